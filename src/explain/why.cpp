#include "explain/why.h"

#include <cstdlib>

#include "procedures/conditions_of.h"

namespace evc::explain {
namespace {

/// A formula with its value and the literals that decide it: with `and` those that are false, or all if none is; with
/// `or` those that are true, or all. Its negation has the same ones.
struct Formula {
  bool holds = false;
  Literals because;
};

Formula literal(Fact fact, bool holds, Ack ack = {}) {
  Formula out{holds, {}};
  (void)out.because.push_back({fact, holds, ack, 0});  // one fits
  return out;
}

std::uint8_t choices(const Literals& list) {
  std::uint8_t n = 0;
  for (const Literal& l : list)
    if (l.choice >= n) n = static_cast<std::uint8_t>(l.choice + 1);
  return n;
}

/// Both decide: `any` of them alone, or only together.
Formula together(const Formula& a, const Formula& b, bool any) {
  Formula out = a;
  const std::uint8_t offset = any ? std::uint8_t{0} : choices(a.because);
  for (Literal l : b.because) {
    l.choice = static_cast<std::uint8_t>(l.choice + offset);
    (void)out.because.push_back(l);  // the longest formula has eight: [32]
  }
  if (any)
    for (Literal& l : out.because) l.choice = 0;
  return out;
}

Formula operator!(Formula f) {
  f.holds = !f.holds;
  return f;
}
Formula operator&&(const Formula& a, const Formula& b) {
  if (a.holds != b.holds) return a.holds ? b : a;
  return together(a, b, a.holds);
}
Formula operator||(const Formula& a, const Formula& b) { return !(!a && !b); }

struct LevelNow {
  Level level;
};
/// No formula compares with level 2 or 3 alone: of it there is no fact.
Formula operator==(LevelNow now, Level level) {
  switch (level) {
    case Level::L0:
      return literal(Fact::level_0, now.level == level);
    case Level::NTC:
      return literal(Fact::level_NTC, now.level == level);
    case Level::L1:
      return literal(Fact::level_1, now.level == level);
    case Level::L2:
    case Level::L3:
      break;
  }
  std::abort();
}
Formula level_2_or_3(LevelNow now) { return literal(Fact::level_2_or_3, evc::level_2_or_3(now.level)); }
Formula level_1_2_3(LevelNow now) { return literal(Fact::level_1_2_3, evc::level_1_2_3(now.level)); }

struct LevelSwitch {
  std::optional<Level> to;
};
Formula operator==(LevelSwitch change, Level level) {
  switch (level) {
    case Level::L0:
      return literal(Fact::level_becomes_0, change.to == level);
    case Level::NTC:
      return literal(Fact::level_becomes_NTC, change.to == level);
    case Level::L1:
      return literal(Fact::level_becomes_1, change.to == level);
    case Level::L2:
    case Level::L3:
      break;
  }
  std::abort();
}
Formula level_2_or_3(LevelSwitch change) { return literal(Fact::level_becomes_2_or_3, evc::level_2_or_3(change.to)); }

struct Acks {
  Fact fact;
  Set<Ack> set;
  Formula has(Ack ack) const { return literal(fact, set.has(ack), ack); }
};

/// The facts under their names, each a formula.
struct Named {
  explicit Named(const procedures::Facts& facts) : f(facts) {}
  const procedures::Facts& f;
  // clang-format off
  LevelNow level{f.level};
  LevelSwitch level_switched_to{f.level_switched_to};
  Acks acknowledged{Fact::acknowledged, f.acknowledged}, requested{Fact::requested, f.requested};
  Formula level_order_changed_national_system_only =
      literal(Fact::national_system_only, f.level_order_changed_national_system_only);
#define EVC_FACT(name) Formula name = literal(Fact::name, f.name)
  EVC_FACT(isolated); EVC_FACT(powered); EVC_FACT(desk_open); EVC_FACT(standstill); EVC_FACT(sleeping);
  EVC_FACT(non_leading); EVC_FACT(passive_shunting); EVC_FACT(safety_fault); EVC_FACT(selects_SH);
  EVC_FACT(selects_exit_SH); EVC_FACT(selects_NL); EVC_FACT(selects_override); EVC_FACT(train_data_valid);
  EVC_FACT(ma_ssp_gradient_stored); EVC_FACT(ma_accepted); EVC_FACT(ma_with_trip_order);
  EVC_FACT(profile_demands_OS); EVC_FACT(profile_demands_LS); EVC_FACT(profile_demands_SH);
  EVC_FACT(profile_in_force); EVC_FACT(front_in_OS_ack_area); EVC_FACT(front_in_LS_ack_area);
  EVC_FACT(mode_is_OS); EVC_FACT(mode_is_LS); EVC_FACT(min_safe_antenna_beyond_eoa);
  EVC_FACT(min_safe_front_beyond_eoa); EVC_FACT(group_at_eoa_in_RSM);
  EVC_FACT(front_in_rear_of_track_description); EVC_FACT(linking_reaction_trip);
  EVC_FACT(linked_group_wrong_direction); EVC_FACT(telegram_version_too_high); EVC_FACT(trip_order);
  EVC_FACT(stop_if_in_SH); EVC_FACT(stop_if_in_SR); EVC_FACT(group_passed_not_in_SH_list);
  EVC_FACT(group_passed_not_in_SR_list); EVC_FACT(group_passed_in_SR_list); EVC_FACT(ues_accepted);
  EVC_FACT(ues_received); EVC_FACT(T_NVCONTACT_trip); EVC_FACT(SH_granted); EVC_FACT(override_active);
  EVC_FACT(former_eoa_passed); EVC_FACT(SR_distance_passed); EVC_FACT(continue_shunting);
  EVC_FACT(stop_shunting_stored); EVC_FACT(national_trip); EVC_FACT(level_crossing_approach_shown);
  EVC_FACT(brake_commanded); EVC_FACT(AD_requested); EVC_FACT(described_for_whole_train);
  EVC_FACT(selects_ATO_engage); EVC_FACT(ATO_disengaged); EVC_FACT(SM_authorised); EVC_FACT(selects_exit_SM);
  EVC_FACT(consist_in_front); EVC_FACT(odometer_beyond_threshold);
#undef EVC_FACT
  // clang-format on
};

}  // namespace

Reasons reasons(const procedures::Facts& facts, SrsVersion srs) {
  Reasons out;
  const auto give = [&out](int n, const Formula& f) {
    (void)out.push_back({static_cast<std::uint8_t>(n), f.holds, f.because});  // one for each
  };
  procedures::conditions_of(Named(facts), give);
  if (srs == SrsVersion::v4_0_0) procedures::conditions_of_4_0_0(Named(facts), give);
  return out;
}

}  // namespace evc::explain
