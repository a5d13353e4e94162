#pragma once
#include "openevc/terms/row.h"

namespace evc {

/// Every cause of a brake command (3.14.1; what each asks for and what releases it: brakes/brakes.h).
enum class Cause : std::uint8_t {
  trip,                 ///< mode TR
  no_power_or_failure,  ///< modes NP and SF
  overspeed_traction,   ///< warning limit: traction cut-off (3.13.10)
  overspeed_service,    ///< SBI limit
  overspeed_emergency,  ///< EBI limit, release speed, or in place of the service brake
  roll_away,
  reverse_movement,
  standstill,  ///< movement in SB
  linking,     ///< linking reaction "service brake"
  balise_group_consistency,
  two_groups_missed,  ///< 3.16.2.7
  T_NVCONTACT,        ///< M_NVCONTACT "service brake"
  reversing_distance,
  train_data_changed,  ///< by an external source while running (5.17)
  movement_while_entering_train_data,
  movement_while_entering_SR_data,
  post_trip_distance,
  text_service,    ///< text not acknowledged, Q_TEXTCONFIRM 2
  text_emergency,  ///< Q_TEXTCONFIRM 3
  OS_unacknowledged,
  LS_unacknowledged,
  SH_unacknowledged,
  level_NTC_unacknowledged,
  level_0_unacknowledged,  ///< level 0; up to 3.6.0 also 1, 2 and 3 from NTC
  national_system_service,
  national_system_emergency,
  balise_antenna,  ///< BTM alarm that lasts (3.15.7)
  consist_length,  ///< of a supervised manoeuvre: it became unavailable (4.4.21.1.12)
  count
};

/// The names as printed in outputs: service and emergency brake for the same cause share one.
inline constexpr auto kCauseRows = std::to_array<terms::Row<Cause>>({
    {Cause::trip, "trip"},
    {Cause::no_power_or_failure, "no power or system failure"},
    {Cause::overspeed_traction, "overspeed: warning"},
    {Cause::overspeed_service, "overspeed: SBI"},
    {Cause::overspeed_emergency, "overspeed: EBI"},
    {Cause::roll_away, "roll away"},
    {Cause::reverse_movement, "reverse movement"},
    {Cause::standstill, "standstill"},
    {Cause::linking, "linking"},
    {Cause::balise_group_consistency, "balise group consistency"},
    {Cause::two_groups_missed, "two balise groups missed"},
    {Cause::T_NVCONTACT, "T_NVCONTACT"},
    {Cause::reversing_distance, "reversing distance"},
    {Cause::train_data_changed, "train data changed"},
    {Cause::movement_while_entering_train_data, "movement while entering train data"},
    {Cause::movement_while_entering_SR_data, "movement while entering SR data"},
    {Cause::post_trip_distance, "post trip distance"},
    {Cause::text_service, "text not acknowledged"},
    {Cause::text_emergency, "text not acknowledged"},
    {Cause::OS_unacknowledged, "OS not acknowledged"},
    {Cause::LS_unacknowledged, "LS not acknowledged"},
    {Cause::SH_unacknowledged, "SH not acknowledged"},
    {Cause::level_NTC_unacknowledged, "level NTC not acknowledged"},
    {Cause::level_0_unacknowledged, "level not acknowledged"},
    {Cause::national_system_service, "national system"},
    {Cause::national_system_emergency, "national system"},
    {Cause::balise_antenna, "balise antenna"},
    {Cause::consist_length, "safe consist length"},
});
static_assert(terms::in_order(kCauseRows) && kCauseRows.size() == terms::index(Cause::count));

/// "overspeed: SBI".
constexpr const char* name(Cause cause) { return terms::kNames<kCauseRows>[terms::index(cause)]; }

}  // namespace evc
