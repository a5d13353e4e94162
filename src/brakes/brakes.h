#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>

#include "terms/mode.h"

// Brake command handling, SUBSET-026-3 3.14.1: every cause that may ask for a brake, what it
// asks for, and what releases it.
namespace evc::brakes {

enum class Kind : std::uint8_t { traction_cut_off, service_brake, emergency_brake };

/// What ends the command of a cause once it was given.
enum class Release : std::uint8_t {
  when_gone,  // the asking room knows the rule: the command lasts as long as it is asked for
  at_standstill,
  at_standstill_or_message,  // or with a new consistent message from the RBC
  acknowledged_at_standstill,
  gone_or_acknowledged_at_standstill,
};

/// Every cause of a brake command.
enum class Cause : std::uint8_t {
  trip,                 // mode TR
  no_power_or_failure,  // modes NP and SF
  overspeed_traction,   // warning limit: traction cut-off (3.13.10)
  overspeed_service,    // SBI limit
  overspeed_emergency,  // EBI limit, release speed, or in place of the service brake
  roll_away,
  reverse_movement,
  standstill,  // movement in SB
  linking,     // linking reaction "service brake"
  balise_group_consistency,
  two_groups_missed,  // 3.16.2.7
  T_NVCONTACT,        // M_NVCONTACT "service brake"
  reversing_distance,
  train_data_changed,  // by an external source while running (5.17)
  movement_while_entering_train_data,
  movement_while_entering_SR_data,
  post_trip_distance,
  text_service,    // text not acknowledged, Q_TEXTCONFIRM 2
  text_emergency,  // Q_TEXTCONFIRM 3
  OS_unacknowledged,
  LS_unacknowledged,
  SH_unacknowledged,
  level_NTC_unacknowledged,
  level_0_unacknowledged,  // level 0; up to 3.6.0 also 1, 2 and 3 from NTC
  national_system_service,
  national_system_emergency,
  balise_antenna,  // BTM alarm that lasts (3.15.7)
  count
};
inline constexpr std::size_t kCauses = static_cast<std::size_t>(Cause::count);

class CauseSet {
 public:
  constexpr CauseSet() = default;
  constexpr CauseSet(std::initializer_list<Cause> causes) {
    for (const Cause c : causes) add(c);
  }
  constexpr void add(Cause c, bool when = true) {
    if (when) bits_ |= bit(c);
  }
  constexpr void remove(Cause c) { bits_ &= ~bit(c); }
  constexpr bool has(Cause c) const { return (bits_ & bit(c)) != 0; }
  constexpr bool empty() const { return bits_ == 0; }
  friend constexpr bool operator==(CauseSet, CauseSet) = default;

