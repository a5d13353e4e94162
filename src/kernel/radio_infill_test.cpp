#include "kernel/radio_infill.h"

#include <gtest/gtest.h>

#include <memory>

#include "base/test_units.h"
#include "terms/message_numbers.h"

// Radio infill as the unit executes it (3.9.3).
namespace evc::kernel {
namespace {

using evc::test::at;
using radio::Peer;
using radio::Phase;
constexpr radio::Rbc kAnRbc{1, 10, 1010}, kUnit7{1, 7, 7007, true}, kUnit8{1, 8, 8008, true}, kUnit9{1, 9, 9009, true};

/// A train in FS in level 1 at 1000 m.
class Infill : public ::testing::Test {
 protected:
  Infill() { restart(); }
  void restart() {
    state = State{};
    state.mode = Mode::FS;
    state.level.level = Level::L1;
    state.now = {100.0};
    front(1000.0);
  }
  void front(double x) { here.est_front = at(x); }
  void order(const radio::Rbc& unit, double place, bool establish = true, std::uint16_t NID_BG = 101) {
    state.track.radio_infill = {at(place), establish, unit.NID_C, unit.NID_RBC, unit.NID_RADIO, {1, NID_BG}, {}};
  }
  void run(bool mission_ended = false) {
    outbox = {};
    outputs->events.clear();
    run_radio_infill(state, here, mission_ended, outbox, Log{outputs->events});
  }
  void neighbour(const radio::Rbc& unit, bool establish = true) {
    order_neighbour(state, unit, establish, outbox, Log{outputs->events});
  }
  radio::Session& session(std::size_t i) { return state.radio.infill_units[i]; }
  void open(std::size_t i, const radio::Rbc& unit, Phase phase = Phase::up) {
    session(i).phase = phase;
    session(i).rbc = unit;
  }
  /// The messages of this cycle.
  int sent(std::uint8_t NID_MESSAGE, Peer to) const {
    int n = 0;
    for (const radio::Intent& intent : outbox.messages)
      n += intent.NID_MESSAGE == NID_MESSAGE && intent.to == to ? 1 : 0;
    return n;
  }

