#pragma once
#include "openevc/terms/row.h"

namespace evc {

/// The orientation of the engine, which is that of its active cab, against the direction of the authority of a
/// supervised manoeuvre (4.4.21.1.13 of 4.0.0, SUBSET-034 2.4.11).
enum class EngineOrientation : std::uint8_t { same, opposite };

inline constexpr auto kEngineOrientationRows = std::to_array<terms::Row<EngineOrientation>>({
    {EngineOrientation::same, "same"},
    {EngineOrientation::opposite, "opposite"},
});
static_assert(terms::in_order(kEngineOrientationRows));

}  // namespace evc