 private:
  static constexpr std::uint32_t bit(Cause c) { return std::uint32_t{1} << static_cast<unsigned>(c); }
  std::uint32_t bits_ = 0;
};

struct CauseRow {
  Cause cause;
  Kind kind;
  Release release;
  bool again_on_movement;  // after the release any further movement while the cause is still there brakes again
  const char* reason;      // as shown in outputs and events
  const char* clause;
};

// clang-format off
/// 3.14.1, 3.13.10 and where the causes are defined. Where the standard leaves the kind of brake free (roll away, reverse
/// movement, standstill, movement during data entry, BTM alarm) it is the emergency brake.
inline constexpr auto srs_3_14_1 = [] {
  using enum Release;
  constexpr Kind tco = Kind::traction_cut_off, sb = Kind::service_brake, eb = Kind::emergency_brake;
  return std::to_array<CauseRow>({
    {Cause::trip,                               eb,  when_gone,                          false, "trip",                               "3.14.1.3"},
    {Cause::no_power_or_failure,                eb,  when_gone,                          false, "no power or system failure",         "4.4.4, 4.4.5"},
    {Cause::overspeed_traction,                 tco, when_gone,                          false, "overspeed: warning",                 "3.13.10"},
    {Cause::overspeed_service,                  sb,  when_gone,                          false, "overspeed: SBI",                     "3.13.10.3"},
    {Cause::overspeed_emergency,                eb,  when_gone,                          false, "overspeed: EBI",                     "3.13.10.3"},
    {Cause::roll_away,                          eb,  acknowledged_at_standstill,         true,  "roll away",                          "3.14.1.5"},
    {Cause::reverse_movement,                   eb,  acknowledged_at_standstill,         true,  "reverse movement",                   "3.14.1.5"},
    {Cause::standstill,                         eb,  acknowledged_at_standstill,         true,  "standstill",                         "3.14.1.5"},
    {Cause::linking,                            sb,  at_standstill,                      false, "linking",                            "3.14.1.6"},
    {Cause::balise_group_consistency,           sb,  at_standstill,                      false, "balise group consistency",           "3.14.1.6"},
    {Cause::two_groups_missed,                  sb,  at_standstill,                      false, "two balise groups missed",           "3.14.1.6"},
    {Cause::T_NVCONTACT,                        sb,  at_standstill_or_message,           false, "T_NVCONTACT",                        "3.14.1.7"},
    {Cause::reversing_distance,                 eb,  gone_or_acknowledged_at_standstill, true,  "reversing distance",                 "3.14.1.7.1"},
    {Cause::train_data_changed,                 sb,  acknowledged_at_standstill,         false, "train data changed",                 "3.14.1.7.2"},
    {Cause::movement_while_entering_train_data, eb,  acknowledged_at_standstill,         false, "movement while entering train data", "3.14.1.7.3"},
    {Cause::movement_while_entering_SR_data,    eb,  acknowledged_at_standstill,         false, "movement while entering SR data",    "3.14.1.7.3"},
    {Cause::post_trip_distance,                 sb,  acknowledged_at_standstill,         true,  "post trip distance",                 "3.14.1.7.4"},
    {Cause::text_service,                       sb,  when_gone,                          false, "text not acknowledged",              "3.14.1.7.5"},
    {Cause::text_emergency,                     eb,  when_gone,                          false, "text not acknowledged",              "3.14.1.7.5"},
    {Cause::OS_unacknowledged,                  sb,  when_gone,                          false, "OS not acknowledged",                "5.9.2.4"},
    {Cause::LS_unacknowledged,                  sb,  when_gone,                          false, "LS not acknowledged",                "5.19.2.4"},
    {Cause::SH_unacknowledged,                  sb,  when_gone,                          false, "SH not acknowledged",                "5.7.2.4"},
    {Cause::level_NTC_unacknowledged,           sb,  when_gone,                          false, "level NTC not acknowledged",         "5.10.4.3"},
    {Cause::level_0_unacknowledged,             sb,  when_gone,                          false, "level not acknowledged",             "5.10.4.3"},
    {Cause::national_system_service,            sb,  when_gone,                          false, "national system",                    "3.14.1.7.7"},
    {Cause::national_system_emergency,          eb,  when_gone,                          false, "national system",                    "3.14.1.7.7"},
    {Cause::balise_antenna,                     eb,  when_gone,                          false, "balise antenna",                     "3.15.7"},
  });
}();
// clang-format on
static_assert(srs_3_14_1.size() == kCauses);

constexpr const CauseRow& row(Cause cause) { return srs_3_14_1[static_cast<std::size_t>(cause)]; }

struct State {
  CauseSet active;        // commands given and not released
  CauseSet asked_before;  // what was asked for in the cycle before
};

struct Context {
  bool standstill = false;
  bool driver_acknowledges = false;     // the brake, in this cycle; counts at standstill only
  bool new_consistent_message = false;  // from the RBC, in this cycle
  bool service_brake_fitted = true;     // otherwise the emergency brake takes its place
  bool service_brake_failed = false;    // commanded, but the train does not brake (3.14.1.2)
  bool traction_cut_off_fitted = true;
};

struct Command {
  bool tco = false, sb = false, eb = false;
  CauseSet reasons;
  bool acknowledgement_wanted = false;  // a release waits for the driver, all else is fulfilled (3.14.1.8)
};

/// One cycle: what is asked for now gives commands, and commands whose release rule is fulfilled end. Service and
/// emergency brake are joined over the causes separately.
Command command(State& state, CauseSet asked, const Context& context);

/// 4.12 of 4.0.0, used for 3.x too, which is silent: a mode entry revokes commands. Those that last as long as they are
/// asked for are not touched here: the rooms that ask for them stop asking.
void on_mode_entry(State& state, Mode to, Mode from);

/// Whether the entry of mode `to` from mode `from` revokes the command of a cause.
bool revoked_on_mode_entry(Cause cause, Mode to, Mode from);

}  // namespace evc::brakes
