#include "lang/telegram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "lang/decode.h"
#include "lang/encode.h"
#include "lang/messages.h"
#include "lang/packets/packet_0.h"
#include "lang/packets/packet_136.h"
#include "lang/packets/packet_137.h"
#include "lang/packets/packet_15.h"
#include "lang/packets/packet_21.h"
#include "lang/packets/packet_245.h"
#include "lang/packets/packet_27.h"
#include "lang/packets/packet_41.h"
#include "lang/packets/packet_42.h"
#include "lang/packets/packet_44.h"
#include "lang/packets/packet_45.h"
#include "lang/packets/packet_5.h"
#include "lang/packets/packet_57.h"
#include "lang/packets/packet_65.h"
#include "lang/packets/packet_66.h"
#include "lang/packets/packet_68.h"
#include "lang/packets/train_packet_0.h"
#include "lang/packets/train_packet_5.h"
#include "lang/si.h"

namespace evc::lang {
namespace {

std::vector<std::uint8_t> from_hex(const std::string& hex) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < hex.size(); i += 2)
    bytes.push_back(static_cast<std::uint8_t>(std::stoi((hex + "0").substr(i, 2), nullptr, 16)));
  return bytes;
}

TEST(Telegram, OfARealLine) {
  const auto bytes = from_hex("9002FFB540B00B501790210FFF8");
  const TelegramView t = scan_telegram(bytes, 105);
  ASSERT_EQ(t.fault, Fault::none) << text_of(t.fault) << t.at.bit;
  EXPECT_EQ(t.sv, (SystemVersion{1, 0}));
  EXPECT_EQ(t.NID_BG.raw, 352);
  ASSERT_EQ(t.packets.size(), 1u);
  EXPECT_EQ(t.packets[0].NID_PACKET, 45);
  Packet45 p;
  ASSERT_EQ(decode(t.packets[0], p), Fault::none);
  EXPECT_EQ(p.NID_MN.raw, 2114079u);
  Packet5 linking;
  EXPECT_EQ(decode(t.packets[0], linking), Fault::not_a_packet_of_this_kind);
}

/// A telegram of version 2.1 (or `M_VERSION`) with the bits that `fill` writes.
template <class Fill>
struct WithBits {
  std::array<std::uint8_t, 128> room{};
  BitWriter out{room};
  explicit WithBits(Fill fill, std::uint8_t M_VERSION = 33, std::size_t bits = 830) {
    TelegramHeader header;
    header.M_VERSION.raw = M_VERSION;
    header.NID_BG.raw = 9;
    begin_telegram(out, header);
    fill(out);
    end_telegram(out, bits);
  }
  TelegramView scan(Check check = Check::all, SystemVersion newest = kNewest_of_baseline_3) const {
    return scan_telegram(out.bytes(), out.position(), check, newest);
  }
};

void raw_packet(BitWriter& out, unsigned nid, unsigned Q_DIR, unsigned L_PACKET) {
  out.write(nid, 8);
  out.write(Q_DIR, 2);
  out.write(L_PACKET, 13);
}

TEST(Telegram, UnknownPacketWithLengthZero) {
  const WithBits made([](BitWriter& out) { raw_packet(out, 99, 1, 0); });
  for (const Check check : {Check::all, Check::structure}) {
    const TelegramView t = made.scan(check);
    EXPECT_EQ(t.fault, Fault::length_too_small);
    EXPECT_EQ(t.at.bit, 60u);
    EXPECT_EQ(t.at.packet, 99);
  }
}

TEST(Telegram, ADigitOfANumberThatIsNotUsedIsRefusedByATrain) {  // 7.5.1.95
  for (const auto& [number, fault] :
       {std::pair{0x0612'3456'78FF'FFFFu, Fault::none}, std::pair{0x0612'3456'7AFF'FFFFu, Fault::spare_value},
        std::pair{kNo_number, Fault::spare_value}}) {
    Packet42 p;
    p.Q_DIR.raw = 2;
    p.Q_RBC.raw = 1;
    p.NID_RADIO.raw = number;
    const WithBits made([&](BitWriter& out) { encode(out, p); });
    const TelegramView t = made.scan();
    EXPECT_EQ(t.fault, fault) << number;
    EXPECT_EQ(t.at.value, fault == Fault::none ? 0 : number);
    EXPECT_EQ(made.scan(Check::reading).fault, Fault::none) << number;
    EXPECT_EQ(made.scan(Check::structure).fault, Fault::none) << number;
  }
}

