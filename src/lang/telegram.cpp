#include "lang/telegram.h"

#include "lang/codec.h"
#include "lang/decode.h"
#include "lang/instances.h"
#include "lang/message_codec.h"
#include "lang/message_table.h"
#include "lang/packet_codec.h"
#include "lang/packets/packet_131.h"
#include "lang/packets/packet_133.h"
#include "lang/packets/packet_143.h"
#include "lang/packets/packet_42.h"
#include "terms/message_numbers.h"
#include "terms/packet_numbers.h"

namespace evc::lang {
namespace {

enum class Ending : std::uint8_t { packet_255, padding };

/// What all packets of one telegram or message have in common.
struct Frame {
  std::span<const std::uint8_t> bytes;
  std::size_t end = 0;  // bits
  Direction direction = Direction::to_train;
  SystemVersion sv;
  Media medium = 0;  // 0: given by the list of the message
  Ending ending = Ending::packet_255;
  Check check = Check::all;
};

/// The number of version 2.1 (6.6.3.2.3, translations 15, 17 to 19; 6.6.5.2.3, 6.6.5.2.4); that of the same order to an
/// RBC with a number.
std::uint8_t working_number(std::uint8_t nid, Versions version, Direction direction) {
  if (direction == Direction::to_track) return nid;
  if ((version & (v2_2 | v2_3 | v3_0)) != 0)
    return nid == packet::plain_text_v2_2              ? std::uint8_t{packet::plain_text}
           : nid == packet::fixed_text_v2_2            ? std::uint8_t{packet::fixed_text}
           : nid == packet::rbc_transition_order_frmcs ? std::uint8_t{packet::rbc_transition_order}
           : nid == packet::session_management_frmcs   ? std::uint8_t{packet::session_management}
                                                       : nid;
  if (version != v1_1) return nid;
  return nid == packet::virtual_balise_cover_marker_v1 ? std::uint8_t{packet::virtual_balise_cover_marker}
         : nid == packet::track_condition_v1           ? std::uint8_t{packet::track_condition}
         : nid == packet::route_suitability_v1         ? std::uint8_t{packet::route_suitability}
         : nid == packet::traction_system_change_v1    ? std::uint8_t{packet::traction_system_change}
                                                       : nid;
}

FaultAt fault_in(Fault fault, std::size_t bit, std::uint8_t nid, const char* variable, std::uint64_t value) {
  return {fault, bit, nid, variable, value};
}

template <class S, class V>
constexpr Field<S, V> field(V S::*member) {
  return {V::name, member};
}

/// Finds the end of the packet at `view.bit`; `known` is null if the number is unknown.
[[gnu::always_inline]] inline FaultAt measure(const Frame& frame, PacketView& view, const PacketCodec* known) {
  const std::size_t left = frame.end - view.bit;
  const auto nid = static_cast<std::uint8_t>(view.NID_PACKET);
  if (known != nullptr && !known->has_length) [[unlikely]] {
    view.Q_DIR = 2;
    view.L_PACKET = 14;  // packet 0: NID_PACKET, NID_VBCMK
    return left < 14 ? fault_in(Fault::truncated, view.bit, nid, "NID_VBCMK", 0) : FaultAt{};
  }
  const bool with_direction = frame.direction == Direction::to_train;
  const unsigned header = with_direction ? 8 + 2 + 13 : 8 + 13;
  if (left < header) [[unlikely]]
    return fault_in(Fault::truncated, view.bit + 8, nid, with_direction ? "Q_DIR" : "L_PACKET", 0);
  const std::uint64_t window = BitReader(frame.bytes, frame.end, view.bit).window();
  view.Q_DIR = static_cast<std::uint8_t>(with_direction ? (window >> 54) & 3u : 2u);
  view.L_PACKET = static_cast<std::uint16_t>((window >> (64 - header)) & 0x1FFFu);
  const std::size_t at = view.bit + header - 13;
  if (view.L_PACKET < header) [[unlikely]]
    return fault_in(Fault::length_too_small, at, nid, "L_PACKET", view.L_PACKET);
  if (view.L_PACKET > left) [[unlikely]]
    return fault_in(Fault::length_beyond_end, at, nid, "L_PACKET", view.L_PACKET);
  return {};
}

bool is_let_through(const FaultAt& fault, const Frame& frame) {
  return frame.check == Check::reading && is_let_through(fault, frame.sv);
}

/// 6.6.3.1.1.1: a train ignores the contents of a fixed text of X = 1.
bool is_ignored(const Frame& frame, std::uint8_t nid) {
  return nid == packet::fixed_text && frame.sv.x == 1 && frame.check == Check::all &&
         frame.direction == Direction::to_train;
}

template <class P>
std::uint64_t number_in(const PacketView& view) {
  P p;
  return decode(view, p) == Fault::none ? p.NID_RADIO.raw : 0;
}
/// The subscriber number that a train is to call, 0 without one. Its digits A to E are "not used" (7.5.1.95): no spare
/// value (3.16.1.1.1), but no message that complies with the specification has one (3.16.1.1), and nobody can be called
/// so.
std::uint64_t number_to_call(const Frame& frame, const PacketView& view) {
  if (frame.check != Check::all || frame.direction != Direction::to_train) return 0;
  switch (view.NID_PACKET) {
    case packet::session_management:
      return number_in<Packet42>(view);
    case packet::rbc_transition_order:
      return number_in<Packet131>(view);
    case packet::radio_infill_area:
      return number_in<Packet133>(view);
    case packet::session_management_riu:
      return number_in<Packet143>(view);
    default:
      return 0;
  }
}

/// Checks a packet whose end is known. False: not consistent, with the reason in `at`.
bool check_found(const Frame& frame, const PacketView& view, const PacketCodec* codec, const PacketViews& before,
                 Instances& instances, FaultAt& at) {
  const auto nid = static_cast<std::uint8_t>(view.NID_PACKET);
  Fault fault = Fault::none;
  if (codec == nullptr) [[unlikely]] {
    if (frame.check == Check::all && !is_later(frame.sv)) fault = Fault::spare_value;
  } else if (!codec->check(view, at) && !is_let_through(at, frame)) [[unlikely]] {
    return false;
  } else if (frame.medium != 0 && (codec->info->media & frame.medium) == 0) {
    fault = Fault::wrong_medium;
  } else if ((nid == packet::virtual_balise_cover_marker || nid == packet::virtual_balise_cover_marker_v1) &&
             frame.direction == Direction::to_train && !before.empty() &&
             before.back().NID_PACKET != packet::virtual_balise_cover_marker) {
    fault = Fault::wrong_place;
  } else if (const std::uint64_t number = number_to_call(frame, view); is_in(decimal_digits, number)) [[unlikely]] {
    at = fault_in(Fault::spare_value, view.bit, nid, var::NID_RADIO::name, number);
    return false;
  } else if (instances.add(view, nid)) {
    fault = Fault::duplicate_packet;
  }
  if (fault == Fault::none) [[likely]]
    return true;
  at = fault_in(fault, view.bit, nid, "NID_PACKET", nid);
  return false;
}

/// The packets from bit `at` on; `used` is the bit after the last one (after packet 255).
FaultAt find_packets(const Frame& frame, std::size_t at, PacketViews& packets, std::size_t& used) {
  const Versions version = known_version(frame.sv);
  Instances instances(frame.medium == media::balise ? Composed::by_group : Composed::by_loop_or_radio);
  FaultAt fault;
  for (;;) {
    used = at;
    if (frame.end - at < 8) {
      if (frame.ending == Ending::padding) break;
      return {Fault::no_end_packet, frame.end, -1, "NID_PACKET", 0};
    }
    const auto nid = static_cast<std::uint8_t>(BitReader(frame.bytes, frame.end, at).read(8));
    if (nid == packet::end_of_information) {
      used = at + 8;
      if (frame.ending == Ending::packet_255) break;
      return fault_in(Fault::wrong_medium, at, nid, "NID_PACKET", nid);
    }
    const PacketCodec* codec = find_packet_codec(frame.direction, version, nid);
    const bool ignored = is_ignored(frame, nid);
    PacketView view{
        nid,        0, static_cast<std::uint32_t>(at), 0, frame.sv, frame.direction, codec != nullptr && !ignored,
        frame.bytes};
    if (const FaultAt unmeasured = measure(frame, view, codec)) return unmeasured;
    if (frame.check != Check::structure && !ignored)
      if (!check_found(frame, view, codec, packets, instances, fault)) return fault;
    view.NID_PACKET = working_number(nid, version, frame.direction);
    if (!packets.push_back(view)) return fault_in(Fault::too_many_packets, at, nid, "NID_PACKET", nid);
    at += view.L_PACKET;
  }
  return {};
}

/// M_VERSION as X.Y, if it can be read further (3.17.3.5). After 2.3 no Y of X = 2 is valid, which Baseline 3 does not
/// know (7.5.1.79).
FaultAt check_version(var::M_VERSION M_VERSION, SystemVersion newest) {
  const SystemVersion sv = system_version(M_VERSION.raw);
  const bool after_2_3 = newest == kNewest && sv.x == 2 && sv.y > 3;
  if (var::M_VERSION::is_spare(M_VERSION.raw) || after_2_3)
    return {Fault::spare_value, 1, -1, "M_VERSION", M_VERSION.raw};
  if (known_version(as_known(sv, newest)) == 0) return {Fault::unknown_version, 1, -1, "M_VERSION", M_VERSION.raw};
  return {};
}

template <class View>
void set_fault(View& view, const FaultAt& at) {
  view.at = at;
  view.fault = at.fault;
}

/// Whether the header is complete and for this receiver.
FaultAt check_header(const codec::Source& from, var::Q_UPDOWN Q_UPDOWN, var::M_VERSION M_VERSION, Check check,
                     SystemVersion newest) {
  if (from.in.faulty()) return {Fault::truncated, from.in.position(), -1, from.in.failed_on(), 0};
  if (Q_UPDOWN.raw != 1 && check != Check::structure) return {Fault::wrong_direction, 0, -1, "Q_UPDOWN", Q_UPDOWN.raw};
  if (const FaultAt at = check_version(M_VERSION, newest)) return at;
  const SystemVersion sv = as_known(system_version(M_VERSION.raw), newest);
  const FaultAt spare{Fault::spare_value, from.spare_bit, -1, from.spare_variable, from.spare_value};
  if (from.spare_variable == nullptr || check == Check::structure) return {};
  return check == Check::reading && is_let_through(spare, sv) ? FaultAt{} : spare;
}

bool contains(std::span<const std::uint8_t> list, std::uint8_t n) {
  for (const std::uint8_t i : list)
    if (i == n) return true;
  return false;
}

/// 8.4.4: the mandatory packets are first, in their order; the others are on the list of the message. Unknown packets
/// are ignored; by a train only where the message may have others than the mandatory ones (3.17.3.11 c). An RBC and a
/// radio infill unit each have a list of their own (8.4.4.4.1).
FaultAt check_list(const MessageRules& rules, const PacketViews& packets, std::size_t end, Check check, Media sender) {
  const std::span<const std::uint8_t> own = sender == media::RIU   ? rules.optional_from_riu
                                            : sender == media::RBC ? rules.optional_from_rbc
                                                                   : rules.optional;
  const std::span<const std::uint8_t> optional = own.empty() ? rules.optional : own;
  std::size_t next = 0;
  for (const auto& one_of : rules.required) {
    if (one_of.empty()) continue;
    if (next >= packets.size()) return {Fault::missing_packet, end, one_of[0], nullptr, 0};
    if (!contains(one_of, wire_number(packets[next])))
      return {Fault::missing_packet, packets[next].bit, one_of[0], nullptr, packets[next].NID_PACKET};
    ++next;
  }
  for (; next < packets.size(); ++next) {
    const std::uint8_t nid = wire_number(packets[next]);
    const bool passed_over = !packets[next].known && (check != Check::all || !optional.empty());
    if (!passed_over && !contains(optional, nid))
      return fault_in(Fault::unexpected_packet, packets[next].bit, nid, "NID_PACKET", nid);
  }
  return {};
}

/// The common part of messages of both directions.
template <class View, class Codec>
FaultAt scan_message(View& view, const Codec* (*find)(std::uint8_t, SystemVersion), Direction direction, Check check,
                     Media sender = 0) {
  BitReader in(view.bytes);
  view.NID_MESSAGE = static_cast<std::uint8_t>(in.read(8, "NID_MESSAGE"));
  view.L_MESSAGE = static_cast<std::uint16_t>(in.read(10, "L_MESSAGE"));
  if (in.faulty()) return {Fault::truncated, in.position(), -1, in.failed_on(), 0};
  const MessageRules* rules = find_message_rules(direction, view.NID_MESSAGE, view.sv);
  const Codec* codec = find(view.NID_MESSAGE, view.sv);
  if (rules == nullptr || codec == nullptr) {
    const Fault fault = known_version(view.sv) == 0 ? Fault::unknown_version : Fault::unknown_message;
    return {fault, 0, -1, "NID_MESSAGE", view.NID_MESSAGE};
  }
  if (sender != 0 && (rules->media & sender) == 0) return {Fault::wrong_medium, 0, -1, "NID_MESSAGE", view.NID_MESSAGE};
  if (view.L_MESSAGE != view.bytes.size()) return {Fault::message_length_mismatch, 8, -1, "L_MESSAGE", view.L_MESSAGE};
  std::size_t at = 0;
  const FaultAt fixed = codec->check(view, at);
  const Frame frame{view.bytes, view.bytes.size() * 8, direction, view.sv, 0, Ending::padding, check};
  const bool readable = check == Check::structure ? fixed.fault != Fault::truncated : is_let_through(fixed, frame);
  if (fixed && !readable) return fixed;
  if (const FaultAt fault = find_packets(frame, at, view.packets, view.bits_used)) return fault;
  return check != Check::structure ? check_list(*rules, view.packets, view.bits_used, check, sender) : FaultAt{};
}

constexpr std::uint32_t kUnknown_group = 16777215;  // 7.5.1.90
/// 8.7.16: the acknowledgement of session establishment ends with M_ACK.
bool has_no_group(std::span<const std::uint8_t> bytes, SystemVersion sv) {
  return !bytes.empty() && bytes[0] == message::session_establishment_acknowledged &&
         (known_version(sv) & (v2_3 | v3_0)) != 0;
}

}  // namespace

TelegramView scan_telegram(std::span<const std::uint8_t> bytes, std::size_t bits, Check check, SystemVersion newest) {
  TelegramView view;
  codec::Source from{BitReader(bytes, bits)};
  codec::get_run(from, view, field(&TelegramView::Q_UPDOWN), field(&TelegramView::M_VERSION),
                 field(&TelegramView::Q_MEDIA), field(&TelegramView::N_PIG), field(&TelegramView::N_TOTAL),
                 field(&TelegramView::M_DUP), field(&TelegramView::M_MCOUNT), field(&TelegramView::NID_C),
                 field(&TelegramView::NID_BG), field(&TelegramView::Q_LINK));
  view.sv = as_known(system_version(view.M_VERSION.raw), newest);
  FaultAt at = check_header(from, view.Q_UPDOWN, view.M_VERSION, check, newest);
  if (!at && check != Check::structure && view.Q_MEDIA.raw != 0) at = {Fault::wrong_medium, 8, -1, "Q_MEDIA", 1};
  if (!at) {
    const Frame frame{bytes, from.in.end(), Direction::to_train, view.sv, media::balise, Ending::packet_255, check};
    at = find_packets(frame, from.in.position(), view.packets, view.bits_used);
  }
  set_fault(view, at);
  return view;
}

LoopMessageView scan_loop_message(std::span<const std::uint8_t> bytes, std::size_t bits, Check check,
                                  SystemVersion newest) {
  LoopMessageView view;
  codec::Source from{BitReader(bytes, bits)};
  codec::get_run(from, view, field(&LoopMessageView::Q_UPDOWN), field(&LoopMessageView::M_VERSION),
                 field(&LoopMessageView::Q_MEDIA), field(&LoopMessageView::NID_C), field(&LoopMessageView::NID_LOOP));
  view.sv = as_known(system_version(view.M_VERSION.raw), newest);
  FaultAt at = check_header(from, view.Q_UPDOWN, view.M_VERSION, check, newest);
  if (!at && check != Check::structure && view.Q_MEDIA.raw != 1) at = {Fault::wrong_medium, 8, -1, "Q_MEDIA", 0};
  if (!at) {
    const Frame frame{bytes, from.in.end(), Direction::to_train, view.sv, media::loop, Ending::packet_255, check};
    at = find_packets(frame, from.in.position(), view.packets, view.bits_used);
  }
  set_fault(view, at);
  return view;
}

std::optional<MessageHead> head_of_message_to_train(std::span<const std::uint8_t> bytes) {
  BitReader in(bytes);
  (void)in.read(8, "NID_MESSAGE");
  const std::uint64_t L_MESSAGE = in.read(10, "L_MESSAGE");
  MessageHead head;
  head.T_TRAIN = static_cast<std::uint32_t>(in.read(32, "T_TRAIN"));
  head.M_ACK = in.read(1, "M_ACK") != 0;
  if (bytes.empty() || bytes[0] != message::session_establishment_acknowledged) (void)in.read(24, "NID_LRBG");
  if (in.faulty() || L_MESSAGE != bytes.size()) return std::nullopt;
  return head;
}

MessageToTrainView scan_message_to_train(std::span<const std::uint8_t> bytes, SystemVersion sv, Check check,
                                         Media sender) {
  MessageToTrainView view;
  view.sv = sv;
  view.bytes = bytes;
  BitReader in(bytes, bytes.size() * 8, 18);
  view.T_TRAIN.raw = static_cast<std::uint32_t>(in.read(32));
  view.M_ACK.raw = static_cast<std::uint8_t>(in.read(1));
  view.NID_LRBG.raw = static_cast<std::uint32_t>(in.read(24));
  if (has_no_group(bytes, sv)) view.NID_LRBG.raw = kUnknown_group;
  set_fault(view, scan_message(view, &find_message_to_train, Direction::to_train, check, sender));
  // 6.6.3.3 [2]: an RBC of X = 1 may give a group here, which has no meaning.
  if (sv.x == 1 && (view.NID_MESSAGE == message::train_rejected || view.NID_MESSAGE == message::train_accepted))
    view.NID_LRBG.raw = kUnknown_group;
  return view;
}

MessageToTrackView scan_message_to_track(std::span<const std::uint8_t> bytes, SystemVersion sv, Check check) {
  MessageToTrackView view;
  view.sv = sv;
  view.bytes = bytes;
  BitReader in(bytes, bytes.size() * 8, 18);
  view.T_TRAIN.raw = static_cast<std::uint32_t>(in.read(32));
  view.NID_ENGINE.raw = static_cast<std::uint32_t>(in.read(24));
  set_fault(view, scan_message(view, &find_message_to_track, Direction::to_track, check));
  return view;
}

FaultAt check_packet(std::span<const std::uint8_t> bytes, std::size_t bits, Direction direction, SystemVersion sv) {
  BitReader in(bytes, bits);
  const auto nid = static_cast<std::uint8_t>(in.read(8, "NID_PACKET"));
  if (in.faulty()) return {Fault::truncated, 0, -1, "NID_PACKET", 0};
  const PacketCodec* codec = find_packet_codec(direction, known_version(sv), nid);
  PacketView view{nid, 0, 0, 0, sv, direction, codec != nullptr, bytes};
  const Frame frame{bytes, in.end(), direction, sv, 0, Ending::padding, Check::reading};
  if (nid == packet::end_of_information) view.L_PACKET = 8;
  if (const FaultAt fault = nid == packet::end_of_information ? FaultAt{} : measure(frame, view, codec)) return fault;
  FaultAt at;
  if (codec != nullptr) (void)codec->check(view, at);
  return is_let_through(at, frame) ? FaultAt{} : at;
}

}  // namespace evc::lang
