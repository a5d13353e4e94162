#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "base/inplace_vector.h"
#include "base/units.h"
#include "radio/messages.h"
#include "radio/session.h"
#include "terms/clause.h"
#include "terms/reaction.h"

// Radio: everything between the bearer and the contents of messages. position/ decides when a position report is due by
// its parameters; this room sends it.
namespace evc::radio {

/// T_CYCRQSTD: cycle of the MA request before packet 57 is received (A.3.1).
inline constexpr Duration kDefaultRequestCycle{60.0};

/// Packet 57. Absent: off.
struct MaRequestParameters {
  std::optional<Duration> T_MAR, T_TIMEOUTRQST, T_CYCRQST;
  friend constexpr bool operator==(const MaRequestParameters&, const MaRequestParameters&) = default;
};

/// Reasons of an MA request, bits of Q_MARQSTREASON (7.5.1.118.3).
enum Reason : std::uint8_t {
  kStartSelected = 1,
  kBeforePerturbation = 2,
  kBeforeTimeout = 4,
  kTrackDescriptionDeleted = 8,
  kTrackAheadFree = 16,
};

/// The reaction when T_NVCONTACT expires.
struct ContactRule {
  std::optional<Duration> T_NVCONTACT;  ///< absent: infinite
  Reaction M_NVCONTACT = Reaction::none;
};

/// An RBC of a version above 2.2 knows supervised manoeuvres (6.6.5.3.7 of 4.0.0).
constexpr bool knows_manoeuvres(const Session& session) { return session.M_VERSION > 0x22; }

/// Of the train data what the routes and the track description of an RBC depend on (4.8.3 [3] of 4.0.0): train
/// category, axle load, loading gauge and traction systems, in the codes of packet 11.
struct RouteData {
  std::uint8_t NC_CDTRAIN = 0;
  std::uint16_t NC_TRAIN = 0;
  std::uint8_t M_AXLELOADCAT = 0, M_LOADINGGAUGE = 0;
  struct Traction {
    std::uint8_t M_VOLTAGE = 0;
    std::uint16_t NID_CTRACTION = 0;
    friend constexpr bool operator==(const Traction&, const Traction&) = default;
  };
  InplaceVector<Traction, 8> tractions;
  friend constexpr bool operator==(const RouteData&, const RouteData&) = default;
};
/// Train data that were sent and are not acknowledged.
struct SentTrainData {
  std::uint32_t T_TRAIN = 0;  ///< of their message
  RouteData data;
};

/// An RBC and what is agreed with it in its session.
struct Partner {
  Session session;
  bool established_now = false;     ///< message 32 was accepted since the last cycle
  bool running_number_due = false;  ///< has to be sent (3.18.4.5.4)
  // 3.18.3.4
  bool train_data_pending = false;                ///< has to be sent
  std::optional<std::uint32_t> train_data_stamp;  ///< of the 129 that is not acknowledged yet
  bool train_data_acknowledged = false;           ///< in this session
  bool train_data_validated_since = false;        ///< anew or others, since the acknowledgement
  // 4.8.3 [3] of 4.0.0, in this session
  InplaceVector<SentTrainData, 4> train_data_sent;   ///< since those acknowledged last, the oldest first
  std::optional<RouteData> route_data_acknowledged;  ///< of any train data: the last value
  // 3.18.3.10 of 4.0.0
  bool consist_due = false;                    ///< 133 has to be sent
  std::optional<std::uint32_t> consist_stamp;  ///< of the 133 that is not acknowledged yet
  /// It has acknowledged the train data of now; that they are sent again does not matter.
  bool knows_train_data() const { return train_data_acknowledged && !train_data_validated_since; }
};

struct State {
  lang::SystemVersion newest = lang::kNewest_of_baseline_3;  ///< the highest version of the unit (6.4.2.1)
  Partner supervising;             ///< the RBC that supervises; without a handover the only one
  Partner other;                   ///< of a handover (3.15.1): the accepting RBC, after it the former RBC
  bool other_accepts = false;      ///< which of them it is
  bool exchange_due = false;       ///< the accepting RBC supervises from the next cycle on
  bool other_called_last = false;  ///< by the last connection request to an RBC
  Peer infill_called_last = Peer::infill_1;
  std::array<Session, 2> infill_units;     ///< sessions with radio infill units
  InplaceVector<Rbc, 8> disconnect_later;  ///< orders to the bearer that wait: one in a cycle
  std::optional<Rbc> contact;              ///< stored RBC contact
  std::optional<std::uint32_t> last_sent;  ///< T_TRAIN of the last message sent: stamps are unique (3.16.3.3.2)
  // 3.16.3.4
  std::optional<Duration>
      contact_reference;      ///< T_REF: stamp of the last message, of a level change, or of the exit from a radio hole
  bool contact_lost = false;  ///< T_NVCONTACT expired and no new message since
  bool contact_brake_released = false;  ///< the service brake for it was released at standstill
  bool reconnected = false;             ///< the connection was set up again 60 s later
  /// A message of any RBC counts, not only one of the supervising RBC: a further order changed the handing over RBC
  /// (3.16.3.4.1.2.1 of 4.0.0).
  bool contact_with_any = false;
  bool was_in_hole = false, was_level_2_or_3 = false;
  std::optional<std::uint32_t> shunting_request_stamp;   ///< of the last 130
  std::optional<std::uint32_t> manoeuvre_request_stamp;  ///< of the last 131 (4.0.0)
  // 3.8.2
  std::optional<MaRequestParameters> ma_request;
  std::uint8_t reasons = 0;  ///< that were sent and still apply
  std::optional<Duration> requested_at;
  InplaceVector<ErrorReport, 4> errors;  ///< to report (3.16.4)

