#include "explain/origins.h"

#include <fmt/format.h>

#include <algorithm>

#include "explain/words.h"
#include "kernel/here.h"
#include "modes/conditions.h"
#include "terms/packet_numbers.h"
#include "texts/texts.h"

namespace evc::explain {
namespace {

std::optional<Step> step_of_last(const Act* act) {
  return act == nullptr ? std::nullopt : std::optional(step_of(*act));
}

/// The later one.
const Note* later(const Note* a, const Note* b) {
  if (a == nullptr || b == nullptr) return a == nullptr ? b : a;
  return a->t_ms >= b->t_ms ? a : b;
}

/// The packet whose arrival makes a fact true; 0 where none does.
std::int32_t packet_of(Fact fact) {
  switch (fact) {
    case Fact::profile_demands_OS:
    case Fact::profile_demands_LS:
    case Fact::profile_demands_SH:
    case Fact::profile_in_force:
    case Fact::front_in_OS_ack_area:
    case Fact::front_in_LS_ack_area:
      return packet::mode_profile;
    case Fact::stop_if_in_SH:
      return packet::danger_for_shunting;
    case Fact::stop_if_in_SR:
      return packet::stop_if_in_sr;
    case Fact::group_passed_not_in_SH_list:
      return packet::balise_groups_for_sh_area;
    case Fact::group_passed_not_in_SR_list:
    case Fact::group_passed_in_SR_list:
      return packet::balise_groups_in_sr_authority;
    case Fact::stop_shunting_stored:
      return packet::stop_shunting_on_desk_opening;
    default:
      return 0;
  }
}

/// The event that makes a fact true.
std::optional<What> event_of(Fact fact) {
  switch (fact) {
    case Fact::train_data_valid:
      return What::train_data_valid;
    case Fact::ma_ssp_gradient_stored:
    case Fact::ma_accepted:
    case Fact::ma_with_trip_order:
      return What::authority_accepted;
    case Fact::trip_order:
      return What::trip_ordered;
    case Fact::linked_group_wrong_direction:
      return What::group_wrong_direction;
    case Fact::telegram_version_too_high:
      return What::telegram_version_new;
    case Fact::ues_accepted:
    case Fact::ues_received:
      return What::emergency_stop_unconditional;
    case Fact::override_active:
      return What::override_active;
    default:
      return std::nullopt;
  }
}

/// The act of the train interface behind a fact.
std::optional<Act::Kind> act_of(Fact fact) {
  switch (fact) {
    case Fact::isolated:
      return Act::Kind::isolation;
    case Fact::powered:
      return Act::Kind::power;
    case Fact::desk_open:
      return Act::Kind::desk;
    case Fact::sleeping:
      return Act::Kind::sleeping;
    case Fact::non_leading:
      return Act::Kind::non_leading;
    case Fact::passive_shunting:
      return Act::Kind::passive_shunting;
    case Fact::safety_fault:
      return Act::Kind::fault;
    case Fact::national_trip:
      return Act::Kind::national_system;
    default:
      return std::nullopt;
  }
}

/// The selection that makes a fact true.
std::optional<port::Select> selection_of(Fact fact) {
  switch (fact) {
    case Fact::selects_SH:
      return port::Select::shunting;
    case Fact::selects_exit_SH:
      return port::Select::exit_shunting;
    case Fact::selects_NL:
      return port::Select::non_leading;
    case Fact::selects_override:
      return port::Select::override_;
    case Fact::continue_shunting:
      return port::Select::maintain_shunting;
    case Fact::selects_ATO_engage:
      return port::Select::ato_engage;
    case Fact::ATO_disengaged:
      return port::Select::ato_disengage;
    default:
      return std::nullopt;
  }
}

/// The act behind a fact.
const Act* act_behind(const Literal& literal, const Journal& journal, std::int64_t t_ms) {
  if (literal.fact == Fact::acknowledged)
    return journal.last(Act::Kind::acknowledge, t_ms, static_cast<std::uint8_t>(literal.ack));
  if (const auto select = selection_of(literal.fact))
    return journal.last(Act::Kind::select, t_ms, static_cast<std::uint8_t>(*select));
  const auto kind = act_of(literal.fact);
  if (literal.fact == Fact::national_trip) return journal.last(Act::Kind::national_system, t_ms, kNationalTrip);
  return kind ? journal.last(*kind, t_ms) : nullptr;
}

std::string by_source(const Note& note) { return note.source.empty() ? "" : " by " + note.source; }

bool is_level(Fact fact) { return fact >= Fact::level_0 && fact <= Fact::national_system_only; }

/// The timer of the authority, by the clause of its event.
const char* timer_words(const std::string& clause) {
  return clause == "3.8.4.1.2"   ? "timer of the end section elapsed"
         : clause == "3.8.4.2.2" ? "section timer elapsed"
         : clause == "3.8.4.3.2" ? "timer of the LOA speed elapsed"
         : clause == "3.8.4.4.2" ? "overlap timer elapsed"
                                 : "standstill ends the overlap";
}

}  // namespace

Step step_of(const Note& note) {
  std::string text(texts::line_of(note.event).view());
  std::string clause;
  if (const std::size_t bracket = text.find(" ["); bracket != std::string::npos && text.back() == ']') {
    clause = text.substr(bracket + 2, text.size() - bracket - 3);
    text.resize(bracket);
  }
  if (note.event.what == What::trip_ordered) text += " (packet 12, V_MAIN 0: signal at danger)";
  if (note.event.what == What::authority_timer_elapsed) text = timer_words(clause);
  if (note.event.what == What::mode_changed) {
    text += fmt::format(": {}", modes::meaning(note.event.id));
    clause = fmt::format("4.6.3({})", note.event.id);
  }
  if (note.event.what == What::emergency_stop_revoked) text += " (the end stays as it is until a new MA)";
  if (!note.source.empty() && note.event.what != What::group_accepted && note.event.what != What::message_accepted)
    text = note.source + ": " + text;
  if (!note.detail.empty()) text += ": " + note.detail;
  return {note.t_ms, text, clause};
}

std::optional<Step> step_of_last(const Note* note) {
  return note == nullptr ? std::nullopt : std::optional(step_of(*note));
}

std::optional<Step> level_step(const Journal& journal, std::int64_t t_ms) {
  const Note* change =
      later(journal.last(What::level_changed, t_ms), journal.last(What::level_changed_by_driver, t_ms));
  if (change == nullptr) return std::nullopt;
  Step step = step_of(*change);
  const Note* order = later(
      journal.last(What::packet_accepted, change->t_ms, std::int32_t{packet::level_transition_order}),
      journal.last(What::packet_accepted, change->t_ms, std::int32_t{packet::conditional_level_transition_order}));
  if (change->event.what == What::level_changed && order != nullptr)
    step.text +=
        fmt::format(", ordered{} at {} (packet {})", by_source(*order), time_words(order->t_ms), order->event.id);
  return step;
}

Step national_values_step(const Journal& journal, std::int64_t t_ms, const std::string& values, const char* clause) {
  const Note* note =
      later(journal.last(What::national_values_in_force, t_ms), journal.last(What::national_values_default, t_ms));
  if (note == nullptr)
    return {{},
            (journal.starts_with_defaults() ? "default national values (A.3.2): " : "national values as configured: ") +
                values,
            clause};
  if (note->event.what == What::national_values_default)
    return {note->t_ms, "default national values (A.3.2): " + values, clause};
  const Note* packet = journal.last_packet(packet::national_values);
  const bool given = packet != nullptr && packet->t_ms <= note->t_ms && !packet->source.empty();
  return {note->t_ms, (given ? packet->source + ": " : "") + "national values in force: " + values, clause};
}

Step step_of(const Act& act) { return {act.t_ms, act.text, ""}; }

std::optional<Step> origin_of(const Literal& literal, const Journal& journal, std::int64_t t_ms) {
  const Fact fact = literal.fact;
  if (is_level(fact)) return level_step(journal, t_ms);
  if (!literal.holds && fact != Fact::desk_open && fact != Fact::powered) return std::nullopt;
  if (fact == Fact::linking_reaction_trip) {
    const Note* note = journal.last(What::linking_error_early, t_ms);
    for (const What what : {What::linking_error_missed, What::linking_error_later})
      note = later(note, journal.last(what, t_ms));
    return step_of_last(note);
  }
  if (const std::int32_t packet = packet_of(fact))
    return step_of_last(journal.last(What::packet_accepted, t_ms, packet));
  if (const auto what = event_of(fact)) return step_of_last(journal.last(*what, t_ms));
  return step_of_last(act_behind(literal, journal, t_ms));
}

}  // namespace evc::explain