TEST(Telegram, CounterAtItsLimit) {
  // 31 further links announced, none present: the packet ends by its own length.
  const WithBits made([](BitWriter& out) {
    raw_packet(out, 5, 1, 69);
    out.write(1, 2);
    out.write(0, 15 + 1 + 14 + 1 + 2 + 6);
    out.write(31, 5);
  });
  const TelegramView t = made.scan();
  EXPECT_EQ(t.fault, Fault::length_mismatch);
  EXPECT_STREQ(t.at.variable, "D_LINK");
  // The maximum number.
  Packet5 full;
  full.Q_DIR.raw = 1;
  while (!full.links.full()) (void)full.links.push_back({});
  std::array<std::uint8_t, 200> room{};
  BitWriter out(room);
  encode(out, full);
  PacketView view;
  view.L_PACKET = static_cast<std::uint16_t>(out.position());
  view.sv = {2, 1};
  view.bytes = out.bytes();
  Packet5 read;
  ASSERT_EQ(decode(view, read), Fault::none);
  EXPECT_EQ(read, full);
}

TEST(Telegram, PacketThatEndsBeyondTheTelegram) {
  const WithBits made([](BitWriter& out) { raw_packet(out, 99, 1, 8191); });
  const TelegramView t = made.scan(Check::structure);
  EXPECT_EQ(t.fault, Fault::length_beyond_end);
  EXPECT_EQ(t.at.value, 8191u);
  // A packet with an incomplete header.
  const WithBits cut([](BitWriter&) {}, 33, 0);
  std::array<std::uint8_t, 8> bytes{};
  std::copy_n(cut.room.begin(), 8, bytes.begin());
  bytes[6] = static_cast<std::uint8_t>(bytes[6] & 0xC0);
  bytes[7] = 0x15;  // packet 0 without its marker
  EXPECT_STREQ(scan_telegram(bytes, 60).at.variable, "NID_VBCMK");
  bytes[7] = 0x95;  // packet 2 without its length
  EXPECT_STREQ(scan_telegram(bytes, 60).at.variable, "Q_DIR");
  EXPECT_EQ(scan_telegram(bytes, 60).fault, Fault::truncated);
}

TEST(Telegram, PacketThatIsLongerThanItsContent) {
  const WithBits made([](BitWriter& out) {
    raw_packet(out, 45, 1, 23 + 24 + 8);
    out.write(7, 24);
    out.write(0, 8);
  });
  const TelegramView t = made.scan();
  EXPECT_EQ(t.fault, Fault::length_mismatch);
  EXPECT_EQ(t.at.bit, 50u + 23 + 24);
  EXPECT_EQ(t.at.value, 23u + 24 + 8);
}

TEST(Telegram, UnknownPacketIsSkipped) {
  const WithBits made([](BitWriter& out) {
    raw_packet(out, 99, 1, 30);
    out.write(0x55, 7);
    encode(out, Packet45{{1}, {7}});
  });
  const TelegramView t = made.scan(Check::reading);
  ASSERT_EQ(t.fault, Fault::none);
  ASSERT_EQ(t.packets.size(), 2u);
  EXPECT_FALSE(t.packets[0].known);
  EXPECT_TRUE(t.packets[1].known);
  // A train supports every number of 2.1 (3.16.1.1.1), but not those of 2.2 (3.17.3.11).
  EXPECT_EQ(made.scan().fault, Fault::spare_value);
  EXPECT_EQ(made.scan().at.packet, 99);
  EXPECT_STREQ(made.scan().at.variable, "NID_PACKET");
  const WithBits later([](BitWriter& out) { raw_packet(out, 99, 1, 23); }, 34);
  EXPECT_EQ(later.scan().fault, Fault::none);
}

