#include "kernel/here.h"
#include "kernel/intake/filter.h"
#include "kernel/intake/levels.h"
#include "kernel/manoeuvre.h"
#include "kernel/train_category.h"
#include "kernel/train_data.h"
#include "lang/decode.h"
#include "lang/packets/packet_65.h"
#include "lang/packets/packet_72.h"
#include "lang/packets/packet_76.h"
#include "terms/message_numbers.h"
#include "terms/packet_numbers.h"

// What the exceptions of 4.8.3 and 4.8.4 ask of the state.
namespace evc::kernel {
namespace {

/// 4.8.4 [11] of 4.0.0: stored, or in the message.
bool running_number_known(const State& s, const Information& information) {
  if (valid(s.data.train_running_number_status)) return true;
  for (const lang::PacketView& view : information.packets)
    if (view.NID_PACKET == packet::train_running_number_from_rbc) return true;
  return false;
}

/// The group was reported with more than one previous LRBG (3.4.2.3.3.8).
bool reported_with_others(const State& s, GroupId group) {
  for (const position::Reference& reference : s.position.references)
    if (reference.id == group) return reference.reported_ambiguously;
  return false;
}

/// A restriction that can be revoked: 255 is the identity of all others (3.11.5.9).
bool is_revocable_restriction(const lang::PacketView& view) {
  lang::Packet65 p;
  return view.NID_PACKET == packet::temporary_speed_restriction && lang::decode(view, p) == lang::Fault::none &&
         p.NID_TSR.raw != 255;
}

/// A text whose acknowledgement is to be reported, with the identity of one that waits for its own (3.12.3.5.3).
template <class P>
bool repeats_text(const State& s, const lang::PacketView& view) {
  P p;
  if (lang::decode(view, p) != lang::Fault::none || p.Q_TEXTCONFIRM.raw == 0 || p.Q_TEXTREPORT.raw != 1) return false;
  for (const track::Text& text : s.track.texts)
    if (text.report && !text.acknowledged && text.NID_TEXTMESSAGE == p.NID_TEXTMESSAGE.raw) return true;
  return false;
}

/// 4.8.3 [3]: data that are sent, or will be at the end of this cycle, in which the driver has entered them: what the
/// RBC sent before it had them is for others.
bool awaits_train_data_acknowledgement(const State& s, const radio::Partner& rbc) {
  const bool due = rbc.train_data_pending && sends_train_data(s);
  if (s.srs != SrsVersion::v4_0_0) return rbc.train_data_stamp.has_value() || due;
  const bool others = !rbc.route_data_acknowledged || !(route_data(s.train) == *rbc.route_data_acknowledged);
  return radio::awaits_train_data_acknowledgement(rbc) || (due && others);
}

/// 4.8.3 [17], as [3]. An accepting RBC is asked when it supervises: what it sends waits until then, and so does its
/// acknowledgement (4.8.2.1 c); that of the RBC before is not its own.
bool awaits_consist_length_acknowledgement(const Reception& r, SessionRole sender) {
  if (sender != SessionRole::supervising) return false;
  const radio::Partner& rbc = r.state.radio.supervising;
  const bool changed = r.out.consist_changed && informs_of_consist(r.state);
  return rbc.consist_stamp.has_value() || (radio::knows_manoeuvres(rbc.session) && (rbc.consist_due || changed));
}

}  // namespace

bool authorises_manoeuvre(const Information& information) {
  return information.message != nullptr && information.message->NID_MESSAGE == message::sm_authorised;
}

modes::AcceptanceContext context_of(const Reception& r, const Information& information) {
  const State& s = r.state;
  modes::AcceptanceContext c;
  c.mode = s.mode;
  c.level = s.level.level;
  c.medium = information.medium;
  c.rbc = information.sender;
  if (const auto to = ordered_level(r)) c.announced = to->level;
  const bool supervising = information.sender == SessionRole::supervising;
  const radio::Partner& rbc = supervising ? s.radio.supervising : s.radio.other;
  c.train_data_unacknowledged = awaits_train_data_acknowledgement(s, rbc);
  c.emergency_stop_pending = s.emergency_stops.any();
  c.exit_from_trip_recognised = r.out.exit_from_trip || procedures::train_trip::exit_recognised(s.train_trip);
  c.desk_open = r.in.train.desk_open;
  c.train_data_valid = valid(s.data.train_data_status) || authorises_manoeuvre(information);  // 4.8.4 [4]
  c.consist_length_unacknowledged = awaits_consist_length_acknowledgement(r, information.sender);
  c.other_previous_lrbg = information.message != nullptr &&
                          information.message->NID_MESSAGE == message::coordinate_system_assigned &&
                          reported_with_others(s, information.group);
  c.override_active = s.override_.active;
  c.srs = s.srs;
  if (c.srs == SrsVersion::v4_0_0) c.train_running_number = running_number_known(s, information);
  return c;
}

void add_facts_of_stores(modes::AcceptanceContext& c, const State& s, const lang::PacketView& view) {
  c.revocable_and_inhibited = s.track.revocable_tsr_inhibited && is_revocable_restriction(view);
  c.text_awaits_acknowledgement = (view.NID_PACKET == packet::plain_text && repeats_text<lang::Packet72>(s, view)) ||
                                  (view.NID_PACKET == packet::fixed_text && repeats_text<lang::Packet76>(s, view));
}

}  // namespace evc::kernel
