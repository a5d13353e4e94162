#pragma once
#include <functional>

namespace CLI {
class App;
}

namespace evc::app {

struct Program {
  const char* name;
  const char* description;
  const char* version;
  /// Adds the commands; the given one runs and stores its exit status.
  std::function<void(CLI::App&, int&)> add_commands;
};

/// Runs the command that the arguments of the program name. Returns its exit status; 2, with one line on standard
/// error, if they are wrong: `PROGRAM COMMAND: WHERE: found X, expected Y`.
int run_command(const Program& program, int argc, char** argv);

/// Runs a command to its exit status, when everything that it printed is written. What it throws is one line on
/// standard error, and exit status 2.
int run_guarded(const char* program, const std::function<int()>& command);

}  // namespace evc::app
