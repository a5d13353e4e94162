#pragma once
#include <algorithm>
#include <array>
#include <optional>

#include "sdm/evaluate.h"
#include "sdm/supervision.h"
#include "sdm/tables.h"

// The common data of one supervision cycle: supervise.cpp (types of monitoring, statuses, commands), near.cpp (limits
// of the targets), display.cpp (displayed values). Not for other rooms.
namespace evc::sdm {

constexpr double kFar = 1e18;
/// Larger than any rounding error, smaller than any relevant difference.
constexpr Speed kSpare{0.1};

/// A target in this cycle. Plain numbers: members that are not used are not initialised.
struct Seen {
  std::uint8_t beyond;  // bit per Limit
  bool beyond_I_EBD, beyond_I_SBD;
  bool near;    // one of its limits can be exceeded; if not, its speeds are kFar
  double to_I;  // distance to its Indication limit; a lower bound of it if not `near`
  double V_P;
  double V_P_beyond_I;  // the same, of EOA and SvL only the part whose Indication limit is exceeded
};

constexpr std::uint8_t bit(Limit l) { return static_cast<std::uint8_t>(1u << static_cast<unsigned>(l)); }

/// The part of the bounds of `earliest_indication` that is the same for all targets.
struct Ahead {
  Approach a{};
  BuildUpLoss loss_cm0{}, loss_cmt{};  // with the longest times, towards a target speed below the train's
};

struct Cycle {
  Supervision& s;
  const Derived& d;
  const Motion& m;
  std::size_t first = 0;  // MRSP targets before it are passed
  Speed M{};              // V_MRSP
  Speed V_delta0{};
  Approach a{};
  Ahead ahead{};
  Times cm0{}, cmt{};
  Times longest_cm0{}, longest_cmt{};        // upper bounds of the times of all targets, reduced (4.0.0) or not
  Speed full_below_cm0{}, full_below_cmt{};  // 4.0.0: towards lower target speeds no build-up time is reduced
  Feedback feedback{};
  double V_I = kFar;     // the lowest V_I of the targets looked at closely
  bool reduced = false;  // some build-up time is reduced
  bool list_updated = false;
  bool V_MRSP_updated = false;
  Speed M_ebi{};  // V_MRSP + dV_ebi: the highest displayed ceiling
  // The lowest of all targets that are near.
  double V_W = kFar, V_SBI = kFar, V_EBI = kFar;
  // If a release speed exists:
  RsmStart rsm{};
  Place d_SvL{};
};

inline TargetId id_of(const Target& t) {
  return {t.kind, t.kind == TargetKind::EOA_SvL ? t.d_EOA : t.d_target, t.V_target};
}

inline const ReleaseSpeed& release(const Cycle& c) { return c.d.release_speed; }

/// 3.13.10.4.13: none, or not below V_MRSP: the tables are read with 0.
inline Speed V_release_in_tables(const Cycle& c) {
  return release(c).exists && release(c).V_release < c.M ? release(c).V_release : Speed{0.0};
}

/// The SvL and the targets between trip location and SvL (3.13.10.3.8, Table 16 [1]).
inline bool behind_trip_location(const Cycle& c, const Target& t) {
  if (t.kind == TargetKind::EOA_SvL) return true;
  return t.kind == TargetKind::MRSP && release(c).exists && t.d_target >= release(c).d_trip && t.d_target <= c.d_SvL;
}

inline TimesAsked asked(const Cycle& c, const Target& t) {
  TimesAsked q;
  q.feedback = c.feedback.towards(t);
  if (c.d.rules.reduced_build_up) q.reduced_from = Fronts{c.m.est_front, c.m.min_safe_front};
  return q;
}

/// Limits for a speed other than V_est, with the assumptions for that speed.
inline TargetLimits limits_at(const Cycle& c, const Target& t, Speed V) {
  Approach a = c.a;
  a.V = V;
  return limits_of(c.d, t, a, asked(c, t));
}

/// For a speed other than V_est.
Ahead ahead_of(const Cycle& c, Speed V);

/// Lower bounds of the places of the target's Indication limits: for one speed, and for every speed up to `V_least` of
/// the curves. Fast to compute; not available with service brake feedback or guidance.
struct Earliest {
  Place EBD{}, SBD{};
};
Earliest earliest_indication(const Cycle& c, const Target& t, const Ahead& ahead, Speed V_least);

using Bounds = std::array<Speed, static_cast<std::size_t>(Bound::count)>;

inline Speed& at(Bounds& b, Bound which) { return b[static_cast<std::size_t>(which)]; }
inline Speed at(const Bounds& b, Bound which) { return b[static_cast<std::size_t>(which)]; }

inline void set_target(Bounds& b, Speed Vt, const train::FixedValues& f) {
  at(b, Bound::Vt) = Vt;
  at(b, Bound::Vt_w) = Vt + dV_warning(Vt, f);
  at(b, Bound::Vt_sbi) = Vt + dV_sbi(Vt, f);
  at(b, Bound::Vt_ebi) = Vt + dV_ebi(Vt, f);
}
inline Bounds ceiling_bounds(Speed M, const train::FixedValues& f) {
  Bounds b{};
  at(b, Bound::M) = M;
  at(b, Bound::M_w) = M + dV_warning(M, f);
  at(b, Bound::M_sbi) = M + dV_sbi(M, f);
  at(b, Bound::M_ebi) = M + dV_ebi(M, f);
  return b;
}

/// Limits of target `i` at the train's place; if it is far away, only `near` is valid.
void evaluate(Cycle& c, std::size_t i, Seen& seen);

/// 3.13.10.4.2, 3.13.10.4.5. True when the driver has to be informed of a change.
bool select_MRDT(Cycle& c, const Seen* seen);
/// Limits, target and release speed for the display, with the values that may not rise (A.3.10, A.3.13).
void display(Cycle& c, const Seen* seen, Result& out);

}  // namespace evc::sdm
