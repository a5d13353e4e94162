#include "sweep/progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <string>

namespace evc::sweep {
namespace {

constexpr int kWidth = 30;

/// "1:02:03", "2:03".
std::string clock_of(double seconds) {
  const auto s = static_cast<std::int64_t>(seconds + 0.5);
  if (s >= 3600) return fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
  return fmt::format("{}:{:02}", s / 60, s % 60);
}

}  // namespace

Progress::Progress(std::uint64_t done, std::uint64_t all) : before_(done), all_(all), terminal_(::isatty(2) != 0) {}

Progress::~Progress() { clear(); }

double Progress::seconds() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

void Progress::show(std::uint64_t done, std::uint64_t failed) {
  if (!terminal_ || Clock::now() - last_ < std::chrono::milliseconds(100)) return;
  last_ = Clock::now();
  const double share = static_cast<double>(done) / static_cast<double>(all_);
  const auto full = static_cast<std::size_t>(share * kWidth);
  const double rate = static_cast<double>(done - before_) / seconds();
  const std::string left = rate > 0.0 ? clock_of(static_cast<double>(all_ - done) / rate) : "-";
  fmt::print(stderr, "\rsweep [{}{}] {} of {}, {:.{}f} a second, {} left{} \033[K", std::string(full, '#'),
             std::string(kWidth - full, '.'), done, all_, rate, rate < 10.0 ? 1 : 0, left,
             failed == 0 ? "" : fmt::format(", {} failed", failed));
  std::fflush(stderr);
  drawn_ = true;
}

void Progress::clear() {
  if (!drawn_) return;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
  drawn_ = false;
}

}  // namespace evc::sweep
