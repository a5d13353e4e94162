#pragma once
#include "openevc/terms/row.h"

namespace evc {

/// The issues of SUBSET-026 that this unit implements: they select formulas and tables. 3.4.0 and 3.6.0 share the mode
/// table 4.6.2; 4.0.0 has two more modes and no level 3.
enum class SrsVersion : std::uint8_t { v3_4_0, v3_6_0, v4_0_0 };

inline constexpr auto kSrsVersionRows = std::to_array<terms::Row<SrsVersion>>({
    {SrsVersion::v3_4_0, "3.4.0"},
    {SrsVersion::v3_6_0, "3.6.0"},
    {SrsVersion::v4_0_0, "4.0.0"},
});
static_assert(terms::in_order(kSrsVersionRows));

/// "3.4.0", "3.6.0", "4.0.0".
constexpr const char* name(SrsVersion srs) { return terms::kNames<kSrsVersionRows>[terms::index(srs)]; }

}  // namespace evc
