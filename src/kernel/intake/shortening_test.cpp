#include "kernel/intake/shortening.h"

#include <gtest/gtest.h>

#include "kernel/basis.h"
#include "kernel/intake/test_message.h"
#include "lang/packets/packet_15.h"
#include "lang/packets/packet_80.h"

// A request to shorten the movement authority: granted where the train need not brake for it (3.8.6).
namespace evc::kernel {
namespace {

using test::at;

/// In FS at 1000 m with an authority to 5950 m, at 20 m/s, and linking at 2000 m and 5000 m.
class Shortening : public test::OneMessage {
 protected:
  Shortening() { restart(Mode::FS); }
  void restart(Mode mode) {
    state = State{};
    outbox.messages.clear();
    information.packets.clear();
    state.mode = mode;
    state.level.level = Level::L2;
    state.data.train_data_status = DataStatus::valid;
    EXPECT_TRUE(state.track.ma.emplace().sections.push_back({at(950.0), at(5950.0)}));
    EXPECT_TRUE(state.track.ssp.append(at(0.0), {.V_STATIC = 28}));
    EXPECT_TRUE(state.track.gradient.append(at(0.0), {0}));
    for (const double place : {2000.0, 5000.0}) {
      balise::Link link;
      link.place = at(place);
      EXPECT_TRUE(state.balise.linking.links.push_back(link));
    }
    state.position.now.V_est = state.position.now.V_min = state.position.now.V_max = {20.0};
    received.here.min_safe_rear = at(800.0);
    (void)renew_basis(state, in.train, received.here);
  }
  /// The answer to the request, 137 or 138.
  int answer_to(std::uint16_t L_ENDSECTION, std::optional<lang::Packet80> profile = {}) {
    lang::Packet15 p;
    p.Q_SCALE.raw = 1;
    p.L_ENDSECTION.raw = L_ENDSECTION;
    p.T_EMA.raw = 1023;
    add(p);
    if (profile) add(*profile);
    lang::Message9 m;
    m.T_TRAIN.raw = 4711;
    set_message(m);
    evaluate_now();
    if (outbox.messages.size() != 1) return 0;
    EXPECT_EQ(outbox.messages[0].T_TRAIN_REF, 4711u);
    const int answer = outbox.messages[0].NID_MESSAGE;
    EXPECT_EQ(happened(What::shortening_granted), answer == 137);
    EXPECT_EQ(happened(What::shortening_rejected), answer == 138);
    return answer;
  }
  static lang::Packet80 on_sight_in(std::uint16_t D_MAMODE) {
    lang::Packet80 p;
    p.Q_SCALE.raw = 1;
    p.D_MAMODE.raw = D_MAMODE;
    p.L_MAMODE.raw = 500;
    p.V_MAMODE.raw = 6;
    return p;
  }
};

TEST_F(Shortening, IsGrantedFarAhead) {  // 3.8.6.2, A.3.4 f
  EXPECT_EQ(answer_to(3000), 137);
  EXPECT_TRUE(happened(What::message_accepted));
  EXPECT_EQ(state.track.ma->end(), at(3950.0));
  ASSERT_EQ(state.balise.linking.links.size(), 1u);
  EXPECT_EQ(state.balise.linking.links[0].place, at(2000.0));
}

TEST_F(Shortening, IsRejectedWhereTheTrainWouldHaveToBrake) {  // 3.8.6.2
  EXPECT_EQ(answer_to(200), 138);
  EXPECT_TRUE(happened(What::message_refused));
  EXPECT_EQ(state.track.ma->end(), at(5950.0));
  EXPECT_EQ(state.balise.linking.links.size(), 2u);
}

TEST_F(Shortening, TheStartOfAnAreaIsAnEndToo) {  // 3.12.4
  EXPECT_EQ(answer_to(3000, on_sight_in(200)), 138);
  restart(Mode::FS);
  EXPECT_EQ(answer_to(3000, on_sight_in(2500)), 137);
  ASSERT_EQ(state.track.mode_profile.size(), 1u);
  EXPECT_EQ(state.track.mode_profile[0].from, at(3450.0));
}

TEST_F(Shortening, AnAreaThatIsAcceptedIsNoEnd) {  // 5.9.2.7
  // In the area for on sight, and the driver has acknowledged that for LS which follows.
  const auto answer = [&](bool accepted) {
    restart(Mode::LS);
    state.position.now.V_est = state.position.now.V_min = state.position.now.V_max = {5.0};
    track::ModeArea area;
    area.from = area.ack_from = at(950.0);
    area.to = at(1450.0);
    area.accepted = accepted;
    EXPECT_TRUE(state.track.mode_profile.push_back(area));
    return answer_to(3000, on_sight_in(0));
  };
  EXPECT_EQ(answer(true), 137);
  EXPECT_EQ(answer(false), 138);
}

TEST_F(Shortening, IsGrantedInRearOfItsIndicationLimitAlsoWhereTheTrainIsTooFast) {         // 3.8.6.1 b
  state.position.now.V_est = state.position.now.V_min = state.position.now.V_max = {43.0};  // 140 km/h are permitted
  state.track.ma->sections.back().end = at(31000.0);
  EXPECT_EQ(answer_to(30000), 137);
}

TEST_F(Shortening, IsGrantedWhileASpeedIsTheTarget) {  // 3.8.6.1 b
  state.position.now.V_est = state.position.now.V_min = state.position.now.V_max = {20.0};
  ASSERT_TRUE(state.track.tsr.push_back({.from = at(1010.0), .to = at(1100.0), .V_TSR = 1}));
  EXPECT_EQ(answer_to(5000), 137);
}

TEST_F(Shortening, WithTheSameEndDeletesWhatIsBeyond) {  // 3.8.6.2, A.3.4 f
  ASSERT_TRUE(state.track.ssp.append(at(8000.0), {.V_STATIC = 10}));
  ASSERT_EQ(state.track.ssp.steps.size(), 2u);
  EXPECT_EQ(answer_to(5000), 137);
  EXPECT_EQ(state.track.ma->end(), at(5950.0));
  ASSERT_FALSE(state.track.ssp.empty());
  EXPECT_LE(state.track.ssp.steps.back().from, at(5950.0));
}

TEST_F(Shortening, IsNoExtension) {  // 3.8.6.1 a
  state.track.ma->sections.back().end = at(5900.0);
  EXPECT_EQ(answer_to(5000), 138);  // to 5950 m
  EXPECT_EQ(state.track.ma->end(), at(5900.0));
}

TEST_F(Shortening, IsJudgedByItsOwnMessage) {  // 3.8.6.1
  track::ModeArea on_sight;
  on_sight.from = on_sight.ack_from = at(1100.0);
  ASSERT_TRUE(scratch->proposal.mode_profile.emplace().push_back(on_sight));  // of an earlier message
  EXPECT_EQ(answer_to(3000), 137);
  EXPECT_TRUE(state.track.mode_profile.empty());
}

TEST_F(Shortening, WithoutFullSupervisionThereIsNoEndToStopAt) {  // 3.8.6.2
  track::AuthorityContents proposal;
  const auto can_stop = [&] { return can_stop_before(state, scratch->curves, in.train, received.here, proposal); };
  EXPECT_FALSE(can_stop()) << "no authority is proposed";
  ASSERT_TRUE(proposal.ma.emplace().sections.push_back({at(950.0), at(4950.0)}));
  EXPECT_TRUE(can_stop());
  for (const Mode mode : {Mode::SR, Mode::SH, Mode::UN}) {
    state.mode = mode;
    EXPECT_FALSE(can_stop()) << static_cast<int>(mode);
  }
}

TEST_F(Shortening, OverUnknownTrackIsRefused) {  // 4.8.3 [4]
  state.track.gradient = {};
  ASSERT_TRUE(state.track.gradient.append(at(0.0), {}));
  EXPECT_NE(answer_to(3000), 137);
  EXPECT_EQ(state.track.ma->end(), at(5950.0));
}

TEST_F(Shortening, OfWhichThePacketIsMissingIsRefused) {  // 3.8.6.1
  set_message(lang::Message9{});
  evaluate_now();
  EXPECT_FALSE(happened(What::shortening_granted));
  EXPECT_EQ(state.track.ma->end(), at(5950.0));
}

TEST_F(Shortening, LeavesTheCurvesInForceAsTheyAre) {  // 3.8.6.2
  const State before = state;
  ASSERT_EQ(answer_to(200), 138);
  EXPECT_EQ(state.basis.number, before.basis.number);
  EXPECT_EQ(state.track.revision, before.track.revision);
}

}  // namespace
}  // namespace evc::kernel
