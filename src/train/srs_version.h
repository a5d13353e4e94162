#pragma once
#include <cstdint>

namespace evc::train {

/// Whose formulas and tables apply: the issue of SUBSET-026.
enum class SrsVersion : std::uint8_t { v3_4_0, v3_6_0, v4_0_0 };

}  // namespace evc::train
