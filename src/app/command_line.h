#pragma once

namespace evc::app {

/// Runs the command that the arguments of the program name. Returns its exit status; 2, with one line on standard
/// error, if they are wrong: `evc COMMAND: WHERE: found X, expected Y`.
int run_command(int argc, char** argv, const char* version);

}  // namespace evc::app
