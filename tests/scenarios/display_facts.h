#pragma once
#include "base/set.h"
#include "kernel/evc.h"
#include "terms/driver_output.h"

namespace evc::scenario {

/// The outputs of 4.7.2 for which the unit has something to show, whatever mode it is in: from its memory where it
/// keeps the fact, from the outputs of the cycle where it does not. An output that was shown and is not any more, while
/// its fact is held, is masked.
Set<DriverOutput> held(const kernel::State& state, const kernel::Outputs& out);

}  // namespace evc::scenario
