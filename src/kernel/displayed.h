#pragma once
#include <cstdint>
#include <optional>

#include "base/inplace_vector.h"
#include "port/display.h"
#include "sdm/supervision.h"

namespace evc::kernel {

/// What the record of the display needs and no output of a cycle carries (kernel::show).
struct Displayed {
  InplaceVector<port::NtcName, 16> ntc_names;  ///< of the configuration
  std::uint64_t national_systems = 0;          ///< available now, bit n: NID_NTC n
  bool passive_shunting = false;               ///< says the train interface now
  std::uint8_t MRDT = 0;                       ///< counts the most relevant displayed targets
  std::optional<sdm::TargetId> indication;     ///< the target of the first Indication location
  InplaceVector<port::AskedAck, 20> acks;      ///< what the driver has to acknowledge, in the order of arrival
  std::uint16_t last_condition = 0;            ///< the last number given to a track condition or level crossing
  std::uint16_t level_crossing = 0;            ///< that of LX01 while it is shown, else 0
  bool conditions = false;                     ///< track conditions are shown
  bool ato_active = false;                     ///< 4.0.0: the selector of automatic operation is not in stand-by

  /// A number that no condition shown has: 65 535 ones lie between.
  constexpr std::uint16_t next_condition() {
    if (++last_condition == 0) ++last_condition;
    return last_condition;
  }
};

}  // namespace evc::kernel
