#pragma once
#include <CLI/CLI.hpp>

namespace evc::app {

/// `evc describe packets|variables|messages [ID] [--markdown]`: the language's tables. Exit code 2: no
/// such packet, variable or message.
void add_describe_command(CLI::App& app, int& exit_code);

}  // namespace evc::app
