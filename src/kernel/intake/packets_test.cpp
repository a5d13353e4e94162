#include <gtest/gtest.h>

#include "kernel/intake/national_values.h"
#include "kernel/intake/test_message.h"
#include "lang/packets/packet_131.h"
#include "lang/packets/packet_140.h"
#include "lang/packets/packet_16.h"
#include "lang/packets/packet_180.h"
#include "lang/packets/packet_203.h"
#include "lang/packets/packet_3.h"
#include "lang/packets/packet_39.h"
#include "lang/packets/packet_42.h"
#include "lang/packets/packet_57.h"
#include "lang/packets/packet_58.h"
#include "lang/packets/packet_6.h"
#include "lang/packets/packet_70.h"
#include "lang/packets/packet_76.h"

// What the packets do that are not stored with the track description (7.4.2).
namespace evc::kernel {
namespace {

using test::at;

class Taken : public test::OneMessage {
 protected:
  template <class P>
  void receive(P packet) {
    information.packets.clear();
    add(packet);
    evaluate_now();
  }
};

TEST_F(Taken, RepositioningOfAnAnnouncedGroupOnly) {  // 3.8.5.2.2
  state.level.level = Level::L1;
  information.medium = Medium::balise;
  ASSERT_TRUE(state.track.ma.emplace().sections.push_back({at(950.0), at(3000.0)}));
  ASSERT_TRUE(state.track.ssp.append(at(0.0), {.V_STATIC = 20}));
  ASSERT_TRUE(state.track.gradient.append(at(0.0), {0}));
  lang::Packet16 p;
  p.Q_SCALE.raw = 1;
  p.L_SECTION.raw = 1500;
  receive(p);
  EXPECT_EQ(state.track.ma->end(), at(3000.0));
  EXPECT_EQ(told(16).what, What::packet_refused);
  EXPECT_EQ(told(16).clause, "3.8.5.2.2"_srs);
  information.repositioning = true;
  receive(p);
  EXPECT_EQ(state.track.ma->end(), at(2450.0));
  EXPECT_EQ(told(16).what, What::packet_accepted);
  information.repositioning = false;
  information.medium = Medium::rbc;  // as no RBC does (8.4.4)
  set_message(lang::Message24{});
  receive(p);
  EXPECT_TRUE(happened(What::message_refused));
}

TEST_F(Taken, APacketOfOtherVersionsIsToldAsNotUsed) {  // 6.6.3.1.1.1
  lang::Packet76 p;
  add(p);
  evaluate_now();
  EXPECT_EQ(told(76).what, What::packet_accepted);
  information.packets[0].sv = {1, 1};
  evaluate_now();
  expect(76, What::packet_not_used);
  EXPECT_EQ(told(76).clause, "6.6.3.1.1.1"_srs);
}

TEST_F(Taken, APacketOfX1WithoutATranslationIsToldAsNotUsed) {  // 6.6.3.2.3 [10], [12], [13]
  const auto expect_not_used = [&](const auto& used, const auto& passed_over) {
    for (const bool not_used : {false, true}) {
      information.packets.clear();
      not_used ? add(passed_over) : add(used);
      information.packets[0].sv = {1, 0};
      evaluate_now();
      const auto number = used.info.NID_PACKET;
      EXPECT_EQ(told(number).what, not_used ? What::packet_not_used : What::packet_accepted) << int{number};
      EXPECT_EQ(told(number).clause, not_used ? "6.6.3.2.3"_srs : Clause{}) << int{number};
    }
  };
  lang::Packet39_v1_0 traction;
  lang::Packet70_v1_0 suitability;
  suitability.Q_SUITABILITY.raw = 2;
  lang::Packet140_v1_0 number;
  const auto known_traction = traction;
  const auto known_suitability = suitability;
  traction.M_TRACTION.raw = suitability.M_TRACTION.raw = 4;
  expect_not_used(known_traction, traction);
  expect_not_used(known_suitability, suitability);
  information.medium = Medium::rbc;
  const auto known_number = number;
  number.NID_OPERATIONAL.raw = 0xFFFFFFFF;
  expect_not_used(known_number, number);
}

TEST_F(Taken, Packet203WithoutItsPacket3IsToldAsNotUsed) {  // 6.6.3.2.3 [16]
  for (const std::uint8_t X : {std::uint8_t{0}, std::uint8_t{1}, std::uint8_t{2}}) {
    information.packets.clear();
    add(lang::Packet203{});
    information.packets[0].sv = {1, 1};
    if (X == 1) add(lang::Packet3_v1_0{});
    if (X == 2) add(lang::Packet3{});
    if (X != 0) information.packets[1].sv = {X, 1};
    evaluate_now();
    EXPECT_EQ(told(203).what, X == 1 ? What::packet_accepted : What::packet_not_used) << int{X};
    EXPECT_EQ(told(203).clause, X == 1 ? Clause{} : "6.6.3.2.3"_srs) << int{X};
  }
}

TEST_F(Taken, NationalValuesOfX1LeaveWhatTheyDoNotContain) {  // 6.6.3.2.3 [1a], [1b], [2]
  const train::NationalValues defaults;
  for (const std::uint8_t operated : {std::uint8_t{1}, std::uint8_t{2}}) {
    state.operated_X = operated;
    state.national_values.Q_NVLOCACC = {33.0};
    state.national_values.M_NVEBCL = 3;
    lang::Packet3_v1_0 p;
    p.V_NVSTFF.raw = 5;
    EXPECT_TRUE(p.areas.push_back({lang::var::NID_C{1}}));
    information.packets.clear();
    add(p);
    information.packets[0].sv = {1, 1};
    evaluate_now();
    EXPECT_FALSE(happened(What::national_values_in_force)) << "D_VALIDNV of X = 1 is a distance";
    ASSERT_TRUE(state.pending_national_values.has_value());
    use_national_values(state, state.pending_national_values->set);
    EXPECT_EQ(state.national_values.V_NVSTFF, Speed{25.0 / 3.6});
    EXPECT_EQ(state.national_values.Q_NVLOCACC, operated == 1 ? defaults.Q_NVLOCACC : Distance{33.0});
    EXPECT_EQ(state.national_values.M_NVEBCL, 3);
  }
}

TEST_F(Taken, NationalValuesAtOnceOrFromAPlaceOn) {  // 3.18.2.3, 3.18.2.9
  lang::Packet3 p;
  p.Q_SCALE.raw = 1;
  p.V_NVSHUNT.raw = 5;
  p.D_VALIDNV.raw = 500;
  receive(p);
  ASSERT_TRUE(state.pending_national_values.has_value());
  EXPECT_EQ(state.pending_national_values->from, at(1450.0));
  EXPECT_EQ(state.pending_national_values->set.values.V_NVSHUNT, Speed{25.0 / 3.6});
  EXPECT_FALSE(happened(What::national_values_in_force));
  EXPECT_NE(state.national_values.V_NVSHUNT, Speed{25.0 / 3.6});
  p.D_VALIDNV.raw = 32767;
  receive(p);
  EXPECT_TRUE(happened(What::national_values_in_force));
  EXPECT_EQ(state.national_values.V_NVSHUNT, Speed{25.0 / 3.6});
  EXPECT_FALSE(state.pending_national_values.has_value()) << "those of an older message";
}

TEST_F(Taken, OrdersForASession) {  // 3.5.3.5
  lang::Packet42 p;
  p.Q_RBC.raw = 1;
  p.NID_C.raw = 3;
  p.NID_RBC.raw = 77;
  const auto ordered = [&](Mode mode, std::uint8_t Q_SLEEPSESSION) {
    state.mode = mode;
    state.radio = {};
    outbox = {};
    received.termination_ordered = false;
    p.Q_SLEEPSESSION.raw = Q_SLEEPSESSION;
    receive(p);
    EXPECT_EQ(happened(What::session_ordered), state.radio.supervising.session.phase == radio::Phase::connecting);
    return happened(What::session_ordered);
  };
  EXPECT_TRUE(ordered(Mode::FS, 0));
  EXPECT_FALSE(received.termination_ordered);
  ASSERT_TRUE(outbox.connect.has_value());
  EXPECT_EQ(outbox.connect->NID_RBC, 77);
  EXPECT_FALSE(ordered(Mode::SL, 0)) << "not for a sleeping engine";
  EXPECT_TRUE(ordered(Mode::SL, 1));
}

TEST_F(Taken, InSHOnlyTheContactIsStored) {  // 4.8.4 [3]
  state.mode = Mode::SH;
  lang::Packet42 p;
  p.Q_RBC.raw = 1;
  p.NID_RBC.raw = 77;
  receive(p);
  EXPECT_EQ(told(42).what, What::packet_contact_stored);
  ASSERT_TRUE(state.radio.contact.has_value());
  EXPECT_EQ(state.radio.contact->NID_RBC, 77);
  EXPECT_EQ(state.radio.supervising.session.phase, radio::Phase::idle);
}

TEST_F(Taken, TheContactOfAnOrderIsValid) {  // 3.5.3.5, 5.4.3.3
  lang::Packet42 p;
  p.NID_C.raw = 3;
  p.NID_RBC.raw = 77;
  for (const bool establish : {true, false}) {
    state.radio = {};
    state.radio.supervising.session.phase = radio::Phase::up;
    state.radio.supervising.session.rbc = {3, 77, 0};
    state.contact_status = DataStatus::unknown;
    p.Q_RBC.raw = establish ? 1 : 0;
    receive(p);
    EXPECT_TRUE(happened(establish ? What::session_ordered : What::session_termination_ordered));
    EXPECT_EQ(state.contact_status, establish ? DataStatus::valid : DataStatus::unknown);
  }
}

/// Of a handover: the stored contact is that of the RBC that supervises.
TEST_F(Taken, AnRBCThatEndsTheLastKnownSessionMeansItsOwn) {  // 3.5.5.1, 3.15.1
  const auto ended = [&](SessionRole sender, std::uint8_t Q_RBC, std::uint16_t NID_RBC) {
    state.radio = {};
    state.radio.supervising.session.rbc = {1, 10, 0};
    state.radio.other.session.rbc = {1, 20, 0};
    state.radio.supervising.session.phase = state.radio.other.session.phase = radio::Phase::up;
    state.radio.contact = state.radio.supervising.session.rbc;
    information.sender = sender;
    lang::Packet42 p;
    p.Q_RBC.raw = Q_RBC;
    p.NID_C.raw = 1;
    p.NID_RBC.raw = NID_RBC;
    received.termination_ordered = false;
    receive(p);
    if (state.radio.supervising.session.phase == radio::Phase::terminating) return 10;
    return state.radio.other.session.phase == radio::Phase::terminating ? 20 : 0;
  };
  EXPECT_EQ(ended(SessionRole::accepting, 0, radio::kLastKnownRbc), 20);
  EXPECT_FALSE(received.termination_ordered) << "the session with the RBC that supervises goes on";
  EXPECT_EQ(ended(SessionRole::supervising, 0, radio::kLastKnownRbc), 10);
  EXPECT_TRUE(received.termination_ordered);
  EXPECT_EQ(ended(SessionRole::accepting, 0, 20), 20);
  EXPECT_EQ(ended(SessionRole::accepting, 0, 10), 10) << "as it is named";
  EXPECT_EQ(ended(SessionRole::accepting, 1, radio::kLastKnownRbc), 0);
}

TEST_F(Taken, OfARBCTransitionOrderInSHOnlyTheContactIsStored) {  // 4.8.4 [8]
  state.mode = Mode::SH;
  state.contact_status = DataStatus::unknown;
  information.medium = Medium::balise;
  lang::Packet131 p;
  p.NID_C.raw = 1;
  p.NID_RBC.raw = 77;
  receive(p);
  EXPECT_EQ(told(131).what, What::packet_contact_stored);
  ASSERT_TRUE(state.radio.contact.has_value());
  EXPECT_EQ(state.radio.contact->NID_RBC, 77);
  EXPECT_EQ(state.contact_status, DataStatus::valid);
  EXPECT_FALSE(state.track.rbc_transition.has_value());
  p.D_RBCTR.raw = 500;
  receive(p);
  EXPECT_EQ(told(131).what, What::packet_refused) << "only of an order that is executed at once";
}

TEST_F(Taken, TheTrainRunningNumberOfTheRBC) {  // 3.18.4.5.1
  lang::Packet140 p;
  p.NID_OPERATIONAL.raw = 0x4711;
  state.data.train_running_number_status = DataStatus::unknown;
  receive(p);
  EXPECT_EQ(state.data.train_running_number, 0x4711u);
  EXPECT_EQ(state.data.train_running_number_status, DataStatus::valid);
}

TEST_F(Taken, TheDelayOfAnOrderToShowTheLSSMA) {  // 4.4.19.1.4.2, 4.8.5.2
  state.mode = Mode::LS;
  state.level.level = Level::L1;
  state.now = {100.0};
  information.medium = Medium::balise;
  information.time = {90.0};
  lang::Packet180 p;
  p.Q_LSSMA.raw = 1;
  p.T_LSSMA.raw = 5;
  receive(p);
  ASSERT_TRUE(state.lssma.waiting.has_value());
  EXPECT_EQ(state.lssma.waiting->since, Duration{90.0}) << "from its reception on";
  EXPECT_EQ(state.lssma.waiting->delay, Duration{5.0});
  information.judge_packets = 1;  // it waited for a level transition
  receive(p);
  ASSERT_TRUE(state.lssma.waiting.has_value());
  EXPECT_EQ(state.lssma.waiting->since, Duration{100.0}) << "from the transition on";
}

TEST_F(Taken, TheOrderToEndTheSession) {  // 3.5.5.1
  state.radio.supervising.session.phase = radio::Phase::up;
  state.radio.supervising.session.rbc = {1, 77, 0};
  lang::Packet42 p;
  p.NID_C.raw = 1;
  p.NID_RBC.raw = 77;
  receive(p);
  EXPECT_TRUE(received.termination_ordered);
  EXPECT_TRUE(happened(What::session_termination_ordered));
  EXPECT_FALSE(happened(What::session_ordered));
  EXPECT_EQ(state.radio.supervising.session.phase, radio::Phase::terminating);
}

TEST_F(Taken, ParametersOfTheRequest) {  // 3.8.2.3, 7.4.2.12
  lang::Packet57 p;
  p.T_MAR.raw = 20;
  p.T_TIMEOUTRQST.raw = 30;
  p.T_CYCRQST.raw = 255;
  receive(p);
  EXPECT_EQ(state.radio.ma_request, (radio::MaRequestParameters{Duration{20.0}, Duration{30.0}, std::nullopt}));
}

TEST_F(Taken, ParametersOfThePositionReport) {  // 3.6.5.1.5, 7.4.2.13, 7.5.1.11
  lang::Packet58 p;
  p.Q_SCALE.raw = 1;
  p.T_CYCLOC.raw = 15;
  p.D_CYCLOC.raw = 400;
  p.M_LOC.raw = 1;
  for (const std::uint8_t Q_LGTLOC : {std::uint8_t{1}, std::uint8_t{0}}) {
    lang::Packet58_locations location;
    location.D_LOC.raw = 600;
    location.Q_LGTLOC.raw = Q_LGTLOC;
    ASSERT_TRUE(p.locations.push_back(location));
  }
  receive(p);
  ASSERT_TRUE(state.reports.parameters.has_value());
  const position::ReportParameters& r = *state.reports.parameters;
  EXPECT_EQ(r.T_CYCLOC, Duration{15.0});
  EXPECT_EQ(r.D_CYCLOC, Distance{400.0});
  EXPECT_EQ(r.M_LOC, 1);
  ASSERT_EQ(r.at.size(), 2u);
  EXPECT_EQ(r.at[0].place, at(1550.0));
  EXPECT_TRUE(r.at[0].front);
  EXPECT_EQ(r.at[1].place, at(2150.0));
  EXPECT_FALSE(r.at[1].front);
}

TEST_F(Taken, CoversOfVirtualBalises) {  // 3.15.9, 7.5.1.155.1
  information.medium = Medium::balise;
  state.now = {50.0};
  lang::Packet6 p;
  p.Q_VBCO.raw = 1;
  p.NID_VBCMK.raw = 7;
  p.NID_C.raw = 1;
  p.T_VBC.raw = 2;
  receive(p);
  ASSERT_EQ(state.balise.covers.size(), 1u);
  EXPECT_EQ(state.balise.covers[0].NID_VBCMK, 7);
  EXPECT_EQ(state.balise.covers[0].until, Duration{50.0 + 2.0 * 86400.0});
  EXPECT_FALSE(happened(What::cover_capacity));
  p.Q_VBCO.raw = 0;
  receive(p);
  EXPECT_TRUE(state.balise.covers.empty());
  p.Q_VBCO.raw = 1;
  for (std::uint8_t i = 0; i < balise::kCovers; ++i) {
    p.NID_VBCMK.raw = i;
    receive(p);
    EXPECT_FALSE(happened(What::cover_capacity));
  }
  p.NID_VBCMK.raw = balise::kCovers;
  receive(p);
  EXPECT_TRUE(happened(What::cover_capacity));
}

}  // namespace
}  // namespace evc::kernel
