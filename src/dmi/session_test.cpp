#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "dmi/acks.h"
#include "dmi/dmi.h"
#include "dmi/drawing.h"
#include "dmi/test_display.h"

// What goes on over time: texts, acknowledgements, sounds, buttons, toggles, places of track conditions.
namespace evc::dmi {
namespace {

using port::AskedAck;
using port::Display;
using test::drawn;
using test::neutral;

class Session : public ::testing::Test {
 protected:
  void at(double seconds) {
    now = 100.0 + seconds;
    display.now = Duration{now};
    show(state, display);
  }
  void ask(Ack what, std::uint16_t id = 0) { EXPECT_TRUE(display.acks.push_back({what, id, display.now})); }
  void ask_at(double seconds, Ack what, std::uint16_t id = 0) {
    EXPECT_TRUE(display.acks.push_back({what, id, Duration{100.0 + seconds}}));
  }
  void withdraw(Ack what, std::uint16_t id = 0) {
    display.acks.erase_if([&](const AskedAck& asked) { return asked.what == what && asked.id == id; });
  }
  /// The name of the symbol or "text N" on offer; empty: nothing.
  std::string offered() const {
    if (!state.offered) return "";
    if (state.offered->ack.what == Ack::text) return "text " + std::to_string(state.offered->ack.id);
    return name(*ack_picture(state.display, state.offered->ack.what));
  }
  /// The driver acknowledges by touch; the on-board takes it.
  void acknowledge_at(double seconds) {
    at(seconds);
    ASSERT_TRUE(state.offered);
    const AskedAck ack = state.offered->ack;
    const Cell cell = test::middle(rect_of(place_of(ack.what).touch));
    ASSERT_TRUE(press(state, cell, Duration{now}));
    release(state, Duration{now});
    EXPECT_EQ(take(state).actions.acknowledged, 1u << static_cast<unsigned>(ack.what));
    withdraw(ack.what, ack.id);
    at(seconds);
  }
  std::vector<std::string> sounds() {
    std::vector<std::string> names;
    for (const SoundOrder& order : take(state).sounds)
      names.push_back(std::string(name(order.sound)) + (order.what == SoundDo::loop   ? " loop"
                                                        : order.what == SoundDo::stop ? " stop"
                                                                                      : ""));
    return names;
  }
  void text(std::uint16_t id, const std::string& words, int minute, bool important, bool acknowledged = false) {
    port::DisplayedText made{
        .id = id, .important = important, .acknowledge = acknowledged, .since = Duration{double(minute)}};
    made.minute_of_day = static_cast<std::uint16_t>(minute);
    made.length = static_cast<std::uint8_t>(words.size());
    std::copy(words.begin(), words.end(), made.characters.begin());
    EXPECT_TRUE(display.texts.push_back(made));
  }
  /// The lines of E5 to E9: "17:22 words" and "b" in front of bold ones.
  std::vector<std::string> lines() const {
    std::vector<std::string> found;
    Area last = Area::screen;
    const Screen screen = drawn(state);
    for (const Item& item : screen.items) {
      if (item.kind != Kind::text || item.area < Area::E5 || item.area > Area::E9) continue;
      const std::string words{item.text.view()};
      if (item.area == last)
        found.back() += " " + words;
      else
        found.push_back((item.bold ? "b " : "") + words);
      last = item.area;
    }
    return found;
  }
  bool shows(Picture picture) const { return test::find_symbol(drawn(state), picture) != nullptr; }

