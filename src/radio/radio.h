#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "base/inplace_vector.h"
#include "base/units.h"
#include "radio/messages.h"
#include "radio/session.h"

// Radio (A3): everything between the bearer and the contents of messages.
namespace evc::radio {

/// Packet 57. Absent: off.
struct MaRequestParameters {
  std::optional<Duration> T_MAR, T_TIMEOUTRQST, T_CYCRQST;
  friend constexpr bool operator==(const MaRequestParameters&, const MaRequestParameters&) = default;
};
/// Packet 58, with its places in the odometer or track frame as metres of one axis: the kernel's choice.
struct PositionReportParameters {
  std::optional<Duration> T_CYCLOC;
  std::optional<Distance> D_CYCLOC;
  bool now = false, every_group = false;  ///< M_LOC 0, 1; neither: 2
  struct Location {
    Place at{};
    bool max_front = false;  ///< Q_LGTLOC: false min safe rear end, true max safe front end
    bool reported = false;
    friend constexpr bool operator==(const Location&, const Location&) = default;
  };
  InplaceVector<Location, 32> locations;
  friend constexpr bool operator==(const PositionReportParameters&, const PositionReportParameters&) = default;
};

/// Reasons of an MA request, bits of Q_MARQSTREASON (7.5.1.121.1).
enum Reason : std::uint8_t {
  kStartSelected = 1,
  kBeforePerturbation = 2,
  kBeforeTimeout = 4,
  kTrackDescriptionDeleted = 8,
  kTrackAheadFree = 16,
};

/// Reaction at the end of T_NVCONTACT (M_NVCONTACT).
enum class Reaction : std::uint8_t { trip = 0, service_brake = 1, none = 2 };
struct ContactRule {
  std::optional<Duration> T_NVCONTACT;  ///< absent: infinite
  Reaction M_NVCONTACT = Reaction::none;
};

/// An exchange that is repeated every kRepeatAfter until its answer comes (end of mission, SH request, exit from
/// trip, leaving the RBC area); after the last wait the session is terminated.
struct Exchange {
  std::uint8_t NID_MESSAGE = 0;  ///< 0: none runs
  std::uint8_t repetitions = 0;
  Duration since{};
};

struct State {
  Session session;
  std::optional<Rbc> contact;              ///< stored RBC contact
  std::optional<std::uint32_t> last_sent;  ///< T_TRAIN of the last message sent: stamps are unique (3.16.3.3.2)
  // 3.16.3.4
  std::optional<Duration> contact_reference;  ///< T_REF: stamp of the last message, or level switch, or hole left
  bool contact_lost = false;                  ///< expired and no new message since
  bool contact_reported = false;              ///< M_ERROR 5 is owed when the link is back
  bool was_in_hole = false;
  // 3.18.3.4
  bool train_data_pending = false;                ///< has to be sent in this session
  std::optional<std::uint32_t> train_data_stamp;  ///< of the 129 that is not acknowledged yet
  bool train_data_acknowledged = false;           ///< in this session
  // 3.6.2.2
  InplaceVector<std::uint32_t, 8> reported_lrbg;  ///< newest last
  bool unknown_lrbg_allowed = false;
  // 3.8.2
  std::optional<MaRequestParameters> ma_request;
  std::uint8_t reasons = 0;  ///< true at the last cycle
  std::optional<Duration> requested_at;
  // 3.6.5
  std::optional<PositionReportParameters> report;
  std::optional<Duration> reported_at;
  std::optional<Place> reported_place;
  bool report_due = false;
  InplaceVector<std::uint8_t, 4> errors;  ///< M_ERROR to report
  Exchange exchange;
  std::optional<std::uint32_t> exit_from_trip_stamp;  ///< T_TRAIN of message 6, for PT
};

/// Why a message was rejected as a whole (3.16.3.1.1).
enum class Rejected : std::uint8_t { no, no_session, terminating, stamp, lrbg };
/// The clause of a rejection, a literal.
const char* clause(Rejected rejected);

/// Takes a message whose bits were found right: order of time stamps, LRBG known to both, acknowledgement (146) when
/// M_ACK, contact supervision. 32 and 39 are carried out here too.
Rejected receive(State& state, const Header& header, Duration now, Outbox& out);
/// A message with bits that are not right: the error is reported to the RBC (3.16.3.1.1.2).
void receive_inconsistent(State& state);
/// Message 32.
void receive_version(State& state, std::uint8_t M_VERSION, Duration now, Outbox& out);
/// Message 8: `T_TRAIN_REF` of the 129 that it acknowledges.
void receive_train_data_ack(State& state, std::uint32_t T_TRAIN_REF);

/// Packet 42, packet 131 as an establishment order, or the driver's choice (3.5.3). `sleeping`: only orders for
/// sleeping units count. `store_only`: SH, PS. Gives false when the order is ignored.
struct SessionOrder {
  bool establish = true;
  Rbc rbc{};
  bool sleeping_too = false;
  Cause cause = Cause::trackside_order;
};
bool order(State& state, const SessionOrder& order, bool sleeping, bool store_only, Duration now, Outbox& out);

/// Events that ask for a position report (3.6.5.1.4), set by the kernel in the cycle they happen and filtered by mode.
struct ReportEvents {
  bool standstill_reached = false, mode_changed = false, level_changed = false, border_passed = false,
       integrity_changed = false, session_established = false;
  bool group_passed = false;      ///< an LRBG compliant balise group was evaluated
  bool start_of_mission = false;  ///< the report goes as 157 with `Q_STATUS`
  std::uint8_t Q_STATUS = 1;
};
struct Inputs {
  Duration now{};
  Link link = Link::unchanged;
  bool in_radio_hole = false;
  bool level_2_or_3 = false;
  bool contact_supervised = false;  ///< level 2/3 and FS, LS or OS (4.5.2)
  bool standstill = false;
  bool reports_allowed = true;    ///< the mode reports by packet 58 (4.5.2)
  bool train_data_valid = false;  ///< valid, and the engine leads: not in SL, NL
  ContactRule contact{};
  Place est_front{}, min_safe_rear{}, max_safe_front{};
  std::uint32_t NID_LRBG = kUnknownLrbg;
  bool orientation_known = true;
  ReportEvents events{};
  std::uint8_t reasons = 0;                ///< reasons of the MA request that are true now
  std::optional<std::uint32_t> NID_LTRBG;  ///< with kTrackAheadFree: the border's group
};
struct Result {
  bool session_established = false, session_lost = false;
  bool trip = false;           ///< condition [41]
  bool service_brake = false;  ///< T_NVCONTACT expired with M_NVCONTACT 1
  bool contact_lost = false;   ///< driver: no message in due time
  bool shorten = false;        ///< standstill under that brake without a message: A.3.4 i
};
/// One cycle: session, contact supervision, train data, position reports, MA requests, repetitions; finally
/// every intent gets its time stamp.
Result supervise(State& state, const Inputs& inputs, Outbox& out);

/// Train data were validated or changed: 129 is due (3.18.3.4).
void send_train_data(State& state);
/// Starts a repeated exchange: 130, 136, 150 (1.7).
void begin_exchange(State& state, std::uint8_t NID_MESSAGE, Duration now, Outbox& out);
/// Its answer came.
void end_exchange(State& state);

/// The driver's text acknowledgement, emergency stop answers and others go straight to the outbox.
inline void answer_emergency_stop(std::uint8_t NID_EM, std::uint8_t Q_EMERGENCYSTOP, Outbox& out) {
  Intent intent;
  intent.NID_MESSAGE = 147;
  intent.NID_EM = NID_EM;
  intent.Q_EMERGENCYSTOP = Q_EMERGENCYSTOP;
  out.send(intent);
}

}  // namespace evc::radio
