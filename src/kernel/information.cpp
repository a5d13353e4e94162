#include "kernel/information.h"

#include "kernel/national_values.h"
#include "kernel/orders.h"
#include "lang/decode.h"
#include "lang/packets/packet_136.h"
#include "lang/packets/packet_3.h"
#include "lang/packets/packet_41.h"
#include "lang/packets/packet_42.h"
#include "lang/packets/packet_46.h"
#include "lang/packets/packet_5.h"
#include "lang/packets/packet_57.h"
#include "lang/packets/packet_58.h"
#include "lang/packets/packet_6.h"
#include "lang/packets/packet_68.h"
#include "lang/si.h"
#include "radio/from_packets.h"
#include "terms/packet_numbers.h"
#include "track/store.h"

namespace evc::kernel {
namespace {

using modes::Acceptance;
using modes::AcceptanceContext;
using modes::Verdict;

/// Facts of the message as a whole that exceptions of the acceptance tables ask for.
struct Evaluation {
  Cycle& cycle;
  const Information& information;
  AcceptanceContext context;
  track::Contents contents;
  track::Reference reference;
  std::uint64_t judge = 0;  // bit n: the n-th packet
  std::uint8_t refused = 0;
  Waiting waiting;
  Clause refused_because;
};

bool judged(const Evaluation& e, std::size_t i) { return ((e.judge >> i) & 1u) != 0; }

AcceptanceContext context_of(const Cycle& cycle, const Information& information) {
  const State& s = cycle.state;
  AcceptanceContext c;
  c.mode = s.mode;
  c.level = s.level.level;
  c.medium = information.medium;
  if (s.level_transition.pending && !s.level_transition.pending->to.same_level(s.level))
    c.announced = s.level_transition.pending->to.level;
  if (cycle.switching_to) c.announced = cycle.switching_to;
  c.train_data_unacknowledged = s.radio.train_data_stamp.has_value();
  c.emergency_stop_pending = s.emergency_stops.any();
  c.exit_from_trip_recognised = procedures::train_trip::exit_recognised(s.train_trip);
  c.desk_open = cycle.in.train.desk_open;
  c.train_data_valid = s.data.train_data_status == DataStatus::valid;
  c.override_active = s.override_.active;
  c.srs = s.srs;
  return c;
}

What what_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::buffered:
      return What::packet_buffered;
    case Verdict::order_stored:
      return What::packet_kept;
    case Verdict::rejected:
      return What::packet_refused;
    case Verdict::only_contact_stored:
      return What::packet_contact_stored;
    case Verdict::accepted:
      break;
  }
  return What::packet_accepted;
}

void tell_packet(Evaluation& e, int NID_PACKET, const Acceptance& a) {
  note(e.cycle, {.what = what_of(a.verdict), .id = NID_PACKET, .clause = a.clause});
  if (a.verdict == Verdict::rejected) {
    ++e.refused;
    e.refused_because = a.clause;
  }
}

/// Judges packet `i`; leaves it to wait when the filter says so. Gives whether it is to be used now.
bool accept_packet(Evaluation& e, std::size_t i, int detail = 0) {
  const lang::PacketView& view = e.information.packets[i];
  const modes::Informations rows = modes::information_of_packet(view.NID_PACKET, detail);
  Acceptance worst{Verdict::accepted, {}};
  for (const evc::Information row : rows) {
    const Acceptance a = modes::accept(row, e.context);
    if (a.verdict != Verdict::accepted) worst = a;
  }
  tell_packet(e, view.NID_PACKET, worst);
  if (worst.verdict == Verdict::buffered) e.waiting.packets |= std::uint64_t{1} << i;
  return worst.verdict == Verdict::accepted;
}

// --- Level transition orders come first (4.8.1.3)

/// Packet 46 has no place and so no length in rear of it.
Distance L_ack(const lang::Packet41& p, const lang::Packet41_levels& e) {
  return lang::metres(p.Q_SCALE, e.L_ACKLEVELTR);
}
Distance L_ack(const lang::Packet46&, const lang::Packet46_levels&) { return {}; }

