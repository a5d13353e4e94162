#include "kernel/clock.h"

namespace evc::kernel {
namespace {

/// The difference of two times in milliseconds may be a little below a whole second.
std::int64_t whole_seconds(Duration elapsed) { return static_cast<std::int64_t>(elapsed.si + 0.0005); }

/// What the clock went on since power off, less the time since power-up, which counted. A clock that was set back
/// meanwhile says nothing of the time without power: the cover stays applicable (3.15.9.5).
void count_time_without_power(balise::Cover& cover, std::int64_t utc, Duration since_power_up) {
  if (!cover.power_off) return;
  const Duration without_power = Duration{static_cast<double>(utc - *cover.power_off)} - since_power_up;
  if (without_power > Duration{}) cover.until = cover.until - without_power;
  cover.power_off.reset();
}

}  // namespace

void read_clock(State& s, const std::optional<std::int64_t>& reading) {
  if (!reading || !is_date(*reading)) return;
  s.clock = ClockReading{*reading, s.now};
  for (balise::Cover& cover : s.balise.covers) count_time_without_power(cover, *reading, s.now);
}

std::optional<std::int64_t> date(const State& s) {
  if (!s.clock) return std::nullopt;
  return s.clock->utc + whole_seconds(s.now - s.clock->at);
}

std::optional<std::int64_t> date_of(const State& s, const balise::Cover& cover) {
  const std::optional<std::int64_t> utc =
      cover.power_off ? std::optional(*cover.power_off + whole_seconds(s.now)) : date(s);
  return utc && is_date(*utc) ? utc : std::nullopt;
}

}  // namespace evc::kernel
