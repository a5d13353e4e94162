#include "radio/compose.h"

#include <array>

#include "lang/encode.h"
#include "lang/messages.h"
#include "lang/packets/train_packet_0.h"
#include "lang/packets/train_packet_1.h"
#include "lang/packets/train_packet_11.h"
#include "lang/packets/train_packet_2.h"
#include "lang/packets/train_packet_3.h"
#include "lang/packets/train_packet_4.h"
#include "lang/packets/train_packet_5.h"
#include "lang/packets/train_packet_9.h"
#include "lang/translate.h"
#include "terms/mode.h"

namespace evc::radio {
namespace {

struct Composer {
  const Intent& intent;
  const PositionReport& position;
  const TrainDataReport& train;
  const OnBoard& unit;
  bool version_1;       // X = 1
  bool tells_versions;  // 2.1 and above: packet 2 in message 159, else packet 3
  BitWriter& out;
};

/// X = 1 has no passive shunting (6.6.3.4.5 [1]).
std::uint8_t M_MODE_for(std::uint8_t M_MODE, bool version_1) {
  return version_1 && M_MODE == evc::M_MODE(Mode::PS) ? evc::M_MODE(Mode::SH) : M_MODE;
}

template <class P>
P position_packet(const PositionReport& r, bool version_1) {
  P p;
  p.Q_SCALE.raw = r.Q_SCALE;
  p.NID_LRBG.raw = r.NID_LRBG;
  if constexpr (requires { p.NID_PRVLRBG; }) p.NID_PRVLRBG.raw = r.NID_PRVLRBG ? *r.NID_PRVLRBG : kUnknownLrbg;
  p.D_LRBG.raw = r.D_LRBG;
  p.Q_DIRLRBG.raw = r.Q_DIRLRBG;
  p.Q_DLRBG.raw = r.Q_DLRBG;
  p.L_DOUBTOVER.raw = r.L_DOUBTOVER;
  p.L_DOUBTUNDER.raw = r.L_DOUBTUNDER;
  p.Q_LENGTH.raw = r.Q_LENGTH;
  p.L_TRAININT.raw = r.L_TRAININT;
  p.V_TRAIN.raw = r.V_TRAIN;
  p.Q_DIRTRAIN.raw = r.Q_DIRTRAIN;
  p.M_MODE.raw = M_MODE_for(r.M_MODE, version_1);
  p.M_LEVEL.raw = r.M_LEVEL;
  p.NID_NTC.raw = r.NID_NTC;
  return p;
}

template <class M>
M message_of(const Composer& c) {
  M m;
  m.T_TRAIN.raw = c.intent.T_TRAIN;
  m.NID_ENGINE.raw = c.unit.NID_ENGINE;
  return m;
}

void put_position(const Composer& c) {
  if (c.version_1) {
    if (c.position.NID_PRVLRBG)
      lang::encode(c.out, position_packet<lang::TrainPacket1_v1_0>(c.position, true));
    else
      lang::encode(c.out, position_packet<lang::TrainPacket0_v1_0>(c.position, true));
  } else if (c.position.NID_PRVLRBG) {
    lang::encode(c.out, position_packet<lang::TrainPacket1>(c.position, false));
  } else {
    lang::encode(c.out, position_packet<lang::TrainPacket0>(c.position, false));
  }
}

/// Packets 4 and 5 of 136 and 157; X = 1 has no packet 5 and fewer error codes (6.6.3.4.5 [2]).
void put_error_and_number(const Composer& c) {
  if (c.intent.M_ERROR) {
    lang::TrainPacket4 p;
    p.M_ERROR.raw = static_cast<std::uint8_t>(*c.intent.M_ERROR);
    if (!c.version_1)
      lang::encode(c.out, p);
    else if (*c.intent.M_ERROR <= ErrorReport::safety_critical_fault)
      lang::encode(c.out, lang::for_version_1(p));
  }
  if (!c.version_1 && c.intent.running_number && c.train.NID_OPERATIONAL) {
    lang::TrainPacket5 p;
    p.NID_OPERATIONAL.raw = *c.train.NID_OPERATIONAL;
    lang::encode(c.out, p);
  }
}

// --- packet 11

void put_train_data(const Composer& c) {
  const TrainDataReport& t = c.train;
  lang::TrainPacket11 p;
  p.NC_CDTRAIN.raw = t.NC_CDTRAIN;
  p.NC_TRAIN.raw = t.NC_TRAIN;
  p.L_TRAIN.raw = t.L_TRAIN;
  p.V_MAXTRAIN.raw = t.V_MAXTRAIN;
  p.M_LOADINGGAUGE.raw = t.M_LOADINGGAUGE;
  p.M_AXLELOADCAT.raw = t.M_AXLELOADCAT;
  p.M_AIRTIGHT.raw = t.M_AIRTIGHT;
  p.N_AXLE.raw = t.N_AXLE;
  for (const TrainDataReport::Traction& traction : t.tractions) {
    lang::TrainPacket11_tractions e;
    e.M_VOLTAGE.raw = traction.M_VOLTAGE;
    e.NID_CTRACTION.raw = traction.NID_CTRACTION;
    (void)p.tractions.push_back(e);  // 8 of 31
  }
  for (const std::uint8_t ntc : t.NID_NTC) {
    lang::TrainPacket11_ntcs e;
    e.NID_NTC.raw = ntc;
    (void)p.ntcs.push_back(e);
  }
  lang::encode(c.out, p);
}

/// Bits of NC_TRAIN of X = 1: cant deficiency 80 100 130 150 165 180 210 225 245 275 300 mm (6.5.1.5.34.1).
constexpr std::array<std::uint8_t, 11> kCantBit{1, 2, 3, 4, 5, 6, 13, 7, 12, 0, 8};
/// M_AXLELOAD of X = 1 in 0.5 t: the axle load of each category A HS17 B1 B2 C2 C3 C4 D2 D3 D4 D4XL E4 E5.
constexpr std::array<std::uint8_t, 13> kAxleLoad{32, 34, 36, 36, 40, 40, 40, 45, 45, 45, 45, 50, 50};

void put_train_data_version_1(const Composer& c) {
  const TrainDataReport& t = c.train;
  lang::TrainPacket11_v1_0 p;
  p.NID_OPERATIONAL.raw = t.NID_OPERATIONAL ? *t.NID_OPERATIONAL : 0xFFFF'FFFFu;
  unsigned categories = t.NC_CDTRAIN < kCantBit.size() ? 1u << kCantBit[t.NC_CDTRAIN] : 0u;
  // Freight P, freight G or passenger; several of them: none (6.6.3.4.5 [3b]).
  if (t.NC_TRAIN == 1 || t.NC_TRAIN == 2 || t.NC_TRAIN == 4) categories |= unsigned{t.NC_TRAIN} << 9;
  p.NC_TRAIN.raw = static_cast<std::uint16_t>(categories);
  p.L_TRAIN.raw = t.L_TRAIN;
  p.V_MAXTRAIN.raw = t.V_MAXTRAIN;
  p.M_AXLELOAD.raw = t.M_AXLELOADCAT < kAxleLoad.size() ? kAxleLoad[t.M_AXLELOADCAT] : std::uint8_t{126};
  p.M_AIRTIGHT.raw = t.M_AIRTIGHT;
  for (const std::uint8_t ntc : t.NID_NTC) {
    lang::TrainPacket11_ntcs e;
    e.NID_NTC.raw = ntc;
    (void)p.ntcs.push_back(e);
  }
  lang::encode(c.out, p);
}

// --- messages

void put_ma_request(const Composer& c) {
  if (c.version_1) {
    auto m = message_of<lang::TrainMessage132_v1_0>(c);
    m.Q_TRACKDEL.raw = (c.intent.Q_MARQSTREASON & 8u) != 0 ? 1 : 0;
    lang::begin_message(c.out, m);
  } else {
    auto m = message_of<lang::TrainMessage132>(c);
    m.Q_MARQSTREASON.raw = c.intent.Q_MARQSTREASON;
    lang::begin_message(c.out, m);
  }
  put_position(c);
  if (c.intent.NID_LTRBG) {
    lang::TrainPacket9 p;
    p.NID_LTRBG.raw = *c.intent.NID_LTRBG;
    lang::encode(c.out, p);
  }
}

void put_emergency_answer(const Composer& c) {
  if (c.version_1) {
    auto m = message_of<lang::TrainMessage147_v1_0>(c);
    m.NID_EM.raw = c.intent.NID_EM;
    m.Q_EMERGENCYSTOP.raw = c.intent.Q_EMERGENCYSTOP;
    lang::begin_message(c.out, m);
  } else {
    auto m = message_of<lang::TrainMessage147>(c);
    m.NID_EM.raw = c.intent.NID_EM;
    m.Q_EMERGENCYSTOP.raw = c.intent.Q_EMERGENCYSTOP;
    lang::begin_message(c.out, m);
  }
  put_position(c);
}

void put_established(const Composer& c) {
  lang::begin_message(c.out, message_of<lang::TrainMessage159>(c));
  if (c.tells_versions) {
    lang::TrainPacket2 p;
    p.M_VERSION.raw = 0x21;
    for (const std::uint8_t M_VERSION : std::array<std::uint8_t, 3>{0x20, 0x11, 0x10}) {
      lang::TrainPacket2_versions e;
      e.M_VERSION.raw = M_VERSION;
      (void)p.versions.push_back(e);
    }
    lang::encode(c.out, p);
    return;
  }
  lang::TrainPacket3 p;
  for (const std::uint64_t number : c.unit.telephone_numbers) {
    lang::TrainPacket3_numbers e;
    e.NID_RADIO.raw = number;
    (void)p.numbers.push_back(e);
  }
  lang::encode(c.out, p);
}

template <class M>
void put_plain(const Composer& c) {
  lang::begin_message(c.out, message_of<M>(c));
  put_position(c);
}
template <class M>
void put_without_position(const Composer& c) {
  lang::begin_message(c.out, message_of<M>(c));
}
template <class M>
void put_answer(const Composer& c) {
  auto m = message_of<M>(c);
  m.T_TRAIN_REF.raw = c.intent.T_TRAIN_REF;
  lang::begin_message(c.out, m);
  put_position(c);
}

void put_acknowledgement(const Composer& c) {
  auto m = message_of<lang::TrainMessage146>(c);
  m.T_TRAIN_REF.raw = c.intent.T_TRAIN_REF;
  lang::begin_message(c.out, m);
}

void put_start_of_mission_report(const Composer& c) {
  auto m = message_of<lang::TrainMessage157>(c);
  m.Q_STATUS.raw = c.intent.Q_STATUS;
  lang::begin_message(c.out, m);
  put_position(c);
  put_error_and_number(c);
}

void put_infill_request(const Composer& c) {
  auto m = message_of<lang::TrainMessage153>(c);
  m.NID_C.raw = c.intent.signal.NID_C;
  m.NID_BG.raw = c.intent.signal.NID_BG;
  m.Q_INFILL.raw = c.intent.Q_INFILL;
  lang::begin_message(c.out, m);
  put_position(c);
}

void put_text_acknowledged(const Composer& c) {
  auto m = message_of<lang::TrainMessage158>(c);
  m.NID_TEXTMESSAGE.raw = c.intent.NID_TEXTMESSAGE;
  lang::begin_message(c.out, m);
  put_position(c);
}

/// The whole message except length and padding. False: this message is not sent to this version.
bool put(const Composer& c) {
  switch (c.intent.NID_MESSAGE) {
    case message::validated_train_data:
      put_plain<lang::TrainMessage129>(c);
      c.version_1 ? put_train_data_version_1(c) : put_train_data(c);
      return true;
    case message::request_for_shunting:
      put_plain<lang::TrainMessage130>(c);
      return true;
    case message::ma_request:
      put_ma_request(c);
      return true;
    case message::position_report:
      put_plain<lang::TrainMessage136>(c);
      put_error_and_number(c);
      return true;
    case message::shortening_granted:
      put_answer<lang::TrainMessage137>(c);
      return true;
    case message::shortening_rejected:
      put_answer<lang::TrainMessage138>(c);
      return true;
    case message::acknowledgement:
      put_acknowledgement(c);
      return true;
    case message::emergency_stop_acknowledged:
      put_emergency_answer(c);
      return true;
    case message::track_ahead_free_granted:
      put_plain<lang::TrainMessage149>(c);
      return true;
    case message::end_of_mission:
      put_plain<lang::TrainMessage150>(c);
      return true;
    case message::radio_infill_request:
      put_infill_request(c);
      return true;
    case message::no_compatible_version:
      put_without_position<lang::TrainMessage154>(c);
      return true;
    case message::session_initiated:
      put_without_position<lang::TrainMessage155>(c);
      return true;
    case message::session_terminated:
      put_without_position<lang::TrainMessage156>(c);
      return true;
    case message::som_position_report:
      put_start_of_mission_report(c);
      return true;
    case message::text_acknowledged:
      if (c.version_1) return false;
      put_text_acknowledged(c);
      return true;
    case message::session_established:
      put_established(c);
      return true;
    default:
      return false;
  }
}

}  // namespace

std::size_t compose(const Intent& intent, const PositionReport& position, const TrainDataReport& train,
                    const OnBoard& unit, std::uint8_t M_VERSION, std::span<std::uint8_t> bytes) {
  BitWriter out(bytes);
  const Composer composer{intent, position, train, unit, (M_VERSION >> 4) == 1, M_VERSION >= 0x21, out};
  if (!put(composer)) return 0;
  lang::end_message(out);
  return out.faulty() ? 0 : out.bytes().size();
}

}  // namespace evc::radio
