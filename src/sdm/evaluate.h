#pragma once
#include <optional>

#include "sdm/limits.h"
#include "sdm/supervision.h"

// The limits of one target for one speed. This is the only code that composes them; used by supervision, by the fixed
// locations and by `explain`.
namespace evc::sdm {

/// Position of the train, for the build-up times of 4.0.0. Without it the times are not reduced.
struct Fronts {
  Place est{}, min_safe{};
};

/// The times as a clause defines them.
struct TimesAsked {
  std::optional<FeedbackTimes> feedback;  // service brake feedback in action
  std::optional<Fronts> reduced_from;     // 4.0.0: reduced build-up times from these front ends
};

struct TargetTimes {
  Times EBD, SBD;
  bool reduced_be = false, reduced_bs = false;
};
TargetTimes times_of(const Derived& d, const Target& target, const Approach& a, const TimesAsked& asked);

/// Upper bounds of the times that `times_of` returns for all targets (4.0.0), from the unreduced ones. A shorter T_bs2
/// makes T_traction longer where a traction cut-off interface is fitted (3.13.9.3.2.3).
Times longest_times(const Times& unreduced, const Derived& d, const train::BuildUpTimes& build_up);

/// 4.0.0: towards target speeds below this one no build-up time is reduced on any track (A.3.12.4).
Speed full_build_up_below(const Derived& d, const train::BuildUpTimes& build_up, const Approach& a,
                          const Times& unreduced);

/// Limits of a target: EBD always, SBD for EOA_SvL.
struct TargetLimits {
  TargetTimes times;
  Limits EBD{};
  std::optional<Limits> SBD;
};
TargetLimits limits_of(const Derived& d, const Target& target, const Approach& a, const TimesAsked& asked);
/// The same with known times.
Limits EBD_limits_of(const Derived& d, const Target& target, const Approach& a, const Times& t);
Limits SBD_limits_of(const Derived& d, const Target& target, const Approach& a, const Times& t);

/// V_delta0 of clauses that use SUBSET-041 instead of V_ura: f41(V), 0 where inhibited.
Speed V_delta0_41(const Derived& d, Speed V);

/// Service brake feedback in action: the times towards a target speed of 0, and towards others.
struct Feedback {
  std::optional<FeedbackTimes> cm0{}, cmt{};
  const std::optional<FeedbackTimes>& towards(const Target& t) const { return t.zero ? cm0 : cmt; }
};

/// Start of release speed monitoring for a release speed (3.13.9.4.6-7).
struct RsmStart {
  Place d_SBI1{}, d_SBI2{};
};
RsmStart rsm_start(const Derived& d, const Target& EOA_SvL, Speed V_release, Place d_trip, bool on_board,
                   const Feedback& feedback);

}  // namespace evc::sdm