  Partner& partner(Peer peer) { return peer == Peer::supervising ? supervising : other; }
  const Partner& partner(Peer peer) const { return peer == Peer::supervising ? supervising : other; }
  Session& session(Peer peer) {
    return is_infill_unit(peer) ? infill_units[peer == Peer::infill_2] : partner(peer).session;
  }
  const Session& session(Peer peer) const {
    return is_infill_unit(peer) ? infill_units[peer == Peer::infill_2] : partner(peer).session;
  }
};

/// The RBC, or radio infill unit, that an input of the bearer is from: the named one, without a name the one called
/// last. None when there is no session with the named one.
std::optional<Peer> peer_of(const State& state, const std::optional<Rbc>& named, bool infill_unit = false);

/// The part in a handover of the RBC that the session is with (3.15.1).
SessionRole role_of(const State& state, Peer peer);

/// Why a message was rejected as a whole (3.16.3.1.1).
enum class Rejected : std::uint8_t { no, no_session, terminating, time_stamp };
/// The clause of a rejection; none when not rejected.
Clause clause(Rejected rejected);

/// Whether stamp `a` is later than `b`; the counter overflows after 497 days (3.16.3.2.3).
constexpr bool later(std::uint32_t a, std::uint32_t b) { return static_cast<std::int32_t>(a - b) > 0; }

/// Receives a message whose bits are correct: checks session and order of time stamps, acknowledges (146) when M_ACK,
/// supervises contact (3.16.3). Message 39 is executed here. The contents may still be refused by filters; the message
/// counts as received all the same.
Rejected receive(State& state, const Header& header, Duration now, Outbox& out, Peer from = Peer::supervising);
/// A message whose bits are not correct (3.16.3.1.1.2): reported to the RBC if there is a session with its sender.
void receive_inconsistent(State& state, Peer from = Peer::supervising);
/// Message 32, after `receive`. True when the session is established by it.
bool receive_version(State& state, std::uint8_t M_VERSION, Duration now, Outbox& out, Peer from = Peer::supervising);
/// The version in which the unit and this partner speak: the older of theirs (6.6.3.4, 6.6.5.3 to .6); 2.1 before the
/// partner gave its own.
lang::SystemVersion common_version(const State& state, const Session& session);
/// Message 8, after `receive`: `T_TRAIN_REF` names the 129 that it acknowledges.
void receive_train_data_ack(Partner& from, std::uint32_t T_TRAIN_REF);
/// 4.8.3 [3] of 4.0.0: train data were sent, and the RBC has acknowledged none in this session yet, or others in what
/// its routes depend on than those it has acknowledged last.
bool awaits_train_data_acknowledgement(const Partner& partner);
/// Message 7 (4.0.0).
void receive_consist_length_ack(Partner& from, std::uint32_t T_TRAIN_REF);
/// An error of balises or radio, to be reported when a session is established (3.16.4).
void report_error(State& state, ErrorReport error);

/// Packet 42, packet 131 as an order to establish, or the driver's choice (3.5.3).
struct SessionOrder {
  bool establish = true;
  Rbc rbc{};
  bool sleeping_too = false;  ///< Q_SLEEPSESSION
  Cause cause = Cause::trackside_order;
};
/// `sleeping`: only orders with Q_SLEEPSESSION count. `store_only`: in SH and PS only the contact is stored. False when
/// the order is ignored: no stored "last known RBC", a sleeping unit, or a termination for another RBC. A session with
/// an RBC that is no partner ends the others (3.5.3.5.2).
bool order(State& state, const SessionOrder& order, bool sleeping, bool store_only, Duration now, Outbox& out);

/// The RBC that answers the short number, chosen by the driver: not the stored one (3.5.3.11). Other sessions end.
void call_short_number(State& state, Cause cause, Duration now, Outbox& out);
/// The bearer reports who answered: from now on the session is with this RBC (3.18.4.3.4).
void identify(Session& session, const Rbc& answered);

/// The session with the accepting RBC of a transition order, beside the one that supervises (3.5.3.5.2.1); one with
/// another RBC beside it is terminated first (3.15.1.3.2.3).
void call_accepting(State& state, const Rbc& accepting, Duration now, Outbox& out);
/// The accepting RBC supervises (3.15.1.3.5): the contact is supervised from its last message on (3.16.3.4.1.2), an MA
/// is requested from it anew.
void exchange(State& state, Duration now);
/// 3.16.3.4.1.2.1 of 4.0.0: until the next exchange the contact is supervised from the latest message of any RBC.
void supervise_contact_with_any(State& state, Duration now);
/// Both sessions end (3.5.5), or the set-up of one.
void terminate_all(State& state, Duration now, Outbox& out);
/// 3.5.3.8: the set-up of either session ends.
void abort_set_ups(State& state, Duration now, Outbox& out);

struct Inputs {
  Duration now{};
  RadioLink link = RadioLink::unchanged;
  Peer link_of = Peer::supervising;
  bool in_radio_hole = false;
  bool level_2_or_3 = false;
  bool contact_supervised = false;  ///< level 2/3 and FS, LS or OS (4.5.2)
  bool standstill = false;
  bool train_data_valid = false;  ///< valid, and the engine leads: not in SL, NL
  RouteData route_data{};         ///< of these train data
  ContactRule contact{};
  bool report_due = false;        ///< a position report (136), by parameters or event (3.6.5.1.4)
  bool errors_reported = true;    ///< the mode reports errors (4.5.2): the next one is in the report
  bool start_of_mission = false;  ///< a report is due, as 157 with Q_STATUS (5.4)
  bool consist_known = false;     ///< 4.0.0: 157 holds packet 10 (8.4.4.4.3)
  bool consist_due = false;       ///< 4.0.0: 133 is due (3.18.3.10)
  bool in_manoeuvre = false;      ///< 4.0.0: an accepting RBC is given the safe consist length (3.15.1.3.3)
  bool running_number_valid = false, running_number_entered = false;  ///< entered: in this cycle, not by an RBC
  std::optional<Rbc> running_number_from;                             ///< the RBC that gave it
  std::uint8_t Q_STATUS = 1;
  std::uint8_t reasons = 0;                ///< reasons of the MA request that apply now
  std::optional<std::uint32_t> NID_LTRBG;  ///< with kTrackAheadFree: the group at the border
};
struct Result {
  bool session_established = false, session_lost = false;  ///< with either RBC
  bool reported_to_other = false;                          ///< a position report was sent to the other RBC as well
  bool trip = false;                                       ///< condition [41], as long as it holds
  bool service_brake = false;  ///< T_NVCONTACT expired with M_NVCONTACT 1, until standstill or a new message
  bool shorten = false;        ///< standstill under that brake without a message: A.3.4 i, once
};
/// The connection to this partner is ordered: reports of the bearer that name none are of it (3.5.3.7).
void note_called(State& state, const Rbc& called);

/// Messages that their session does not send now are removed, of all peers (3.5.3.7, 3.5.4.5, 3.5.5.3).
void drop_unsent(const State& state, Outbox& out);

/// One cycle: sessions, contact supervision, train data, position reports (to both RBCs, 3.15.1.3.4), MA requests,
/// repetitions. Afterwards every message of the outbox has its own time stamp; messages without a connection are
/// removed (3.5.4.5).
Result supervise(State& state, const Inputs& inputs, Outbox& out);

/// Sessions and set-ups with radio infill units, and how many there are of all kinds at the moment.
std::optional<Peer> infill_unit(const State& state, const Rbc& unit);
std::size_t sessions(const State& state);

/// 129 is due, to both RBCs (3.15.1.3.3).
void send_train_data(State& state);
/// Train data were validated or changed (3.18.3.4).
void note_validated_train_data(State& state);

/// Message 147; Q_EMERGENCYSTOP in the codes of the RBC's version (for X = 1 from protection/).
inline void answer_emergency_stop(std::uint8_t NID_EM, std::uint8_t Q_EMERGENCYSTOP, Outbox& out) {
  Intent intent;
  intent.NID_MESSAGE = message::emergency_stop_acknowledged;
  intent.NID_EM = NID_EM;
  intent.Q_EMERGENCYSTOP = Q_EMERGENCYSTOP;
  out.send(intent);
}
/// Messages 137 (granted) and 138 (rejected): the answer to message 9 with this stamp (3.8.6).
inline void answer_shortening(bool granted, std::uint32_t T_TRAIN_REF, Outbox& out) {
  Intent intent;
  intent.NID_MESSAGE = granted ? message::shortening_granted : message::shortening_rejected;
  intent.T_TRAIN_REF = T_TRAIN_REF;
  out.send(intent);
}
/// Message 153 (3.9.3.10).
inline void inform_infill_unit(Peer to, GroupId signal, bool passed, Outbox& out) {
  Intent intent;
  intent.NID_MESSAGE = message::radio_infill_request;
  intent.signal = signal;
  intent.Q_INFILL = passed ? 1 : 0;
  const Addressed addressed(out, to);
  out.send(intent);
}
/// Message 158.
inline void report_text_acknowledged(std::uint8_t NID_TEXTMESSAGE, Outbox& out) {
  Intent intent;
  intent.NID_MESSAGE = message::text_acknowledged;
  intent.NID_TEXTMESSAGE = NID_TEXTMESSAGE;
  out.send(intent);
}

}  // namespace evc::radio
