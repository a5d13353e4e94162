#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
  const track::Here here = kernel::here(m.deciding);
  const track::Authority& a = m.deciding.basis.authority;
  const Place passing = level_1 ? here.min_safe_antenna : here.min_safe_front;
  steps.push_back({m.t_ms,
                   fmt::format("the min safe {} is {:.2f} m beyond the {} at {}, front end at {}",
                               level_1 ? "antenna" : "front end", (passing - a.EOA_or_LOA().value_or(passing)).si,
                               a.LOA ? "LOA" : "EOA", kmh_words(m.outputs.v), place_words(m.deciding, here.est_front)),
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

Steps of_last(const Journal& journal, const Moment& m, What what, std::optional<std::int32_t> id = {}) {
  const Note* note = journal.last(what, m.t_ms, id);
  return note == nullptr ? Steps{} : Steps{step_of(*note)};
}

/// The target that limits the speed; null: the ceiling does.
const sdm::TargetId* target_of(const Moment& m) {
  const bool ceiling = m.outputs.monitoring == Monitoring::CSM || !m.after.supervision.has_MRDT;
  return ceiling ? nullptr : &m.after.supervision.MRDT;
}

/// What brought the limit of the moment.
Steps limit_origins(const Journal& journal, const Moment& m) {
  if (const sdm::TargetId* target = target_of(m)) return target_steps(journal, m, *target);
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

/// Its words (7.5.1.137), or the number of one without.
std::string fixed_text(std::uint8_t Q_TEXT) {
  return Q_TEXT == 0   ? "\"Level crossing not protected\""
         : Q_TEXT == 1 ? "\"Acknowledgement\""
                       : fmt::format("{} (fixed)", Q_TEXT);
}

/// Why an emergency brake takes the place of a service brake.
const char* instead_words(const Moment& m) {
  return m.after.mode == Mode::RV                ? " in place of the service brake, in RV"
         : m.after.train.service_brake_interface ? " in place of the service brake, not permitted in TSM"
                                                 : " in place of the service brake, none is fitted";
}

/// The speed against the limit, and the command.
Step limit_step(const Command& command, const Moment& m) {
  const kernel::Outputs& o = m.outputs;
  const bool warning = command.cause == Cause::overspeed_traction;
  const bool instead = command.cause == Cause::overspeed_emergency && !m.after.supervision.eb;
  const bool service = command.cause == Cause::overspeed_service || instead;
  const std::optional<Speed> limit = warning ? o.V_W : service ? o.V_SBI : o.V_EBI;
  const char* const limit_name = warning ? "warning" : service ? "SBI" : "EBI";
  std::string text =
      fmt::format("{}, front end at {}: {:.2f} km/h", terms::kNames<kMonitoringRows>[terms::index(o.monitoring)],
                  metres_words(o.est_front.from_origin), std::abs(o.v.si) * 3.6);
  if (limit && std::abs(o.v.si) > limit->si)
    text += fmt::format(" above the {} limit of {:.2f} km/h", limit_name, limit->si * 3.6);
  else  // towards a target speed of 0 any speed is too much beyond the place of the limit
    text += fmt::format(" beyond the place of the {} limit", limit_name);
  if (m.after.supervision.has_MRDT && o.monitoring != Monitoring::CSM)
    text += fmt::format(" for {}", target_words(m, m.after.supervision.MRDT));
  text += fmt::format(": {}{}", words(brakes::row(command.cause).kind), instead ? instead_words(m) : "");
  return {m.t_ms, text, clause_of(command.cause, m)};
}

}  // namespace

Step SR_distance_step(const Journal& journal, const Moment& m) {
  if (m.deciding.staff_responsible.national_from) {
    Step step = national_values_step(journal, m.t_ms);
    const auto& D_NVSTFF = m.deciding.national_values.D_NVSTFF;
    step.text += ": SR distance D_NVSTFF" + (D_NVSTFF ? " " + metres_words(*D_NVSTFF) : "");
    step.clause = "4.4.11";
    return step;
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
      return list_steps(journal, m, m.before.mode == Mode::SH ? m.deciding.track.sh_list : m.deciding.track.sr_list);
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
  Steps steps;
  const sdm::TargetId* told = nullptr;
  // The target of the last command first; of an earlier command only another one.
  for (std::size_t i = commands.size(); i-- > 0;) {
    const Moment& m = *commands[i].braking->onset;
    const sdm::TargetId* target = target_of(m);
    if (i + 1 < commands.size() && (target == nullptr || told == nullptr || *target == *told)) continue;
    told = target;
    for (Step& step : limit_origins(journal, m)) add_once(steps, std::move(step));
  }
  if (target_of(*commands.back().braking->onset) != nullptr)
    add_gradient(steps, journal, *commands.back().braking->onset);
  for (const Command& command : commands) {
    const Braking& braking = *command.braking;
    steps.push_back(limit_step(command, *braking.onset));
    if (braking.failed) steps.push_back(failed_step(*braking.failed));
    if (braking.beyond_EBI) steps.push_back(limit_step(command, *braking.beyond_EBI));
  }
  std::stable_sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.t_ms < b.t_ms; });
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
  const radio::State& radio = m.deciding.radio;
  if (!radio.contact_reference) return steps;
  const auto since = static_cast<std::int64_t>(radio.contact_reference->si * 1000.0 + 0.5);
  // T_REF is its stamp; what else begins the time comes after it.
  const Contact* last = journal.last_of(radio.supervising.session.rbc);
  const bool of_message = last != nullptr && last->t_ms >= since;
  Step step{of_message ? last->t_ms : since,
            "a radio hole, the entry into level 2 or 3, or a handover: the time begins", "3.16.3.4.1.1"};
  if (of_message) step = {last->t_ms, "the last message of the RBC, " + message_words(last->NID_MESSAGE), ""};
  steps.insert(!steps.empty() && steps[0].t_ms > step.t_ms ? steps.begin() : steps.end(), step);
  const Act* connection = journal.last(Act::Kind::session, m.t_ms, kNotConnected);
  if (connection != nullptr && connection->t_ms >= step.t_ms) steps.push_back(step_of(*connection));
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
    if (const Note* note = journal.last(What::packet_accepted, m.t_ms, packet::mode_profile))
      steps.push_back(step_of(*note));
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
