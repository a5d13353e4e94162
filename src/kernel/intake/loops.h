#pragma once
#include "kernel/intake/evaluation.h"

// Euroloop (3.4.5, 3.9.2).
namespace evc::kernel {

/// Packet 134: announces a loop; it replaces the one announced before (3.4.5.1.4).
void take_announcement(Evaluation& e, const lang::PacketView& view, modes::Verdict verdict);
/// Packet 13: the distance that may be run in SR, from a group that it names (4.4.11.1.3.1 c).
void take_SR_distance(Evaluation& e, const lang::PacketView& view, modes::Verdict verdict);

/// A balise group was passed: the signal of an SR distance (4.4.11.1.6.7).
void note_signal_of_loop(State& state, GroupId group);
/// Each cycle, after the telegrams: the end of the area of the loop (3.4.5.1.6), then its messages.
void receive_loops(Reception& r);

}  // namespace evc::kernel