template <class P>
modes::LevelTable table_of(const P& p) {
  modes::LevelTable table;
  const auto entry = [&p](const auto& e) {
    modes::OrderedLevel level;
    level.level = level_of(e.M_LEVELTR.raw).value_or(Level::L0);  // a spare code was refused before
    level.nid_ntc = level.level == Level::NTC ? static_cast<std::uint8_t>(e.NID_NTC.raw) : std::uint8_t{0};
    level.L_ack = L_ack(p, e);
    return level;
  };
  bool room = table.push_back(entry(p.first_levels()));
  for (const auto& further : p.levels) room = room && table.push_back(entry(further));
  return table;
}

std::optional<procedures::level_transition::Order> order_of(const Evaluation& e, const lang::PacketView& view) {
  procedures::level_transition::Order order;
  if (view.NID_PACKET == packet::conditional_level_transition_order) {
    lang::Packet46 p;
    if (lang::decode(view, p) != lang::Fault::none) return {};
    order.kind = modes::OrderKind::conditional;
    order.table = table_of(p);
    return order;
  }
  lang::Packet41 p;
  if (lang::decode(view, p) != lang::Fault::none) return {};
  const std::optional<Distance> D_LEVELTR = lang::metres(p.Q_SCALE, p.D_LEVELTR);
  order.kind = D_LEVELTR ? modes::OrderKind::announcement : modes::OrderKind::immediate;
  if (D_LEVELTR) order.border = e.reference.place + *D_LEVELTR;
  order.table = table_of(p);
  return order;
}

void evaluate_level_orders(Evaluation& e) {
  bool along = false;
  for (std::size_t i = 0; i < e.information.packets.size(); ++i)
    along = along || e.information.packets[i].NID_PACKET == packet::level_transition_order;
  e.context.level_order_along_or_announced = along || e.cycle.state.level_transition.pending.has_value();
  for (std::size_t i = 0; i < e.information.packets.size(); ++i) {
    const lang::PacketView& view = e.information.packets[i];
    if ((view.NID_PACKET != packet::level_transition_order &&
         view.NID_PACKET != packet::conditional_level_transition_order) ||
        !judged(e, i))
      continue;
    const auto order = order_of(e, view);
    if (!order) continue;
    e.context.order = order->kind;
    if (!accept_packet(e, i)) continue;
    const modes::OrderDecision decision = give_order(e.cycle, *order);
    if (decision.effect == modes::OrderEffect::execute || decision.effect == modes::OrderEffect::announce)
      e.context.announced = decision.to.level;
    else if (decision.cancels_pending)
      e.context.announced.reset();
    e.context.immediate_order_to_1_2_3 =
        decision.effect == modes::OrderEffect::execute && level_1_2_3(decision.to.level);
  }
}

// --- Linking goes before other location data (4.8.1.6)

void evaluate_linking(Evaluation& e, bool infill) {
  State& s = e.cycle.state;
  for (std::size_t i = 0; i < e.information.packets.size(); ++i) {
    const lang::PacketView& view = e.information.packets[i];
    if (view.NID_PACKET != packet::linking || !judged(e, i)) continue;
    lang::Packet5 p;
    if (!accept_packet(e, i) || lang::decode(view, p) != lang::Fault::none) continue;
    balise::LinkingReference reference;
    reference.id = e.reference.group;
    reference.place = e.reference.place;
    reference.NID_C = e.information.group.NID_C;
    reference.orientation_known = e.information.orientation != Direction::unknown;
    reference.infill = infill;
    std::optional<balise::CurrentLrbg> current;
    if (const position::Reference* lrbg = position::lrbg(s.position))
      current = balise::CurrentLrbg{lrbg->id, lrbg->place};
    const balise::Stored stored = balise::store(s.balise.linking, balise::linking_list(p), reference,
                                                position::antenna(s.position, s.train.L_antenna_front), current);
    // The list holds the LRBG: its distance by linking counts, and everything in the message with it (3.6.4.3).
    e.reference.place = stored.reference;
    if (!stored.complete) note(e.cycle, {.what = What::linking_capacity});
  }
}

