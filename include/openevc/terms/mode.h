#pragma once
#include "openevc/terms/row.h"

namespace evc {

/// The modes of SUBSET-026-4 4.4, in the column order of 4.6.2 of 3.x; SM (Supervised Manoeuvre) and AD (Automatic
/// Driving) exist in 4.0.0 only.
enum class Mode : std::uint8_t { NP, SB, PS, SH, FS, LS, SR, OS, SL, NL, UN, TR, PT, SF, IS, SN, RV, SM, AD };

// clang-format off
/// Code: M_MODE (7.5.1.72). NP is never reported, as the unit has no power; it has the code of SB, the mode after it.
/// To an RBC of a version up to 2.1, AD is reported as FS (6.6.5.3.7 [1a]); SM is not possible with one (6.6.5.3.7), SH stands for
/// it.
inline constexpr auto kModeRows = std::to_array<terms::WireRow<Mode>>({
    {Mode::NP,  6, "NP"},
    {Mode::SB,  6, "SB"},
    {Mode::PS, 15, "PS"},
    {Mode::SH,  3, "SH"},
    {Mode::FS,  0, "FS"},
    {Mode::LS, 12, "LS"},
    {Mode::SR,  2, "SR"},
    {Mode::OS,  1, "OS"},
    {Mode::SL,  5, "SL"},
    {Mode::NL, 11, "NL"},
    {Mode::UN,  4, "UN"},
    {Mode::TR,  7, "TR"},
    {Mode::PT,  8, "PT"},
    {Mode::SF,  9, "SF"},
    {Mode::IS, 10, "IS"},
    {Mode::SN, 13, "SN"},
    {Mode::RV, 14, "RV"},
    {Mode::SM,  3, "SM"},
    {Mode::AD,  0, "AD"},
});
// clang-format on
static_assert(terms::in_order(kModeRows));
inline constexpr std::size_t kModes = kModeRows.size();
inline constexpr std::size_t kModesOf3 = 17;  ///< without SM and AD

/// M_MODE (7.5.1.72).
constexpr std::uint8_t M_MODE(Mode mode) { return terms::kCodes<kModeRows>[terms::index(mode)]; }

/// The mode of a code of M_MODE or M_MODETEXTDISPLAY; NP, in which no train runs, for a spare code.
constexpr Mode mode_of(std::uint64_t M_MODE) {
  constexpr const auto& codes = terms::kCodes<kModeRows>;
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
