#pragma once
#include <array>
#include <optional>

#include "modes/mode_table.h"
#include "terms/mode.h"

namespace evc::modes {

// SUBSET-026-4 4.6.2 of 3.3.0, 3.4.0 and 3.6.0, one block per row of the matrix (the mode entered), one
// entry per cell, in the standard's column order. Read it against the page: `to, from, [conditions], priority`.
// clang-format off
inline constexpr auto srs_4_6_2 = [] {
  using enum Mode;
  return std::to_array<Cell<Mode>>({
    // into NP
    {NP, SB, {29}, 2}, {NP, PS, {29}, 2}, {NP, SH, {29}, 2}, {NP, FS, {29}, 2}, {NP, LS, {29}, 2},
    {NP, SR, {29}, 2}, {NP, OS, {29}, 2}, {NP, SL, {29}, 2}, {NP, NL, {29}, 2}, {NP, UN, {29}, 2},
    {NP, TR, {29}, 2}, {NP, PT, {29}, 2}, {NP, SF, {29}, 2}, {NP, SN, {29}, 2}, {NP, RV, {29}, 2},
    // into SB
    {SB, NP, {4},          2},
    {SB, PS, {22},         4},
    {SB, SH, {19, 27, 30}, 5},
    {SB, FS, {28},         5},
    {SB, LS, {28},         5},
    {SB, SR, {28},         5},
    {SB, OS, {28},         5},
    {SB, SL, {2, 3},       3},
    {SB, NL, {28, 47},     3},
    {SB, UN, {28},         6},
    {SB, PT, {28},         4},
    {SB, SN, {28},         6},
    {SB, RV, {28},         4},
    // into PS
    {PS, SH, {26}, 5},
    // into SH
    {SH, SB, {5, 6, 50},     7},
    {SH, PS, {23},           4},
    {SH, FS, {5, 6, 50, 51}, 6},
    {SH, LS, {5, 6, 50, 51}, 6},
    {SH, SR, {5, 6, 51},     6},
    {SH, OS, {5, 6, 50, 51}, 6},
    {SH, UN, {5, 61},        7},
    {SH, TR, {68},           4},
    {SH, PT, {5, 6, 50},     5},
    {SH, SN, {5, 61},        7},
    // into FS
    {FS, SB, {10},     7},
    {FS, LS, {31, 32}, 6},
    {FS, SR, {31, 32}, 6},
    {FS, OS, {31, 32}, 6},
    {FS, UN, {25},     7},
    {FS, PT, {31},     5},
    {FS, SN, {25},     7},
    // into LS
    {LS, SB, {70},     7},
    {LS, FS, {70, 72}, 6},
    {LS, SR, {72},     6},
    {LS, OS, {70, 74}, 6},
    {LS, UN, {71},     7},
    {LS, PT, {70},     5},
    {LS, SN, {71},     7},
    // into SR
    {SR, SB, {8, 37},  7},
    {SR, FS, {37},     6},
    {SR, LS, {37},     6},
    {SR, OS, {37},     6},
    {SR, UN, {44, 45}, 4},
    {SR, PT, {8, 37},  5},
    {SR, SN, {44, 45}, 4},
    // into OS
    {OS, SB, {15},     7},
    {OS, FS, {15, 40}, 6},
    {OS, LS, {15, 73}, 6},
    {OS, SR, {40},     6},
    {OS, UN, {34},     7},
    {OS, PT, {15},     5},
    {OS, SN, {34},     7},
    // into SL
    {SL, SB, {14}, 5},
    {SL, PS, {14}, 4},
    // into NL
    {NL, SB, {46}, 6},
    {NL, SH, {46}, 5},
    {NL, FS, {46}, 6},
    {NL, LS, {46}, 6},
    {NL, SR, {46}, 6},
    {NL, OS, {46}, 6},
    // into UN
    {UN, SB, {60}, 7},
    {UN, FS, {21}, 6},
    {UN, LS, {21}, 6},
    {UN, SR, {21}, 6},
    {UN, OS, {21}, 6},
    {UN, TR, {62}, 4},
    {UN, SN, {21}, 7},
    // into TR
    {TR, SB, {20},                                 4},
    {TR, SH, {49, 52, 65},                         4},
    {TR, FS, {12, 16, 17, 18, 20, 41, 65, 66, 69}, 4},
    {TR, LS, {12, 16, 17, 18, 20, 41, 65, 66, 69}, 4},
    {TR, SR, {18, 20, 42, 43, 36, 54, 65},         4},
    {TR, OS, {12, 16, 17, 18, 20, 41, 65, 66, 69}, 4},
    {TR, UN, {67, 39, 20},                         5},
    {TR, SN, {67, 39, 38, 35, 20},                 5},
    // into PT
    {PT, TR, {7}, 4},
    // into SF
    {SF, SB, {13}, 3}, {SF, PS, {13}, 3}, {SF, SH, {13}, 3}, {SF, FS, {13}, 3}, {SF, LS, {13}, 3},
    {SF, SR, {13}, 3}, {SF, OS, {13}, 3}, {SF, UN, {13}, 3}, {SF, TR, {13}, 3}, {SF, PT, {13}, 3},
    {SF, SN, {13}, 3}, {SF, RV, {13}, 3},
    // into IS
    {IS, NP, {1}, 1}, {IS, SB, {1}, 1}, {IS, PS, {1}, 1}, {IS, SH, {1}, 1}, {IS, FS, {1}, 1},
    {IS, LS, {1}, 1}, {IS, SR, {1}, 1}, {IS, OS, {1}, 1}, {IS, SL, {1}, 1}, {IS, NL, {1}, 1},
    {IS, UN, {1}, 1}, {IS, TR, {1}, 1}, {IS, PT, {1}, 1}, {IS, SF, {1}, 1}, {IS, SN, {1}, 1},
    {IS, RV, {1}, 1},
    // into SN
    {SN, SB, {58}, 7},
    {SN, FS, {56}, 6},
    {SN, LS, {56}, 6},
    {SN, SR, {56}, 6},
    {SN, OS, {56}, 6},
    {SN, UN, {56}, 7},
    {SN, TR, {63}, 4},
    // into RV
    {RV, FS, {59}, 6},
    {RV, LS, {59}, 6},
    {RV, OS, {59}, 6},
  });
}();
// clang-format on

/// The modes in the column order of the standard.
inline constexpr std::array<Mode, kModesOf3> kColumns{Mode::NP, Mode::SB, Mode::PS, Mode::SH, Mode::FS, Mode::LS,
                                                      Mode::SR, Mode::OS, Mode::SL, Mode::NL, Mode::UN, Mode::TR,
                                                      Mode::PT, Mode::SF, Mode::IS, Mode::SN, Mode::RV};

static_assert(srs_4_6_2.size() == 129);
static_assert(every_mode_is_reachable(srs_4_6_2, kModesOf3));
static_assert(no_cell_twice(srs_4_6_2));
static_assert(equal_priority_means_disjoint_conditions(srs_4_6_2));

inline constexpr ByLeaving<Mode, srs_4_6_2.size(), kModes> srs_4_6_2_by_leaving(srs_4_6_2);

/// The mode to enter now, with the condition and its priority; none when the mode stays. One
/// transition a cycle: its entry actions (4.10) are executed before the conditions are evaluated
/// again.
constexpr std::optional<Transition<Mode>> next_mode(Mode current, const Conditions& holding) {
  return select(srs_4_6_2_by_leaving, current, holding);
}

}  // namespace evc::modes
