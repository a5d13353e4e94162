#pragma once
#include "kernel/cycle.h"

// What leaves the unit at the end of a cycle: messages, brake commands, what the driver is shown.
namespace evc::kernel {

/// Session, MA requests, position reports (3.5, 3.6.5, 3.8.2, 3.16.3.4) and the messages as bits.
void run_radio(Cycle& cycle);
/// All causes of this cycle into brake commands (3.14.1).
void command_brakes(Cycle& cycle);
/// Position, authority, symbols, requests and texts (4.7).
void show(Cycle& cycle);
/// The outputs of a cycle before anything happened in it, whatever they held.
void begin(Outputs& out);

}  // namespace evc::kernel
