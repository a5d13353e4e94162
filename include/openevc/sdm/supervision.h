#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "openevc/base/inplace_vector.h"
#include "openevc/base/units.h"
#include "openevc/sdm/braking_curve.h"
#include "openevc/sdm/deceleration.h"
#include "openevc/sdm/feedback.h"
#include "openevc/sdm/inputs.h"
#include "openevc/sdm/limits.h"
#include "openevc/sdm/rules.h"
#include "openevc/terms/monitoring.h"

// Speed and distance monitoring, 3.13: `rebuild` when track, train or national values change,
// `supervise` in every cycle.
namespace evc::sdm {

enum class TargetKind : std::uint8_t { MRSP, LOA, EOA_SvL, SR_end };

inline constexpr std::size_t kTargets = 64;
inline constexpr std::size_t kKnotPool = 4096;

/// A curve in the pool of `Derived`.
struct CurveRef {
  std::uint16_t first = 0;
  std::uint16_t count = 0;
  friend constexpr bool operator==(const CurveRef&, const CurveRef&) = default;
};

/// A supervised target (3.13.8.2) with its fixed values.
struct Target {
  TargetKind kind = TargetKind::MRSP;
  bool due_to_TSR = false;
  bool zero = false;  // V_target = 0: times cm0, else cmt
  Speed V_target{};
  Place d_target{};  // SvL for EOA_SvL
  Place d_EOA{};     // EOA_SvL only
  CurveRef EBD, SBD, GUI, GUI_EOA;
  CurveWarnings warnings;
  Place foot{};                                                   // d_EBD(V_target)
  Place d_P_target{};                                             // d_P(V_target) without service brake feedback
  std::optional<Place> d_preindication_EBD, d_preindication_SBD;  // 3.4.0
  bool preindication_passed_at_once = false;                      // 3.4.0: curve below the MRSP at its start
};

/// Perturbation location (3.13.11): the reference of the MA request.
struct Perturbation {
  std::optional<Place> from_EBD;  // SvL or LOA, against the max safe front end
  std::optional<Place> from_SBD;  // EOA, against the estimated front end
  bool passed_at_once = false;    // 3.13.11.9
};

/// Release speed and its monitoring (3.13.9.4).
struct ReleaseSpeed {
  bool exists = false;
  bool on_board = false;
  Speed V_release{};
  Place d_trip{};  // d_tripEOA
  Place d_SBI1{};  // for V_release, against the estimated front end
  Place d_SBI2{};  // for V_release, the most restrictive one, against the max safe front end
};

/// Everything computed from `Inputs`; it can be computed again and is not part of a snapshot.
struct Derived {
  std::uint64_t revision = 0;  // of the inputs it was built from
  bool valid = false;
  Rules rules{};
  train::FixedValues fixed;
  train::BuildUpTimes cm0, cmt;
  TimeConfig time_config;
  bool service_brake_interface = false;
  bool traction_cut_off_interface = false;
  bool Q_NVEMRRLS = false;
  bool Q_NVINHSMICPERM = false;
  bool guidance = false;
  train::MaxReducedAdhesion::Display csm_display = train::MaxReducedAdhesion::Display::none;
  Speed V_relevant{};
  Decelerations decelerations;
  Mrsp mrsp;
  InplaceVector<Target, kTargets> targets;  // MRSP targets in order of place, then LOA or EOA_SvL, then SR_end
  ReleaseSpeed release_speed;
  Perturbation perturbation;
  bool truncated = false;        // something did not fit; handled on the safe side
  bool no_deceleration = false;  // A_safe <= 0 on the way to a target
  std::uint16_t knots_used = 0;
  std::array<Knot, kKnotPool> knots{};

