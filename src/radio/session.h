#pragma once
#include <cstdint>
#include <optional>

#include "base/inplace_vector.h"
#include "base/units.h"
#include "lang/schema.h"
#include "radio/messages.h"
#include "terms/radio_link.h"

// Communication session with an RBC (3.5): set-up, version check, maintenance, termination.
namespace evc::radio {

/// N_CONN_TRIES, T_REP, N_REP, T_SESSION_KEEP, T_VERSION_WAIT, T_CONNSTATUS (A.3.1).
inline constexpr std::uint8_t kConnectionTries = 3;
inline constexpr Duration kRepeatAfter{15.0};
inline constexpr std::uint8_t kRepetitions = 3;
inline constexpr Duration kSessionKept{300.0};
inline constexpr Duration kVersionWait{15.0};
inline constexpr Duration kAcknowledgementWait{15.0};  ///< of session establishment, SRS 4.0.0
inline constexpr Duration kContactExtra{60.0};
inline constexpr Duration kConnectionStatus{45.0};

using Phase = SessionPhase;
/// Why a session is to be established (3.5.3.4).
enum class Cause : std::uint8_t {
  start_of_mission,
  trackside_order,
  mode_report,
  driver_level,
  radio_hole_end,
  after_loss,
  start_without_session
};

struct Session {
  Phase phase = Phase::idle;
  Rbc rbc{};
  Cause cause = Cause::start_of_mission;
  std::uint8_t tries = 0;        ///< connection requests made
  std::uint8_t repetitions = 0;  ///< of message 156
  Duration since{};              ///< entry of the phase, or the last repetition
  std::optional<Duration> status_timer;
  RadioIndication indication = RadioIndication::none;
  std::uint8_t M_VERSION = 0;                 ///< of the RBC, from message 32; 0: unknown
  std::optional<std::uint32_t> last_T_TRAIN;  ///< of the last message not rejected: the sequence reference
  // 3.5.3.7.4 of SRS 4.0.0, with an RBC or radio infill unit of version 2.3 or later.
  std::optional<Duration> established_report;  ///< of the last message 159 that is not acknowledged
  bool established_repeated = false;           ///< it was the second one
  bool request_connection = false;             ///< a request was made that the bearer has not answered yet
  std::optional<Rbc> remembered;               ///< ordered during termination; set up afterwards
  Cause remembered_cause = Cause::trackside_order;
  /// `connections` of the one whose end the terminal awaits to register with another network (3.5.6.6).
  std::optional<std::uint8_t> registers_after;
  std::uint8_t connections = 0;  ///< counts those that were requested anew or are over: whether one still is the same
  bool after_hole = false;       ///< the session was lost for good in a radio hole: set up again at its end (3.5.3.4 e)

  /// A session is established from message 32 on; a lost one is kept for kSessionKept (3.5.4.1).
  bool established() const { return phase == Phase::up || phase == Phase::lost; }
  /// Neither idle nor waiting for the end of a radio hole.
  bool active() const { return phase != Phase::idle || after_hole; }
  /// From then until its termination has ended (3.5.5).
  bool ongoing() const { return established() || phase == Phase::terminating; }
};

struct Outbox;

/// Establishes a session with `rbc` unless one with it is up or being set up (3.5.3.4.1); a session with another RBC is
/// terminated first (3.5.3.5.2).
void establish(Session& session, const Rbc& rbc, Cause cause, Duration now, Outbox& out);
/// A set-up ends without a session (3.5.3.8), and one that was to follow or to be resumed is not begun; a session that
/// is established stays.
void abort_set_up(Session& session, Duration now, Outbox& out);
/// Terminates the session (3.5.5): message 156, repeated until 39; while connecting, the set-up
/// ends.
void terminate(Session& session, Duration now, Outbox& out);
/// Evaluates the report of the bearer and the timers. `in_radio_hole`: no connection requests (3.5.4.4), and a set-up
/// ends. True in the cycle in which the session is finally lost after kSessionKept.
bool maintain(Session& session, RadioLink link, bool in_radio_hole, Duration now, Outbox& out);
/// Message 32 was received: 159 when X is supported, else 154 and termination (3.5.3.8). True when established.
/// `newest`: the highest version of the unit.
bool check_version(Session& session, std::uint8_t M_VERSION, lang::SystemVersion newest, Duration now, Outbox& out);
/// Message 38 of 2.3 and later was received (3.5.3.7.4).
void note_acknowledged(Session& session);
/// The connection request of this cycle is not made yet: it follows in the next.
void withdraw_request(Session& session);
/// Message 39 was received.
void end(Session& session, Duration now, Outbox& out);
/// No message since T_NVCONTACT + kContactExtra: the connection is released and set up again (3.16.3.4.3).
void reconnect(Session& session, Duration now, Outbox& out);

}  // namespace evc::radio
