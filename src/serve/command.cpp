#include "serve/command.h"

#include <fmt/core.h>

#include <cstdio>

#include "realtime/timing.h"
#include "run/stop_signals.h"
#include "serve/server.h"

namespace evc::serve {
namespace {

double milliseconds(realtime::Nanoseconds time) { return static_cast<double>(time.count()) / 1e6; }

/// One line at the end of a session with the clock. Of several sessions that end together each line is whole.
void print_times(const realtime::Timing& timing) {
  fmt::print(
      "session ended: {} cycles, {} missed; begin after due median {:.3f}, 99.9 % {:.3f}, max {:.3f} ms; answer "
      "after due max {:.3f} ms\n",
      timing.cycles, timing.missed, milliseconds(timing.jitter.share(0.5)), milliseconds(timing.jitter.share(0.999)),
      milliseconds(timing.jitter.max()), milliseconds(timing.response.max()));
  std::fflush(stdout);
}

}  // namespace

int serve(const Options& options) {
  const run::StopSignals signals;
  ServerOptions wanted;
  wanted.port = options.port;
  wanted.manner.by_clock = options.real_time;
  wanted.manner.cycle_ms = options.cycle_ms;
  wanted.manner.printed.planning = options.planning;
  wanted.manner.printed.dmi = options.dmi;
  wanted.manner.measured = print_times;
  const auto server = Server::open(wanted);
  if (!server) return io::complain(server.error());
  fmt::print("http://127.0.0.1:{}/\n", (*server)->port());
  std::fflush(stdout);
  (*server)->run([&] { return signals.seen(); });
  return 0;
}

}  // namespace evc::serve
