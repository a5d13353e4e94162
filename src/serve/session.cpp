#include "serve/session.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include "io/file.h"
#include "io/input_stream.h"
#include "io/json.h"
#include "realtime/executor.h"
#include "run/drive.h"
#include "run/on_board.h"
#include "run/stream.h"

namespace evc::serve {
namespace {

using realtime::Nanoseconds;

/// The name in an error without a line.
constexpr const char* kName = "session";

/// The lines of a partner as those of a stream.
class Source {
 public:
  Source(Conversation& partner, bool waits) : partner_(partner), waits_(waits) {}

  /// The next line; false at the end. With the clock only the first one, that is not blank, is waited for: the unit
  /// begins with it.
  bool next(std::string& text) {
    Conversation::Line line;
    if (waits_ || !begun_ ? !partner_.wait_for_line(line) : !partner_.next_line(line)) return false;
    ++number_;
    if (line.too_long) throw io::ReadError{io::line_too_long(kName, number_)};
    if (!begun_) begin_ = line.arrived;
    begun_ = begun_ || line.text.find_first_not_of(" \t\r") != std::string::npos;
    arrived_ = line.arrived;
    text = std::move(line.text);
    return true;
  }

  bool begun() const { return begun_; }
  Nanoseconds begin() const { return begin_; }
  /// Of the last line, since the first one.
  std::int64_t arrived_ms() const {
    return std::chrono::duration_cast<std::chrono::milliseconds>(std::max(arrived_ - begin_, Nanoseconds{0})).count();
  }

 private:
  Conversation& partner_;
  bool waits_;
  bool begun_ = false;
  std::size_t number_ = 0;
  Nanoseconds begin_{0}, arrived_{0};
};

/// Cycles by the times of the lines.
io::Result<bool> by_lines(Conversation& partner, const Manner& manner) {
  Source source(partner, true);
  auto stream = io::InputStream::open(kName, [&](std::string& text) { return source.next(text); });
  if (!stream) return tl::unexpected(stream.error());
  if (stream->empty()) return tl::unexpected(run::no_input(kName));
  run::OnBoard on_board(stream->configuration().for_kernel());
  run::Answers answers(on_board, stream->configuration().ntc_names, manner.printed);
  sim::CycleInputs cycle;
  for (;;) {
    const auto more = stream->next(cycle);
    if (!more || !*more) return more;
    std::string line;
    answers.append(line, cycle);
    if (partner.give(std::move(line))) continue;
    partner.drop();
    return true;
  }
}

/// Cycles by the clock, from the first line on. Nothing is waited for but the time of the next cycle.
io::Result<bool> by_clock(Conversation& partner, const Manner& manner, realtime::Clock& clock,
                          const std::stop_token& stop) {
  Source source(partner, false);
  auto stream = io::InputStream::open_by_clock(kName, [&](std::string& text) { return source.next(text); },
                                               {[&] { return source.arrived_ms(); }, manner.cycle_ms});
  if (!stream) return tl::unexpected(stream.error());
  if (!source.begun()) return tl::unexpected(run::no_input(kName));
  run::OnBoard on_board(stream->configuration().for_kernel());
  run::Answers answers(on_board, stream->configuration().ntc_names, manner.printed);
  sim::CycleInputs cycle;
  io::Result<bool> result = true;
  std::stop_source over;
  const std::stop_callback also(stop, [&] { over.request_stop(); });
  realtime::Executor executor(clock, std::chrono::milliseconds(stream->configuration().cycle_ms));
  executor.run(source.begin(), over.get_token(), [&](const realtime::Cycle& due) {
    if (partner.inputs_ended() && stream->empty()) {
      over.request_stop();
      return;
    }
    result = stream->next(cycle);
    if (!result) {
      over.request_stop();
      return;
    }
    if (due.late > run::kLatestCycle) cycle.levels.safety_fault = true;
    std::string line;
    answers.append(line, cycle);
    if (partner.give_now(std::move(line))) return;
    partner.drop();
    over.request_stop();
  });
  if (manner.measured) manner.measured(executor.timing());
  return result;
}

}  // namespace

std::string error_line(io::Diagnostic error) {
  // There is no file: the line is its place.
  if (!error.where.empty()) error.file = std::exchange(error.where, "");
  return io::Json{{"error", error.text()}}.dump() + "\n";
}

void answer(Conversation& partner, const Manner& manner, realtime::Clock& clock, const std::stop_token& stop) {
  io::Result<bool> ended = true;
  try {
    ended = manner.by_clock ? by_clock(partner, manner, clock, stop) : by_lines(partner, manner);
  } catch (const std::exception& failure) {  // no memory for a line, for one
    ended = tl::unexpected(io::Diagnostic{kName, "", failure.what(), "no failure"});
  }
  if (!ended) (void)partner.give(error_line(ended.error()));
  partner.finish();
}

}  // namespace evc::serve
