#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "explain/brake.h"
#include "explain/words.h"
#include "kernel/curves.h"
#include "kernel/here.h"
#include "sdm/evaluate.h"
#include "terms/packet_numbers.h"

// Commands by speed and distance monitoring (3.13.10): which limit of which target, what set it, what moved it.
namespace evc::explain {
namespace {

enum class LimitOf : std::uint8_t { warning, SBI, EBI };

const char* limit_name(LimitOf which) {
  return which == LimitOf::warning ? "warning" : which == LimitOf::SBI ? "SBI" : "EBI";
}

/// A cause as the limit that was exceeded: an emergency brake in place of the service brake is of the SBI limit.
LimitOf limit_of(Cause cause, const Moment& m) {
  if (cause == Cause::overspeed_traction) return LimitOf::warning;
  const bool instead = cause == Cause::overspeed_emergency && !m.after.supervision.eb;
  return cause == Cause::overspeed_service || instead ? LimitOf::SBI : LimitOf::EBI;
}

/// A target beyond whose limit the train is.
struct Exceeded {
  sdm::TargetId id;
  bool from_SBD = false;  ///< the curve of the EOA, with the estimated front end (3.13.9.3.3.1); else an EBD, with the
                          ///< max safe front end (3.13.9.3.2.12, 3.13.9.3.3.2)
  Place curve_end{};      ///< where the curve ends: EOA, SvL or the target
  double beyond = 0.0;    ///< metres
};

/// Of the targets in target speed monitoring the one beyond whose limit the train is the farthest; nothing: the limits
/// of this cycle were others (service brake feedback), or it was the ceiling.
std::optional<Exceeded> exceeded(const Moment& m, LimitOf which) {
  const sdm::Derived& d = m.curves.sdm;
  if (m.outputs.monitoring != Monitoring::TSM || !d.valid) return std::nullopt;
  const sdm::Motion motion = kernel::motion_of(m.after, kernel::here(m.after), m.train);
  const sdm::Approach approach =
      sdm::approach(motion.V_est, d.Q_NVINHSMICPERM ? Speed{} : motion.V_ura, motion.A_est, d.fixed);
  sdm::TimesAsked asked;
  if (d.rules.reduced_build_up) asked.reduced_from = sdm::Fronts{motion.est_front, motion.min_safe_front};
  std::optional<Exceeded> most;
  const auto consider = [&](const sdm::Target& t, bool from_SBD, Place front, Place limit) {
    const bool end = t.kind == sdm::TargetKind::EOA_SvL;
    const double beyond = (front - limit).si;
    if (beyond <= 0.0 || (most && most->beyond >= beyond)) return;
    most =
        Exceeded{{t.kind, end ? t.d_EOA : t.d_target, t.V_target}, from_SBD, from_SBD ? t.d_EOA : t.d_target, beyond};
  };
  for (const sdm::Target& t : d.targets) {
    if (motion.V_est <= t.V_target) continue;
    if (t.kind == sdm::TargetKind::MRSP && motion.max_safe_front > t.d_target) continue;  // passed
    const sdm::TargetLimits limits = sdm::limits_of(d, t, approach, asked);
    const auto place = [&](const sdm::Limits& l) {
      return which == LimitOf::warning ? std::optional(l.d_W)
             : which == LimitOf::SBI   ? std::optional(l.d_SBI)
                                       : l.d_EBI;
    };
    if (const auto limit = place(limits.EBD)) consider(t, false, motion.max_safe_front, *limit);
    if (!limits.SBD) continue;
    if (const auto limit = place(*limits.SBD)) consider(t, true, motion.est_front, *limit);
  }
  return most;
}

/// The target that limits the speed; nothing: the ceiling does.
std::optional<sdm::TargetId> target_of(const Command& command) {
  const Moment& m = *command.braking->onset;
  if (const auto most = exceeded(m, limit_of(command.cause, m))) return most->id;
  const bool ceiling = m.outputs.monitoring == Monitoring::CSM || !m.after.supervision.has_MRDT;
  return ceiling ? std::nullopt : std::optional(m.after.supervision.MRDT);
}

/// What brought the limit of the command.
Steps limit_origins(const Journal& journal, const Command& command) {
  const Moment& m = *command.braking->onset;
  if (const auto target = target_of(command)) return target_steps(journal, m, *target);
  Steps steps;
  const track::Here here = kernel::here(m.after);
  if (m.outputs.V_MRSP)
    for (const Restriction& r : restrictions(journal, m, here.min_safe_front, here.max_safe_front, *m.outputs.V_MRSP))
      steps.push_back(step_of(r));
  return steps;
}

/// The place of an end differs between two moments.
void add_once(Steps& steps, Step step) {
  const auto what = [](const Step& s) { return s.text.substr(0, s.text.find(',')); };
  for (const Step& s : steps)
    if (s.t_ms == step.t_ms && what(s) == what(step)) return;
  steps.push_back(std::move(step));
}

/// A gradient that came after the target moved the braking curve (3.13.4).
void add_gradient(Steps& steps, const Journal& journal, const Moment& m) {
  const Note* gradient = journal.last(What::packet_accepted, m.t_ms, std::int32_t{packet::gradient_profile});
  if (gradient == nullptr) return;
  for (const Step& step : steps)
    if (step.t_ms && *step.t_ms >= gradient->t_ms) return;
  Step step = step_of(*gradient);
  step.text += ": gradient, for the braking curve";
  step.clause = "3.11.12";
  steps.push_back(std::move(step));
}

// --- What else moved the curve: the limit of the same cycle without it, from curves built anew.

/// The limit as a speed with other stored data, from curves of their own.
Speed limit_with(const kernel::State& s, const Moment& m, LimitOf which, kernel::Derived::Curves& curves) {
  curves.pbd_speeds = m.curves.pbd_speeds;
  kernel::build(curves, s, m.train, s.basis);
  sdm::Supervision fresh;
  const sdm::Result r = sdm::supervise(fresh, curves.sdm, kernel::motion_of(s, kernel::here(s), m.train));
  return which == LimitOf::warning ? r.V_W : which == LimitOf::SBI ? r.V_SBI : r.V_EBI;
}

/// One thing that may have moved the curve: what it is, and how the state is without it.
struct Mover {
  Step step;
  const char* without_it;
  void (*without)(kernel::State&, const Journal&);
};

void without_areas(kernel::State& s, const Journal&) { s.track.adhesion.clear(); }
void without_selection(kernel::State& s, const Journal&) { s.slippery_rail = false; }
void without_conditions(kernel::State& s, const Journal&) { s.track.conditions.clear(); }
void without_default_gradient(kernel::State& s, const Journal&) { s.track.default_gradient.reset(); }
void with_values_before(kernel::State& s, const Journal& journal) {
  if (journal.replaced_values()) s.national_values = journal.replaced_values()->values;
}

/// The values of the braking curves that differ, by their names (3.18.2.3).
std::string changed_words(const train::NationalValues& a, const train::NationalValues& b) {
  std::string text;
  const auto differ = [&text](bool different, const char* name) {
    if (different) text += (text.empty() ? "" : ", ") + std::string(name);
  };
  differ(a.Q_NVSBTSMPERM != b.Q_NVSBTSMPERM, "Q_NVSBTSMPERM");
  differ(a.Q_NVGUIPERM != b.Q_NVGUIPERM, "Q_NVGUIPERM");
  differ(a.Q_NVSBFBPERM != b.Q_NVSBFBPERM, "Q_NVSBFBPERM");
  differ(a.Q_NVINHSMICPERM != b.Q_NVINHSMICPERM, "Q_NVINHSMICPERM");
  differ(a.V_NVREL != b.V_NVREL, "V_NVREL");
  differ(a.M_NVEBCL != b.M_NVEBCL, "M_NVEBCL");
  differ(a.M_NVAVADH != b.M_NVAVADH, "M_NVAVADH");
  const bool adhesion = a.A_NVMAXREDADH1 == b.A_NVMAXREDADH1 && a.A_NVMAXREDADH2 == b.A_NVMAXREDADH2 &&
                        a.A_NVMAXREDADH3 == b.A_NVMAXREDADH3;
  differ(!adhesion, "A_NVMAXREDADH");
  differ(!(a.Kv_int_freight == b.Kv_int_freight && a.Kv_int_passenger == b.Kv_int_passenger), "Kv_int");
  differ(!(a.Kr_int == b.Kr_int), "Kr_int");
  differ(a.Kt_int != b.Kt_int, "Kt_int");
  differ(a.A_NVP12 != b.A_NVP12 || a.A_NVP23 != b.A_NVP23, "A_NVP");
  return text.empty() ? "others" : "other " + text;
}

Step mover_step(const Note* note, const std::string& what, const char* clause) {
  Step step = note != nullptr ? step_of(*note) : Step{};
  step.text += (step.text.empty() ? "" : ": ") + what;
  step.clause = clause;
  return step;
}

std::vector<Mover> movers(const Journal& journal, const Moment& m) {
  std::vector<Mover> out;
  const kernel::State& s = m.after;
  for (const track::AdhesionArea& area : s.track.adhesion) {
    out.push_back(
        {mover_step(journal.note(journal.brought().adhesion.of(area)),
                    fmt::format("slippery rail from {} to {}", place_words(s, area.from), place_words(s, area.to)),
                    "3.18.4.6.1"),
         "without it", without_areas});
    break;  // one for all of them
  }
  if (s.slippery_rail) {
    const Act* act = journal.last(Act::Kind::select, m.t_ms, static_cast<std::uint8_t>(port::Select::slippery_rail));
    out.push_back({mover_step(nullptr, act != nullptr ? act->text : "slippery rail by the driver", "3.18.4.6.1"),
                   "without it", without_selection});
    if (act != nullptr) out.back().step.t_ms = act->t_ms;
  }
  const auto& replaced = journal.replaced_values();
  if (replaced && replaced->t_ms <= m.t_ms)
    out.push_back({national_values_step(journal, m.t_ms, changed_words(replaced->values, s.national_values), "3.18.2"),
                   "with those before", with_values_before});
  if (!s.track.conditions.empty())
    out.push_back(
        {mover_step(journal.last_packet(packet::track_condition), "a special brake is to be switched off", "3.12.1"),
         "without it", without_conditions});
  if (s.track.default_gradient)
    out.push_back({mover_step(journal.last_packet(packet::default_gradient_for_tsr),
                              fmt::format("default gradient {} per mille", *s.track.default_gradient), "3.11.12"),
                   "without it", without_default_gradient});
  return out;
}

/// Those without which the limit would be higher.
Steps moved_curve(const Journal& journal, const Moment& m, LimitOf which) {
  const std::vector<Mover> all = movers(journal, m);
  if (all.empty()) return {};
  constexpr Speed kNoticeable{0.1 / 3.6};
  const auto curves = std::make_unique<kernel::Derived::Curves>();
  const auto state = std::make_unique<kernel::State>(m.after);
  const Speed with = limit_with(*state, m, which, *curves);
  Steps steps;
  for (const Mover& mover : all) {
    *state = m.after;
    mover.without(*state, journal);
    const Speed without = limit_with(*state, m, which, *curves);
    if (without <= with + kNoticeable) continue;
    steps.push_back(mover.step);
    steps.back().text +=
        fmt::format(" (the {} limit would be {} {})", limit_name(which), kmh_words(without), mover.without_it);
  }
  return steps;
}

/// Why an emergency brake takes the place of a service brake.
const char* instead_words(const Moment& m) {
  return m.after.mode == Mode::RV                ? " in place of the service brake, in RV"
         : m.after.train.service_brake_interface ? " in place of the service brake, not permitted in TSM"
                                                 : " in place of the service brake, none is fitted";
}

/// The speed against the limit, and the command, with the front end that counts.
Step limit_step(const Command& command, const Moment& m) {
  const kernel::Outputs& o = m.outputs;
  const LimitOf which = limit_of(command.cause, m);
  const bool instead = command.cause == Cause::overspeed_emergency && which == LimitOf::SBI;
  const std::optional<Speed> limit = which == LimitOf::warning ? o.V_W : which == LimitOf::SBI ? o.V_SBI : o.V_EBI;
  const auto most = exceeded(m, which);
  const bool max_safe = most && !most->from_SBD;
  const Speed V = o.v < Speed{} ? -o.v : o.v;
  const auto speeds = different_kmh_words(V, limit.value_or(V));
  std::string text = fmt::format("{}, {} at {}: {}", terms::kNames<kMonitoringRows>[terms::index(o.monitoring)],
                                 max_safe ? "max safe front end" : "front end",
                                 metres_words((max_safe ? o.max_safe_front : o.est_front).from_origin), speeds[0]);
  if (limit && V > *limit)
    text += fmt::format(" above the {} limit of {}", limit_name(which), speeds[1]);
  else  // towards a target speed of 0 any speed is too much beyond the place of the limit
    text += fmt::format("{} beyond the place of the {} limit", most ? fmt::format(", {:.2f} m", most->beyond) : "",
                        limit_name(which));
  if (most && most->id.kind == sdm::TargetKind::EOA_SvL && max_safe)
    text += " for SvL at " + place_words(m.after, most->curve_end);
  else if (most)
    text += " for " + target_words(m, most->id);
  else if (m.after.supervision.has_MRDT && o.monitoring != Monitoring::CSM)
    text += " for " + target_words(m, m.after.supervision.MRDT);
  text += fmt::format(": {}{}", words(brakes::row(command.cause).kind), instead ? instead_words(m) : "");
  return {m.t_ms, text, clause_of(command.cause, m)};
}

}  // namespace

Steps curve_steps(const Journal& journal, const Moment& m) { return moved_curve(journal, m, LimitOf::EBI); }

Steps overspeed_chain(const Journal& journal, const std::vector<Command>& commands) {
  Steps steps;
  std::optional<sdm::TargetId> told;
  // The target of the last command first; of an earlier command only another one.
  for (std::size_t i = commands.size(); i-- > 0;) {
    const auto target = target_of(commands[i]);
    if (i + 1 < commands.size() && (!target || !told || *target == *told)) continue;
    told = target;
    for (Step& step : limit_origins(journal, commands[i])) add_once(steps, std::move(step));
  }
  if (target_of(commands.back())) {
    add_gradient(steps, journal, *commands.back().braking->onset);
    const Moment& m = *commands.back().braking->onset;
    for (Step& step : moved_curve(journal, m, limit_of(commands.back().cause, m))) steps.push_back(std::move(step));
  }
  for (const Command& command : commands) {
    const Braking& braking = *command.braking;
    steps.push_back(limit_step(command, *braking.onset));
    if (braking.failed) steps.push_back(failed_step(*braking.failed));
    if (braking.beyond_EBI) steps.push_back(limit_step(command, *braking.beyond_EBI));
  }
  std::stable_sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.t_ms < b.t_ms; });
  return steps;
}

}  // namespace evc::explain
