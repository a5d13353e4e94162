// A table has each cell only once (4.6.2).
// expected: static
#include "modes/mode_table.h"

using namespace evc;

enum class M { NP, SB, FS };

constexpr auto table = std::to_array<modes::Cell<M>>({
    {M::SB, M::NP, {4}, 2},
#ifdef MISTAKE
    {M::SB, M::NP, {10}, 3},
#else
    {M::FS, M::SB, {10}, 3},
#endif
    {M::NP, M::SB, {29}, 1},
});
static_assert(modes::no_cell_twice(table));
