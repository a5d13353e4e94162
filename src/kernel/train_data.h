#pragma once
#include "kernel/log.h"
#include "kernel/state.h"
#include "track/services.h"

// Changes of the train data, by the driver or by another source (3.18.3).
namespace evc::kernel {

/// Whether the data are within their ranges; if not, this is logged.
bool acceptable(const train::TrainData& data, Log log);

/// Whether an RBC is given the train data: they are valid, and those of the engine in front (not in SL and NL).
bool sends_train_data(const State& state);

/// Whether the change concerns train category, axle load, loading gauge or traction system (3.18.3.7).
bool route_matters(const train::TrainData& before, const train::TrainData& after);

/// The data are the valid train data from now on: they are sent to the RBC (3.18.3.4), and at standstill what was
/// received for other data is shortened to the train (3.18.3.7).
void change_train_data(State& state, const train::TrainData& data, const track::Here& here, Log log);

}  // namespace evc::kernel
