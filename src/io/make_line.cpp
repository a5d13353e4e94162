#include "io/make_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "io/json.h"
#include "io/line_file.h"
#include "io/number.h"
#include "io/rbc_contact.h"
#include "io/telegram_json.h"
#include "io/train_file.h"
#include "lang/encode.h"
#include "lang/layouts.h"
#include "lang/messages.h"
#include "lang/packets/packet_12.h"
#include "lang/packets/packet_136.h"
#include "lang/packets/packet_15.h"
#include "lang/packets/packet_21.h"
#include "lang/packets/packet_27.h"
#include "lang/packets/packet_3.h"
#include "lang/packets/packet_41.h"
#include "lang/packets/packet_42.h"
#include "lang/packets/packet_5.h"
#include "lang/packets/packet_57.h"
#include "lang/packets/packet_58.h"
#include "lang/packets/packet_65.h"
#include "lang/packets/packet_66.h"
#include "lang/packets/packet_72.h"
#include "lang/packets/packet_80.h"
#include "terms/level.h"

namespace evc::io {
namespace {

using io::JsonPlace;
using nlohmann::ordered_json;

constexpr double kBaliseSpacing = 3.0;  // metres, N_PIG 0 to N_PIG 1
constexpr std::size_t kLinks = 14;      // maximum number of groups announced ahead
constexpr double kBeyond = 100.0;       // distance by which profiles extend beyond the danger point
constexpr std::uint8_t kLocationAccuracy = 5;
constexpr lang::SystemVersion kVersion{2, 1};

struct Group {
  std::uint16_t NID_BG = 0;
  double position_m = 0.0;
};
struct Stretch {
  double from_m = 0.0, to_m = 0.0, value = 0.0;
};

/// A place for a message to the user.
std::string place(double m) {
  std::string text;
  append_number(text, m);
  return text + " m";
}

/// A packet's fields in one direction (nominal), in metres.
template <class P>
P nominal() {
  P p;
  p.Q_DIR.raw = 1;
  if constexpr (requires { p.Q_SCALE; }) p.Q_SCALE.raw = 1;
  return p;
}

constexpr double kFarthest = 32766.0;  // metres that a distance of 15 bits can hold; 32767 is special in some

/// The speed at `place`, which must have a code: V_STATIC and the others count in 5 km/h.
double speed(const JsonPlace& place, double least, double most) {
  const double kmh = place.number(least, most);
  if (kmh != 5.0 * std::round(kmh / 5.0)) place.fail("a multiple of 5 km/h");
  return kmh;
}
std::uint8_t codes_of_5_kmh(double kmh) { return static_cast<std::uint8_t>(std::lround(kmh / 5.0)); }
std::uint16_t whole(double v) { return static_cast<std::uint16_t>(std::lround(v)); }

constexpr const char* kOrders =
    "authority, national_values, session, level_transition, temporary_speed_restriction, "
    "revoke_temporary_speed_restriction, mode_profile, text, ma_requests, position_reports, packet or, in a group, "
    "infill";

/// An object with one key. A second order in it would be lost.
void require_one_order(const JsonPlace& order) {
  if (!order.is_object()) order.fail("an object");
  if (order.value().size() != 1)
    order.fail(std::to_string(order.value().size()) + " keys", std::string("one order: ") + kOrders);
}

/// Number and name of a packet that the JSON encoder has accepted.
std::string title(const JsonPlace& packet) {
  const std::int64_t NID_PACKET = packet["NID_PACKET"].integer(0, 255);
  for (const lang::PacketLayout& layout : lang::packet_layouts())
    if (layout.info->NID_PACKET == NID_PACKET && layout.info->direction == lang::Direction::to_train)
      return std::to_string(NID_PACKET) + " " + layout.info->name;
  return std::to_string(NID_PACKET);
}

/// Distances in metres between consecutive places, without accumulating rounding errors.
class Increments {
 public:
  Increments(double reference_m, const JsonPlace& root) : reference_(reference_m), root_(root) {}
  /// An error beyond 15 bits.
  std::uint16_t to(double place_m) {
    const long now = std::lround(place_m - reference_);
    const long step = now - last_;
    if (step > 32767)
      root_.fail(std::to_string(step) + " m to " + std::to_string(std::lround(place_m)) + " m",
                 "at most 32767 m between two groups or two steps of a profile");
    last_ = now;
    return static_cast<std::uint16_t>(step);
  }

