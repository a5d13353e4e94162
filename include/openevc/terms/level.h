#pragma once
#include "openevc/terms/row.h"

namespace evc {

/// The levels of SUBSET-026-2 2.6. Level 3 exists up to 3.6.0; 4.0.0 merged it into level 2.
enum class Level : std::uint8_t { L0, NTC, L1, L2, L3 };

/// Code: M_LEVEL and M_LEVELTR (7.5.1.65, 7.5.1.67).
inline constexpr auto kLevelRows = std::to_array<terms::WireRow<Level>>({
    {Level::L0, 0, "0"},
    {Level::NTC, 1, "NTC"},
    {Level::L1, 2, "1"},
    {Level::L2, 3, "2"},
    {Level::L3, 4, "3"},
});
static_assert(terms::in_order(kLevelRows));
inline constexpr std::size_t kLevels = kLevelRows.size();

constexpr std::uint8_t M_LEVEL(Level level) { return terms::kCodes<kLevelRows>[terms::index(level)]; }
/// The level of a code of M_LEVEL or M_LEVELTR; none for a spare code.
constexpr std::optional<Level> level_of(std::uint64_t M_LEVEL) { return terms::of_code<Level, kLevelRows>(M_LEVEL); }

/// "0", "NTC", "1", "2", "3".
constexpr const char* name(Level level) { return terms::kNames<kLevelRows>[terms::index(level)]; }

/// Level 2 or 3: the RBC gives the authority.
constexpr bool level_2_or_3(Level level) { return level == Level::L2 || level == Level::L3; }
constexpr bool level_2_or_3(std::optional<Level> level) { return level && level_2_or_3(*level); }
/// Level 1, 2 or 3: the trackside is fitted.
constexpr bool level_1_2_3(Level level) { return level == Level::L1 || level_2_or_3(level); }

}  // namespace evc
