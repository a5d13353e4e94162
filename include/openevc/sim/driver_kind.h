#pragma once
#include <cstdint>

namespace evc::sim {

/// perfect: follows the permitted speed and brakes comfortably ahead of targets. late: the same, but reacts and
/// acknowledges late. reckless: ignores the permitted speed.
enum class DriverKind : std::uint8_t { perfect, late, reckless };

}  // namespace evc::sim
