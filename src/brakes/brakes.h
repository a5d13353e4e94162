#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "base/set.h"
#include "base/units.h"
#include "terms/cause.h"
#include "terms/clause.h"
#include "terms/mode.h"
#include "terms/srs_version.h"

// Brake command handling, SUBSET-026-3 3.14.1: every cause that may ask for a brake, what it
// asks for, and what releases it.
namespace evc::brakes {

enum class Kind : std::uint8_t { traction_cut_off, service_brake, emergency_brake };

/// What ends the command of a cause once it was given.
enum class Release : std::uint8_t {
  when_gone,  // the room that asks applies the rule: the command lasts as long as it is asked for
  at_standstill,
  at_standstill_or_message,  // or with a new consistent message from the RBC
  acknowledged_at_standstill,
  gone_or_acknowledged_at_standstill,
};

using evc::Cause;
using CauseSet = Set<Cause>;
inline constexpr std::size_t kCauses = terms::index(Cause::count);

struct CauseRow {
  Cause cause;
  Kind kind;
  Release release;
  bool again_on_movement;  // after the release, any further movement while the cause is present brakes again
  Clause clause;
};

// clang-format off
/// 3.14.1, 3.13.10 and the clauses that define the causes. Where the standard leaves the kind of brake open (roll away,
/// reverse movement, standstill, movement during data entry, BTM alarm), the emergency brake is used.
inline constexpr auto srs_3_14_1 = [] {
  using enum Release;
  constexpr Kind tco = Kind::traction_cut_off, sb = Kind::service_brake, eb = Kind::emergency_brake;
  return std::to_array<CauseRow>({
    {Cause::trip,                               eb,  when_gone,                          false, "3.14.1.3"_srs},
    {Cause::no_power_or_failure,                eb,  when_gone,                          false, "4.4.4"_srs},
    {Cause::overspeed_traction,                 tco, when_gone,                          false, "3.13.10"_srs},
    {Cause::overspeed_service,                  sb,  when_gone,                          false, "3.13.10.3"_srs},
    {Cause::overspeed_emergency,                eb,  when_gone,                          false, "3.13.10.3"_srs},
    {Cause::roll_away,                          eb,  acknowledged_at_standstill,         true,  "3.14.1.5"_srs},
    {Cause::reverse_movement,                   eb,  acknowledged_at_standstill,         true,  "3.14.1.5"_srs},
    {Cause::standstill,                         eb,  acknowledged_at_standstill,         true,  "3.14.1.5"_srs},
    {Cause::linking,                            sb,  at_standstill,                      false, "3.14.1.6"_srs},
    {Cause::balise_group_consistency,           sb,  at_standstill,                      false, "3.14.1.6"_srs},
    {Cause::two_groups_missed,                  sb,  at_standstill,                      false, "3.14.1.6"_srs},
    {Cause::T_NVCONTACT,                        sb,  at_standstill_or_message,           false, "3.14.1.7"_srs},
    {Cause::reversing_distance,                 eb,  gone_or_acknowledged_at_standstill, true,  "3.14.1.7.1"_srs},
    {Cause::train_data_changed,                 sb,  acknowledged_at_standstill,         false, "3.14.1.7.2"_srs},
    {Cause::movement_while_entering_train_data, eb,  acknowledged_at_standstill,         false, "3.14.1.7.3"_srs},
    {Cause::movement_while_entering_SR_data,    eb,  acknowledged_at_standstill,         false, "3.14.1.7.3"_srs},
    {Cause::post_trip_distance,                 sb,  acknowledged_at_standstill,         true,  "3.14.1.7.4"_srs},
    {Cause::text_service,                       sb,  when_gone,                          false, "3.14.1.7.5"_srs},
    {Cause::text_emergency,                     eb,  when_gone,                          false, "3.14.1.7.5"_srs},
    {Cause::OS_unacknowledged,                  sb,  when_gone,                          false, "5.9.2.4"_srs},
    {Cause::LS_unacknowledged,                  sb,  when_gone,                          false, "5.19.2.4"_srs},
    {Cause::SH_unacknowledged,                  sb,  when_gone,                          false, "5.7.2.4"_srs},
    {Cause::level_NTC_unacknowledged,           sb,  when_gone,                          false, "5.10.4.3"_srs},
    {Cause::level_0_unacknowledged,             sb,  when_gone,                          false, "5.10.4.3"_srs},
    {Cause::national_system_service,            sb,  when_gone,                          false, "3.14.1.7.7"_srs},
    {Cause::national_system_emergency,          eb,  when_gone,                          false, "3.14.1.7.7"_srs},
    {Cause::balise_antenna,                     eb,  when_gone,                          false, "3.15.7"_srs},
    {Cause::consist_length,                     sb,  at_standstill,                      false, "3.14.1.7.6"_srs},
  });
}();
// clang-format on
static_assert(srs_3_14_1.size() == kCauses);

constexpr const CauseRow& row(Cause cause) { return srs_3_14_1[static_cast<std::size_t>(cause)]; }

/// A cause that a paragraph of 3.14.1 of one issue includes and not that of `srs_3_14_1`, which has those of 3.x.
struct ClauseChange {
  SrsVersion srs{};
  Cause cause{};
  Clause clause;
};
inline constexpr auto kClausesOfIssue = std::to_array<ClauseChange>({
    {SrsVersion::v4_0_0, Cause::movement_while_entering_train_data, "3.14.1.5"_srs},
    {SrsVersion::v4_0_0, Cause::movement_while_entering_SR_data, "3.14.1.5"_srs},
});

/// The paragraph that includes the cause.
constexpr Clause clause_of(Cause cause, SrsVersion srs) {
  for (const ClauseChange& change : kClausesOfIssue)
    if (change.srs == srs && change.cause == cause) return change.clause;
  return row(cause).clause;
}

/// What the train reports of its service brake.
struct ServiceBrakeFeedback {
  bool applied = false;                // says its signal
  std::optional<double> pressure_kpa;  // of the main pipe; absent: not measured
};
/// 3.14.1.2: whether a service brake that is commanded is applied.
struct ServiceBrakeWatch {
  std::optional<Duration> since;       // the command; absent: none
  std::optional<double> pressure_kpa;  // then
  bool failed = false;                 // until the command ends
};
/// The fall of the pressure that shows an application, as that from which on A.3.10 counts.
inline constexpr double kApplicationKpa = 30.0;
/// The fall below the pressure of the released brake that is a full application (A.3.10.3).
inline constexpr double kFullApplicationKpa = 150.0;
/// The pressure of a released brake: the nominal one, not more is taken for it (a pipe that was overcharged); and the
/// lowest that A.3.10.2 takes for it.
inline constexpr double kReleasedKpa = 500.0, kLowestReleasedKpa = 400.0;

struct State {
  CauseSet active;        // commands given and not released
  CauseSet asked_before;  // what was asked for in the cycle before
  ServiceBrakeWatch service_brake;
  double highest_kpa = 0.0;  // pressure reported while no brake was commanded
};

/// Whether the service or the emergency brake was commanded at the end of the cycle before.
bool brakes_now(const State& state);

struct Context {
  bool standstill = false;
  bool driver_acknowledges = false;  // the brake, in this cycle; counts at standstill only
  SrsVersion srs = SrsVersion::v3_6_0;
  bool new_consistent_message = false;  // from the RBC, in this cycle
  bool service_brake_fitted = true;     // otherwise the emergency brake is used instead
  bool traction_cut_off_fitted = true;
  Duration now{};
  std::optional<ServiceBrakeFeedback> feedback;  // absent: the train reports nothing of its service brake
  Duration T_bs{};                               // after which the service brake acts fully
};

struct Command {
  bool tco = false, sb = false, eb = false;
  CauseSet reasons;
  bool service_brake_fails = false;     // found in this cycle (3.14.1.2)
  bool acknowledgement_wanted = false;  // a release waits only for the driver's acknowledgement (3.14.1.8)
};

/// 3.14.1.10: what an acknowledgement at standstill is for, the commanded causes of one clause; another clause needs
/// its own. The clauses are acknowledged in the order of the table.
CauseSet acknowledged_causes(const State& state, SrsVersion srs);

/// One cycle: the causes asked for give commands, and commands whose release rule is fulfilled end. Service brake and
/// emergency brake are combined over the causes separately.
Command command(State& state, CauseSet asked, const Context& context);

/// 4.12 of 4.0.0: a mode entry revokes commands. Used for 3.x too, which does not say. Commands that last as long as
/// they are asked for are not changed here: the rooms that ask for them stop asking.
void on_mode_entry(State& state, Mode to, Mode from);

/// 4.12 [2] of 4.0.0: an authorisation for a supervised manoeuvre that changes the train orientation revokes commands.
void on_turn(State& state);

/// Whether the entry of mode `to` from mode `from` revokes the command of a cause.
bool revoked_on_mode_entry(Cause cause, Mode to, Mode from);

}  // namespace evc::brakes
