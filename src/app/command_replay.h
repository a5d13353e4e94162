#pragma once
#include <CLI/CLI.hpp>

namespace evc::app {

/// `evc replay`: the on-board seen from outside, a stream of inputs to a stream of outputs.
void add_replay_command(CLI::App& app, int& exit_code);

}  // namespace evc::app