  CurveView view(CurveRef r) const { return {{knots.data() + r.first, r.count}}; }
};

/// Builds everything when `in.revision` differs from what `out` was built from (or `out` is not
/// valid). True when it was built.
bool rebuild(Derived& out, const Inputs& in);

/// The train in this cycle.
struct Motion {
  Place est_front{}, min_safe_front{}, max_safe_front{};
  Speed V_est{};
  Speed V_ura{};  // speed under-reading amount, >= 0
  Acceleration A_est{};
  bool standstill = false;
  bool automatic = false;  // driven by automatic operation: its SBI limits command no brake (4.4.16.1.4 of 4.0.0)
  Duration now{};
  std::optional<double> brake_pressure_kpa;  // main pipe (or from the cylinder), for the feedback
  std::optional<Duration> T_MAR;             // of the RBC's MA request parameters (packet 57)
};

/// The target of a displayed value: kind, place and speed identify it across rebuilds.
struct TargetId {
  TargetKind kind = TargetKind::MRSP;
  Place d_target{};  // EOA for EOA_SvL: an SvL that comes nearer, as at the end of an overlap, ends no target
  Speed V_target{};
  friend constexpr bool operator==(const TargetId&, const TargetId&) = default;
};

/// The state of speed and distance monitoring, kept from cycle to cycle.
struct Supervision {
  bool active = false;  // false: the next cycle is the first one (3.13.10.3.5)
  Monitoring monitoring = Monitoring::CSM;
  Status status = Status::Normal;
  // Commands latched (3.13.10.2.2). `eb_for_sb`: emergency brake in place of a service brake.
  bool tco = false, sb = false, eb = false, eb_for_sb = false;
  std::uint64_t list_revision = 0;  // the target list of the last cycle
  std::uint16_t list_passed = 0;
  bool has_MRDT = false;
  TargetId MRDT{};
  Speed V_MRSP{};
  FeedbackState feedback;
  // Displayed values that may not rise (A.3.10, A.3.13).
  bool hold_P = false, hold_SBI = false, hold_target_distance = false;
  std::optional<Speed> shown_P{}, shown_SBI{};
  std::optional<Distance> shown_target_distance{};
};

/// Why something is commanded, for brake reasons and events: the number of the triggering condition.
struct Trigger {
  Monitoring monitoring = Monitoring::CSM;
  std::uint8_t condition = 0;  // n of "t<n>"; 0 none
};

struct Result {
  Monitoring monitoring = Monitoring::CSM;
  Status status = Status::Normal;
  bool tco = false, sb = false, eb = false;
  Trigger highest{};  // the highest condition met in this cycle
  bool status_changed = false;
  bool monitoring_changed = false;
  bool MRDT_changed = false;  // the driver is informed
  // Limits at the train's place, for display and traces.
  Speed V_MRSP, V_P, V_W, V_SBI, V_EBI;
  // The Indication limit as a speed, found as 3.13.9.3.5.5 finds V_P, at most V_MRSP; none in RSM.
  std::optional<Speed> V_I;
  bool show_SBI = false;  // Overspeed, Warning, Intervention
  // The most relevant displayed target; in CSM only with target information asked for by A_NVMAXREDADH.
  std::optional<Speed> V_target;
  std::optional<Distance> d_target;
  std::optional<TargetId> MRDT;
  std::optional<Speed> V_release;               // when to be shown
  std::optional<Distance> first_indication;     // CSM: distance to the first Indication location
  std::optional<TargetId> first_indication_of;  // and the target to which it belongs
  std::optional<Duration> TTI;                  // CSM: shown when asked for and below T_dispTTI
  bool MA_request = false;                      // perturbation location minus T_MAR passed (3.13.11.8)
  bool truncated = false, no_deceleration = false;
};

/// One cycle of 3.13.10. `derived` must be valid.
Result supervise(Supervision& state, const Derived& derived, const Motion& motion);

/// V_MRSP: the lowest speed between min and max safe front end (3.13.7.2).
Speed V_MRSP(const Mrsp& mrsp, Place min_safe_front, Place max_safe_front);

/// The highest of the six statuses that holds. `trip`: a train trip is due (EOA passed, timer elapsed). An estimated
/// speed above the EBI in force is EB, as the standard has it.
MemoStatus memo_status(const Result& result, Speed V_est, bool trip);

}  // namespace evc::sdm
