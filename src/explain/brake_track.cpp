#include <fmt/format.h>

#include "explain/brake.h"
#include "explain/words.h"
#include "io/diagnostic.h"
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
  const track::Here here = kernel::here(m.after);
  const kernel::State& s = m.after.basis.authority.EOA_or_LOA() ? m.after : m.before;
  const Distance over = level_1 ? here.min_safe_antenna - s.basis.authority.EOA_or_LOA().value_or(here.min_safe_antenna)
                                : here.min_safe_front - s.basis.authority.EOA_or_LOA().value_or(here.min_safe_front);
  steps.push_back(
      {m.t_ms,
       fmt::format("the min safe {} is {:.2f} m beyond it at {}, front end at {}", level_1 ? "antenna" : "front end",
                   over.si, kmh_words(m.outputs.v), place_words(m.after, here.est_front)),
       ""});
  if (m.before.supervision.monitoring == Monitoring::RSM)
    steps.back().text += fmt::format(", in release speed monitoring{}",
                                     m.before.basis.authority.release.kind == ReleaseSpeedChoice::value
                                         ? fmt::format(" with {}", kmh_words(m.before.basis.authority.release.V))
                                         : "");
  return steps;
}

/// What gave the SR distance last: the RBC, a loop, the driver; without these it is the national value.
Step SR_distance_step(const Journal& journal, const Moment& m) {
  if (m.before.staff_responsible.national_from) return {{}, "the SR distance is the national value D_NVSTFF", "4.4.11"};
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

Steps SR_steps(const Journal& journal, const Moment& m) {
  Steps steps{SR_distance_step(journal, m)};
  const kernel::State& s = m.before;
  if (const Note* mode = journal.last(What::mode_changed, m.t_ms - 1)) {
    const bool first = steps[0].t_ms && mode->t_ms < *steps[0].t_ms;
    steps.insert(first ? steps.begin() : steps.end(), step_of(*mode));
  }
  if (!s.staff_responsible.end) return steps;
  steps.push_back({m.t_ms,
                   fmt::format("the front end is {:.2f} m beyond the end of the SR distance at {}",
                               (kernel::here(m.after).est_front - *s.staff_responsible.end).si,
                               place_words(s, *s.staff_responsible.end)),
                   "4.4.11"});
  return steps;
}

Steps of_last(const Journal& journal, const Moment& m, What what, std::optional<std::int32_t> id = {}) {
  const Note* note = journal.last(what, m.t_ms, id);
  return note == nullptr ? Steps{} : Steps{step_of(*note)};
}

bool is_linking_error(What what) {
  return what == What::linking_error_missed || what == What::linking_error_early || what == What::linking_error_later ||
         what == What::group_inconsistent;
}

/// The link of the group that the event names, announced before the cycle.
const balise::Link* link_of(const Moment& m, const port::Event& e) {
  for (const balise::Link& link : m.before.balise.linking.links)
    if (std::int32_t{link.id.NID_BG} == e.id) return &link;
  return nullptr;
}

/// The error of this cycle that has a reaction, otherwise the first one.
const Note* linking_error(const Journal& journal, const Moment& m) {
  const Note* error = nullptr;
  for (const Note& note : journal.notes()) {
    if (note.t_ms != m.t_ms || !is_linking_error(note.event.what)) continue;
    if (error == nullptr) error = &note;
    const balise::Link* link = link_of(m, note.event);
    if (link != nullptr && link->reaction != Reaction::none) return &note;
  }
  return error;
}

const char* reaction_words(Reaction reaction) {
  return reaction == Reaction::trip ? "trip" : reaction == Reaction::service_brake ? "service brake" : "none";
}

/// The speed against the limit, and the command.
Step limit_step(Cause cause, const Moment& m) {
  const kernel::Outputs& o = m.outputs;
  const bool warning = cause == Cause::overspeed_traction;
  const bool service = cause == Cause::overspeed_service;
  const std::optional<Speed> limit = warning ? o.V_W : service ? o.V_SBI : o.V_EBI;
  const char* const limit_name = warning ? "warning" : service ? "SBI" : "EBI";
  std::string text =
      fmt::format("{}, front end at {}: {:.2f} km/h", terms::kNames<kMonitoringRows>[terms::index(o.monitoring)],
                  metres_words(o.est_front.from_origin), o.v.si * 3.6);
  if (limit) text += fmt::format(" above the {} limit of {:.2f} km/h", limit_name, limit->si * 3.6);
  if (m.after.supervision.has_MRDT && o.monitoring != Monitoring::CSM)
    text += fmt::format(" for {}", target_words(m, m.after.supervision.MRDT));
  const brakes::CauseRow& row = brakes::row(cause);
  return {m.t_ms, text + fmt::format(": {}", words(row.kind)), texts::text_of(row.clause)};
}

}  // namespace