TEST(Telegram, SpareCode) {
  const auto fill = [](BitWriter& out) {
    Packet65 tsr;
    tsr.Q_DIR.raw = 1;
    tsr.V_TSR.raw = 121;
    encode(out, tsr);
  };
  const TelegramView t = WithBits(fill).scan();
  EXPECT_EQ(t.fault, Fault::spare_value);
  EXPECT_EQ(t.at.packet, 65);
  EXPECT_STREQ(t.at.variable, "V_TSR");
  EXPECT_EQ(t.at.value, 121u);
  EXPECT_EQ(t.at.bit, 50u + 23 + 2 + 8 + 15 + 15 + 1);
  EXPECT_EQ(WithBits(fill).scan(Check::structure).fault, Fault::none);
  // A train cannot use it with a later Y either; a reader continues and returns the code.
  EXPECT_EQ(WithBits(fill, 34).scan().fault, Fault::spare_value);
  EXPECT_EQ(WithBits(fill).scan(Check::reading).fault, Fault::spare_value);
  const WithBits later(fill, 34);
  const TelegramView reading = later.scan(Check::reading);
  ASSERT_EQ(reading.fault, Fault::none);
  Packet65 read;
  EXPECT_EQ(decode(reading.packets[0], read), Fault::none);
  EXPECT_EQ(read.V_TSR.raw, 121);
  // But not with an unknown scale or direction.
  const auto scale = [](BitWriter& out) {
    Packet65 tsr;
    tsr.Q_DIR.raw = 1;
    tsr.Q_SCALE.raw = 3;
    encode(out, tsr);
  };
  for (const Check check : {Check::all, Check::reading})
    EXPECT_STREQ(WithBits(scale, 34).scan(check).at.variable, "Q_SCALE");
  const auto direction = [](BitWriter& out) { encode(out, Packet65{{3}, {1}, {1}, {}, {}, {}, {}}); };
  for (const Check check : {Check::all, Check::reading})
    EXPECT_STREQ(WithBits(direction, 34).scan(check).at.variable, "Q_DIR");
}

// The same for variables of other kinds: enumerations, conditions, speeds.
TEST(Telegram, SpareCodesOfALaterVersionByVariable) {
  struct Case {
    const char* variable;
    void (*fill)(BitWriter&);
  };
  const Case cases[]{
      {"V_TSR",
       [](BitWriter& out) {
         encode(out, Packet65{{1}, {1}, {1}, {}, {}, {}, {125}});
       }},
      {"M_TRACKCOND",
       [](BitWriter& out) {
         Packet68 p;
         p.M_TRACKCOND.raw = 12;
         encode(out, p);
       }},
      {"Q_DIFF",
       [](BitWriter& out) {
         Packet27 p;
         (void)p.diffs.push_back({{3}, {}, {}, {}});
         encode(out, p);
       }},
      {"M_LEVELTR",
       [](BitWriter& out) {
         encode(out, Packet41{{1}, {1}, {0}, {7}, {}, {}, {}});
       }},
  };
  for (const Case& c : cases) {
    const WithBits now(c.fill), later(c.fill, 35);
    for (const Check check : {Check::all, Check::reading}) EXPECT_STREQ(now.scan(check).at.variable, c.variable);
    EXPECT_STREQ(later.scan().at.variable, c.variable);
    EXPECT_EQ(later.scan(Check::reading).fault, Fault::none) << c.variable;
  }
}

TEST(Telegram, Versions) {
  const auto nothing = [](BitWriter&) {};
  EXPECT_EQ(WithBits(nothing, 16).scan().fault, Fault::none);
  EXPECT_EQ(WithBits(nothing, 17).scan().fault, Fault::none);
  EXPECT_EQ(WithBits(nothing, 32).scan().fault, Fault::none);
  EXPECT_EQ(WithBits(nothing, 47).scan().fault, Fault::none);
  EXPECT_EQ(WithBits(nothing, 15).scan().fault, Fault::unknown_version);
  EXPECT_EQ(WithBits(nothing, 48).scan().fault, Fault::unknown_version);
  EXPECT_EQ(WithBits(nothing, 18).scan().fault, Fault::spare_value);
  EXPECT_EQ(WithBits(nothing, 48).scan().NID_BG.raw, 9);
  for (const SystemVersion unknown : {SystemVersion{0, 0}, SystemVersion{4, 0}}) EXPECT_EQ(known_version(unknown), 0);
}

