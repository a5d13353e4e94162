#include "kernel/report/sessions.h"

#include "driver/srs_4_7_2.h"
#include "kernel/here.h"
#include "kernel/radio_infill.h"
#include "kernel/stored.h"
#include "modes/active_functions.h"

namespace evc::kernel {
namespace {

void establish(State& s, radio::Cause cause, radio::Outbox& outbox) {
  if (!s.radio.contact) return;
  radio::SessionOrder order;
  order.rbc = *s.radio.contact;
  order.cause = cause;
  (void)radio::order(s.radio, order, false, false, s.now, outbox);
}

/// The RBC that the driver chose, or the stored one.
void call(State& s, const Received& received, radio::Cause cause, radio::Outbox& outbox) {
  if (received.selected.has(Select::short_number)) return radio::call_short_number(s.radio, cause, s.now, outbox);
  establish(s, cause, outbox);
}

void follow_procedures(State& s, const Received& received, const procedures::Effects& effects, radio::Outbox& outbox) {
  using procedures::Send;
  if (effects.send.has(Send::open_session)) call(s, received, radio::Cause::start_of_mission, outbox);
  if (!effects.send.has(Send::terminate_session)) return;
  if (s.end_of_mission.mission)
    radio::terminate(s.radio.supervising.session, s.now, outbox);
  else  // 3.15.1.3.4.1, 5.4.1.4
    radio::terminate_all(s.radio, s.now, outbox);
}

/// 3.5.3.8 b, d. Up to 3.6.0 the front end passes the border, in 4.0.0 the rear end (run_radio).
void stop_set_up(State& s, const Received& received, const Decided& decided, radio::Outbox& outbox) {
  const bool left_level = s.srs != SrsVersion::v4_0_0 && received.level_2_or_3_left;
  if (decided.mission_ended || left_level) radio::abort_set_ups(s.radio, s.now, outbox);
}

/// 3.5.3.4 c, g: in level 2 and 3, a mode that has to be reported; the end of a start of mission in which there was no
/// session. To an RBC with which there is one, or a set-up, the mode is reported there: beyond the border of a handover
/// the contact may be another one.
void open_for_mode(State& s, const Decided& decided, radio::Outbox& outbox) {
  if (!level_2_or_3(s.level.level) || !reports_mode(s, decided) || decided.mission_ended) return;
  const radio::Session& session = s.radio.supervising.session;
  const bool to_report = session.phase == radio::Phase::idle || session.phase == radio::Phase::terminating;
  if (!valid(s.contact_status) || !to_report) return;
  const bool started = s.previous_mode == Mode::SB && procedures::end_of_mission::is_mission(s.mode) &&
                       procedures::start_of_mission::without_session(s.start_of_mission);
  establish(s, started ? radio::Cause::start_without_session : radio::Cause::mode_report, outbox);
}

/// 4.4.6.1.10 c: in SL of level 2 and 3, for the report of a fault that was memorised.
void open_for_fault(State& s, const Received& received, radio::Outbox& outbox) {
  if (!received.fault_to_report || s.mode != Mode::SL || !level_2_or_3(s.level.level)) return;
  if (valid(s.contact_status) && s.radio.supervising.session.phase == radio::Phase::idle)
    establish(s, radio::Cause::mode_report, outbox);
}

/// 3.5.3.4 d, h, 5.10.3.15.2: outside start of mission, with a valid contact and a registered terminal at once, else
/// when the driver has chosen one. He is asked as in S3 (5.4.3.2), once a terminal is registered, and in the modes in
/// which he may enter it (4.7.2): after a change of level that led to TR, in PT.
void open_for_driver(State& s, const Received& received, procedures::Effects& effects, radio::Outbox& outbox) {
  if (s.mode == Mode::SB || !level_2_or_3(s.level.level)) {
    s.asks_for_contact = false;
    return;
  }
  const bool changed_level = received.level_switched_to && received.level_changed_by_driver;
  if (changed_level) s.asks_for_contact = !s.radio.supervising.session.established();
  const bool entered = received.entered.has(Entered::rbc_contact);
  const bool chosen = entered || received.selected.has(Select::short_number);
  const bool at_once = changed_level && s.asks_for_contact && valid(s.contact_status) && callable(s.network);
  const bool calls = chosen || at_once;
  if (calls) call(s, received, radio::Cause::driver_level, outbox);
  // He is asked until he has chosen, or the trackside has ordered a session.
  const radio::Phase phase = s.radio.supervising.session.phase;
  const bool ordered = phase != radio::Phase::idle && phase != radio::Phase::terminating;
  if (calls || ordered) s.asks_for_contact = false;
  const bool may_answer = callable(s.network) && driver::allowed(driver::Input::rbc_contact, s.mode, s.srs);
  effects.entries.add(Entry::rbc_contact, s.asks_for_contact && may_answer);
}

}  // namespace

bool reports_errors(const State& s) {
  if (s.mode == Mode::SF) return s.odometer_accuracy.beyond_safety_threshold;
  return modes::active(modes::Function::report_data_consistency_error, s.mode);
}

bool reports_mode(const State& s, const Decided& decided) {
  const bool shunting_goes_on = s.previous_mode == Mode::PS && s.mode == Mode::SH;
  return decided.mode_changed && !shunting_goes_on && modes::active(modes::Function::report_mode_change, s.mode);
}

/// 3.18.4.3.6.1 b, 3.5.3.8 i: the driver changes the network.
void end_for_network(State& s, const Received& received, radio::Outbox& outbox) {
  if (received.selected.has(Select::radio_network)) s.network.by_driver = true;
  if (!received.selected.has(Select::radio_network) && !received.entered.has(Entered::network)) return;
  radio::terminate_all(s.radio, s.now, outbox);
  radio::abort_set_ups(s.radio, s.now, outbox);
  end_infill_sessions(s, outbox);
}

void order_sessions(State& s, const Received& received, const Decided& decided, procedures::Effects& effects,
                    radio::Outbox& outbox) {
  end_for_network(s, received, outbox);
  follow_procedures(s, received, effects, outbox);
  stop_set_up(s, received, decided, outbox);
  open_for_mode(s, decided, outbox);
  open_for_fault(s, received, outbox);
  open_for_driver(s, received, effects, outbox);
}

void note_contact(State& s) {
  const radio::Partner& p = s.radio.supervising;
  if (p.established_now && s.radio.contact && s.radio.contact->same_id(p.session.rbc))
    s.contact_status = DataStatus::valid;
}

void end_without_power(State& s, radio::Outbox& outbox) {
  outbox.messages.clear();
  outbox.connect.reset();
  const Sessions before = sessions_of(s);
  for (const radio::Peer peer : radio::kPeers) {
    const radio::Session& session = s.radio.session(peer);
    if (session.phase != radio::Phase::idle) outbox.release(session.rbc);
  }
  const std::optional<radio::Rbc> contact = s.radio.contact;
  InplaceVector<radio::Rbc, 8> later = s.radio.disconnect_later;
  for (const radio::Rbc& rbc : outbox.also_disconnect) (void)later.push_back(rbc);
  if (!outbox.disconnect && !later.empty()) {
    outbox.disconnect = later.front();
    later.erase(0);
  }
  s.radio = {};
  s.radio.newest = lang::newest_version(s.srs);
  s.radio.contact = contact;
  s.radio.disconnect_later = later;
  s.handover = {};
  s.radio_infill = {};
  s.network.awaited = false;
  delete_with_sessions(s, before);
}

}  // namespace evc::kernel
