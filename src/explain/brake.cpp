#include "explain/brake.h"

#include <fmt/format.h>

#include <algorithm>

#include "explain/words.h"
#include "protection/antenna.h"
#include "terms/packet_numbers.h"

namespace evc::explain {
namespace {

/// The condition with which a mode was entered; 0: at power-up.
int condition_of(const Moment& entry) {
  for (const port::Event& e : entry.outputs.events)
    if (e.what == What::mode_changed) return e.id;
  return 0;
}

/// What made the facts of a condition, in the order of time, each once.
Steps origins_of(const Reason& reason, const Journal& journal, std::int64_t t_ms) {
  Steps steps;
  // The level alone has led to nothing, where it did not change now.
  const auto is_level = [](const Literal& l) { return l.fact >= Fact::level_0 && l.fact <= Fact::level_1_2_3; };
  for (const Literal& literal : reason.because) {
    if (is_level(literal)) continue;
    auto origin = origin_of(literal, journal, t_ms);
    const auto same = [&](const Step& s) { return s.t_ms == origin->t_ms && s.text == origin->text; };
    if (origin && std::none_of(steps.begin(), steps.end(), same)) steps.push_back(*std::move(origin));
  }
  std::stable_sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.t_ms < b.t_ms; });
  return steps;
}

/// The order of the national system, whose level is NTC or is announced.
Steps national_steps(const Journal& journal, const Moment& m, std::uint8_t order) {
  const Act* act = journal.last(Act::Kind::national_system, m.t_ms, order);
  Step step = act != nullptr ? step_of(*act) : Step{m.t_ms, "the national system orders the brake", ""};
  if (m.after.level.level == Level::NTC) step.text += fmt::format(" (level NTC, system {})", m.after.level.nid_ntc);
  return {step};
}

/// 3.15.7.2: in levels 0 and NTC the alarm is ignored for a distance.
Steps antenna_steps(const Journal& journal, const Moment& m) {
  const Act* act = journal.last(Act::Kind::antenna, m.t_ms);
  Steps steps{act != nullptr ? step_of(*act) : Step{m.t_ms, "alarm of the balise antenna", ""}};
  if (!level_1_2_3(m.after.level.level))
    steps.push_back({m.t_ms,
                     fmt::format("it has lasted for {}, for which it is ignored in level {}",
                                 metres_words(protection::D_METAL), name(m.after.level.level)),
                     "3.15.7.2"});
  return steps;
}

/// What happened before the command of the cause.
Steps first_steps(Cause cause, const Journal& journal, const Moment& m) {
  switch (cause) {
    case Cause::trip:
    case Cause::no_power_or_failure:
      return entry_steps(journal, m);  // the command begins with the mode
    case Cause::linking:
    case Cause::balise_group_consistency:
      return linking_steps(journal, m);
    case Cause::two_groups_missed:
      return two_groups_steps(journal, m);
    case Cause::T_NVCONTACT:
      return contact_steps(journal, m);
    case Cause::train_data_changed:
      return train_data_steps(journal, m);
    case Cause::text_service:
    case Cause::text_emergency:
      return text_steps(cause, journal, m);
    case Cause::OS_unacknowledged:
    case Cause::LS_unacknowledged:
    case Cause::SH_unacknowledged:
    case Cause::level_NTC_unacknowledged:
    case Cause::level_0_unacknowledged:
      return unacknowledged_steps(cause, journal, m);
    case Cause::national_system_service:
    case Cause::national_system_emergency:
      return national_steps(journal, m,
                            cause == Cause::national_system_service ? kNationalService : kNationalEmergency);
    case Cause::balise_antenna:
      return antenna_steps(journal, m);
    case Cause::consist_length:
      return {Step{m.t_ms, "the safe consist length is not available any more", "4.4.21"}};
    default:
      return movement_steps(cause, journal, m);
  }
}

}  // namespace

Steps entry_steps(const Journal& journal, const Moment& entry) {
  const int condition = condition_of(entry);
  Steps steps;
  if (entry.after.mode == Mode::TR) steps = trip_steps(journal, entry, condition);
  if (condition == 13) steps = fault_steps(journal, entry);
  for (const Reason& reason : reasons(entry.facts, entry.after.srs)) {
    if (reason.number != condition) continue;
    if (steps.empty()) steps = origins_of(reason, journal, entry.t_ms);
    steps.push_back(
        {entry.t_ms,
         fmt::format("mode {}->{}: {}", name(entry.before.mode), name(entry.after.mode), modes::meaning(condition)),
         fmt::format("4.6.3({})", condition)});
  }
  return steps;
}

Steps chain_of(const Command& command, const Journal& journal) {
  const Moment& m = *command.braking->onset;
  const brakes::CauseRow& row = brakes::row(command.cause);
  Steps steps = first_steps(command.cause, journal, m);
  // 3.14.1.2: without an interface to the service brake the emergency brake takes its place.
  const bool instead = row.kind == brakes::Kind::service_brake && !m.outputs.sb && m.outputs.eb;
  steps.push_back({m.t_ms,
                   fmt::format("{} at {}, front end at {}",
                               instead ? "emergency brake, no service brake is fitted," : words(row.kind),
                               kmh_words(m.outputs.v), metres_words(m.outputs.est_front.from_origin)),
                   clause_of(command.cause, m)});
  if (command.braking->failed) steps.push_back(failed_step(*command.braking->failed));
  return steps;
}

}  // namespace evc::explain
