#include "kernel/report/handover.h"

#include <gtest/gtest.h>

#include <memory>

#include "base/test_units.h"
#include "modes/active_functions.h"
#include "radio/messages.h"

// The handover between two RBCs as the unit executes it (3.15.1, 5.15).
namespace evc::kernel {
namespace {

using procedures::rbc_handover::Step;

using evc::test::at;
constexpr radio::Rbc kFirst{1, 10, 1010}, kSecond{1, 20, 2020}, kThird{1, 30, 3030};

/// A train of 200 m in FS at 1000 m with a session with the first RBC; it has been ordered to the second one at 1500 m.
class RbcHandover : public ::testing::Test {
 protected:
  RbcHandover() { restart(Mode::FS); }
  void restart(Mode mode) {
    state = State{};
    state.mode = mode;
    state.level.level = Level::L2;
    state.now = {100.0};
    state.train.L_TRAIN = {200.0};
    state.data.train_data_status = DataStatus::valid;
    state.radio.supervising.session.phase = radio::Phase::up;
    state.radio.supervising.session.rbc = kFirst;
    state.radio.contact = kFirst;
    state.contact_status = DataStatus::invalid;
    front(1000.0);
    order(kSecond, 1500.0);
  }
  void front(double x) { here.est_front = here.min_safe_front = here.max_safe_front = at(x); }
  void order(const radio::Rbc& rbc, double place, bool sleeping_too = false) {
    state.track.rbc_transition = {at(place), rbc.NID_C, rbc.NID_RBC, rbc.NID_RADIO, sleeping_too, {}};
  }
  /// One cycle. Returns whether a position report is due.
  bool run() {
    outbox = {};
    outputs->events.clear();
    return run_handover(state, here, outbox, Log{outputs->events});
  }
  bool run_at(double x) {
    front(x);
    return run();
  }
  void complete(bool reported_to_other) {
    radio::Result result;
    result.reported_to_other = reported_to_other;
    outputs->events.clear();
    complete_handover(state, result, Log{outputs->events});
  }
  /// The identity in the log; 0: it is not there.
  int logged(What what) const {
    for (const Event& e : outputs->events)
      if (e.what == what) return e.id;
    return 0;
  }
  bool sent(std::uint8_t NID_MESSAGE, radio::Peer to) const {
    for (const radio::Intent& m : outbox.messages)
      if (m.NID_MESSAGE == NID_MESSAGE && m.to == to) return true;
    return false;
  }
  Step step() const { return state.handover.procedure.step; }
  radio::Session& other() { return state.radio.other.session; }
  void answer_of_the_second() { other().phase = radio::Phase::up; }

