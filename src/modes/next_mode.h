#pragma once
#include <optional>
#include <span>

#include "modes/srs_4_6_2.h"
#include "modes/srs_4_6_2_v400.h"
#include "terms/srs_version.h"

// The mode table of an edition.
namespace evc::modes {

/// The mode to enter now by the table of the edition; none when the mode stays.
constexpr std::optional<Transition<Mode>> next_mode(Mode current, const Conditions& holding, SrsVersion srs) {
  return srs == SrsVersion::v4_0_0 ? v400::next_mode(current, holding) : next_mode(current, holding);
}

/// The cells of the edition that leave a mode.
constexpr std::span<const Cell<Mode>> cells_leaving(Mode mode, SrsVersion srs) {
  return srs == SrsVersion::v4_0_0 ? leaving(v400::srs_4_6_2_by_leaving, mode) : leaving(srs_4_6_2_by_leaving, mode);
}

}  // namespace evc::modes