 private:
  double reference_;
  const JsonPlace& root_;
  long last_ = 0;
};

/// The contents of one telegram or message, relative to its reference group.
class Encoder {
 public:
  Encoder(const JsonPlace& root, std::vector<Group> groups, std::vector<Stretch> gradient, std::vector<Stretch> ssp,
          std::uint16_t NID_C)
      : root_(root), groups_(std::move(groups)), gradient_(std::move(gradient)), ssp_(std::move(ssp)), NID_C_(NID_C) {}

  /// Appends the packets of one order of the description and names them in `contains`.
  void encode(BitWriter& out, const JsonPlace& order, const Group& reference, bool by_radio, ordered_json& contains) {
    contains_ = &contains;
    const auto is = [&](const char* key) { return order.find(key); };
    if (const auto p = is("authority")) return authority(out, *p, reference, by_radio);
    if (const auto p = is("national_values")) return national_values(out, *p);
    if (const auto p = is("session")) return session(out, *p);
    if (const auto p = is("level_transition")) return level_transition(out, *p, reference);
    if (const auto p = is("temporary_speed_restriction")) return restriction(out, *p, reference);
    if (const auto p = is("revoke_temporary_speed_restriction")) return revocation(out, *p);
    if (const auto p = is("mode_profile")) return mode_profile(out, *p, reference);
    if (const auto p = is("text")) return text(out, *p);
    if (const auto p = is("ma_requests")) return ma_requests(out, *p);
    if (const auto p = is("position_reports")) return position_reports(out, *p);
    if (const auto p = is("packet")) return packet(out, *p);
    order.fail("an unknown order", kOrders);
  }
  /// Packet 136: the group of the main signal is the reference of the orders after it in this
  /// telegram.
  const Group& infill(BitWriter& out, const JsonPlace& NID_BG, const Group& here, ordered_json& contains) {
    contains_ = &contains;
    const Group& main = group(NID_BG);
    if (main.position_m <= here.position_m) NID_BG.fail("a group ahead");
    lang::Packet136 packet;
    packet.Q_DIR.raw = 1;
    packet.NID_BG.raw = main.NID_BG;
    add(out, packet);
    return main;
  }
  const Group& group(const JsonPlace& NID_BG) const {
    const auto wanted = NID_BG.integer(0, 16382);
    const auto it = std::find_if(groups_.begin(), groups_.end(), [&](const Group& g) { return g.NID_BG == wanted; });
    if (it == groups_.end()) NID_BG.fail("the NID_BG of a group");
    return *it;
  }
  const std::vector<Group>& groups() const { return groups_; }
  std::uint16_t NID_C() const { return NID_C_; }

 private:
  template <class P>
  void add(BitWriter& out, const P& packet) {
    lang::encode(out, packet);
    contains_->push_back(std::to_string(P::info.NID_PACKET) + " " + P::info.name);
  }