// 7.5.1.79 of SRS 4.0.0, 6.4.2.2: all versions from 1.0 to 3.0.
TEST(Telegram, VersionsOf4_0_0) {
  const auto nothing = [](BitWriter&) {};
  const auto fault = [&](std::uint8_t M_VERSION) {
    return WithBits(nothing, M_VERSION).scan(Check::all, kNewest).fault;
  };
  for (const std::uint8_t M_VERSION : std::initializer_list<std::uint8_t>{16, 17, 32, 33, 34, 35, 48, 49, 63})
    EXPECT_EQ(fault(M_VERSION), Fault::none) << unsigned{M_VERSION};
  for (std::uint8_t M_VERSION = 36; M_VERSION < 48; ++M_VERSION) {
    EXPECT_EQ(fault(M_VERSION), Fault::spare_value) << unsigned{M_VERSION};
    EXPECT_EQ(WithBits(nothing, M_VERSION).scan().sv, (SystemVersion{2, kLater_Y}));
  }
  for (const std::uint8_t M_VERSION : std::initializer_list<std::uint8_t>{15, 64, 127})
    EXPECT_EQ(fault(M_VERSION), Fault::unknown_version);
  EXPECT_EQ(WithBits(nothing, 35).scan(Check::all, kNewest).sv, (SystemVersion{2, 3}));
  EXPECT_EQ(WithBits(nothing, 34).scan().sv, (SystemVersion{2, kLater_Y}));
  EXPECT_EQ(known_version({2, kLater_Y}), v2_1);
  EXPECT_EQ(known_version({3, kLater_Y}), v3_0);
}

// A packet of 2.3 only: unknown before and in 3.0 (6.5.2.3.16, 7.4.1.1), skipped by a unit of Baseline 3 (3.17.3.11).
TEST(Telegram, PacketOfOneVersion) {
  const auto network_type = [](BitWriter& out) { encode(out, Packet245{{1}, {2}}); };
  const auto of = [&](std::uint8_t M_VERSION, SystemVersion newest) {
    return WithBits(network_type, M_VERSION).scan(Check::all, newest);
  };
  EXPECT_TRUE(of(35, kNewest).packets[0].known);
  for (const std::uint8_t other : std::initializer_list<std::uint8_t>{33, 34, 48})
    EXPECT_EQ(of(other, kNewest).fault, Fault::spare_value);
  ASSERT_EQ(of(35, kNewest_of_baseline_3).fault, Fault::none);
  EXPECT_FALSE(of(35, kNewest_of_baseline_3).packets[0].known);
}

TEST(Telegram, Header) {
  WithBits made([](BitWriter&) {});
  made.room[0] = static_cast<std::uint8_t>(made.room[0] & 0x7F);
  EXPECT_EQ(made.scan().fault, Fault::wrong_direction);
  made.room[0] = static_cast<std::uint8_t>(made.room[0] | 0x80);
  made.room[1] = static_cast<std::uint8_t>(made.room[1] | 0x80);
  EXPECT_EQ(made.scan().fault, Fault::wrong_medium);
  made.room[1] = 1;  // M_DUP 3
  made.room[2] = 0x80;
  EXPECT_EQ(made.scan().fault, Fault::spare_value);
  EXPECT_EQ(made.scan(Check::structure).fault, Fault::none);
  made.room[0] = 0x80 | 34;  // 2.2
  EXPECT_EQ(made.scan().fault, Fault::spare_value);
  EXPECT_EQ(made.scan(Check::reading).fault, Fault::none);
  EXPECT_EQ(scan_telegram(made.room, 49).fault, Fault::truncated);
  EXPECT_EQ(scan_telegram({}, 0).fault, Fault::truncated);
  EXPECT_STREQ(scan_telegram({}, 0).at.variable, "Q_UPDOWN");
}

