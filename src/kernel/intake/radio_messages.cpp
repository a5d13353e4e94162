#include "kernel/intake/radio_messages.h"

#include "kernel/intake/buffer.h"
#include "kernel/intake/filter.h"
#include "kernel/intake/routes.h"
#include "kernel/intake/system_version.h"
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

/// The reference of message 33 is D_REF away from the LRBG (3.6.3.2.5).
void shift_reference(Information& information, const lang::MessageToTrainView& view) {
  if (view.NID_MESSAGE != message::movement_authority_shifted) return;
  lang::Message33 m;
  if (lang::decode(view, m) != lang::Fault::none) return;
  const Distance d = lang::metres(m.Q_SCALE, m.D_REF);
  information.reference =
      information.orientation == Direction::reverse ? information.reference - d : information.reference + d;
}

void evaluate_radio(Reception& r, const lang::MessageToTrainView& view, std::span<const std::uint8_t> bytes,
                    SessionRole sender) {
  State& s = r.state;
  Information information;
  information.medium = Medium::rbc;
  information.sender = sender;
  information.message = &view;
  information.min_safe_front = r.out.here.min_safe_front;
  information.time = radio::time_of(view.T_TRAIN.raw, s.now);  // timers count from the time stamp (3.8.4.2.1)
  refer(information, s, view);
  if (!information.located && has_place(view.NID_MESSAGE)) {
    r.log.note({.what = What::message_refused, .id = view.NID_MESSAGE, .clause = "3.6.2.2.2"_srs});
    return;
  }
  shift_reference(information, view);
  (void)gather(information, view.packets, &r.log);  // all packets of a message fit
  drop_superseded(information, &r.log);
  const Waiting waiting = evaluate(r, information);
  if (!waiting.any()) return;
  add_bits(keep(r, information, waiting), bytes);
}

/// Message 37 is sent by a radio infill unit (8.7.15), and the unit has sessions with RBCs only: it is judged by its
/// row of 4.8.3, and where that accepts it (level 1) no session with its sender is there (3.9.3.4). It says nothing
/// about the contact with the RBC and is not acknowledged.
void refuse_radio_infill(Reception& r) {
  modes::AcceptanceContext context;
  context.level = r.state.level.level;
  context.medium = Medium::riu;
  const modes::Acceptance a = modes::accept_by_level(evc::Information::infill_location_reference, context);
  r.log.note({.what = What::message_refused,
              .id = message::infill_movement_authority,
              .clause = a.verdict == modes::Verdict::accepted ? "3.9.3.4"_srs : a.clause});
}

/// `named`: by the bearer.
void receive_message(Reception& r, std::span<const std::uint8_t> bytes, const std::optional<radio::Rbc>& named) {
  State& s = r.state;
  const radio::Peer from = radio::peer_of(s.radio, named).value_or(radio::Peer::supervising);
  const SessionRole sender = radio::role_of(s.radio, from);
  const lang::MessageToTrainView view =
      lang::scan_message_to_train(bytes, session_version(s.radio.partner(from).session.M_VERSION));
  if (view.fault == lang::Fault::unknown_message && lang::is_later(view.sv)) {
    r.log.note({.what = What::message_unknown, .id = view.NID_MESSAGE, .clause = "3.17.3.11"_srs});
    return;
  }
  if (view.fault != lang::Fault::none) {
    radio::receive_inconsistent(s.radio);
    r.log.note({.what = What::message_rejected, .id = view.NID_MESSAGE, .clause = "3.16.3.1.1"_srs});
    return;
  }
  if (view.NID_MESSAGE == message::infill_movement_authority) return refuse_radio_infill(r);
  const radio::Header header{view.NID_MESSAGE, view.T_TRAIN.raw, view.M_ACK.raw == 1};
  const radio::Rejected rejected = radio::peer_of(s.radio, named)
                                       ? radio::receive(s.radio, header, s.now, r.outbox, from)
                                       : radio::Rejected::no_session;
  if (rejected != radio::Rejected::no) {
    r.log.note({.what = What::message_rejected, .id = view.NID_MESSAGE, .clause = radio::clause(rejected)});
    return;
  }
  if (sender == SessionRole::supervising) r.out.new_radio_message = true;
  if (view.NID_MESSAGE == message::trackside_system_version) {
    lang::Message32 m;
    if (lang::decode(view, m) == lang::Fault::none)
      radio::receive_version(s.radio, static_cast<std::uint8_t>(m.M_VERSION.raw), s.now, r.outbox, from);
    operate_version_of_rbc(r, s.level.level);
  }
  evaluate_radio(r, view, bytes, sender);
}

}  // namespace

void receive_radio(Reception& r) {
  for (const RadioMessage& m : r.in.radio_messages) receive_message(r, m.bytes, named_rbc(m.from));
}

}  // namespace evc::kernel
