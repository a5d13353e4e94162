#pragma once

namespace CLI {
class App;
}
namespace evc::sweep {
class Computers;
}

namespace evc::app {

/// Adds every command with its arguments; the given command runs and stores its exit status in `exit_code`.
void add_commands(CLI::App& app, int& exit_code);

/// Adds the commands of `evc-mpi`: `sweep`, computed by its ranks.
void add_commands_of_ranks(CLI::App& app, int& exit_code, sweep::Computers& ranks);

}  // namespace evc::app