// --- Everything else

void take_national_values(Evaluation& e, const lang::PacketView& view) {
  State& s = e.cycle.state;
  lang::Packet3 p;
  if (lang::decode(view, p) != lang::Fault::none) return;
  const ReceivedNationalValues received = read(p);
  if (!received.D_VALIDNV) {
    use_national_values(s, received.values, received.areas);
    s.pending_national_values.reset();
    note(e.cycle, {.what = What::national_values_in_force, .clause = "3.18.2.3"_srs});
    return;
  }
  s.pending_national_values =
      PendingNationalValues{e.reference.place + *received.D_VALIDNV, received.values, received.areas};
}

void take_session_order(Evaluation& e, const lang::PacketView& view, bool store_only) {
  State& s = e.cycle.state;
  lang::Packet42 p;
  if (lang::decode(view, p) != lang::Fault::none) return;
  const radio::SessionOrder order = radio::session_order_of(p);
  if (radio::order(s.radio, order, s.mode == Mode::SL, store_only, s.now, e.cycle.outbox))
    note(e.cycle, {.what = order.establish ? What::session_ordered : What::session_termination_ordered,
                   .clause = "3.5.3.5"_srs});
  if (!order.establish) e.cycle.termination_ordered = true;
}

void take_ma_request_parameters(Evaluation& e, const lang::PacketView& view) {
  lang::Packet57 p;
  if (lang::decode(view, p) != lang::Fault::none) return;
  e.cycle.state.radio.ma_request = radio::ma_request_of(p);
}

void take_report_parameters(Evaluation& e, const lang::PacketView& view) {
  lang::Packet58 p;
  if (lang::decode(view, p) != lang::Fault::none) return;
  position::ReportParameters r;
  r.T_CYCLOC = lang::seconds(p.T_CYCLOC);
  r.D_CYCLOC = lang::metres(p.Q_SCALE, p.D_CYCLOC);
  r.M_LOC = p.M_LOC.raw;
  for (const auto& at : p.locations) {
    // 31 places at the most: there is room.
    (void)r.at.push_back({e.reference.place + lang::metres(p.Q_SCALE, at.D_LOC), at.Q_LGTLOC.raw == 1});
  }
  State& s = e.cycle.state;
  position::set_parameters(s.reports, s.position, r);
}

void take_cover(Evaluation& e, const lang::PacketView& view) {
  lang::Packet6 p;
  if (lang::decode(view, p) != lang::Fault::none) return;
  State& s = e.cycle.state;
  if (p.Q_VBCO.raw == 0) {
    balise::remove_cover(s.balise, static_cast<std::uint8_t>(p.NID_VBCMK.raw), p.NID_C.raw);
    return;
  }
  // T_VBC in days (7.5.1.155.1).
  const Duration until = s.now + Duration{86400.0 * p.T_VBC.raw};
  if (!balise::set_cover(s.balise, {static_cast<std::uint8_t>(p.NID_VBCMK.raw), p.NID_C.raw, until}))
    note(e.cycle, {.what = What::cover_capacity});
}

