#pragma once
#include <CLI/CLI.hpp>

namespace evc::app {

/// `evc make-line`: a line file from a readable description.
void add_make_line_command(CLI::App& app, int& exit_code);

}  // namespace evc::app