  std::unique_ptr<State> memory = std::make_unique<State>();
  State& state = *memory;
  track::Here here{};
  radio::Outbox outbox;
  std::unique_ptr<Outputs> outputs = std::make_unique<Outputs>();
};

TEST_F(Infill, TheOrderIsExecutedOnceAtItsPlace) {  // 3.9.3.5
  order(kUnit7, 1000.5);
  run();
  EXPECT_FALSE(outbox.connect);
  front(1000.5);
  run();
  EXPECT_EQ(outbox.connect, kUnit7);
  EXPECT_FALSE(state.track.radio_infill);
  ASSERT_TRUE(state.radio_infill.area);
  EXPECT_EQ(state.radio_infill.area->signal, (GroupId{1, 101}));
  run();
  EXPECT_FALSE(outbox.connect);
}

TEST_F(Infill, TheUnitIsInformedWhenItsSessionIsOpen) {  // 3.9.3.10 a
  order(kUnit7, 900.0);
  run();
  session(0).phase = Phase::waiting_version;
  run();
  EXPECT_TRUE(outbox.messages.empty());
  session(0).phase = Phase::up;
  run();
  ASSERT_EQ(sent(message::radio_infill_request, Peer::infill_1), 1);
  EXPECT_EQ(outbox.messages[0].signal, (GroupId{1, 101}));
  EXPECT_EQ(outbox.messages[0].Q_INFILL, 0);
  run();
  EXPECT_TRUE(outbox.messages.empty());
}

TEST_F(Infill, TheSignalEndsTheArea) {  // 3.9.3.10 b
  open(1, kUnit7);
  order(kUnit7, 900.0);
  run();
  EXPECT_EQ(sent(message::radio_infill_request, Peer::infill_2), 1);
  note_signal_of_radio_infill(state, {1, 102});
  run();
  EXPECT_TRUE(outbox.messages.empty());
  note_signal_of_radio_infill(state, {1, 101});
  run();
  ASSERT_EQ(sent(message::radio_infill_request, Peer::infill_2), 1);
  EXPECT_EQ(outbox.messages[0].Q_INFILL, 1);
  note_signal_of_radio_infill(state, {1, 101});
  run();
  EXPECT_TRUE(outbox.messages.empty());
}

TEST_F(Infill, OneAreaEndsBeforeTheNextBegins) {  // 3.9.3.10, Figure 25a
  open(0, kUnit7);
  order(kUnit7, 900.0);
  run();
  note_signal_of_radio_infill(state, {1, 101});
  order(kUnit7, 1000.0, true, 102);
  run();
  ASSERT_EQ(outbox.messages.size(), 2u);
  EXPECT_EQ(outbox.messages[0].Q_INFILL, 1);
  EXPECT_EQ(outbox.messages[0].signal, (GroupId{1, 101}));
  EXPECT_EQ(outbox.messages[1].Q_INFILL, 0);
  EXPECT_EQ(outbox.messages[1].signal, (GroupId{1, 102}));
}

TEST_F(Infill, WhatIsDueWithoutAConnectionCountsAsSent) {  // 3.5.4.5
  open(0, kUnit7, Phase::lost);
  order(kUnit7, 900.0);
  run();
  EXPECT_EQ(sent(message::radio_infill_request, Peer::infill_1), 1) << "the sessions drop it";
  session(0).phase = Phase::up;
  run();
  EXPECT_TRUE(outbox.messages.empty());
}

TEST_F(Infill, AUnitThatWasNotReachedInItsAreaIsNotInformed) {
  order(kUnit7, 900.0);
  run();
  note_signal_of_radio_infill(state, {1, 101});
  run();
  session(0).phase = Phase::up;
  run();
  run();
  EXPECT_TRUE(outbox.messages.empty());
}

TEST_F(Infill, OtherUnitsAreLeftAndTheNewOneIsCalledWhenThereIsATerminal) {  // 3.9.3.5
  open(0, kUnit7);
  open(1, kUnit9, Phase::connecting);
  order(kUnit8, 900.0);
  run();
  EXPECT_EQ(sent(message::session_terminated, Peer::infill_1), 1);
  EXPECT_EQ(outbox.disconnect, kUnit9) << "a set-up";
  EXPECT_EQ(outbox.connect, kUnit8);
  EXPECT_EQ(session(1).rbc, kUnit8);

  restart();
  state.terminals = 1;
  open(0, kUnit7);
  order(kUnit8, 900.0);
  run();
  EXPECT_FALSE(outbox.connect);
  session(0) = {};
  run();
  EXPECT_EQ(outbox.connect, kUnit8);
}

TEST_F(Infill, ASessionWithAnRbcTakesATerminal) {
  state.radio.supervising.session.phase = Phase::up;
  state.radio.supervising.session.rbc = kAnRbc;
  state.terminals = 1;
  order(kUnit7, 900.0);
  run();
  EXPECT_FALSE(outbox.connect);
  state.terminals = 2;
  run();
  EXPECT_EQ(outbox.connect, kUnit7);
}

TEST_F(Infill, RbcsComeFirst) {  // 3.5.2.4: two sessions
  open(0, kUnit7);
  open(1, kUnit8);
  order(kUnit8, 900.0);
  state.radio_infill.area = RadioInfill::Area{kUnit8, {1, 101}, false, false, false};
  state.track.radio_infill.reset();
  run();
  EXPECT_TRUE(outbox.messages.empty());
  state.radio.supervising.session.phase = Phase::connecting;
  state.radio.supervising.session.rbc = kAnRbc;
  run();
  EXPECT_EQ(sent(message::session_terminated, Peer::infill_1), 1);
  EXPECT_EQ(sent(message::session_terminated, Peer::infill_2), 0);
  run();
  EXPECT_TRUE(outbox.messages.empty()) << "it is ending";
  state.radio.other.session.phase = Phase::up;
  state.radio.other.session.rbc = {1, 11};
  run();
  EXPECT_EQ(sent(message::session_terminated, Peer::infill_2), 1);
}

TEST_F(Infill, AnOrderToEndTheSession) {  // 3.9.3.16
  open(0, kUnit7);
  order(kUnit8, 900.0, false);
  run();
  EXPECT_TRUE(outbox.messages.empty());
  EXPECT_TRUE(outputs->events.empty());
  order(kUnit7, 900.0, false);
  run();
  EXPECT_EQ(sent(message::session_terminated, Peer::infill_1), 1);
  ASSERT_EQ(outputs->events.size(), 1u);
  EXPECT_EQ(outputs->events[0].what, What::session_termination_ordered);
  EXPECT_FALSE(state.radio_infill.area);
}

TEST_F(Infill, AnOrderToEndASessionThatIsStillToCome) {
  state.terminals = 1;
  open(0, kUnit7);
  order(kUnit8, 900.0);
  run();
  order(kUnit8, 900.0, false);
  run();
  session(0) = {};
  run();
  EXPECT_FALSE(outbox.connect);
}

TEST_F(Infill, OutsideLevel1NothingIsEstablishedAndEverySessionEnds) {  // 3.9.3.1, 3.9.3.16
  for (const Level level : {Level::L0, Level::NTC, Level::L2, Level::L3}) {
    restart();
    open(0, kUnit7);
    open(1, kUnit8, Phase::waiting_version);
    state.radio_infill.area = RadioInfill::Area{kUnit7, {1, 101}, false, false, false};
    state.level.level = level;
    order(kUnit9, 900.0);
    run();
    EXPECT_FALSE(outbox.connect);
    EXPECT_EQ(sent(message::session_terminated, Peer::infill_1), 1);
    EXPECT_EQ(outbox.disconnect, kUnit8);
    EXPECT_FALSE(state.radio_infill.area);
    EXPECT_FALSE(state.track.radio_infill);
  }
}

TEST_F(Infill, EverySessionEndsWithTheMission) {  // 5.5.3.1.2
  open(0, kUnit7);
  session(0).remembered = kUnit8;
  run(true);
  EXPECT_EQ(sent(message::session_terminated, Peer::infill_1), 1);
  EXPECT_FALSE(session(0).remembered);
}

TEST_F(Infill, ANeighbourIsCalledBesideThePresentUnit) {  // 3.9.3.6
  open(0, kUnit7);
  neighbour(kUnit8);
  neighbour(kUnit8);
  EXPECT_EQ(state.radio_infill.to_call.size(), 1u);
  run();
  EXPECT_EQ(outbox.connect, kUnit8);
  EXPECT_TRUE(outbox.messages.empty());
  neighbour(kUnit8);
  EXPECT_TRUE(state.radio_infill.to_call.empty());
}

TEST_F(Infill, ANeighbourWithOneTerminalIsIgnored) {  // 3.9.3.6.1
  state.terminals = 1;
  open(0, kUnit7);
  neighbour(kUnit8);
  EXPECT_TRUE(state.radio_infill.to_call.empty());
  neighbour(kUnit7, false);
  EXPECT_EQ(sent(message::session_terminated, Peer::infill_1), 1);
}

TEST_F(Infill, OfTwoSessionsThatOfTheAreaStays) {  // 3.9.3.6 b
  for (const std::size_t of_area : {std::size_t{0}, std::size_t{1}}) {
    restart();
    outbox = {};
    open(0, kUnit7);
    open(1, kUnit8);
    state.radio_infill.area = RadioInfill::Area{of_area == 0 ? kUnit7 : kUnit8, {1, 101}, false, false, false};
    neighbour(kUnit9);
    EXPECT_EQ(sent(message::session_terminated, Peer::infill_1), of_area == 0 ? 0 : 1);
    EXPECT_EQ(sent(message::session_terminated, Peer::infill_2), of_area == 0 ? 1 : 0);
  }
}

TEST_F(Infill, TheSessionOfTheAreaIsThatOfItsUnit) {  // 3.5.7.7
  EXPECT_EQ(session_of_infill_area(state), nullptr);
  open(1, kUnit8);
  EXPECT_EQ(session_of_infill_area(state), nullptr);
  state.radio_infill.area = RadioInfill::Area{kUnit8, {1, 101}, false, false, false};
  EXPECT_EQ(session_of_infill_area(state), &session(1));
  session(1) = {};
  EXPECT_EQ(session_of_infill_area(state), nullptr);
}

}  // namespace
}  // namespace evc::kernel