  State state;
  Display display = neutral(Mode::FS);
  double now = 100.0;
};

TEST_F(Session, TextsStandByGroupAndAge) {
  text(1, "A", 17 * 60 + 22, true);
  text(2, "B", 17 * 60 + 28, false);
  text(3, "C", 17 * 60 + 33, true);
  text(4, "D", 17 * 60 + 35, false);
  at(0);
  EXPECT_EQ(lines(), (std::vector<std::string>{"b 17:33 C", "b 17:22 A", "17:35 D", "17:28 B"}));
  EXPECT_TRUE(shows(Picture::NA15) && shows(Picture::NA16));
}

TEST_F(Session, LongTextsContinueBelow) {
  text(1, "No MA received at level transition", 1, true);
  at(0);
  const auto found = lines();
  ASSERT_GE(found.size(), 2u);
  std::string whole_text;
  const Screen screen = drawn(state);
  for (const Item& item : screen.items)
    if (item.kind == Kind::text && item.area >= Area::E5 && item.area <= Area::E9 && item.height == 12) {
      EXPECT_LE(absolute(item).x + width_of(item.text.view(), 12, true), 288.0);
      EXPECT_EQ(item.at.x, 49);
      whole_text += (whole_text.empty() ? "" : " ") + std::string(item.text.view());
    }
  EXPECT_EQ(whole_text, "No MA received at level transition");
}

TEST_F(Session, TextsScrollByLinesAndStop) {
  for (int i = 0; i < 7; ++i) text(static_cast<std::uint16_t>(i + 1), "t" + std::to_string(i), 600 + i, false);
  at(0);
  EXPECT_EQ(lines().front(), "10:06 t6");
  double when = now;
  for (int i = 0; i < 2; ++i) EXPECT_TRUE(test::tap(state, "E11", when));
  EXPECT_FALSE(test::tap(state, "E11", when));
  EXPECT_EQ(lines(), (std::vector<std::string>{"10:04 t4", "10:03 t3", "10:02 t2", "10:01 t1", "10:00 t0"}));
  EXPECT_TRUE(shows(Picture::NA13) && shows(Picture::NA16));
  display.texts.erase(0, 5);
  at(1);
  EXPECT_EQ(lines(), (std::vector<std::string>{"10:06 t6", "10:05 t5"})) << "nothing is left above";
}

TEST_F(Session, TextToAcknowledgeStandsAlone) {
  text(1, "Old", 600, true);
  at(-1);
  text(2, "X", 1053, true, true);
  ask(Ack::text, 2);
  at(0);
  EXPECT_EQ(lines(), std::vector<std::string>{"b 17:33 X"});
  EXPECT_TRUE(shows(Picture::NA15) && shows(Picture::NA16));
  const Screen screen = drawn(state);
  ASSERT_EQ(screen.flashing.size(), 1u);
  EXPECT_EQ(screen.flashing[0], Area::E5_E9);
  sounds();
  acknowledge_at(2);
  display.texts[1].acknowledge = false;
  at(2.1);
  EXPECT_EQ(lines(), (std::vector<std::string>{"b 17:33 X", "b 10:00 Old"}));
  EXPECT_TRUE(sounds().empty());
}

TEST_F(Session, TextsWaitWhileOneIsToBeAcknowledged) {
  text(1, "Old", 600, true);
  text(2, "X", 1053, true, true);
  ask(Ack::OS);
  at(0);
  ask(Ack::text, 2);
  at(0.1);
  EXPECT_EQ(offered(), "MO08");
  EXPECT_TRUE(lines().empty());
}

// 015560 8.2.3.4.7 h, 5.4.1.10: it is heard when it is displayed for the first time.
TEST_F(Session, AHiddenTextIsHeardWhenItAppears) {
  text(1, "hide", 1, true, true);
  ask(Ack::text, 1);
  at(0);
  EXPECT_EQ(sounds(), (std::vector<std::string>{"Sinfo"})) << "the acknowledgement";
  text(2, "hidden", 2, true);
  text(3, "gone", 3, true);
  at(1);
  EXPECT_TRUE(sounds().empty());
  display.texts.erase(2);
  at(2);
  withdraw(Ack::text, 1);
  display.texts.erase(0);
  at(3);
  EXPECT_EQ(lines(), (std::vector<std::string>{"b 00:02 hidden"}));
  EXPECT_EQ(sounds(), (std::vector<std::string>{"Sinfo"}));
  text(4, "gone before it is seen", 4, true);
  text(5, "hide", 5, true, true);
  ask(Ack::text, 5);
  at(4);
  (void)sounds();
  display.texts.erase(1, 3);
  withdraw(Ack::text, 5);
  at(6);
  EXPECT_TRUE(sounds().empty());
}

// 015560 Table 68: since 4.0.0 the text names the radio system.
TEST_F(Session, AFailedRegistrationNamesItsSystem) {
  port::DisplayedText failed{.id = 1, .kind = port::TextKind::status, .important = true};
  failed.status = StatusText::network_registration_failed;
  EXPECT_TRUE(display.texts.push_back(failed));
  at(0);
  EXPECT_EQ(lines().front().substr(0, 13), "b GSM-R netwo");
  display.config.srs = SrsVersion::v3_6_0;
  at(1);
  EXPECT_EQ(lines().front().substr(0, 13), "b Radio netwo");
}

// 015560 8.2.3.2.9: the abbreviation of the system instead of the letters NTC, with and without acknowledgement.
TEST_F(Session, AnAnnouncedSystemHasItsAbbreviation) {
  const auto in_C1 = [&] {
    const Screen screen = drawn(state);
    for (const Item& item : screen.items)
      if (item.area == Area::C1 && (item.kind == Kind::symbol || item.kind == Kind::text_symbol))
        return std::string(name(*item.picture)) + ' ' + std::string(item.text.view());
    return std::string();
  };
  port::NtcName pzb{.nid_ntc = 6};
  pzb.characters = {'P', 'Z', 'B'};
  EXPECT_TRUE(display.config.ntc_names.push_back(pzb));
  display.announced_level = port::AnnouncedLevel{Level::NTC, 6};
  at(0);
  EXPECT_EQ(in_C1(), "LE08 PZB");
  ask(Ack::level);
  at(1);
  EXPECT_EQ(in_C1(), "LE09 PZB");
  withdraw(Ack::level);
  display.announced_level->nid_ntc = 9;
  at(2);
  EXPECT_EQ(in_C1(), "LE08 ") << "without a name the letters of the symbol stand";
}

TEST_F(Session, TextOfAnyBytesIsDrawn) {
  for (int round = 0; round < 4; ++round) {
    std::string words;
    for (int i = 0; i < 255; ++i)
      words += static_cast<char>(round == 0 ? i : round == 1 ? 'W' : round == 2 ? ' ' : 200 + i % 50);
    text(static_cast<std::uint16_t>(round), words, round, round % 2 == 0);
  }
  at(0);
  EXPECT_EQ(lines().size(), 5u);
  while (can_scroll(state, false)) {
    ++state.scroll;
    ASSERT_LE(lines().size(), 5u);
  }
  EXPECT_GT(state.scroll, 20);
}

TEST_F(Session, AcksOfOneMomentAreOrderedByKind) {
  ask(Ack::OS);
  ask(Ack::level);
  display.announced_level = port::AnnouncedLevel{Level::L0, 0};
  at(0);
  EXPECT_EQ(offered(), "LE07");
}

TEST_F(Session, AcksOtherwiseByArrival) {
  ask_at(0, Ack::OS);
  at(0);
  ask_at(0.2, Ack::level);
  at(0.4);
  EXPECT_EQ(offered(), "MO08");
}

TEST_F(Session, NextAckComesASecondAfter) {
  text(7, "X", 1, true, true);
  ask(Ack::OS);
  ask(Ack::text, 7);
  at(0);
  EXPECT_EQ(offered(), "MO08");
  EXPECT_EQ(sounds(), std::vector<std::string>{"Sinfo"});
  acknowledge_at(3);
  at(3.5);
  EXPECT_EQ(offered(), "");
  EXPECT_TRUE(sounds().empty());
  at(4.05);
  EXPECT_EQ(offered(), "text 7");
  EXPECT_EQ(sounds(), std::vector<std::string>{"Sinfo"});
}

TEST_F(Session, RevokedAckGivesWay) {
  text(7, "X", 1, true, true);
  ask(Ack::OS);
  ask(Ack::text, 7);
  at(0);
  withdraw(Ack::OS);
  at(2);
  at(2.5);
  EXPECT_EQ(offered(), "");
  at(3.1);
  EXPECT_EQ(offered(), "text 7");
}

TEST_F(Session, AckQueueKeepsItsOrder) {
  text(1, "X", 1, true, true);
  text(2, "Y", 2, true, true);
  ask_at(0, Ack::text, 1);
  ask_at(0.5, Ack::text, 2);
  ask_at(1, Ack::SH);
  at(1);
  EXPECT_EQ(offered(), "text 1");
  acknowledge_at(2);
  at(3.1);
  EXPECT_EQ(offered(), "text 2");
  acknowledge_at(4);
  at(5.1);
  EXPECT_EQ(offered(), "MO02");
}

TEST_F(Session, FixedTextsComeBeforeOthersOfTheSameMoment) {
  using port::TextKind;
  text(1, "status", 1, true, true), text(2, "plain", 1, true, true), text(3, "", 1, true, true);
  display.texts[0].kind = TextKind::status;
  display.texts[2].kind = TextKind::fixed;
  ask(Ack::brake);
  ask(Ack::text, 1), ask(Ack::text, 2), ask(Ack::text, 3);
  at(0);
  EXPECT_EQ(offered(), "text 3");
}

TEST_F(Session, FrameFlashesTwiceASecond) {
  ask(Ack::OS);
  at(0);
  const auto frame = [&](double seconds) {
    const Screen screen = drawn(state, Duration{100.0 + seconds});
    return std::any_of(screen.items.begin(), screen.items.end(),
                       [](const Item& item) { return item.kind == Kind::frame && item.area == Area::C1; });
  };
  EXPECT_TRUE(frame(0.1));
  EXPECT_FALSE(frame(0.3));
  EXPECT_TRUE(frame(0.6));
  EXPECT_FALSE(frame(0.9));
}

TEST_F(Session, StaffResponsibleIsADelayButton) {
  ask(Ack::SR);
  at(0);
  const Cell cell = test::middle(rect_of(Area::C1));
  EXPECT_TRUE(press(state, cell, Duration{101.0}));
  release(state, Duration{102.5});
  EXPECT_EQ(offered(), "MO10");
  EXPECT_TRUE(press(state, cell, Duration{103.0}));
  release(state, Duration{105.2});
  EXPECT_EQ(offered(), "");
}

TEST_F(Session, BrakeIsAcknowledgedOnThreeAreas) {
  display.brake = true;
  ask(Ack::brake);
  at(0);
  EXPECT_EQ(drawn(state).flashing[0], Area::C9);
  ASSERT_TRUE(press(state, test::middle(rect_of(Area::E1)), Duration{101.0}));
  release(state, Duration{101.2});
  EXPECT_EQ(offered(), "");
  withdraw(Ack::brake);
  display.brake = false;
  take(state);
  at(1.3);
  EXPECT_TRUE(sounds().empty()) << "it was acknowledged";
}

TEST_F(Session, SlidOutAckDoesNothing) {
  ask(Ack::OS);
  at(0);
  ASSERT_TRUE(press(state, test::middle(rect_of(Area::C1)), Duration{101.0}));
  slide(state, {300, 200}, Duration{101.2});
  release(state, Duration{101.4});
  EXPECT_EQ(offered(), "MO08");
}

TEST_F(Session, StartUpHoldsAcksBack) {
  display.start_of_mission = true;
  at(0);
  ask(Ack::OS);
  at(1);
  EXPECT_EQ(offered(), "");
  display.start_of_mission = false;
  at(5);
  at(5.5);
  EXPECT_EQ(offered(), "");
  at(6.1);
  EXPECT_EQ(offered(), "MO08");
}

// 015560 11.7.1.9: also one of a brake, or where the on-board should take nothing else.
TEST_F(Session, InTheStartUpEveryAckWaits) {
  display.mode = Mode::SB;
  display.start_of_mission = true;
  display.step = Dialogue::start_S1;
  display.enabled = {DriverInput::ack_standstill, DriverInput::isolation};
  at(0);
  ASSERT_EQ(state.window, WindowId::driver_id);
  for (const Ack what : {Ack::brake, Ack::level, Ack::OS}) ask(what);
  ask(Ack::text, 7);
  for (int i = 1; i < 30; ++i) {
    at(i / 2.0);
    ASSERT_EQ(offered(), "");
    ASSERT_EQ(state.window, WindowId::driver_id);
  }
  EXPECT_EQ(take(state).actions.acknowledged, 0u);
  display.step = Dialogue::start_S10;
  display.start_of_mission = false;
  at(20);
  EXPECT_EQ(offered(), "");
  at(21.1);
  EXPECT_NE(offered(), "");
}

TEST_F(Session, AHeldFingerAnswersTheRequestThatItTouched) {
  ask(Ack::OS);
  at(0);
  ASSERT_EQ(offered(), "MO08");
  ASSERT_TRUE(press(state, test::middle(rect_of(Area::C1)), Duration{now}));
  withdraw(Ack::OS);
  at(0.1);
  ask(Ack::SH);
  at(1.2);
  ASSERT_EQ(offered(), "MO02");
  release(state, Duration{now});
  EXPECT_EQ(take(state).actions.acknowledged, 0u);
  EXPECT_EQ(offered(), "MO02");
}

TEST_F(Session, EntryIsLeftForAnAck) {
  display.mode = Mode::SB;
  display.buttons = test::all_buttons();
  at(0);
  double when = now;
  ASSERT_TRUE(test::tap(state, "F1", when));
  ASSERT_TRUE(test::tap(state, "Train data", when));
  EXPECT_EQ(state.window, WindowId::train_data);
  EXPECT_TRUE(take(state).windows.has(port::Window::train_data));
  ask(Ack::OS);
  at(1.1);
  EXPECT_EQ(state.window, WindowId::main);
  EXPECT_EQ(offered(), "");
  EXPECT_FALSE(test::tap(state, "Train data", when)) << "menus wait too";
  at(2.15);
  EXPECT_EQ(offered(), "MO08");
}

TEST_F(Session, AnswerThatIsLostIsAskedForAgain) {
  ask(Ack::OS);
  at(0);
  ASSERT_TRUE(press(state, test::middle(rect_of(Area::C1)), Duration{100.5}));
  release(state, Duration{100.6});
  at(3);
  EXPECT_EQ(offered(), "");
  at(6.5);
  EXPECT_EQ(offered(), "MO08");
}

TEST_F(Session, SoundsOfMonitoring) {
  struct Case {
    Mode mode;
    Monitoring from, to;
    Status before, after;
    std::vector<std::string> sounds;
  };
  using enum Monitoring;
  const std::vector<Case> cases{
      {Mode::FS, CSM, TSM, Status::Normal, Status::Normal, {"Sinfo"}},
      {Mode::LS, CSM, TSM, Status::Normal, Status::Normal, {}},
      {Mode::AD, CSM, TSM, Status::Normal, Status::Normal, {}},
      {Mode::FS, CSM, RSM, Status::Normal, Status::Indication, {"Sinfo"}},
      {Mode::FS, TSM, RSM, Status::Indication, Status::Indication, {}},
      {Mode::FS, TSM, TSM, Status::Indication, Status::Overspeed, {"S1"}},
      {Mode::FS, CSM, CSM, Status::Normal, Status::Overspeed, {}},
      {Mode::AD, TSM, TSM, Status::Indication, Status::Overspeed, {}},
      {Mode::FS, TSM, TSM, Status::Warning, Status::Indication, {"S2 stop"}},
      {Mode::FS, CSM, CSM, Status::Overspeed, Status::Warning, {"S2 loop"}},
      {Mode::SR, TSM, TSM, Status::Overspeed, Status::Warning, {"S2 loop"}},
      {Mode::AD, TSM, TSM, Status::Overspeed, Status::Warning, {}},
      {Mode::FS, TSM, TSM, Status::Warning, Status::Intervention, {"S2 stop"}},
  };
  for (const Case& c : cases) {
    state = State{};
    display = neutral(c.mode);
    display.monitoring = c.from;
    display.status = c.before;
    at(0);
    take(state);
    display.monitoring = c.to;
    display.status = c.after;
    at(0.1);
    EXPECT_EQ(sounds(), c.sounds) << name(c.mode) << static_cast<int>(c.from) << static_cast<int>(c.after);
  }
}

TEST_F(Session, SoundsOfSymbols) {
  at(0);
  display.monitoring = Monitoring::CSM;
  display.TTI = Duration{5.0};
  at(0.1);
  EXPECT_EQ(sounds(), std::vector<std::string>{"Sinfo"});
  text(1, "aux", 1, false);
  at(0.2);
  EXPECT_TRUE(sounds().empty());
  text(2, "important", 1, true);
  at(0.3);
  EXPECT_EQ(sounds(), std::vector<std::string>{"Sinfo"});
  display.brake = true;
  at(0.4);
  display.brake = false;
  at(0.5);
  EXPECT_EQ(sounds(), std::vector<std::string>{"Sinfo"});
  display.monitoring = Monitoring::TSM;
  at(0.6);
  take(state);
  display.MRDT = 1;
  at(0.7);
  EXPECT_EQ(sounds(), std::vector<std::string>{"Sinfo"});
  display.ato.warning_sound = true;
  at(0.8);
  EXPECT_EQ(sounds(), std::vector<std::string>{"S2 loop"});
}

// 015560 8.2.2.3.6: the driver's acknowledgement of the trip releases its brake; a brake that is released by itself is
// heard, in PT as everywhere.
TEST_F(Session, TheBrakeOfATripIsReleasedWithoutASound) {
  display.mode = Mode::TR;
  display.brake = true;
  at(0);
  ask(Ack::trip);
  at(0.1);
  acknowledge_at(1.2);
  take(state);
  display.mode = Mode::PT;
  display.brake = false;
  at(1.3);
  EXPECT_TRUE(sounds().empty());
  display.brake = true;
  at(1.4);
  display.brake = false;
  at(1.5);
  EXPECT_EQ(sounds(), std::vector<std::string>{"Sinfo"});
}

// Another brake than that of the trip goes on, and ends without the driver.
TEST_F(Session, ABrakeThatOutlastsTheTripIsHeard) {
  display.mode = Mode::TR;
  display.brake = true;
  at(0);
  display.mode = Mode::PT;
  at(0.1);
  take(state);
  display.brake = false;
  at(0.2);
  EXPECT_EQ(sounds(), std::vector<std::string>{"Sinfo"});
}

TEST_F(Session, UpButtonActsOnReleaseInside) {
  at(0);
  const Cell main = test::middle(rect_of(Area::F1));
  EXPECT_TRUE(press(state, main, Duration{100.1}));
  EXPECT_FALSE(press(state, test::middle(rect_of(Area::F2)), Duration{100.15})) << "one at a time";
  EXPECT_EQ(state.window, WindowId::default_);
  slide(state, {10, 10}, Duration{100.2});
  slide(state, main, Duration{100.3});
  release(state, Duration{100.4});
  EXPECT_EQ(state.window, WindowId::main);
  EXPECT_EQ(sounds(), std::vector<std::string>{"click"});
}

TEST_F(Session, DelayButtonBlinksAndHolds) {
  display.buttons = test::all_buttons();
  at(0);
  double when = now;
  ASSERT_TRUE(test::tap(state, "F1", when));
  const auto held = [&](double touch, double leave) {
    const Touch* place = test::find_touch(drawn(state), "Shunting");
    EXPECT_NE(place, nullptr);
    EXPECT_TRUE(press(state, test::middle(Rect{334, 215, 153, 50}), Duration{touch}));
    const auto pressed = [&](double at_time) {
      const Screen screen = drawn(state, Duration{touch + at_time});
      return test::find_item(screen, Kind::button, "Shunting")->pressed;
    };
    EXPECT_TRUE(pressed(0.1) && !pressed(0.3) && pressed(0.6) && !pressed(1.8) && pressed(2.1) && pressed(2.3));
    release(state, Duration{leave});
    return take(state).actions.has(port::Select::shunting);
  };
  EXPECT_FALSE(held(110.0, 111.9));
  EXPECT_TRUE(held(120.0, 122.4));
}

TEST_F(Session, DelayStartsAgainAfterSlidingOut) {
  display.buttons = test::all_buttons();
  at(0);
  double when = now;
  ASSERT_TRUE(test::tap(state, "F1", when));
  const Cell shunting = test::middle(Rect{334, 215, 153, 50});
  ASSERT_TRUE(press(state, shunting, Duration{110.0}));
  slide(state, {1, 1}, Duration{111.5});
  slide(state, shunting, Duration{111.6});
  release(state, Duration{113.0});
  EXPECT_FALSE(take(state).actions.has(port::Select::shunting));
}

TEST_F(Session, HeldDownButtonRepeats) {
  for (int i = 0; i < 20; ++i) text(static_cast<std::uint16_t>(i + 1), "t", 600 + i, false);
  at(0);
  const Cell down = test::middle(rect_of(Area::E11));
  ASSERT_TRUE(press(state, down, Duration{100.0}));
  release(state, Duration{101.4});
  EXPECT_EQ(state.scroll, 1);
  ASSERT_TRUE(press(state, down, Duration{200.0}));
  release(state, Duration{203.05});
  EXPECT_GE(state.scroll, 7);
  EXPECT_LE(state.scroll, 8);
}

// 015560 5.3.2.6.4, 5.3.2.6.5: pressed and at once enabled again, each time that it acts.
TEST_F(Session, DownButtonsAreSeenPressedOnlyWhenTheyAct) {
  for (int i = 0; i < 20; ++i) text(static_cast<std::uint16_t>(i + 1), "t", 600 + i, false);
  at(0);
  const Action down{ActionKind::scroll_down, 0};
  ASSERT_TRUE(press(state, test::middle(rect_of(Area::E11)), Duration{100.0}));
  for (const auto& [after, pressed] : std::vector<std::pair<double, bool>>{{0.0, true},
                                                                           {0.05, true},
                                                                           {0.2, false},
                                                                           {1.4, false},
                                                                           {1.51, true},
                                                                           {1.7, false},
                                                                           {1.81, true},
                                                                           {2.0, false}}) {
    tick(state, Duration{100.0 + after});
    EXPECT_EQ(looks_pressed(state, down, Duration{100.0 + after}), pressed) << after;
  }
}

TEST_F(Session, ToggleIsOffAtEveryEntry) {
  display.mode = Mode::OS;
  at(0);
  double when = now;
  EXPECT_TRUE(test::tap(state, "A", when));
  EXPECT_TRUE(state.toggles.speed);
  EXPECT_TRUE(take(state).actions.has(port::Select::toggle));
  EXPECT_TRUE(test::tap(state, "B", when));
  EXPECT_FALSE(state.toggles.speed);
  EXPECT_TRUE(test::tap(state, "A", when));
  display.mode = Mode::FS;
  at(1);
  EXPECT_EQ(test::find_touch(drawn(state), "A"), nullptr);
  display.mode = Mode::OS;
  at(2);
  EXPECT_FALSE(state.toggles.speed);
}

// 015560 8.2.2.5.7: the time to Indication is heard when it is displayed, also on the driver's request.
TEST_F(Session, ToggledTimeToIndicationIsHeard) {
  for (const Mode mode : {Mode::OS, Mode::SR}) {
    state = State{};
    display = neutral(mode);
    display.monitoring = Monitoring::CSM;
    display.TTI = Duration{5.0};
    at(0);
    EXPECT_TRUE(sounds().empty());
    double when = now;
    EXPECT_TRUE(test::tap(state, "A", when));
    EXPECT_EQ(sounds(), std::vector<std::string>{"Sinfo"});
    at(1);
    EXPECT_TRUE(sounds().empty());
    when = now;
    EXPECT_TRUE(test::tap(state, "B", when));
    EXPECT_TRUE(sounds().empty());
  }
}

// 5.18.8.2: of a tunnel stopping area of the outputs the driver sees a place to touch, until he asks for it.
TEST_F(Session, ATunnelStoppingAreaIsShownOnRequest) {
  display.mode = Mode::FS;
  display.tunnel = port::TunnelStoppingArea{false, Distance{500.0}};
  at(0);
  EXPECT_TRUE(shows(Picture::DR05));
  EXPECT_FALSE(shows(Picture::TC37));
  double when = now;
  EXPECT_TRUE(test::tap(state, "C2+C3+C4", when));
  EXPECT_FALSE(shows(Picture::DR05));
  EXPECT_TRUE(shows(Picture::TC37));
  display.tunnel->inside = true;
  at(10);
  EXPECT_TRUE(shows(Picture::TC36));
  when = now;
  EXPECT_TRUE(test::tap(state, "C2+C3+C4", when));
  EXPECT_TRUE(shows(Picture::DR05));
  EXPECT_FALSE(shows(Picture::TC36));
  EXPECT_FALSE(take(state).actions.has(port::Select::toggle));  // that of speeds
  display.tunnel.reset();
  at(20);
  EXPECT_FALSE(shows(Picture::DR05));
}

// The on-board has a toggle of its own (4.7.2): both stay in step, however often the driver touches in a cycle.
TEST_F(Session, TheOnBoardTogglesAsTheDisplayDoes) {
  display.mode = Mode::SR;
  bool on_board = false;
  double when = 100.0;
  for (int cycle = 0; cycle < 12; ++cycle) {
    at(10.0 * cycle);
    when = now;
    for (int touch = 0; touch < cycle % 4; ++touch) ASSERT_TRUE(test::tap(state, touch % 2 == 0 ? "A" : "B", when));
    if (take(state).actions.has(port::Select::toggle)) on_board = !on_board;
    EXPECT_EQ(state.toggles.speed, on_board) << cycle;
  }
}

TEST_F(Session, ConditionsKeepTheirPlaces) {
  using port::DisplayedCondition;
  for (const auto& condition : {DisplayedCondition{1, Picture::TC03, {}}, DisplayedCondition{2, Picture::TC07, {}},
                                DisplayedCondition{3, Picture::LX01, {}}, DisplayedCondition{4, Picture::TC35, {}}})
    EXPECT_TRUE(display.conditions.push_back(condition));
  at(0);
  const auto area = [&](Picture picture) {
    const Screen screen = drawn(state);
    const Item* item = test::find_symbol(screen, picture);
    return item == nullptr ? std::string{} : std::string{name(item->area)};
  };
  EXPECT_EQ(area(Picture::TC03), "B3");
  EXPECT_EQ(area(Picture::TC07), "B4");
  EXPECT_EQ(area(Picture::LX01), "B5");
  EXPECT_EQ(area(Picture::TC35), "");
  display.conditions.erase(1);
  at(1);
  EXPECT_EQ(area(Picture::TC35), "B4");
  EXPECT_EQ(area(Picture::LX01), "B5");
}

TEST_F(Session, DiscontinuitiesOverlapByImportance) {
  display.monitoring = Monitoring::CSM;
  display.indication_target = Distance{1000.0};
  for (const auto& [metres, kmh] :
       {std::pair{0.0, 160.0}, std::pair{1000.0, 100.0}, std::pair{1010.0, 90.0}, std::pair{1020.0, 120.0}})
    EXPECT_TRUE(display.planning.speeds.push_back({Distance{metres}, Speed{kmh / 3.6}, {}}));
  at(0);
  std::vector<std::string> drawn_in_order;
  const Screen screen = drawn(state);
  for (const Item& item : screen.items)
    if (item.kind == Kind::symbol && item.area == Area::D6_D7) drawn_in_order.emplace_back(name(*item.picture));
  EXPECT_EQ(drawn_in_order, (std::vector<std::string>{"PL21", "PL22", "PL23"}));
}

// Numbers of the planning area are legible: none is drawn over another one, what is on top keeps its number.
TEST_F(Session, NumbersOfDiscontinuitiesDoNotOverlap) {
  const auto numbers = [&] {
    std::vector<std::pair<std::string, std::int16_t>> found;
    const Screen screen = drawn(state);
    for (const Item& item : screen.items)
      if (item.kind == Kind::text && item.area == Area::D7)
        found.emplace_back(std::string{item.text.view()}, absolute(item).y);
    return found;
  };
  // Decreases near the end of the authority: the nearer is on top.
  for (const auto& [metres, kmh] : {std::pair{0.0, 160.0}, std::pair{3400.0, 100.0}, std::pair{3900.0, 60.0}})
    EXPECT_TRUE(display.planning.speeds.push_back({Distance{metres}, Speed{kmh / 3.6}, {}}));
  display.planning.EOA = Distance{4000.0};
  at(0);
  const auto shown = numbers();
  ASSERT_EQ(shown.size(), 1U);
  EXPECT_EQ(shown[0].first, "100");
  // The target of the indication marker is on top of a nearer one.
  display.indication_target = Distance{4000.0};
  display.monitoring = Monitoring::CSM;
  display.planning.speeds.erase(1);
  at(1);
  ASSERT_EQ(numbers().size(), 1U);
  EXPECT_EQ(numbers()[0].first, "0");
  // At one place the lower speed.
  display.indication_target.reset();
  display.planning.speeds[1].at = Distance{4000.0};
  at(2);
  ASSERT_EQ(numbers().size(), 1U);
  EXPECT_EQ(numbers()[0].first, "0");
  // Far enough from one another each has its number.
  display.planning.speeds[1].at = Distance{2000.0};
  at(3);
  EXPECT_EQ(numbers().size(), 2U);
}

}  // namespace
}  // namespace evc::dmi
