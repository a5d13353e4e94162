#pragma once
#include <cstdint>

namespace evc::modes {

/// The issues of SUBSET-026 whose tables differ in this room. The mode table 4.6.2 of 3.4.0 and
/// 3.6.0 is one; 4.0.0 has two modes more and no level 3.
enum class Edition : std::uint8_t { v3_4_0, v3_6_0, v4_0_0 };

}  // namespace evc::modes
