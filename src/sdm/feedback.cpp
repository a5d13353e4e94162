#include "sdm/feedback.h"

#include <algorithm>

namespace evc::sdm {
namespace {

constexpr double kStable = 20.0;  // kPa, A.3.10.2 a
constexpr Duration kStableFor{3.0};
constexpr double kLowest = 400.0, kHighest = 550.0;
constexpr Duration kLongest{200.0};
constexpr double kP1 = 30.0, kP2 = 60.0, kP3 = 150.0;  // below p0

}  // namespace

void follow_pressure(FeedbackState& s, std::optional<double> p_kpa, Duration now) {
  if (!p_kpa.has_value()) {
    s.searching = false;
    return;
  }
  const double p = std::min(*p_kpa, kHighest);
  if (!s.p0_known) {
    const bool stays = s.searching && p >= s.p_search - kStable && p <= s.p_search + kStable;
    if (p < kLowest) {
      s.searching = false;
    } else if (!stays) {
      s.searching = true;
      s.p_search = p;
      s.since = now;
    } else if (now - s.since >= kStableFor) {
      s.p0_known = true;
      s.p0 = p;
      s.last = now;
    }
    return;
  }
  // A.3.10.2 b: once per second. After a gap, at most as many steps as p0 needs to change from any value to any other.
  s.last = std::max(s.last, now - kLongest);
  while (now - s.last >= Duration{1.0}) {
    s.last += Duration{1.0};
    if (p > s.p0)
      s.p0 = std::min(s.p0 + 1.5, kHighest);
    else if (p < s.p0 && p > s.p0 - kP1)
      s.p0 = s.p0 - 0.5;
  }
}

void reset_feedback(FeedbackState& s, Duration T_bs) {
  s.started = false;
  s.locked = false;
  s.T_bs1_previous = T_bs;
}

FeedbackTimes feedback_times(FeedbackState& s, std::optional<double> p_kpa, Duration T_bs,
                             const train::FixedValues& fixed, bool may_begin) {
  const FeedbackTimes full{T_bs, std::max(T_bs, fixed.T_bs2_min)};
  if (s.locked) return {Duration{0.0}, fixed.T_bs2_min};
  if (!s.p0_known || !p_kpa.has_value() || !(s.started || may_begin)) return full;
  const double p = std::min(*p_kpa, kHighest);
  if (p <= s.p0 - kP2) {
    s.locked = true;
    s.started = true;
    return {Duration{0.0}, fixed.T_bs2_min};
  }
  if (!s.started && p > s.p0 - kP1) return full;
  s.started = true;
  const double p3 = s.p0 - kP3;
  const Duration T = std::min(T_bs, ((p - p3) / (s.p0 - p3)) * T_bs);
  return {T, std::max(T, fixed.T_bs2_min)};
}

}  // namespace evc::sdm
