#pragma once
#include <cstdint>

// Codes of M_VERSION (7.5.1.79) for tests.
namespace evc::lang::testing {

inline constexpr std::uint8_t M_VERSION_1_0 = 16, M_VERSION_1_1 = 17, M_VERSION_2_1 = 33, M_VERSION_2_2 = 34;

}  // namespace evc::lang::testing
