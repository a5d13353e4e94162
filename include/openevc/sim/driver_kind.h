#pragma once
#include <cstdint>

namespace evc::sim {

/// perfect: follows the permitted speed with a comfortable braking ahead. late: the same, but reacts
/// and acknowledges late. reckless: ignores the permitted speed.
enum class DriverKind : std::uint8_t { perfect, late, reckless };

}  // namespace evc::sim