  void authority(BitWriter& out, const JsonPlace& p, const Group& reference, bool by_radio) {
    p.know_only({"to_m", "danger_point_m", "release_kmh"});
    const double to = p["to_m"].number(reference.position_m, reference.position_m + 32000.0);
    const auto danger = p.find("danger_point_m");
    const double danger_m = danger ? danger->number(to, to + 5000.0) : to;
    const auto release = p.find("release_kmh");
    const auto fill = [&](auto packet) {
      packet.T_EMA.raw = 1023;
      packet.L_ENDSECTION.raw = whole(to - reference.position_m);
      packet.Q_DANGERPOINT.raw = danger ? 1 : 0;
      packet.D_DP.raw = whole(danger_m - to);
      packet.V_RELEASEDP.raw = release ? codes_of_5_kmh(speed(*release, 0.0, 100.0)) : std::uint8_t{127};
      return packet;
    };
    if (by_radio) {
      add(out, fill(nominal<lang::Packet15>()));
    } else {
      auto packet = fill(nominal<lang::Packet12>());
      packet.V_MAIN.raw = 32;
      add(out, packet);
    }
    linking(out, reference, to);
    gradient_profile(out, reference, danger_m + kBeyond);
    speed_profile(out, reference, danger_m + kBeyond);
  }

  /// The groups on the way to `to` and the one after.
  void linking(BitWriter& out, const Group& reference, double to) {
    auto packet = nominal<lang::Packet5>();
    Increments metres(reference.position_m, root_);
    std::size_t n = 0;
    double last_m = reference.position_m;
    for (const Group& g : groups_) {
      if (g.position_m <= reference.position_m) continue;
      if (n == kLinks || last_m > to) break;
      last_m = g.position_m;
      lang::Packet5_links link;
      link.D_LINK.raw = metres.to(g.position_m);
      link.NID_BG.raw = g.NID_BG;
      link.Q_LINKORIENTATION.raw = 1;
      link.Q_LINKREACTION.raw = 1;  // service brake
      link.Q_LOCACC.raw = kLocationAccuracy;
      if (n == 0) {
        packet.D_LINK = link.D_LINK;
        packet.NID_BG = link.NID_BG;
        packet.Q_LINKORIENTATION = link.Q_LINKORIENTATION;
        packet.Q_LINKREACTION = link.Q_LINKREACTION;
        packet.Q_LOCACC = link.Q_LOCACC;
      } else {
        (void)packet.links.push_back(link);
      }
      ++n;
    }
    if (n > 0) add(out, packet);
  }

  /// The first step is in the packet, up to 31 follow (N_ITER has 5 bits).
  template <class List, class Found>
  void follow(List& list, const Found& step) const {
    if (!list.push_back(step)) root_.fail("more steps in one authority", "at most 32 steps of gradient, 32 of ssp");
  }

  /// The steps of the profile `key` from the reference to `to`, the first one beginning at the reference.
  std::vector<Stretch> part(const char* key, const std::vector<Stretch>& profile, double from, double to) const {
    std::vector<Stretch> steps;
    for (const Stretch& s : profile)
      if (s.to_m > from && s.from_m < to) steps.push_back({std::max(s.from_m, from), std::min(s.to_m, to), s.value});
    if (steps.empty() || steps.front().from_m > from || steps.back().to_m < to)
      root_[key].fail("an authority over places without " + std::string(key),
                      std::string(key) + " from " + place(from) + " to " + place(to) +
                          ": from the group to 100 m beyond the danger point");
    return steps;
  }

  void gradient_profile(BitWriter& out, const Group& reference, double to) {
    auto packet = nominal<lang::Packet21>();
    Increments metres(reference.position_m, root_);
    bool first = true;
    const auto append = [&](double from, bool uphill, std::uint8_t G_A) {
      lang::Packet21_steps step;
      step.D_GRADIENT.raw = metres.to(from);
      step.Q_GDIR.raw = uphill ? 1 : 0;
      step.G_A.raw = G_A;
      if (first) {
        packet.D_GRADIENT = step.D_GRADIENT;
        packet.Q_GDIR = step.Q_GDIR;
        packet.G_A = step.G_A;
      } else {
        follow(packet.steps, step);
      }
      first = false;
    };
    // G_A is in whole permille (7.5.1.37): further downhill is the safe side.
    for (const Stretch& s : part("gradient", gradient_, reference.position_m, to))
      append(s.from_m, s.value >= 0.0, static_cast<std::uint8_t>(std::abs(std::floor(s.value))));
    append(to, false, 255);
    add(out, packet);
  }

