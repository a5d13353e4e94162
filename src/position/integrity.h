#pragma once
#include <cstdint>
#include <optional>

#include "position/position.h"
#include "terms/train_integrity.h"

// Train integrity for the position report (3.6.5.2).
namespace evc::position {

enum class Integrity : std::uint8_t { none = 0, by_device = 1, by_driver = 2, lost = 3 };  // codes of Q_LENGTH

/// The status to be reported, and where the train ended when it was last known to be complete.
struct IntegrityStatus {
  Integrity integrity = Integrity::none;
  Place min_safe_rear{};  ///< then (3.6.5.2.4)
  Distance L_TRAIN{};     ///< then
};

struct IntegrityFacts {
  TrainIntegrity device{};                ///< says the external source now
  std::optional<Distance> device_length;  ///< of the train that it knows to be complete
  bool driver_confirms = false;           ///< at standstill (3.6.5.2.2)
  bool train_data_valid = false;
  bool length_acknowledged = false;   ///< by the RBC, and no other length waits for the driver
  bool validated_since = false;       ///< train data, and the RBC has not acknowledged these: they confirm nothing
  bool session_established = false;   ///< in this cycle (3.6.5.2.6)
  bool consist_known = false;         ///< 4.0.0: no valid train data, but the safe consist length is available
  bool consist_acknowledged = false;  ///< by the RBC, if it was sent
  bool consist_captured = false;      ///< 4.0.0: of a source of the safe consist length a loss counts (condition 4)
  bool consist_changed = false;       ///< in this cycle, even to one of the same sum
  bool turned = false;                ///< 4.0.0: the train orientation changed in this cycle
  Distance L_TRAIN{};                 ///< from the min safe front end to the min safe rear end
};

/// What is reported by itself (3.6.5.1.4 c, d).
struct IntegrityEvents {
  bool confirmed_by_driver = false, lost = false;
};

/// Once a cycle: the transitions of Table 2b of 4.0.0 by the conditions of Table 2c; earlier issues name the four
/// statuses only.
IntegrityEvents supervise(IntegrityStatus& status, const State& state, const IntegrityFacts& facts);
/// Condition 5 of Table 2c: a confirmation is reported once.
void note_reported(IntegrityStatus& status);

}  // namespace evc::position
