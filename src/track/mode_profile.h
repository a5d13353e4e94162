#pragma once
#include <cstdint>
#include <optional>

#include "base/inplace_vector.h"
#include "base/location.h"
#include "base/units.h"
#include "terms/mode.h"
#include "track/speed_restrictions.h"

namespace evc::track {

/// One area of the mode profile (packet 80; 3.12.4).
struct ModeArea {
  Place from{};
  std::optional<Place> to;        ///< absent: unlimited. The length of a shunting area is ignored
  Mode mode = Mode::OS;           ///< OS, LS or SH
  SpeedCode V_MAMODE = kNoSpeed;  ///< kNoSpeed: the national value
  Place ack_from{};               ///< start of the acknowledgement window
  bool also_SvL = true;           ///< Q_MAMODE: the start is the supervised location too
  bool accepted = false;          ///< the mode was entered for this area
  bool asked = false;             ///< the driver is asked to acknowledge it ahead of its start (5.7.3.3)
  Anchor anchor{};
  friend constexpr bool operator==(const ModeArea&, const ModeArea&) = default;
};
using ModeProfile = InplaceVector<ModeArea, 32>;

}  // namespace evc::track
