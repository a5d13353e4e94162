#include "lang/instances.h"

#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

#include "lang/decode.h"
#include "lang/encode.h"
#include "lang/packets/packet_0.h"
#include "lang/packets/packet_136.h"
#include "lang/packets/packet_145.h"
#include "lang/packets/packet_206.h"
#include "lang/packets/packet_207.h"
#include "lang/packets/packet_239.h"
#include "lang/packets/packet_254.h"
#include "lang/packets/packet_39.h"
#include "lang/packets/packet_44.h"
#include "lang/packets/packet_45.h"
#include "lang/packets/packet_5.h"
#include "lang/packets/packet_6.h"
#include "lang/packets/packet_65.h"
#include "lang/packets/packet_66.h"
#include "lang/packets/packet_68.h"
#include "lang/packets/packet_70.h"
#include "lang/packets/packet_88.h"

// 8.4.1.4, 8.4.1.5 and the exceptions of 6.6.3.2.3 that concern the whole message.
namespace evc::lang {
namespace {

/// A telegram of a version with these packets, and the result of reading it.
struct WithPackets {
  std::array<std::uint8_t, 128> room{};
  TelegramView view;
  template <class... P>
  explicit WithPackets(std::uint8_t M_VERSION, const P&... packets) {
    BitWriter out(room);
    TelegramHeader header;
    header.M_VERSION.raw = M_VERSION;
    begin_telegram(out, header);
    (encode(out, packets), ...);
    end_telegram(out, 830);
    view = scan_telegram(room, 830);
  }
  WithPackets(const WithPackets&) = delete;
};
template <class... P>
Fault fault_of(const P&... packets) {
  return WithPackets(33, packets...).view.fault;
}

Packet65 restriction(std::uint8_t Q_DIR, std::uint8_t NID_TSR) { return {{Q_DIR}, {1}, {NID_TSR}, {}, {}, {}, {10}}; }
Packet66 revocation(std::uint8_t Q_DIR, std::uint8_t NID_TSR) { return {{Q_DIR}, {NID_TSR}}; }
Packet88 crossing(std::uint8_t Q_DIR, std::uint8_t NID_LX) {
  Packet88 p;
  p.Q_DIR.raw = Q_DIR;
  p.NID_LX.raw = NID_LX;
  return p;
}
Packet6 cover(std::uint8_t Q_DIR, std::uint8_t Q_VBCO, std::uint8_t NID_VBCMK, std::uint16_t NID_C) {
  return {{Q_DIR}, {Q_VBCO}, {NID_VBCMK}, {NID_C}, {}};
}
Packet136 infill(std::uint8_t Q_DIR, std::uint16_t NID_BG) { return {{Q_DIR}, {0}, {0}, {NID_BG}}; }

TEST(Instances, OfAnOrdinaryPacketOneADirection) {
  const auto twice = [](unsigned first, unsigned second) {
    return fault_of(Packet45{{static_cast<std::uint8_t>(first)}, {7}},
                    Packet45{{static_cast<std::uint8_t>(second)}, {7}});
  };
  for (unsigned first = 0; first < 3; ++first)
    for (unsigned second = 0; second < 3; ++second) {
      const bool apart = first != second && first != 2 && second != 2;
      EXPECT_EQ(twice(first, second), apart ? Fault::none : Fault::duplicate_packet) << first << second;
    }
}

TEST(Instances, RestrictionsDifferInTheirIdentity) {
  EXPECT_EQ(fault_of(restriction(1, 1), restriction(1, 2), restriction(1, 254)), Fault::none);
  EXPECT_EQ(fault_of(restriction(1, 1), restriction(1, 2), restriction(1, 1)), Fault::duplicate_packet);
  EXPECT_EQ(fault_of(restriction(2, 1), restriction(0, 1)), Fault::duplicate_packet);
  EXPECT_EQ(fault_of(restriction(0, 1), restriction(1, 1)), Fault::none);
  // 255: cannot be revoked, has no identity.
  EXPECT_EQ(fault_of(restriction(1, 255), restriction(1, 255)), Fault::none);
  // A restriction and the revocation of the former one are different packets.
  EXPECT_EQ(fault_of(restriction(1, 7), revocation(1, 7)), Fault::none);
  // Also where one of them follows packet 136.
  EXPECT_EQ(fault_of(restriction(1, 1), infill(1, 9), restriction(1, 1)), Fault::duplicate_packet);
}

TEST(Instances, RevocationsDifferInTheirIdentity) {
  EXPECT_EQ(fault_of(revocation(1, 1), revocation(1, 2)), Fault::none);
  EXPECT_EQ(fault_of(revocation(1, 1), revocation(1, 1)), Fault::duplicate_packet);
  EXPECT_EQ(fault_of(revocation(1, 255), revocation(2, 255)), Fault::duplicate_packet);
}

TEST(Instances, CrossingsDifferInTheirIdentity) {
  EXPECT_EQ(fault_of(crossing(1, 1), crossing(1, 2)), Fault::none);
  EXPECT_EQ(fault_of(crossing(1, 1), crossing(1, 1)), Fault::duplicate_packet);
  EXPECT_EQ(fault_of(crossing(0, 1), crossing(1, 1)), Fault::none);
}

TEST(Instances, CoversDifferInMarkerOrCountry) {
  EXPECT_EQ(fault_of(cover(2, 1, 5, 426), cover(2, 1, 6, 426), cover(2, 1, 5, 427)), Fault::none);
  EXPECT_EQ(fault_of(cover(2, 1, 5, 426), cover(2, 1, 5, 426)), Fault::duplicate_packet);
  // Set and removed at once: the result must not depend on the order of packets (8.4.1.3).
  EXPECT_EQ(fault_of(cover(1, 1, 5, 426), cover(2, 0, 5, 426)), Fault::duplicate_packet);
  EXPECT_EQ(fault_of(cover(2, 1, 5, 426), cover(0, 0, 5, 426)), Fault::duplicate_packet);
  EXPECT_EQ(fault_of(cover(0, 1, 5, 426), cover(1, 0, 5, 426)), Fault::none);
}

TEST(Instances, ThoseThatMayComeAgain) {
  EXPECT_EQ(fault_of(Packet0{{5}}, Packet0{{6}}), Fault::none);
  EXPECT_EQ(fault_of(Packet145{{1}}, Packet145{{1}}), Fault::none);
  EXPECT_EQ(fault_of(Packet254{{1}}, Packet254{{1}}), Fault::none);
  EXPECT_EQ(fault_of(Packet44{}, Packet44{}), Fault::none);
}

/// 8.4.1.4.6 to .8 are for balise groups: a loop and a radio infill unit send packet 254 once for a direction.
TEST(Instances, DefaultInformationOfALoopOrByRadioComesOnce) {
  const WithPackets twice(33, Packet254{{1}}, Packet254{{0}}, Packet254{{1}}), data(33, Packet44{}, Packet44{});
  Instances instances(Composed::by_loop_or_radio);
  EXPECT_FALSE(instances.add(twice.view.packets[0]));
  EXPECT_FALSE(instances.add(twice.view.packets[1]));
  EXPECT_TRUE(instances.add(twice.view.packets[2]));
  for (const PacketView& packet : data.view.packets) EXPECT_FALSE(instances.add(packet));
}

TEST(Instances, InfillCountsByItself) {
  EXPECT_EQ(fault_of(Packet5{}, infill(0, 9), Packet5{}), Fault::none);
  EXPECT_EQ(fault_of(infill(0, 9), Packet5{}, Packet5{}), Fault::duplicate_packet);
  // Once for each direction.
  EXPECT_EQ(fault_of(infill(0, 9), infill(1, 8)), Fault::none);
  EXPECT_EQ(fault_of(infill(0, 9), infill(0, 8)), Fault::duplicate_packet);
  EXPECT_EQ(fault_of(infill(2, 9), infill(1, 9)), Fault::duplicate_packet);
}

/// Whether one message can contain all the telegrams.
bool together(std::initializer_list<const WithPackets*> telegrams) {
  Instances instances;
  for (const WithPackets* telegram : telegrams) {
    EXPECT_EQ(telegram->view.fault, Fault::none);
    instances.begin_telegram();
    for (const PacketView& packet : telegram->view.packets)
      if (instances.add(packet)) return false;
  }
  return true;
}

TEST(Instances, AcrossTheTelegramsOfAGroup) {
  const WithPackets linking(33, Packet5{{1}, {1}, {}, {}, {}, {}, {}, {}, {}, {}}), network(33, Packet45{{1}, {7}});
  EXPECT_TRUE(together({&linking, &network}));
  EXPECT_FALSE(together({&linking, &network, &linking}));
  const WithPackets first(33, restriction(1, 1)), second(33, restriction(1, 2)), both(33, restriction(2, 2));
  EXPECT_TRUE(together({&first, &second}));
  EXPECT_FALSE(together({&second, &both}));
  const WithPackets old(16, restriction(1, 1));
  EXPECT_FALSE(together({&first, &old}));  // the version makes no difference
}

TEST(Instances, InfillAcrossTelegrams) {
  const WithPackets a(33, Packet45{{1}, {7}}, infill(1, 9), Packet5{}), b(33, infill(1, 9), Packet45{{1}, {7}}),
      elsewhere(33, infill(1, 8)), back(33, infill(0, 8)), plain(33, Packet5{});
  EXPECT_TRUE(together({&a, &b}));  // one packet 136 in each, both the same; 45 once outside and once inside
  EXPECT_FALSE(together({&a, &elsewhere}));
  EXPECT_TRUE(together({&a, &back}));
  EXPECT_TRUE(together({&a, &plain}));  // packet 5 as infill, and for the group itself in the next telegram
  EXPECT_FALSE(together({&b, &b}));
}

TEST(Instances, MoreThanAMessageCanHaveAreOneTooMany) {
  std::array<std::uint8_t, 2048> room{};
  BitWriter out(room);
  for (std::uint16_t i = 0; i < 209; ++i) encode(out, cover(2, 0, 5, i));
  const auto length = static_cast<std::uint16_t>(out.position() / 209);
  Instances instances;
  for (unsigned i = 0; i < 209; ++i) {
    const PacketView view{6, length, length * i, 2, {2, 1}, Direction::to_train, true, out.bytes()};
    EXPECT_EQ(instances.add(view), i == 208);
  }
}

// 6.6.3.2.3 exceptions 9, 11 to 13: with 206, 207, 239 in the message the old packets are for other
// units.
TEST(Superseding, InTheSameTelegram) {
  Packet68_v1_0 old;
  old.Q_TRACKINIT.raw = 1;
  Packet206 own;
  own.Q_TRACKINIT.raw = 1;
  own.D_TRACKINIT.raw = 9;
  Packet70_v1_0 suitability;
  suitability.Q_TRACKINIT.raw = 1;
  Packet207 own_suitability;
  own_suitability.Q_TRACKINIT.raw = 1;
  const WithPackets made(17, old, own, Packet39_v1_0{}, Packet239{}, suitability, own_suitability);
  ASSERT_EQ(made.view.fault, Fault::none);
  ASSERT_EQ(made.view.packets.size(), 6u);  // a reader gets all of them
  PacketViews message = made.view.packets;
  const Superseding newer = superseding_in(message);
  message.erase_if([&](const PacketView& p) { return newer.drops(p); });
  ASSERT_EQ(message.size(), 3u);
  EXPECT_EQ(message[0].NID_PACKET, 68);
  EXPECT_EQ(message[1].NID_PACKET, 39);
  EXPECT_EQ(message[2].NID_PACKET, 70);
  Packet68 p;
  ASSERT_EQ(decode(message[0], p), Fault::none);
  EXPECT_EQ(p.D_TRACKINIT.raw, 9);
}

TEST(Superseding, AcrossTheTelegramsOfAGroup) {
  // The telegram for units of 1.0 is marked 1.0, the other one 1.1; packets of X = 2 are not superseded.
  Packet68_v1_0 condition;
  condition.Q_TRACKINIT.raw = 1;
  Packet68 of_2;
  of_2.Q_TRACKINIT.raw = 1;
  const WithPackets old(16, condition, Packet39_v1_0{}), own(17, Packet239{}), current(33, Packet39{}, of_2);
  const Superseding newer = superseding_in(own.view.packets);
  EXPECT_FALSE(newer.p206 || newer.p207);
  EXPECT_FALSE(newer.drops(old.view.packets[0]));
  EXPECT_TRUE(newer.drops(old.view.packets[1]));
  EXPECT_FALSE(newer.drops(own.view.packets[0]));
  EXPECT_FALSE(newer.drops(current.view.packets[0]));
  // 206 of another version is no packet at all.
  EXPECT_FALSE(superseding_in(current.view.packets).p239);
}

}  // namespace
}  // namespace evc::lang