TEST(Telegram, PacketsThatStandTwice) {
  const auto twice = [](unsigned first, unsigned second) {
    return WithBits([=](BitWriter& out) {
             encode(out, Packet45{{static_cast<std::uint8_t>(first)}, {7}});
             encode(out, Packet45{{static_cast<std::uint8_t>(second)}, {7}});
           })
        .scan()
        .fault;
  };
  EXPECT_EQ(twice(1, 1), Fault::duplicate_packet);
  EXPECT_EQ(twice(0, 1), Fault::none);
  EXPECT_EQ(twice(2, 1), Fault::duplicate_packet);
  EXPECT_EQ(twice(0, 2), Fault::duplicate_packet);
  // 8.4.1.4: temporary speed restrictions, and packets after packet 136.
  EXPECT_EQ(WithBits([](BitWriter& out) {
              encode(out, Packet65{{1}, {1}, {1}, {}, {}, {}, {}});
              encode(out, Packet65{{1}, {1}, {2}, {}, {}, {}, {}});
            })
                .scan()
                .fault,
            Fault::none);
  EXPECT_EQ(WithBits([](BitWriter& out) {
              encode(out, Packet5{});
              encode(out, Packet136{});
              encode(out, Packet5{});
            })
                .scan()
                .fault,
            Fault::none);
}

TEST(Telegram, MediumAndPlace) {
  // Packet 57 is sent by radio only.
  EXPECT_EQ(WithBits([](BitWriter& out) { encode(out, Packet57{}); }).scan().fault, Fault::wrong_medium);
  EXPECT_EQ(WithBits([](BitWriter& out) { encode(out, Packet57{}); }).scan(Check::structure).fault, Fault::none);
  const auto marker = [](BitWriter& out) {
    encode(out, Packet0{{5}});
    encode(out, Packet0{{6}});
    encode(out, Packet45{});
  };
  const WithBits made(marker);
  const TelegramView t = made.scan();
  ASSERT_EQ(t.fault, Fault::none);
  EXPECT_EQ(t.packets[0].L_PACKET, 14);
  Packet0 p;
  ASSERT_EQ(decode(t.packets[1], p), Fault::none);
  EXPECT_EQ(p.NID_VBCMK.raw, 6);
  EXPECT_EQ(WithBits([](BitWriter& out) {
              encode(out, Packet45{});
              encode(out, Packet0{{5}});
            })
                .scan()
                .fault,
            Fault::wrong_place);
}

TEST(Telegram, MorePacketsThanCanBeHeld) {
  std::array<std::uint8_t, 400> room{};
  BitWriter out(room);
  begin_telegram(out, {});
  for (std::size_t i = 0; i <= kPacketsMax; ++i) encode(out, Packet0{{1}});
  end_telegram(out, 0);
  EXPECT_EQ(scan_telegram(out.bytes(), out.position()).fault, Fault::too_many_packets);
}

TEST(LoopMessage, IsRead) {
  std::array<std::uint8_t, 32> room{};
  BitWriter out(room);
  out.write(1, 1);
  out.write(33, 7);
  out.write(1, 1);
  out.write(426, 10);
  out.write(77, 14);
  encode(out, Packet136{});
  end_telegram(out, 0);
  const LoopMessageView m = scan_loop_message(out.bytes(), out.position());
  ASSERT_EQ(m.fault, Fault::none);
  EXPECT_EQ(m.NID_LOOP.raw, 77);
  EXPECT_EQ(m.packets.size(), 1u);
  EXPECT_EQ(m.bits_used, out.position());
  room[1] = static_cast<std::uint8_t>(room[1] & 0x7F);
  EXPECT_EQ(scan_loop_message(out.bytes(), out.position()).fault, Fault::wrong_medium);
}

