#pragma once

namespace CLI {
class App;
}

namespace evc::app {

/// Adds every command with its arguments; the given command runs and stores its exit status in `exit_code`.
void add_commands(CLI::App& app, int& exit_code);

}  // namespace evc::app
