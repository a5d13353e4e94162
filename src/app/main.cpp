#include <cstdio>
#include <exception>
#include <new>
#include <system_error>

#include "app/command_line.h"
#include "app/signals.h"
#include "app/standard_streams.h"

int main(int argc, char** argv) {
  evc::app::take_closed_streams();
  evc::app::leave_no_parts_of_files();
  int exit_code = 2;
  int write_error = 0;
  try {
    exit_code = evc::app::run_command(argc, argv, EVC_VERSION);
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
