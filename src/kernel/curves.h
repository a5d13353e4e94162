#pragma once
#include "kernel/state.h"
#include "sdm/supervision.h"
#include "track/services.h"

// From the track description to the curves of 3.13.
namespace evc::kernel {

/// Curves and limits, from the stored data and `basis`; of the train interface only the special brakes are asked for.
void build(Derived::Curves& curves, const State& state, const TrainSignals& train, const SupervisionBasis& basis);

/// How the train moves, for 3.13.10.
sdm::Motion motion_of(const State& state, const track::Here& here, const TrainSignals& train);

}  // namespace evc::kernel
