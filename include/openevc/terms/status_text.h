#pragma once
#include "openevc/terms/row.h"

namespace evc {

/// The system status messages that the driver is shown (ERA_ERTMS_015560 15, Table 68): trip reasons, brake reasons and
/// what procedures and radio report.
enum class StatusText : std::uint8_t {
  balise_read_error,
  trackside_malfunction,
  communication_error,
  entering_FS,
  entering_OS,
  runaway_movement,
  SH_refused,
  SH_request_failed,
  trackside_not_compatible,
  train_is_rejected,
  passing_of_EOA_or_LOA,
  no_MA_at_level_transition,
  SR_distance_exceeded,
  SH_stop_order,
  SR_stop_order,
  emergency_stop,
  RV_distance_exceeded,
  PT_distance_exceeded,
  no_track_description,
  national_system_brake_demand,
  route_unsuitable_gauge,
  route_unsuitable_traction,
  route_unsuitable_axle_load,
  network_registration_failed,
  train_data_changed,
  national_system_not_available,
  NL_no_longer_permitted,
  odometer_impaired,
  entering_SM,
  SM_refused,
  SM_request_failed,
  consist_length_lost,
  count
};

/// The texts, spelt as in Tables 68 and 69; those that begin with "National system" have its name there
/// (names_national_system).
inline constexpr auto kStatusTextRows = std::to_array<terms::Row<StatusText>>({
    {StatusText::balise_read_error, "Balise read error"},
    {StatusText::trackside_malfunction, "Trackside malfunction"},
    {StatusText::communication_error, "Communication error"},
    {StatusText::entering_FS, "Entering FS"},
    {StatusText::entering_OS, "Entering OS"},
    {StatusText::runaway_movement, "Runaway movement"},
    {StatusText::SH_refused, "SH refused"},
    {StatusText::SH_request_failed, "SH request failed"},
    {StatusText::trackside_not_compatible, "Trackside not compatible"},
    {StatusText::train_is_rejected, "Train is rejected"},
    {StatusText::passing_of_EOA_or_LOA, "Unauthorized passing of EOA / LOA"},
    {StatusText::no_MA_at_level_transition, "No MA received at level transition"},
    {StatusText::SR_distance_exceeded, "SR distance exceeded"},
    {StatusText::SH_stop_order, "SH stop order"},
    {StatusText::SR_stop_order, "SR stop order"},
    {StatusText::emergency_stop, "Emergency stop"},
    {StatusText::RV_distance_exceeded, "RV distance exceeded"},
    {StatusText::PT_distance_exceeded, "PT distance exceeded"},
    {StatusText::no_track_description, "No track description"},
    {StatusText::national_system_brake_demand, "National system brake demand"},
    {StatusText::route_unsuitable_gauge, "Route unsuitable – loading gauge"},
    {StatusText::route_unsuitable_traction, "Route unsuitable – traction system"},
    {StatusText::route_unsuitable_axle_load, "Route unsuitable – axle load category"},
    {StatusText::network_registration_failed, "Radio network registration failed"},
    {StatusText::train_data_changed, "Train data changed"},
    {StatusText::national_system_not_available, "National system is not available"},
    {StatusText::NL_no_longer_permitted, "NL no longer permitted"},
    {StatusText::odometer_impaired, "Odometer impaired"},
    {StatusText::entering_SM, "Entering SM"},
    {StatusText::SM_refused, "SM refused"},
    {StatusText::SM_request_failed, "SM request failed"},
    {StatusText::consist_length_lost, "Safe consist length no longer available"},
});
static_assert(terms::in_order(kStatusTextRows) && kStatusTextRows.size() == terms::index(StatusText::count));

/// Whether the text begins with the name of the national system.
constexpr bool names_national_system(StatusText text) {
  return text == StatusText::national_system_brake_demand || text == StatusText::national_system_not_available;
}

/// Whether the driver has to acknowledge the text (4.4.15.1.1.3 of 4.0.0).
constexpr bool asks_acknowledgement(StatusText text) { return text == StatusText::NL_no_longer_permitted; }

/// "Unauthorized passing of EOA / LOA".
constexpr const char* name(StatusText text) { return terms::kNames<kStatusTextRows>[terms::index(text)]; }

}  // namespace evc
