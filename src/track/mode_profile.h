#pragma once
#include <cstdint>
#include <optional>

#include "base/inplace_vector.h"
#include "base/units.h"
#include "track/speed_restrictions.h"

namespace evc::track {

enum class AreaMode : std::uint8_t { OS = 0, SH = 1, LS = 2 };  ///< M_MAMODE

/// One area of the mode profile (packet 80; 3.12.4).
struct ModeArea {
  Place from{};
  std::optional<Place> to;  ///< absent: endless. The length of a shunting area is ignored
  AreaMode mode = AreaMode::OS;
  SpeedCode V_MAMODE = kNoSpeed;  ///< kNoSpeed: the national value
  Place ack_from{};               ///< start of the acknowledgement window
  bool also_SvL = true;           ///< Q_MAMODE: the start is the supervised location too
  bool accepted = false;          ///< the mode was entered for this area
  friend constexpr bool operator==(const ModeArea&, const ModeArea&) = default;
};
using ModeProfile = InplaceVector<ModeArea, 32>;

}  // namespace evc::track
