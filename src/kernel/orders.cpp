#include "kernel/orders.h"

#include "kernel/supervise.h"
#include "lang/decode.h"
#include "lang/messages.h"
#include "lang/si.h"
#include "sdm/supervision.h"
#include "terms/packet_numbers.h"
#include "track/services.h"
#include "track/store.h"

namespace evc::kernel {

modes::AvailableLevels available_levels(const Cycle& cycle) {
  modes::AvailableLevels available;
  available.fitted = cycle.state.fitted_levels;
  available.national_systems[0] = cycle.in.national_system.available;
  return available;
}

modes::OrderDecision give_order(Cycle& cycle, const procedures::level_transition::Order& order) {
  State& s = cycle.state;
  s.level_table = order.table;
  const modes::OrderDecision decision = modes::judge(order.kind, order.table, s.level, s.mode, available_levels(cycle));
  // The procedure looks at one order a cycle, the last one; an earlier one of the same cycle is replaced
  // (5.10.1.6), but never an order that is to be executed by one that is not.
  const bool executes = decision.effect == modes::OrderEffect::execute;
  if (executes || !cycle.switching_to) {
    cycle.order = order;
    cycle.switching_to = executes ? std::optional<Level>(decision.to.level) : std::nullopt;
  }
  return decision;
}

void use_national_values(State& state, const train::NationalValues& values,
                         const InplaceVector<std::uint16_t, 32>& areas) {
  state.national_values = values;
  state.national_areas = areas;
  ++state.revision;
}

void advance_national_values(Cycle& cycle) {
  State& s = cycle.state;
  if (!s.pending_national_values || cycle.here.est_front < s.pending_national_values->from) return;
  use_national_values(s, s.pending_national_values->values, s.pending_national_values->areas);
  s.pending_national_values.reset();
  note(cycle, {.what = What::national_values_in_force, .clause = "3.18.2.3"_srs});
}

void leave_area(Cycle& cycle, std::uint16_t NID_C) {
  State& s = cycle.state;
  if (s.national_areas.empty()) return;
  for (const std::uint16_t area : s.national_areas)
    if (area == NID_C) return;
  use_national_values(s, train::NationalValues{}, {});
  note(cycle, {.what = What::national_values_default, .clause = "3.18.2.5"_srs});
}

track::Contents proposal(const Information& information, const track::Reference& reference) {
  track::Contents proposed;
  proposed.medium = reference.medium;
  proposed.time = information.time;
  proposed.reference = information.reference;
  for (const lang::PacketView& p : information.packets)
    if (p.NID_PACKET == packet::level_2_3_movement_authority || p.NID_PACKET == packet::mode_profile ||
        p.NID_PACKET == packet::balise_groups_for_sh_area)
      (void)track::add(proposed, p, reference);
  return proposed;
}

bool proposal_is_described(const Cycle& cycle, const Information& information, const track::Reference& reference) {
  const track::Contents proposed = proposal(information, reference);
  return proposed.ma && track::complete(cycle.state.track, proposed, cycle.here);
}

void cut_other(State& state, Place beyond) {
  balise::clear_beyond(state.balise.linking, beyond);
  if (state.pending_national_values && state.pending_national_values->from > beyond)
    state.pending_national_values.reset();
}

namespace {

Clause take_conditional_stop(Cycle& cycle, const Information& information, const lang::MessageToTrainView& view,
                             const track::Reference& reference) {
  State& s = cycle.state;
  lang::Message15 m;
  if (lang::decode(view, m) != lang::Fault::none) return "3.16.3.1.1"_srs;
  if (information.orientation == Direction::unknown) return "3.6.3.1.4"_srs;
  const std::optional<Place> stop = track::stop_location(m, reference);
  const protection::Answer answer = stop ? protection::accept_conditional(s.emergency_stops, s.track, m.NID_EM.raw,
                                                                          *stop, information.min_safe_front, cycle.here)
                                         : protection::Answer{.clause = "3.6.3.1.3"_srs};
  std::uint8_t Q = answer.Q_EMERGENCYSTOP;
  if (answer.accepted) cut_other(s, *stop);
  if (information.sv.x == 1) Q = protection::Q_EMERGENCYSTOP_for_version_1(Q);
  radio::answer_emergency_stop(m.NID_EM.raw, Q, cycle.outbox);
  note(cycle, {.what = answer.accepted ? What::emergency_stop_accepted
                       : stop          ? What::emergency_stop_place_passed
                                       : What::emergency_stop_other_direction,
               .id = m.NID_EM.raw,
               .clause = answer.accepted ? "3.10.2.2"_srs : answer.clause});
  return answer.accepted ? Clause{} : answer.clause;
}

Clause take_unconditional_stop(Cycle& cycle, const lang::MessageToTrainView& view, const Information& information) {
  lang::Message16 m;
  if (lang::decode(view, m) != lang::Fault::none) return "3.16.3.1.1"_srs;
  const protection::Answer answer = protection::accept_unconditional(cycle.state.emergency_stops, m.NID_EM.raw);
  std::uint8_t Q = answer.Q_EMERGENCYSTOP;
  if (information.sv.x == 1) Q = protection::Q_EMERGENCYSTOP_for_version_1(Q);
  radio::answer_emergency_stop(m.NID_EM.raw, Q, cycle.outbox);
  cycle.facts.ues_accepted = answer.accepted;
  cycle.facts.ues_received = true;
  note(cycle, {.what = What::emergency_stop_unconditional, .id = m.NID_EM.raw, .clause = "3.10.2.3"_srs});
  return answer.accepted ? Clause{} : answer.clause;
}

Clause take_revocation(Cycle& cycle, const lang::MessageToTrainView& view) {
  lang::Message18 m;
  if (lang::decode(view, m) != lang::Fault::none) return "3.16.3.1.1"_srs;
  if (!protection::revoke(cycle.state.emergency_stops, m.NID_EM.raw)) return "3.10.3.3"_srs;
  note(cycle, {.what = What::emergency_stop_revoked, .id = m.NID_EM.raw, .clause = "3.10.3.3"_srs});
  return {};
}

/// SR authorisation: D_SR from the estimated front end, and the list of packet 63 (4.4.11.1.3.2).
Clause take_SR_authorisation(Cycle& cycle, const Information& information, const lang::MessageToTrainView& view,
                             const track::Reference& reference) {
  State& s = cycle.state;
  lang::Message2 m;
  if (lang::decode(view, m) != lang::Fault::none) return "3.16.3.1.1"_srs;
  cycle.SR_authorised = true;
  const std::optional<Distance> D_SR = lang::metres(m.Q_SCALE, m.D_SR);
  s.staff_responsible.end.reset();
  s.staff_responsible.by_rbc = true;
  ++s.revision;
  if (D_SR) s.staff_responsible.end = cycle.here.est_front + *D_SR;
  s.track.sr_list.reset();
  for (const lang::PacketView& p : information.packets) {
    if (p.NID_PACKET != packet::balise_groups_in_sr_authority) continue;
    track::Contents list;
    if (track::add(list, p, reference) == track::Added::added) s.track.sr_list = list.sr_list;
  }
  return {};
}

/// Message 9: granted only when the authority is described and the train would not have to brake for it (3.8.6.2).
Clause take_shortening(Cycle& cycle, const Information& information, const lang::MessageToTrainView& view,
                       const track::Reference& reference) {
  State& s = cycle.state;
  track::Contents proposed = proposal(information, reference);
  const bool granted = proposed.ma && !proposed.ma->sections.empty() &&
                       track::complete(s.track, proposed, cycle.here) &&
                       can_stop_before(cycle, cycle.derived, proposed);
  radio::answer_shortening(granted, view.T_TRAIN.raw, cycle.outbox);
  note(cycle, {.what = granted ? What::shortening_granted : What::shortening_rejected, .clause = "3.8.6"_srs});
  if (!granted) return "3.8.6.2"_srs;
  proposed.ma_is_shortening_request = true;
  (void)track::store(s.track, proposed, cycle.here);
  cut_other(s, proposed.ma->far_end());
  return {};
}

Clause take_track_ahead_free(Cycle& cycle, const lang::MessageToTrainView& view, const track::Reference& reference) {
  lang::Message34 m;
  if (lang::decode(view, m) != lang::Fault::none) return "3.16.3.1.1"_srs;
  if (reference.orientation == Direction::unknown) return "3.6.3.1.4"_srs;
  if (!track::valid_direction(m.Q_DIR.raw, reference.orientation)) return "3.6.3.1.3"_srs;
  const Place from =
      track::shifted(reference, lang::metres(m.Q_SCALE, m.D_REF)).place + lang::metres(m.Q_SCALE, m.D_TAFDISPLAY);
  const Place to = from + lang::metres(m.Q_SCALE, m.L_TAFDISPLAY);
  protection::request(cycle.state.track_ahead_free, from, to);
  return {};
}

}  // namespace

Clause take_message(Cycle& cycle, const Information& information, const lang::MessageToTrainView& message,
                    const track::Reference& reference) {
  State& s = cycle.state;
  switch (message.NID_MESSAGE) {
    case message::sr_authorisation:
      return take_SR_authorisation(cycle, information, message, reference);
    case message::exit_from_trip_recognised:
      cycle.exit_from_trip = true;
      s.radio.exit_from_trip = message.T_TRAIN.raw;
      return {};
    case message::train_data_acknowledged: {
      lang::Message8 m;
      if (lang::decode(message, m) != lang::Fault::none) return "3.16.3.1.1"_srs;
      radio::receive_train_data_ack(s.radio, m.T_TRAIN_REF.raw);
      cycle.train_data_acknowledged = true;
      return {};
    }
    case message::request_to_shorten_ma:
      return take_shortening(cycle, information, message, reference);
    case message::conditional_emergency_stop:
      return take_conditional_stop(cycle, information, message, reference);
    case message::unconditional_emergency_stop:
      return take_unconditional_stop(cycle, message, information);
    case message::emergency_stop_revoked:
      return take_revocation(cycle, message);
    case message::sh_refused:
      cycle.SH_refused = true;
      return {};
    case message::sh_authorised:
      cycle.SH_authorised = true;
      return {};
    case message::track_ahead_free_request:
      return take_track_ahead_free(cycle, message, reference);
    case message::train_rejected:
      cycle.train_rejected = true;
      return {};
    case message::train_accepted:
      cycle.train_accepted = true;
      return {};
    case message::som_position_confirmed:
      cycle.position_confirmed = true;
      return {};
    case message::coordinate_system_assigned: {
      lang::Message45 m;
      if (lang::decode(message, m) != lang::Fault::none) return "3.16.3.1.1"_srs;
      const Direction nominal = m.Q_ORIENTATION.raw == 1 ? Direction::nominal : Direction::reverse;
      return position::assign_orientation(s.position, information.group, nominal) ? Clause{} : "3.4.2.3.3.8"_srs;
    }
    default:
      return {};
  }
}

}  // namespace evc::kernel
