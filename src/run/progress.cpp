#include "run/progress.h"

#include <fmt/core.h>

#include <algorithm>

namespace evc::run {

void Progress::show(double share, std::int64_t t_ms, double speed_kmh) {
  if (!line_.is_seen()) return;
  constexpr std::size_t kWidth = 40;
  const int per_mille = static_cast<int>(1000.0 * std::clamp(share, 0.0, 1.0));
  if (per_mille == drawn_) return;
  drawn_ = per_mille;
  line_.show(fmt::format("{} [{}] {:3} %  {:02}:{:02}  {:5.1f} km/h", what_, io::bar_of(per_mille / 1000.0, kWidth),
                         per_mille / 10, t_ms / 60000, t_ms / 1000 % 60, speed_kmh));
}

void Progress::clear() {
  line_.clear();
  drawn_ = -1;
}

}  // namespace evc::run
