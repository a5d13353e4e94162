#include "kernel/here.h"
#include "kernel/intake/filter.h"
#include "kernel/intake/levels.h"
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
  c.train_data_unacknowledged = (supervising ? s.radio.supervising : s.radio.other).train_data_stamp.has_value();
  c.emergency_stop_pending = s.emergency_stops.any();
  c.exit_from_trip_recognised = r.out.exit_from_trip || procedures::train_trip::exit_recognised(s.train_trip);
  c.desk_open = r.in.train.desk_open;
  c.train_data_valid = valid(s.data.train_data_status) || authorises_manoeuvre(information);  // 4.8.4 [4]
  c.consist_length_unacknowledged = s.radio.supervising.consist_stamp.has_value();
  c.override_active = s.override_.active;
  c.srs = s.srs;
  if (c.srs == SrsVersion::v4_0_0) c.train_running_number = running_number_known(s, information);
  return c;
}

}  // namespace evc::kernel