  void speed_profile(BitWriter& out, const Group& reference, double to) {
    auto packet = nominal<lang::Packet27>();
    Increments metres(reference.position_m, root_);
    bool first = true;
    const auto append = [&](double from, std::uint8_t V_STATIC) {
      lang::Packet27_steps step;
      step.D_STATIC.raw = metres.to(from);
      step.V_STATIC.raw = V_STATIC;
      if (first) {
        packet.D_STATIC = step.D_STATIC;
        packet.V_STATIC = step.V_STATIC;
      } else {
        follow(packet.steps, step);
      }
      first = false;
    };
    for (const Stretch& s : part("ssp", ssp_, reference.position_m, to)) append(s.from_m, codes_of_5_kmh(s.value));
    append(to, 127);
    add(out, packet);
  }

  void national_values(BitWriter& out, const JsonPlace& p) {
    const auto values = io::read_national_values(p);
    for (const char* key : {"V_NVSHUNT", "V_NVSTFF", "V_NVONSIGHT", "V_NVLIMSUPERV", "V_NVUNFIT", "V_NVREL",
                            "V_NVALLOWOVTRP", "V_NVSUPOVTRP"})
      if (const auto v = p.find(key)) (void)speed(*v, 0.0, 600.0);
    add(out, io::packet_3(values, NID_C_));
  }

  void session(BitWriter& out, const JsonPlace& p) {
    p.know_only({"establish", "NID_RBC", "NID_RADIO"});
    lang::Packet42 packet;
    packet.Q_DIR.raw = 1;
    packet.Q_RBC.raw = p["establish"].boolean() ? 1 : 0;
    packet.NID_C.raw = NID_C_;
    packet.NID_RBC.raw = static_cast<std::uint16_t>(p["NID_RBC"].integer(0, 16383));
    packet.NID_RADIO.raw = read_NID_RADIO(p["NID_RADIO"]);
    add(out, packet);
  }

  /// A place that a distance from the reference can hold.
  static double ahead(const JsonPlace& place, const Group& reference) {
    return place.number(reference.position_m, reference.position_m + kFarthest);
  }

  void level_transition(BitWriter& out, const JsonPlace& p, const Group& reference) {
    p.know_only({"at_m", "level", "nid_ntc", "acknowledge_m"});
    auto packet = nominal<lang::Packet41>();
    packet.D_LEVELTR.raw = whole(ahead(p["at_m"], reference) - reference.position_m);
    packet.M_LEVELTR.raw = M_LEVEL(p["level"].term<kLevelRows>());
    if (const auto nid = p.find("nid_ntc")) packet.NID_NTC.raw = static_cast<std::uint8_t>(nid->integer(0, 255));
    packet.L_ACKLEVELTR.raw = whole(p["acknowledge_m"].number(0.0, 5000.0));
    add(out, packet);
  }

  void restriction(BitWriter& out, const JsonPlace& p, const Group& reference) {
    p.know_only({"NID_TSR", "from_m", "to_m", "kmh"});
    auto packet = nominal<lang::Packet65>();
    packet.NID_TSR.raw = static_cast<std::uint8_t>(p["NID_TSR"].integer(0, 254));
    const double from = ahead(p["from_m"], reference);
    packet.D_TSR.raw = whole(from - reference.position_m);
    packet.L_TSR.raw = whole(p["to_m"].number(from, from + 30000.0) - from);
    packet.V_TSR.raw = codes_of_5_kmh(speed(p["kmh"], 5.0, 500.0));
    add(out, packet);
  }

  void revocation(BitWriter& out, const JsonPlace& p) {
    lang::Packet66 packet;
    packet.Q_DIR.raw = 1;
    packet.NID_TSR.raw = static_cast<std::uint8_t>(p.integer(0, 254));
    add(out, packet);
  }

