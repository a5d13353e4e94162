#include <CLI/CLI.hpp>

#include "app/command_curves.h"
#include "app/command_decode.h"
#include "app/command_describe.h"
#include "app/command_encode.h"
#include "app/command_make_line.h"
#include "app/command_replay.h"
#include "app/command_run.h"

int main(int argc, char** argv) {
  CLI::App app{"openevc: an open ETCS on-board unit. It claims no safety integrity."};
  app.set_version_flag("--version", EVC_VERSION);
  app.require_subcommand(1);
  int exit_code = 0;
  evc::app::add_run_command(app, exit_code);
  evc::app::add_replay_command(app, exit_code);
  evc::app::add_curves_command(app, exit_code);
  evc::app::add_decode_command(app, exit_code);
  evc::app::add_encode_command(app, exit_code);
  evc::app::add_describe_command(app, exit_code);
  evc::app::add_make_line_command(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Exit status 2: the command line is wrong.
    return app.exit(error) == 0 ? 0 : 2;
  }
  return exit_code;
}
