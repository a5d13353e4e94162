#include "kernel/report/sessions.h"

#include <gtest/gtest.h>

#include <memory>

#include "modes/active_functions.h"
#include "radio/messages.h"

// Sessions that the unit establishes and ends by itself (3.5.3.4, 3.5.3.8, 3.5.5.1).
namespace evc::kernel {
namespace {

using procedures::Send;

constexpr radio::Rbc kStored{1, 10, 1010}, kOther{1, 20, 2020};

/// A unit in FS and level 2 that has a valid contact and no session.
class OwnSessions : public ::testing::Test {
 protected:
  OwnSessions() { restart(); }
  void restart() {
    state = State{};
    received = {};
    decided = {};
    state.mode = state.previous_mode = Mode::FS;
    state.level.level = Level::L2;
    state.radio.contact = kStored;
    state.contact_status = DataStatus::valid;
  }
  void run() {
    outbox = {};
    effects = decided.effects;
    order_sessions(state, received, decided, effects, outbox);
  }
  bool calls() {
    run();
    return outbox.connect == kStored;
  }
  void change(Mode from, Mode to) {
    state.previous_mode = from;
    state.mode = to;
    decided.mode_changed = true;
  }
  radio::Session& session() { return state.radio.supervising.session; }
  radio::Session& second() { return state.radio.other.session; }
  void establish_both() {
    session().rbc = kStored;
    second().rbc = kOther;
    session().phase = second().phase = radio::Phase::up;
  }

