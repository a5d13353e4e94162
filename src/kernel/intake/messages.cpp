#include "kernel/intake/messages.h"

#include "kernel/intake/manoeuvre.h"
#include "kernel/intake/routes.h"
#include "kernel/intake/shortening.h"
#include "kernel/stored.h"
#include "lang/decode.h"
#include "lang/messages.h"
#include "lang/si.h"
#include "terms/message_numbers.h"

namespace evc::kernel {
namespace {

Clause take_conditional_stop(Evaluation& e, const lang::MessageToTrainView& view) {
  State& s = e.r.state;
  lang::Message15 m;
  if (lang::decode(view, m) != lang::Fault::none) return "3.16.3.1.1"_srs;
  // Each is answered (3.10.1.4), also one whose direction is not that of the train, or not known.
  const bool unknown = e.information.orientation == Direction::unknown;
  const std::optional<Place> stop = track::stop_location(m, e.reference);
  const protection::Answer answer =
      stop ? protection::accept_conditional(s.emergency_stops, s.track, m.NID_EM.raw, *stop,
                                            e.information.min_safe_front, e.r.out.here)
           : protection::Answer{.clause = unknown ? "3.6.3.1.4"_srs : "3.6.3.1.3"_srs};
  std::uint8_t Q = answer.Q_EMERGENCYSTOP;
  if (answer.accepted) cut_beyond(s, *stop);
  if (view.sv.x == 1) Q = protection::Q_EMERGENCYSTOP_for_version_1(Q);
  radio::answer_emergency_stop(m.NID_EM.raw, Q, e.r.outbox);
  e.r.log.note({.what = answer.accepted ? What::emergency_stop_accepted
                        : stop          ? What::emergency_stop_place_passed
                                        : What::emergency_stop_other_direction,
                .id = m.NID_EM.raw,
                .clause = answer.accepted ? "3.10.2.2"_srs : answer.clause});
  return answer.accepted ? Clause{} : answer.clause;
}

Clause take_unconditional_stop(Evaluation& e, const lang::MessageToTrainView& view) {
  lang::Message16 m;
  if (lang::decode(view, m) != lang::Fault::none) return "3.16.3.1.1"_srs;
  const protection::Answer answer = protection::accept_unconditional(e.r.state.emergency_stops, m.NID_EM.raw);
  // Of this answer the code is the same in version 1 (7.5.1.107).
  radio::answer_emergency_stop(m.NID_EM.raw, answer.Q_EMERGENCYSTOP, e.r.outbox);
  e.r.out.ues_accepted = answer.accepted;
  e.r.out.ues_received = true;
  e.r.log.note({.what = What::emergency_stop_unconditional, .id = m.NID_EM.raw, .clause = "3.10.2.3"_srs});
  return answer.accepted ? Clause{} : answer.clause;
}

Clause take_revocation(Evaluation& e, const lang::MessageToTrainView& view) {
  lang::Message18 m;
  if (lang::decode(view, m) != lang::Fault::none) return "3.16.3.1.1"_srs;
  if (!protection::revoke(e.r.state.emergency_stops, m.NID_EM.raw)) return "3.10.3.3"_srs;
  e.r.log.note({.what = What::emergency_stop_revoked, .id = m.NID_EM.raw, .clause = "3.10.3.3"_srs});
  return {};
}

/// SR authorisation: D_SR from the estimated front end, and the list of packet 63 (4.4.11.1.3.2).
Clause take_SR_authorisation(Evaluation& e, const lang::MessageToTrainView& view) {
  State& s = e.r.state;
  lang::Message2 m;
  if (lang::decode(view, m) != lang::Fault::none) return "3.16.3.1.1"_srs;
  e.r.out.SR_authorised = true;
  set_SR_distance(s, e.r.out.here, lang::metres(m.Q_SCALE, m.D_SR));
  s.staff_responsible.by_rbc = true;
  ++s.revision;
  s.track.sr_list.reset();
  for (const lang::PacketView& p : e.information.packets) {
    if (p.NID_PACKET != packet::balise_groups_in_sr_authority) continue;
    if (const std::optional<track::GroupList> list = track::sr_list(p, e.reference)) s.track.sr_list = list;
  }
  return {};
}

Clause take_track_ahead_free(Evaluation& e, const lang::MessageToTrainView& view) {
  lang::Message34 m;
  if (lang::decode(view, m) != lang::Fault::none) return "3.16.3.1.1"_srs;
  if (e.reference.orientation == Direction::unknown) return "3.6.3.1.4"_srs;
  if (!track::valid_direction(m.Q_DIR.raw, e.reference.orientation)) return "3.6.3.1.3"_srs;
  const Place from =
      track::shifted(e.reference, lang::metres(m.Q_SCALE, m.D_REF)).place + lang::metres(m.Q_SCALE, m.D_TAFDISPLAY);
  const Place to = from + lang::metres(m.Q_SCALE, m.L_TAFDISPLAY);
  protection::request(e.r.state.track_ahead_free, from, to);
  return {};
}

Clause take_train_data_acknowledgement(Evaluation& e, const lang::MessageToTrainView& view) {
  lang::Message8 m;
  if (lang::decode(view, m) != lang::Fault::none) return "3.16.3.1.1"_srs;
  radio::State& radio = e.r.state.radio;
  const bool supervising = e.information.sender == SessionRole::supervising;
  radio::receive_train_data_ack(supervising ? radio.supervising : radio.other, m.T_TRAIN_REF.raw);
  return {};
}

Clause take_coordinate_system(Evaluation& e, const lang::MessageToTrainView& view) {
  lang::Message45 m;
  if (lang::decode(view, m) != lang::Fault::none) return "3.16.3.1.1"_srs;
  const Direction nominal = m.Q_ORIENTATION.raw == 1 ? Direction::nominal : Direction::reverse;
  return position::assign_orientation(e.r.state.position, e.information.group, nominal) ? Clause{} : "3.4.2.3.3.8"_srs;
}

/// The answer names the request that waits for one (4.6.3 [6]): others come too late, or are another train's. In SM it
/// need not (4.8.4, without [14]).
bool answers_SH_request(const State& s, const lang::var::T_TRAIN& T_TRAIN_REF) {
  if (s.mode == Mode::SM) return true;
  return s.shunting.waits_for_answer && s.radio.shunting_request_stamp == T_TRAIN_REF.raw;
}
Clause take_SH_refused(Evaluation& e, const lang::MessageToTrainView& view) {
  lang::Message27 m;
  if (lang::decode(view, m) != lang::Fault::none) return "3.16.3.1.1"_srs;
  if (!answers_SH_request(e.r.state, m.T_TRAIN_REF)) return "4.6.3"_srs;
  e.r.out.SH_refused = true;
  return {};
}
/// The list of packet 49 takes the place of a stored one; without it there is none (5.6.2.2 E090).
Clause take_SH_authorised(Evaluation& e, const lang::MessageToTrainView& view) {
  State& s = e.r.state;
  lang::Message28 m;
  if (lang::decode(view, m) != lang::Fault::none) return "3.16.3.1.1"_srs;
  if (!answers_SH_request(s, m.T_TRAIN_REF) || !e.r.out.here.standstill) return "4.6.3"_srs;
  e.r.out.SH_authorised = true;
  track::AuthorityContents& area = e.r.scratch.proposal;
  area = {};
  for (const lang::PacketView& p : e.information.packets)
    if (p.NID_PACKET == packet::balise_groups_for_sh_area) (void)track::add(area, e.information.time, p, e.reference);
  s.track.sh_list = area.sh_list;
  return {};
}

/// 5.21.2.2 E215. Of an authorisation (4) the packets are used, after judge_manoeuvre.
Clause take_SM_refused(Evaluation& e, const lang::MessageToTrainView& view) {
  lang::Message5 m;
  if (lang::decode(view, m) != lang::Fault::none) return "3.16.3.1.1"_srs;
  if (!answers_manoeuvre_request(e.r.state, m.T_TRAIN_REF.raw)) return "4.8.4"_srs.exception(14);
  e.r.out.SM_refused = true;
  return {};
}
Clause take_consist_length_acknowledgement(Evaluation& e, const lang::MessageToTrainView& view) {
  lang::Message7 m;
  if (lang::decode(view, m) != lang::Fault::none) return "3.16.3.1.1"_srs;
  radio::receive_consist_length_ack(e.r.state.radio.supervising, m.T_TRAIN_REF.raw);
  return {};
}

// Only the fact is used.
/// 4.8.4 [1]: information of the RBC that is received later has a later time stamp (3.16.3.3.3).
Clause take_exit_from_trip(Evaluation& e, const lang::MessageToTrainView&) {
  e.r.out.exit_from_trip = true;
  return {};
}
Clause take_train_rejected(Evaluation& e, const lang::MessageToTrainView&) {
  e.r.out.train_rejected = true;
  return {};
}
Clause take_train_accepted(Evaluation& e, const lang::MessageToTrainView&) {
  e.r.out.train_accepted = true;
  return {};
}
Clause take_position_confirmed(Evaluation& e, const lang::MessageToTrainView&) {
  e.r.out.position_confirmed = true;
  return {};
}

using TakeMessage = Clause (*)(Evaluation&, const lang::MessageToTrainView&);
/// The route of a radio message itself, without its packets: its row of 4.8.3 and 4.8.4, and the function that executes
/// it; none where its packets or the session (radio/) have all of its contents.
struct MessageRoute {
  message::ToTrain number;
  evc::Information row;
  TakeMessage take;
};

// clang-format off
/// 8.4.4. The general message (24) and the authorities (3, 4, 33, 37) have no row of their own: their packets have.
constexpr auto kMessageRoutes = [] {
  using enum evc::Information;
  return std::to_array<MessageRoute>({
    {message::sr_authorisation,                 sr_authorisation,             take_SR_authorisation},
    {message::sm_refused,                       sm_refused,                   take_SM_refused},
    {message::consist_length_acknowledged,      safe_consist_length_ack,      take_consist_length_acknowledgement},
    {message::exit_from_trip_recognised,        exit_trip_recognition,        take_exit_from_trip},
    {message::train_data_acknowledged,          train_data_ack,               take_train_data_acknowledgement},
    {message::request_to_shorten_ma,            ma_shortening_request,        take_shortening},
    {message::conditional_emergency_stop,       conditional_emergency_stop,   take_conditional_stop},
    {message::unconditional_emergency_stop,     unconditional_emergency_stop, take_unconditional_stop},
    {message::emergency_stop_revoked,           emergency_stop_revocation,    take_revocation},
    {message::sh_refused,                       sh_refused,                   take_SH_refused},
    {message::sh_authorised,                    sh_authorised,                take_SH_authorised},
    {message::trackside_system_version,         trackside_system_version,     nullptr},
    {message::track_ahead_free_request,         track_ahead_free_request,     take_track_ahead_free},
    {message::session_initiated_by_rbc,         session_initiation,           nullptr},
    {message::session_termination_acknowledged, session_termination_ack,      nullptr},
    {message::train_rejected,                   train_rejected,               take_train_rejected},
    {message::train_accepted,                   train_accepted,               take_train_accepted},
    {message::som_position_confirmed,           som_position_confirmed,       take_position_confirmed},
    {message::coordinate_system_assigned,       coordinate_system_assignment, take_coordinate_system},
  });
}();
// clang-format on

constexpr const MessageRoute* route_of(std::uint8_t NID_MESSAGE) {
  for (const MessageRoute& route : kMessageRoutes)
    if (route.number == NID_MESSAGE) return &route;
  return {};
}

}  // namespace

bool has_place(std::uint8_t NID_MESSAGE) {
  switch (NID_MESSAGE) {
    case message::movement_authority:
    case message::movement_authority_shifted:
    case message::sm_authorised:
    case message::infill_movement_authority:
    case message::request_to_shorten_ma:
    case message::conditional_emergency_stop:
    case message::track_ahead_free_request:
      return true;
    default:
      return false;
  }
}

std::optional<evc::Information> row_of_message(std::uint8_t NID_MESSAGE) {
  const MessageRoute* const route = route_of(NID_MESSAGE);
  return route != nullptr ? std::optional(route->row) : std::nullopt;
}

Clause take_message(Evaluation& e, const lang::MessageToTrainView& message) {
  const MessageRoute* const route = route_of(message.NID_MESSAGE);
  return route != nullptr && route->take != nullptr ? route->take(e, message) : Clause{};
}

}  // namespace evc::kernel