/// A message with the bits that `fill` writes after its own variables.
template <class M, class Fill>
std::vector<std::uint8_t> message(const M& m, Fill fill) {
  std::array<std::uint8_t, 200> room{};
  BitWriter out(room);
  begin_message(out, m);
  fill(out);
  end_message(out);
  EXPECT_FALSE(out.faulty());
  return {out.bytes().begin(), out.bytes().end()};
}
const auto no_packets = [](BitWriter&) {};

TEST(Message, ToTheTrain) {
  Message3 ma;
  ma.T_TRAIN.raw = 100;
  ma.M_ACK.raw = 1;
  ma.NID_LRBG.raw = 12345;
  const auto bytes = message(ma, [](BitWriter& out) {
    encode(out, Packet15{});
    encode(out, Packet21{});
  });
  const MessageToTrainView m = scan_message_to_train(bytes, {2, 1});
  ASSERT_EQ(m.fault, Fault::none) << m.at.bit;
  EXPECT_EQ(m.NID_MESSAGE, 3);
  EXPECT_EQ(m.L_MESSAGE, bytes.size());
  EXPECT_EQ(m.T_TRAIN.raw, 100u);
  EXPECT_EQ(m.NID_LRBG.raw, 12345u);
  ASSERT_EQ(m.packets.size(), 2u);
  Message3 read;
  ASSERT_EQ(decode(m, read), Fault::none);
  EXPECT_EQ(read, ma);
}

TEST(Message, Lists) {
  const auto fault = [](const std::vector<std::uint8_t>& bytes) { return scan_message_to_train(bytes, {2, 1}).fault; };
  EXPECT_EQ(fault(message(Message3{}, no_packets)), Fault::missing_packet);
  EXPECT_EQ(fault(message(Message3{}, [](BitWriter& out) { encode(out, Packet21{}); })), Fault::missing_packet);
  EXPECT_EQ(fault(message(Message3{},
                          [](BitWriter& out) {
                            encode(out, Packet15{});
                            encode(out, Packet137{});
                          })),
            Fault::unexpected_packet);
  EXPECT_EQ(fault(message(Message3{},
                          [](BitWriter& out) {
                            encode(out, Packet15{});
                            raw_packet(out, 99, 1, 23);
                          })),
            Fault::spare_value);
  EXPECT_EQ(fault(message(Message3{},
                          [](BitWriter& out) {
                            encode(out, Packet15{});
                            out.write(255, 8);
                          })),
            Fault::wrong_medium);
  EXPECT_EQ(fault(message(Message24{}, no_packets)), Fault::none);
}

TEST(Message, OfARadioInfillUnit) {  // 8.7.9, 8.7.15
  const auto fault = [](const std::vector<std::uint8_t>& bytes) {
    return scan_message_to_train(bytes, {2, 1}, Check::all, media::RIU).fault;
  };
  EXPECT_EQ(fault(message(Message3{}, [](BitWriter& out) { encode(out, Packet15{}); })), Fault::wrong_medium);
  EXPECT_EQ(fault(message(Message24{}, no_packets)), Fault::none);
  const auto area = [](BitWriter& out) { encode(out, Packet21{}); };
  EXPECT_EQ(scan_message_to_train(message(Message24{}, area), {2, 1}).fault, Fault::none);
  EXPECT_EQ(fault(message(Message24{}, area)), Fault::unexpected_packet);
}

// 3.17.3.11 c: where optional packets can be added.
constexpr SystemVersion kLater = as_known({2, 2}, kNewest_of_baseline_3);
TEST(Message, UnknownPacketsOfALaterVersion) {
  const auto unknown = [](BitWriter& out) { raw_packet(out, 99, 1, 23); };
  const auto general = message(Message24{}, unknown), stop = message(Message16{}, unknown);
  EXPECT_EQ(scan_message_to_train(general, kLater).fault, Fault::none);
  EXPECT_EQ(scan_message_to_train(general, {2, 1}).fault, Fault::spare_value);
  EXPECT_EQ(scan_message_to_train(general, {2, 1}, Check::reading).fault, Fault::none);
  EXPECT_EQ(scan_message_to_train(stop, kLater).fault, Fault::unexpected_packet);
  EXPECT_EQ(scan_message_to_train(stop, kLater, Check::reading).fault, Fault::none);
  // A code without a meaning among the message's own variables.
  Message2 m;
  m.Q_SCALE.raw = 3;
  for (const Check check : {Check::all, Check::reading})
    EXPECT_STREQ(scan_message_to_train(message(m, no_packets), kLater, check).at.variable, "Q_SCALE");
}

