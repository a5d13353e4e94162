#pragma once

namespace evc::app {

/// Occupies standard streams that the caller closed, so that no file opened by the program gets their number: reading
/// from them and writing to them fail.
void take_closed_streams();

/// The exit status when the command ended with `exit_code`: 2 when not everything reached standard output, reported in
/// one line unless the command has already reported an error. `error`: errno of a write that failed before, 0 for none.
int with_all_written(int exit_code, int error);

}  // namespace evc::app
