#pragma once
#include <cstddef>
#include <cstdint>

namespace evc::modes {

/// The modes of SUBSET-026-4 4.4, in the column order of 4.6.2.
enum class Mode : std::uint8_t { NP, SB, PS, SH, FS, LS, SR, OS, SL, NL, UN, TR, PT, SF, IS, SN, RV };
inline constexpr std::size_t kModes = 17;

/// The mode's abbreviation of 4.6.1 ("NP", "SB", ...).
constexpr const char* name(Mode mode) {
  constexpr const char* names[kModes] = {"NP", "SB", "PS", "SH", "FS", "LS", "SR", "OS", "SL",
                                         "NL", "UN", "TR", "PT", "SF", "IS", "SN", "RV"};
  return names[static_cast<std::size_t>(mode)];
}

}  // namespace evc::modes
