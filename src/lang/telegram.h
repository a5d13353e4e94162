#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "base/inplace_vector.h"
#include "lang/fault.h"
#include "lang/schema.h"
#include "lang/variables.h"
#include "terms/srs_version.h"

// Telegrams and messages as received: header variables and the places of the packets. Nothing is
// copied or allocated; a view is valid as long as the bytes it was made from.
namespace evc::lang {

/// A packet inside a telegram or message.
struct PacketView {
  /// The packet number of version 2.1: 200, 206, 207 and 239 of version 1.1 are 0, 68, 70 and 39 here
  /// (6.6.3.2.3, translations 15, 17, 18, 19), 73 and 74 of 2.2 and later are 72 and 76 (6.6.5.2.3, 6.6.5.2.4
  /// backwards), 31 and 32 of 2.3 and later 131 and 42.
  std::uint16_t NID_PACKET = 0;
  std::uint16_t L_PACKET = 0;  ///< bits, header included; for packets without L_PACKET their fixed length
  std::uint32_t bit = 0;       ///< of NID_PACKET in `bytes`
  std::uint8_t Q_DIR = 0;      ///< raw; 2 (both) for packets without Q_DIR and from the train
  SystemVersion sv{0, 0};      ///< to be set in views not made by scan_...()
  Direction direction = Direction::to_train;
  bool known = false;                   ///< false: an unknown number, skipped by its length
  std::span<const std::uint8_t> bytes;  ///< of the whole telegram or message
};

inline constexpr std::size_t kPacketsMax = 48;
using PacketViews = InplaceVector<PacketView, kPacketsMax>;

/// A balise telegram (8.4.2). `fault` set: the telegram is not consistent and the other members are not valid, except
/// the part of the header that was read.
struct TelegramView {
  var::Q_UPDOWN Q_UPDOWN;
  var::M_VERSION M_VERSION;
  var::Q_MEDIA Q_MEDIA;
  var::N_PIG N_PIG;
  var::N_TOTAL N_TOTAL;
  var::M_DUP M_DUP;
  var::M_MCOUNT M_MCOUNT;
  var::NID_C NID_C;
  var::NID_BG NID_BG;
  var::Q_LINK Q_LINK;
  SystemVersion sv;
  PacketViews packets;        ///< without packet 255
  std::size_t bits_used = 0;  ///< up to the end of packet 255
  FaultAt at;
  Fault fault = Fault::none;  ///< = at.fault
};

/// A Euroloop message (8.4.3).
struct LoopMessageView {
  var::Q_UPDOWN Q_UPDOWN;
  var::M_VERSION M_VERSION;
  var::Q_MEDIA Q_MEDIA;
  var::NID_C NID_C;
  var::NID_LOOP NID_LOOP;
  SystemVersion sv;
  PacketViews packets;
  std::size_t bits_used = 0;
  FaultAt at;
  Fault fault = Fault::none;
};

/// A radio message from the RBC or RIU (8.4.4). Its own variables are read with decode(view, Message3&).
struct MessageToTrainView {
  std::uint8_t NID_MESSAGE = 0;
  std::uint16_t L_MESSAGE = 0;  ///< bytes
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  var::NID_LRBG NID_LRBG;
  SystemVersion sv;
  std::span<const std::uint8_t> bytes;
  PacketViews packets;        ///< mandatory ones first
  std::size_t bits_used = 0;  ///< up to the padding
  FaultAt at;
  Fault fault = Fault::none;
};

/// A radio message of a train (8.4.4).
struct MessageToTrackView {
  std::uint8_t NID_MESSAGE = 0;
  std::uint16_t L_MESSAGE = 0;
  var::T_TRAIN T_TRAIN;
  var::NID_ENGINE NID_ENGINE;
  SystemVersion sv;
  std::span<const std::uint8_t> bytes;
  PacketViews packets;
  std::size_t bits_used = 0;
  FaultAt at;
  Fault fault = Fault::none;
};

/// The highest version of a unit (6.4.2.1, .2): those of SRS 4.0.0 support all from 1.0 to 3.0.
constexpr SystemVersion newest_version(SrsVersion srs) {
  return srs == SrsVersion::v4_0_0 ? kNewest : kNewest_of_baseline_3;
}

/// The checks beyond those needed to find the packets.
///
/// With a later version Y (3.1 and above; to a unit of Baseline 3 also 2.2) a train skips packets with an unknown
/// number (3.17.3.11). This does not apply to unknown codes in known packets: the clause mentions NID_PACKET and
/// NID_MESSAGE only, and a speed or distance without a meaning cannot be used, so the message is inconsistent
/// (3.16.1.1.1).
enum class Check : std::uint8_t {
  /// For a train: all rules of 3.16.1, 3.16.2, 7.3 and 8.4, including the contents of every packet, its media, and
  /// 8.4.1.4.
  all,
  /// For a reader that is not a train: as `all`, but unknown packets are skipped in every version, and spare codes of a
  /// later Y are accepted, except Q_SCALE and Q_DIR, without which a packet cannot be interpreted.
  reading,
  structure,  ///< only that the packets can be found
};

/// Reads the user bits of a balise telegram. Every packet is checked (spare values, L_PACKET against
/// content, medium, duplicates), so decode() of its packets cannot fail. Telegrams of an unknown X
/// give Fault::unknown_version with the header read.
/// `newest`: the highest version of the unit (6.4.2.1); SystemVersion `sv` of the view is that of as_known().
TelegramView scan_telegram(std::span<const std::uint8_t> bytes, std::size_t bits, Check check = Check::all,
                           SystemVersion newest = kNewest);
LoopMessageView scan_loop_message(std::span<const std::uint8_t> bytes, std::size_t bits, Check check = Check::all,
                                  SystemVersion newest = kNewest);
/// Radio messages do not contain a version: `sv` is that of the session (3.5.3.5.2) as the unit knows it (as_known()).
/// `bytes` is the whole message: more or fewer than L_MESSAGE is a fault. Message 38 has no NID_LRBG: unknown.
/// `sender`: media::RIU, and only what a radio infill unit may send is consistent (8.7); 0: an RBC, or not known.
MessageToTrainView scan_message_to_train(std::span<const std::uint8_t> bytes, SystemVersion sv,
                                         Check check = Check::all, Media sender = 0);
/// What every message to the train begins with (8.4.4.6), also one of an unknown number.
struct MessageHead {
  std::uint32_t T_TRAIN = 0;
  bool M_ACK = false;
};
/// Absent: the message is too short, or its length is not L_MESSAGE.
std::optional<MessageHead> head_of_message_to_train(std::span<const std::uint8_t> bytes);
MessageToTrackView scan_message_to_track(std::span<const std::uint8_t> bytes, SystemVersion sv,
                                         Check check = Check::all);

/// Checks one packet at the start of `bytes`, of `bits` bits.
FaultAt check_packet(std::span<const std::uint8_t> bytes, std::size_t bits, Direction direction, SystemVersion sv);

}  // namespace evc::lang
