#pragma once
#include <optional>

#include "base/location.h"
#include "terms/level.h"
#include "terms/mode.h"
#include "terms/srs_version.h"
#include "track/services.h"

// The alarm of the balise antenna and the tolerance of big metal masses (3.15.7).
namespace evc::protection {

/// A.3.1: in levels 0 and NTC an alarm is ignored for this distance.
inline constexpr Distance D_METAL{300.0};

struct AntennaAlarm {
  std::optional<OdometerReading> since;      ///< the odometer when the alarm began; absent: no alarm
  std::optional<OdometerReading> inhibited;  ///< the same when its reaction was inhibited; absent: it acts (5.22)
  bool reacts = false;                       ///< it has its reaction, so that no metal ahead is its cause
};

/// What the reaction depends on, in this cycle.
struct AntennaSituation {
  bool alarm = false;
  Mode mode = Mode::NP;
  Level level = Level::L0;
  SrsVersion srs = SrsVersion::v3_6_0;
  OdometerReading counter{};
  Place min_safe_antenna{}, max_safe_antenna{};
};

/// One cycle: whether the safety reaction is due (3.15.7.6). The alarm is ignored in a big metal mass (3.15.7.5),
/// from where the max safe antenna enters it until the min safe antenna leaves it, unless it had its reaction before:
/// the metal may not have triggered it. It is ignored in RV (4.4.18.1.11); in levels 0 and NTC for 300 m from where it
/// began, each at least as far as the train really ran; of 4.0.0 in SB in the other levels (3.15.7.4). 4.0.0: the
/// inhibition ends after 300 m, in another mode than SB, SH and SR, or where a big metal mass begins (5.22.5).
bool asks_for_brake(AntennaAlarm& state, const AntennaSituation& situation, const track::Description& description);

/// Whether the antenna may be in a big metal mass.
bool over_metal(const track::Description& description, Place min_safe_antenna, Place max_safe_antenna);

}  // namespace evc::protection