/// Packets whose use is not with the track description.
bool take_here(Evaluation& e, std::size_t i) {
  const lang::PacketView& view = e.information.packets[i];
  switch (view.NID_PACKET) {
    case packet::national_values:
      if (accept_packet(e, i)) take_national_values(e, view);
      return true;
    case packet::virtual_balise_cover_order:
      if (accept_packet(e, i)) take_cover(e, view);
      return true;
    case packet::session_management: {
      lang::Packet42 p;
      if (lang::decode(view, p) == lang::Fault::none) e.context.orders_establishment = p.Q_RBC.raw == 1;
      const auto rows = modes::information_of_packet(packet::session_management);
      const Acceptance a = modes::accept(rows[0], e.context);
      tell_packet(e, packet::session_management, a);
      if (a.verdict == Verdict::accepted || a.verdict == Verdict::only_contact_stored)
        take_session_order(e, view, a.verdict == Verdict::only_contact_stored);
      return true;
    }
    case packet::ma_request_parameters:
      if (accept_packet(e, i)) take_ma_request_parameters(e, view);
      return true;
    case packet::position_report_parameters:
      if (accept_packet(e, i)) take_report_parameters(e, view);
      return true;
    case packet::system_version_order:
    case packet::external_application_data:
    case packet::radio_network_registration:
    case packet::radio_infill_area:
    case packet::eolm:
    case packet::train_running_number_from_rbc:
    case packet::session_management_riu:
    case packet::lssma_display:
    case packet::default_information:
      // The filters judge them; this unit has no use for what they say (CAVEATS).
      (void)accept_packet(e, i);
      return true;
    case packet::virtual_balise_cover_marker:
    case packet::inhibition_of_consistency_reaction:
    case packet::end_of_information:
    case packet::infill_location_reference:
    case packet::linking:
    case packet::level_transition_order:
    case packet::conditional_level_transition_order:
      return true;  // evaluated elsewhere
    default:
      return false;
  }
}

int detail_of(const lang::PacketView& view) {
  if (view.NID_PACKET != packet::track_condition) return 0;
  lang::Packet68 p;
  if (lang::decode(view, p) != lang::Fault::none || p.Q_TRACKINIT.raw == 1) return 0;
  return p.M_TRACKCOND.raw;
}

constexpr bool belongs_to_authority(int NID_PACKET) {
  return NID_PACKET == packet::mode_profile || NID_PACKET == packet::balise_groups_for_sh_area ||
         NID_PACKET == packet::balise_groups_in_sr_authority;
}
constexpr bool is_authority(int NID_PACKET) {
  return NID_PACKET == packet::level_1_movement_authority || NID_PACKET == packet::level_2_3_movement_authority;
}

void evaluate_track_packets(Evaluation& e) {
  for (std::size_t i = 0; i < e.information.packets.size(); ++i) {
    const lang::PacketView& view = e.information.packets[i];
    if (!judged(e, i) || is_authority(view.NID_PACKET) || belongs_to_authority(view.NID_PACKET)) continue;
    if (take_here(e, i)) continue;
    if (accept_packet(e, i, detail_of(view))) (void)track::add(e.contents, view, e.reference);
  }
}

/// The movement authority is judged last: whether SSP and gradient cover it shows only now (4.8.3 [4]).
void evaluate_authority(Evaluation& e) {
  // The authority of a request to shorten is a proposal: take_message decides (3.8.6).
  if (e.information.message != nullptr && e.information.message->NID_MESSAGE == message::request_to_shorten_ma) return;
  for (std::size_t i = 0; i < e.information.packets.size(); ++i) {
    const lang::PacketView& view = e.information.packets[i];
    if (!is_authority(view.NID_PACKET) || !judged(e, i)) continue;
    track::Contents whole = e.contents;
    if (track::add(whole, view, e.reference) != track::Added::added) continue;
    e.context.described_over_whole_ma = track::complete(e.cycle.state.track, whole, e.cycle.here);
    if (view.NID_PACKET == packet::level_1_movement_authority && whole.V_MAIN && *whole.V_MAIN == 0 &&
        !e.contents.infill) {
      // The signalling related speed restriction "0" is a row of its own: a trip order (3.11.6.2).
      const Acceptance trip = modes::accept(evc::Information::signalling_speed, e.context);
      if (trip.verdict == Verdict::accepted) {
        e.contents.V_MAIN = whole.V_MAIN;
        e.cycle.facts.trip_order = true;
        note(e.cycle, {.what = What::trip_ordered, .clause = "3.11.6.2"_srs});
      }
    }
    if (!accept_packet(e, i)) {
      for (std::size_t k = 0; k < e.information.packets.size(); ++k)
        if (belongs_to_authority(e.information.packets[k].NID_PACKET) && judged(e, k) &&
            (e.waiting.packets >> i & 1u) != 0)
          e.waiting.packets |= std::uint64_t{1} << k;
      continue;
    }
    e.contents = whole;
    for (std::size_t k = 0; k < e.information.packets.size(); ++k) {
      // Those of the same part: what stands behind packet 136 belongs to the infill authority.
      const lang::PacketView& other = e.information.packets[k];
      if ((other.NID_PACKET == packet::mode_profile || other.NID_PACKET == packet::balise_groups_for_sh_area) &&
          judged(e, k))
        (void)track::add(e.contents, other, e.reference);
    }
  }
}

