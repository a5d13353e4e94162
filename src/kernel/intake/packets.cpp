#include "kernel/intake/forwarded.h"
#include "kernel/intake/loops.h"
#include "kernel/intake/national_values.h"
#include "kernel/intake/routes.h"
#include "kernel/intake/session_packets.h"
#include "kernel/radio_infill.h"
#include "lang/decode.h"
#include "lang/packets/packet_140.h"
#include "lang/packets/packet_143.h"
#include "lang/packets/packet_180.h"
#include "lang/packets/packet_3.h"
#include "lang/packets/packet_41.h"
#include "lang/packets/packet_57.h"
#include "lang/packets/packet_58.h"
#include "lang/packets/packet_6.h"
#include "lang/packets/packet_68.h"
#include "lang/packets/packet_72.h"
#include "lang/packets/packet_76.h"
#include "lang/si.h"
#include "radio/from_packets.h"
#include "terms/track_condition.h"

namespace evc::kernel {
namespace {

using modes::Verdict;

/// Stored in the track description.
void store_with_track(Evaluation& e, const lang::PacketView& view, Verdict) {
  (void)track::add(e.contents, view, e.reference);
}

void store_text(Evaluation& e, const lang::PacketView& view, Verdict) {
  track::Contents& contents = e.contents;
  if (track::add(contents, view, e.reference) != track::Added::added || contents.texts.empty()) return;
  track::Text& text = contents.texts.back();
  const SrsVersion srs = e.r.state.srs;
  if (text.start_level) text.start_level = modes::level_in(srs, *text.start_level);
  if (text.end_level) text.end_level = modes::level_in(srs, *text.end_level);
}

/// The section changes its length only by the group that was announced for it (3.8.5.2.2).
void take_repositioning(Evaluation& e, const lang::PacketView& view, Verdict verdict) {
  if (e.information.repositioning) return store_with_track(e, view, verdict);
  constexpr Clause kNotAnnounced = "3.8.5.2.2"_srs;
  e.r.log.note({.what = What::packet_refused, .id = view.NID_PACKET, .clause = kNotAnnounced});
  refuse(e, kNotAnnounced);
}

void take_national_values(Evaluation& e, const lang::PacketView& view, Verdict) {
  State& s = e.r.state;
  lang::Packet3 p;
  if (lang::decode(view, p) != lang::Fault::none) return;
  ReceivedNationalValues received = read(p, view.sv.x);
  if (view.sv.x == 1) {
    received.set.of_X_2 = s.operated_X == 1;  // 6.6.3.2.3 [1a], [1b]
    received.set.braking = join_braking_curves(e.information, received.set.values);
  }
  if (!received.D_VALIDNV) {
    use_national_values(s, received.set);
    s.pending_national_values.reset();
    e.r.log.note({.what = What::national_values_in_force, .clause = "3.18.2.3"_srs});
    return;
  }
  s.pending_national_values =
      PendingNationalValues{e.reference.place + *received.D_VALIDNV, anchor_of(e), received.set};
  e.brought.national_values = true;
}

/// 3.9.3.6.
void take_neighbour_order(Evaluation& e, const lang::PacketView& view, Verdict) {
  lang::Packet143 p;
  if (lang::decode(view, p) != lang::Fault::none) return;
  order_neighbour(e.r.state, {p.NID_C.raw, p.NID_RIU.raw, p.NID_RADIO.raw, true}, p.Q_RIU.raw == 1, e.r.outbox,
                  e.r.log);
}

/// 4.8.4 [8]: in SH and PS only the contact is stored.
void take_rbc_transition(Evaluation& e, const lang::PacketView& view, Verdict verdict) {
  if (verdict != Verdict::only_contact_stored) return store_with_track(e, view, verdict);
  lang::Packet131 p;
  if (lang::decode(view, p) != lang::Fault::none) return;
  if (p.NID_RADIO.raw == radio::kNoNumber) return;
  e.r.state.radio.contact = radio::session_order_of(p).rbc;
  e.r.state.contact_status = DataStatus::valid;
}

void take_ma_request_parameters(Evaluation& e, const lang::PacketView& view, Verdict) {
  lang::Packet57 p;
  if (lang::decode(view, p) != lang::Fault::none) return;
  e.r.state.radio.ma_request = radio::ma_request_of(p);
}

void take_report_parameters(Evaluation& e, const lang::PacketView& view, Verdict) {
  lang::Packet58 p;
  if (lang::decode(view, p) != lang::Fault::none) return;
  position::ReportParameters r;
  r.T_CYCLOC = lang::seconds(p.T_CYCLOC);
  r.D_CYCLOC = lang::metres(p.Q_SCALE, p.D_CYCLOC);
  r.M_LOC = p.M_LOC.raw;
  Place place = e.reference.place;
  for (const auto& at : p.locations) {
    place = place + lang::metres(p.Q_SCALE, at.D_LOC);  // from the location before (7.5.1.11)
    // At most 31 places: they fit.
    (void)r.at.push_back({place, at.Q_LGTLOC.raw == 1});
  }
  State& s = e.r.state;
  position::set_parameters(s.reports, s.position, r);
}

void take_cover(Evaluation& e, const lang::PacketView& view, Verdict) {
  lang::Packet6 p;
  if (lang::decode(view, p) != lang::Fault::none) return;
  State& s = e.r.state;
  if (p.Q_VBCO.raw == 0) return balise::remove_cover(s.balise, static_cast<std::uint8_t>(p.NID_VBCMK.raw), p.NID_C.raw);
  // T_VBC in days (7.5.1.155.1).
  const Duration until = s.now + Duration{86400.0 * p.T_VBC.raw};
  if (!balise::set_cover(s.balise, {static_cast<std::uint8_t>(p.NID_VBCMK.raw), p.NID_C.raw, until,
                                    static_cast<std::uint8_t>(p.T_VBC.raw)}))
    e.r.log.note({.what = What::cover_capacity});
}

/// Packet 203 is read with its packet 3 (join_braking_curves).
void taken_with_packet_3(Evaluation&, const lang::PacketView&, Verdict) {}
/// 3.16.2.4.9. A group has it also where the filters refuse it (receive_group).
void take_default_information(Evaluation& e, const lang::PacketView&, Verdict) { e.r.out.default_information = true; }

/// 3.18.4.5.1, 3.18.4.5.3: it is not sent back to this RBC (3.18.4.5.4.1).
void take_running_number(Evaluation& e, const lang::PacketView& view, Verdict) {
  lang::Packet140 p;
  if (lang::decode(view, p) != lang::Fault::none) return;
  DriverData& data = e.r.state.data;
  data.train_running_number = p.NID_OPERATIONAL.raw;
  data.train_running_number_status = DataStatus::valid;
  const SessionRole sender = e.information.sender;
  const radio::Rbc& rbc =
      (sender == SessionRole::supervising ? e.r.state.radio.supervising : e.r.state.radio.other).session.rbc;
  data.train_running_number_from = RbcIdentity{rbc.NID_C, rbc.NID_RBC};
}

/// An order deletes one that waits; until it takes effect nothing is displayed (4.4.19.1.4.2, .4, .5).
void take_lssma_order(Evaluation& e, const lang::PacketView& view, Verdict) {
  lang::Packet180 p;
  if (lang::decode(view, p) != lang::Fault::none) return;
  State& s = e.r.state;
  s.lssma = {};
  if (p.Q_LSSMA.raw == 0) return;
  const bool released = e.information.judge_packets != ~std::uint64_t{0};  // by the level transition of this cycle
  s.lssma.waiting = {released ? s.now : e.information.time, lang::seconds(p.T_LSSMA)};
}

evc::Information row_of_track_condition(const lang::PacketView& view) {
  lang::Packet68 p;
  // The return to the initial state uses the row that is accepted in every mode that accepts any condition.
  if (lang::decode(view, p) != lang::Fault::none || p.Q_TRACKINIT.raw == 1)
    return evc::Information::track_conditions_general;
  const auto kind = track_condition_of(p.M_TRACKCOND.raw);
  return kind && horn_or_stopping(*kind) ? evc::Information::track_conditions_horn_stopping
                                         : evc::Information::track_conditions_general;
}

evc::Information row_of_lssma(const lang::PacketView& view) {
  lang::Packet180 p;
  const bool on = lang::decode(view, p) == lang::Fault::none && p.Q_LSSMA.raw == 1;
  return on ? evc::Information::lssma_toggle_on : evc::Information::lssma_toggle_off;
}

// --- Whether the contents have a place, which needs the reference of the message

bool always(const lang::PacketView&) { return true; }
bool from_a_place(const lang::PacketView& view) {
  lang::Packet3 p;
  return lang::decode(view, p) != lang::Fault::none || start_of_validity(p, view.sv.x).has_value();
}
bool at_a_border(const lang::PacketView& view) {
  lang::Packet41 p;
  return lang::decode(view, p) != lang::Fault::none || lang::metres(p.Q_SCALE, p.D_LEVELTR).has_value();
}
bool reports_at_places(const lang::PacketView& view) {
  lang::Packet58 p;
  return lang::decode(view, p) != lang::Fault::none || !p.locations.empty();
}
template <class Text>
bool shown_at_a_place(const lang::PacketView& view) {
  Text p;
  return lang::decode(view, p) != lang::Fault::none || lang::metres(p.Q_SCALE, p.D_TEXTDISPLAY).has_value() ||
         lang::metres(p.Q_SCALE, p.L_TEXTDISPLAY).has_value();
}

// clang-format off
/// The route of each packet from trackside (7.4.2) through the kernel.
constexpr auto kPacketRoutes = [] {
  using enum evc::Information;
  return std::to_array<PacketRoute>({
    // packet                                         turn                  rows of 4.8.3 and 4.8.4                  place                   taken by
    {packet::virtual_balise_cover_marker,             Turn::before,         {},                                      nullptr,                nullptr},
    {packet::system_version_order,                    Turn::version_order,  {system_version_order},                  nullptr,                nullptr},
    {packet::national_values,                         Turn::rest,           {national_values},                       from_a_place,           take_national_values},
    {packet::linking,                                 Turn::linking,        {linking},                               always,                 nullptr},
    {packet::virtual_balise_cover_order,              Turn::rest,           {vbc_order},                             nullptr,                take_cover},
    {packet::level_1_movement_authority,              Turn::authority,      {signalling_speed, movement_authority},  always,                 nullptr},
    {packet::sr_distance_from_loop,                   Turn::rest,           {sr_distance_loop},                      nullptr,                take_SR_distance},
    {packet::level_2_3_movement_authority,            Turn::authority,      {movement_authority},                    always,                 nullptr},
    {packet::repositioning_information,               Turn::rest,           {repositioning},                         always,                 take_repositioning},
    {packet::gradient_profile,                        Turn::rest,           {gradient},                              always,                 store_with_track},
    {packet::static_speed_profile,                    Turn::rest,           {ssp},                                   always,                 store_with_track},
    {packet::traction_system_change,                  Turn::rest,           {track_conditions_general},              always,                 store_with_track},
    {packet::permitted_current_change,                Turn::rest,           {track_conditions_general},              always,                 store_with_track},
    {packet::level_transition_order,                  Turn::level_order,    {level_transition_order},                at_a_border,            nullptr},
    {packet::session_management,                      Turn::rest,           {session_management},                    nullptr,                take_session_order},
    {packet::external_application_data,               Turn::rest,           {external_application_data},             nullptr,                forward_data},
    {packet::radio_network_registration,              Turn::rest,           {radio_network_registration},            nullptr,                take_network},
    {packet::radio_network_type,                      Turn::rest,           {radio_network_registration},            nullptr,                take_network_type},
    {packet::conditional_level_transition_order,      Turn::level_order,    {conditional_level_transition_order},    nullptr,                nullptr},
    {packet::balise_groups_for_sh_area,               Turn::with_authority, {},                                      nullptr,                nullptr},
    {packet::axle_load_speed_profile,                 Turn::rest,           {asp},                                   always,                 store_with_track},
    {packet::permitted_braking_distance,              Turn::rest,           {permitted_braking_distance},            always,                 store_with_track},
    {packet::ma_request_parameters,                   Turn::rest,           {ma_request_params},                     nullptr,                take_ma_request_parameters},
    {packet::position_report_parameters,              Turn::rest,           {position_report_params},                reports_at_places,      take_report_parameters},
    {packet::balise_groups_in_sr_authority,           Turn::with_authority, {},                                      nullptr,                nullptr},
    {packet::inhibition_of_revocable_tsr,             Turn::rest,           {inhibit_revocable_tsr},                 nullptr,                store_with_track},
    {packet::temporary_speed_restriction,             Turn::rest,           {tsr},                                   always,                 store_with_track},
    {packet::tsr_revocation,                          Turn::rest,           {tsr_revocation},                        nullptr,                store_with_track},
    {packet::big_metal_masses,                        Turn::rest,           {track_condition_bmm},                   always,                 store_with_track},
    {packet::track_condition,                         Turn::rest,           row_of_track_condition,                  always,                 store_with_track},
    {packet::station_platforms,                       Turn::rest,           {track_conditions_general},              always,                 store_with_track},
    {packet::route_suitability,                       Turn::rest,           {route_suitability},                     always,                 store_with_track},
    {packet::adhesion_factor,                         Turn::rest,           {adhesion},                              always,                 store_with_track},
    {packet::plain_text,                              Turn::rest,           {plain_text},                            shown_at_a_place<lang::Packet72>, store_text},
    {packet::fixed_text,                              Turn::rest,           {fixed_text},                            shown_at_a_place<lang::Packet76>, store_text},
    {packet::geographical_position,                   Turn::rest,           {geo_position},                          always,                 store_with_track},
    {packet::mode_profile,                            Turn::with_authority, {},                                      nullptr,                nullptr},
    {packet::level_crossing,                          Turn::rest,           {level_crossing},                        always,                 store_with_track},
    {packet::track_ahead_free_to_level_2_3,           Turn::rest,           {taf_up_to_l23},                         always,                 store_with_track},
    {packet::rbc_transition_order,                    Turn::rest,           {rbc_transition_order},                  always,                 take_rbc_transition},
    {packet::danger_for_shunting,                     Turn::rest,           {danger_for_sh},                         nullptr,                store_with_track},
    {packet::radio_infill_area,                       Turn::rest,           {radio_infill_area},                     always,                 store_with_track},
    {packet::eolm,                                    Turn::rest,           {eolm},                                  always,                 take_announcement},
    {packet::stop_shunting_on_desk_opening,           Turn::rest,           {stop_sh_on_desk_opening},               nullptr,                store_with_track},
    {packet::infill_location_reference,               Turn::before,         {infill_location_reference},             nullptr,                nullptr},
    {packet::stop_if_in_sr,                           Turn::rest,           {stop_if_in_sr},                         nullptr,                store_with_track},
    {packet::reversing_area,                          Turn::rest,           {reversing_area},                        always,                 store_with_track},
    {packet::reversing_supervision,                   Turn::rest,           {reversing_supervision},                 always,                 store_with_track},
    {packet::train_running_number_from_rbc,           Turn::rest,           {train_running_number},                  nullptr,                take_running_number},
    {packet::default_gradient_for_tsr,                Turn::rest,           {default_gradient_tsr},                  nullptr,                store_with_track},
    {packet::session_management_riu,                  Turn::rest,           {session_management_riu},                nullptr,                take_neighbour_order},
    {packet::inhibition_of_consistency_reaction,      Turn::before,         {},                                      nullptr,                nullptr},
    {packet::lssma_display,                           Turn::rest,           row_of_lssma,                            nullptr,                take_lssma_order},
    {packet::generic_ls_marker,                       Turn::rest,           {generic_ls_marker},                     nullptr,                store_with_track},
    {packet::national_values_v1,                      Turn::rest,           {national_values},                       nullptr,                taken_with_packet_3},
    {packet::default_information,                     Turn::rest,           {default_balise_info},                   nullptr,                take_default_information},
    {packet::end_of_information,                      Turn::before,         {},                                      nullptr,                nullptr},
  });
}();
// clang-format on

/// The index of the route of each number; kPacketRoutes.size() for an unknown number.
constexpr auto kPlaceOfRoute = [] {
  std::array<std::uint8_t, 256> place{};
  place.fill(static_cast<std::uint8_t>(kPacketRoutes.size()));
  for (std::size_t i = 0; i < kPacketRoutes.size(); ++i) {
    if (place[kPacketRoutes[i].number] != kPacketRoutes.size())
      __builtin_trap();  // not constexpr: two rows do not compile
    place[kPacketRoutes[i].number] = static_cast<std::uint8_t>(i);
  }
  return place;
}();

}  // namespace

const PacketRoute& route_of(const lang::PacketView& view) {
  static constexpr PacketRoute kNone{packet::end_of_information, Turn::rest, {}, nullptr, nullptr};
  if (view.NID_PACKET == packet::fixed_text && view.sv.x == 1) return kNone;  // 6.6.3.1.1.1
  const std::uint8_t i = kPlaceOfRoute[view.NID_PACKET & 0xFFu];
  return i < kPacketRoutes.size() ? kPacketRoutes[i] : kNone;
}

InformationRows rows_of(const PacketRoute& route, const lang::PacketView& view) {
  InformationRows rows;
  const Rows& r = route.rows;
  if (r.count > 0) (void)rows.push_back(r.of_contents != nullptr ? r.of_contents(view) : r.first);
  if (r.count > 1) (void)rows.push_back(r.second);
  return rows;
}

}  // namespace evc::kernel
