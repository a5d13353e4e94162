#include "modes/information.h"

#include <array>

namespace evc::modes {
namespace {

// clang-format off
struct Row { int number; Information what; };

/// Packets that fill one row whatever they contain (7.4.2).
constexpr auto kPackets = std::to_array<Row>({
    {  2, Information::system_version_order},      {  3, Information::national_values},
    {  5, Information::linking},                   {  6, Information::vbc_order},
    { 13, Information::sr_distance_loop},          { 15, Information::movement_authority},
    { 16, Information::repositioning},             { 21, Information::gradient},
    { 27, Information::ssp},                       { 39, Information::track_conditions_general},
    { 40, Information::track_conditions_general},  { 41, Information::level_transition_order},
    { 42, Information::session_management},        { 44, Information::external_application_data},
    { 45, Information::radio_network_registration}, { 46, Information::conditional_level_transition_order},
    { 51, Information::asp},                       { 52, Information::permitted_braking_distance},
    { 57, Information::ma_request_params},         { 58, Information::position_report_params},
    { 64, Information::inhibit_revocable_tsr},     { 65, Information::tsr},
    { 66, Information::tsr_revocation},            { 67, Information::track_condition_bmm},
    { 69, Information::track_conditions_general},  { 70, Information::route_suitability},
    { 71, Information::adhesion},                  { 72, Information::plain_text},
    { 76, Information::fixed_text},                { 79, Information::geo_position},
    { 88, Information::level_crossing},            { 90, Information::taf_up_to_l23},
    {131, Information::rbc_transition_order},      {132, Information::danger_for_sh},
    {133, Information::radio_infill_area},         {134, Information::eolm},
    {135, Information::stop_sh_on_desk_opening},   {136, Information::infill_location_reference},
    {137, Information::stop_if_in_sr},             {138, Information::reversing_area},
    {139, Information::reversing_supervision},     {140, Information::train_running_number},
    {141, Information::default_gradient_tsr},      {143, Information::session_management_riu},
    {181, Information::generic_ls_marker},         {254, Information::default_balise_info},
});

/// Radio messages from the track (8.4.4).
constexpr auto kMessages = std::to_array<Row>({
    { 2, Information::sr_authorisation},              { 3, Information::movement_authority},
    { 6, Information::exit_trip_recognition},         { 8, Information::train_data_ack},
    { 9, Information::ma_shortening_request},         {15, Information::conditional_emergency_stop},
    {16, Information::unconditional_emergency_stop},  {18, Information::emergency_stop_revocation},
    {27, Information::sh_refused},                    {28, Information::sh_authorised},
    {32, Information::trackside_system_version},      {33, Information::movement_authority},
    {34, Information::track_ahead_free_request},      {38, Information::session_initiation},
    {39, Information::session_termination_ack},       {40, Information::train_rejected},
    {41, Information::train_accepted},                {43, Information::som_position_confirmed},
    {45, Information::coordinate_system_assignment},
});
// clang-format on

Informations one(Information what) {
  Informations out;
  static_cast<void>(out.push_back(what));
  return out;
}

template <std::size_t N>
Informations find(const std::array<Row, N>& rows, int number) {
  for (const Row& row : rows)
    if (row.number == number) return one(row.what);
  return {};
}

}  // namespace

Informations information_of_packet(int NID_PACKET, int detail) {
  if (NID_PACKET == 12) {  // the authority of level 1 brings the signalling related speed restriction V_MAIN
    Informations both = one(Information::signalling_speed);
    static_cast<void>(both.push_back(Information::movement_authority));
    return both;
  }
  // M_TRACKCOND 0, 1, 2: non stopping area, tunnel stopping area, sound horn
  if (NID_PACKET == 68)
    return one(detail <= 2 ? Information::track_conditions_horn_stopping : Information::track_conditions_general);
  if (NID_PACKET == 180) return one(detail == 1 ? Information::lssma_toggle_on : Information::lssma_toggle_off);
  return find(kPackets, NID_PACKET);
}

Informations information_of_message(int NID_MESSAGE) { return find(kMessages, NID_MESSAGE); }

}  // namespace evc::modes
