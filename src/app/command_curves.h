#pragma once
#include <CLI/CLI.hpp>

namespace evc::app {

/// `evc curves`: braking curves and supervision limits of one train and one target; `evc curves compare`.
void add_curves_command(CLI::App& app, int& exit_code);

}  // namespace evc::app
