#pragma once
#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace evc::app {

/// The error of the command line, in one line: `evc COMMAND: WHERE: found X, expected Y`. `arguments` are those of the
/// program, without its name.
std::string wrong_command_line(const CLI::App& app, const CLI::ParseError& error,
                               const std::vector<std::string>& arguments);

}  // namespace evc::app