TEST(Message, LengthAndVersion) {
  std::vector<std::uint8_t> bytes = message(Message16{}, no_packets);
  EXPECT_EQ(scan_message_to_train(bytes, {2, 1}).fault, Fault::none);
  EXPECT_EQ(scan_message_to_train(bytes, as_known({3, 0}, kNewest_of_baseline_3)).fault, Fault::unknown_version);
  bytes.push_back(0);
  EXPECT_EQ(scan_message_to_train(bytes, {2, 1}).fault, Fault::message_length_mismatch);
  bytes[0] = 200;
  EXPECT_EQ(scan_message_to_train(bytes, {2, 1}).fault, Fault::unknown_message);
  EXPECT_EQ(scan_message_to_train({}, {2, 1}).fault, Fault::truncated);
  // Before a version is agreed only messages that are the same in every version are read
  // (8.4.4.1.1).
  const std::vector<std::uint8_t> version = message(Message32{}, no_packets);
  EXPECT_EQ(scan_message_to_train(version, {0, 0}).fault, Fault::none);
  // Shorter than its own variables.
  std::vector<std::uint8_t> cut = message(Message16{}, no_packets);
  cut.resize(6);
  cut[1] = 6 >> 2;
  cut[2] = static_cast<std::uint8_t>((cut[2] & 0x3F) | (6 & 3) << 6);
  EXPECT_EQ(scan_message_to_train(cut, {2, 1}).fault, Fault::truncated);
  // A spare code among them.
  Message15 stop;
  stop.Q_DIR.raw = 3;
  EXPECT_EQ(scan_message_to_train(message(stop, no_packets), {2, 1}).fault, Fault::spare_value);
}

TEST(Message, ToTheTrack) {
  std::array<std::uint8_t, 100> room{};
  BitWriter out(room);
  TrainMessage136 m;
  m.NID_ENGINE.raw = 77;
  TrainPacket0 report;
  report.Q_LENGTH.raw = 1;
  report.L_TRAININT.raw = 400;
  encode_message(out, m, report, TrainPacket5{{0x12FFFFFF}});
  ASSERT_FALSE(out.faulty());
  const MessageToTrackView view = scan_message_to_track(out.bytes(), {2, 1});
  ASSERT_EQ(view.fault, Fault::none) << text_of(view.fault) << view.at.bit;
  EXPECT_EQ(view.NID_ENGINE.raw, 77u);
  ASSERT_EQ(view.packets.size(), 2u);
  TrainPacket0 read;
  ASSERT_EQ(decode(view.packets[0], read), Fault::none);
  EXPECT_EQ(read, report);
  Packet0 other;
  EXPECT_EQ(decode(view.packets[0], other), Fault::not_a_packet_of_this_kind);
  TrainMessage136 again;
  ASSERT_EQ(decode(view, again), Fault::none);
  EXPECT_EQ(again, m);
  // A position report is mandatory.
  const auto bare = message(TrainMessage136{}, no_packets);
  EXPECT_EQ(scan_message_to_track(bare, {2, 1}).fault, Fault::missing_packet);
  // In version 1.0 packet 5 does not exist.
  EXPECT_EQ(scan_message_to_track(out.bytes(), {1, 0}).fault, Fault::spare_value);
  EXPECT_EQ(scan_message_to_track(out.bytes(), {1, 0}, Check::reading).fault, Fault::none);
}

