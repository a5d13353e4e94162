#pragma once
#include "openevc/terms/row.h"

namespace evc {

/// What an external source says of the completeness of the train (3.6.5.2).
enum class TrainIntegrity : std::uint8_t { unknown, confirmed, lost };

inline constexpr auto kTrainIntegrityRows = std::to_array<terms::Row<TrainIntegrity>>({
    {TrainIntegrity::unknown, "unknown"},
    {TrainIntegrity::confirmed, "confirmed"},
    {TrainIntegrity::lost, "lost"},
});
static_assert(terms::in_order(kTrainIntegrityRows));

}  // namespace evc
