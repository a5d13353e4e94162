#pragma once
#include "openevc/terms/srs_version.h"

namespace evc::sdm {

/// The differences between the issues of SUBSET-026 in speed and distance monitoring, as data: the same code serves all
/// issues. The text of 3.6.0 was not available; its column is deduced from 3.4.0, 4.0.0 and the driver machine
/// interface of 3.6.0.
struct Rules {
  bool indication_includes_T_driver;    // T_indication + T_driver (3.13.9.3.6.2)
  bool pre_indication;                  // CSM -> TSM by pre-indication location, Normal status in TSM
  bool ceiling_rows_need_indication;    // t6, t9, t12, t15 only beyond the Indication limit
  bool all_lower_elements_are_targets;  // every MRSP element below V_MRSP, else only decreases
  bool reduced_build_up;                // A.3.12
  bool P_not_beyond_target;             // 3.13.9.3.5.1: d_P <= d_target
  bool indication_ignores_feedback;     // 3.13.9.3.6.5
  bool release_speed_with_D41;          // 3.13.9.4.8: D41 in level 1, traction cut-off as not implemented
  bool masking;                         // MRDT among targets whose Indication limit is exceeded, with masking
  bool first_indication;                // first Indication location, TTI, target information in CSM
  bool feedback_until_CSM;              // A.3.10: active in TSM and RSM, else per target
  bool LX_with_current_motion;          // 3.13.9.3.5.12 with A_est and V_ura, else f41(V_LX) and 0
};

constexpr Rules rules_of(SrsVersion version) {
  const bool v360 = version != SrsVersion::v3_4_0;
  const bool v400 = version == SrsVersion::v4_0_0;
  return {
      .indication_includes_T_driver = v360,
      .pre_indication = !v360,
      .ceiling_rows_need_indication = v360 && !v400,
      .all_lower_elements_are_targets = v400,
      .reduced_build_up = v400,
      .P_not_beyond_target = v400,
      .indication_ignores_feedback = v400,
      .release_speed_with_D41 = v400,
      .masking = v360,
      .first_indication = v360,
      .feedback_until_CSM = v400,
      .LX_with_current_motion = v400,
  };
}

}  // namespace evc::sdm
