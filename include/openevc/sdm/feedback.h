#pragma once
#include <optional>

#include "openevc/base/units.h"
#include "openevc/sdm/limits.h"

// Service brake feedback, A.3.10: when the pressure shows that the driver brakes, the build-up times are reduced.
namespace evc::sdm {

struct FeedbackState {
  bool started = false, locked = false;
  bool p0_known = false;
  double p0 = 0.0;
  // Search for the first stable pressure: 3 s within +-20 kPa.
  bool searching = false;
  double p_search = 0.0;
  Duration since{};
  Duration last{};
  Duration T_bs1_previous{};
  bool approaching = false;  // 3.4.0: faster than a target whose Indication limit is exceeded, in the last cycle
};

/// Updates p0 (A.3.10.2); called in every cycle, in any type of monitoring.
void follow_pressure(FeedbackState& s, std::optional<double> p_kpa, Duration now);

/// Resets the feedback: on leaving TSM or passing the target (3.4.0), on entering CSM, on entering TSM or RSM from CSM
/// (4.0.0).
void reset_feedback(FeedbackState& s, Duration T_bs);

/// T_bs1 and T_bs2 now (A.3.10.3); without a known pressure T_bs. T_bs2 is at least T_bs2_min. `may_begin`: a falling
/// pressure starts to count now; a count that has started continues in any case.
FeedbackTimes feedback_times(FeedbackState& s, std::optional<double> p_kpa, Duration T_bs,
                             const train::FixedValues& fixed, bool may_begin = true);

}  // namespace evc::sdm
