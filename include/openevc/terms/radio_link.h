#pragma once
#include "openevc/terms/row.h"

namespace evc {

/// What the bearer reports of the safe radio connection to the last RBC called (3.5.3).
enum class RadioLink : std::uint8_t { unchanged, connected, lost, refused };

inline constexpr auto kRadioLinkRows = std::to_array<terms::Row<RadioLink>>({
    {RadioLink::unchanged, "unchanged"},
    {RadioLink::connected, "connected"},
    {RadioLink::lost, "lost"},
    {RadioLink::refused, "refused"},
});
static_assert(terms::in_order(kRadioLinkRows));

}  // namespace evc
