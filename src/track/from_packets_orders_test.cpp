#include "lang/packets/packet_131.h"
#include "lang/packets/packet_132.h"
#include "lang/packets/packet_133.h"
#include "lang/packets/packet_135.h"
#include "lang/packets/packet_137.h"
#include "lang/packets/packet_138.h"
#include "lang/packets/packet_139.h"
#include "lang/packets/packet_181.h"
#include "lang/packets/packet_39.h"
#include "lang/packets/packet_40.h"
#include "lang/packets/packet_49.h"
#include "lang/packets/packet_63.h"
#include "lang/packets/packet_67.h"
#include "lang/packets/packet_68.h"
#include "lang/packets/packet_69.h"
#include "lang/packets/packet_70.h"
#include "lang/packets/packet_71.h"
#include "lang/packets/packet_72.h"
#include "lang/packets/packet_76.h"
#include "lang/packets/packet_79.h"
#include "lang/packets/packet_90.h"
#include "track/from_packets_testing.h"

namespace evc::track {
namespace {

using namespace testing;

TEST(FromPackets, Conditions) {
  auto p = packet_in_metres<lang::Packet68>();
  p.D_TRACKCOND.raw = 100;
  p.L_TRACKCOND.raw = 50;
  p.M_TRACKCOND.raw = 4;
  lang::Packet68_conditions more;
  more.D_TRACKCOND.raw = 10;
  more.L_TRACKCOND.raw = 5;
  more.M_TRACKCOND.raw = 2;
  ASSERT_TRUE(p.conditions.push_back(more));
  const auto conditions = *contents_of(p).conditions;
  EXPECT_EQ(conditions.from, at(1100));
  EXPECT_EQ(conditions.elements[0].kind, TrackConditionKind::radio_hole);
  EXPECT_EQ(conditions.elements[0].to, at(1150));
  EXPECT_EQ(conditions.elements[1].from, at(1110));
  auto init = packet_in_metres<lang::Packet68>();
  init.Q_TRACKINIT.raw = 1;
  init.D_TRACKINIT.raw = 7;
  EXPECT_TRUE(contents_of(init).conditions->initial_state);
  EXPECT_EQ(contents_of(init).conditions->from, at(1007));

  auto metal = packet_in_metres<lang::Packet67>();
  metal.L_TRACKCOND.raw = 12;
  EXPECT_EQ(contents_of(metal).big_metal->elements[0].to, at(1012));
  auto platform = packet_in_metres<lang::Packet69>();
  platform.L_TRACKCOND.raw = 200;
  platform.M_PLATFORM.raw = 3;
  platform.Q_PLATFORM.raw = 2;
  EXPECT_EQ(contents_of(platform).platforms->elements[0].M_PLATFORM, 3);
  platform.Q_TRACKINIT.raw = 1;
  EXPECT_TRUE(contents_of(platform).platforms->initial_state);
  auto traction = packet_in_metres<lang::Packet39>();
  traction.D_TRACTION.raw = 40;
  traction.M_VOLTAGE.raw = 1;
  traction.NID_CTRACTION.raw = 12;
  EXPECT_EQ(contents_of(traction).traction->at, at(1040));
  EXPECT_EQ(contents_of(traction).traction->NID_CTRACTION, 12);
  auto current = packet_in_metres<lang::Packet40>();
  current.M_CURRENT.raw = 50;
  EXPECT_EQ(contents_of(current).current->amperes, 500);
  current.M_CURRENT.raw = 1023;
  EXPECT_FALSE(contents_of(current).current->amperes);
  auto adhesion = packet_in_metres<lang::Packet71>();
  adhesion.L_ADHESION.raw = 80;
  EXPECT_TRUE(contents_of(adhesion).adhesion->slippery);
  EXPECT_EQ(contents_of(adhesion).adhesion->to, at(1080));
}

TEST(FromPackets, Suitability) {
  auto p = packet_in_metres<lang::Packet70>();
  p.D_SUITABILITY.raw = 100;
  p.M_LINEGAUGE.raw = 3;
  lang::Packet70_points point;
  point.D_SUITABILITY.raw = 50;
  point.Q_SUITABILITY.raw = 2;
  point.M_VOLTAGE.raw = 1;
  point.NID_CTRACTION.raw = 12;
  ASSERT_TRUE(p.points.push_back(point));
  const auto items = *contents_of(p).suitability;
  EXPECT_EQ(items.elements[0].kind, Suitability::gauge);
  EXPECT_EQ(items.elements[0].M_LINEGAUGE, 3);
  EXPECT_EQ(items.elements[1].at, at(1150));
  EXPECT_EQ(items.elements[1].NID_CTRACTION, 12);
  auto init = packet_in_metres<lang::Packet70>();
  init.Q_TRACKINIT.raw = 1;
  EXPECT_TRUE(contents_of(init).suitability->initial_state);
}

TEST(FromPackets, Texts) {
  auto p = packet_in_metres<lang::Packet72>();
  p.D_TEXTDISPLAY.raw = 100;
  p.M_MODETEXTDISPLAY_START.raw = 15;
  p.M_LEVELTEXTDISPLAY_START.raw = 1;
  p.NID_NTC_START.raw = 6;
  p.L_TEXTDISPLAY.raw = 50;
  p.T_TEXTDISPLAY.raw = 1023;
  p.M_MODETEXTDISPLAY_END.raw = 0;
  p.M_LEVELTEXTDISPLAY_END.raw = 5;
  p.Q_TEXTCONFIRM.raw = 2;
  p.Q_CONFTEXTDISPLAY.raw = 1;
  p.Q_TEXTREPORT.raw = 1;
  p.NID_TEXTMESSAGE.raw = 77;
  p.NID_RBC.raw = 5;
  for (const char c : {'H', 'i'}) {
    lang::Packet72_text x;
    x.X_TEXT.raw = static_cast<std::uint8_t>(c);
    ASSERT_TRUE(p.text.push_back(x));
  }
  const Text t = contents_of(p).texts[0];
  EXPECT_EQ(t.start_at, at(1100));
  EXPECT_EQ(t.end_at, at(1150));
  EXPECT_FALSE(t.start_mode || t.end_level || t.T_TEXTDISPLAY);
  EXPECT_EQ(t.start_level, Level::NTC);
  EXPECT_EQ(t.start_NTC, 6);
  EXPECT_EQ(t.end_mode, Mode::FS);
  EXPECT_TRUE(t.ack_and_end && t.report);
  EXPECT_EQ(t.NID_TEXTMESSAGE, 77);
  EXPECT_EQ(std::string_view(t.characters.data(), t.length), "Hi");
  auto f = packet_in_metres<lang::Packet76>();
  f.D_TEXTDISPLAY.raw = 32767;
  f.M_MODETEXTDISPLAY_START.raw = f.M_MODETEXTDISPLAY_END.raw = 15;
  f.M_LEVELTEXTDISPLAY_START.raw = f.M_LEVELTEXTDISPLAY_END.raw = 5;
  f.L_TEXTDISPLAY.raw = 30;
  f.T_TEXTDISPLAY.raw = 20;
  f.Q_TEXT.raw = 1;
  const Text fixed = contents_of(f).texts[0];
  EXPECT_EQ(fixed.Q_TEXT, 1);
  EXPECT_EQ(fixed.end_at, at(1030));
  EXPECT_EQ(fixed.T_TEXTDISPLAY, Duration{20});
}

TEST(FromPackets, ListsOfGroups) {
  lang::Packet49 p;
  lang::Packet49_groups g;
  g.NID_BG.raw = 1;
  ASSERT_TRUE(p.groups.push_back(g));
  g.Q_NEWCOUNTRY.raw = 1;
  g.NID_C.raw = 12;
  g.NID_BG.raw = 2;
  ASSERT_TRUE(p.groups.push_back(g));
  g.Q_NEWCOUNTRY.raw = 0;
  g.NID_BG.raw = 3;
  ASSERT_TRUE(p.groups.push_back(g));
  const GroupList list = *contents_of(p).sh_list;
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[0], (GroupId{426, 1}));
  EXPECT_EQ(list[1], (GroupId{12, 2}));
  EXPECT_EQ(list[2], (GroupId{12, 3})) << "as the group before";
}

TEST(FromPackets, ListForStaffResponsible) {
  lang::Packet63 p;
  p.Q_DIR.raw = 1;
  EXPECT_TRUE(sr_list(Written(p).view, reference())->empty());
  lang::Packet63_groups g;
  g.NID_BG.raw = 5;
  ASSERT_TRUE(p.groups.push_back(g));
  EXPECT_EQ((*sr_list(Written(p).view, reference()))[0], (GroupId{426, 5}));
  Contents c;
  EXPECT_EQ(add(c, Written(p).view, reference()), Added::not_stored_here) << "it comes with message 2 only";
  Written broken(p);
  broken.view.bytes = std::span<const std::uint8_t>(broken.bytes).first(4);
  EXPECT_FALSE(sr_list(broken.view, reference()));
  p.Q_DIR.raw = 0;
  EXPECT_FALSE(sr_list(Written(p).view, reference())) << "3.6.3.1.3";
}

TEST(FromPackets, GeographicalPosition) {
  auto p = packet_in_metres<lang::Packet79>();
  p.NID_BG.raw = 7;
  p.D_POSOFF.raw = 20;
  p.Q_MPOSITION.raw = 1;
  p.M_POSITION.raw = 12345;
  lang::Packet79_references r;
  r.Q_NEWCOUNTRY.raw = 1;
  r.NID_C.raw = 5;
  r.NID_BG.raw = 8;
  r.M_POSITION.raw = 16777215;
  ASSERT_TRUE(p.references.push_back(r));
  const auto geo = *contents_of(p).geo;
  EXPECT_EQ(geo[0].applies_from, at(1020)) << "the sender itself";
  EXPECT_TRUE(geo[0].counts_up);
  EXPECT_EQ(geo[0].M_POSITION, 12345u);
  EXPECT_EQ(geo[1].group, (GroupId{5, 8}));
  EXPECT_FALSE(geo[1].M_POSITION || geo[1].applies_from);
}

TEST(FromPackets, GeographicalPositionCountsUpOrDown) {  // 7.5.1.116, 3.6.6.10: in the nominal direction of the group
  for (const std::uint8_t up : {std::uint8_t{0}, std::uint8_t{1}}) {
    auto p = packet_in_metres<lang::Packet79>();
    p.Q_DIR.raw = 2;
    p.NID_BG.raw = 7;
    p.Q_MPOSITION.raw = up;
    lang::Packet79_references next;
    next.NID_BG.raw = 8;
    next.Q_MPOSITION.raw = up;
    ASSERT_TRUE(p.references.push_back(next));
    const Written written(p);
    for (const Direction orientation : {Direction::nominal, Direction::reverse}) {
      Reference r = reference();
      r.orientation = orientation;
      Contents c;
      ASSERT_EQ(add(c, written.view, r), Added::added);
      EXPECT_EQ((*c.geo)[0].counts_up, up == 1);
      EXPECT_EQ((*c.geo)[0].counts_up_ahead, (up == 1) == (orientation == Direction::nominal));
      EXPECT_EQ((*c.geo)[1].counts_up, up == 1);
    }
  }
}

TEST(FromPackets, PlacesOfAnInfillCountFromItsReferenceAndCountriesFromTheSender) {  // 3.6.2.3.1, 7.5.1.121
  auto p = packet_in_metres<lang::Packet79>();
  p.Q_DIR.raw = 1;
  p.NID_BG.raw = 8;
  p.D_POSOFF.raw = 20;
  Reference r = reference();
  const std::uint16_t NID_C = r.group.NID_C;
  r.infill = GroupId{NID_C, 8};
  Contents c;
  ASSERT_EQ(add(c, Written(p).view, r), Added::added);
  EXPECT_EQ((*c.geo)[0].applies_from, at(1020));
  r.infill = GroupId{static_cast<std::uint16_t>(NID_C + 1), 8};
  ASSERT_EQ(add(c, Written(p).view, r), Added::added);
  EXPECT_EQ((*c.geo)[0].group, (GroupId{NID_C, 8}));
  EXPECT_FALSE((*c.geo)[0].applies_from) << "another group";
}

TEST(FromPackets, OrdersThatActAtOnce) {
  lang::Packet137 sr;
  EXPECT_EQ(contents_of(sr).stop_if_in_sr, true);
  sr.Q_SRSTOP.raw = 1;
  EXPECT_EQ(contents_of(sr).stop_if_in_sr, false);
  lang::Packet132 sh;
  EXPECT_EQ(contents_of(sh).danger_for_shunting, true);
  lang::Packet90 taf;
  taf.NID_BG.raw = 99;
  EXPECT_EQ(contents_of(taf).track_ahead_free_to, (GroupId{426, 99}));
  EXPECT_TRUE(contents_of(lang::Packet135{}).stop_shunting_on_desk_opening);
  EXPECT_TRUE(contents_of(lang::Packet181{}).generic_ls_marker);
}

TEST(FromPackets, TransitionsAndReversing) {
  auto rbc = packet_in_metres<lang::Packet131>();
  rbc.D_RBCTR.raw = 900;
  rbc.NID_RBC.raw = 3;
  rbc.Q_SLEEPSESSION.raw = 1;
  EXPECT_EQ(contents_of(rbc).rbc_transition->at, at(1900));
  EXPECT_TRUE(contents_of(rbc).rbc_transition->sleeping_too);
  auto riu = packet_in_metres<lang::Packet133>();
  riu.Q_RIU.raw = 1;
  riu.D_INFILL.raw = 10;
  riu.NID_C.raw = 4;
  riu.NID_BG.raw = 6;
  EXPECT_EQ(contents_of(riu).radio_infill->next_main_signal, (GroupId{4, 6}));
  auto area = packet_in_metres<lang::Packet138>();
  area.D_STARTREVERSE.raw = 100;
  area.L_REVERSEAREA.raw = 200;
  EXPECT_EQ(contents_of(area).reversing_area->to, at(1300));
  auto reverse = packet_in_metres<lang::Packet139>();
  reverse.D_REVERSE.raw = 32767;
  reverse.V_REVERSE.raw = 6;
  EXPECT_FALSE(contents_of(reverse).reversing_supervision->D_REVERSE);
  EXPECT_EQ(contents_of(reverse).reversing_supervision->V_REVERSE, 6);
}

}  // namespace
}  // namespace evc::track
