#pragma once
#include <optional>
#include <vector>

#include "deceleration/bands.h"
#include "deceleration/plain_run.h"
#include "deceleration/spec.h"

namespace evc::deceleration {

/// What a train guarantees, by steps of speed.
struct Guaranteed {
  struct AtSpeed {
    double from_kmh = 0.0;
    double A_brake_emergency = 0.0;       ///< nominal, m/s2
    Quantiles Kdry_rst;                   ///< by M_NVEBCL; not rounded, above 1 where it is so
    std::optional<Quantiles> build_up_s;  ///< exceeded with these probabilities; its low bound is the shorter time
  };
  std::vector<AtSpeed> steps;
  std::optional<PlainRun> plain;  ///< its steps are those above
  double seconds = 0.0;           ///< the computation took, without the plain run

  /// The steps with the low bound of each factor: what can be promised.
  std::vector<Step> safe_steps() const;
  /// The longest time over all speeds, at its high bound, that is exceeded with the probability of this level, in s.
  std::optional<double> build_up_at(std::size_t level) const;
  /// The largest half width of the bounds at this level.
  double error_at(std::size_t level) const;
};

/// `progress` gets the share that is done. `plain` samples of a plain run; 0 for none.
Guaranteed guaranteed(const Spec& spec, unsigned threads, std::uint64_t plain,
                      const std::function<void(double)>& progress);

}  // namespace evc::deceleration
