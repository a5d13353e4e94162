#pragma once
#include "kernel/evc.h"
#include "kernel/log.h"
#include "kernel/state.h"

// The cab that is active, or was last: it defines the orientation of the train (3.6.1.5, 5.12).
namespace evc::kernel {

/// Whether the desk of the other cab is open in the cycle after this one: it has to be closed between them, and counts
/// as closed for a cycle.
bool skips_closing(const State& state, const TrainSignals& train);

/// The desk of the other cab is opened: position and orientation are those of that cab (5.12.2.5, 5.12.4.3).
void follow_cab(State& state, const TrainSignals& train, Log log);

/// Position and train data as they are from the other cab, `cab`.
void see_from_other_cab(State& state, Cab cab);

/// Stores train data. The distance of the antenna, given from cab A, counts from the front end of the active cab.
void set_train_data(State& state, const train::TrainData& data);
/// Whether these train data, as they are given, are those of the unit.
bool are_in_force(const State& state, train::TrainData data);

}  // namespace evc::kernel