TEST(CheckPacket, Alone) {
  std::array<std::uint8_t, 16> room{};
  BitWriter out(room);
  encode(out, Packet66{{1}, {9}});
  EXPECT_FALSE(check_packet(out.bytes(), out.position(), Direction::to_train, {2, 1}));
  EXPECT_EQ(check_packet(out.bytes(), 30, Direction::to_train, {2, 1}).fault, Fault::length_beyond_end);
  EXPECT_EQ(check_packet(out.bytes(), 7, Direction::to_train, {2, 1}).fault, Fault::truncated);
  const std::array<std::uint8_t, 1> end{255};
  EXPECT_FALSE(check_packet(end, 8, Direction::to_train, {2, 1}));
}

TEST(Fault, EveryOneHasAText) {
  for (int f = 0; f <= static_cast<int>(Fault::not_a_packet_of_this_kind); ++f)
    EXPECT_STRNE(text_of(static_cast<Fault>(f)), "");
  EXPECT_STREQ(text_of(static_cast<Fault>(255)), "");
}

TEST(Encode, NoRoom) {
  std::array<std::uint8_t, 4> room{};
  BitWriter out(room);
  encode(out, Packet5{});
  EXPECT_TRUE(out.faulty());
  BitWriter wide(room);
  wide.write(4, 2);
  EXPECT_TRUE(wide.faulty());
  // A message begins at bit 0.
  std::array<std::uint8_t, 64> more{};
  BitWriter late(more);
  late.write(0, 3);
  begin_message(late, Message16{});
  EXPECT_TRUE(late.faulty());
  // A telegram that is too long for its form.
  BitWriter telegram(more);
  begin_telegram(telegram, {});
  end_telegram(telegram, 50);
  EXPECT_TRUE(telegram.faulty());
  // Missing bits of an application.
  BitWriter application(more);
  Packet44 p;
  p.OTHER_DATA.bits = 9;
  encode(application, p);
  EXPECT_TRUE(application.faulty());
}

// --- messages of supervised manoeuvre (8.6, 8.7)

TEST(Message, SmAuthorisationNeedsItsThreePackets) {
  Message4 m;
  m.T_TRAIN_REF.raw = 77;
  m.Q_SCALE.raw = 1;
  m.D_REF.raw = 65436;
  m.V_SM.raw = 6;
  const auto whole = message(m, [](BitWriter& out) {
    encode(out, Packet15{});
    encode(out, Packet21{});
    encode(out, Packet27{});
  });
  for (const SystemVersion sv : {SystemVersion{2, 3}, SystemVersion{3, 0}}) {
    const MessageToTrainView view = scan_message_to_train(whole, sv);
    ASSERT_EQ(view.fault, Fault::none);
    EXPECT_EQ(view.packets.size(), 3u);
    Message4 read;
    ASSERT_EQ(decode(view, read), Fault::none);
    EXPECT_EQ(read, m);
  }
  EXPECT_EQ(scan_message_to_train(whole, {2, 2}).fault, Fault::unknown_message);
  const auto without_speed = message(m, [](BitWriter& out) {
    encode(out, Packet15{});
    encode(out, Packet21{});
  });
  EXPECT_EQ(scan_message_to_train(without_speed, {3, 0}).fault, Fault::missing_packet);
}

// 8.7.16
TEST(Message, AcknowledgementOfSessionHasNoGroup) {
  const auto bytes = message(Message38{{5}, {0}}, no_packets);
  EXPECT_EQ(bytes.size(), 7u);
  for (const SystemVersion sv : {SystemVersion{2, 3}, SystemVersion{3, 0}}) {
    const MessageToTrainView view = scan_message_to_train(bytes, sv, Check::all, media::RIU);
    EXPECT_EQ(view.fault, Fault::none);
    EXPECT_EQ(view.NID_LRBG.raw, 16777215u);
    EXPECT_EQ(view.T_TRAIN.raw, 5u);
  }
  EXPECT_EQ(scan_message_to_train(bytes, {2, 1}).fault, Fault::unknown_message);
  const std::optional<MessageHead> head = head_of_message_to_train(bytes);
  ASSERT_TRUE(head);
  EXPECT_EQ(head->T_TRAIN, 5u);
}

}  // namespace
}  // namespace evc::lang
