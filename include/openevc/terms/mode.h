#pragma once
#include "openevc/terms/row.h"

namespace evc {

/// The modes of SUBSET-026-4 4.4, in the column order of 4.6.2 of 3.x; SM (Supervised Manoeuvre) and AD (Automatic
/// Driving) exist in 4.0.0 only.
enum class Mode : std::uint8_t { NP, SB, PS, SH, FS, LS, SR, OS, SL, NL, UN, TR, PT, SF, IS, SN, RV, SM, AD };

/// A mode with its codes of M_MODE, by the version of the language.
struct ModeRow {
  Mode value;
  std::array<std::uint8_t, 4> codes;  ///< of 1.x; of 2.0 and 2.1; of 2.2; from 2.3 on
  const char* name;
};

// clang-format off
/// M_MODE (7.5.1.72), and what older versions have instead: 1.x no passive shunting (6.6.3.4.5 [1a]), versions up to 2.1
/// no automatic driving (6.6.5.3.7 [1a]). NP is never reported, as the unit has no power; it has the code of SB, the mode
/// after it. SM is never reported to a version up to 2.2, which cannot authorise it (6.6.4.3.1); SH stands for it.
inline constexpr auto kModeRows = std::to_array<ModeRow>({
    //          1.x  2.0  2.2  2.3
    {Mode::NP, {{ 6,  6,  6,  6}}, "NP"},
    {Mode::SB, {{ 6,  6,  6,  6}}, "SB"},
    {Mode::PS, {{ 3, 15, 15, 15}}, "PS"},
    {Mode::SH, {{ 3,  3,  3,  3}}, "SH"},
    {Mode::FS, {{ 0,  0,  0,  0}}, "FS"},
    {Mode::LS, {{12, 12, 12, 12}}, "LS"},
    {Mode::SR, {{ 2,  2,  2,  2}}, "SR"},
    {Mode::OS, {{ 1,  1,  1,  1}}, "OS"},
    {Mode::SL, {{ 5,  5,  5,  5}}, "SL"},
    {Mode::NL, {{11, 11, 11, 11}}, "NL"},
    {Mode::UN, {{ 4,  4,  4,  4}}, "UN"},
    {Mode::TR, {{ 7,  7,  7,  7}}, "TR"},
    {Mode::PT, {{ 8,  8,  8,  8}}, "PT"},
    {Mode::SF, {{ 9,  9,  9,  9}}, "SF"},
    {Mode::IS, {{10, 10, 10, 10}}, "IS"},
    {Mode::SN, {{13, 13, 13, 13}}, "SN"},
    {Mode::RV, {{14, 14, 14, 14}}, "RV"},
    {Mode::SM, {{ 3,  3,  3, 17}}, "SM"},
    {Mode::AD, {{ 0,  0, 16, 16}}, "AD"},
});
// clang-format on
static_assert(terms::in_order(kModeRows));
inline constexpr std::size_t kModes = kModeRows.size();
inline constexpr std::size_t kModesOf3 = 17;  ///< without SM and AD

namespace terms {
/// The codes of a column of `kModeRows`, without the names.
inline constexpr auto kModeCodes = [] {
  std::array<std::array<std::uint8_t, kModes>, 4> columns{};
  for (std::size_t m = 0; m < kModes; ++m)
    for (std::size_t c = 0; c < columns.size(); ++c) columns[c][m] = kModeRows[m].codes[c];
  return columns;
}();
/// The column of version X.Y.
constexpr std::size_t mode_column(std::uint8_t X, std::uint8_t Y) {
  if (X < 2) return 0;
  if (X > 2 || Y > 2) return 3;
  return Y == 2 ? 2 : 1;
}
}  // namespace terms

/// M_MODE (7.5.1.72) in version X.Y of the language.
constexpr std::uint8_t M_MODE(Mode mode, std::uint8_t X, std::uint8_t Y) {
  return terms::kModeCodes[terms::mode_column(X, Y)][terms::index(mode)];
}

/// The mode of a code of M_MODE in the newest version; NP, in which no train runs, for a spare code.
constexpr Mode mode_of(std::uint64_t M_MODE) {
  constexpr const auto& codes = terms::kModeCodes.back();
  for (std::size_t i = terms::index(Mode::SB); i < kModes; ++i)
    if (codes[i] == M_MODE) return static_cast<Mode>(i);
  return Mode::NP;
}

/// The mode of an area of a mode profile: M_MAMODE (7.5.1.70). Spare codes are rejected before (chapter 7).
constexpr Mode mode_of_area(std::uint64_t M_MAMODE) {
  return M_MAMODE == 0 ? Mode::OS : M_MAMODE == 1 ? Mode::SH : Mode::LS;
}

/// The mode's abbreviation of 4.6.1 ("NP", "SB", ...).
constexpr const char* name(Mode mode) { return terms::kNames<kModeRows>[terms::index(mode)]; }

/// FS, LS, OS, AD and SM: a movement authority is supervised (4.5.2).
constexpr bool supervises_authority(Mode mode) {
  return mode == Mode::FS || mode == Mode::LS || mode == Mode::OS || mode == Mode::AD || mode == Mode::SM;
}
/// FS and AD: what the driver or the automatic operation does is supervised in full.
constexpr bool full_supervision(Mode mode) { return mode == Mode::FS || mode == Mode::AD; }

}  // namespace evc
