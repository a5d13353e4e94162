#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "base/inplace_vector.h"
#include "base/location.h"
#include "base/units.h"
#include "lang/schema.h"
#include "terms/error_report.h"
#include "terms/message_numbers.h"

namespace evc::radio {

/// The address of an RBC or radio infill unit. NID_RBC 16383: the last one known; NID_RADIO all ones: the short number
/// stored on board (3.5.3.15), which the bearer has.
struct Rbc {
  std::uint16_t NID_C = 0, NID_RBC = 0;
  std::uint64_t NID_RADIO = 0;
  bool infill_unit = false;  ///< NID_RBC is NID_RIU
  friend constexpr bool operator==(const Rbc&, const Rbc&) = default;
  constexpr bool same_id(const Rbc& other) const {
    return NID_C == other.NID_C && NID_RBC == other.NID_RBC && infill_unit == other.infill_unit;
  }
};
inline constexpr std::uint16_t kLastKnownRbc = 16383;
/// An RBC that is interfaced to FRMCS only has no number (packets 31 and 32): this unit, which has GSM-R, cannot call
/// it.
inline constexpr std::uint64_t kNoNumber = lang::kNo_number;
inline constexpr std::uint64_t kStoredNumber = 0xFFFF'FFFF'FFFF'FFFFu;
/// The RBC that answers the short number, until the bearer reports its identity: all ones (3.5.3.11).
inline constexpr Rbc kUnknownRbc{1023, 16383, kStoredNumber};
inline constexpr std::uint32_t kUnknownLrbg = 0xFF'FFFF;
inline constexpr std::uint32_t kUnknownTime = 0xFFFF'FFFF;

/// The on-board clock in 10 ms units as T_TRAIN counts (7.5.1.154); never the code for unknown.
constexpr std::uint32_t T_TRAIN_of(Duration now) {
  // To the nearest tick; the kernel has no libm.
  // NOLINTNEXTLINE(bugprone-incorrect-roundings)
  return static_cast<std::uint32_t>(static_cast<std::uint64_t>(now.si * 100.0 + 0.5) % 0xFFFF'FFFFu);
}

/// The on-board time of a stamp that is at most 248 days old; never later than now.
constexpr Duration time_of(std::uint32_t T_TRAIN, Duration now) {
  const auto age = static_cast<std::int32_t>(T_TRAIN_of(now) - T_TRAIN);
  return age > 0 ? now - Duration{static_cast<double>(age) / 100.0} : now;
}

/// The header of a message to the train (8.4.4.6).
struct Header {
  std::uint8_t NID_MESSAGE = 0;
  std::uint32_t T_TRAIN = kUnknownTime;
  bool M_ACK = false;
};

/// Those with which the unit can have a session: two RBCs (3.15.1), two radio infill units (3.9.3.6).
enum class Peer : std::uint8_t { supervising, other, infill_1, infill_2 };
inline constexpr std::array<Peer, 2> kRbcs{Peer::supervising, Peer::other};
inline constexpr std::array<Peer, 4> kPeers{Peer::supervising, Peer::other, Peer::infill_1, Peer::infill_2};
inline constexpr std::array<Peer, 2> kInfillUnits{Peer::infill_1, Peer::infill_2};
constexpr bool is_infill_unit(Peer peer) { return peer == Peer::infill_1 || peer == Peer::infill_2; }

/// A message to send; `compose` makes the bits.
struct Intent {
  std::uint8_t NID_MESSAGE = 0;
  Peer to = Peer::supervising;
  std::uint32_t T_TRAIN = 0;                     ///< its own stamp
  std::uint32_t T_TRAIN_REF = 0;                 ///< 137, 138, 146: of the message answered
  std::uint8_t NID_EM = 0, Q_EMERGENCYSTOP = 0;  ///< 147, in the codes of the RBC's version
  std::uint8_t Q_MARQSTREASON = 0;               ///< 132
  std::uint8_t Q_STATUS = 0;                     ///< 157: 0 invalid, 1 valid, 2 unknown
  std::uint8_t NID_TEXTMESSAGE = 0;              ///< 158
  std::uint8_t Q_INFILL = 0;                     ///< 153: 0 the area is entered, 1 its signal was read or missed
  GroupId signal;                                ///< 153: at the next main signal
  std::optional<ErrorReport> M_ERROR;            ///< packet 4 in 136, 157
  std::optional<std::uint32_t> NID_LTRBG;        ///< packet 9 in 132
  bool running_number = false;                   ///< packet 5 in 136, 157, if there is a number
  bool train_data = false;                       ///< packet 11 in 157, from 2.2 on
  bool consist_length = false;                   ///< packet 10 in 157, from 2.3 on
  bool default_train_data = false;               ///< packet 12 in 131
  bool desk_open = false;                        ///< 150, from 2.3 on
};

/// Whether the message holds packet 0 or 1, the position report (8.6).
constexpr bool reports_position(std::uint8_t NID_MESSAGE) {
  switch (NID_MESSAGE) {
    case message::acknowledgement:
    case message::no_compatible_version:
    case message::session_initiated:
    case message::session_terminated:
    case message::session_established:
      return false;
    default:
      return true;
  }
}

/// The messages and orders to the bearer of one cycle.
struct Outbox {
  static constexpr std::size_t kMessages = 24;
  InplaceVector<Intent, kMessages> messages;
  Peer to = Peer::supervising;            ///< of the messages that are sent next (Addressed)
  std::optional<Rbc> connect;             ///< one request in a cycle
  std::optional<Rbc> disconnect;          ///< the first one of this cycle
  InplaceVector<Rbc, 8> also_disconnect;  ///< the others: due in the next cycles
  bool inform_no_version = false;         ///< message 154 was sent: the driver is informed (3.5.3.7 d)
  bool lost = false;                      ///< there were more messages than room
  /// When there is no room an answer to an emergency stop (147) takes the place of the last message that is not one.
  void send(Intent intent) {
    intent.to = to;
    if (messages.push_back(intent)) return;
    lost = true;
    if (intent.NID_MESSAGE != message::emergency_stop_acknowledged) return;
    for (std::size_t i = messages.size(); i-- > 0;)
      if (messages[i].NID_MESSAGE != message::emergency_stop_acknowledged) {
        messages[i] = intent;
        return;
      }
  }
  void send(std::uint8_t NID_MESSAGE) {
    Intent intent;
    intent.NID_MESSAGE = NID_MESSAGE;
    send(intent);
  }
  void release(const Rbc& rbc) {
    if (!disconnect)
      disconnect = rbc;
    else
      (void)also_disconnect.push_back(rbc);  // four sessions: there is room
  }
};

/// While it exists, messages are sent to this RBC.
class Addressed {
 public:
  Addressed(Outbox& out, Peer to) : out_(out), before_(out.to) { out.to = to; }
  ~Addressed() { out_.to = before_; }
  Addressed(const Addressed&) = delete;
  Addressed& operator=(const Addressed&) = delete;

 private:
  Outbox& out_;
  Peer before_;
};

}  // namespace evc::radio
