#pragma once
#include "kernel/state.h"
#include "modes/mode_properties.h"
#include "track/services.h"

// The authority in force, and the other inputs of the curves (3.13.2, 3.13.9.4.8).
namespace evc::kernel {

/// Whether speed is supervised in the mode (4.5.2); in SN the national system does this.
bool supervises_speed(Mode mode);
/// The area of the mode profile that gives the speed of LS and OS (3.11.7.1.1; that of SH is deleted at its entry,
/// 4.10): max safe front end beyond its start and min safe front end not beyond its end, of several the slowest. With
/// none of them the nearest one that was accepted: an acknowledgement counts for each area whose window has begun, the
/// speed of a farther one comes later. Absent: none.
std::optional<track::ModeArea> area_of_mode(const State& state, const track::Here& here);
/// The supervision of speed in the current mode.
bool supervises(const State& state, modes::Supervision kind);

/// Whether a fault that affects safety does not stop the train in the mode: it is memorised and handled when the mode
/// is left (4.4.6.1.6, 4.4.15.1.5; in PS of 4.0.0 4.4.20.1.10, the table before has [13] there).
bool memorises_faults(const State& state);

/// Renews State::basis when the track description, the train, the national values or the mode changed since it was
/// built, or the train's rear end is farther back than where its curves begin. Returns whether it did. Without a change
/// it does nothing. Its key is taken with the authority that was in force before: what a new authority changes in it is
/// found by the next call, of which each cycle has two at least.
bool renew_basis(State& state, const TrainSignals& train, const track::Here& here);

/// The basis of curves built now, for `authority`.
SupervisionBasis basis_of(const State& state, const track::Here& here, const SupervisionBasis::Key& key,
                          const track::Authority& authority);

}  // namespace evc::kernel
