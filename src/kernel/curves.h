#pragma once
#include "kernel/state.h"
#include "sdm/supervision.h"
#include "terms/mrsp_source.h"
#include "track/services.h"

// From the track description to the curves of 3.13.
namespace evc::kernel {

/// Curves and limits, from the stored data and `basis`; only the special brakes are used of the train interface.
void build(Derived::Curves& curves, const State& state, const TrainSignals& train, const SupervisionBasis& basis);

/// The part of the MRSP of `curves` that comes from `source` alone; the speeds of permitted braking distances are those
/// of `curves`.
void mrsp_of(MrspSource source, track::Mrsp& out, const State& state, const Derived::Curves& curves,
             const SupervisionBasis& basis);

/// The movement of the train, for 3.13.10.
sdm::Motion motion_of(const State& state, const track::Here& here, const TrainSignals& train);

}  // namespace evc::kernel
