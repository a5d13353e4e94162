#include "kernel/report/handover.h"

#include "kernel/here.h"
#include "kernel/radio_infill.h"
#include "modes/active_functions.h"

namespace evc::kernel {
namespace {

using procedures::rbc_handover::Step;

radio::Rbc accepting_rbc(const track::RbcTransition& order) { return {order.NID_C, order.NID_RBC, order.NID_RADIO}; }

/// The session with the handing over RBC.
radio::Peer handing_over(const State& s) {
  const bool exchanged = s.handover.procedure.step == Step::handed_over && !s.radio.exchange_due;
  return exchanged ? radio::Peer::other : radio::Peer::supervising;
}

/// One session, and the max safe front end has left the area of the handing over RBC: the accepting RBC of the
/// former order becomes the handing over RBC of the new one (3.15.1.3.2.4).
void continue_former(State& s, const track::RbcTransition& former, radio::Outbox& outbox) {
  if (s.handover.procedure.step != Step::at_border) return;
  radio::establish(s.radio.supervising.session, accepting_rbc(former), radio::Cause::trackside_order, s.now, outbox);
}

/// 3.16.3.4.1.2.1 of 4.0.0: whether a further order changes the handing over RBC: it is then the RBC that supervises
/// since the border of the handover that goes on (3.15.1.3.2.3), or that was to be called there (3.15.1.3.2.4).
bool changes_handing_over(const State& s) {
  if (s.srs != SrsVersion::v4_0_0) return false;
  const Step step = s.handover.procedure.step;
  return step == Step::handed_over || (step == Step::at_border && s.terminals < 2);
}

/// Takes the stored order. Returns whether it begins a handover; one that names the same RBC again only moves the
/// border, and one that names the RBC that supervises has been executed before its balise group was read.
bool take_order(State& s, radio::Outbox& outbox, Log log) {
  std::optional<track::RbcTransition>& stored = s.track.rbc_transition;
  Handover& h = s.handover;
  if (!stored || stored == h.order) return false;
  const std::optional<track::RbcTransition> former = h.order;
  const radio::Rbc accepting = accepting_rbc(*stored);
  const bool same = former && accepting_rbc(*former).same_id(accepting) && h.procedure.step != Step::none;
  if (same) {
    h.order = stored;
    return false;
  }
  const radio::Session& supervising = s.radio.supervising.session;
  if (supervising.active() && supervising.rbc.same_id(accepting)) {
    stored.reset();
    return false;
  }
  h.order = stored;
  s.radio.contact_with_any = false;
  if (changes_handing_over(s)) radio::supervise_contact_with_any(s.radio, s.now);
  if (s.mode == Mode::SL && !stored->sleeping_too) return true;
  if (!callable(s.network) || accepting.NID_RADIO == radio::kNoNumber) {
    log.note({.what = What::network_missing, .clause = "3.5.6.7"_srs});
    return true;
  }
  if (s.terminals < 2) {
    if (former) continue_former(s, *former, outbox);
  } else {
    radio::call_accepting(s.radio, accepting, s.now, outbox);
  }
  return true;
}

/// 3.18.4.3.1. An RBC without a number, which this unit cannot call, is none for the next start of mission, nor is the
/// one that was left.
void store_contact(State& s, const radio::Rbc& accepting) {
  const bool has_number = accepting.NID_RADIO != radio::kNoNumber;
  s.radio.contact = has_number ? std::optional(accepting) : std::nullopt;
  s.contact_status = has_number ? DataStatus::valid : DataStatus::unknown;
}

procedures::rbc_handover::Inputs inputs_of(const State& s, const track::Here& here) {
  procedures::rbc_handover::Inputs in;
  in.now = s.now;
  in.stored = s.track.rbc_transition.has_value();
  in.alone = !s.radio.other.session.active();
  in.est_front = here.est_front >= s.handover.order->at;
  in.max_safe_front = here.max_safe_front >= s.handover.order->at;
  in.min_safe_rear = here.min_safe_front - length_of(s) >= s.handover.order->at;
  in.one_session = s.terminals < 2;
  in.accepting_connected = s.radio.other_accepts && s.radio.other.session.phase == radio::Phase::up;
  in.reports = modes::activity(modes::Function::report_rbc_border, s.mode, s.srs) == modes::Activity::active;
  const radio::Session& session = s.radio.partner(handing_over(s)).session;
  in.established = session.established();
  in.ended = !session.active();
  return in;
}

}  // namespace

bool run_handover(State& s, const track::Here& here, radio::Outbox& outbox, Log log) {
  const bool ordered = take_order(s, outbox, log);
  Handover& h = s.handover;
  if (!h.order) return false;
  procedures::rbc_handover::Inputs in = inputs_of(s, here);
  in.ordered = ordered;
  const radio::Rbc accepting = accepting_rbc(*h.order);
  const radio::Peer peer = handing_over(s);
  const bool in_rear = ordered || h.procedure.step == Step::announced;
  const procedures::rbc_handover::Result r = procedures::rbc_handover::step(h.procedure, in);
  if (ordered) log.note({.what = What::rbc_handover_ordered, .id = accepting.NID_RBC, .clause = "3.15.1.3.1"_srs});
  if (r.change_contact) store_contact(s, accepting);
  // 3.11.5.14: by the max safe front end; what the accepting RBC orders for the way beyond the border stays.
  if (in_rear && in.max_safe_front) s.track.revocable_tsr_inhibited = false;
  radio::Session& session = s.radio.partner(peer).session;
  const radio::Addressed to(outbox, peer);
  if (r.rear_passed_now) radio::abort_set_up(session, s.now, outbox);
  if (r.terminate) radio::terminate(session, s.now, outbox);
  if (r.call_accepting && callable(s.network) && accepting.NID_RADIO != radio::kNoNumber)
    radio::establish(session, accepting, radio::Cause::trackside_order, s.now, outbox);
  if (r.over) s.track.rbc_transition.reset();
  if (h.procedure.step == Step::none) {
    h.order.reset();
    s.radio.contact_with_any = false;
    s.buffer.erase_if([](const BufferedSet& set) { return set.accepting; });  // 4.8.5.4 a
  }
  return r.report;
}

void complete_handover(State& s, const radio::Result& radio, Log log) {
  if (!radio.reported_to_other || !s.radio.other_accepts) return;
  if (!procedures::rbc_handover::reported_to_accepting(s.handover.procedure)) return;
  s.radio.exchange_due = true;
  log.note({.what = What::rbc_handed_over, .id = s.radio.other.session.rbc.NID_RBC, .clause = "3.15.1.3.5"_srs});
}

const radio::Session& indicated_session(const State& s) {
  if (const radio::Session* infill = session_of_infill_area(s)) return *infill;  // 3.5.7.7
  const bool left = s.handover.procedure.rear_passed && !s.radio.supervising.session.active();
  return left && s.radio.other.session.active() ? s.radio.other.session : s.radio.supervising.session;
}

}  // namespace evc::kernel
