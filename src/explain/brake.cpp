#include "explain/brake.h"

#include <fmt/format.h>

#include <algorithm>

#include "explain/words.h"
#include "terms/packet_numbers.h"
#include "texts/texts.h"

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
  for (const Literal& literal : reason.because) {
    auto origin = origin_of(literal, journal, t_ms);
    const auto same = [&](const Step& s) { return s.t_ms == origin->t_ms && s.text == origin->text; };
    if (origin && std::none_of(steps.begin(), steps.end(), same)) steps.push_back(*std::move(origin));
  }
  std::stable_sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.t_ms < b.t_ms; });
  return steps;
}

Step last_act(const Journal& journal, Act::Kind kind, const Moment& m, const char* otherwise) {
  const Act* act = journal.last(kind, m.t_ms);
  return act != nullptr ? step_of(*act) : Step{m.t_ms, otherwise, ""};
}

Steps group_steps(const Journal& journal, const Moment& m, What what) {
  Steps steps;
  for (const Note& note : journal.notes())
    if (note.t_ms == m.t_ms && note.event.what == what) steps.push_back(step_of(note));
  if (const Note* note = journal.last(what, m.t_ms); steps.empty() && note != nullptr) steps.push_back(step_of(*note));
  return steps;
}

/// Both groups that were missed since linking announced them.
Steps two_groups_steps(const Journal& journal, const Moment& m) {
  Steps steps;
  const Note* announced = journal.last(What::packet_accepted, m.t_ms, std::int32_t{packet::linking});
  for (const Note& note : journal.notes()) {
    if (announced == nullptr || note.t_ms < announced->t_ms || note.t_ms > m.t_ms) continue;
    const What what = note.event.what;
    if (&note == announced || what == What::linking_error_missed || what == What::double_linking_error ||
        what == What::double_repositioning)
      steps.push_back(step_of(note));
  }
  return steps;
}

/// What happened before the command of the cause.
Steps first_steps(Cause cause, const Journal& journal, const Moment& m) {
  switch (cause) {
    case Cause::trip:
    case Cause::no_power_or_failure:
      return entry_steps(journal, m);  // the command begins with the mode
    case Cause::linking:
      return linking_steps(journal, m);
    case Cause::balise_group_consistency:
      return group_steps(journal, m, What::group_inconsistent);
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
      return {last_act(journal, Act::Kind::national_system, m, "the national system orders the brake")};
    case Cause::balise_antenna:
      return {last_act(journal, Act::Kind::antenna, m, "alarm of the balise antenna")};
    default:
      return movement_steps(cause, journal, m);
  }
}

}  // namespace

Steps entry_steps(const Journal& journal, const Moment& entry) {
  const int condition = condition_of(entry);
  Steps steps;
  if (entry.after.mode == Mode::TR) steps = trip_steps(journal, entry, condition);
  for (const Reason& reason : reasons(entry.facts)) {
    if (reason.number != condition) continue;
    if (steps.empty()) steps = origins_of(reason, journal, entry.t_ms);
    steps.push_back(
        {entry.t_ms,
         fmt::format("mode {}->{}: {}", name(entry.before.mode), name(entry.after.mode), modes::meaning(condition)),
         fmt::format("4.6.3({})", condition)});
  }
  return steps;
}

Steps chain_of(Cause cause, const Journal& journal, const Moment& m) {
  const brakes::CauseRow& row = brakes::row(cause);
  Steps steps = first_steps(cause, journal, m);
  // 3.14.1.2: without an interface to the service brake the emergency brake takes its place.
  const bool instead = row.kind == brakes::Kind::service_brake && !m.outputs.sb && m.outputs.eb;
  steps.push_back({m.t_ms,
                   fmt::format("{} at {}, front end at {}",
                               instead ? "emergency brake, no service brake is fitted," : words(row.kind),
                               kmh_words(m.outputs.v), metres_words(m.outputs.est_front.from_origin)),
                   texts::text_of(row.clause)});
  return steps;
}

}  // namespace evc::explain
