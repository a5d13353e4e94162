#pragma once

namespace evc::app {

/// From now on a signal that ends the program (io::kEndingSignals) first deletes the files that are not
/// complete; one that the caller ignores stays ignored. What is beyond the size that the caller permits is an error of
/// the file.
void leave_no_parts_of_files();

}  // namespace evc::app
