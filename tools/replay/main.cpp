// `evc replay` and nothing else: what tools/check_determinism builds with every compiler and level.
#include <CLI/CLI.hpp>

#include "app/command_replay.h"

int main(int argc, char** argv) {
  CLI::App app{"evc replay alone"};
  app.require_subcommand(1);
  int exit_code = 0;
  evc::app::add_replay_command(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return exit_code;
}
