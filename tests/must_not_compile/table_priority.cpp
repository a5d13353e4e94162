// Two cells of one mode and one priority share no condition (4.6.2).
// expected: static
#include "modes/mode_table.h"

using namespace evc;

enum class M { NP, SB, FS };

constexpr auto table = std::to_array<modes::Cell<M>>({
    {M::SB, M::NP, {4}, 2},
#ifdef MISTAKE
    {M::FS, M::SB, {10, 29}, 1},
#else
    {M::FS, M::SB, {10}, 1},
#endif
    {M::NP, M::SB, {29}, 1},
});
static_assert(modes::equal_priority_means_disjoint_conditions(table));
