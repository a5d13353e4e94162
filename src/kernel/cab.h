#pragma once
#include "kernel/evc.h"
#include "kernel/log.h"
#include "kernel/state.h"

// The cab that is active, or was last: it defines the orientation of the train (3.6.1.5, 5.12).
namespace evc::kernel {

/// Whether the desk of the other cab is open without a cycle in which both were closed: it counts as closed then.
bool skips_closing(const State& state, const TrainSignals& train);

/// The desk of the other cab is opened: position and orientation are those of that cab (5.12.2.5, 5.12.4.3).
/// The train has the other orientation while the cab stays (4.4.21.1.7): as with a change of cab, what lay ahead is
/// deleted (3.7.3.4 b) and the frame is mirrored.
void turn_train(State& state);

void follow_cab(State& state, const TrainSignals& train, Log log);

/// The position as it is from the other cab, `cab`.
void see_from_other_cab(State& state, Cab cab);

}  // namespace evc::kernel
