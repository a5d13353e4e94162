#include "serve/command.h"

#include <fmt/core.h>

#include <cstdio>

#include "run/stop_signals.h"
#include "serve/server.h"

namespace evc::serve {

int serve(const Options& options) {
  const run::StopSignals signals;
  ServerOptions wanted;
  wanted.port = options.port;
  wanted.manner.by_clock = options.real_time;
  wanted.manner.cycle_ms = options.cycle_ms;
  wanted.manner.printed.planning = options.planning;
  wanted.manner.printed.dmi = options.dmi;
  const auto server = Server::open(wanted);
  if (!server) return io::complain(server.error());
  fmt::print("http://127.0.0.1:{}/\n", (*server)->port());
  std::fflush(stdout);
  (*server)->run([&] { return signals.seen(); });
  return 0;
}

}  // namespace evc::serve
