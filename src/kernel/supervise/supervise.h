#pragma once
#include "kernel/log.h"
#include "kernel/state.h"
#include "kernel/supervise/supervised.h"
#include "track/services.h"

// Third stage: speed and distance monitoring (3.13), and the movement protections (3.14).
namespace evc::kernel {

/// Supervises the movement with what is in force after the mode transition. Written are: of
/// `derived` the curves in force and the scratch (5.16.2); of `state` the basis, the supervision, the guards, the
/// LSSMA, the watch over the odometer, the antenna alarm, how far track conditions have come (5.18), and of level
/// crossings what the driver was shown and a stop that gives way. `basis_renewed`: State::basis was renewed in this
/// cycle before; `brake_acknowledged`: by the driver, in this cycle.
Supervised supervise(State& state, Derived& derived, const TrainSignals& train, const track::Here& here,
                     bool basis_renewed, bool brake_acknowledged, Log log);

}  // namespace evc::kernel
