#pragma once
#include <cstddef>
#include <cstdint>

namespace evc::modes {

/// The levels of SUBSET-026-2 2.6. Level 3 exists up to 3.6.0; 4.0.0 merged it into level 2.
enum class Level : std::uint8_t { L0, NTC, L1, L2, L3 };
inline constexpr std::size_t kLevels = 5;

/// "0", "NTC", "1", "2", "3".
constexpr const char* name(Level level) {
  constexpr const char* names[kLevels] = {"0", "NTC", "1", "2", "3"};
  return names[static_cast<std::size_t>(level)];
}

}  // namespace evc::modes
