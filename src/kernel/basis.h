#pragma once
#include "kernel/state.h"
#include "modes/mode_properties.h"
#include "track/services.h"

// The authority in force, and what else the curves are built from (3.13.2, 3.13.9.4.8).
namespace evc::kernel {

/// Whether the mode supervises speed by itself (4.5.2); in SN the national system does.
bool supervises_speed(Mode mode);
/// How the mode in force supervises speed.
bool supervises(const State& state, modes::Supervision kind);

/// Renews State::basis when the track description, the train, the national values or the mode changed since it was
/// made. Gives whether it did. Without a change nothing is done.
bool renew_basis(State& state, const TrainSignals& train, const track::Here& here);

/// The basis of curves that are built now, for `authority`.
SupervisionBasis basis_of(const State& state, const track::Here& here, const SupervisionBasis::Key& key,
                          const track::Authority& authority);

}  // namespace evc::kernel
