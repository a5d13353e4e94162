#include "kernel/intake/radio_messages.h"

#include "kernel/here.h"
#include "kernel/intake/buffer.h"
#include "kernel/intake/filter.h"
#include "kernel/intake/manoeuvre.h"
#include "kernel/intake/routes.h"
#include "kernel/intake/system_version.h"
#include "kernel/manoeuvre.h"
#include "kernel/radio_address.h"
#include "lang/decode.h"
#include "lang/instances.h"
#include "lang/messages.h"
#include "lang/si.h"

namespace evc::kernel {
namespace {

/// Reference and orientation of a radio message: its NID_LRBG, if it is remembered (3.6.2.2.2 c). With an LRBG that is
/// unknown (3.6.2.2.2.3) or not remembered only information without a place can be used, such as an unconditional
/// emergency stop.
void refer(Information& information, const State& state, const lang::MessageToTrainView& view) {
  information.located = false;
  const auto id = lang::group(view.NID_LRBG);
  if (!id) return;
  information.group = {id->NID_C, id->NID_BG};
  const position::Reference* reference = position::find(state.position, information.group);
  if (reference == nullptr) return;
  information.located = true;
  information.reference = reference->place;
  information.orientation = reference->orientation;
}

template <class M>
Distance D_REF_of(const lang::MessageToTrainView& view) {
  M m;
  return lang::decode(view, m) == lang::Fault::none ? lang::metres(m.Q_SCALE, m.D_REF) : Distance{};
}
/// The reference of messages 4 and 33 is D_REF away from the LRBG (3.6.3.2.5), in its nominal direction (7.5.1.22).
Distance D_REF_of(const lang::MessageToTrainView& view) {
  if (view.NID_MESSAGE == message::movement_authority_shifted) return D_REF_of<lang::Message33>(view);
  if (view.NID_MESSAGE == message::sm_authorised) return D_REF_of<lang::Message4>(view);
  return {};
}
void shift_reference(Information& information, Distance D_REF) {
  information.reference =
      information.orientation == Direction::reverse ? information.reference - D_REF : information.reference + D_REF;
}

/// Nothing of the message can be used.
void refuse(Reception& r, const lang::MessageToTrainView& view, Clause clause) {
  for (const lang::PacketView& packet : view.packets)
    r.log.note({.what = What::packet_refused, .id = packet.NID_PACKET, .clause = clause});
  r.log.note({.what = What::message_refused, .id = view.NID_MESSAGE, .clause = clause});
}

struct Sender {
  radio::Peer peer{};
  SessionRole role = SessionRole::supervising;
  bool infill_unit() const { return radio::is_infill_unit(peer); }
};

/// 4.12 [2]: what braked against a movement in the orientation that the train had is revoked when SM is entered, and so
/// is what asked for it. In SM no mode is entered: the driver acknowledges.
void revoke_brakes_of_orientation(State& s) {
  if (s.mode == Mode::SM) return;
  s.guards.roll_away = s.guards.reverse_movement = {};
  brakes::on_turn(s.brakes);
}

/// Whether the authority of an authorisation was accepted; if not, everything is as it was before, but what turning
/// deleted.
void tell_manoeuvre(Reception& r, const ManoeuvreBefore& before) {
  State& s = r.state;
  const bool turned = before.opposite != s.manoeuvre.opposite;
  if (!r.out.SM_authorised) {
    restore_manoeuvre(s, before);
    r.out.here = here(s);
  } else if (turned) {
    r.out.train_turned = true;
    revoke_brakes_of_orientation(s);
    r.log.note({.what = What::train_turned, .clause = "4.4.21"_srs});
  }
}

void evaluate_radio(Reception& r, const lang::MessageToTrainView& view, std::span<const std::uint8_t> bytes,
                    const Sender& from) {
  State& s = r.state;
  Information information;
  information.medium = from.infill_unit() ? Medium::riu : Medium::rbc;
  information.sender = from.role;
  information.message = &view;
  information.M_VERSION = s.radio.session(from.peer).M_VERSION;
  information.min_safe_front = r.out.here.min_safe_front;
  information.time = radio::time_of(view.T_TRAIN.raw, s.now);  // timers count from the time stamp (3.8.4.2.1)
  refer(information, s, view);
  if (!information.located && has_place(view.NID_MESSAGE)) return refuse(r, view, "3.6.2.2.2"_srs);
  const Distance D_REF = D_REF_of(view);
  const bool directed = D_REF != Distance{};
  if (directed && information.orientation == Direction::unknown) return refuse(r, view, "3.6.3.1.4"_srs);
  std::optional<ManoeuvreBefore> before;
  if (view.NID_MESSAGE == message::sm_authorised) {
    const ManoeuvreAuthorisation judged = judge_manoeuvre(r, information, view);
    if (judged.refused) return refuse(r, view, judged.refused);
    before = begin_manoeuvre(s, judged.opposite, judged.V_SM);
    r.out.here = here(s);
    information.min_safe_front = r.out.here.min_safe_front;
    refer(information, s, view);  // against the orientation of now
  }
  shift_reference(information, D_REF);
  (void)gather(information, view.packets, &r.log);  // all packets of a message fit
  drop_superseded(information, &r.log);
  const Waiting waiting = evaluate(r, information);
  if (before) tell_manoeuvre(r, *before);
  if (waiting.any()) add_bits(keep(r, information, waiting), bytes);
}

/// Message 37 is sent by radio infill units only (8.7.15): that of an RBC is judged by its row of 4.8.3, and where that
/// accepts it (level 1) there is no session with an infill unit that sent it (3.9.3.4). It says nothing about the
/// contact with the RBC and is not acknowledged.
void refuse_radio_infill(Reception& r, const lang::MessageToTrainView& view) {
  modes::AcceptanceContext context;
  context.level = r.state.level.level;
  context.medium = Medium::riu;
  const modes::Acceptance a = modes::accept_by_level(evc::Information::infill_location_reference, context);
  refuse(r, view, a.verdict == modes::Verdict::accepted ? "3.9.3.4"_srs : a.clause);
}

/// 6.6.3.4.1.3 (and 6.6.5.3.4, 6.6.5.4.3, 6.6.5.5.3): an RBC up to 2.2, which has no code for SM, is left at once.
void leave_in_manoeuvre(Reception& r, radio::Peer peer) {
  radio::Session& session = r.state.radio.session(peer);
  if (r.state.mode != Mode::SM || radio::knows_manoeuvres(session)) return;
  const radio::Addressed to(r.outbox, peer);
  radio::terminate(session, r.state.now, r.outbox);
  r.log.note({.what = What::session_termination_ordered, .clause = "6.6.3.4.1.3"_srs});
}

void receive_version(Reception& r, const lang::MessageToTrainView& view, const Sender& from) {
  State& s = r.state;
  lang::Message32 m;
  if (lang::decode(view, m) != lang::Fault::none) return;
  const auto M_VERSION = static_cast<std::uint8_t>(m.M_VERSION.raw);
  const bool established = radio::receive_version(s.radio, M_VERSION, s.now, r.outbox, from.peer);
  if (established) leave_in_manoeuvre(r, from.peer);
  if (!from.infill_unit()) return operate_version_of_rbc(r, s.level.level);
  if (!established) return;
  r.log.note({.what = What::session_established, .clause = "3.5.3.7"_srs});
  operate_version_of_infill_unit(r, M_VERSION);
}

/// The checks of the session (3.16.3); false: the message is rejected. `known`: there is a session with the sender.
bool passes(Reception& r, const radio::Header& header, const Sender& from, bool known) {
  const radio::Rejected rejected =
      known ? radio::receive(r.state.radio, header, r.state.now, r.outbox, from.peer) : radio::Rejected::no_session;
  if (rejected != radio::Rejected::no) {
    r.log.note({.what = What::message_rejected, .id = header.NID_MESSAGE, .clause = radio::clause(rejected)});
    return false;
  }
  if (!from.infill_unit() && from.role == SessionRole::supervising) r.out.new_radio_message = true;
  return true;
}

/// Reported to an RBC that the unit knows (3.16.4.1).
void reject_inconsistent(Reception& r, std::uint8_t NID_MESSAGE, const Sender& from, bool known) {
  if (known && !from.infill_unit()) radio::receive_inconsistent(r.state.radio, from.peer);
  r.log.note({.what = What::message_rejected, .id = NID_MESSAGE, .clause = "3.16.3.1.1"_srs});
}

/// 3.17.3.11 b: of a message of a later Y only the contents are ignored. It is received as any other: order of the
/// stamps, acknowledgement, contact.
void receive_unknown(Reception& r, const lang::MessageToTrainView& view, std::span<const std::uint8_t> bytes,
                     const Sender& from, bool known) {
  const std::optional<lang::MessageHead> head = lang::head_of_message_to_train(bytes);
  if (!head) return reject_inconsistent(r, view.NID_MESSAGE, from, known);
  if (!passes(r, {view.NID_MESSAGE, head->T_TRAIN, head->M_ACK}, from, known)) return;
  r.log.note({.what = What::message_unknown, .id = view.NID_MESSAGE, .clause = "3.17.3.11"_srs});
}

/// Message 38 from version 2.3 on (8.7.16); before it was another one.
bool acknowledges_session(const lang::MessageToTrainView& view) {
  return view.NID_MESSAGE == message::session_establishment_acknowledged && view.sv >= lang::SystemVersion{2, 3};
}

/// Whose packets a message may have (8.4.4.4.1). Message 37 of an RBC is read as any other: it has its own refusal.
lang::Media sender_of(const RadioMessage& message) {
  if (message.infill_unit) return lang::media::RIU;
  const bool infill = !message.bytes.empty() && message.bytes[0] == message::infill_movement_authority;
  return infill ? lang::Media{0} : lang::media::RBC;
}

void receive_message(Reception& r, const RadioMessage& message) {
  State& s = r.state;
  const std::optional<radio::Peer> known =
      radio::peer_of(s.radio, named_rbc(message.from, message.infill_unit), message.infill_unit);
  Sender from{known.value_or(message.infill_unit ? radio::Peer::infill_1 : radio::Peer::supervising)};
  if (!from.infill_unit()) from.role = radio::role_of(s.radio, from.peer);
  const lang::MessageToTrainView view =
      lang::scan_message_to_train(message.bytes, session_version(s.radio.session(from.peer).M_VERSION, s.srs),
                                  lang::Check::all, sender_of(message));
  if (view.fault == lang::Fault::unknown_message && lang::is_later(view.sv))
    return receive_unknown(r, view, message.bytes, from, known.has_value());
  if (view.fault != lang::Fault::none) return reject_inconsistent(r, view.NID_MESSAGE, from, known.has_value());
  if (view.NID_MESSAGE == message::infill_movement_authority && !from.infill_unit())
    return refuse_radio_infill(r, view);
  if (!passes(r, {view.NID_MESSAGE, view.T_TRAIN.raw, view.M_ACK.raw == 1}, from, known.has_value())) return;
  if (view.NID_MESSAGE == message::trackside_system_version) receive_version(r, view, from);
  if (acknowledges_session(view)) {  // it has no row in 4.8: radio::receive has taken it
    r.log.note({.what = What::message_accepted, .id = view.NID_MESSAGE, .clause = "3.5.3.7.4"_srs});
    return;
  }
  evaluate_radio(r, view, message.bytes, from);
}

}  // namespace

void receive_radio(Reception& r) {
  for (const RadioMessage& m : r.in.radio_messages) receive_message(r, m);
  if (!level_2_or_3(r.state.level.level)) r.state.radio.errors.clear();  // 3.16.4.1
}

}  // namespace evc::kernel
