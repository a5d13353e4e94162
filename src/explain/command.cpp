#include "explain/command.h"

#include <fmt/format.h>

#include <memory>
#include <optional>

#include "explain/journal.h"
#include "explain/screen.h"
#include "io/file.h"
#include "kernel/examine.h"
#include "run/stream.h"

namespace evc::explain {
namespace {

using io::complain;

/// The unit, and its memory before the last cycle.
struct Unit {
  kernel::State before, state;
  kernel::Derived derived;
  kernel::Examined seen;
  kernel::Outputs outputs;
};

io::Result<bool> power_up(Unit& unit, const kernel::Config& config, const std::string& persistent) {
  if (persistent.empty()) {
    kernel::power_up(unit.state, unit.derived, config);
    return true;
  }
  const auto retained = run::load_retained(persistent);
  if (!retained) return tl::unexpected(retained.error());
  (void)kernel::power_up(unit.state, unit.derived, config, *retained);
  return true;
}

/// Runs the journey up to the cycle to explain. False: it ends before; `last_ms` is its last cycle.
io::Result<bool> run_to(std::int64_t at_ms, io::InputStream& stream, Unit& unit, Journal& journal,
                        std::int64_t& last_ms) {
  const std::int64_t cycle_ms = stream.configuration().cycle_ms;
  sim::CycleInputs cycle;
  for (;;) {
    const auto more = stream.next(cycle);
    if (!more || !*more) return more;
    unit.before = unit.state;
    kernel::examine(unit.state, unit.derived, cycle.view(), unit.outputs, unit.seen);
    journal.take(cycle, unit.before, unit.state, unit.derived, unit.seen, unit.outputs);
    last_ms = cycle.t_ms;
    if (cycle.t_ms + cycle_ms <= at_ms) continue;
    journal.stop_here(cycle, unit.before, unit.state, unit.derived, unit.seen, unit.outputs);
    return true;
  }
}

}  // namespace

int explain(const Options& options) {
  for (const std::string& input : {options.input, options.config, options.persistent})
    if (const auto apart = io::not_the_input(input, options.output); !apart) return complain(apart.error());
  auto stream = run::open_stream(options.input, options.config);
  if (!stream) return complain(stream.error());
  const auto unit = std::make_unique<Unit>();
  const auto powered = power_up(*unit, stream->configuration().for_kernel(), options.persistent);
  if (!powered) return complain(powered.error());
  Journal journal;
  std::int64_t last_ms = 0;
  const auto there = run_to(options.at_ms, *stream, *unit, journal, last_ms);
  if (!there) return complain(run::of_stream(there.error(), options.input));
  if (!*there) {
    (void)complain({options.input, "", fmt::format("a journey that ends at {} ms", last_ms),
                    fmt::format("a cycle at {} ms", options.at_ms)});
    return 1;
  }
  bool answered = true;
  const std::string text = options.why_brake ? why_brake(journal, answered) : situation(journal);
  const auto written = io::write_whole(options.output, text);
  if (!written) return complain(written.error());
  return answered ? 0 : 1;
}

}  // namespace evc::explain
