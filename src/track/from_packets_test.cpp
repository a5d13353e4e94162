#include "lang/packets/packet_12.h"
#include "lang/packets/packet_141.h"
#include "lang/packets/packet_15.h"
#include "lang/packets/packet_16.h"
#include "lang/packets/packet_21.h"
#include "lang/packets/packet_27.h"
#include "lang/packets/packet_51.h"
#include "lang/packets/packet_52.h"
#include "lang/packets/packet_57.h"
#include "lang/packets/packet_64.h"
#include "lang/packets/packet_65.h"
#include "lang/packets/packet_66.h"
#include "lang/packets/packet_72.h"
#include "lang/packets/packet_76.h"
#include "lang/packets/packet_80.h"
#include "lang/packets/packet_88.h"
#include "track/from_packets_testing.h"

namespace evc::track {
namespace {

using namespace testing;

TEST(FromPackets, Direction) {  // 3.6.3.1.3-4
  struct Case {
    std::uint8_t Q_DIR;
    Direction orientation;
    bool valid;
  };
  for (const Case& c :
       {Case{2, Direction::unknown, true}, Case{1, Direction::unknown, false}, Case{0, Direction::unknown, false},
        Case{1, Direction::nominal, true}, Case{0, Direction::nominal, false}, Case{0, Direction::reverse, true},
        Case{1, Direction::reverse, false}, Case{2, Direction::reverse, true}})
    EXPECT_EQ(valid_direction(c.Q_DIR, c.orientation), c.valid);
  lang::Packet66 p;
  p.Q_DIR.raw = 0;
  const Written written(p);
  Contents c;
  EXPECT_EQ(add(c, written.view, reference()), Added::other_direction);
}

TEST(FromPackets, StopLocation) {
  lang::Message15 m;
  m.Q_SCALE.raw = 1;
  m.D_REF.raw = static_cast<std::uint16_t>(-30);
  m.Q_DIR.raw = 1;
  m.D_EMERGENCYSTOP.raw = 100;
  Reference r = reference();
  EXPECT_EQ(stop_location(m, r), at(1070)) << "the reference lies 30 m in rear";
  m.Q_DIR.raw = 0;
  EXPECT_FALSE(stop_location(m, r));
  r.orientation = Direction::reverse;
  EXPECT_EQ(stop_location(m, r), at(1130)) << "against the nominal direction the shift turns";
}

TEST(FromPackets, OthersAndBrokenOnes) {
  lang::Packet57 p;
  p.Q_DIR.raw = 1;
  Contents c;
  EXPECT_EQ(add(c, Written(p).view, reference()), Added::not_stored_here);
  for (const std::uint16_t id : std::array<std::uint16_t, 3>{12, 39, 49}) {
    Written broken(p);
    broken.view.NID_PACKET = id;
    broken.view.bytes = std::span<const std::uint8_t>(broken.bytes).first(4);
    EXPECT_EQ(add(c, broken.view, reference()), Added::faulty) << id;
  }
}

TEST(FromPackets, ContentsBeginEmpty) {
  auto p = packet_in_metres<lang::Packet65>();
  p.Q_DIR.raw = 1;
  Contents c;
  begin(c, reference(), Duration{90});
  EXPECT_EQ(c.medium, Medium::rbc);
  EXPECT_EQ(c.time, Duration{90});
  EXPECT_EQ(c.reference, at(1000));
  EXPECT_FALSE(c.infill);
  EXPECT_EQ(add(c, Written(p).view, reference()), Added::added);
  c.ma = authority_to(1000);
  c.generic_ls_marker = true;
  c.lose(65, at(5));
  begin(c, reference(2000), Duration{91}, at(2000));
  EXPECT_EQ(c.reference, at(2000));
  EXPECT_EQ(c.infill, at(2000));
  EXPECT_TRUE(c.tsr.empty() && c.lost.empty());
  EXPECT_FALSE(c.ma || c.generic_ls_marker || c.lost_from);
}

TEST(FromPackets, AuthorityAlone) {  // 4.8.3 [4], 3.8.6: judged before it counts
  auto p = packet_in_metres<lang::Packet12>();
  p.Q_DIR.raw = 1;
  p.V_MAIN.raw = 12;
  p.L_ENDSECTION.raw = 700;
  p.Q_SECTIONTIMER.raw = 1;
  p.T_SECTIONTIMER.raw = 40;
  auto modes = packet_in_metres<lang::Packet80>();
  modes.Q_DIR.raw = 1;
  AuthorityContents alone;
  EXPECT_EQ(add(alone, Duration{90}, Written(p).view, reference()), Added::added);
  EXPECT_EQ(add(alone, Duration{90}, Written(modes).view, reference()), Added::added);
  EXPECT_EQ(alone.ma, contents_of(p).ma) << "as with all the others";
  EXPECT_EQ(alone.ma->sections[0].timer.started, Duration{90});
  EXPECT_EQ(alone.V_MAIN, 12);
  EXPECT_EQ(alone.mode_profile, contents_of(modes).mode_profile);
  EXPECT_FALSE(alone.sh_list);
  lang::Packet66 other;
  other.Q_DIR.raw = 1;
  EXPECT_EQ(add(alone, Duration{90}, Written(other).view, reference()), Added::not_stored_here);
  p.Q_DIR.raw = 0;
  AuthorityContents against;
  EXPECT_EQ(add(against, Duration{90}, Written(p).view, reference()), Added::other_direction);
  EXPECT_FALSE(against.ma);
}

TEST(FromPackets, MovementAuthorityLevel2) {
  auto p = packet_in_metres<lang::Packet15>();
  p.V_EMA.raw = 4;
  p.T_EMA.raw = 60;
  lang::Packet15_sections s;
  s.L_SECTION.raw = 500;
  s.Q_SECTIONTIMER.raw = 1;
  s.T_SECTIONTIMER.raw = 30;
  s.D_SECTIONTIMERSTOPLOC.raw = 100;
  ASSERT_TRUE(p.sections.push_back(s));
  p.L_ENDSECTION.raw = 700;
  p.Q_SECTIONTIMER.raw = 1;
  p.T_SECTIONTIMER.raw = 1023;
  p.D_SECTIONTIMERSTOPLOC.raw = 50;
  p.Q_ENDTIMER.raw = 1;
  p.T_ENDTIMER.raw = 20;
  p.D_ENDTIMERSTARTLOC.raw = 200;
  p.Q_DANGERPOINT.raw = 1;
  p.D_DP.raw = 10;
  p.V_RELEASEDP.raw = 126;
  p.Q_OVERLAP.raw = 1;
  p.D_STARTOL.raw = 300;
  p.T_OL.raw = 40;
  p.D_OL.raw = 60;
  p.V_RELEASEOL.raw = 8;
  const Contents c = contents_of(p);
  ASSERT_TRUE(c.ma);
  const MovementAuthority& ma = *c.ma;
  EXPECT_FALSE(ma.level_1);
  ASSERT_EQ(ma.sections.size(), 2u);
  EXPECT_EQ(ma.sections[0].begin, at(1000));
  EXPECT_EQ(ma.sections[0].end, at(1500));
  EXPECT_EQ(ma.sections[0].stop, at(1100));
  EXPECT_EQ(ma.sections[0].timer.limit, Duration{30});
  EXPECT_EQ(ma.sections[0].timer.started, Duration{90});
  EXPECT_EQ(ma.sections[1].stop, at(1550));
  EXPECT_FALSE(ma.sections[1].timer.limit) << "endless";
  EXPECT_EQ(ma.end(), at(2200));
  EXPECT_TRUE(ma.limited());
  EXPECT_EQ(ma.V_LOA, Speed{20 / 3.6});
  EXPECT_EQ(ma.loa_timer.limit, Duration{60});
  EXPECT_EQ(ma.end_section->start, at(2000));
  EXPECT_EQ(ma.danger_point->at, at(2210));
  EXPECT_EQ(ma.danger_point->release.kind, ReleaseSpeedChoice::on_board);
  EXPECT_EQ(ma.overlap->start, at(1900));
  EXPECT_EQ(ma.overlap->end, at(2260));
  EXPECT_EQ(ma.overlap->release.V, Speed{40 / 3.6});
}

TEST(FromPackets, ReleaseSpeeds) {  // 7.5.1.161, 7.5.1.162
  struct Case {
    std::uint8_t code;
    Release expected;
  };
  for (const Case& k : {Case{0, {ReleaseSpeedChoice::value, {}}}, Case{8, {ReleaseSpeedChoice::value, Speed{40 / 3.6}}},
                        Case{126, {ReleaseSpeedChoice::on_board, {}}}, Case{127, {ReleaseSpeedChoice::national, {}}}}) {
    auto p = packet_in_metres<lang::Packet15>();
    p.L_ENDSECTION.raw = 700;
    p.Q_DANGERPOINT.raw = 1;
    p.V_RELEASEDP.raw = k.code;
    p.Q_OVERLAP.raw = 1;
    p.V_RELEASEOL.raw = k.code;
    const Contents c = contents_of(p);
    EXPECT_EQ(c.ma->danger_point->release, k.expected) << int{k.code};
    EXPECT_EQ(c.ma->overlap->release, k.expected) << int{k.code};
  }
}

TEST(FromPackets, MovementAuthorityLevel1AndRepositioning) {
  auto p = packet_in_metres<lang::Packet12>();
  p.V_MAIN.raw = 16;
  p.L_ENDSECTION.raw = 900;
  p.Q_DANGERPOINT.raw = 1;
  p.V_RELEASEDP.raw = 127;
  const Contents c = contents_of(p);
  EXPECT_TRUE(c.ma->level_1);
  EXPECT_EQ(c.V_MAIN, 16);
  EXPECT_EQ(c.ma->danger_point->release.kind, ReleaseSpeedChoice::national);
  EXPECT_FALSE(c.ma->loa_timer.running);
  auto r = packet_in_metres<lang::Packet16>();
  r.L_SECTION.raw = 321;
  const Contents d = contents_of(r);
  EXPECT_EQ(d.repositioned_section, Distance{321});
  EXPECT_EQ(d.reference, at(1000));
}

TEST(FromPackets, Profiles) {
  auto g = packet_in_metres<lang::Packet21>();
  g.Q_SCALE.raw = 0;
  g.D_GRADIENT.raw = 15;
  g.G_A.raw = 7;
  lang::Packet21_steps gs;
  gs.D_GRADIENT.raw = 1000;
  gs.Q_GDIR.raw = 1;
  gs.G_A.raw = 12;
  ASSERT_TRUE(g.steps.push_back(gs));
  gs.G_A.raw = 255;
  ASSERT_TRUE(g.steps.push_back(gs));
  const NewGradientProfile gradient = *contents_of(g).gradient;
  ASSERT_EQ(gradient.steps.size(), 3u);
  EXPECT_EQ(gradient.steps[0].from, at(1001.5));
  EXPECT_EQ(gradient.steps[0].value.permille, -7) << "downhill";
  EXPECT_EQ(gradient.steps[1].value.permille, 12);
  EXPECT_EQ(gradient.steps[2].from, at(1201.5));
  EXPECT_FALSE(gradient.steps[2].value.known());

  auto s = packet_in_metres<lang::Packet27>();
  s.V_STATIC.raw = 28;
  s.Q_FRONT.raw = 1;
  lang::Packet27_diffs diff;
  diff.NC_CDDIFF.raw = 2;
  diff.V_DIFF.raw = 32;
  ASSERT_TRUE(s.diffs.push_back(diff));
  diff.Q_DIFF.raw = 1;
  diff.NC_DIFF.raw = 2;
  diff.V_DIFF.raw = 20;
  ASSERT_TRUE(s.diffs.push_back(diff));
  diff.Q_DIFF.raw = 2;
  diff.NC_DIFF.raw = 0;
  diff.V_DIFF.raw = 18;
  ASSERT_TRUE(s.diffs.push_back(diff));
  lang::Packet27_steps end;
  end.D_STATIC.raw = 400;
  end.V_STATIC.raw = 127;
  ASSERT_TRUE(s.steps.push_back(end));
  const NewStaticSpeedProfile ssp = *contents_of(s).ssp;
  ASSERT_EQ(ssp.steps.size(), 2u);
  const StaticSpeed& e = ssp.steps[0].value;
  EXPECT_TRUE(e.Q_FRONT);
  EXPECT_EQ(e.cd[2], 32);
  EXPECT_EQ(e.other[2], 20);
  EXPECT_EQ(e.other[0], 18);
  EXPECT_EQ(e.replaces_cd, 4);
  EXPECT_EQ(e.speed_for({2, 0, 0}), 32);
  EXPECT_EQ(ssp.steps[1].from, at(1400));
  EXPECT_FALSE(ssp.steps[1].value.known());
}

TEST(FromPackets, AxleLoadAndPermittedBrakingDistance) {
  auto a = packet_in_metres<lang::Packet51>();
  a.D_AXLELOAD.raw = 100;
  a.L_AXLELOAD.raw = 50;
  lang::Packet51_categories category;
  category.M_AXLELOADCAT.raw = 4;
  category.V_AXLELOAD.raw = 10;
  ASSERT_TRUE(a.categories.push_back(category));
  lang::Packet51_restrictions more;
  more.D_AXLELOAD.raw = 20;
  more.L_AXLELOAD.raw = 5;
  more.Q_FRONT.raw = 1;
  ASSERT_TRUE(a.restrictions.push_back(more));
  const auto asp = *contents_of(a).asp;
  EXPECT_EQ(asp.from, at(1100));
  ASSERT_EQ(asp.elements.size(), 2u);
  EXPECT_EQ(asp.elements[0].to, at(1150));
  EXPECT_EQ(asp.elements[0].V_AXLELOAD[4], 10);
  EXPECT_EQ(asp.elements[1].from, at(1120)) << "from start to start";
  auto init = packet_in_metres<lang::Packet51>();
  init.Q_TRACKINIT.raw = 1;
  init.D_TRACKINIT.raw = 30;
  EXPECT_TRUE(contents_of(init).asp->initial_state);
  EXPECT_EQ(contents_of(init).asp->from, at(1030));

  auto b = packet_in_metres<lang::Packet52>();
  b.D_PBD.raw = 800;
  b.G_PBDSR.raw = 9;
  b.Q_PBDSR.raw = 1;
  b.D_PBDSR.raw = 100;
  b.L_PBDSR.raw = 10;
  lang::Packet52_restrictions next;
  next.Q_GDIR.raw = 1;
  next.G_PBDSR.raw = 4;
  next.D_PBDSR.raw = 5;
  ASSERT_TRUE(b.restrictions.push_back(next));
  const auto pbd = *contents_of(b).pbd;
  EXPECT_EQ(pbd.elements[0].D_PBD, Distance{800});
  EXPECT_EQ(pbd.elements[0].gradient_permille, -9);
  EXPECT_TRUE(pbd.elements[0].service_brake);
  EXPECT_EQ(pbd.elements[1].from, at(1105));
  EXPECT_EQ(pbd.elements[1].gradient_permille, 4);
  auto empty = packet_in_metres<lang::Packet52>();
  empty.Q_TRACKINIT.raw = 1;
  EXPECT_TRUE(contents_of(empty).pbd->initial_state);
}

TEST(FromPackets, TemporarySpeedRestrictions) {
  auto p = packet_in_metres<lang::Packet65>();
  p.NID_TSR.raw = 130;
  p.D_TSR.raw = 200;
  p.L_TSR.raw = 300;
  p.V_TSR.raw = 8;
  const Contents c = contents_of(p);
  ASSERT_EQ(c.tsr.size(), 1u);
  EXPECT_EQ(c.tsr[0].from, at(1200));
  EXPECT_EQ(c.tsr[0].to, at(1500));
  EXPECT_TRUE(c.tsr[0].from_rbc);
  EXPECT_FALSE(c.tsr[0].Q_FRONT);
  lang::Packet66 revoke;
  revoke.NID_TSR.raw = 9;
  EXPECT_EQ(contents_of(revoke).revoked_tsr[0], 9);
  EXPECT_TRUE(contents_of(lang::Packet64{}).inhibit_revocable_tsr);
  lang::Packet141 gradient;
  gradient.G_TSR.raw = 6;
  EXPECT_EQ(contents_of(gradient).default_gradient, -6);
  gradient.Q_GDIR.raw = 1;
  EXPECT_EQ(contents_of(gradient).default_gradient, 6);
}

TEST(FromPackets, LevelCrossingAndModeProfile) {
  auto x = packet_in_metres<lang::Packet88>();
  x.NID_LX.raw = 4;
  x.D_LX.raw = 100;
  x.L_LX.raw = 20;
  EXPECT_FALSE(contents_of(x).lx[0].unprotected);
  x.Q_LXSTATUS.raw = 1;
  x.V_LX.raw = 2;
  x.Q_STOPLX.raw = 1;
  x.L_STOPLX.raw = 30;
  const LevelCrossing lx = contents_of(x).lx[0];
  EXPECT_TRUE(lx.unprotected && lx.stop_required);
  EXPECT_EQ(lx.to, at(1120));
  EXPECT_EQ(lx.L_STOPLX, Distance{30});
  EXPECT_FALSE(lx.substituted || lx.informed) << "the driver was not informed (5.16)";

  auto m = packet_in_metres<lang::Packet80>();
  m.D_MAMODE.raw = 500;
  m.V_MAMODE.raw = 127;
  m.L_MAMODE.raw = 32767;
  m.L_ACKMAMODE.raw = 200;
  m.Q_MAMODE.raw = 1;
  lang::Packet80_modes sh;
  sh.D_MAMODE.raw = 300;
  sh.M_MAMODE.raw = 1;
  sh.V_MAMODE.raw = 5;
  sh.L_MAMODE.raw = 100;
  ASSERT_TRUE(m.modes.push_back(sh));
  sh.M_MAMODE.raw = 2;
  ASSERT_TRUE(m.modes.push_back(sh));
  const ModeProfile profile = *contents_of(m).mode_profile;
  ASSERT_EQ(profile.size(), 3u);
  EXPECT_EQ(profile[0].mode, Mode::OS);
  EXPECT_EQ(profile[0].ack_from, at(1300));
  EXPECT_EQ(profile[0].V_MAMODE, kNoSpeed);
  EXPECT_FALSE(profile[0].to);
  EXPECT_TRUE(profile[0].also_SvL);
  EXPECT_EQ(profile[1].from, at(1800));
  EXPECT_FALSE(profile[1].to) << "the length of a shunting area is ignored";
  EXPECT_FALSE(profile[1].also_SvL);
  EXPECT_EQ(profile[2].mode, Mode::LS);
  EXPECT_EQ(profile[2].to, at(2200));
  EXPECT_EQ(profile[2].V_MAMODE, 5);
}

TEST(FromPackets, MoreThanThereIsRoomForIsSaid) {
  lang::Packet66 p;
  p.Q_DIR.raw = 1;
  const Written written(p);
  Contents c;
  for (std::size_t i = 0; i < c.revoked_tsr.capacity(); ++i) ASSERT_EQ(add(c, written.view, reference()), Added::added);
  EXPECT_TRUE(c.lost.empty());
  ASSERT_EQ(add(c, written.view, reference()), Added::added);
  ASSERT_EQ(c.lost.size(), 1u);
  EXPECT_EQ(c.lost[0], 66);
  EXPECT_FALSE(c.lost_from) << "the restriction stays";
}

TEST(FromPackets, TheLastRestrictionCoversThoseForWhichThereIsNoRoom) {
  lang::Packet65 p;
  p.Q_DIR.raw = 1;
  p.Q_SCALE.raw = 1;
  p.L_TSR.raw = 100;
  p.V_TSR.raw = 16;
  Contents c;
  for (std::size_t i = 0; i < c.tsr.capacity(); ++i) {
    p.NID_TSR.raw = static_cast<std::uint8_t>(i);
    p.D_TSR.raw = static_cast<std::uint16_t>(1000 + 200 * i);
    ASSERT_EQ(add(c, Written(p).view, reference()), Added::added);
  }
  const Place last_end = c.tsr.back().to;
  p.D_TSR.raw = 300;
  p.V_TSR.raw = 6;
  ASSERT_EQ(add(c, Written(p).view, reference()), Added::added);
  ASSERT_EQ(add(c, Written(p).view, reference()), Added::added);
  EXPECT_EQ(c.tsr.back().V_TSR, 6);
  EXPECT_EQ(c.tsr.back().from, reference().place + Distance{300.0});
  EXPECT_EQ(c.tsr.back().to, last_end);
  EXPECT_EQ(c.tsr.back().NID_TSR, 255);
  ASSERT_EQ(c.lost.size(), 1u) << "one word for a packet kind";
  EXPECT_EQ(c.lost[0], 65);
}

TEST(FromPackets, TheNearestLevelCrossingWithoutRoomIsRemembered) {
  lang::Packet88 p;
  p.Q_DIR.raw = 1;
  p.Q_SCALE.raw = 1;
  p.Q_LXSTATUS.raw = 1;
  Contents c;
  const auto at_metre = [&](std::uint16_t D_LX) {
    p.D_LX.raw = D_LX;
    ++p.NID_LX.raw;
    ASSERT_EQ(add(c, Written(p).view, reference()), Added::added);
  };
  for (std::size_t i = 0; i < c.lx.capacity(); ++i) at_metre(5000);
  p.Q_LXSTATUS.raw = 0;
  at_metre(600);
  EXPECT_EQ(c.lost.size(), 1u);
  EXPECT_FALSE(c.lost_from) << "a protected one asks for nothing";
  p.Q_LXSTATUS.raw = 1;
  at_metre(900);
  at_metre(700);
  at_metre(800);
  ASSERT_TRUE(c.lost_from);
  EXPECT_EQ(*c.lost_from, reference().place + Distance{700.0});
}

TEST(FromPackets, AThirdTextOfOneMessageIsSaid) {
  lang::Packet76 fixed;
  fixed.Q_DIR.raw = 1;
  Contents c;
  for (int i = 0; i < 3; ++i) ASSERT_EQ(add(c, Written(fixed).view, reference()), Added::added);
  lang::Packet72 plain;
  plain.Q_DIR.raw = 1;
  ASSERT_EQ(add(c, Written(plain).view, reference()), Added::added);
  ASSERT_EQ(c.lost.size(), 2u);
  EXPECT_EQ(c.lost[0], 76);
  EXPECT_EQ(c.lost[1], 72);
}

}  // namespace
}  // namespace evc::track
