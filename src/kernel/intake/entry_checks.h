#pragma once
#include <optional>

#include "kernel/port.h"
#include "train/brake_model.h"

// Range and resolution of what the driver enters (A.3.11). The display may check them too (015560 10.3.4); the unit
// does not rely on it.
namespace evc::kernel {

/// A speed of 0 to 600 km/h in steps of 5 km/h, and a distance of 0 to 100 km in steps of 1 m (4.4.11.1.5.2), each
/// where it was entered.
[[nodiscard]] bool is_SR_entry(const std::optional<Speed>& V, const std::optional<Distance>& D);

/// An RBC identity of 24 bits; all ones name no RBC (3.18.4.3.5).
[[nodiscard]] bool is_rbc(const DriverActions::RbcContact& contact);

/// What of `entered` is no multiple of its resolution: the length (1 m), the maximum speed (5 km/h) or the brake
/// percentage (1 %). A value that is the one of `before` was not typed: the train was configured with it.
[[nodiscard]] train::Fault off_resolution(const train::TrainData& entered, const train::TrainData& before);

}  // namespace evc::kernel