void tell_stored(Evaluation& e, const track::Stored& stored) {
  for (const track::Note& n : stored.notes) {
    if (n.what == track::Note::What::stored) continue;
    note(e.cycle, {.what = n.what == track::Note::What::full        ? What::packet_no_room
                           : n.what == track::Note::What::shortened ? What::packet_shortened
                           : !n.clause                              ? What::packet_refused_no_room
                                                                    : What::packet_refused,
                   .id = n.packet,
                   .clause = n.clause});
    if (n.what == track::Note::What::refused) {
      ++e.refused;
      e.refused_because = n.clause;
    }
  }
}

void store_contents(Evaluation& e) {
  Cycle& c = e.cycle;
  State& s = c.state;
  const bool authority = e.contents.ma.has_value();
  const track::Stored stored = track::store(s.track, e.contents, c.here);
  tell_stored(e, stored);
  if (stored.trip_order) c.facts.trip_order = true;
  if (stored.shortened && s.track.ma && !s.track.ma->sections.empty()) {
    // Linking and national values of this very message were stored already; those of the old MA go (3.8.5.1.3).
    cut_other(s, s.track.ma->far_end());
  }
  if (stored.lost_from) {
    cut_other(s, *stored.lost_from < c.here.max_safe_front ? c.here.max_safe_front : *stored.lost_from);
    note(c, {.what = What::track_description_ended, .clause = "3.7.2.3"_srs});
  }
  if (stored.ma_accepted) {
    s.ma_with_trip_order = c.facts.trip_order;
    c.facts.ma_accepted = true;
    if (e.information.medium == Medium::rbc)
      c.ma_from_rbc = true;
    else if (!c.facts.trip_order)
      c.balise_proceed = true;
    note(c, {.what = What::authority_accepted, .clause = "3.8.4"_srs});
  } else if (authority) {
    note(c, {.what = What::authority_refused, .clause = "3.7.2.3"_srs});
  }
  if (e.contents.stop_if_in_sr && *e.contents.stop_if_in_sr) c.facts.stop_if_in_SR = true;
  if (e.contents.danger_for_shunting && *e.contents.danger_for_shunting) c.facts.stop_if_in_SH = true;
  if (e.contents.track_ahead_free_to) {
    c.ma_request_reasons |= radio::kTrackAheadFree;
    c.NID_LTRBG = (std::uint32_t{e.contents.track_ahead_free_to->NID_C} << 14) | e.contents.track_ahead_free_to->NID_BG;
  }
}

