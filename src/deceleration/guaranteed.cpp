#include "deceleration/guaranteed.h"

#include <algorithm>
#include <chrono>

namespace evc::deceleration {
namespace {

/// The quantiles of each step; where the units have the weights of an earlier step they are that one's.
template <class Make>
std::vector<Quantiles> by_speed(const Spec& spec, std::uint32_t number, Effort effort, Make make,
                                const std::function<void(double)>& progress) {
  std::vector<Quantity> quantities;
  std::vector<Quantiles> found;
  const auto all = static_cast<double>(spec.speeds_kmh.size());
  for (std::size_t s = 0; s < spec.speeds_kmh.size(); ++s) {
    quantities.push_back(make(spec, spec.speeds_kmh[s]));
    std::size_t same = 0;
    while (!same_weights(quantities[same], quantities[s])) ++same;
    effort.progress = [&](double share) { progress((static_cast<double>(s) + share) / all); };
    found.push_back(same < s ? found[same] : quantiles(quantities[s], number + static_cast<std::uint32_t>(s), effort));
  }
  return found;
}

/// The quantile of a time from that of the time times -1.
Quantiles of_time(Quantiles negative) {
  for (Quantile& q : negative) q = {-q.value, -q.high, -q.low};
  return negative;
}

}  // namespace

std::vector<Step> Guaranteed::safe_steps() const {
  std::vector<Step> safe;
  for (const AtSpeed& step : steps) {
    safe.push_back({step.from_kmh, step.A_brake_emergency, {}});
    for (std::size_t k = 0; k < kLevels; ++k) safe.back().Kdry_rst[k] = step.Kdry_rst[k].low;
    // A higher level promises no more: the bounds of two levels are estimated separately.
    for (std::size_t k = 1; k < kLevels; ++k)
      safe.back().Kdry_rst[k] = std::min(safe.back().Kdry_rst[k], safe.back().Kdry_rst[k - 1]);
  }
  return safe;
}

std::optional<double> Guaranteed::build_up_at(std::size_t level) const {
  std::optional<double> longest;
  for (const AtSpeed& step : steps)
    if (step.build_up_s) longest = std::max(longest.value_or(0.0), (*step.build_up_s)[level].high);
  return longest;
}

double Guaranteed::error_at(std::size_t level) const {
  double error = 0.0;
  for (const AtSpeed& step : steps)
    error = std::max(error, 0.5 * (step.Kdry_rst[level].high - step.Kdry_rst[level].low));
  return error;
}

Guaranteed guaranteed(const Spec& spec, unsigned threads, std::uint64_t plain,
                      const std::function<void(double)>& progress) {
  const auto begin = std::chrono::steady_clock::now();
  const Effort effort{spec.seed, spec.samples, threads, {}};
  const double share = spec.has_response() ? 0.5 : 1.0;
  Guaranteed result;
  const auto factors = by_speed(spec, 0, effort, deceleration_of, [&](double done) { progress(share * done); });
  for (std::size_t s = 0; s < spec.speeds_kmh.size(); ++s)
    result.steps.push_back(
        {spec.speeds_kmh[s], nominal_deceleration(spec, spec.speeds_kmh[s]), factors[s], std::nullopt});
  if (spec.has_response()) {
    const auto times = by_speed(spec, kMostSpeeds, effort, build_up_time_of,
                                [&](double done) { progress(share + (1.0 - share) * done); });
    for (std::size_t s = 0; s < times.size(); ++s) result.steps[s].build_up_s = of_time(times[s]);
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (plain > 0) {
    Effort counting = effort;
    counting.progress = progress;
    result.plain = plain_run(spec, plain, counting);
  }
  return result;
}

}  // namespace evc::deceleration
