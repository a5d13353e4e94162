#pragma once
#include <array>
#include <string_view>

// The register of clauses: every paragraph of SUBSET-026 that code may name, in the order of their characters.
namespace evc {

// clang-format off
inline constexpr auto kSrsClauses = std::to_array<std::string_view>({
#include "openevc/terms/clauses.inc"
});
// clang-format on

}  // namespace evc
