#include "dmi/windows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "dmi/commit.h"
#include "dmi/dmi.h"
#include "dmi/entry.h"
#include "dmi/labels.h"
#include "dmi/test_display.h"
#include "dmi/touch.h"

// Windows, data entry and dialogues.
namespace evc::dmi {
namespace {

using port::Display;
using port::Waiting;
using test::drawn;

class Windows : public ::testing::Test {
 protected:
  Windows() {
    display.buttons = test::all_buttons();
    display.level_valid = true;
    display.level = Level::L1;
    display.data.stored.level_status = DataStatus::valid;
    display.data.levels = 0x1F;
    cycle(0.0);
  }
  void cycle(double seconds) {
    when += seconds;
    display.now = Duration{when};
    show(state, display);
  }
  bool tap(const std::string& name) { return test::tap(state, name, when); }
  void keys(const std::string& numbers) {
    for (const char key : numbers) EXPECT_TRUE(tap(key == '0' ? "key 11" : std::string("key ") + key)) << key;
  }
  std::string field_text(int number) const {
    const Screen screen = drawn(state, Duration{when});
    for (const Item& item : screen.items)
      if (item.kind == Kind::field && item.number == number) return std::string(item.text.view());
    return "no field";
  }
  const Item& item(Kind kind, const std::string& name) {
    last = drawn(state, Duration{when});
    const Item* found = test::find_item(last, kind, name);
    EXPECT_NE(found, nullptr) << name;
    static const Item kNone;
    return found != nullptr ? *found : kNone;
  }
  void open(WindowId window) { open_window(state, window); }