  void mode_profile(BitWriter& out, const JsonPlace& p, const Group& reference) {
    p.know_only({"mode", "from_m", "to_m", "kmh", "acknowledge_m"});
    auto packet = nominal<lang::Packet80>();
    const double from = ahead(p["from_m"], reference);
    packet.D_MAMODE.raw = whole(from - reference.position_m);
    packet.M_MAMODE.raw = static_cast<std::uint8_t>(p["mode"].one_of({"OS", "SH", "LS"}));
    const auto kmh = p.find("kmh");
    packet.V_MAMODE.raw = kmh ? codes_of_5_kmh(speed(*kmh, 5.0, 500.0)) : std::uint8_t{127};
    packet.L_MAMODE.raw = whole(p["to_m"].number(from, from + 30000.0) - from);
    packet.L_ACKMAMODE.raw = whole(p["acknowledge_m"].number(0.0, 5000.0));
    add(out, packet);
  }

  void text(BitWriter& out, const JsonPlace& p) {
    p.know_only({"text", "for_s"});
    auto packet = nominal<lang::Packet72>();
    packet.M_MODETEXTDISPLAY_START.raw = packet.M_MODETEXTDISPLAY_END.raw = 15;   // not limited by mode
    packet.M_LEVELTEXTDISPLAY_START.raw = packet.M_LEVELTEXTDISPLAY_END.raw = 5;  // nor by level
    packet.L_TEXTDISPLAY.raw = 32767;
    packet.T_TEXTDISPLAY.raw = static_cast<std::uint16_t>(p["for_s"].integer(1, 1022));
    for (const char c : p["text"].string()) {
      const auto u = static_cast<unsigned char>(c);
      if (u < 0x20 || u > 0x7e) p["text"].fail("printable ASCII");
      lang::Packet72_text character;
      character.X_TEXT.raw = u;
      if (!packet.text.push_back(character))
        p["text"].fail(std::to_string(p["text"].string().size()) + " characters", "at most 255 characters");
    }
    add(out, packet);
  }

  void ma_requests(BitWriter& out, const JsonPlace& p) {
    p.know_only({"before_perturbation_s", "before_timeout_s", "every_s"});
    lang::Packet57 packet;
    packet.Q_DIR.raw = 1;
    packet.T_MAR.raw = static_cast<std::uint8_t>(p["before_perturbation_s"].integer(0, 254));
    packet.T_TIMEOUTRQST.raw = static_cast<std::uint16_t>(p["before_timeout_s"].integer(0, 1022));
    packet.T_CYCRQST.raw = static_cast<std::uint8_t>(p["every_s"].integer(1, 254));
    add(out, packet);
  }

  void position_reports(BitWriter& out, const JsonPlace& p) {
    p.know_only({"every_s", "at_groups"});
    auto packet = nominal<lang::Packet58>();
    packet.T_CYCLOC.raw = static_cast<std::uint8_t>(p["every_s"].integer(1, 254));
    packet.D_CYCLOC.raw = 32767;
    packet.M_LOC.raw = p["at_groups"].boolean() ? 1 : 2;
    add(out, packet);
  }

  /// Any packet, in the JSON of `evc encode packet`: for packets without an order.
  void packet(BitWriter& out, const JsonPlace& p) {
    const auto bits = io::encode_packet_json(p.value(), {lang::Direction::to_train, kVersion});
    if (!bits) p.fail(io::error_json(bits.error()), "a packet to the train of system version 2.1");
    BitReader in(bits->bytes, bits->bits);
    while (in.left() > 0) {
      const auto width = static_cast<unsigned>(std::min<std::size_t>(in.left(), 32));
      out.write(in.read(width), width);
    }
    contains_->push_back(title(p));
  }

  JsonPlace root_;
  std::vector<Group> groups_;
  std::vector<Stretch> gradient_, ssp_;
  std::uint16_t NID_C_;
  ordered_json* contains_ = nullptr;
};

std::string hex(std::span<const std::uint8_t> bytes) {
  std::string digits;
  io::append_hex(digits, bytes);
  return digits;
}

/// The orders of a group, put one after another into the telegrams of its balises.
class Orders {
 public:
  Orders(Encoder& encoder, const Group& group, std::optional<JsonPlace> orders)
      : encoder_(encoder), group_(group), orders_(std::move(orders)) {}

