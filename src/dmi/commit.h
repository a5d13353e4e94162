#pragma once
#include "dmi/state.h"

// What the driver completed, for the on-board, and the window that follows (015560 11.7).
namespace evc::dmi {

/// The window's data are entered: a half window at Enter, a full one at Yes, a validation window at its choice.
void complete_entry(State&, Duration now);

/// The Main window with the hour glass until the on-board has the answer it waits for, then the window `then`; with
/// `needs_mode` only when the mode has changed, else the Main window.
void await(State&, WindowId then, Duration now, bool needs_mode = false);

/// The same of the Radio data window, for what a network has to answer.
void await_network(State&, WindowId then, Duration now);

/// Where the driver is after a registration that failed, with a radio network type: where both radio systems are used
/// another one can be chosen (015560 11.7.3 D9).
WindowId after_failed_registration(const port::Display&, port::RadioNetworkType);

}  // namespace evc::dmi
