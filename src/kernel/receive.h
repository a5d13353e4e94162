#pragma once
#include "kernel/cycle.h"

// Telegrams and messages of one cycle, and the transition buffer.
namespace evc::kernel {

/// The balise telegrams of this cycle into groups, linking and position, and the information of the groups that are
/// complete (3.4, 3.16.2).
void receive_balises(Cycle& cycle);
/// Loop messages: the unit takes none of their information yet, and says so.
void receive_loops(Cycle& cycle);
/// The radio messages of this cycle (3.16.3).
void receive_radio(Cycle& cycle);

/// 4.8.5: everything that waits is judged again at the new level, in the order of reception.
void release_buffer(Cycle& cycle);
/// The order for which it waited is deleted (4.8.5.4).
void clear_buffer(State& state);

}  // namespace evc::kernel
