#pragma once
#include <cstdint>
#include <optional>

#include "kernel/intake/evaluation.h"

// The operated system version (3.17.2): its number X.
namespace evc::kernel {

/// A balise group that was accepted, after its level transition orders and before its other information, which depends
/// on the version (3.17.2.3 to .7, 3.17.3.3). A group that is rejected does not come here (3.17.3.4). Where the group
/// itself orders the level, the version of that level counts (3.17.2.8.1, .2).
void determine_version(Evaluation& evaluation);

/// In levels 2 and 3 the RBC's version is operated (3.17.2.8): at the begin of a cycle, when the RBC sent its version,
/// and after a level transition. `before`: the level before that.
void operate_version_of_rbc(Reception& reception, Level before);

/// A radio infill unit with a higher X raises the operated version (3.17.2.3), where no RBC's counts.
void operate_version_of_infill_unit(Reception& reception, std::uint8_t M_VERSION);

}  // namespace evc::kernel