  std::unique_ptr<State> memory = std::make_unique<State>();
  State& state = *memory;
  Received received;
  Decided decided;
  procedures::Effects effects;
  radio::Outbox outbox;
};

TEST_F(OwnSessions, AProcedureOpensOne) {  // 3.5.3.4 a
  EXPECT_FALSE(calls());
  decided.effects.send.add(Send::open_session);
  EXPECT_TRUE(calls());
  EXPECT_EQ(session().cause, radio::Cause::start_of_mission);
  restart();
  state.radio.contact.reset();
  decided.effects.send.add(Send::open_session);
  run();
  EXPECT_FALSE(outbox.connect.has_value()) << "there is nobody to call";
}

TEST_F(OwnSessions, TheEndOfAMissionEndsThatWithTheRBCThatSupervises) {  // 3.15.1.3.4.1, 5.4.1.4
  for (const bool mission : {true, false}) {
    restart();
    establish_both();
    state.end_of_mission.mission = mission;
    run();
    EXPECT_TRUE(session().established());
    decided.effects.send.add(Send::terminate_session);
    run();
    EXPECT_EQ(session().phase, radio::Phase::terminating);
    EXPECT_EQ(second().phase, mission ? radio::Phase::up : radio::Phase::terminating);
  }
}

TEST_F(OwnSessions, ASetUpEndsWithTheMissionOrTheLevel) {  // 3.5.3.8 b, d
  const auto ends = [&](bool mission_ended, bool left, SrsVersion srs) {
    restart();
    state.srs = srs;
    session().phase = second().phase = radio::Phase::connecting;
    decided.mission_ended = mission_ended;
    received.level_2_or_3_left = left;
    run();
    EXPECT_EQ(session().phase, second().phase);
    return session().phase == radio::Phase::idle;
  };
  for (const SrsVersion srs : {SrsVersion::v3_6_0, SrsVersion::v4_0_0}) {
    EXPECT_FALSE(ends(false, false, srs));
    EXPECT_TRUE(ends(true, false, srs));
  }
  EXPECT_TRUE(ends(false, true, SrsVersion::v3_6_0));
  EXPECT_FALSE(ends(false, true, SrsVersion::v4_0_0)) << "the rear end passes the border";
}

TEST_F(OwnSessions, AModeThatHasToBeReportedOpensOne) {  // 3.5.3.4 c, 3.6.5.1.4 b, 4.5.2
  for (std::size_t i = 1; i < kModes; ++i) {
    const Mode mode = static_cast<Mode>(i);
    restart();
    change(Mode::UN, mode);
    const bool reported = modes::active(modes::Function::report_mode_change, mode);
    EXPECT_EQ(reports_mode(state, decided), reported) << i;
    EXPECT_EQ(calls(), reported) << i;
    if (reported) {
      EXPECT_EQ(session().cause, radio::Cause::mode_report) << i;
    }
  }
}

TEST_F(OwnSessions, OfAModeThatIsNotReportedNone) {  // 3.5.3.4 c, 4.4.20, 5.5.4
  change(Mode::FS, Mode::SR);
  decided.mode_changed = false;
  EXPECT_FALSE(calls());
  restart();
  change(Mode::FS, Mode::SR);
  state.level.level = Level::L1;
  EXPECT_FALSE(calls());
  restart();
  change(Mode::PS, Mode::SH);
  EXPECT_FALSE(reports_mode(state, decided)) << "shunting goes on";
  EXPECT_FALSE(calls());
  change(Mode::PS, Mode::SL);
  EXPECT_TRUE(reports_mode(state, decided));
  change(Mode::SB, Mode::SH);
  EXPECT_TRUE(reports_mode(state, decided));
  restart();
  change(Mode::FS, Mode::SR);
  decided.mission_ended = true;
  EXPECT_FALSE(calls()) << "only to report the end of a mission none is opened";
  restart();
  change(Mode::FS, Mode::SR);
  state.contact_status = DataStatus::invalid;
  EXPECT_FALSE(calls());
}

TEST_F(OwnSessions, AStartWithoutOneOpensItAtItsEnd) {  // 3.5.3.4 g
  const auto cause = [&](Mode from, Mode to, bool had_session) {
    restart();
    change(from, to);
    state.start_of_mission.step = procedures::start_of_mission::Step::S24;
    state.start_of_mission.had_session = had_session;
    EXPECT_TRUE(calls());
    return session().cause;
  };
  EXPECT_EQ(cause(Mode::SB, Mode::SR, false), radio::Cause::start_without_session);
  EXPECT_EQ(cause(Mode::SB, Mode::SR, true), radio::Cause::mode_report);
  EXPECT_EQ(cause(Mode::SB, Mode::SH, false), radio::Cause::mode_report) << "no mission";
  EXPECT_EQ(cause(Mode::FS, Mode::SR, false), radio::Cause::mode_report);
}

// --- 3.5.3.4 d, h, 5.10.3.15.2

TEST_F(OwnSessions, ADriverWhoSelectsLevel2OpensOne) {
  received.level_switched_to = Level::L2;
  received.level_changed_by_driver = true;
  EXPECT_TRUE(calls());
  EXPECT_EQ(session().cause, radio::Cause::driver_level);
  EXPECT_FALSE(effects.entries.has(Entry::rbc_contact));
  EXPECT_FALSE(state.asks_for_contact);
  restart();
  received.level_switched_to = Level::L2;
  EXPECT_FALSE(calls()) << "by trackside";
  restart();
  received.level_changed_by_driver = true;
  EXPECT_FALSE(calls()) << "no change in this cycle";
}

TEST_F(OwnSessions, WithoutAValidContactTheDriverIsAsked) {
  state.contact_status = DataStatus::unknown;
  received.level_switched_to = Level::L2;
  received.level_changed_by_driver = true;
  EXPECT_FALSE(calls());
  EXPECT_TRUE(effects.entries.has(Entry::rbc_contact));
  received = {};
  EXPECT_FALSE(calls());
  EXPECT_TRUE(effects.entries.has(Entry::rbc_contact)) << "until he has entered it";
  received.entered.add(Entered::rbc_contact);
  EXPECT_TRUE(calls());
  EXPECT_EQ(session().cause, radio::Cause::driver_level);
  EXPECT_FALSE(effects.entries.has(Entry::rbc_contact));
}

TEST_F(OwnSessions, WithoutARegisteredTerminalTheDriverChoosesWhenThereIsOne) {
  state.network.registered = false;
  received.level_switched_to = Level::L2;
  received.level_changed_by_driver = true;
  EXPECT_FALSE(calls());
  EXPECT_FALSE(effects.entries.has(Entry::rbc_contact));
  received = {};
  state.network.registered = true;
  EXPECT_FALSE(calls()) << "at once only with the change of level (5.10.3.15.2 a)";
  EXPECT_TRUE(effects.entries.has(Entry::rbc_contact));
  received.entered.add(Entered::rbc_contact);
  EXPECT_TRUE(calls());
  EXPECT_FALSE(state.asks_for_contact);
}

TEST_F(OwnSessions, AnOrderOfTheTracksideEndsTheQuestion) {
  state.asks_for_contact = true;
  session().phase = radio::Phase::connecting;
  run();
  EXPECT_FALSE(state.asks_for_contact);
  EXPECT_FALSE(effects.entries.has(Entry::rbc_contact));
}

TEST_F(OwnSessions, ADriverWithASessionIsNotAsked) {
  state.contact_status = DataStatus::unknown;
  received.level_switched_to = Level::L2;
  received.level_changed_by_driver = true;
  session().phase = radio::Phase::up;
  run();
  EXPECT_FALSE(effects.entries.has(Entry::rbc_contact));
  EXPECT_FALSE(state.asks_for_contact);
}

TEST_F(OwnSessions, InTRHeIsAskedInPT) {
  state.asks_for_contact = true;
  state.contact_status = DataStatus::unknown;
  state.mode = state.previous_mode = Mode::TR;
  run();
  EXPECT_FALSE(effects.entries.has(Entry::rbc_contact));
  state.mode = state.previous_mode = Mode::PT;
  run();
  EXPECT_TRUE(effects.entries.has(Entry::rbc_contact));
}

TEST_F(OwnSessions, InSBAndOtherLevelsTheProceduresAsk) {
  const auto asks = [&](Mode mode, Level level) {
    restart();
    state.mode = state.previous_mode = mode;
    state.level.level = level;
    state.contact_status = DataStatus::unknown;
    state.asks_for_contact = true;
    run();
    EXPECT_EQ(state.asks_for_contact, effects.entries.has(Entry::rbc_contact));
    return state.asks_for_contact;
  };
  EXPECT_TRUE(asks(Mode::FS, Level::L2));
  EXPECT_TRUE(asks(Mode::SR, Level::L3));
  EXPECT_FALSE(asks(Mode::SB, Level::L2));
  EXPECT_FALSE(asks(Mode::FS, Level::L1));
}

// --- 4.4.4

TEST_F(OwnSessions, WithoutPowerThereIsNone) {
  establish_both();
  state.handover.order.emplace();
  ASSERT_TRUE(state.radio.errors.push_back(ErrorReport::linked_message));
  outbox = {};
  outbox.send(message::request_for_shunting);
  outbox.connect = kOther;
  BufferedSet& set = *state.buffer.grow();
  set.accepting = true;
  state.track.revocable_tsr_inhibited = true;
  end_without_power(state, outbox);
  EXPECT_TRUE(outbox.messages.empty());
  EXPECT_FALSE(outbox.connect.has_value());
  EXPECT_EQ(outbox.disconnect, kStored);
  ASSERT_EQ(state.radio.disconnect_later.size(), 1u);
  EXPECT_EQ(state.radio.disconnect_later[0], kOther);
  EXPECT_EQ(session().phase, radio::Phase::idle);
  EXPECT_EQ(second().phase, radio::Phase::idle);
  EXPECT_EQ(state.radio.contact, kStored);
  EXPECT_TRUE(state.radio.errors.empty());
  EXPECT_FALSE(state.handover.order.has_value());
  EXPECT_TRUE(state.buffer.empty()) << "4.8.5.4 c";
  EXPECT_FALSE(state.track.revocable_tsr_inhibited) << "3.11.5.14";
  outbox = {};
  end_without_power(state, outbox);
  EXPECT_EQ(outbox.disconnect, kOther) << "one in a cycle";
  EXPECT_TRUE(state.radio.disconnect_later.empty());
  outbox = {};
  end_without_power(state, outbox);
  EXPECT_FALSE(outbox.disconnect.has_value());
}

}  // namespace
}  // namespace evc::kernel