  std::unique_ptr<State> memory = std::make_unique<State>();
  State& state = *memory;
  track::Here here;
  radio::Outbox outbox;
  std::unique_ptr<Outputs> outputs = std::make_unique<Outputs>();
};

TEST_F(RbcHandover, AnOrderCallsTheAcceptingRBC) {  // 3.15.1.3.1, 3.5.3.5.2.1
  EXPECT_FALSE(run());
  EXPECT_EQ(logged(What::rbc_handover_ordered), 20);
  EXPECT_EQ(outbox.connect, kSecond);
  EXPECT_TRUE(other().active());
  EXPECT_TRUE(state.radio.other_accepts);
  EXPECT_EQ(state.radio.supervising.session.phase, radio::Phase::up);
  EXPECT_EQ(state.radio.contact, kFirst) << "the contact changes at the border";
  EXPECT_FALSE(run());
  EXPECT_EQ(logged(What::rbc_handover_ordered), 0) << "once";
  EXPECT_FALSE(outbox.connect.has_value());
}

TEST_F(RbcHandover, WithoutAnOrderThereIsNone) {  // 3.15.1.3.1
  state.track.rbc_transition.reset();
  state.buffer.grow()->accepting = true;
  EXPECT_FALSE(run_at(2000.0));
  EXPECT_FALSE(other().active());
  EXPECT_EQ(state.radio.contact, kFirst);
  EXPECT_EQ(state.buffer.size(), 1u) << "what waits for it is not deleted either";
}

TEST_F(RbcHandover, TheSameRBCAgainOnlyMovesTheBorder) {  // 3.15.1.3.1
  (void)run();
  order(kSecond, 1600.0);
  EXPECT_FALSE(run_at(1550.0));
  EXPECT_EQ(logged(What::rbc_handover_ordered), 0);
  EXPECT_EQ(step(), Step::announced);
  EXPECT_TRUE(run_at(1600.0));
  EXPECT_EQ(step(), Step::at_border);
}

TEST_F(RbcHandover, AnotherRBCTakesThePlaceOfTheFormer) {  // 3.15.1.3.2.3
  (void)run();
  answer_of_the_second();
  order(kThird, 1700.0);
  (void)run();
  EXPECT_EQ(logged(What::rbc_handover_ordered), 30);
  EXPECT_TRUE(sent(message::session_terminated, radio::Peer::other));
  EXPECT_EQ(other().remembered, kThird);
}

TEST_F(RbcHandover, TheRBCThatSupervisesIsNoAcceptingOne) {  // 3.15.1.3.1
  order(kFirst, 1500.0);
  EXPECT_FALSE(run());
  EXPECT_FALSE(state.track.rbc_transition.has_value());
  EXPECT_FALSE(state.handover.order.has_value());
  EXPECT_EQ(logged(What::rbc_handover_ordered), 0);
  EXPECT_FALSE(other().active());
  restart(Mode::FS);
  state.radio.supervising.session.phase = radio::Phase::idle;
  order(kFirst, 1500.0);
  (void)run();
  EXPECT_EQ(logged(What::rbc_handover_ordered), 10) << "without a session it is called";
}

TEST_F(RbcHandover, AnOrderToTheRBCThatSupervisesTakesThePlaceOfTheFormer) {  // 3.15.1.3.1: one is stored
  (void)run();
  answer_of_the_second();
  order(kFirst, 1400.0);
  EXPECT_FALSE(run());
  EXPECT_EQ(logged(What::rbc_handover_ordered), 0);
  EXPECT_FALSE(state.handover.order.has_value());
}

TEST_F(RbcHandover, AfterOneIsOverTheSameRBCMayBeOrderedAgain) {  // 3.15.1.3.1
  (void)run();
  state.handover.procedure = {};
  order(kSecond, 1600.0);
  (void)run();
  EXPECT_EQ(logged(What::rbc_handover_ordered), 20);
}

TEST_F(RbcHandover, ASleepingEngineCallsOnlyWhereItIsTold) {  // 3.15.1.3.1, Q_SLEEPSESSION
  const auto calls = [&](Mode mode, bool sleeping_too) {
    restart(mode);
    order(kSecond, 1500.0, sleeping_too);
    (void)run();
    EXPECT_EQ(logged(What::rbc_handover_ordered), 20);
    return outbox.connect.has_value();
  };
  EXPECT_FALSE(calls(Mode::SL, false));
  EXPECT_TRUE(calls(Mode::SL, true));
  EXPECT_TRUE(calls(Mode::FS, false));
}

TEST_F(RbcHandover, TheFrontEndChangesTheContact) {  // 3.15.1.3.7
  (void)run();
  here.est_front = at(1499.9);
  (void)run();
  EXPECT_EQ(state.radio.contact, kFirst);
  here.est_front = at(1500.0);
  (void)run();
  EXPECT_EQ(state.radio.contact, kSecond);
  EXPECT_EQ(state.contact_status, DataStatus::valid);
}

TEST_F(RbcHandover, TheMaxSafeFrontEndEndsTheInhibitionOfRevocableRestrictions) {  // 3.11.5.14
  bool& inhibited = state.track.revocable_tsr_inhibited;
  (void)run();
  inhibited = true;
  here.max_safe_front = at(1499.9);
  (void)run();
  EXPECT_TRUE(inhibited);
  here.max_safe_front = at(1500.0);
  (void)run();
  EXPECT_FALSE(inhibited);
  inhibited = true;
  (void)run_at(1501.0);
  EXPECT_TRUE(inhibited) << "once: ordered beyond the border by the accepting RBC";
}

TEST_F(RbcHandover, TheMaxSafeFrontEndReportsTheBorder) {  // 3.15.1.3.1 b, 3.6.5.1.4 e, 4.5.2
  for (std::size_t i = 1; i < kModes; ++i) {
    const Mode mode = static_cast<Mode>(i);
    restart(mode);
    (void)run();
    here.max_safe_front = at(1499.9);
    EXPECT_FALSE(run()) << i;
    here.max_safe_front = at(1500.0);
    EXPECT_EQ(run(), modes::active(modes::Function::report_rbc_border, mode)) << i;
    EXPECT_EQ(step(), Step::at_border) << i;
    EXPECT_FALSE(run()) << i;
  }
}

TEST_F(RbcHandover, TheMinSafeRearEndReportsThatItLeft) {  // 3.15.1.3.1 c, 3.15.1.3.9
  (void)run();
  answer_of_the_second();
  (void)run_at(1600.0);
  complete(true);
  here.min_safe_front = at(1699.9);  // the rear end is 200 m behind
  EXPECT_FALSE(run());
  here.min_safe_front = at(1700.0);
  EXPECT_TRUE(run());
  EXPECT_FALSE(run());
  for (int i = 0; i < procedures::N_REPEAT; ++i) {
    state.now += procedures::T_REPEAT;
    EXPECT_TRUE(run()) << i;
    EXPECT_FALSE(sent(message::session_terminated, radio::Peer::supervising));
  }
  state.now += procedures::T_REPEAT;
  EXPECT_FALSE(run());
  EXPECT_TRUE(sent(message::session_terminated, radio::Peer::supervising));
  EXPECT_TRUE(other().established()) << "that with the accepting RBC stays";
}

TEST_F(RbcHandover, TheSetUpWithTheRBCThatIsLeftEnds) {  // 3.5.3.8 f
  (void)run();
  answer_of_the_second();
  (void)run_at(1600.0);
  complete(true);
  state.radio.supervising.session.phase = radio::Phase::connecting;
  (void)run_at(1699.9);
  EXPECT_EQ(state.radio.supervising.session.phase, radio::Phase::connecting);
  EXPECT_FALSE(run_at(1700.0)) << "no session, no report";
  EXPECT_EQ(state.radio.supervising.session.phase, radio::Phase::idle);
  EXPECT_TRUE(other().established());
}

TEST_F(RbcHandover, TheAcceptingRBCSupervisesAfterAReportFromBeyondTheBorder) {  // 3.15.1.3.5
  (void)run();
  answer_of_the_second();
  complete(true);
  EXPECT_FALSE(state.radio.exchange_due) << "in rear of the border";
  (void)run_at(1500.0);
  complete(false);
  EXPECT_FALSE(state.radio.exchange_due) << "not to the accepting RBC";
  state.radio.other_accepts = false;
  complete(true);
  EXPECT_FALSE(state.radio.exchange_due) << "the other one is the former RBC";
  state.radio.other_accepts = true;
  complete(true);
  EXPECT_TRUE(state.radio.exchange_due);
  EXPECT_EQ(logged(What::rbc_handed_over), 20);
  state.radio.exchange_due = false;
  complete(true);
  EXPECT_FALSE(state.radio.exchange_due) << "once";
}

TEST_F(RbcHandover, IsOverWhenTheSessionWithTheFormerRBCHasEnded) {  // 3.15.1.3, 4.8.5.4 a
  (void)run();
  answer_of_the_second();
  (void)run_at(1500.0);
  complete(true);
  radio::exchange(state.radio, state.now);
  state.buffer.grow()->accepting = true;
  state.buffer.grow()->accepting = false;
  EXPECT_TRUE(run_at(1700.0)) << "to the former RBC";
  EXPECT_TRUE(state.handover.order.has_value());
  EXPECT_TRUE(state.track.rbc_transition.has_value());
  EXPECT_EQ(state.buffer.size(), 2u);
  state.radio.other.session = {};
  EXPECT_FALSE(run());
  EXPECT_FALSE(state.handover.order.has_value());
  EXPECT_FALSE(state.track.rbc_transition.has_value());
  ASSERT_EQ(state.buffer.size(), 1u);
  EXPECT_FALSE(state.buffer[0].accepting);
}

TEST_F(RbcHandover, BeforeTheExchangeItIsTheSupervisingSessionThatEnds) {  // 3.15.1.3.5: from the next cycle on
  (void)run();
  answer_of_the_second();
  (void)run_at(1500.0);
  complete(true);
  EXPECT_TRUE(run_at(1700.0));
  for (int i = 0; i <= procedures::N_REPEAT; ++i) {
    state.now += procedures::T_REPEAT;
    (void)run();
  }
  EXPECT_EQ(state.radio.supervising.session.phase, radio::Phase::terminating);
  EXPECT_TRUE(other().established());
}

TEST_F(RbcHandover, AnOrderThatIsDeletedEndsIt) {  // 3.15.1.3.1
  (void)run();
  state.track.rbc_transition.reset();
  EXPECT_FALSE(run());
  EXPECT_FALSE(state.handover.order.has_value());
  EXPECT_FALSE(run_at(2000.0));
  EXPECT_EQ(state.radio.contact, kFirst);
}

TEST_F(RbcHandover, AnOrderThatIsDeletedBeyondTheBorderEndsItWithoutASecondSession) {  // 3.15.1.3.1
  for (const bool second : {true, false}) {
    restart(Mode::FS);
    (void)run();
    other().phase = second ? radio::Phase::up : radio::Phase::idle;
    (void)run_at(1500.0);
    state.track.rbc_transition.reset();
    (void)run();
    EXPECT_EQ(state.handover.order.has_value(), second);
  }
}

TEST_F(RbcHandover, WithOneTerminalTheAcceptingRBCIsCalledAfterTheFormer) {  // 3.15.1.3.2.2
  state.terminals = 1;
  (void)run();
  EXPECT_FALSE(outbox.connect.has_value());
  EXPECT_FALSE(other().active());
  EXPECT_TRUE(run_at(1500.0));
  EXPECT_FALSE(outbox.connect.has_value()) << "the session with the former RBC goes on";
  state.radio.supervising.session = {};
  (void)run();
  EXPECT_EQ(outbox.connect, kSecond);
  EXPECT_TRUE(state.radio.supervising.session.active());
  EXPECT_FALSE(other().active());
}

TEST_F(RbcHandover, WithOneTerminalTheFormerOrderGoesOnBeyondItsBorder) {  // 3.15.1.3.2.4
  for (const bool beyond : {true, false}) {
    restart(Mode::FS);
    state.terminals = 1;
    (void)run();
    (void)run_at(beyond ? 1500.0 : 1499.0);
    order(kThird, 3000.0);
    (void)run();
    EXPECT_EQ(logged(What::rbc_handover_ordered), 30);
    EXPECT_EQ(sent(message::session_terminated, radio::Peer::supervising), beyond);
    EXPECT_EQ(state.radio.supervising.session.remembered, beyond ? std::optional{kSecond} : std::nullopt);
  }
}

TEST_F(RbcHandover, WithTwoTerminalsTheSupervisingSessionStaysAtTheBorder) {  // 3.15.1.3.9
  (void)run();
  answer_of_the_second();
  (void)run_at(1500.0);
  state.radio.supervising.session = {};
  (void)run();
  EXPECT_FALSE(outbox.connect.has_value());
  EXPECT_EQ(step(), Step::at_border);
}

TEST_F(RbcHandover, IndicatesTheAcceptingRBCWhenTheOtherIsLeft) {  // 3.5.7.6
  const auto indicated = [&](bool rear_passed, bool supervising, bool second) {
    state.handover.procedure.rear_passed = rear_passed;
    state.radio.supervising.session.phase = supervising ? radio::Phase::up : radio::Phase::idle;
    other().phase = second ? radio::Phase::up : radio::Phase::idle;
    return &indicated_session(state) == &other() ? 2 : 1;
  };
  EXPECT_EQ(indicated(true, false, true), 2);
  EXPECT_EQ(indicated(false, false, true), 1);
  EXPECT_EQ(indicated(true, true, true), 1);
  EXPECT_EQ(indicated(true, false, false), 1);
}

}  // namespace
}  // namespace evc::kernel
