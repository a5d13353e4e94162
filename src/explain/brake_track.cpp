#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "explain/brake.h"
#include "explain/words.h"
#include "io/diagnostic.h"
#include "kernel/basis.h"
#include "kernel/here.h"
#include "position/position.h"
#include "procedures/mode_profile.h"
#include "terms/packet_numbers.h"
#include "texts/texts.h"

// Commands because of what trackside sent: authority, speeds, linking, radio, texts.
namespace evc::explain {
namespace {

/// The end of the authority and the train against it.
Steps end_steps(const Journal& journal, const Moment& m, bool level_1) {
  Steps steps = authority_steps(journal, m);
  const track::Here here = kernel::here(m.deciding);
  const track::Authority& a = m.deciding.basis.authority;
  const Place passing = level_1 ? here.min_safe_antenna : here.min_safe_front;
  steps.push_back(
      {m.t_ms,
       fmt::format("the min safe {} is {:.2f} m beyond the {} at {}, front end at {}",
                   level_1 ? "antenna" : "front end", (passing - a.EOA_or_LOA().value_or(passing)).si,
                   a.ends_with_LOA() ? "LOA" : "EOA", kmh_words(m.outputs.v), place_words(m.deciding, here.est_front)),
       level_1 ? "3.13.10.2.7" : "3.13.10.2.6"});
  if (m.before.supervision.monitoring == Monitoring::RSM)
    steps.back().text += fmt::format(", in release speed monitoring{}",
                                     m.before.basis.authority.release.kind == ReleaseSpeedChoice::value
                                         ? fmt::format(" with {}", kmh_words(m.before.basis.authority.release.V))
                                         : "");
  return steps;
}

Steps SR_steps(const Journal& journal, const Moment& m) {
  Steps steps{SR_distance_step(journal, m)};
  const kernel::State& s = m.deciding;
  if (const Note* mode = journal.last(What::mode_changed, m.t_ms - 1)) {
    const bool first = steps[0].t_ms && mode->t_ms < *steps[0].t_ms;
    steps.insert(first ? steps.begin() : steps.end(), step_of(*mode));
  }
  if (!s.staff_responsible.end) return steps;
  steps.push_back(
      {m.t_ms,
       fmt::format("the front end is {:.2f} m beyond the end of the SR distance at {}",
                   (kernel::here(s).est_front - *s.staff_responsible.end).si, place_words(s, *s.staff_responsible.end)),
       "4.4.11"});
  return steps;
}

/// Why override ended, by the bullet of 5.8.4.1.
std::string override_end_words(const std::string& clause, const train::NationalValues& n) {
  switch (clause.empty() ? ' ' : clause.back()) {
    case 'a':
      return fmt::format("its time T_NVOVTRP, {:g} s, is over", n.T_NVOVTRP.si);
    case 'b':
      return fmt::format("its distance D_NVOVTRP, {}, is passed", metres_words(n.D_NVOVTRP));
    case 'c':
      return "the former EOA was passed";
    case 'd':
      return "a group that stops the train was passed";
    case 'e':
      return "a balise group gave an MA or a signalling speed";
    case 'f':
      return "the RBC gave an MA";
    case 'g':
      return "a group that is not in the list was passed";
    case 'h':
      return "the SR distance of before was passed";
    default:
      return "";
  }
}

/// The override that was on before in the mode that is left, and its end: without it the train had not been tripped.
Steps override_steps(const Journal& journal, const Moment& m) {
  const Note* active = journal.last(What::override_active, m.t_ms);
  const Note* entered = journal.last(What::mode_changed, m.t_ms - 1);
  if (active == nullptr || (entered != nullptr && active->t_ms < entered->t_ms)) return {};
  Steps steps;
  const Act* selected = journal.last(Act::Kind::select, m.t_ms, static_cast<std::uint8_t>(port::Select::override_));
  steps.push_back(selected != nullptr ? step_of(*selected) : step_of(*active));
  steps.back().clause = "5.8.3";
  const auto& former = m.deciding.override_.former_eoa;
  if (former) steps.back().text += fmt::format("; former EOA at {}", place_words(m.deciding, *former));
  const Note* ended = journal.last(What::override_ended, m.t_ms);
  if (ended == nullptr || ended->t_ms < active->t_ms) return steps;
  steps.push_back(step_of(*ended));
  const std::string why = override_end_words(steps.back().clause, m.deciding.national_values);
  if (!why.empty()) steps.back().text += ": " + why;
  return steps;
}

/// [43]: the former end of authority (5.8.3.1.1) is passed without override.
Steps former_end_steps(const Journal& journal, const Moment& m) {
  Steps steps;
  const Note* active = journal.last(What::override_active, m.t_ms);
  const Note* authority = active != nullptr ? journal.last(What::authority_accepted, active->t_ms) : nullptr;
  if (authority != nullptr) steps.push_back(step_of(*authority));
  for (Step& step : override_steps(journal, m)) steps.push_back(std::move(step));
  const track::Here here = kernel::here(m.deciding);
  if (const auto& former = m.deciding.override_.former_eoa)
    steps.push_back({m.t_ms,
                     fmt::format("the min safe antenna is {:.2f} m beyond the former EOA, front end at {}",
                                 (here.min_safe_antenna - *former).si, place_words(m.deciding, here.est_front)),
                     "5.8.3.1.1"});
  return steps;
}

/// The steps of a trip that override would have inhibited, behind the override that ended before.
Steps after_override(const Journal& journal, const Moment& m, Steps steps) {
  Steps all = override_steps(journal, m);
  for (Step& step : steps) all.push_back(std::move(step));
  std::stable_sort(all.begin(), all.end(), [](const Step& a, const Step& b) { return a.t_ms < b.t_ms; });
  return all;
}

Steps of_last(const Journal& journal, const Moment& m, What what, std::optional<std::int32_t> id = {}) {
  const Note* note = journal.last(what, m.t_ms, id);
  return note == nullptr ? Steps{} : Steps{step_of(*note)};
}

/// Its words (7.5.1.137), or the number of one without.
std::string fixed_text(std::uint8_t Q_TEXT) {
  return Q_TEXT == 0   ? "\"Level crossing not protected\""
         : Q_TEXT == 1 ? "\"Acknowledgement\""
                       : fmt::format("{} (fixed)", Q_TEXT);
}

}  // namespace

Step SR_distance_step(const Journal& journal, const Moment& m) {
  if (m.deciding.staff_responsible.national_from) {
    const auto& D_NVSTFF = m.deciding.national_values.D_NVSTFF;
    return national_values_step(journal, m.t_ms,
                                "SR distance D_NVSTFF" + (D_NVSTFF ? " " + metres_words(*D_NVSTFF) : ""), "4.4.11");
  }
  const Note* message = journal.last(What::message_accepted, m.t_ms, 2);
  const Note* loop = journal.last(What::packet_accepted, m.t_ms, std::int32_t{packet::sr_distance_from_loop});
  const Act* entered = journal.last(Act::Kind::SR_distance, m.t_ms);
  Step step{{}, "the SR distance", "4.4.11"};
  const auto later = [&step](std::int64_t t_ms) { return !step.t_ms || t_ms >= *step.t_ms; };
  if (message != nullptr) step = {message->t_ms, message_words(2) + " gives the SR distance", "4.4.11"};
  if (loop != nullptr && later(loop->t_ms)) step = step_of(*loop);
  if (entered != nullptr && later(entered->t_ms)) step = step_of(*entered);
  step.clause = "4.4.11";
  return step;
}

/// The packet of a group that stops a train in SH or SR.
Steps stop_if_in_steps(const Journal& journal, const Moment& m, std::int32_t packet) {
  const bool SH = packet == packet::danger_for_shunting;
  Steps steps = of_last(journal, m, What::packet_accepted, packet);
  for (Step& step : steps) {
    step.text += SH ? ": stop if in shunting" : ": stop if in SR";
    step.clause = SH ? "4.4.8.1.1 c" : "4.4.11.1.3 d";
  }
  return steps;
}

Steps trip_steps(const Journal& journal, const Moment& m, int condition) {
  switch (condition) {
    case 12:
    case 16:
      return end_steps(journal, m, condition == 12);
    case 17:
    case 66:
      return linking_steps(journal, m);
    case 36:
    case 52:
      return after_override(
          journal, m,
          list_steps(journal, m, m.before.mode == Mode::SH ? m.deciding.track.sh_list : m.deciding.track.sr_list));
    case 18:
    case 67:
      return after_override(journal, m, of_last(journal, m, What::trip_ordered));
    case 41:
      return contact_steps(journal, m);
    case 42:
      return after_override(journal, m, SR_steps(journal, m));
    case 43:
      return former_end_steps(journal, m);
    case 49:
      return after_override(journal, m, stop_if_in_steps(journal, m, packet::danger_for_shunting));
    case 54:
      return after_override(journal, m, stop_if_in_steps(journal, m, packet::stop_if_in_sr));
    default:
      return {};  // its facts are the reason
  }
}

/// The order that made the message of any RBC count.
Steps any_contact_steps(const Journal& journal, const Moment& m, std::int64_t since) {
  Steps steps;
  if (const Note* order = journal.last(What::rbc_handover_ordered, m.t_ms)) {
    steps.push_back(step_of(*order));
    steps.back().text += ": the handing over RBC is another one, so that the message of any RBC counts";
    steps.back().clause = "3.16.3.4.1.2.1";
  }
  steps.push_back({since, "the last message of any RBC", "3.16.3.4.1.2.1"});
  return steps;
}

/// From when the time without a message counts (3.16.3.4.1), the last message first.
Steps contact_reference_steps(const Journal& journal, const Moment& m, std::int64_t since) {
  if (m.deciding.radio.contact_with_any) return any_contact_steps(journal, m, since);
  Steps steps;
  const Contact* last = journal.last_of(m.deciding.radio.supervising.session.rbc);
  const auto message = [](const Contact& contact) {
    return Step{contact.t_ms, "the last message of the RBC, " + message_words(contact.NID_MESSAGE), "3.16.3.4.1"};
  };
  // T_REF is its stamp; what else begins the time comes after it.
  if (last != nullptr && last->t_ms >= since) return {message(*last)};
  if (last != nullptr) steps.push_back(message(*last));
  const auto& hole = journal.radio_hole();
  if (hole && hole->to_ms == since) {
    if (const Note* packet = journal.note(hole->packet)) {
      steps.push_back(step_of(*packet));
      steps.back().text += ": radio hole " + hole->place;
      steps.back().clause = "3.12.1";
    }
    steps.push_back(
        {since,
         fmt::format("the radio hole, entered at {}, is left: the time counts from here", time_words(hole->from_ms)),
         "3.16.3.4.1.3"});
  } else if (const Note* over = journal.last(What::rbc_handed_over, m.t_ms); over != nullptr && over->t_ms >= since) {
    steps.push_back(step_of(*over));
    steps.back().text += ": the time counts from here";
    steps.back().clause = "3.16.3.4.1.2";
  } else {
    if (const auto level = level_step(journal, m.t_ms)) steps.push_back(*level);
    steps.push_back({since, "without a session the time counts from the transition to level 2", "3.16.3.4.1.1"});
  }
  return steps;
}

Steps contact_steps(const Journal& journal, const Moment& m) {
  Steps steps;
  const train::NationalValues& n = m.after.national_values;
  if (n.T_NVCONTACT)
    steps.push_back(national_values_step(
        journal, m.t_ms,
        fmt::format("T_NVCONTACT {:g} s, reaction {}", n.T_NVCONTACT->si, reaction_words(n.M_NVCONTACT)), "3.16.3.4"));
  const radio::State& radio = m.deciding.radio;
  if (!radio.contact_reference) return steps;
  const auto since = static_cast<std::int64_t>(radio.contact_reference->si * 1000.0 + 0.5);
  for (Step& step : contact_reference_steps(journal, m, since)) steps.push_back(std::move(step));
  const Act* connection = journal.last(Act::Kind::session, m.t_ms, kNotConnected);
  if (connection != nullptr && connection->t_ms >= since) steps.push_back(step_of(*connection));
  std::stable_sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.t_ms < b.t_ms; });
  steps.push_back(
      {m.t_ms, fmt::format("no message for {}: the contact is lost", time_words(m.t_ms - since)), "3.16.3.4.1"});
  return steps;
}

