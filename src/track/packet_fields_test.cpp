#include "lang/packets/packet_131.h"
#include "lang/packets/packet_133.h"
#include "lang/packets/packet_138.h"
#include "lang/packets/packet_139.h"
#include "lang/packets/packet_15.h"
#include "lang/packets/packet_21.h"
#include "lang/packets/packet_27.h"
#include "lang/packets/packet_39.h"
#include "lang/packets/packet_40.h"
#include "lang/packets/packet_51.h"
#include "lang/packets/packet_52.h"
#include "lang/packets/packet_65.h"
#include "lang/packets/packet_66.h"
#include "lang/packets/packet_69.h"
#include "lang/packets/packet_70.h"
#include "lang/packets/packet_71.h"
#include "lang/packets/packet_72.h"
#include "lang/packets/packet_76.h"
#include "lang/packets/packet_79.h"
#include "lang/packets/packet_80.h"
#include "lang/packets/packet_88.h"
#include "lang/packets/packet_90.h"
#include "track/from_packets_testing.h"

// Every variable of a packet arrives where it belongs (7.4.2), also the largest value before a special one (7.5.1).
namespace evc::track {
namespace {

using namespace testing;

TEST(PacketFields, The_medium_is_that_of_the_message) {
  for (const Medium medium : {Medium::balise, Medium::rbc}) {
    Contents c;
    Reference r = reference();
    r.medium = medium;
    auto p = packet_in_metres<lang::Packet65>();
    p.Q_DIR.raw = 1;
    EXPECT_EQ(add(c, Written(p).view, r), Added::added);
    EXPECT_EQ(c.medium, medium);
    EXPECT_EQ(c.tsr[0].from_rbc, medium == Medium::rbc);
  }
  EXPECT_EQ(Reference{}.medium, Medium::balise);
}

TEST(PacketFields, Timers_of_an_MA_run_from_its_time_but_those_that_a_place_starts) {  // 3.8.4
  auto p = packet_in_metres<lang::Packet15>();
  p.V_EMA.raw = 4;
  p.T_EMA.raw = 60;
  p.L_ENDSECTION.raw = 700;
  p.Q_SECTIONTIMER.raw = p.Q_ENDTIMER.raw = p.Q_OVERLAP.raw = 1;
  p.T_SECTIONTIMER.raw = 30;
  p.T_ENDTIMER.raw = 20;
  p.T_OL.raw = 40;
  const MovementAuthority ma = *contents_of(p).ma;
  EXPECT_EQ(ma.sections[0].timer, (Timer{Duration{30}, Duration{90}, true}));
  EXPECT_TRUE(ma.sections[0].timed);
  EXPECT_EQ(ma.loa_timer, (Timer{Duration{60}, Duration{90}, true}));
  EXPECT_EQ(ma.end_section->timer, (Timer{Duration{20}, {}, false}));
  EXPECT_EQ(ma.overlap->timer, (Timer{Duration{40}, {}, false}));
  EXPECT_FALSE(MovementAuthority{}.loa_timer.running);
  p.Q_SECTIONTIMER.raw = 0;
  EXPECT_FALSE(contents_of(p).ma->sections[0].timed);
}

TEST(PacketFields, Gradient_21) {
  auto p = packet_in_metres<lang::Packet21>();
  p.D_GRADIENT.raw = 10;
  p.Q_GDIR.raw = 1;
  p.G_A.raw = 254;
  lang::Packet21_steps step;
  step.D_GRADIENT.raw = 20;
  step.Q_GDIR.raw = 0;
  step.G_A.raw = 254;
  ASSERT_TRUE(p.steps.push_back(step));
  step.G_A.raw = 255;
  ASSERT_TRUE(p.steps.push_back(step));
  const NewGradientProfile profile = *contents_of(p).gradient;
  ASSERT_EQ(profile.steps.size(), 3u);
  EXPECT_EQ(profile.steps[0].from, at(1010));
  EXPECT_EQ(profile.steps[0].value.permille, 254);
  EXPECT_EQ(profile.steps[1].from, at(1030));
  EXPECT_EQ(profile.steps[1].value.permille, -254);
  EXPECT_EQ(profile.steps[2].from, at(1050));
  EXPECT_FALSE(profile.steps[2].value.known());
}

TEST(PacketFields, Static_speed_profile_27) {
  auto p = packet_in_metres<lang::Packet27>();
  p.V_STATIC.raw = 20;
  p.Q_FRONT.raw = 1;
  lang::Packet27_diffs diff;
  const auto append = [&](unsigned Q_DIFF, unsigned category, unsigned V) {
    diff = {};
    diff.Q_DIFF.raw = static_cast<std::uint8_t>(Q_DIFF);
    (Q_DIFF == 0 ? diff.NC_CDDIFF.raw : diff.NC_DIFF.raw) = static_cast<std::uint8_t>(category);
    diff.V_DIFF.raw = static_cast<std::uint8_t>(V);
    EXPECT_TRUE(p.diffs.push_back(diff));
  };
  append(0, 10, 22);
  append(0, 0, 21);
  append(1, 2, 23);
  append(2, 0, 24);
  const StaticSpeed element = contents_of(p).ssp->steps[0].value;
  EXPECT_EQ(element.V_STATIC, 20);
  EXPECT_TRUE(element.Q_FRONT);
  EXPECT_EQ(element.cd[10], 22);
  EXPECT_EQ(element.cd[0], 21);
  EXPECT_EQ(element.other[2], 23);
  EXPECT_EQ(element.other[0], 24);
  EXPECT_EQ(element.replaces_cd, 0b100);
  p.Q_FRONT.raw = 0;
  EXPECT_FALSE(contents_of(p).ssp->steps[0].value.Q_FRONT);
}

TEST(PacketFields, Axle_load_51) {
  auto p = packet_in_metres<lang::Packet51>();
  p.D_AXLELOAD.raw = 10;
  p.L_AXLELOAD.raw = 5;
  p.Q_FRONT.raw = 1;
  lang::Packet51_categories category;
  category.M_AXLELOADCAT.raw = 12;
  category.V_AXLELOAD.raw = 9;
  ASSERT_TRUE(p.categories.push_back(category));
  lang::Packet51_restrictions more;
  more.D_AXLELOAD.raw = 100;
  more.L_AXLELOAD.raw = 7;
  ASSERT_TRUE(p.restrictions.push_back(more));
  const Fresh<AxleLoadRestriction> fresh = *contents_of(p).asp;
  EXPECT_EQ(fresh.from, at(1010));
  EXPECT_EQ(fresh.elements[0].from, at(1010));
  EXPECT_EQ(fresh.elements[0].to, at(1015));
  EXPECT_TRUE(fresh.elements[0].Q_FRONT);
  EXPECT_EQ(fresh.elements[0].V_AXLELOAD[12], 9);
  EXPECT_EQ(fresh.elements[1].from, at(1110));
  EXPECT_EQ(fresh.elements[1].to, at(1117));
  EXPECT_FALSE(fresh.elements[1].Q_FRONT);
  auto init = packet_in_metres<lang::Packet51>();
  init.Q_TRACKINIT.raw = 1;
  init.D_TRACKINIT.raw = 7;
  EXPECT_TRUE(contents_of(init).asp->initial_state);
  EXPECT_EQ(contents_of(init).asp->from, at(1007));
}

TEST(PacketFields, Permitted_braking_distance_52) {
  auto p = packet_in_metres<lang::Packet52>();
  p.D_PBDSR.raw = 10;
  p.L_PBDSR.raw = 5;
  p.D_PBD.raw = 900;
  p.Q_GDIR.raw = 1;
  p.G_PBDSR.raw = 3;
  p.Q_PBDSR.raw = 1;
  lang::Packet52_restrictions more;
  more.D_PBDSR.raw = 100;
  more.L_PBDSR.raw = 7;
  more.G_PBDSR.raw = 4;
  ASSERT_TRUE(p.restrictions.push_back(more));
  const Fresh<PermittedBrakingDistance> fresh = *contents_of(p).pbd;
  EXPECT_EQ(fresh.from, at(1010));
  EXPECT_EQ(fresh.elements[0].from, at(1010));
  EXPECT_EQ(fresh.elements[0].to, at(1015));
  EXPECT_EQ(fresh.elements[0].D_PBD, Distance{900});
  EXPECT_EQ(fresh.elements[0].gradient_permille, 3);
  EXPECT_TRUE(fresh.elements[0].service_brake);
  EXPECT_EQ(fresh.elements[1].from, at(1110));
  EXPECT_EQ(fresh.elements[1].to, at(1117));
  EXPECT_EQ(fresh.elements[1].gradient_permille, -4);
  EXPECT_FALSE(fresh.elements[1].service_brake);
  auto init = packet_in_metres<lang::Packet52>();
  init.Q_TRACKINIT.raw = 1;
  init.D_TRACKINIT.raw = 7;
  EXPECT_EQ(contents_of(init).pbd->from, at(1007));
}

TEST(PacketFields, Temporary_speed_restriction_65) {
  auto p = packet_in_metres<lang::Packet65>();
  p.NID_TSR.raw = 9;
  p.D_TSR.raw = 10;
  p.L_TSR.raw = 5;
  p.Q_FRONT.raw = 1;
  p.V_TSR.raw = 8;
  const Contents c = contents_of(p);
  EXPECT_EQ(c.tsr[0].NID_TSR, 9);
  EXPECT_EQ(c.tsr[0].from, at(1010));
  EXPECT_EQ(c.tsr[0].to, at(1015));
  EXPECT_TRUE(c.tsr[0].Q_FRONT);
  EXPECT_EQ(c.tsr[0].V_TSR, 8);
  EXPECT_TRUE(c.lost.empty());
  p.Q_FRONT.raw = 0;
  EXPECT_FALSE(contents_of(p).tsr[0].Q_FRONT);
}

TEST(PacketFields, Level_crossing_88) {
  auto p = packet_in_metres<lang::Packet88>();
  p.NID_LX.raw = 5;
  p.D_LX.raw = 10;
  p.L_LX.raw = 20;
  p.Q_LXSTATUS.raw = 1;
  p.V_LX.raw = 4;
  p.Q_STOPLX.raw = 1;
  p.L_STOPLX.raw = 50;
  const LevelCrossing lx = contents_of(p).lx[0];
  EXPECT_EQ(lx.NID_LX, 5);
  EXPECT_EQ(lx.from, at(1010));
  EXPECT_EQ(lx.to, at(1030));
  EXPECT_TRUE(lx.unprotected && lx.stop_required);
  EXPECT_EQ(lx.V_LX, 4);
  EXPECT_EQ(lx.L_STOPLX, Distance{50});
}

TEST(PacketFields, Mode_profile_80) {
  auto p = packet_in_metres<lang::Packet80>();
  p.D_MAMODE.raw = 10;
  p.L_MAMODE.raw = 100;
  p.V_MAMODE.raw = 120;
  p.L_ACKMAMODE.raw = 5;
  p.Q_MAMODE.raw = 1;
  lang::Packet80_modes more;
  more.D_MAMODE.raw = 200;
  more.V_MAMODE.raw = 127;
  ASSERT_TRUE(p.modes.push_back(more));
  const ModeProfile profile = *contents_of(p).mode_profile;
  EXPECT_EQ(profile[0].from, at(1010));
  EXPECT_EQ(profile[0].to, at(1110));
  EXPECT_EQ(profile[0].V_MAMODE, 120);
  EXPECT_EQ(profile[0].ack_from, at(1005));
  EXPECT_TRUE(profile[0].also_SvL);
  EXPECT_EQ(profile[1].V_MAMODE, kNoSpeed) << "the national value";
  EXPECT_FALSE(profile[1].also_SvL);
}

TEST(PacketFields, Conditions_of_the_track) {
  auto platform = packet_in_metres<lang::Packet69>();
  platform.D_TRACKCOND.raw = 10;
  platform.L_TRACKCOND.raw = 200;
  platform.M_PLATFORM.raw = 3;
  platform.Q_PLATFORM.raw = 2;
  const Platform there = contents_of(platform).platforms->elements[0];
  EXPECT_EQ(there, (Platform{at(1010), at(1210), 3, 2}));
  auto traction = packet_in_metres<lang::Packet39>();
  traction.M_VOLTAGE.raw = 1;
  EXPECT_EQ(contents_of(traction).traction->M_VOLTAGE, 1);
  auto current = packet_in_metres<lang::Packet40>();
  current.D_CURRENT.raw = 15;
  current.M_CURRENT.raw = 1000;  // the largest of 7.5.1.62
  EXPECT_EQ(contents_of(current).current->at, at(1015));
  EXPECT_EQ(contents_of(current).current->amperes, 10000);
  auto adhesion = packet_in_metres<lang::Packet71>();
  adhesion.D_ADHESION.raw = 10;
  adhesion.L_ADHESION.raw = 80;
  adhesion.M_ADHESION.raw = 1;
  EXPECT_EQ(*contents_of(adhesion).adhesion, (AdhesionArea{at(1010), at(1090), false}));
}

TEST(PacketFields, Route_suitability_70) {
  auto p = packet_in_metres<lang::Packet70>();
  p.D_SUITABILITY.raw = 100;
  p.Q_SUITABILITY.raw = 1;
  p.M_AXLELOADCAT.raw = 5;
  lang::Packet70_points point;
  point.D_SUITABILITY.raw = 50;
  point.Q_SUITABILITY.raw = 2;
  point.M_VOLTAGE.raw = 1;
  point.NID_CTRACTION.raw = 12;
  ASSERT_TRUE(p.points.push_back(point));
  point.Q_SUITABILITY.raw = 0;
  point.M_LINEGAUGE.raw = 4;
  ASSERT_TRUE(p.points.push_back(point));
  const Fresh<RouteSuitability> fresh = *contents_of(p).suitability;
  EXPECT_EQ(fresh.from, at(1100));
  ASSERT_EQ(fresh.elements.size(), 3u);
  EXPECT_EQ(fresh.elements[0].kind, Suitability::axle_load);
  EXPECT_EQ(fresh.elements[0].M_LINEAXLELOADCAT, 0b11'1111);
  EXPECT_EQ(fresh.elements[1].kind, Suitability::traction);
  EXPECT_EQ(fresh.elements[1].M_VOLTAGE, 1);
  EXPECT_EQ(fresh.elements[1].NID_CTRACTION, 12);
  EXPECT_EQ(fresh.elements[2].kind, Suitability::gauge);
  EXPECT_EQ(fresh.elements[2].M_LINEGAUGE, 4);
}

template <class P>
void expect_text_fields() {
  auto p = packet_in_metres<P>();
  p.Q_TEXTCLASS.raw = 1;
  p.Q_TEXTDISPLAY.raw = 1;
  p.D_TEXTDISPLAY.raw = 100;
  p.M_MODETEXTDISPLAY_START.raw = 1;
  p.M_LEVELTEXTDISPLAY_START.raw = 3;
  p.L_TEXTDISPLAY.raw = 50;
  p.T_TEXTDISPLAY.raw = 8;
  p.M_MODETEXTDISPLAY_END.raw = 2;
  p.M_LEVELTEXTDISPLAY_END.raw = 1;
  p.NID_NTC_END.raw = 6;
  p.Q_TEXTCONFIRM.raw = 1;
  p.Q_CONFTEXTDISPLAY.raw = 1;
  p.Q_TEXTREPORT.raw = 1;
  p.NID_TEXTMESSAGE.raw = 77;
  p.NID_C.raw = 12;
  p.NID_RBC.raw = 5;
  Text t = contents_of(p).texts[0];
  EXPECT_EQ(t.Q_TEXTCLASS, 1);
  EXPECT_TRUE(t.all_parts);
  EXPECT_EQ(t.start_at, at(1100));
  EXPECT_EQ(t.start_mode, Mode::OS);
  EXPECT_EQ(t.start_level, Level::L2);
  EXPECT_EQ(t.end_at, at(1150));
  EXPECT_EQ(t.T_TEXTDISPLAY, Duration{8});
  EXPECT_EQ(t.end_mode, Mode::SR);
  EXPECT_EQ(t.end_level, Level::NTC);
  EXPECT_EQ(t.end_NTC, 6);
  EXPECT_EQ(t.Q_TEXTCONFIRM, 1);
  EXPECT_TRUE(t.ack_and_end && t.report);
  EXPECT_EQ(t.NID_TEXTMESSAGE, 77);
  EXPECT_EQ(t.NID_C, 12);
  EXPECT_EQ(t.NID_RBC, 5);
  p.Q_TEXTDISPLAY.raw = p.Q_CONFTEXTDISPLAY.raw = p.Q_TEXTREPORT.raw = 0;
  t = contents_of(p).texts[0];
  EXPECT_FALSE(t.all_parts || t.ack_and_end || t.report);
  // Room for two in a message; a third one is named as lost.
  Contents c;
  p.Q_DIR.raw = 1;
  const Written written(p);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(c.lost.size(), 0u);
    EXPECT_EQ(add(c, written.view, reference()), Added::added);
  }
  ASSERT_EQ(c.lost.size(), 1u);
  EXPECT_EQ(c.lost[0], P::info.NID_PACKET);
}

TEST(PacketFields, Plain_text_72) { expect_text_fields<lang::Packet72>(); }
TEST(PacketFields, Fixed_text_76) { expect_text_fields<lang::Packet76>(); }

TEST(PacketFields, Geographical_position_79) {  // 3.6.6
  auto p = packet_in_metres<lang::Packet79>();
  p.Q_DIR.raw = 2;
  p.NID_BG.raw = 8;
  p.Q_MPOSITION.raw = 1;
  p.M_POSITION.raw = 9999999;
  const Written written(p);
  for (const Direction orientation : {Direction::nominal, Direction::reverse}) {
    Contents c;
    Reference r = reference();
    r.orientation = orientation;
    EXPECT_EQ(add(c, written.view, r), Added::added);
    EXPECT_TRUE((*c.geo)[0].counts_up);  // in the nominal direction of group 8, whatever that of the sender
    EXPECT_EQ((*c.geo)[0].M_POSITION, 9999999u);
    EXPECT_EQ((*c.geo)[0].group, (GroupId{426, 8}));
  }
}

TEST(PacketFields, Radio_infill_133_and_the_other_orders) {
  auto p = packet_in_metres<lang::Packet133>();
  p.Q_RIU.raw = 1;
  p.NID_C_RIU.raw = 12;
  p.NID_RIU.raw = 34;
  p.NID_RADIO.raw = 0x123456789abcdef0;
  p.D_INFILL.raw = 10;
  p.NID_C.raw = 5;
  p.NID_BG.raw = 6;
  const RadioInfillArea area = *contents_of(p).radio_infill;
  EXPECT_EQ(area, (RadioInfillArea{at(1010), true, 12, 34, 0x123456789abcdef0, {5, 6}}));
  p.Q_RIU.raw = 0;
  EXPECT_FALSE(contents_of(p).radio_infill->establish);
  auto rbc = packet_in_metres<lang::Packet131>();
  rbc.D_RBCTR.raw = 900;
  rbc.NID_C.raw = 12;
  rbc.NID_RBC.raw = 3;
  rbc.NID_RADIO.raw = 0x123456789abcdef0;
  EXPECT_EQ(*contents_of(rbc).rbc_transition, (RbcTransition{at(1900), 12, 3, 0x123456789abcdef0, false}));
  lang::Packet90 free;
  free.Q_NEWCOUNTRY.raw = 1;
  free.NID_C.raw = 5;
  free.NID_BG.raw = 99;
  EXPECT_EQ(contents_of(free).track_ahead_free_to, (GroupId{5, 99}));
  auto reversing = packet_in_metres<lang::Packet138>();
  reversing.D_STARTREVERSE.raw = 10;
  reversing.L_REVERSEAREA.raw = 20;
  EXPECT_EQ(*contents_of(reversing).reversing_area, (ReversingArea{at(1010), at(1030)}));
  auto supervision = packet_in_metres<lang::Packet139>();
  supervision.D_REVERSE.raw = 300;
  supervision.V_REVERSE.raw = 4;
  EXPECT_EQ(*contents_of(supervision).reversing_supervision, (ReversingSupervision{Distance{300}, 4}));
}

TEST(PacketFields, A_packet_that_cannot_be_read_is_faulty_and_one_of_another_version_is_not_stored) {
  auto p = packet_in_metres<lang::Packet65>();
  p.Q_DIR.raw = 1;
  for (const std::uint16_t id : {std::uint16_t{65}, std::uint16_t{68}, std::uint16_t{79}}) {
    Written broken(p);
    broken.view.NID_PACKET = id;
    broken.view.bytes = std::span<const std::uint8_t>(broken.bytes).first(4);
    Contents c;
    EXPECT_EQ(add(c, broken.view, reference()), Added::faulty) << id;
  }
}

}  // namespace
}  // namespace evc::track