/// The information of the radio message itself, beside its packets.
void evaluate_message(Evaluation& e) {
  const lang::MessageToTrainView& message = *e.information.message;
  if (!e.information.judge_message || message.NID_MESSAGE == message::movement_authority ||
      message.NID_MESSAGE == message::movement_authority_shifted)
    return;
  if (message.NID_MESSAGE == message::request_to_shorten_ma)
    e.context.described_over_whole_ma = proposal_is_described(e.cycle, e.information, e.reference);
  for (const evc::Information row : modes::information_of_message(message.NID_MESSAGE)) {
    const Acceptance a = modes::accept(row, e.context);
    if (a.verdict == Verdict::buffered) e.waiting.message = true;
    if (a.verdict == Verdict::rejected) {
      ++e.refused;
      e.refused_because = a.clause;
    }
    if (a.verdict != Verdict::accepted) continue;
    if (const Clause clause = take_message(e.cycle, e.information, message, e.reference)) {
      ++e.refused;
      e.refused_because = clause;
    }
  }
}

}  // namespace

namespace {

/// Everything behind packet 136 is infill (3.6.2.3.1, 7.4.2.32): it counts from another group, which linking names.
struct Infill {
  std::size_t at = 0;  // index of packet 136
  GroupId group;
};
std::optional<Infill> find_infill(const Information& information) {
  for (std::size_t i = 0; i < information.packets.size(); ++i) {
    if (information.packets[i].NID_PACKET != packet::infill_location_reference) continue;
    Infill infill;
    infill.at = i;
    lang::Packet136 p;
    if (lang::decode(information.packets[i], p) != lang::Fault::none) return infill;
    infill.group = {p.Q_NEWCOUNTRY.raw == 1 ? p.NID_C.raw : information.group.NID_C, p.NID_BG.raw};
    return infill;
  }
  return std::nullopt;
}

void tell_message(Evaluation& e) {
  const bool refused = e.refused != 0;
  note(e.cycle, {.what = refused && e.refused_because ? What::message_refused
                         : refused                    ? What::message_refused_no_room
                         : e.waiting.any()            ? What::message_buffered
                                                      : What::message_accepted,
                 .id = e.information.message->NID_MESSAGE,
                 .clause = refused ? e.refused_because : Clause{}});
}

void evaluate_part(Evaluation& e) {
  evaluate_level_orders(e);
  evaluate_linking(e, e.contents.infill.has_value());
  evaluate_track_packets(e);
  evaluate_authority(e);
}

/// The infill part, after the rest of the message (4.8.1.5).
void evaluate_infill(Evaluation& e, const Infill& infill, std::uint64_t judge) {
  // Linking of this very message also gives the place of the group.
  std::optional<Place> place;
  for (const balise::Link& link : e.cycle.state.balise.linking.links)
    if (link.id == infill.group) place = link.place;
  if (!place) {
    note(e.cycle, {.what = What::infill_refused, .id = infill.group.NID_BG, .clause = "3.6.2.3.1"_srs});
    return;
  }
  e.judge = judge;
  e.context.infill = true;
  e.reference.place = *place;
  e.reference.group = infill.group;
  e.contents = track::Contents{};
  e.contents.medium = e.reference.medium;
  e.contents.time = e.information.time;
  e.contents.reference = *place;
  e.contents.infill = *place;
  evaluate_part(e);
  store_contents(e);
}

}  // namespace

Waiting evaluate(Cycle& cycle, const Information& information) {
  Evaluation e{cycle, information, context_of(cycle, information), {}, {}, 0, 0, {}, {}};
  e.reference = {information.reference, information.orientation, information.group, information.medium,
                 cycle.state.now};
  e.contents.medium = e.reference.medium;
  e.contents.time = information.time;
  e.contents.reference = information.reference;
  const std::optional<Infill> infill = find_infill(information);
  // Packets before packet 136; bit n stands for the n-th packet.
  const std::uint64_t before = infill ? (std::uint64_t{1} << infill->at) - 1u : ~std::uint64_t{0};
  e.judge = information.judge_packets & before;
  evaluate_part(e);
  if (information.message != nullptr) evaluate_message(e);
  store_contents(e);
  if (infill) evaluate_infill(e, *infill, information.judge_packets & ~before);
  if (information.message != nullptr) tell_message(e);
  return e.waiting;
}

}  // namespace evc::kernel
