#include <array>

#include "lang/decode.h"
#include "lang/encode.h"
#include "lang/message_codec.h"
#include "lang/messages.h"
#include "lang/packet_codec.h"
#include "lang/translate.h"
#include "terms/message_numbers.h"

namespace evc::lang {
namespace {

constexpr unsigned header_bits = 8 + 10;  // NID_MESSAGE, L_MESSAGE

template <class M, class View>
FaultAt read_message(const View& view, M& message, std::size_t* end) {
  codec::Source from{BitReader(view.bytes, view.bytes.size() * 8, header_bits)};
  codec::read_structure<0>(from, codec::Scope<M, void>{message, nullptr});
  if (end != nullptr) *end = from.in.position();
  if (from.in.faulty()) return {Fault::truncated, from.in.position(), -1, from.in.failed_on(), 0};
  if (from.spare_variable != nullptr)
    return {Fault::spare_value, from.spare_bit, -1, from.spare_variable, from.spare_value};
  return {};
}

/// Messages that are the same in every version (8.4.4.1.1) can be read before a version is agreed.
template <class M>
constexpr bool is_of(std::uint8_t nid, SystemVersion sv) {
  const Versions version = known_version(sv);
  return nid == M::info.NID_MESSAGE && (version == 0 || (M::info.versions & version) != 0);
}

/// The same for decode().
template <class M, class View>
Fault read_message(const View& view, M& message) {
  const FaultAt at = read_message(view, message, nullptr);
  return is_let_through(at, view.sv) ? Fault::none : at.fault;
}

Fault not_this() { return Fault::not_a_packet_of_this_kind; }

}  // namespace

// Messages of X = 1 in the form of X = 2 (6.6.3.3): D_REF is 0 in 15 and 34; NID_LRBG is unknown in 40, 41.
template <class M>
Fault decode(const MessageToTrainView& view, M& message) {
  if (is_of<M>(view.NID_MESSAGE, view.sv)) {
    const Fault fault = read_message(view, message);
    if constexpr (M::info.NID_MESSAGE == message::train_rejected || M::info.NID_MESSAGE == message::train_accepted)
      if (view.sv.x == 1) message.NID_LRBG.raw = 16777215u;
    return fault;
  }
  if constexpr (std::is_same_v<M, Message15>) {
    Message15_v1_0 m;
    const Fault fault = decode(view, m);
    message = {m.T_TRAIN, m.M_ACK, m.NID_LRBG, m.NID_EM, m.Q_SCALE, {}, m.Q_DIR, m.D_EMERGENCYSTOP};
    return fault;
  } else if constexpr (std::is_same_v<M, Message34>) {
    Message34_v1_0 m;
    const Fault fault = decode(view, m);
    message = {m.T_TRAIN, m.M_ACK, m.NID_LRBG, m.Q_SCALE, {}, m.Q_DIR, m.D_TAFDISPLAY, m.L_TAFDISPLAY};
    return fault;
  } else {
    return not_this();
  }
}
template <class M>
Fault decode(const MessageToTrackView& view, M& message) {
  return is_of<M>(view.NID_MESSAGE, view.sv) ? read_message(view, message) : not_this();
}

template <class M>
void begin_message(BitWriter& out, const M& message) {
  if (out.position() != 0) return out.fail();
  out.write(M::info.NID_MESSAGE, 8);
  out.write(0, 10);
  codec::write_structure<0>(out, codec::Scope<const M, void>{message, nullptr});
}
void end_message(BitWriter& out) {
  if (out.position() % 8 != 0) out.write(0, static_cast<unsigned>(8 - out.position() % 8));
  out.patch(8, out.position() / 8, 10);
}

#define EVC_TO_TRAIN(M)                                    \
  template Fault decode<M>(const MessageToTrainView&, M&); \
  template void begin_message<M>(BitWriter&, const M&);
#define EVC_TO_TRACK(M)                                    \
  template Fault decode<M>(const MessageToTrackView&, M&); \
  template void begin_message<M>(BitWriter&, const M&);
EVC_MESSAGES_TO_TRAIN(EVC_TO_TRAIN)
EVC_MESSAGES_TO_TRACK(EVC_TO_TRACK)

namespace {

template <class M, class View>
FaultAt check_message(const View& view, std::size_t& end) {
  M message;
  return read_message(view, message, &end);
}
#define EVC_ROW(M) {&M::info, &check_message<M, MessageToTrainView>},
constexpr MessageToTrainCodec messages_to_train[]{EVC_MESSAGES_TO_TRAIN(EVC_ROW)};
#undef EVC_ROW
#define EVC_ROW(M) {&M::info, &check_message<M, MessageToTrackView>},
constexpr MessageToTrackCodec messages_to_track[]{EVC_MESSAGES_TO_TRACK(EVC_ROW)};
#undef EVC_ROW

template <class List>
auto find(const List& list, std::uint8_t nid, SystemVersion sv) {
  const Versions version = known_version(sv);
  for (const auto& row : list)
    if (row.info->NID_MESSAGE == nid && (version == 0 || (row.info->versions & version) != 0)) return &row;
  return static_cast<decltype(&list[0])>(nullptr);
}

}  // namespace

const MessageToTrainCodec* find_message_to_train(std::uint8_t nid, SystemVersion sv) {
  return find(messages_to_train, nid, sv);
}
const MessageToTrackCodec* find_message_to_track(std::uint8_t nid, SystemVersion sv) {
  return find(messages_to_track, nid, sv);
}

void begin_telegram(BitWriter& out, const TelegramHeader& h) {
  out.write(h.Q_UPDOWN.raw, var::Q_UPDOWN::bits);
  out.write(h.M_VERSION.raw, var::M_VERSION::bits);
  out.write(h.Q_MEDIA.raw, var::Q_MEDIA::bits);
  out.write(h.N_PIG.raw, var::N_PIG::bits);
  out.write(h.N_TOTAL.raw, var::N_TOTAL::bits);
  out.write(h.M_DUP.raw, var::M_DUP::bits);
  out.write(h.M_MCOUNT.raw, var::M_MCOUNT::bits);
  out.write(h.NID_C.raw, var::NID_C::bits);
  out.write(h.NID_BG.raw, var::NID_BG::bits);
  out.write(h.Q_LINK.raw, var::Q_LINK::bits);
}
void end_telegram(BitWriter& out, std::size_t bits) {
  out.write(255, 8);
  if (bits != 0 && out.position() > bits) return out.fail();
  while (!out.faulty() && out.position() < bits) {
    const std::size_t left = bits - out.position();
    const unsigned ones = left < 8 ? static_cast<unsigned>(left) : 8u;
    out.write((1u << ones) - 1u, ones);
  }
}

}  // namespace evc::lang
