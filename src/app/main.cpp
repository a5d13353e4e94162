#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <new>
#include <sstream>
#include <string>
#include <system_error>

#include "app/command_line.h"
#include "app/commands.h"
#include "app/signals.h"
#include "app/standard_streams.h"
#include "io/file.h"

namespace {

/// Help or version.
int answer(const CLI::App& app, const CLI::ParseError& asked) {
  std::ostringstream text;
  app.exit(asked, text, text);
  const auto written = evc::io::write_whole("-", text.str());
  return written ? 0 : evc::io::complain(written.error());
}

int command(int argc, char** argv) {
  CLI::App app{"openevc: an open ETCS on-board unit. It claims no safety integrity."};
  app.set_version_flag("--version", EVC_VERSION);
  app.require_subcommand(1);
  int exit_code = 0;
  evc::app::add_commands(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Help and version are not errors; anything else is a wrong command line: one line and exit status 2.
    if (error.get_exit_code() == 0) return answer(app, error);
    std::fputs(evc::app::wrong_command_line(app, error, {argv + (argc > 0 ? 1 : 0), argv + argc}).c_str(), stderr);
    return 2;
  }
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  evc::app::take_closed_streams();
  evc::app::leave_no_parts_of_files();
  int exit_code = 2;
  int write_error = 0;
  try {
    exit_code = command(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fputs("evc: found not enough memory, expected enough for the input\n", stderr);
  } catch (const std::exception& error) {
    // fmt throws this when standard output cannot be written; anything else is a different failure.
    const auto* failed = dynamic_cast<const std::system_error*>(&error);
    if (failed != nullptr && std::ferror(stdout) != 0) {
      exit_code = 0;
      write_error = failed->code().value();
    } else {
      std::fprintf(stderr, "evc: found %s, expected no failure\n", error.what());
    }
  }
  return evc::app::with_all_written(exit_code, write_error);
}
