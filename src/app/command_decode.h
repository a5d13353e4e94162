#pragma once
#include <CLI/CLI.hpp>

namespace evc::app {

/// `evc decode balise|airgap|radio|packet` (docs/decode.md). Exit codes: 0 all taken, 1 something was
/// refused, 2 the input cannot be read.
void add_decode_command(CLI::App& app, int& exit_code);

}  // namespace evc::app
