#include "radio/compose.h"

#include <algorithm>
#include <array>

#include "lang/encode.h"
#include "lang/messages.h"
#include "lang/packets/train_packet_0.h"
#include "lang/packets/train_packet_1.h"
#include "lang/packets/train_packet_10.h"
#include "lang/packets/train_packet_11.h"
#include "lang/packets/train_packet_12.h"
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
  lang::SystemVersion version;  // in which both speak
  BitWriter& out;

  bool version_1() const { return version.x == 1; }
  bool since(std::uint8_t X, std::uint8_t Y) const { return version >= lang::SystemVersion{X, Y}; }
};

/// X = 3 has no level 3: what was ordered as such is level 2 (6.6.3.4.5 [1b]).
std::uint8_t M_LEVEL_for(std::uint8_t M_LEVEL, const Composer& c) {
  return c.since(3, 0) && M_LEVEL == evc::M_LEVEL(Level::L3) ? evc::M_LEVEL(Level::L2) : M_LEVEL;
}

template <class P>
P position_packet(const Composer& c) {
  const PositionReport& r = c.position;
  P p;
  p.Q_SCALE.raw = r.Q_SCALE;
  p.NID_LRBG.raw = r.NID_LRBG;
  if constexpr (requires { p.NID_PRVLRBG; }) p.NID_PRVLRBG.raw = r.NID_PRVLRBG ? *r.NID_PRVLRBG : kUnknownLrbg;
  p.D_LRBG.raw = r.D_LRBG;
  p.Q_DIRLRBG.raw = r.Q_DIRLRBG;
  p.Q_DLRBG.raw = r.Q_DLRBG;
  p.L_DOUBTOVER.raw = r.L_DOUBTOVER;
  p.L_DOUBTUNDER.raw = r.L_DOUBTUNDER;
  if constexpr (requires { p.Q_INTEGRITY; })
    p.Q_INTEGRITY.raw = r.Q_LENGTH;
  else
    p.Q_LENGTH.raw = r.Q_LENGTH;
  p.L_TRAININT.raw = r.L_TRAININT;
  constexpr std::uint8_t kStandstill = 127;
  p.V_TRAIN.raw = c.since(2, 3) && r.standstill ? kStandstill : r.V_TRAIN;  // 6.6.3.4.5 [1c]
  p.Q_DIRTRAIN.raw = r.Q_DIRTRAIN;
  p.M_MODE.raw = M_MODE(r.mode, c.version.x, c.version.y);
  p.M_LEVEL.raw = M_LEVEL_for(r.M_LEVEL, c);
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

/// Packet 0, or packet 1 with a previous LRBG, in one form.
template <class One, class Two>
void put_position_as(const Composer& c) {
  if (c.position.NID_PRVLRBG)
    lang::encode(c.out, position_packet<Two>(c));
  else
    lang::encode(c.out, position_packet<One>(c));
}

void put_position(const Composer& c) {
  if (c.since(3, 0)) return put_position_as<lang::TrainPacket0_v3_0, lang::TrainPacket1_v3_0>(c);
  if (c.since(2, 3)) return put_position_as<lang::TrainPacket0_v2_3, lang::TrainPacket1_v2_3>(c);
  if (c.since(2, 2)) return put_position_as<lang::TrainPacket0_v2_2, lang::TrainPacket1_v2_2>(c);
  if (!c.version_1()) return put_position_as<lang::TrainPacket0, lang::TrainPacket1>(c);
  put_position_as<lang::TrainPacket0_v1_0, lang::TrainPacket1_v1_0>(c);
}

/// Packet 4, if the version has the error: X = 1 fewer and other codes, 2.0 and 2.1 none of the odometer (6.6.3.4.5
/// [2], 6.6.5.3.7 [3], 6.6.5.4.6 [2]).
void put_error(const Composer& c, ErrorReport error) {
  const auto code = static_cast<std::uint8_t>(error);
  if (c.since(2, 2)) return lang::encode(c.out, lang::TrainPacket4_v2_2{{code}});
  const ErrorReport last = c.version_1() ? ErrorReport::safety_critical_fault : ErrorReport::double_repositioning;
  if (error > last) return;
  const lang::TrainPacket4 p{{code}};
  if (c.version_1())
    lang::encode(c.out, lang::for_version_1(p));
  else
    lang::encode(c.out, p);
}

/// Packets 4 and 5 of 136 and 157; X = 1 has no packet 5.
void put_error_and_number(const Composer& c) {
  if (c.intent.M_ERROR) put_error(c, *c.intent.M_ERROR);
  if (!c.version_1() && c.intent.running_number && c.train.NID_OPERATIONAL) {
    lang::TrainPacket5 p;
    p.NID_OPERATIONAL.raw = *c.train.NID_OPERATIONAL;
    lang::encode(c.out, p);
  }
}

// --- packets 10 to 12

/// In whole metres: the least and the nominal length rounded down, the greatest one up.
std::uint16_t at_most(Distance length) {
  constexpr double kGreatest = 4095.0;
  return static_cast<std::uint16_t>(length.si < 0.0 ? 0.0 : length.si > kGreatest ? kGreatest : length.si);
}
std::uint16_t at_least(Distance length) {
  const std::uint16_t whole = at_most(length);
  return whole < 4095 && static_cast<double>(whole) < length.si ? static_cast<std::uint16_t>(whole + 1) : whole;
}

void put_consist_length(const Composer& c) {
  lang::TrainPacket10 p;
  if (const std::optional<ConsistLength>& l = c.train.consist) {
    p.Q_SAFECONSISTLENGTH.raw = 1;
    p.L_CONSISTFRONTENGINENOM.raw = at_most(l->front.nominal);
    p.L_CONSISTFRONTENGINEMIN.raw = at_most(l->front.min);
    p.L_CONSISTFRONTENGINEMAX.raw = at_least(l->front.max);
    p.L_CONSISTREARENGINENOM.raw = at_most(l->rear.nominal);
    p.L_CONSISTREARENGINEMIN.raw = at_most(l->rear.min);
    p.L_CONSISTREARENGINEMAX.raw = at_least(l->rear.max);
  }
  lang::encode(c.out, p);
}

/// What packets 11 and 12 share.
template <class P>
void fill_train_data(const TrainDataReport& t, P& p) {
  p.NC_CDTRAIN.raw = t.NC_CDTRAIN;
  p.NC_TRAIN.raw = t.NC_TRAIN;
  p.V_MAXTRAIN.raw = t.V_MAXTRAIN;
  p.M_LOADINGGAUGE.raw = t.M_LOADINGGAUGE;
  p.M_AXLELOADCAT.raw = t.M_AXLELOADCAT;
  p.M_AIRTIGHT.raw = t.M_AIRTIGHT;
  p.N_AXLE.raw = t.N_AXLE;
  for (const RouteData::Traction& traction : t.tractions) {
    lang::TrainPacket11_tractions e;
    e.M_VOLTAGE.raw = traction.M_VOLTAGE;
    e.NID_CTRACTION.raw = traction.NID_CTRACTION;
    (void)p.tractions.push_back(e);  // 8 of 31
  }
}

void put_default_train_data(const Composer& c) {
  lang::TrainPacket12 p;
  fill_train_data(c.train, p);
  lang::encode(c.out, p);
}

void put_train_data(const Composer& c) {
  const TrainDataReport& t = c.train;
  lang::TrainPacket11 p;
  fill_train_data(t, p);
  p.L_TRAIN.raw = t.L_TRAIN;
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
  if (c.version_1()) {
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
  if (c.version_1()) {
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

/// All versions from 1.0 to the highest one (6.4.2.2), that one first.
void put_versions(const Composer& c) {
  lang::TrainPacket2 p;
  bool first = true;
  for (const std::uint8_t M_VERSION : std::array<std::uint8_t, 7>{0x30, 0x23, 0x22, 0x21, 0x20, 0x11, 0x10}) {
    if (lang::system_version(M_VERSION) > c.unit.newest) continue;
    if (first)
      p.M_VERSION.raw = M_VERSION;
    else
      (void)p.versions.push_back({{M_VERSION}});  // seven of 31
    first = false;
  }
  lang::encode(c.out, p);
}

void put_established(const Composer& c) {
  lang::begin_message(c.out, message_of<lang::TrainMessage159>(c));
  if (c.since(2, 1)) return put_versions(c);
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

void put_shortening_answer(const Composer& c) {
  const bool granted = c.intent.NID_MESSAGE == message::shortening_granted;
  granted ? put_answer<lang::TrainMessage137>(c) : put_answer<lang::TrainMessage138>(c);
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
  if (c.since(2, 3) && c.intent.consist_length) put_consist_length(c);
  if (c.since(2, 2) && c.intent.train_data) put_train_data(c);
}

void put_end_of_mission(const Composer& c) {
  if (!c.since(2, 3)) return put_plain<lang::TrainMessage150>(c);
  auto m = message_of<lang::TrainMessage150_v2_3>(c);
  m.Q_DESK.raw = c.intent.desk_open ? 1 : 0;
  lang::begin_message(c.out, m);
  put_position(c);
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

/// Messages 131 and 133, which are those of 2.3 and later.
bool put_for_supervised_manoeuvre(const Composer& c) {
  if (!c.since(2, 3)) return false;
  const bool request = c.intent.NID_MESSAGE == message::request_for_sm;
  request ? put_plain<lang::TrainMessage131>(c) : put_plain<lang::TrainMessage133>(c);
  put_consist_length(c);
  if (request && c.intent.default_train_data) put_default_train_data(c);
  return true;
}

/// The whole message except length and padding. False: this message is not sent to this version.
bool put(const Composer& c) {
  switch (c.intent.NID_MESSAGE) {
    case message::validated_train_data:
      put_plain<lang::TrainMessage129>(c);
      c.version_1() ? put_train_data_version_1(c) : put_train_data(c);
      return true;
    case message::request_for_shunting:
      put_plain<lang::TrainMessage130>(c);
      return true;
    case message::request_for_sm:
    case message::safe_consist_length:
      return put_for_supervised_manoeuvre(c);
    case message::ma_request:
      put_ma_request(c);
      return true;
    case message::position_report:
      put_plain<lang::TrainMessage136>(c);
      put_error_and_number(c);
      return true;
    case message::shortening_granted:
    case message::shortening_rejected:
      put_shortening_answer(c);
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
      put_end_of_mission(c);
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
      if (!c.version_1()) put_text_acknowledged(c);
      return !c.version_1();
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
  const Composer composer{intent, position, train, unit, std::min(lang::system_version(M_VERSION), unit.newest), out};
  if (!put(composer)) return 0;
  lang::end_message(out);
  return out.faulty() ? 0 : out.bytes().size();
}

}  // namespace evc::radio
