#include "lang/translate.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "lang/decode.h"
#include "lang/encode.h"
#include "lang/packets/packet_0.h"
#include "lang/packets/packet_131.h"
#include "lang/packets/packet_140.h"
#include "lang/packets/packet_200.h"
#include "lang/packets/packet_203.h"
#include "lang/packets/packet_206.h"
#include "lang/packets/packet_207.h"
#include "lang/packets/packet_239.h"
#include "lang/packets/packet_27.h"
#include "lang/packets/packet_3.h"
#include "lang/packets/packet_31.h"
#include "lang/packets/packet_32.h"
#include "lang/packets/packet_39.h"
#include "lang/packets/packet_41.h"
#include "lang/packets/packet_42.h"
#include "lang/packets/packet_44.h"
#include "lang/packets/packet_45.h"
#include "lang/packets/packet_46.h"
#include "lang/packets/packet_51.h"
#include "lang/packets/packet_68.h"
#include "lang/packets/packet_70.h"
#include "lang/packets/packet_72.h"
#include "lang/packets/packet_73.h"
#include "lang/packets/packet_74.h"
#include "lang/packets/packet_76.h"
#include "lang/packets/packet_79.h"
#include "lang/packets/packet_80.h"
#include "lang/packets/train_packet_0.h"
#include "lang/packets/train_packet_1.h"
#include "lang/packets/train_packet_11.h"
#include "lang/packets/train_packet_4.h"