Steps trip_steps(const Journal& journal, const Moment& m, int condition) {
  switch (condition) {
    case 12:
    case 16:
      return end_steps(journal, m, condition == 12);
    case 17:
      return linking_steps(journal, m);
    case 18:
    case 67:
      return of_last(journal, m, What::trip_ordered);
    case 41:
      return contact_steps(journal, m);
    case 42:
      return SR_steps(journal, m);
    default:
      return {};  // its facts are the reason
  }
}

Steps overspeed_chain(const Journal& journal, const std::vector<Command>& commands) {
  const Moment& m = *commands.back().braking->onset;
  Steps steps;
  if (m.outputs.monitoring == Monitoring::CSM || !m.after.supervision.has_MRDT) {
    const track::Here here = kernel::here(m.after);
    if (m.outputs.V_MRSP)
      for (const Restriction& r : restrictions(journal, m, here.min_safe_front, here.max_safe_front, *m.outputs.V_MRSP))
        steps.push_back(step_of(r));
  } else {
    steps = target_steps(journal, m, m.after.supervision.MRDT);
  }
  for (const Command& command : commands) steps.push_back(limit_step(command.cause, *command.braking->onset));
  return steps;
}

Steps linking_steps(const Journal& journal, const Moment& m) {
  Steps steps;
  const Note* error = linking_error(journal, m);
  // What a group brings in this cycle announces later ones.
  if (const Note* announced = journal.last(What::packet_accepted, m.t_ms - 1, packet::linking)) {
    steps.push_back(step_of(*announced));
    steps.back().clause = "3.4.4";
    if (const balise::Link* link = error == nullptr ? nullptr : link_of(m, error->event))
      steps.back().text +=
          fmt::format(": group {} announced at {} +- {}, reaction {}", link->id.NID_BG,
                      metres_words((position::counter_of(m.before.position, link->place) - OdometerPlace{})),
                      metres_words(link->Q_LOCACC), reaction_words(link->reaction));
  }
  if (error == nullptr) return steps;
  steps.push_back(step_of(*error));
  if (error->event.what != What::linking_error_missed) return steps;
  const PlaceInterval antenna = position::antenna(m.after.position, kernel::L_antenna(m.after));
  steps.back().text += fmt::format(" (antenna between {} and {})",
                                   metres_words(position::counter_of(m.after.position, antenna.min) - OdometerPlace{}),
                                   metres_words(position::counter_of(m.after.position, antenna.max) - OdometerPlace{}));
  return steps;
}

Steps contact_steps(const Journal& journal, const Moment& m) {
  Steps steps;
  const train::NationalValues& n = m.after.national_values;
  if (n.T_NVCONTACT) {
    steps.push_back(national_values_step(journal, m.t_ms));
    steps.back().text +=
        fmt::format(": T_NVCONTACT {:g} s, reaction {}", n.T_NVCONTACT->si, reaction_words(n.M_NVCONTACT));
    steps.back().clause = "3.16.3.4";
  }
  const radio::State& radio = m.before.radio;
  if (!radio.contact_reference) return steps;
  const auto since = static_cast<std::int64_t>(radio.contact_reference->si * 1000.0 + 0.5);
  // T_REF is its stamp; what else begins the time comes after it.
  const Contact* last = journal.last_of(radio.supervising.session.rbc);
  const bool of_message = last != nullptr && last->t_ms >= since;
  Step step{of_message ? last->t_ms : since,
            "a radio hole, the entry into level 2 or 3, or a handover: the time begins", "3.16.3.4.1.1"};
  if (of_message) step = {last->t_ms, "the last message of the RBC, " + message_words(last->NID_MESSAGE), ""};
  steps.insert(!steps.empty() && steps[0].t_ms > step.t_ms ? steps.begin() : steps.end(), step);
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
                     text.Q_TEXT ? fmt::format("fixed text {} is shown, to be acknowledged", *text.Q_TEXT)
                                 : fmt::format("text \"{}\" is shown, to be acknowledged", io::printable(characters)),
                     "3.12.3"});
    steps.push_back({m.t_ms, "its end is reached without an acknowledgement", "3.12.3.4.7"});
  }
  return steps;
}

Steps unacknowledged_steps(Cause cause, const Journal& journal, const Moment& m) {
  Steps steps;
  const bool level = cause == Cause::level_NTC_unacknowledged || cause == Cause::level_0_unacknowledged;
  if (!level) {
    if (const Note* note = journal.last(What::packet_accepted, m.t_ms, packet::mode_profile))
      steps.push_back(step_of(*note));
    if (const Note* note = journal.last(What::mode_changed, m.t_ms)) steps.push_back(step_of(*note));
  } else {
    if (const auto step = level_step(journal, m.t_ms)) steps.push_back(*step);
  }
  steps.push_back(
      {m.t_ms, fmt::format("{} is not acknowledged in time", level ? "the level" : name(m.after.mode)), ""});
  return steps;
}

}  // namespace evc::explain
