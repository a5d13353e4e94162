#include "run/progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace evc::run {
namespace {
constexpr int kWidth = 40;
}

Progress::Progress(const char* what) : what_(what), terminal_(::isatty(2) != 0) {}

Progress::~Progress() { clear(); }

void Progress::show(double share, std::int64_t t_ms, double speed_kmh) {
  if (!terminal_) return;
  const int per_mille = static_cast<int>(1000.0 * std::clamp(share, 0.0, 1.0));
  if (per_mille == drawn_) return;
  drawn_ = per_mille;
  const int full = per_mille * kWidth / 1000;
  const std::string bar =
      std::string(static_cast<std::size_t>(full), '#') + std::string(static_cast<std::size_t>(kWidth - full), '.');
  fmt::print(stderr, "\r{} [{}] {:3} %  {:02}:{:02}  {:5.1f} km/h ", what_, bar, per_mille / 10, t_ms / 60000,
             t_ms / 1000 % 60, speed_kmh);
  std::fflush(stderr);
}

void Progress::clear() {
  if (!terminal_ || drawn_ < 0) return;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
  drawn_ = -1;
}

}  // namespace evc::run
