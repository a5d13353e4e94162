#include <fmt/format.h>

#include "explain/brake.h"
#include "explain/words.h"
#include "texts/texts.h"

// What a command is, and what releases it.
namespace evc::explain {
namespace {

/// An emergency brake by the SBI limit: no service brake is fitted or permitted (3.13.10.2.3), or the mode is RV
/// (4.4.18.1.6).
bool for_service_brake(const Moment& m) { return !m.after.supervision.eb; }

bool no_service_brake(const Command& c) {
  return brakes::row(c.cause).kind == brakes::Kind::service_brake &&
         !c.braking->onset->after.train.service_brake_interface;
}

/// As the service brake: with r1 of Table 11 the speed that counts at the end of authority is the release speed.
std::string permitted_words(const Moment& now) {
  const bool released_at_it = now.outputs.monitoring == Monitoring::TSM && now.outputs.V_release;
  return released_at_it
             ? fmt::format("at the release speed, {}, or the permitted speed", kmh_words(*now.outputs.V_release))
             : "at the permitted speed";
}

std::string emergency_words(const Moment& now) {
  const sdm::Supervision& s = now.after.supervision;
  if (for_service_brake(now) && (s.eb_for_sb || s.sb)) return permitted_words(now);
  if (now.outputs.monitoring == Monitoring::RSM) return "at standstill (release speed monitoring)";
  return now.after.national_values.Q_NVEMRRLS ? permitted_words(now) + " (Q_NVEMRRLS 1)"
                                              : "at standstill (Q_NVEMRRLS 0)";
}

const char* rule_words(brakes::Release rule) {
  switch (rule) {
    case brakes::Release::at_standstill:
      return "at standstill";
    case brakes::Release::at_standstill_or_message:
      return "at standstill, or by a message of the RBC";
    case brakes::Release::acknowledged_at_standstill:
      return "at standstill, when the driver acknowledges the brake";
    case brakes::Release::gone_or_acknowledged_at_standstill:
      return "when its cause ends, or at standstill with the driver's acknowledgement";
    default:
      return "when its cause ends";
  }
}

}  // namespace

std::string brake_words(const Command& c) {
  if (no_service_brake(c)) return "emergency brake in place of the service brake";
  const char* kind = words(brakes::row(c.cause).kind);
  if (c.braking->failed) return fmt::format("{}, since {} the emergency brake", kind, time_words(*c.braking->failed));
  if (c.cause == Cause::overspeed_emergency && for_service_brake(*c.braking->onset))
    return std::string(kind) +
           (c.braking->beyond_EBI ? ", first in place of the service brake" : " in place of the service brake");
  return kind;
}

Step failed_step(std::int64_t t_ms) { return {t_ms, "the service brake is not applied: emergency brake", "3.14.1.2"}; }

std::optional<std::string> release_words(const Command& c, const Moment& now) {
  switch (c.cause) {
    case Cause::trip:
      return "at standstill, when the driver acknowledges the trip";
    case Cause::no_power_or_failure:
      if (now.after.mode != Mode::NP) return std::nullopt;
      return "when the unit is supplied";
    case Cause::overspeed_traction:
    case Cause::overspeed_service:
      return permitted_words(now);
    case Cause::overspeed_emergency:
      return emergency_words(now);
    case Cause::text_service:
    case Cause::text_emergency:
    case Cause::OS_unacknowledged:
    case Cause::LS_unacknowledged:
    case Cause::SH_unacknowledged:
    case Cause::level_NTC_unacknowledged:
    case Cause::level_0_unacknowledged:
      return "when the driver acknowledges it";
    case Cause::national_system_service:
    case Cause::national_system_emergency:
      return "when the national system withdraws its order, or SN is left";
    case Cause::balise_antenna:
      return "when the alarm ends";
    default:
      return rule_words(brakes::row(c.cause).release);
  }
}

std::string clause_of(Cause cause, const Moment& m) {
  switch (cause) {
    case Cause::no_power_or_failure:
      return m.after.mode == Mode::NP ? "4.4.4.1.2" : "4.4.5.1.2";
    case Cause::overspeed_traction:
    case Cause::overspeed_service:
    case Cause::overspeed_emergency:
      if (m.after.mode == Mode::RV && for_service_brake(m)) return "4.4.18.1.6";
      if (cause == Cause::overspeed_emergency && for_service_brake(m)) return "3.13.10.2.3";
      return m.outputs.monitoring == Monitoring::CSM   ? "3.13.10.3.3"
             : m.outputs.monitoring == Monitoring::TSM ? "3.13.10.4.10"
                                                       : "3.13.10.5.4";
    case Cause::balise_antenna:
      return level_1_2_3(m.after.level.level) ? "3.15.7.6" : "3.15.7.2";
    default:
      break;
  }
  return texts::text_of(brakes::clause_of(cause, m.after.srs));
}

}  // namespace evc::explain