Steps text_steps(Cause cause, const Journal& journal, const Moment& m) {
  Steps steps;
  const std::uint8_t Q_TEXTCONFIRM = cause == Cause::text_service ? 2 : 3;
  for (const track::Text& text : m.after.track.texts) {
    if (text.Q_TEXTCONFIRM != Q_TEXTCONFIRM || text.acknowledged || text.state != track::Text::State::shown ||
        !track::at_end(text))
      continue;
    if (const Note* note = journal.of_text(text.id)) steps.push_back(step_of(*note));
    const std::string characters(text.characters.data(), text.length);
    steps.push_back({static_cast<std::int64_t>(text.shown_since.si * 1000.0 + 0.5),
                     fmt::format("text {} is shown, to be acknowledged",
                                 text.Q_TEXT ? fixed_text(*text.Q_TEXT) : "\"" + io::printable(characters) + "\""),
                     "3.12.3"});
    steps.push_back({m.t_ms, "its end is reached without an acknowledgement", "3.12.3.4.7"});
  }
  return steps;
}

Steps unacknowledged_steps(Cause cause, const Journal& journal, const Moment& m) {
  Steps steps;
  const bool level = cause == Cause::level_NTC_unacknowledged || cause == Cause::level_0_unacknowledged;
  if (!level) {
    if (const Note* note = journal.last(What::packet_accepted, m.t_ms, packet::mode_profile)) {
      steps.push_back(step_of(*note));
      if (const auto area = kernel::area_of_mode(m.after, kernel::here(m.after)))
        steps.back().text += fmt::format(": an area of {} from {}", name(area->mode), place_words(m.after, area->from));
      else if (m.after.mode == Mode::SH)  // its area is deleted (4.10)
        steps.back().text += ": an area of SH";
      steps.back().clause = "3.12.4";
    }
    if (const Note* note = journal.last(What::mode_changed, m.t_ms)) steps.push_back(step_of(*note));
  } else {
    if (const auto step = level_step(journal, m.t_ms)) steps.push_back(*step);
  }
  steps.push_back({m.t_ms,
                   fmt::format("{} is not acknowledged within T_ACK, {:g} s", level ? "the level" : name(m.after.mode),
                               procedures::T_ACK.si),
                   clause_of(cause, m)});
  return steps;
}

}  // namespace evc::explain
