#include "serve/command.h"

#include <fmt/core.h>

#include <mutex>
#include <string>

#include "io/file.h"
#include "realtime/timing.h"
#include "run/stop_signals.h"
#include "serve/server.h"

namespace evc::serve {
namespace {

double milliseconds(realtime::Nanoseconds time) { return static_cast<double>(time.count()) / 1e6; }

/// At the end of a session with the clock.
std::string line_of(const realtime::Timing& timing) {
  return fmt::format(
      "session ended: {} cycles, {} missed; begin after due median {:.3f}, 99.9 % {:.3f}, max {:.3f} ms; answer "
      "after due max {:.3f} ms\n",
      timing.cycles, timing.missed, milliseconds(timing.jitter.share(0.5)), milliseconds(timing.jitter.share(0.999)),
      milliseconds(timing.jitter.max()), milliseconds(timing.response.max()));
}

/// Standard output for the lines of several units: of sessions that end together each line is whole. Nothing is written
/// after a line that was lost.
class Printed {
 public:
  void add(const std::string& line) {
    const std::lock_guard lock(mutex_);
    if (written_) written_ = io::write_whole("-", line);
  }
  io::Result<bool> written() const {
    const std::lock_guard lock(mutex_);
    return written_;
  }

 private:
  mutable std::mutex mutex_;
  io::Result<bool> written_ = true;
};

}  // namespace

int serve(const Options& options) {
  const run::StopSignals signals;
  Printed printed;
  ServerOptions wanted;
  wanted.port = options.port;
  wanted.manner.by_clock = options.real_time;
  wanted.manner.cycle_ms = options.cycle_ms;
  wanted.manner.printed.planning = options.planning;
  wanted.manner.printed.dmi = options.dmi;
  wanted.manner.measured = [&printed](const realtime::Timing& timing) { printed.add(line_of(timing)); };
  const auto server = Server::open(wanted);
  if (!server) return io::complain(server.error());
  printed.add(fmt::format("http://127.0.0.1:{}/\n", (*server)->port()));
  // Nobody can come to an address that nobody was given. Times that are lost end no session: they are an error at the
  // end.
  if (const auto written = printed.written(); !written) return io::complain(written.error());
  (*server)->run([&] { return signals.seen(); });
  const auto written = printed.written();
  return written ? 0 : io::complain(written.error());
}

}  // namespace evc::serve
