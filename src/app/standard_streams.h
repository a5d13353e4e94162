#pragma once

namespace evc::app {

/// A standard stream that the caller closed is taken, so that no file that the program opens gets its number: reading
/// from it and writing to it fail.
void take_closed_streams();

/// The exit status when the command ended with `exit_code`: 2 when not everything reached standard output, reported
/// in one line unless the command has reported an error already. `error`: errno of a write that failed before, 0 for
/// none.
int with_all_written(int exit_code, int error);

}  // namespace evc::app