  Display display = test::neutral();
  State state;
  Screen last;
  double when = 100.0;
};

TEST_F(Windows, PartsHaveTheirPlaces) {
  open(WindowId::main);
  EXPECT_EQ(absolute(item(Kind::rect, "title")), (Rect{334, 15, 306, 24}));
  EXPECT_EQ(absolute(item(Kind::button, "Start")), (Rect{334, 65, 153, 50}));
  EXPECT_EQ(absolute(item(Kind::button, "Driver ID")), (Rect{487, 65, 153, 50}));
  EXPECT_EQ(absolute(item(Kind::button, "Radio data")), (Rect{487, 265, 153, 50}));
  EXPECT_EQ(item(Kind::button, "close").picture, Picture::NA11);
  open(WindowId::train_data);
  EXPECT_EQ(absolute(item(Kind::rect, "title")), (Rect{0, 15, 334, 24}));
  EXPECT_EQ(absolute(item(Kind::field, "Train category")), (Rect{334, 15, 306, 50}));
  EXPECT_EQ(absolute(Area::full, item(Kind::field, "Maximum speed (km/h)").data_at), (Rect{538, 165, 102, 50}));
  EXPECT_EQ(item(Kind::rect, "title").text.view(), "Train data (1/2)");
  EXPECT_EQ(item(Kind::echo, "Length (m)").baseline, 151);
}

TEST_F(Windows, HourGlassWanders) {
  open(WindowId::main);
  display.waiting = Waiting::session;
  display.start_of_mission = true;
  cycle(0.0);
  const double begin = when;
  for (const auto& [seconds, x] :
       {std::pair{0.0, 376}, std::pair{3.5, 454}, std::pair{9.5, 610}, std::pair{10.5, 376}}) {
    when = begin + seconds;
    last = drawn(state, Duration{when});
    const Item* glass = test::find_symbol(last, Picture::ST05);
    ASSERT_NE(glass, nullptr);
    EXPECT_EQ(absolute(*glass).x, x);
    EXPECT_EQ(absolute(*glass).y, 17);
  }
  for (const Touch& touch : last.touch) EXPECT_FALSE(touch.enabled) << touch.name.view();
}

// 015560 11.2.5.6: in Radio data as in Main, from 42 on; below it is its own ground, not the end of the title.
TEST_F(Windows, HourGlassOfRadioDataHasThePlacesOfMain) {
  open(WindowId::radio_data);
  display.waiting = Waiting::radio_registration;
  cycle(0.0);
  const double begin = when;
  for (int second = 0; second < 30; ++second) {
    when = begin + second + 0.2;
    last = drawn(state, Duration{when});
    const Item* glass = test::find_symbol(last, Picture::ST05);
    ASSERT_NE(glass, nullptr);
    EXPECT_EQ(absolute(*glass), (Rect{static_cast<std::int16_t>(376 + 26 * (second % 10)), 17, 20, 20}));
    const Item* ground = glass - 1;
    EXPECT_TRUE(ground->kind == Kind::rect && ground->colour == Colour::black && ground->at == glass->at);
  }
}

// 3.6.0 has one radio network and calls it so; in 4.0.0 there is that of FRMCS beside it.
TEST_F(Windows, RadioNetworkIsNamedByTheEdition) {
  EXPECT_TRUE(display.data.networks.push_back(0x26210Fu));
  for (const auto& [srs, called] : {std::pair{SrsVersion::v3_6_0, std::string("Radio network ID")},
                                    std::pair{SrsVersion::v4_0_0, std::string("GSM-R network ID")}}) {
    display.config.srs = srs;
    cycle(0.1);
    open(WindowId::radio_data);
    EXPECT_EQ(item(Kind::button, called).text.view(), called);
    EXPECT_EQ(item(Kind::button, called).number, 6);
    ASSERT_NE(test::find_touch(last, called), nullptr);
    open(WindowId::network_id);
    EXPECT_EQ(item(Kind::rect, "title").text.view(), called);
    EXPECT_EQ(last.window.view(), called);
    EXPECT_EQ(item(Kind::field, called).number, 1);
  }
}

TEST_F(Windows, DisabledButtonsDoNothing) {
  display.buttons = {};
  cycle(0.1);
  for (const WindowId window :
       {WindowId::main, WindowId::override_, WindowId::special, WindowId::settings, WindowId::radio_data}) {
    open(window);
    for (const MenuButton& button : menu_buttons(state, window)) {
      EXPECT_FALSE(press(state, test::middle(menu_place(button.number)), Duration{when}));
      when += 3.0;
      release(state, Duration{when});
      choose(state, button.button, Duration{when});
      EXPECT_EQ(state.window, window);
      EXPECT_EQ(take(state).actions.selected, 0u);
    }
  }
}

TEST_F(Windows, EveryMenuButtonActs) {
  for (const WindowId window :
       {WindowId::main, WindowId::override_, WindowId::special, WindowId::settings, WindowId::radio_data})
    for (const MenuButton& button : menu_buttons(state, window)) {
      open(window);
      EXPECT_TRUE(tap(name(button.button))) << name(button.button);
      const Commands commands = take(state);
      EXPECT_TRUE(state.window != window || commands.actions.selected != 0) << name(button.button);
      state.awaited = Awaited{};
    }
}

TEST_F(Windows, RunningNumberIsTyped) {
  display.data.stored.train_running_number_status = DataStatus::valid;
  display.data.stored.train_running_number = static_cast<std::uint32_t>(to_bcd("45678", 8));
  cycle(0.1);
  ASSERT_TRUE(tap("F1") && tap("Train running number"));
  EXPECT_EQ(field_text(1), "45678");
  keys("9");
  EXPECT_EQ(field_text(1), "9") << "the first key replaces";
  keys("1023456");
  EXPECT_EQ(field_text(1), "9102 3456");
  ASSERT_TRUE(tap("key 10"));
  EXPECT_EQ(field_text(1), "9102 345");
  ASSERT_TRUE(tap("field 1"));
  EXPECT_EQ(take(state).actions.train_running_number, 0x9102345Fu);
  EXPECT_EQ(state.window, WindowId::main);
}

// 015560 10.3.2.5: held, a key with letters goes on to the next one; meanwhile the cursor waits below the character.
TEST_F(Windows, LettersByAHeldKey) {
  open(WindowId::driver_id);
  const auto typed = [&] { return std::string(state.entry.fields[0].value.typed.view()); };
  const auto cursor = [&](double at) {
    last = drawn(state, Duration{at});
    for (const Item& item : last.items)
      if (item.kind == Kind::cursor) return static_cast<int>(absolute(item).x);
    return 0;
  };
  const int begin = cursor(200.0);
  ASSERT_TRUE(press(state, test::middle(key_place(2)), Duration{200.0}));
  EXPECT_EQ(typed(), "2");
  EXPECT_EQ(cursor(201.0), begin);
  for (const auto& [at, expected] : {std::pair{201.4, "2"}, {201.6, "a"}, {201.9, "b"}, {202.2, "c"}, {202.5, "2"}}) {
    tick(state, Duration{at});
    EXPECT_EQ(typed(), expected) << at;
  }
  release(state, Duration{202.5});
  tick(state, Duration{204.6});
  EXPECT_GT(cursor(205.0), begin);
  // A key with one character is none to hold, nor are those of numbers.
  ASSERT_TRUE(press(state, test::middle(key_place(1)), Duration{206.0}));
  tick(state, Duration{209.0});
  EXPECT_EQ(typed(), "21");
  release(state, Duration{209.0});
  open(WindowId::train_running_number);
  ASSERT_TRUE(press(state, test::middle(key_place(2)), Duration{210.0}));
  tick(state, Duration{213.0});
  EXPECT_EQ(typed(), "2");
}

// 015560 10.3.1.22: the data part of the field that is selected is [Enter], its label is not.
TEST_F(Windows, TheLabelDoesNotAccept) {
  open(WindowId::sr_data);
  keys("40");
  const Rect field = full_field(1);
  EXPECT_FALSE(press(state, {field.x + 100, field.y + 25}, Duration{when}));
  EXPECT_FALSE(state.entry.fields[0].accepted);
  ASSERT_TRUE(tap("field 1"));
  EXPECT_TRUE(state.entry.fields[0].accepted);
  EXPECT_EQ(state.entry.selected, 1);
  ASSERT_TRUE(press(state, {field.x + 100, field.y + 25}, Duration{when})) << "it selects (10.3.1.26)";
  release(state, Duration{when});
  EXPECT_EQ(state.entry.selected, 0);
}

// 015560 11.7.3 S5-2: the hour glass until there is a list, then until the network is registered.
TEST_F(Windows, NetworksAreAwaitedInTheRadioDataWindow) {
  display.radio = RadioIndication::up;
  for (const std::uint32_t network : {0x26210Fu, 0x23414Fu}) EXPECT_TRUE(display.data.networks.push_back(network));
  cycle(0.1);
  const auto disabled = [&] {
    last = drawn(state, Duration{when});
    return std::none_of(last.touch.begin(), last.touch.end(), [](const Touch& touch) { return touch.enabled; });
  };
  ASSERT_TRUE(tap("F1") && tap("Radio data") && tap("GSM-R network ID"));
  EXPECT_EQ(state.window, WindowId::radio_data);
  EXPECT_TRUE(disabled());
  EXPECT_TRUE(take(state).actions.has(port::Select::radio_network));
  display.waiting = Waiting::network_list;
  cycle(0.1);
  EXPECT_TRUE(disabled());
  display.waiting = Waiting::nothing;
  cycle(5.0);
  EXPECT_EQ(state.window, WindowId::network_id);
  ASSERT_TRUE(tap("key 2") && tap("field 1"));
  EXPECT_EQ(take(state).actions.network, 0x23414Fu);
  EXPECT_EQ(state.window, WindowId::radio_data);
  EXPECT_TRUE(disabled());
  display.waiting = Waiting::radio_registration;
  cycle(0.1);
  EXPECT_TRUE(disabled());
  display.waiting = Waiting::nothing;
  display.radio = RadioIndication::none;  // the choice has ended the session
  cycle(5.0);
  EXPECT_EQ(state.window, WindowId::radio_data);
  ASSERT_TRUE(tap("GSM-R network ID"));
  EXPECT_EQ(state.window, WindowId::network_id) << "the list is there at once";
  display.data.networks.clear();
  cycle(0.1);
  open(WindowId::radio_data);
  ASSERT_TRUE(tap("GSM-R network ID"));
  EXPECT_EQ(state.window, WindowId::main) << "an empty list: A5, D9";
}

TEST_F(Windows, LettersByMultiTap) {
  open(WindowId::driver_id);
  const auto key = [&](int number, double at) {
    EXPECT_TRUE(press(state, test::middle(key_place(number)), Duration{at}));
    release(state, Duration{at + 0.05});
  };
  key(2, 200.0), key(2, 201.0), key(3, 201.5);
  EXPECT_EQ(state.entry.fields[0].value.typed.view(), "a3");
  open(WindowId::driver_id);
  key(2, 300.0), key(2, 302.5);
  EXPECT_EQ(state.entry.fields[0].value.typed.view(), "22");
  when = 303.0;
  ASSERT_TRUE(tap("field 1"));
  EXPECT_EQ(take(state).actions.driver_id->view(), "22");
}

TEST_F(Windows, FieldsAreSelectedAndAccepted) {
  open(WindowId::train_data);
  EXPECT_EQ(item(Kind::field, "Train category").state, FieldState::selected);
  EXPECT_EQ(item(Kind::field, "Length (m)").colour, Colour::grey);
  EXPECT_FALSE(item(Kind::button, "Yes").enabled);
  ASSERT_TRUE(tap("key 5") && tap("field 1"));
  EXPECT_EQ(item(Kind::field, "Train category").state, FieldState::accepted);
  EXPECT_EQ(item(Kind::echo, "Train category").colour, Colour::white);
  EXPECT_EQ(item(Kind::field, "Length (m)").state, FieldState::selected);
  keys("1");
  ASSERT_TRUE(tap("field 3"));
  EXPECT_EQ(item(Kind::field, "Length (m)").text.view(), "") << "not accepted: erased";
}

// 015560 10.3.1.19 to 10.3.1.21, 10.3.3.3: the echo text has the data value, which keys do not change until Enter, and
// which is lost when another field is selected before.
TEST_F(Windows, EchoesHaveTheDataValueUntilItIsReplaced) {
  display.data.stored.train_status = DataStatus::valid;
  display.data.stored.train.L_TRAIN = Distance{200.0};
  cycle(0.1);
  open(WindowId::train_data);
  const auto echo = [&](const char* words, Colour colour) {
    const Item& length = item(Kind::echo, "Length (m)");
    EXPECT_EQ(length.text.view(), words);
    EXPECT_TRUE(length.text.empty() || length.colour == colour);
  };
  ASSERT_TRUE(tap("field 2"));
  echo("200", Colour::grey);
  keys("31");
  EXPECT_EQ(field_text(2), "31");
  echo("200", Colour::grey);
  ASSERT_TRUE(tap("field 2"));
  echo("31", Colour::white);
  ASSERT_TRUE(tap("field 2"));
  keys("9");
  echo("31", Colour::white);
  keys("999");
  ASSERT_TRUE(tap("field 2"));
  echo("++++", Colour::red);
  keys("4");
  echo("", Colour::grey);  // what a check has rejected is no value
  ASSERT_TRUE(tap("field 2") && tap("field 2"));
  keys("5");
  ASSERT_TRUE(tap("field 3"));
  EXPECT_EQ(field_text(2), "");
  echo("", Colour::grey);
}

TEST_F(Windows, RangesAreChecked) {
  open(WindowId::train_data);
  ASSERT_TRUE(tap("field 2"));
  keys("9999");
  ASSERT_TRUE(tap("field 2"));
  EXPECT_EQ(item(Kind::echo, "Length (m)").text.view(), "++++");
  EXPECT_EQ(item(Kind::echo, "Length (m)").colour, Colour::red);
  EXPECT_FALSE(tap("field 2")) << "until a key is pressed";
  EXPECT_FALSE(tap("next"));
  state.display.config.L_TRAIN.operational_most = 750.0;
  keys("0800");
  ASSERT_TRUE(tap("field 2"));
  EXPECT_EQ(item(Kind::echo, "Length (m)").colour, Colour::yellow);
  EXPECT_EQ(item(Kind::field, "Length (m)").type, ButtonType::delay);
  ASSERT_TRUE(tap("field 2")) << "the driver insists";
  EXPECT_EQ(item(Kind::field, "Length (m)").state, FieldState::accepted);
}

// A code has 24 bits, whether a cover is set with it or removed (015560 11.3.12.5, 11.3.13.5).
TEST_F(Windows, CodesOfCoversHaveTheirRange) {
  for (const WindowId window : {WindowId::set_vbc, WindowId::remove_vbc}) {
    open(window);
    keys("16777216");
    ASSERT_TRUE(tap("field 1"));
    EXPECT_EQ(item(Kind::echo, "VBC code").text.view(), "++++") << row_of(window).title;
    EXPECT_FALSE(tap("Yes")) << row_of(window).title;
    keys("16777215");
    ASSERT_TRUE(tap("field 1"));
    EXPECT_TRUE(tap("Yes")) << row_of(window).title;
  }
}

TEST_F(Windows, TheSelectorOfAutomaticDrivingHasItsTitle) {  // 015560 11.3.14.2
  open(WindowId::ato);
  EXPECT_EQ(drawn(state).window.view(), "ATO selector");
}

class TrainData : public Windows {
 protected:
  void enter_all() {
    ASSERT_TRUE(tap("F1") && tap("Train data"));
    ASSERT_TRUE(tap("key 1") && tap("field 1"));
    keys("400");
    ASSERT_TRUE(tap("field 2"));
    keys("120");
    ASSERT_TRUE(tap("field 3"));
    keys("140");
    ASSERT_TRUE(tap("field 4"));
    ASSERT_EQ(state.page, 1);
    ASSERT_TRUE(tap("key 4") && tap("field 5") && tap("key 8") && tap("field 6") && tap("key 2") && tap("field 7"));
  }
};

TEST_F(TrainData, GoToTheOnBoardAfterValidation) {
  enter_all();
  ASSERT_TRUE(tap("Yes"));
  EXPECT_EQ(state.window, WindowId::validate_train_data);
  EXPECT_FALSE(take(state).train_data);
  ASSERT_TRUE(tap("field 1"));
  const auto commands = take(state);
  ASSERT_TRUE(commands.train_data);
  EXPECT_EQ(commands.train_data->L_TRAIN, Distance{400.0});
  EXPECT_EQ(commands.train_data->V_MAXTRAIN.si, 140.0 / 3.6);
  EXPECT_EQ(commands.train_data->brake_percentage, 120.0);
  EXPECT_EQ(commands.train_data->cant_deficiency_mm, 80);
  EXPECT_EQ(commands.train_data->other_categories, train::kPassenger);
  EXPECT_EQ(commands.train_data->axle_load, train::AxleLoad::B2);
  EXPECT_TRUE(commands.train_data->airtight);
  EXPECT_EQ(commands.train_data->loading_gauge, train::LoadingGauge::GA);
  EXPECT_EQ(state.window, WindowId::train_running_number) << "it is not valid";
  const train::TrainData data = with_entered(train::TrainData{}, *commands.train_data);
  EXPECT_EQ(data.L_TRAIN, Distance{400.0});
}

// SUBSET-026-3 3.18.3.2.2: traction systems and axles are never entered by the driver; they stay those of the train, as
// all that is no field of the window.
TEST_F(TrainData, LeaveWhatTheDriverNeverEnters) {
  train::TrainData before;
  ASSERT_TRUE(before.traction_systems.push_back({3, 77}));
  before.axles = 64;
  before.M_rotating_nom = 6.5;
  display.data.stored.train_status = DataStatus::valid;
  cycle(0.1);
  enter_all();
  ASSERT_TRUE(tap("Yes") && tap("field 1"));
  const auto commands = take(state);
  ASSERT_TRUE(commands.train_data);
  const train::TrainData after = with_entered(before, *commands.train_data);
  EXPECT_FALSE(after == before);
  train::TrainData rest = after;  // with the fields of the window as they were
  rest.L_TRAIN = before.L_TRAIN;
  rest.V_MAXTRAIN = before.V_MAXTRAIN;
  rest.brake_percentage = before.brake_percentage;
  rest.cant_deficiency_mm = before.cant_deficiency_mm;
  rest.other_categories = before.other_categories;
  rest.brake_position = before.brake_position;
  rest.axle_load = before.axle_load;
  rest.loading_gauge = before.loading_gauge;
  rest.airtight = before.airtight;
  EXPECT_TRUE(rest == before);
}

// SUBSET-026-3 3.18.3.2: with brake model gamma the train has no brake percentage that anybody could enter.
TEST_F(TrainData, HaveABrakePercentageWithTheConversionModelAlone) {
  display.config.asks_brake_percentage = false;
  display.data.stored.train_status = DataStatus::valid;
  cycle(0.1);
  open(WindowId::train_data);
  for (const Field& field : state.entry.fields) EXPECT_NE(field.id, FieldId::brake_percentage);
  EXPECT_EQ(state.entry.fields.size(), 6u);
  EXPECT_FALSE(entered_train_data(state, state.entry).brake_percentage);
  for (const ViewItem& line : view_items(state))
    EXPECT_NE(line.label.view(), label(FieldId::brake_percentage, SrsVersion::v4_0_0));
  display.config.asks_brake_percentage = true;
  cycle(0.1);
  open(WindowId::train_data);
  EXPECT_EQ(state.entry.fields.size(), 7u);
}

TEST_F(TrainData, AreNotStoredAfterNo) {
  enter_all();
  ASSERT_TRUE(tap("Yes") && tap("key 7") && tap("field 1"));
  EXPECT_FALSE(take(state).train_data);
  EXPECT_EQ(state.window, WindowId::train_data);
  EXPECT_EQ(state.page, 0);
  EXPECT_EQ(field_text(2), "400");
}

// The process goes on until the validation is left with Yes (015560 10.6.1.3): what was accepted stays white.
TEST_F(TrainData, StayAcceptedAfterNo) {
  enter_all();
  ASSERT_TRUE(tap("Yes") && tap("key 7") && tap("field 1"));
  EXPECT_EQ(item(Kind::field, "Train category").state, FieldState::selected);
  EXPECT_EQ(item(Kind::field, "Length (m)").state, FieldState::accepted);
  EXPECT_EQ(item(Kind::echo, "Length (m)").colour, Colour::white);
  ASSERT_TRUE(tap("close") && tap("Train data"));
  EXPECT_EQ(item(Kind::field, "Length (m)").state, FieldState::not_selected) << "another process";
}

TEST_F(TrainData, AreCheckedAcross) {
  port::CrossCheck check{.categories = Set<TrainCategory>{TrainCategory::PASS1}, .V_most = Speed{120.0 / 3.6}};
  EXPECT_TRUE(display.config.cross_checks.push_back(check));
  cycle(0.1);
  enter_all();
  ASSERT_TRUE(tap("Yes"));
  EXPECT_EQ(state.window, WindowId::train_data);
  EXPECT_EQ(item(Kind::echo, "Train category").text.view(), "????");
  EXPECT_EQ(item(Kind::echo, "Maximum speed (km/h)").colour, Colour::red);
  EXPECT_FALSE(tap("Yes"));
  state.display.config.cross_checks[0].operational = true;
  ASSERT_TRUE(tap("key 1") && tap("field 1") && tap("Yes"));
  EXPECT_EQ(item(Kind::echo, "Train category").colour, Colour::yellow);
  ASSERT_TRUE(tap("Yes")) << "a delay button now";
  EXPECT_EQ(state.window, WindowId::validate_train_data);
}

// 015560 10.3.4.6.5: who insists overrules the rule that was shown, not another one that was not reached.
TEST_F(TrainData, EachOperationalRuleIsOverruledAlone) {
  const Set<TrainCategory> first{TrainCategory::PASS1};
  for (const double kmh : {120.0, 130.0})
    EXPECT_TRUE(
        display.config.cross_checks.push_back({.categories = first, .V_most = Speed{kmh / 3.6}, .operational = true}));
  cycle(0.1);
  enter_all();
  for (int rule = 0; rule < 2; ++rule) {
    ASSERT_TRUE(tap("Yes"));
    EXPECT_EQ(state.window, WindowId::train_data) << rule;
    EXPECT_EQ(item(Kind::echo, "Train category").text.view(), "????") << rule;
    EXPECT_EQ(item(Kind::button, "Yes").type, ButtonType::delay) << rule;
  }
  ASSERT_TRUE(tap("Yes"));
  EXPECT_EQ(state.window, WindowId::validate_train_data);
  EXPECT_EQ(item(Kind::echo, "Train category").text.view(), "PASS 1") << "permitted now";
  EXPECT_EQ(item(Kind::echo, "Train category").colour, Colour::white);
  // A value that changes is checked again.
  ASSERT_TRUE(tap("key 7") && tap("field 1") && tap("key 1") && tap("field 1") && tap("Yes"));
  EXPECT_EQ(state.window, WindowId::train_data);
  EXPECT_EQ(item(Kind::echo, "Train category").text.view(), "????");
}

TEST_F(TrainData, CloseWhenTheTrainMoves) {
  enter_all();
  display.buttons.remove(Button::train_data);
  cycle(0.1);
  EXPECT_EQ(state.window, WindowId::main);
}

// 015560 11.7.1.7, Table 48: also the window of the train running number that follows train data (11.7.3 S3-3).
TEST_F(TrainData, TheRunningNumberAfterThemClosesWhenTheTrainMoves) {
  enter_all();
  ASSERT_TRUE(tap("Yes") && tap("field 1"));
  ASSERT_EQ(state.window, WindowId::train_running_number);
  cycle(0.1);
  EXPECT_EQ(state.window, WindowId::train_running_number);
  display.buttons.remove(Button::train_running_number);
  cycle(0.1);
  EXPECT_EQ(state.window, WindowId::main);
}

// 015560 10.3.4.4.4: a field that is accepted anew is enough.
TEST_F(TrainData, AreCheckedAcrossAgainOnceAFieldIsAccepted) {
  EXPECT_TRUE(display.config.cross_checks.push_back(
      {.categories = Set<TrainCategory>{TrainCategory::PASS1}, .V_most = Speed{120.0 / 3.6}}));
  cycle(0.1);
  enter_all();
  ASSERT_TRUE(tap("Yes"));
  EXPECT_FALSE(tap("Yes"));
  ASSERT_TRUE(tap("field 1"));
  EXPECT_EQ(item(Kind::echo, "Train category").text.view(), "PASS 1");
  ASSERT_TRUE(tap("Yes"));
  EXPECT_EQ(item(Kind::echo, "Train category").text.view(), "????");
}

TEST_F(TrainData, TypesOrData) {
  port::TrainType type;
  type.name = {'I', 'C', 'E'};
  type.data.L_TRAIN = Distance{200.0};
  EXPECT_TRUE(display.config.train_types.push_back(type));
  display.config.train_data_entry = port::TrainDataEntry::switchable;
  cycle(0.1);
  ASSERT_TRUE(tap("F1") && tap("Train data"));
  EXPECT_EQ(item(Kind::button, "switch").text.view(), "Select type");
  ASSERT_TRUE(tap("switch"));
  EXPECT_EQ(item(Kind::button, "switch").text.view(), "Enter data");
  ASSERT_TRUE(tap("key 1") && tap("field 1") && tap("Yes") && tap("field 1"));
  const auto commands = take(state);
  EXPECT_EQ(commands.train_type, 0);
  EXPECT_EQ(commands.train_data->L_TRAIN, Distance{200.0});
}

// 015560 11.5.1.4, Tables 44 and 45: with the entry that can be switched, by the layout used last.
TEST_F(TrainData, ViewedHaveTheTrainTypeThatWasEntered) {
  const auto types = [&] {
    for (const ViewItem& line : view_items(state))
      if (line.label.view() == "Train type") return true;
    return false;
  };
  display.config.train_data_entry = port::TrainDataEntry::switchable;
  cycle(0.1);
  EXPECT_FALSE(types());
  ASSERT_TRUE(tap("F1") && tap("Train data") && tap("switch") && tap("close") && tap("close") && tap("F3"));
  EXPECT_TRUE(types());
}

TEST_F(Windows, CodesOfCovers) {
  open(WindowId::set_vbc);
  keys("321456");
  ASSERT_TRUE(tap("field 1") && tap("Yes") && tap("field 1"));
  auto commands = take(state);
  ASSERT_TRUE(commands.actions.cover);
  EXPECT_EQ(commands.actions.cover->NID_VBCMK, 48);
  EXPECT_EQ(commands.actions.cover->NID_C, 926);
  EXPECT_EQ(commands.actions.cover->T_VBC, 4);
  open(WindowId::remove_vbc);
  keys("50078");
  ASSERT_TRUE(tap("field 1") && tap("Yes") && tap("field 1"));
  commands = take(state);
  EXPECT_EQ(commands.actions.cover->NID_VBCMK, 48);
  EXPECT_EQ(commands.actions.cover->NID_C, 926);
  EXPECT_TRUE(commands.actions.has(port::Select::vbc_remove));
}

// The code with which a cover was set, whatever is left of its time (015560 11.5.1, 11.3.12.5).
TEST_F(Windows, DataViewHasTheCodesOfCovers) {
  (void)display.data.covers.push_back({.NID_C = 926, .NID_VBCMK = 48, .left = Duration{3.0 * 86400.0}, .T_VBC = 4});
  (void)display.data.covers.push_back({.NID_C = 1, .NID_VBCMK = 2, .left = Duration{1.0}, .T_VBC = 255});
  cycle(0.1);
  std::vector<std::string> codes;
  open(WindowId::data_view);
  for (const ViewItem& line : view_items(state))
    if (line.label.view().substr(0, 3) == "VBC") codes.emplace_back(line.value.view());
  EXPECT_EQ(codes, (std::vector<std::string>{"321456", std::to_string((255 << 16) | (1 << 6) | 2)}));
}

// Sixteen digits are two lines of eight (015560 5.1.5.2), and each fits beside its label.
TEST_F(Windows, DataViewHasLongNumbersOnLinesThatFit) {
  display.data.stored.rbc_status = DataStatus::valid;
  display.data.stored.rbc = {.NID_C = 1000, .NID_RBC = 1, .NID_RADIO = 0x0041790000000001};
  cycle(0.1);
  open(WindowId::data_view);
  ASSERT_TRUE(tap("next"));
  last = drawn(state, Duration{when});
  std::vector<std::string> lines;
  std::int16_t baseline = 0;
  for (const Item& line : last.items) {
    if (line.kind != Kind::view_item) continue;
    EXPECT_LT(line.data_left + width_of(line.text.view(), 12, false), 640.0) << line.text.view();
    EXPECT_GT(line.baseline, baseline);
    baseline = line.baseline;
    if (line.name.view() == "RBC phone number" || !lines.empty()) lines.emplace_back(line.text.view());
  }
  EXPECT_EQ(lines, (std::vector<std::string>{"0041 7900", "0000 0001"}));
}

TEST_F(Windows, RbcContact) {
  open(WindowId::rbc_data);
  keys("12345678");
  ASSERT_TRUE(tap("field 1"));
  keys("0123");
  ASSERT_TRUE(tap("field 2") && tap("Yes"));
  const auto commands = take(state);
  ASSERT_TRUE(commands.actions.rbc_contact);
  EXPECT_EQ(commands.actions.rbc_contact->NID_RBC, 8526);
  EXPECT_EQ(commands.actions.rbc_contact->NID_C, 753);
  EXPECT_EQ(commands.actions.rbc_contact->NID_RADIO, 0x0123FFFFFFFFFFFFu);
  state.awaited = Awaited{};
  display.data.radio = port::RadioNetworkType::frmcs;
  cycle(0.1);
  open(WindowId::rbc_data);
  EXPECT_EQ(state.entry.fields.size(), 1u);
}

TEST_F(Windows, LevelsByThePriorityTable) {
  port::NtcName pzb{.nid_ntc = 6};
  pzb.characters = {'P', 'Z', 'B'};
  EXPECT_TRUE(display.config.ntc_names.push_back(pzb));
  EXPECT_TRUE(display.data.ntcs.push_back(6));
  display.data.levels = 1 << 0 | 1 << 2;  // levels 0 and 1
  cycle(0.1);
  open(WindowId::level);
  const auto key = [&](int number) { return key_at(state, number); };
  EXPECT_EQ(key(1).label.view(), "Level 1");
  EXPECT_TRUE(key(1).enabled);
  EXPECT_EQ(key(2).label.view(), "Level 2");
  EXPECT_FALSE(key(2).enabled);
  EXPECT_TRUE(key(3).label.empty());
  EXPECT_TRUE(key(4).enabled);
  EXPECT_EQ(key(5).label.view(), "PZB");
  ASSERT_TRUE(tap("key 5") && tap("field 1"));
  const auto commands = take(state);
  EXPECT_EQ(commands.actions.level, Level::NTC);
  EXPECT_EQ(commands.actions.nid_ntc, 6);
}

TEST_F(Windows, MoreChoicesThanKeys) {
  open(WindowId::train_data);  // 18 categories
  EXPECT_EQ(key_at(state, 12).picture, Picture::NA23);
  EXPECT_EQ(key_at(state, 11).label.view(), "FP 1");
  ASSERT_TRUE(tap("key 12"));
  EXPECT_EQ(key_at(state, 1).label.view(), "FP 2");
  EXPECT_TRUE(key_at(state, 8).label.empty());
  ASSERT_TRUE(tap("key 12"));
  EXPECT_EQ(key_at(state, 1).label.view(), "PASS 1");
}

// 015560 5.3.2.7.4: [More] is an up-type button on every keyboard, beside keys of the down type (10.3.5.13).
TEST_F(Windows, MoreActsOnRelease) {
  open(WindowId::train_data);
  const Cell more = test::middle(key_place(12));
  EXPECT_EQ(item(Kind::key, "").type, ButtonType::down);
  ASSERT_TRUE(press(state, more, Duration{when}));
  EXPECT_EQ(key_at(state, 1).label.view(), "PASS 1") << "held";
  slide(state, {0, 0}, Duration{when});
  release(state, Duration{when});
  EXPECT_EQ(key_at(state, 1).label.view(), "PASS 1") << "slid out";
  ASSERT_TRUE(press(state, more, Duration{when}));
  release(state, Duration{when});
  EXPECT_EQ(key_at(state, 1).label.view(), "FP 2");
}

/// The labels of the keys of a field, up to the first without one.
std::vector<std::string> keys_of(State& state, WindowId window, std::size_t field) {
  open_window(state, window);
  state.entry.selected = static_cast<std::uint8_t>(field);
  std::vector<std::string> labels;
  for (std::size_t choice = 0; choice < choices_of(state, state.entry.fields[field].id); ++choice)
    labels.emplace_back(choice_label(state, state.entry.fields[field].id, choice).view());
  return labels;
}

// Keyboards with fixed choices, in the order of the tables of 015560 11.3.
TEST_F(Windows, FixedChoicesAreInTheOrderOfTheTables) {
  using Labels = std::vector<std::string>;
  EXPECT_EQ(keys_of(state, WindowId::train_data, 0),  // Table 41
            (Labels{"PASS 1", "PASS 2", "PASS 3", "TILT 1", "TILT 2", "TILT 3", "TILT 4", "TILT 5", "TILT 6", "TILT 7",
                    "FP 1", "FP 2", "FP 3", "FP 4", "FG 1", "FG 2", "FG 3", "FG 4"}));
  EXPECT_EQ(keys_of(state, WindowId::train_data, 4),  // SUBSET-026 A.3.11
            (Labels{"A", "HS17", "B1", "B2", "C2", "C3", "C4", "D2", "D3", "D4", "D4XL", "E4", "E5"}));
  EXPECT_EQ(keys_of(state, WindowId::train_data, 5), (Labels{"No", "Yes"}));                            // Table 40
  EXPECT_EQ(keys_of(state, WindowId::train_data, 6), (Labels{"G1", "GA", "GB", "GC", "Out of GC"}));    // Table 42
  EXPECT_EQ(keys_of(state, WindowId::adhesion, 0), (Labels{"Non slippery rail", "Slippery rail"}));     // Table 43
  EXPECT_EQ(keys_of(state, WindowId::ato, 0), (Labels{"Stand-by", "On"}));                              // Table 43a
  EXPECT_EQ(keys_of(state, WindowId::radio_type, 0), (Labels{"FRMCS", "FRMCS+GSM-R", "GSM-R"}));        // Table 43b
  EXPECT_EQ(keys_of(state, WindowId::level, 0), (Labels{"Level 1", "Level 2", "Level 3", "Level 0"}));  // Table 38
}

// Each gauge that is offered is proposed as it is stored, and entered as its key says.
TEST_F(Windows, GaugesAreWhatTheirKeysSay) {
  for (const int offered : {0x1F, 0x1B, 0x09, 0x10}) {
    display.config.loading_gauges = static_cast<std::uint8_t>(offered);
    display.data.stored.train_status = DataStatus::valid;
    for (const auto& row : kLoadingGaugeRows) {
      display.data.stored.train.loading_gauge = row.value;
      cycle(0.1);
      open(WindowId::train_data);
      const bool is_offered = ((offered >> terms::index(row.value)) & 1) != 0;
      const Value* value = value_of(state.entry, FieldId::gauge);
      ASSERT_NE(value, nullptr);
      ASSERT_EQ(value->given(), is_offered) << row.name;
      if (!is_offered) continue;
      EXPECT_EQ(choice_label(state, FieldId::gauge, static_cast<std::size_t>(value->choice)).view(),
                row.value == LoadingGauge::none ? "Out of GC" : row.name);
      EXPECT_EQ(entered_train_data(state, state.entry).loading_gauge, row.value);
    }
  }
}

TEST_F(Windows, SrProposesTheLongestForInfinite) {
  display.data.stored.SR = {DataStatus::valid, Speed{40.0 / 3.6}, std::nullopt};
  display.data.D_sr_most = Distance{327670.0};
  cycle(0.1);
  open(WindowId::sr_data);
  EXPECT_EQ(field_text(2), "327 670");
  EXPECT_TRUE(take(state).windows.has(port::Window::SR_data));
}

TEST_F(Windows, DataViewHasPages) {
  display.data.stored.driver_id_status = DataStatus::valid;
  display.data.stored.driver_id = DriverId{"1234"};
  cycle(0.1);
  ASSERT_TRUE(tap("F3"));
  EXPECT_EQ(item(Kind::rect, "title").text.view(), "Data view (1/2)");
  EXPECT_EQ(item(Kind::view_item, "Driver ID").text.view(), "1234");
  EXPECT_EQ(item(Kind::view_item, "Driver ID").baseline, 77);
  EXPECT_EQ(item(Kind::button, "previous").picture, Picture::NA19);
  EXPECT_EQ(item(Kind::button, "next").picture, Picture::NA17);
  ASSERT_TRUE(tap("next"));
  EXPECT_EQ(item(Kind::view_item, "RBC ID").text.view(), "");
  ASSERT_TRUE(tap("close"));
  EXPECT_EQ(state.window, WindowId::default_);
}

// Topics have an empty line between them (015560 10.5.1.6, Table 45): radio data are one of them since 4.0.0.
TEST_F(Windows, DataViewSeparatesTopics) {
  const auto labels = [&] {
    std::string all;
    for (const ViewItem& line : view_items(state)) all += std::string(line.label.view()) + '|';
    return all;
  };
  open(WindowId::data_view);
  EXPECT_EQ(labels().substr(0, 54), "Driver ID||Train running number||Train category|Length");
  EXPECT_NE(labels().find("|Radio network type|GSM-R network ID|RBC ID|RBC phone number|"), std::string::npos);
  display.config.srs = SrsVersion::v3_6_0;
  cycle(0.1);
  EXPECT_NE(labels().find("|Radio network ID||RBC ID|"), std::string::npos);
}

// All that the driver can enter ends on the screen: the two radio systems as in Figure 134 of 015560.
TEST_F(Windows, DataViewHasValuesOnLinesThatFit) {
  display.data.stored.driver_id_status = DataStatus::valid;
  display.data.stored.driver_id = DriverId{"mmmmmmmmwwwwwwww"};
  display.data.radio = port::RadioNetworkType::frmcs_and_gsmr;
  cycle(0.1);
  open(WindowId::data_view);
  std::vector<std::string> values;
  for (const ViewItem& line : view_items(state)) {
    EXPECT_LE(543.0 + width_of(line.value.view(), 12, false), 640.0) << line.value.view();
    if (!line.value.empty()) values.emplace_back(line.value.view());
  }
  EXPECT_EQ(values, (std::vector<std::string>{"mmmm", "mmmm", "wwww", "wwww", "FRMCS+", "GSM-R"}));
}

// 015560 11.7.3 S5-4 and D5, over all that can be fitted and registered. Other than D5, S5-4 asks for FRMCS alone.
TEST_F(Windows, RadioTypesByWhatIsFittedAndRegistered) {
  using port::RadioNetworkType;
  for (unsigned n = 0; n < 16; ++n)
    for (const RadioNetworkType type :
         {RadioNetworkType::frmcs, RadioNetworkType::frmcs_and_gsmr, RadioNetworkType::gsmr}) {
      const bool frmcs = (n & 1u) != 0, gsmr = (n & 2u) != 0, on_frmcs = (n & 4u) != 0, on_gsmr = (n & 8u) != 0;
      display.config.frmcs_fitted = frmcs;
      display.config.gsmr_fitted = gsmr;
      display.data.frmcs_registered = on_frmcs;
      display.data.gsmr_registered = on_gsmr;
      display.data.radio = type;
      display.data.stored.rbc_status = DataStatus::valid;
      state.awaited = Awaited{};
      cycle(0.1);
      const std::string what = std::to_string(n) + ' ' + std::to_string(static_cast<int>(type));

      open(WindowId::radio_type);
      ASSERT_TRUE(tap("key " + std::to_string(static_cast<int>(type) + 1)) && tap("field 1"));
      const bool failed = type != RadioNetworkType::gsmr && frmcs && !on_frmcs;
      const bool both = type == RadioNetworkType::frmcs_and_gsmr && frmcs && gsmr;
      EXPECT_EQ(state.window, !failed || both ? WindowId::radio_data : WindowId::main) << what;

      open(WindowId::level);
      ASSERT_TRUE(tap("key 2") && tap("field 1"));
      const bool only_frmcs = type == RadioNetworkType::frmcs || (type != RadioNetworkType::gsmr && frmcs && !gsmr);
      const bool only_gsmr = type == RadioNetworkType::gsmr || (type != RadioNetworkType::frmcs && gsmr && !frmcs);
      const bool registered = (only_frmcs && on_frmcs) || (only_gsmr && on_gsmr) || (both && on_frmcs && on_gsmr);
      EXPECT_EQ(state.awaited.on, registered) << what;
      EXPECT_EQ(state.window, registered ? WindowId::main : WindowId::radio_data) << what;
    }
}

/// Level 2 entered from level 0, without a contact to call: the Radio data window is open (015560 11.7.3 D5).
class LevelFrom0 : public Windows {
 protected:
  LevelFrom0() {
    display.mode = Mode::UN;
    display.level = Level::L0;
    cycle(0.1);
    open(WindowId::level);
    EXPECT_TRUE(tap("key 2") && tap("field 1"));
    EXPECT_EQ(state.window, WindowId::radio_data);
  }
  void trip(Level level, double seconds) {
    display.mode = Mode::TR;
    display.level = level;
    cycle(seconds);
  }
  void post_trip() {
    display.mode = Mode::PT;
    cycle(1.0);
  }
};

TEST_F(LevelFrom0, TripsAndGoesOnWithTheRadioData) {
  trip(Level::L2, 0.2);
  EXPECT_EQ(state.window, WindowId::default_);
  cycle(60.0);
  EXPECT_EQ(state.window, WindowId::default_) << "until the trip is acknowledged";
  post_trip();
  EXPECT_EQ(state.window, WindowId::radio_data);
}

TEST_F(LevelFrom0, ThatIsNotTakenIsForgotten) {
  cycle(0.1);
  cycle(2.0);
  trip(Level::L2, 60.0);  // ordered by the trackside
  EXPECT_EQ(state.window, WindowId::radio_data) << "this trip is none of the entry";
  ASSERT_TRUE(tap("close") && tap("close"));
  post_trip();
  EXPECT_EQ(state.window, WindowId::default_);
}

TEST_F(LevelFrom0, IsForgottenWhenTheDriverGoesElsewhere) {
  ASSERT_TRUE(tap("close") && tap("close"));
  trip(Level::L2, 0.2);
  post_trip();
  EXPECT_EQ(state.window, WindowId::default_);
}

TEST_F(LevelFrom0, TakenWithoutATripIsForgotten) {
  display.level = Level::L2;
  cycle(0.2);
  cycle(0.2);
  trip(Level::L2, 0.2);
  EXPECT_EQ(state.window, WindowId::radio_data);
}

TEST_F(Windows, FromTheMainWindowNoStepIsStartUpAgain) {
  display.start_of_mission = true;
  display.step = Dialogue::start_S1;
  cycle(0.1);
  EXPECT_FALSE(tap("close"));
  display.step = Dialogue::start_S10;
  display.start_of_mission = false;
  cycle(0.1);
  EXPECT_EQ(state.window, WindowId::main);
  display.step = Dialogue::start_S3;  // level 2 entered from the Main window (11.7.3 S5-1)
  display.start_of_mission = true;
  cycle(0.1);
  EXPECT_EQ(state.window, WindowId::radio_data);
  EXPECT_TRUE(tap("close"));
  EXPECT_EQ(state.window, WindowId::main);
  display.step.reset();
  display.mode = Mode::NP;  // the desk is closed
  cycle(0.1);
  display.mode = Mode::SB;
  display.step = Dialogue::start_S1;
  cycle(0.1);
  EXPECT_EQ(state.window, WindowId::driver_id);
  EXPECT_FALSE(tap("close"));
}

TEST_F(Windows, StartOfMission) {
  display.start_of_mission = true;
  display.step = Dialogue::start_S1;
  display.level_valid = false;
  cycle(0.1);
  EXPECT_EQ(state.window, WindowId::driver_id);
  EXPECT_FALSE(tap("close"));
  ASSERT_TRUE(tap("TRN"));
  keys("12");
  ASSERT_TRUE(tap("field 1"));
  EXPECT_EQ(state.window, WindowId::driver_id);
  ASSERT_TRUE(tap("SE04"));
  ASSERT_TRUE(tap("close"));
  EXPECT_EQ(state.window, WindowId::driver_id);
  keys("77");
  ASSERT_TRUE(tap("field 1"));
  EXPECT_EQ(state.window, WindowId::main);
  display.step = Dialogue::start_S2;
  cycle(0.1);
  EXPECT_EQ(state.window, WindowId::level);
  EXPECT_FALSE(tap("close"));
  ASSERT_TRUE(tap("key 1") && tap("field 1"));
  EXPECT_EQ(take(state).actions.level, Level::L1);
  display.step = Dialogue::start_S10;
  display.start_of_mission = false;
  cycle(0.1);
  EXPECT_EQ(state.window, WindowId::main);
  cycle(2.0);
  ASSERT_TRUE(tap("Start"));
  EXPECT_TRUE(take(state).actions.has(port::Select::start));
  EXPECT_EQ(state.window, WindowId::default_);
}

TEST_F(Windows, RejectedDriverIdIsAskedForAgain) {
  display.start_of_mission = true;
  display.step = Dialogue::start_S1;
  cycle(0.1);
  keys("7");
  ASSERT_TRUE(tap("field 1"));
  EXPECT_EQ(state.window, WindowId::main);
  cycle(1.5);
  EXPECT_EQ(state.window, WindowId::driver_id);
}

TEST_F(Windows, CloseWhereTheDriverHasNone) {
  open(WindowId::train_data);
  display.mode = Mode::SL;
  cycle(0.1);
  EXPECT_EQ(state.window, WindowId::default_);
  EXPECT_TRUE(take(state).windows.empty());
}

TEST_F(Windows, StartInLevel2WaitsForTheRbc) {
  display.level = Level::L2;
  display.radio = RadioIndication::up;
  cycle(0.1);
  ASSERT_TRUE(tap("F1") && tap("Start"));
  EXPECT_EQ(state.window, WindowId::main);
  EXPECT_FALSE(tap("Driver ID")) << "disabled while it waits";
  EXPECT_FALSE(tap("close"));
  display.waiting = Waiting::answer_to_ma_request;
  cycle(0.1);
  cycle(20.0);
  EXPECT_EQ(state.window, WindowId::main);
  display.waiting = Waiting::nothing;
  cycle(0.1);
  EXPECT_EQ(state.window, WindowId::default_);
}

TEST_F(Windows, RefusedShuntingStaysInMain) {
  display.level = Level::L2;
  for (const bool accepted : {false, true}) {
    cycle(0.1);
    open(WindowId::main);
    ASSERT_TRUE(tap("Shunting"));
    display.waiting = Waiting::answer_to_sh_request;
    cycle(0.1);
    display.waiting = Waiting::nothing;
    if (accepted) display.mode = Mode::SH;
    cycle(1.0);
    EXPECT_EQ(state.window, accepted ? WindowId::default_ : WindowId::main);
  }
}

// Table 33 #11: in PT no manoeuvre is initiated without valid train data, but one continued; also where it is not
// enabled.
TEST_F(Windows, InPostTripTheManoeuvreIsContinuedWithoutTrainData) {
  display.mode = Mode::PT;
  for (const bool enabled : {false, true}) {
    display.buttons = enabled ? test::all_buttons() : Set<Button>{};
    for (const DataStatus status : {DataStatus::unknown, DataStatus::invalid, DataStatus::valid}) {
      display.data.stored.train_status = status;
      cycle(0.1);
      open(WindowId::main);
      const char* const shown = status == DataStatus::valid ? "Initiate SM" : "Continue in SM";
      EXPECT_EQ(item(Kind::button, shown).enabled, enabled) << shown;
    }
  }
}

TEST_F(Windows, OldEditionsHaveNoNewButtons) {
  display.config.srs = SrsVersion::v3_6_0;
  cycle(0.1);
  for (const MenuButton& button : menu_buttons(state, WindowId::main)) EXPECT_NE(button.button, Button::initiate_sm);
  open(WindowId::level);
  EXPECT_EQ(key_at(state, 3).label.view(), "Level 3");
}

}  // namespace
}  // namespace evc::dmi
