#include <CLI/CLI.hpp>
#include <functional>
#include <optional>

#include "app/command_line.h"
#include "app/commands.h"
#include "app/signals.h"
#include "app/standard_streams.h"
#include "cluster/messenger.h"
#include "cluster/ranks.h"

// `evc-mpi`: only rank 0 reads the command line and speaks; all ranks end with its status.
namespace {

using namespace evc;

constexpr const char* kName = "evc-mpi";

int first_rank(cluster::Messenger& messenger, int argc, char** argv) {
  cluster::Leader leader(messenger);
  const app::Program program{
      kName, "The sweep of openevc by the ranks of a cluster: mpirun evc-mpi sweep ... It claims no safety integrity.",
      EVC_VERSION, [&](CLI::App& app, int& exit_code) { app::add_commands_of_ranks(app, exit_code, leader); }};
  const int exit_code = app::run_guarded(kName, [&] { return app::run_command(program, argc, argv); });
  // The others compute, and there is no more to come for them.
  if (leader.computing()) cluster::Messenger::abort(exit_code);
  leader.finish(exit_code);
  return exit_code;
}

int other_rank(cluster::Messenger& messenger) {
  std::optional<int> ended;
  const int exit_code = app::run_guarded(kName, [&] { return *(ended = cluster::follow(messenger)); });
  if (!ended) cluster::Messenger::abort(exit_code);  // the others would wait for this one
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  app::take_closed_streams();
  app::leave_no_parts_of_files();
  return app::run_guarded(kName, [&] {
    cluster::Messenger messenger(argc, argv);
    return messenger.rank() == 0 ? first_rank(messenger, argc, argv) : other_rank(messenger);
  });
}
