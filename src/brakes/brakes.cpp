#include "brakes/brakes.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace evc::brakes {
namespace {

static_assert(
    [] {
      for (std::size_t i = 0; i < kCauses; ++i)
        if (static_cast<std::size_t>(srs_3_14_1[i].cause) != i) return false;
      return true;
    }(),
    "one row for each cause, in order");

/// A mark of 4.12: R revoked, M maintained, P maintained unless the train comes from PT.
struct EntryRow {
  Cause cause;
  std::array<char, kModes> marks{};
  constexpr EntryRow(Cause c, std::string_view row) : cause(c) {
    std::size_t n = 0;
    for (const char mark : row)
      if (mark != ' ') marks[n++] = mark;
    if (n != kModes) __builtin_trap();  // not constexpr: the row does not compile
  }
};

// clang-format off
constexpr auto kOnEntry = std::to_array<EntryRow>({
    //                                          NP SB PS SH FS LS SR OS SL NL UN TR PT SF IS SN RV SM AD
    {Cause::roll_away,                          "R R R M M M M M R R M R M M R R M M M"},
    {Cause::reverse_movement,                   "R R R R P P P P R R R R R M R R R M M"},
    {Cause::standstill,                         "R R R R R R R R R R R R R M R R R R R"},
    {Cause::linking,                            "R R R M M M M M R M M M M M R M M M M"},
    {Cause::balise_group_consistency,           "R R R M M M M M R M M M M M R M M M M"},
    {Cause::two_groups_missed,                  "R R R M M M M M R M M M M M R M M M M"},
    {Cause::T_NVCONTACT,                        "R R R R M M R M R R R R R M R R R R M"},
    {Cause::reversing_distance,                 "R R R R R R R R R R R R R M R R M R R"},
    {Cause::train_data_changed,                 "R R R R M M M M R R M M M M R M M R M"},
    {Cause::movement_while_entering_train_data, "R R R R M M M M R R M M M M R M M R M"},
    {Cause::movement_while_entering_SR_data,    "R R R R R R M R R R R R R M R R R R R"},
    {Cause::post_trip_distance,                 "R R R R R R R R R R R R M M R R R R R"},
    {Cause::consist_length,                     "R R R R R R R R R R R M M R R R R R R"},
});
// clang-format on

constexpr char mark_of(const EntryRow& row, Mode to) { return row.marks[terms::index(to)]; }

bool wants_acknowledgement(Release rule) {
  return rule == Release::acknowledged_at_standstill || rule == Release::gone_or_acknowledged_at_standstill;
}

/// Whether the release rule of a command that was given is fulfilled.
bool released(Release rule, bool asked, bool acknowledged, const Context& c) {
  switch (rule) {
    case Release::at_standstill:
      return c.standstill;
    case Release::at_standstill_or_message:
      return c.standstill || c.new_consistent_message;
    case Release::acknowledged_at_standstill:
      return acknowledged;
    case Release::gone_or_acknowledged_at_standstill:
      return !asked || acknowledged;
    default:  // when_gone
      return !asked;
  }
}

/// Whether the cause gives a new command: when it appears, and on movement where the rule requires it.
bool gives(const CauseRow& r, bool asked, bool asked_before, const Context& c) {
  if (!asked) return false;
  if (r.release == Release::when_gone) return true;
  return !asked_before || (r.again_on_movement && !c.standstill);
}

/// Learns the pressure of the released brake.
void follow_pressure(State& state, const Context& c) {
  if (c.feedback && c.feedback->pressure_kpa)
    state.highest_kpa = std::clamp(*c.feedback->pressure_kpa, state.highest_kpa, kReleasedKpa);
}

/// Whether a pressure shows that the brake is applied: it fell since the command; or the brake was applied already, so
/// far that the command lets it fall by less than that.
bool shows_application(double p_kpa, const ServiceBrakeWatch& watch, double highest_kpa) {
  if (watch.pressure_kpa && p_kpa <= *watch.pressure_kpa - kApplicationKpa) return true;
  const double released = highest_kpa < kLowestReleasedKpa ? kReleasedKpa : highest_kpa;
  return p_kpa <= released - (kFullApplicationKpa - kApplicationKpa);
}

/// Whether the service brake was not applied within its build-up time, or is not any more.
bool fails(ServiceBrakeWatch& watch, double highest_kpa, bool commanded, const Context& c) {
  if (!commanded || !c.feedback) {
    watch = {};
    return false;
  }
  const ServiceBrakeFeedback& told = *c.feedback;
  if (!watch.since) {
    watch.since = c.now;
    watch.pressure_kpa = told.pressure_kpa;
  }
  const bool falls = told.pressure_kpa && shows_application(*told.pressure_kpa, watch, highest_kpa);
  if (!told.applied && !falls && c.now - *watch.since > c.T_bs) watch.failed = true;
  return watch.failed;
}

}  // namespace