namespace evc::lang {
namespace {

/// Writes a packet of an older version and reads it in the newest form.
template <class New, class Old>
Fault through(const Old& old, New& packet, SystemVersion sv = {1, 0}) {
  static std::array<std::uint8_t, 1100> room;
  room = {};
  BitWriter out(room);
  encode(out, old);
  EXPECT_FALSE(out.faulty());
  PacketView view;
  view.NID_PACKET = Old::info.NID_PACKET;
  view.L_PACKET = static_cast<std::uint16_t>(out.position());
  view.sv = sv;
  view.bytes = out.bytes();
  return decode(view, packet);
}

// 6.6.3.2.3 [3]
TEST(Translate, SpeedCategories) {
  constexpr std::array<int, 14> cant_deficiency{9, 0, 1, 2, 3, 4, 5, 7, 10, -1, -1, -1, 8, 6};
  Packet27_v1_0 old;
  old.Q_DIR.raw = 1;
  for (std::uint8_t i = 0; i < 14; ++i) (void)old.diffs.push_back({{i}, {20}});
  Packet27_v1_0_steps step;
  step.D_STATIC.raw = 100;
  step.V_STATIC.raw = 127;
  (void)step.diffs.push_back({{9}, {10}});
  (void)old.steps.push_back(step);
  Packet27 p;
  ASSERT_EQ(through(old, p), Fault::none);
  for (std::uint8_t i = 0; i < 14; ++i) {
    EXPECT_EQ(p.diffs[i].V_DIFF.raw, 20);
    if (cant_deficiency[i] >= 0) {
      EXPECT_EQ(p.diffs[i].Q_DIFF.raw, 0);
      EXPECT_EQ(p.diffs[i].NC_CDDIFF.raw, cant_deficiency[i]);
    } else {
      EXPECT_EQ(p.diffs[i].Q_DIFF.raw, kQ_DIFF_by_train);
      EXPECT_EQ(p.diffs[i].NC_DIFF.raw, i - 9);
    }
  }
  ASSERT_EQ(p.steps.size(), 1u);
  EXPECT_EQ(p.steps[0].V_STATIC.raw, 127);
  EXPECT_EQ(p.steps[0].diffs[0].V_DIFF.raw, 10);
  EXPECT_EQ(p.first_steps().diffs.size(), 14u);
}

TEST(Translate, NationalValues) {
  Packet3_v1_0 old;
  (void)old.areas.push_back({{426}});
  (void)old.areas.push_back({{427}});
  old.Q_NVSRBKTRG.raw = 1;
  old.V_NVSTFF.raw = 8;
  Packet3 p;
  ASSERT_EQ(through(old, p), Fault::none);
  EXPECT_EQ(p.NID_C.raw, 426);
  ASSERT_EQ(p.areas.size(), 1u);
  EXPECT_EQ(p.areas[0].NID_C.raw, 427);
  EXPECT_EQ(p.Q_NVSBTSMPERM.raw, 1);
  EXPECT_EQ(p.V_NVSTFF.raw, 8);
  EXPECT_EQ(p.V_NVLIMSUPERV.raw, 20);
  EXPECT_EQ(p.Q_NVLOCACC.raw, 12);
  EXPECT_EQ(p.M_NVEBCL.raw, 9);
  EXPECT_EQ(p.Q_NVKINT.raw, 0);
  EXPECT_EQ(p.V_NVSTFF.raw, 8);
  // Values for no country.
  old.areas.clear();
  ASSERT_EQ(through(old, p), Fault::none);
  EXPECT_EQ(p.NID_C.raw, kNoCountry);
  EXPECT_TRUE(p.areas.empty());
}

// [13], [19]
TEST(Translate, Traction) {
  Packet39_v1_0 old;
  Packet39 p;
  old.D_TRACTION.raw = 7;
  const struct {
    std::uint8_t M_TRACTION, M_VOLTAGE;
    std::uint16_t NID_CTRACTION;
  } rows[]{{0, 0, 0}, {1, 3, 10}, {6, 4, 1}, {15, 2, 22}, {34, 1, 17}, {46, 2, 9}};
  for (const auto& row : rows) {
    old.M_TRACTION.raw = row.M_TRACTION;
    ASSERT_EQ(through(old, p), Fault::none);
    EXPECT_EQ(p.D_TRACTION.raw, 7);
    EXPECT_EQ(p.M_VOLTAGE.raw, row.M_VOLTAGE);
    EXPECT_EQ(p.NID_CTRACTION.raw, row.NID_CTRACTION);
  }
  old.M_TRACTION.raw = 4;
  EXPECT_EQ(through(old, p), Fault::not_applicable);
  Packet239 newer;
  newer.M_VOLTAGE.raw = 2;
  newer.NID_CTRACTION.raw = 5;
  ASSERT_EQ(through(newer, p, {1, 1}), Fault::none);
  EXPECT_EQ(p.NID_CTRACTION.raw, 5);
  // A packet that does not exist in the version.
  EXPECT_EQ(through(newer, p, {1, 0}), Fault::not_a_packet_of_this_kind);
}

// [12]: points that do not concern traction are left out, their distances are kept.
TEST(Translate, RouteSuitability) {
  Packet70_v1_0 old;
  old.D_SUITABILITY.raw = 100;
  old.Q_SUITABILITY.raw = 1;
  Packet70_v1_0_points point;
  point.D_SUITABILITY.raw = 50;
  point.Q_SUITABILITY.raw = 2;
  point.M_TRACTION.raw = 6;
  (void)old.points.push_back(point);
  (void)old.points.push_back(point);
  point.M_TRACTION.raw = 200;
  (void)old.points.push_back(point);
  Packet70 p;
  ASSERT_EQ(through(old, p), Fault::none);
  EXPECT_EQ(p.D_SUITABILITY.raw, 150);
  EXPECT_EQ(p.Q_SUITABILITY.raw, 2);
  EXPECT_EQ(p.M_VOLTAGE.raw, 4);
  ASSERT_EQ(p.points.size(), 1u);
  EXPECT_EQ(p.points[0].D_SUITABILITY.raw, 50);
  old.Q_TRACKINIT.raw = 1;
  ASSERT_EQ(through(old, p), Fault::none);
  EXPECT_EQ(p.Q_TRACKINIT.raw, 1);
  // No point for traction.
  Packet70_v1_0 gauge;
  EXPECT_EQ(through(gauge, p), Fault::not_applicable);
  // A distance that cannot be expressed: the farthest one that can, which is nearer.
  Packet70_v1_0 far;
  far.D_SUITABILITY.raw = 32767;
  point.D_SUITABILITY.raw = 32767;
  point.M_TRACTION.raw = 6;
  (void)far.points.push_back(point);
  (void)far.points.push_back(point);
  ASSERT_EQ(through(far, p), Fault::none);
  EXPECT_EQ(p.D_SUITABILITY.raw, 32767);
  ASSERT_EQ(p.points.size(), 1u);
  EXPECT_EQ(p.points[0].D_SUITABILITY.raw, 32767);
  far.D_SUITABILITY.raw = 0;
  far.Q_SUITABILITY.raw = 2;
  far.M_TRACTION.raw = 6;
  point.Q_SUITABILITY.raw = 1;
  far.points.clear();
  (void)far.points.push_back(point);
  point.Q_SUITABILITY.raw = 2;
  (void)far.points.push_back(point);
  point.D_SUITABILITY.raw = 0;
  (void)far.points.push_back(point);
  ASSERT_EQ(through(far, p), Fault::none);
  EXPECT_EQ(p.D_SUITABILITY.raw, 0);
  ASSERT_EQ(p.points.size(), 2u);
  EXPECT_EQ(p.points[0].D_SUITABILITY.raw, 32767);
  EXPECT_EQ(p.points[1].D_SUITABILITY.raw, 32767);
  Packet207 newer;
  newer.Q_SUITABILITY.raw = 0;
  newer.M_LINEGAUGE.raw = 3;
  ASSERT_EQ(through(newer, p, {1, 1}), Fault::none);
  EXPECT_EQ(p.M_LINEGAUGE.raw, 3);
}

// [4], [5]
TEST(Translate, AxleLoads) {
  const struct {
    std::uint8_t M_AXLELOAD, M_AXLELOADCAT;
  } rows[]{{32, 0}, {33, 1}, {34, 1}, {35, 2},  {36, 2},  {37, 4},
           {40, 4}, {41, 7}, {45, 7}, {46, 11}, {80, 11}, {126, 11}};
  for (const auto& row : rows) {
    Packet51_v1_0 old;
    (void)old.categories.push_back({{row.M_AXLELOAD}, {12}});
    Packet51_v1_0_restrictions r;
    r.D_AXLELOAD.raw = 9;
    (void)r.categories.push_back({{row.M_AXLELOAD}, {13}});
    (void)old.restrictions.push_back(r);
    Packet51 p;
    ASSERT_EQ(through(old, p), Fault::none);
    EXPECT_EQ(p.categories[0].M_AXLELOADCAT.raw, row.M_AXLELOADCAT);
    EXPECT_EQ(p.restrictions[0].categories[0].M_AXLELOADCAT.raw, row.M_AXLELOADCAT);
    EXPECT_EQ(p.restrictions[0].D_AXLELOAD.raw, 9);
    EXPECT_EQ(p.D_TRACKINIT.raw, 0);
  }
}

TEST(Translate, SmallOnes) {
  Packet68_v1_0 condition;
  condition.M_TRACKCOND.raw = 2;
  (void)condition.conditions.push_back({{1}, {2}, {3}});
  Packet68 p68;
  ASSERT_EQ(through(condition, p68), Fault::none);
  EXPECT_EQ(p68.M_TRACKCOND.raw, 0);
  EXPECT_EQ(p68.conditions[0].M_TRACKCOND.raw, 3);
  Packet206 newer;
  newer.M_TRACKCONDBC.raw = 10;
  (void)newer.conditions.push_back({{1}, {2}, {9}});
  ASSERT_EQ(through(newer, p68, {1, 1}), Fault::none);
  EXPECT_EQ(p68.M_TRACKCOND.raw, 10);
  EXPECT_EQ(p68.conditions[0].M_TRACKCOND.raw, 9);

  Packet200 marker;
  marker.NID_VBCMK.raw = 33;
  Packet0 p0;
  ASSERT_EQ(through(marker, p0, {1, 1}), Fault::none);
  EXPECT_EQ(p0.NID_VBCMK.raw, 33);

  Packet44_v1_0 application;
  Packet44 p44;
  for (const auto& [user, ntc] : {std::pair{13, 28}, {39, 11}, {40, 0}}) {
    application.NID_XUSER.raw = static_cast<std::uint16_t>(user);
    ASSERT_EQ(through(application, p44), Fault::none);
    EXPECT_EQ(p44.NID_XUSER.raw, ntc != 0 ? 102 : user);
    EXPECT_EQ(p44.NID_NTC.raw, ntc);
  }

  Packet79_v1_0 place;
  place.M_POSITION.raw = 1048575;
  (void)place.references.push_back({{1}, {2}, {3}, {4}, {1}, {77}});
  Packet79 p79;
  ASSERT_EQ(through(place, p79), Fault::none);
  EXPECT_EQ(p79.M_POSITION.raw, 16777215u);
  EXPECT_EQ(p79.references[0].M_POSITION.raw, 77u);

  Packet80_v1_0 profile;
  profile.M_MAMODE.raw = 1;
  (void)profile.modes.push_back({{1}, {0}, {3}, {4}, {5}});
  Packet80 p80;
  ASSERT_EQ(through(profile, p80), Fault::none);
  EXPECT_EQ(p80.M_MAMODE.raw, 1);
  EXPECT_EQ(p80.Q_MAMODE.raw, 1);
  EXPECT_EQ(p80.modes[0].Q_MAMODE.raw, 1);

  Packet72_v1_0 text;
  text.Q_TEXTCONFIRM.raw = 2;
  text.M_LEVELTEXTDISPLAY_START.raw = 1;
  text.NID_NTC_START.raw = 6;
  (void)text.text.push_back({{65}});
  Packet72 p72;
  ASSERT_EQ(through(text, p72), Fault::none);
  EXPECT_EQ(p72.Q_TEXTCONFIRM.raw, 2);
  EXPECT_EQ(p72.Q_CONFTEXTDISPLAY.raw, 0);
  EXPECT_EQ(p72.NID_NTC_START.raw, 6);
  EXPECT_EQ(p72.text.size(), 1u);
  Packet76_v1_0 fixed;
  fixed.Q_TEXT.raw = 1;
  Packet76 p76;
  ASSERT_EQ(through(fixed, p76), Fault::none);
  EXPECT_EQ(p76.Q_TEXT.raw, 1);

  // [10]: digits F move to the right.
  Packet140_v1_0 number;
  number.NID_OPERATIONAL.raw = 0xFF12F345;
  Packet140 p140;
  ASSERT_EQ(through(number, p140), Fault::none);
  EXPECT_EQ(p140.NID_OPERATIONAL.raw, 0x12345FFFu);
  // "Unknown" has no code in X = 2.
  number.NID_OPERATIONAL.raw = 0xFFFFFFFF;
  EXPECT_EQ(through(number, p140), Fault::not_applicable);
}

// 6.6.3.4.5
TEST(Translate, ForAnRbcOfVersion1) {
  TrainPacket0 report;
  report.M_MODE.raw = 15;
  report.V_TRAIN.raw = 12;
  EXPECT_EQ(for_version_1(report).M_MODE.raw, 3);
  EXPECT_EQ(for_version_1(report).V_TRAIN.raw, 12);
  TrainPacket1 two;
  two.M_MODE.raw = 12;
  two.NID_PRVLRBG.raw = 5;
  EXPECT_EQ(for_version_1(two).M_MODE.raw, 12);
  EXPECT_EQ(for_version_1(two).NID_PRVLRBG.raw, 5u);
  EXPECT_EQ(for_version_1(TrainPacket4{{6}}).M_ERROR.raw, 7);
  EXPECT_EQ(for_version_1(TrainPacket4{{3}}).M_ERROR.raw, 3);
  constexpr std::array<unsigned, 11> bit{1, 2, 3, 4, 5, 6, 13, 7, 12, 0, 8};
  for (std::uint8_t category = 0; category < 11; ++category) {
    TrainPacket11 data;
    data.NC_CDTRAIN.raw = category;
    data.NC_TRAIN.raw = 2;
    data.M_AXLELOADCAT.raw = 7;
    (void)data.ntcs.push_back({{5}});
    (void)data.tractions.push_back({{1}, {2}});
    const TrainPacket11_v1_0 old = for_version_1(data, {0x1234FFFF});
    EXPECT_EQ(old.NC_TRAIN.raw, (1u << bit[category]) | (1u << 10));
    EXPECT_EQ(old.M_AXLELOAD.raw, 45);
    EXPECT_EQ(old.NID_OPERATIONAL.raw, 0x1234FFFFu);
    EXPECT_EQ(old.ntcs.size(), 1u);
    EXPECT_TRUE(old.tractions.empty());
  }
  TrainMessage132 request;
  request.Q_MARQSTREASON.raw = 8;
  EXPECT_EQ(for_version_1(request).Q_TRACKDEL.raw, 1);
  request.Q_MARQSTREASON.raw = 23;
  EXPECT_EQ(for_version_1(request).Q_TRACKDEL.raw, 0);
  constexpr std::array<int, 4> answer{0, 0, 2, 1};
  for (std::uint8_t q = 0; q < 4; ++q) {
    TrainMessage147 m;
    m.Q_EMERGENCYSTOP.raw = q;
    EXPECT_EQ(for_version_1(m).Q_EMERGENCYSTOP.raw, answer[q]);
  }
}

// 6.6.3.3
TEST(Translate, Messages) {
  std::array<std::uint8_t, 64> room{};
  BitWriter out(room);
  Message15_v1_0 stop;
  stop.NID_EM.raw = 3;
  stop.Q_DIR.raw = 1;
  stop.D_EMERGENCYSTOP.raw = 77;
  encode_message(out, stop);
  Message15 m;
  m.D_REF.raw = 5;
  ASSERT_EQ(decode(scan_message_to_train(out.bytes(), {1, 0}), m), Fault::none);
  EXPECT_EQ(m.D_REF.raw, 0);
  EXPECT_EQ(m.D_EMERGENCYSTOP.raw, 77);
  Message34_v1_0 free;
  free.L_TAFDISPLAY.raw = 8;
  room = {};
  BitWriter second(room);
  encode_message(second, free);
  Message34 m34;
  ASSERT_EQ(decode(scan_message_to_train(second.bytes(), {1, 1}), m34), Fault::none);
  EXPECT_EQ(m34.L_TAFDISPLAY.raw, 8);
  Message41 accepted;
  accepted.NID_LRBG.raw = 5;
  room = {};
  BitWriter third(room);
  encode_message(third, accepted);
  const MessageToTrainView view = scan_message_to_train(third.bytes(), {1, 0});
  EXPECT_EQ(view.NID_LRBG.raw, 16777215u);
  Message41 read;
  ASSERT_EQ(decode(view, read), Fault::none);
  EXPECT_EQ(read.NID_LRBG.raw, 16777215u);
  EXPECT_EQ(decode(view, m34), Fault::not_a_packet_of_this_kind);
  TrainMessage136 report;
  EXPECT_EQ(decode(scan_message_to_track(third.bytes(), {2, 1}), report), Fault::not_a_packet_of_this_kind);
}

// --- 2.2 to 3.0 in the form in which the unit uses them (6.6.5.2 and the other way round)

TEST(Translate, TextOfX3) {
  Packet73 plain;
  plain.M_LEVELTEXTDISPLAY_START.raw = 4;
  plain.M_LEVELTEXTDISPLAY_END.raw = 1;
  plain.NID_NTC_END.raw = 9;
  plain.M_MODETEXTDISPLAY_START.raw = 5;
  plain.M_MODETEXTDISPLAY_END.raw = 15;
  plain.Q_TEXTCONFIRM.raw = 1;
  plain.Q_TEXTREPORT.raw = 1;
  plain.NID_TEXTMESSAGE.raw = 77;
  (void)plain.text.push_back({{'a'}});
  Packet72 p;
  ASSERT_EQ(through(plain, p, {3, 0}), Fault::none);
  EXPECT_EQ(p.M_LEVELTEXTDISPLAY_START.raw, 5) << "not limited by level";
  EXPECT_EQ(p.M_LEVELTEXTDISPLAY_END.raw, 1);
  EXPECT_EQ(p.NID_NTC_END.raw, 9);
  EXPECT_EQ(p.M_MODETEXTDISPLAY_START.raw, 5);
  EXPECT_EQ(p.NID_TEXTMESSAGE.raw, 77);
  ASSERT_EQ(p.text.size(), 1u);
  Packet74_v2_3 fixed;
  fixed.M_LEVELTEXTDISPLAY_START.raw = 4;
  fixed.M_MODETEXTDISPLAY_START.raw = 3;
  fixed.Q_TEXT.raw = 1;
  Packet76 q;
  ASSERT_EQ(through(fixed, q, {2, 3}), Fault::none);
  EXPECT_EQ(q.M_LEVELTEXTDISPLAY_START.raw, 4) << "level 3, as before X = 3";
  EXPECT_EQ(q.M_MODETEXTDISPLAY_START.raw, 3);
  EXPECT_EQ(q.Q_TEXT.raw, 1);
}

// 7.5.1.66, .67, .73: the codes that are spare in one version and not in another.
TEST(Translate, SpareCodesByVersion) {
  Packet72 p;
  Packet73_v2_2 of_2_2;
  of_2_2.M_MODETEXTDISPLAY_START.raw = 5;
  EXPECT_EQ(through(of_2_2, p, {2, 2}), Fault::spare_value) << "SM from 2.3 on";
  of_2_2.M_MODETEXTDISPLAY_START.raw = 3;
  EXPECT_EQ(through(of_2_2, p, {2, 2}), Fault::none);
  Packet73 of_3;
  of_3.M_LEVELTEXTDISPLAY_START.raw = 5;
  EXPECT_EQ(through(of_3, p, {3, 0}), Fault::spare_value);
  Packet41_v3_0 order;
  Packet41 q;
  order.M_LEVELTR.raw = 4;
  EXPECT_EQ(through(order, q, {3, 0}), Fault::spare_value);
  order.M_LEVELTR.raw = 3;
  (void)order.levels.push_back({{1}, {22}, {50}});
  ASSERT_EQ(through(order, q, {3, 0}), Fault::none);
  EXPECT_EQ(q.M_LEVELTR.raw, 3);
  ASSERT_EQ(q.levels.size(), 1u);
  EXPECT_EQ(q.levels[0].NID_NTC.raw, 22);
  EXPECT_EQ(q.levels[0].L_ACKLEVELTR.raw, 50);
  Packet46_v3_0 conditional;
  Packet46 r;
  (void)conditional.levels.push_back({{1}, {7}});
  ASSERT_EQ(through(conditional, r, {3, 0}), Fault::none);
  EXPECT_EQ(r.levels[0].NID_NTC.raw, 7);
  conditional.M_LEVELTR.raw = 4;
  EXPECT_EQ(through(conditional, r, {3, 0}), Fault::spare_value);
}

// [18], 6.6.5.2.2
TEST(Translate, AxleLoadCategoriesOfALine) {
  constexpr std::array<std::uint16_t, 13> sets{0x1,  0x3,   0x7,   0xF,   0x1F,  0x3F,  0x7F,
                                               0xFF, 0x1FF, 0x3FF, 0x7FF, 0xFFF, 0x1FFF};
  for (std::uint8_t k = 0; k < 13; ++k) {
    Packet70 of_2;
    of_2.Q_SUITABILITY.raw = 1;
    of_2.M_AXLELOADCAT.raw = k;
    Packet70_v3_0 p;
    for (const SystemVersion sv : {SystemVersion{2, 0}, SystemVersion{2, 3}}) {
      ASSERT_EQ(through(of_2, p, sv), Fault::none);
      EXPECT_EQ(p.M_LINEAXLELOADCAT.raw, sets[k]);
    }
    Packet207 of_1;
    of_1.Q_SUITABILITY.raw = 1;
    of_1.M_AXLELOADCAT.raw = k;
    ASSERT_EQ(through(of_1, p, {1, 1}), Fault::none);
    EXPECT_EQ(p.M_LINEAXLELOADCAT.raw, sets[k]);
  }
  Packet70_v1_0 traction;
  traction.Q_SUITABILITY.raw = 2;
  traction.M_TRACTION.raw = 2;
  Packet70_v3_0 p;
  ASSERT_EQ(through(traction, p), Fault::none);
  EXPECT_EQ(p.NID_CTRACTION.raw, 12);
  EXPECT_EQ(p.M_LINEAXLELOADCAT.raw, 0);
  traction.M_TRACTION.raw = 4;
  EXPECT_EQ(through(traction, p), Fault::not_applicable);
}

// 6.6.5.2.7; orders to an RBC without GSM-R have no number.
TEST(Translate, NetworkAndRbcWithoutNumber) {
  Packet45_v3_0 network;
  ASSERT_EQ(through(Packet45{{1}, {0x26210F}}, network, {2, 3}), Fault::none);
  EXPECT_EQ(network, (Packet45_v3_0{{1}, {2}, {0x26210F}}));
  Packet42 session;
  ASSERT_EQ(through(Packet32{{2}, {1}, {426}, {7}, {1}}, session, {2, 3}), Fault::none);
  EXPECT_EQ(session, (Packet42{{2}, {1}, {426}, {7}, {kNo_number}, {1}}));
  Packet131 transition;
  ASSERT_EQ(through(Packet31{{1}, {1}, {500}, {426}, {8}, {0}}, transition, {3, 0}), Fault::none);
  EXPECT_EQ(transition, (Packet131{{1}, {1}, {500}, {426}, {8}, {kNo_number}, {0}}));
}

}  // namespace
}  // namespace evc::lang
