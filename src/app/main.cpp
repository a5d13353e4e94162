#include "app/command_line.h"
#include "app/commands.h"
#include "app/signals.h"
#include "app/standard_streams.h"

int main(int argc, char** argv) {
  using namespace evc::app;
  take_closed_streams();
  leave_no_parts_of_files();
  const Program program{"evc", "openevc: an open ETCS on-board unit. It claims no safety integrity.", EVC_VERSION,
                        add_commands};
  return run_guarded(program.name, [&] { return run_command(program, argc, argv); });
}