bool brakes_now(const State& state) {
  constexpr CauseSet cut_off = [] {
    CauseSet causes;
    for (const CauseRow& r : srs_3_14_1) causes.add(r.cause, r.kind == Kind::traction_cut_off);
    return causes;
  }();
  CauseSet braking = state.active;
  braking.remove(cut_off);
  return !braking.empty();
}

CauseSet acknowledged_causes(const State& state, SrsVersion srs) {
  CauseSet causes;
  Clause first;
  for (const CauseRow& r : srs_3_14_1) {
    if (!state.active.has(r.cause) || !wants_acknowledgement(r.release)) continue;
    const Clause clause = clause_of(r.cause, srs);
    if (!first) first = clause;
    causes.add(r.cause, clause == first);
  }
  return causes;
}

Command command(State& state, CauseSet asked, const Context& c) {
  Command out;
  if (asked.empty() && state.active.empty()) {  // the usual cycle
    state.asked_before = {};
    state.service_brake = {};
    follow_pressure(state, c);
    return out;
  }
  CauseSet acknowledged;
  if (c.standstill && c.driver_acknowledges) acknowledged = acknowledged_causes(state, c.srs);
  for (const CauseRow& r : srs_3_14_1) {
    const bool asks = asked.has(r.cause);
    bool active = state.active.has(r.cause);
    if (active && released(r.release, asks, acknowledged.has(r.cause), c)) active = false;
    if (gives(r, asks, state.asked_before.has(r.cause), c)) active = true;
    if (!active) {
      state.active.remove(r.cause);
      continue;
    }
    state.active.add(r.cause);
    out.reasons.add(r.cause);
    out.tco = out.tco || (r.kind == Kind::traction_cut_off && c.traction_cut_off_fitted);
    out.sb = out.sb || r.kind == Kind::service_brake;
    out.eb = out.eb || r.kind == Kind::emergency_brake;
    out.acknowledgement_wanted = out.acknowledgement_wanted || (wants_acknowledgement(r.release) && c.standstill);
  }
  state.asked_before = asked;
  // 3.14.1.2: the emergency brake when the service brake does not act or is not fitted; it is released with its causes.
  const bool failed_before = state.service_brake.failed;
  const bool failed = fails(state.service_brake, state.highest_kpa, out.sb && c.service_brake_fitted, c);
  out.service_brake_fails = failed && !failed_before;
  if (out.sb && (failed || !c.service_brake_fitted)) out.eb = true;
  if (!c.service_brake_fitted) out.sb = false;
  return out;
}

bool revoked_on_mode_entry(Cause cause, Mode to, Mode from) {
  for (const EntryRow& r : kOnEntry)
    if (r.cause == cause) return mark_of(r, to) == 'R' || (mark_of(r, to) == 'P' && from == Mode::PT);
  return false;
}

void on_turn(State& state) {
  constexpr CauseSet kOfOrientation{Cause::roll_away, Cause::reverse_movement, Cause::linking,
                                    Cause::balise_group_consistency, Cause::two_groups_missed};
  state.active.remove(kOfOrientation);
}

void on_mode_entry(State& state, Mode to, Mode from) {
  for (const CauseRow& r : srs_3_14_1)
    if (revoked_on_mode_entry(r.cause, to, from)) state.active.remove(r.cause);
}

}  // namespace evc::brakes
