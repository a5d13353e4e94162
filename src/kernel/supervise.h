#pragma once
#include "kernel/cycle.h"
#include "sdm/supervision.h"

// From the track description to speed and distance monitoring (3.13), and the movement protections (3.14).
namespace evc::kernel {

/// Whether the mode supervises speed by itself (4.5.2); in SN the national system does.
bool supervises_speed(Mode mode);

/// Builds the authority, the MRSP and all curves anew when the track description, the train or the national values
/// changed since they were built. Without a change nothing is done.
void refresh(Cycle& cycle);

/// One cycle of 3.13.10: commands into `cycle.asked`, limits into the outputs.
void supervise_speed(Cycle& cycle);

/// Roll away, reverse movement, standstill, post trip and reversing distance (3.14.2-4, 4.4.14, 3.15.4).
void guard_movement(Cycle& cycle);

/// 3.8.6.2: the train is in rear of the Indication limits of the proposed authority.
/// A question: only Derived::proposed is written.
bool can_stop_before(const Cycle& cycle, Derived& derived, const track::Contents& proposal);

/// The train as the choice of speeds needs it (3.18.3.2).
track::TrainCategory category_of(const train::TrainData& train);
track::TrainInterfaces interfaces_of(const train::TrainData& train);

}  // namespace evc::kernel
