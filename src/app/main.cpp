#include <CLI/CLI.hpp>

#include <cstdio>
#include <string>

#include "app/command_curves.h"
#include "app/command_decode.h"
#include "app/command_describe.h"
#include "app/command_encode.h"
#include "app/command_make_line.h"
#include "app/command_replay.h"
#include "app/command_run.h"

namespace {

/// What is wrong with the command line, in one line; a command that does not exist is named.
std::string wrong_command_line(CLI::App& app, const CLI::ParseError& error, const std::string& first) {
  std::string commands;
  bool known = first.empty() || first.front() == '-';
  for (const CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) {
    known = known || command->get_name() == first;
    commands += (commands.empty() ? "" : ", ") + command->get_name();
  }
  if (!known) return "evc: found \"" + first + "\", expected one of " + commands + "\n";
  return "evc" + (first.empty() || first.front() == '-' ? std::string() : " " + first) + ": " + error.what() + "\n";
}

}  // namespace

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
    // Help and version are answers; anything else is a wrong command line: one line and exit status 2.
    if (error.get_exit_code() == 0) return app.exit(error);
    std::fputs(wrong_command_line(app, error, argc > 1 ? argv[1] : "").c_str(), stderr);
    return 2;
  }
  return exit_code;
}
