#include "sweep/progress.h"

#include <fmt/core.h>

#include <string>

namespace evc::sweep {
namespace {

constexpr std::size_t kWidth = 30;

/// "1:02:03", "2:03".
std::string clock_of(double seconds) {
  const auto s = static_cast<std::int64_t>(seconds + 0.5);
  if (s >= 3600) return fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
  return fmt::format("{}:{:02}", s / 60, s % 60);
}

}  // namespace

double Progress::seconds() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

void Progress::show(std::uint64_t done, std::uint64_t failed) {
  if (!line_.is_seen() || Clock::now() - last_ < std::chrono::milliseconds(100)) return;
  last_ = Clock::now();
  const double rate = static_cast<double>(done - before_) / seconds();
  const std::string left = rate > 0.0 ? clock_of(static_cast<double>(all_ - done) / rate) : "-";
  line_.show(fmt::format("sweep [{}] {} of {}, {:.{}f} a second, {} left{}",
                         io::bar_of(static_cast<double>(done) / static_cast<double>(all_), kWidth), done, all_, rate,
                         rate < 10.0 ? 1 : 0, left, failed == 0 ? "" : fmt::format(", {} failed", failed)));
}

}  // namespace evc::sweep
