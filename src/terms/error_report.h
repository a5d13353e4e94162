#pragma once
#include <cstdint>

namespace evc {

/// M_ERROR of packet 4 (7.5.1.64), for the report to the RBC (3.16.4).
enum class ErrorReport : std::uint8_t {
  linking = 0,
  linked_message = 1,
  unlinked_message = 2,
  radio_message = 3,
  radio_sequence = 4,
  radio_connection = 5,
  safety_critical_fault = 6,
  double_linking = 7,
  double_repositioning = 8,
  odometer_impaired = 9,  // from 2.2 on, as the next
  odometer_beyond_safety = 10,
  none = 255
};

}  // namespace evc
