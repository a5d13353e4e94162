#pragma once
#include <CLI/CLI.hpp>

namespace evc::app {

/// `evc run`: a train driven along a line.
void add_run_command(CLI::App& app, int& exit_code);

}  // namespace evc::app