  /// Writes the orders that still fit; the others are left for the next balise of the group.
  void put(BitWriter& out, ordered_json& contains) {
    constexpr std::size_t room = 830 - 8;  // packet 255 follows
    // Infill continues in the next telegram.
    if (infill_ && left()) (void)encoder_.infill(out, *infill_, group_, contains);
    for (; left(); ++next_) {
      const BitWriter before = out;
      const ordered_json contained = contains;
      const std::optional<JsonPlace> infill = infill_;
      put((*orders_)[next_], out, contains);
      if (!out.faulty() && out.position() <= room) continue;
      out = before;
      contains = contained;
      infill_ = infill;
      break;
    }
  }
  bool left() const { return orders_ && next_ < orders_->size(); }
  /// The first order that is not written.
  JsonPlace first_left() const { return (*orders_)[next_]; }

 private:
  void put(const JsonPlace& order, BitWriter& out, ordered_json& contains) {
    require_one_order(order);
    if (const auto main = order.find("infill")) {
      (void)encoder_.infill(out, *main, group_, contains);
      infill_ = main;
    } else {
      encoder_.encode(out, order, infill_ ? encoder_.group(*infill_) : group_, false, contains);
    }
  }

  Encoder& encoder_;
  Group group_;
  std::optional<JsonPlace> orders_, infill_;
  std::size_t next_ = 0;
};

ordered_json telegram(const Encoder& encoder, const Group& group, unsigned N_PIG, unsigned last, Orders& orders) {
  std::array<std::uint8_t, 104> bytes{};
  BitWriter out(bytes);
  lang::TelegramHeader header;
  header.N_PIG.raw = static_cast<std::uint8_t>(N_PIG);
  header.N_TOTAL.raw = static_cast<std::uint8_t>(last);
  header.M_MCOUNT.raw = 1;
  header.NID_C.raw = encoder.NID_C();
  header.NID_BG.raw = group.NID_BG;
  header.Q_LINK.raw = 1;
  lang::begin_telegram(out, header);
  ordered_json contains = ordered_json::array();
  orders.put(out, contains);
  lang::end_telegram(out, 830);
  return {{"position_m", group.position_m + kBaliseSpacing * N_PIG},
          {"contains", contains},
          {"telegram_bits", 830},
          {"telegram_hex", hex(bytes)}};
}

ordered_json balises(Encoder& encoder, const Group& group, const JsonPlace& place) {
  const auto count = place.find("balises");
  const auto total = static_cast<unsigned>(count ? count->integer(1, 8, "3.4.1.1"_srs) : 2);
  Orders orders(encoder, group, place.find("orders"));
  ordered_json all = ordered_json::array();
  for (unsigned N_PIG = 0; N_PIG < total; ++N_PIG) all.push_back(telegram(encoder, group, N_PIG, total - 1, orders));
  if (orders.left())
    orders.first_left().fail("more than " + std::to_string(total) + " telegrams of 830 bits",
                             "fewer orders, or more balises");
  return all;
}

/// A radio message as in the line file.
struct EncodedMessage {
  unsigned NID_MESSAGE = 0;
  ordered_json contains = ordered_json::array();
  std::vector<std::uint8_t> bytes;
};

std::uint32_t NID_LRBG_of(const Encoder& encoder, const Group& reference) {
  return std::uint32_t{encoder.NID_C()} << 14 | reference.NID_BG;
}

/// Any message, in the JSON of `evc encode radio`: for contents without an order. The variables that every message has
/// may be absent: NID_LRBG is the reference group, T_TRAIN is written when the message is sent.
EncodedMessage whole_message(const Encoder& encoder, const JsonPlace& place, const Group& reference) {
  io::Json message = place.value();
  if (!message.is_object()) place.fail("an object");
  message.emplace("T_TRAIN", 0);
  message.emplace("M_ACK", 0);
  message.emplace("NID_LRBG", NID_LRBG_of(encoder, reference));
  const auto bits = io::encode_radio_json(message, {lang::Direction::to_train, kVersion});
  if (!bits) place.fail(io::error_json(bits.error()), "a message to the train of system version 2.1");
  EncodedMessage encoded;
  encoded.NID_MESSAGE = static_cast<unsigned>(place["NID_MESSAGE"].integer(0, 255));
  encoded.bytes = bits->bytes;
  if (const auto packets = place.find("packets"))
    for (std::size_t i = 0; i < packets->size(); ++i) encoded.contains.push_back(title((*packets)[i]));
  return encoded;
}

/// Message 3 where there is an authority, else message 24, with the packets of the orders.
EncodedMessage message_of_orders(Encoder& encoder, const JsonPlace& orders, const Group& reference) {
  EncodedMessage encoded;
  bool authority = false;
  for (std::size_t i = 0; i < orders.size(); ++i) {
    require_one_order(orders[i]);
    authority = authority || orders[i].find("authority").has_value();
  }
  std::array<std::uint8_t, 512> bytes{};
  BitWriter out(bytes);
  const auto begin = [&](auto message) {
    message.NID_LRBG.raw = NID_LRBG_of(encoder, reference);
    message.M_ACK.raw = authority ? 1 : 0;
    lang::begin_message(out, message);
  };
  if (authority)
    begin(lang::Message3{});
  else
    begin(lang::Message24{});
  // The mandatory packet of message 3 is the first one (8.7.2).
  for (const bool first : {true, false})
    for (std::size_t i = 0; i < orders.size(); ++i)
      if (orders[i].find("authority").has_value() == first)
        encoder.encode(out, orders[i], reference, true, encoded.contains);
  lang::end_message(out);
  if (out.faulty()) orders.fail("more than 512 bytes", "orders that fit in one message");
  encoded.NID_MESSAGE = authority ? 3 : 24;
  encoded.bytes.assign(out.bytes().begin(), out.bytes().end());
  return encoded;
}

/// A comment for the reader of the description.
void check_comment(const JsonPlace& of, const char* key) {
  if (const auto comment = of.find(key)) (void)comment->string();
}

ordered_json radio_message(Encoder& encoder, const JsonPlace& place, int seq) {
  place.know_only({"at_m", "delay_s", "lrbg", "orders", "message", "note"});
  check_comment(place, "note");
  const Group& reference = encoder.group(place["lrbg"]);
  const double at = place["at_m"].number(reference.position_m, 1e6);
  const auto message = place.find("message");
  if (message && place.find("orders")) place.fail("orders and a message", "one of them");
  const EncodedMessage encoded =
      message ? whole_message(encoder, *message, reference) : message_of_orders(encoder, place["orders"], reference);
  ordered_json trigger = {{"position_m", at}};
  if (const auto delay = place.find("delay_s")) trigger["delay_s"] = delay->number(0.0, 3600.0);
  return {{"seq", seq},
          {"trigger", trigger},
          {"nid_message", encoded.NID_MESSAGE},
          {"contains", encoded.contains},
          {"message_bits", 8 * encoded.bytes.size()},
          {"message_hex", hex(encoded.bytes)}};
}

template <class ReadValue>
std::vector<Stretch> read_profile(const JsonPlace& list, ReadValue read_value) {
  std::vector<Stretch> steps;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const JsonPlace row = list[i];
    if (row.size() != 3) row.fail("[from_m, to_m, value]");
    const double from = row[0].number(-1e5, 1e6), to = row[1].number(-1e5, 1e6);
    if (!steps.empty() && from != steps.back().to_m)
      row[0].fail(place(from), place(steps.back().to_m) + ", where the step before ends");
    if (to <= from) row[1].fail(place(to), "a place beyond " + place(from));
    steps.push_back({from, to, read_value(row[2])});
  }
  return steps;
}

ordered_json physical_track(const std::vector<Stretch>& gradient, const std::vector<Stretch>& ssp) {
  ordered_json track = {{"gradient", ordered_json::array()}, {"ssp", ordered_json::array()}};
  for (const Stretch& s : gradient)
    track["gradient"].push_back({{"start_m", s.from_m}, {"end_m", s.to_m}, {"gradient_permille", s.value}});
  for (const Stretch& s : ssp) track["ssp"].push_back({{"start_m", s.from_m}, {"end_m", s.to_m}, {"v_kmh", s.value}});
  return track;
}

ordered_json line_of(const JsonPlace& root) {
  root.require_schema("evc-line-description/1");
  root.know_only(
      {"schema", "name", "about", "NID_C", "length_m", "start", "rbc", "gradient", "ssp", "groups", "radio"});
  check_comment(root, "about");
  const auto gradient = read_profile(root["gradient"], [](const JsonPlace& p) { return p.number(-50.0, 50.0); });
  const auto ssp = read_profile(root["ssp"], [](const JsonPlace& p) { return speed(p, 5.0, 500.0); });
  const JsonPlace list = root["groups"];
  if (list.size() == 0) list.fail("at least one group");
  std::vector<Group> groups;
  for (std::size_t i = 0; i < list.size(); ++i) {
    list[i].know_only({"NID_BG", "at_m", "balises", "orders", "note"});
    check_comment(list[i], "note");
    const double at = list[i]["at_m"].number(-1e5, 1e6);
    if (!groups.empty() && at <= groups.back().position_m) list[i]["at_m"].fail("a place beyond the group before");
    const auto NID_BG = static_cast<std::uint16_t>(list[i]["NID_BG"].integer(0, 16382));
    if (std::any_of(groups.begin(), groups.end(), [&](const Group& g) { return g.NID_BG == NID_BG; }))
      list[i]["NID_BG"].fail("a NID_BG of no other group");
    groups.push_back({NID_BG, at});
  }
  Encoder encoder(root, groups, gradient, ssp, static_cast<std::uint16_t>(root["NID_C"].integer(0, 1023)));
  ordered_json line = {{"schema", "etcs-line/1"},
                       {"name", root["name"].string()},
                       {"length_m", root["length_m"].number(0.0, 1e6)},
                       {"system_version", "2.1"},
                       {"source", "made by evc make-line from " + root.file().substr(root.file().rfind('/') + 1)}};
  root["start"].know_only({"front_m", "level", "mode", "nid_ntc"});
  (void)read_line_start(root["start"]);
  line["start"] = ordered_json::parse(root["start"].value().dump());
  if (const auto rbc = root.find("rbc")) {
    rbc->know_only({"NID_C", "NID_RBC", "NID_RADIO", "shunting"});
    (void)read_rbc(*rbc);
    line["rbc"] = ordered_json::parse(rbc->value().dump());
  }
  line["balise_groups"] = ordered_json::array();
  for (std::size_t i = 0; i < groups.size(); ++i) {
    line["balise_groups"].push_back({{"seq", i},
                                     {"nid_c", encoder.NID_C()},
                                     {"nid_bg", groups[i].NID_BG},
                                     {"position_m", groups[i].position_m},
                                     {"balises", balises(encoder, groups[i], list[i])}});
  }
  line["rbc_messages"] = ordered_json::array();
  const JsonPlace radio = root["radio"];
  for (std::size_t i = 0; i < radio.size(); ++i)
    line["rbc_messages"].push_back(radio_message(encoder, radio[i], static_cast<int>(i)));
  line["physical_track"] = physical_track(gradient, ssp);
  return line;
}

}  // namespace

io::Result<std::string> make_line(std::string_view description, const std::string& file) {
  return io::guarded([&] {
    const io::Json document = io::parse_json(description, file);
    return line_of(JsonPlace(document, file)).dump(1) + "\n";
  });
}

}  // namespace evc::io
