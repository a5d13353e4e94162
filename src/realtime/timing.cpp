#include "realtime/timing.h"

#include <algorithm>
#include <bit>

namespace evc::realtime {
namespace {

constexpr unsigned kBits = 4;  // of the class within its power of two

/// Up to 2^kBits each time is a class of its own.
std::size_t class_of(std::uint64_t time) {
  const auto width = static_cast<unsigned>(std::bit_width(time));
  if (width <= kBits) return static_cast<std::size_t>(time);
  const unsigned shift = width - kBits - 1;
  return (static_cast<std::size_t>(shift) << kBits) + static_cast<std::size_t>(time >> shift);
}

std::uint64_t last_of_class(std::size_t n) {
  if (n < (std::size_t{2} << kBits)) return n;
  const std::size_t shift = (n >> kBits) - 1;
  const std::uint64_t first = (n & ((std::size_t{1} << kBits) - 1)) + (std::uint64_t{1} << kBits);
  return ((first + 1) << shift) - 1;
}

}  // namespace

void Times::add(Nanoseconds time) {
  time = std::max(time, Nanoseconds{0});
  const std::size_t n = class_of(static_cast<std::uint64_t>(time.count()));
  ++classes_[std::min(n, classes_.size() - 1)];
  ++count_;
  max_ = std::max(max_, time);
}

Nanoseconds Times::share(double share) const {
  const double wanted = share * static_cast<double>(count_);
  double seen = 0.0;
  for (std::size_t n = 0; n < classes_.size(); ++n) {
    seen += static_cast<double>(classes_[n]);
    if (classes_[n] > 0 && seen >= wanted)
      return std::min(max_, Nanoseconds{static_cast<std::int64_t>(last_of_class(n))});
  }
  return max_;
}

void Timing::note(const CycleTimes& times, Nanoseconds period) {
  ++cycles;
  if (times.ended > times.due + period) ++missed;
  jitter.add(times.started - times.due);
  response.add(times.ended - times.due);
}

}  // namespace evc::realtime
