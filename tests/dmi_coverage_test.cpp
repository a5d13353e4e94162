// What of the driver-machine interface is touched: the windows with everything in them that can be pressed, the
// conditions of the buttons of the menus, and the steps of the on-board's dialogue. From the same rows as the display
// itself come what has to be touched and the page docs/dmi-coverage.md.

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <deque>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "base/test_paths.h"
#include "dmi/dmi.h"
#include "dmi/entry.h"
#include "dmi/labels.h"
#include "dmi/test_display.h"
#include "dmi/windows.h"
#include "dmi_sequences.h"
#include "driver/buttons.h"
#include "terms/dialogue.h"
#include "texts/texts.h"

namespace evc {
namespace {

using dmi::ActionKind;
using dmi::FieldId;
using dmi::State;
using dmi::Target;
using dmi::WindowId;
using port::Display;

template <std::size_t N>
void put(std::array<char, N>& characters, std::string_view text) {
  text.copy(characters.data(), N);
}

/// A display with everything that a driver may choose, and all data stored.
Display rich(Mode mode = Mode::SB) {
  Display d = dmi::test::neutral(mode);
  d.buttons = dmi::test::all_buttons();
  d.level = Level::L1;
  d.level_valid = true;
  d.config.frmcs_fitted = true;
  for (const std::array<char, 2>& letters : {std::array{'e', 'n'}, std::array{'d', 'e'}})
    (void)d.config.languages.push_back(Language{letters});
  port::ShownData& stored = d.data.stored;
  stored.driver_id_status = stored.train_running_number_status = stored.level_status = stored.rbc_status =
      stored.train_status = DataStatus::valid;
  stored.driver_id = DriverId("4711");
  stored.train_running_number = 0x471FFFFF;
  stored.rbc = {1, 2, 0x1234FFFFFFFFFFFF};
  stored.network = 0x26210F;
  stored.train.L_TRAIN = Distance{200.0};
  stored.train.V_MAXTRAIN = Speed{160.0 / 3.6};
  stored.train.brake_percentage = 135.0;
  stored.train.cant_deficiency_mm = 150;
  stored.SR = {DataStatus::valid, Speed{40.0 / 3.6}, Distance{1000.0}};
  d.data.levels = 0x1F;
  d.data.radio = port::RadioNetworkType::frmcs_and_gsmr;
  d.data.gsmr_registered = d.data.frmcs_registered = true;
  for (const std::uint32_t network : {0x26210Fu, 0x20801Fu}) (void)d.data.networks.push_back(network);
  (void)d.data.covers.push_back({7, 9, Duration{86400.0}});
  for (const std::uint8_t system : std::array<std::uint8_t, 2>{1, 9}) (void)d.data.ntcs.push_back(system);
  d.ato.on = true;
  return d;
}

/// A driver in front of displays, who tries everything.
struct Scene {
  const char* name;
  Display display;
};

std::vector<Scene> scenes() {
  std::vector<Scene> all;
  const auto add = [&](const char* name, Mode mode) -> Display& {
    all.push_back({name, rich(mode)});
    return all.back().display;
  };
  add("stand-by, everything enabled", Mode::SB);
  add("nothing enabled", Mode::SB).buttons = {};
  Display& number = add("without a running number", Mode::SB);
  number.data.stored.train_running_number_status = DataStatus::unknown;
  Display& shunting = add("shunting", Mode::SH);
  shunting.bmm_inhibited = true;
  Display& none_of_shunting = add("shunting, nothing enabled", Mode::SH);
  none_of_shunting.bmm_inhibited = true;
  none_of_shunting.buttons = {};
  add("supervised manoeuvre", Mode::SM);
  add("supervised manoeuvre, nothing enabled", Mode::SM).buttons = {};
  for (const auto entry : {port::TrainDataEntry::fixed, port::TrainDataEntry::switchable}) {
    Display& types = add(entry == port::TrainDataEntry::fixed ? "fixed train data" : "switchable train data", Mode::SB);
    types.config.train_data_entry = entry;
    for (const char* const name : {"ICE", "Regio"}) {
      port::TrainType type;
      put(type.name, name);
      type.data = types.data.stored.train;
      (void)types.config.train_types.push_back(type);
    }
  }
  Display& driving = add("full supervision", Mode::FS);
  driving.standstill = false;
  driving.tunnel = port::TunnelStoppingArea{false, Distance{500.0}};
  driving.geo = Distance{12345.0};
  driving.ato.status = port::AtoStatus::ready;
  driving.ato.skip = port::AtoSkip::inactive;
  for (std::uint16_t id = 1; id <= 9; ++id) {
    port::DisplayedText text{.id = id, .since = Duration{static_cast<double>(id)}};
    put(text.characters, "text");
    text.length = 4;
    (void)driving.texts.push_back(text);
  }
  Display engaged = driving;
  engaged.ato.status = port::AtoStatus::engaged;
  all.push_back({"automatic driving", engaged});
  Display& sight = add("on sight", Mode::OS);
  (void)sight.acks.push_back({Ack::text, 7, sight.now});
  add("the question whether the track ahead is free", Mode::OS).track_ahead_free = true;
  for (const auto& row : kAckRows) {
    Display& asked = add("an acknowledgement", Mode::FS);
    (void)asked.acks.push_back({row.value, static_cast<std::uint16_t>(row.value == Ack::text ? 7 : 0), asked.now});
  }
  for (const DialogueRow& row : kDialogueRows) {
    Display& dialogue = add(row.step, Mode::SB);
    dialogue.step = row.value;
    dialogue.start_of_mission = std::string(row.procedure) == "start_of_mission";
  }
  Display& radio = add("the question for one radio system", Mode::SB);
  radio.start_of_mission = radio.data.asks_one_radio_system = true;
  return all;
}

constexpr std::array<const char*, 22> kActionNames{"-",
                                                   "open",
                                                   "button",
                                                   "close",
                                                   "next",
                                                   "previous",
                                                   "key",
                                                   "field",
                                                   "entry complete?",
                                                   "switch",
                                                   "acknowledge",
                                                   "toggle speeds",
                                                   "toggle tunnel",
                                                   "toggle position",
                                                   "scale smaller",
                                                   "scale larger",
                                                   "text up",
                                                   "text down",
                                                   "track ahead free",
                                                   "ATO engage",
                                                   "ATO disengage",
                                                   "skip stop"};

std::string described(const State& state, const Target& target) {
  const std::size_t argument = target.action.argument;
  switch (target.action.kind) {
    case ActionKind::open:
      return std::string("to ") + dmi::row_of(static_cast<WindowId>(argument)).title;
    case ActionKind::button:
      return name(static_cast<Button>(argument));
    case ActionKind::key:
      return "key " + std::to_string(argument);
    case ActionKind::field: {
      const FieldId id = state.entry.fields[argument].id;
      const bool enters = argument == state.entry.selected;
      return std::string(enters ? "enter " : "select ") + (id == FieldId::validation ? "Yes or No"
                                                           : std::string(dmi::label(id, SrsVersion::v4_0_0)).empty()
                                                               ? dmi::row_of(state.window).title
                                                               : std::string(dmi::label(id, SrsVersion::v4_0_0)));
    }
    default:
      return kActionNames[static_cast<std::size_t>(target.action.kind)];
  }
}

/// What the on-board gets.
std::set<std::string> sent(const dmi::Commands& c) {
  std::set<std::string> all;
  for (std::size_t n = 0; n < terms::index(port::Select::count); ++n)
    if (c.actions.has(static_cast<port::Select>(n))) all.insert(std::string("`") + texts::kSelectNames[n] + "`");
  for (const auto& row : kAckRows)
    if (c.actions.has(row.value)) all.insert(std::string("ack `") + row.name + "`");
  const auto entered = [&](bool given, const char* what) {
    if (given) all.insert(std::string("enters ") + what);
  };
  entered(c.actions.driver_id.has_value(), "the driver ID");
  entered(c.actions.level.has_value(), "the level");
  entered(c.actions.train_running_number.has_value(), "the running number");
  entered(c.train_data.has_value(), "train data");
  entered(c.train_type.has_value(), "a train type");
  entered(c.actions.rbc_contact.has_value(), "the RBC contact");
  entered(c.actions.cover.has_value(), "a cover");
  entered(c.actions.network.has_value(), "the network");
  entered(c.actions.V_sr.has_value() && c.actions.D_sr.has_value(), "SR speed and distance");
  entered(c.actions.language.has_value(), "the language");
  entered(c.radio.has_value(), "the radio network type");
  entered(c.one_radio_system.has_value(), "one radio system");
  entered(c.ato_on.has_value(), "the ATO selector");
  entered(c.skip_stop.has_value(), "the skip of a stop");
  return all;
}

/// What presses of one thing in a window did, over all scenes.
struct Touched {
  bool enabled = false;   ///< pressed and hit
  bool disabled = false;  ///< pressed while it was not enabled, and not hit
  std::set<std::string> effects;
};

/// Everything that was pressed, and what must be.
struct Record {
  std::array<std::map<std::string, Touched>, dmi::kWindows> windows;
  std::set<ActionKind> kinds;
  std::set<Button> buttons, disabled_buttons;
  std::set<FieldId> selected, entered;
  std::map<Dialogue, std::string> steps;  ///< the window of the step, and what can be pressed there
  std::size_t presses = 0;
};

/// States that the driver would treat alike are tried once.
std::string likeness(const State& s) {
  std::ostringstream out;
  out << int(s.window) << ' ' << int(s.page) << ' ' << int(s.entry.selected) << ' ' << int(s.entry.choices_from) << ' '
      << s.from_driver_id << s.fixed_train_entry << s.awaited.on << s.toggles.speed << s.toggles.tunnel << s.toggles.geo
      << ' ' << int(s.zoom) << ' ' << s.scroll << ' ' << s.offered.has_value();
  for (const dmi::Field& field : s.entry.fields)
    out << ' ' << int(field.id) << field.accepted << field.typed << (field.value.typed.view().size() > 1)
        << field.value.given() << int(field.check) << (s.entry.fields.size() == 1 ? field.value.choice : 0);
  return out.str();
}

class Driver {
 public:
  Driver(Record& record, const Scene& scene) : record_(record), display_(scene.display) {
    auto first = std::make_unique<State>();
    dmi::show(*first, display_);
    if (display_.step) note_step(*first);
    dmi::take(*first);
    remember(std::move(first));
    while (!open_.empty()) {
      const std::unique_ptr<State> state = std::move(open_.front());
      open_.pop_front();
      const dmi::Targets targets = dmi::targets(*state);
      for (std::size_t n = 0; n < targets.size(); ++n) press(*state, targets, n);
    }
  }

 private:
  void note_step(const State& state) {
    std::string& what = record_.steps[*display_.step];
    what = dmi::row_of(state.window).title;
    what += state.window == WindowId::default_ ? "" : ": ";
    for (const Target& target : dmi::targets(state)) {
      if (!target.enabled || target.action.kind == ActionKind::key || state.window == WindowId::default_) continue;
      what += (what.ends_with(": ") ? "" : ", ") + described(state, target);
    }
  }

  void press(const State& before, const dmi::Targets& targets, std::size_t n) {
    const Target& target = targets[n];
    const dmi::Cell cell = dmi::test::middle(target.abs);
    for (std::size_t above = 0; above < n; ++above)
      if (dmi::inside(targets[above].abs, cell.x, cell.y)) return;  // covered
    auto after = std::make_unique<State>(before);
    double now = before.display.now.si + 5.0;  // a tap of before has ended
    dmi::tick(*after, Duration{now});
    const std::string what = described(before, target);
    const std::size_t window = static_cast<std::size_t>(before.window);
    Touched& touched = record_.windows[window][what];
    const bool hit = dmi::press(*after, cell, Duration{now});
    ++record_.presses;
    EXPECT_EQ(hit, target.enabled) << dmi::row_of(before.window).title << ": " << what;
    (target.enabled ? touched.enabled : touched.disabled) = true;
    if (target.action.kind == ActionKind::button)
      (target.enabled ? record_.buttons : record_.disabled_buttons).insert(static_cast<Button>(target.action.argument));
    now += target.type == dmi::ButtonType::delay ? 2.1 : 0.1;
    dmi::release(*after, Duration{now});
    const std::set<std::string> commands = sent(dmi::take(*after));
    if (!target.enabled) {
      EXPECT_TRUE(commands.empty()) << what;
      EXPECT_EQ(after->window, before.window) << what;
      return;
    }
    record_.kinds.insert(target.action.kind);
    touched.effects.insert(commands.begin(), commands.end());
    if (after->window != before.window)
      touched.effects.insert(std::string("opens ") + dmi::row_of(after->window).title);
    if (target.action.kind == ActionKind::field) note_field(before, *after, target.action.argument);
    // The on-board shows the same again, once it could have answered.
    Display display = display_;
    for (const double later : {0.2, 1.5}) {
      display.now = Duration{now + later};
      dmi::show(*after, display);
    }
    dmi::take(*after);
    remember(std::move(after));
  }

  void note_field(const State& before, const State& after, std::size_t place) {
    const FieldId id = before.entry.fields[place].id;
    record_.selected.insert(id);
    const bool left = after.window != before.window;
    if (place == before.entry.selected && (left || after.entry.fields[place].accepted)) record_.entered.insert(id);
  }

  void remember(std::unique_ptr<State> state) {
    if (seen_.size() < kMost && seen_.insert(likeness(*state)).second) open_.push_back(std::move(state));
  }

  /// Of states of one scene.
  static constexpr std::size_t kMost = 700;

  Record& record_;
  const Display& display_;
  std::set<std::string> seen_;
  std::deque<std::unique_ptr<State>> open_;
};

const Record& record() {
  static const Record all = [] {
    Record made;
    for (const Scene& scene : scenes()) Driver(made, scene);
    return made;
  }();
  return all;
}

TEST(DmiCoverage, EveryWindowIsPressedIn) {
  for (const dmi::WindowRow& row : dmi::kWindowRows)
    EXPECT_FALSE(record().windows[static_cast<std::size_t>(row.id)].empty()) << row.title;
}

TEST(DmiCoverage, EveryKindOfActionIsTaken) {
  for (std::size_t kind = 1; kind < kActionNames.size(); ++kind)
    EXPECT_TRUE(record().kinds.contains(static_cast<ActionKind>(kind))) << kActionNames[kind];
}

TEST(DmiCoverage, EveryButtonOfAMenuIsPressedEnabledAndNot) {
  for (const auto& row : kButtonRows) {
    EXPECT_TRUE(record().buttons.contains(row.value)) << row.name;
    EXPECT_TRUE(record().disabled_buttons.contains(row.value)) << row.name;
  }
}

TEST(DmiCoverage, EveryFieldIsSelectedAndItsValueEntered) {
  for (std::size_t n = 0; n < static_cast<std::size_t>(FieldId::count); ++n) {
    EXPECT_TRUE(record().selected.contains(static_cast<FieldId>(n)))
        << n << dmi::label(static_cast<FieldId>(n), SrsVersion::v4_0_0);
    EXPECT_TRUE(record().entered.contains(static_cast<FieldId>(n)))
        << n << dmi::label(static_cast<FieldId>(n), SrsVersion::v4_0_0);
  }
}

/// Every input of the on-board that the display has a place for. Isolation is a switch of the cab (4.4.3).
TEST(DmiCoverage, EveryInputOfTheDriverIsGivenByAPress) {
  std::set<std::string> given;
  for (const auto& window : record().windows)
    for (const auto& [what, touched] : window) given.insert(touched.effects.begin(), touched.effects.end());
  for (std::size_t n = 0; n < terms::index(port::Select::count); ++n) {
    if (static_cast<port::Select>(n) == port::Select::isolate) continue;
    EXPECT_TRUE(given.contains(std::string("`") + texts::kSelectNames[n] + "`")) << texts::kSelectNames[n];
  }
  for (const auto& row : kAckRows) EXPECT_TRUE(given.contains(std::string("ack `") + row.name + "`")) << row.name;
}

TEST(DmiCoverage, EveryStepOfTheDialogueIsShown) {
  for (const DialogueRow& row : kDialogueRows) EXPECT_TRUE(record().steps.contains(row.value)) << row.step;
}

// The conditions of the buttons: Tables 33 to 37.

constexpr std::array<const char*, 29> kFactNames{"standstill",
                                                 "driver ID valid",
                                                 "level valid",
                                                 "train data valid",
                                                 "running number valid",
                                                 "session",
                                                 "train data acknowledged",
                                                 "emergency stop",
                                                 "non-leading signal",
                                                 "passive shunting signal",
                                                 "driver ID while running",
                                                 "adhesion by driver",
                                                 "slow enough for override",
                                                 "position valid",
                                                 "length in range",
                                                 "cover stored",
                                                 "covers full",
                                                 "contact known",
                                                 "networks registered",
                                                 "short number reachable",
                                                 "GSM-R chosen",
                                                 "one of two registered",
                                                 "alarm inhibited",
                                                 "consist known",
                                                 "consist in front",
                                                 "consist acknowledged",
                                                 "session above 2.2",
                                                 "second session",
                                                 "RBC transition ordered"};
static_assert(kFactNames.size() == static_cast<std::size_t>(driver::Fact::RBC_transition_ordered) + 1);

using driver::ButtonContext;
using driver::Fact;
using Flip = std::function<void(ButtonContext&)>;

/// The inputs of the conditions, one at a time.
std::vector<Flip> flips() {
  using A = driver::ActionContext;
  using C = ButtonContext;
  std::vector<Flip> all;
  for (const auto field :
       {&A::standstill, &A::driver_id_valid, &A::train_data_valid, &A::train_running_number_valid, &A::session_open,
        &A::train_data_acknowledged, &A::non_leading_signal, &A::passive_shunting_signal, &A::slow_enough_for_override,
        &A::driver_may_change_adhesion, &A::driver_id_while_running, &A::alarm_inhibited})
    all.emplace_back([field](C& c) { c.action.*field = !(c.action.*field); });
  for (const auto field :
       {&C::emergency_stop_pending, &C::position_valid, &C::length_in_range, &C::cover_stored, &C::covers_full,
        &C::contact_known, &C::one_radio_system, &C::consist_known, &C::consist_in_front, &C::consist_acknowledged,
        &C::session_above_2_2, &C::second_session, &C::RBC_transition_ordered})
    all.emplace_back([field](C& c) { c.*field = !(c.*field); });
  for (const auto system : {&C::gsmr, &C::frmcs}) {
    all.emplace_back([system](C& c) { (c.*system).fitted = !(c.*system).fitted; });
    all.emplace_back([system](C& c) { (c.*system).registered = !(c.*system).registered; });
  }
  for (const auto type : {driver::NetworkType::gsmr, driver::NetworkType::frmcs, driver::NetworkType::both})
    all.emplace_back([type](C& c) { c.network_type = type; });
  all.emplace_back([](C& c) { c.action.level = c.action.level ? std::nullopt : std::optional(Level::L1); });
  return all;
}

Set<Fact> differing(Set<Fact> a, Set<Fact> b) {
  Set<Fact> out;
  for (std::size_t n = 0; n < kFactNames.size(); ++n)
    out.add(static_cast<Fact>(n), a.has(static_cast<Fact>(n)) != b.has(static_cast<Fact>(n)));
  return out;
}
std::size_t missing(const driver::ButtonRow& row, const ButtonContext& c) {
  const Set<Fact> facts = driver::facts_of(c);
  std::size_t count = 0;
  for (std::size_t n = 0; n < kFactNames.size(); ++n) {
    const auto fact = static_cast<Fact>(n);
    if (row.needs.has(fact) && !facts.has(fact)) ++count;
    if (row.without.has(fact) && facts.has(fact)) ++count;
  }
  return count;
}

/// What was seen of one button.
struct Conditions {
  std::set<Mode> enabled_in, disabled_in;  ///< with the rest of a row fulfilled; with nothing but the mode changed
  std::set<Level> levels, other_levels;    ///< the same of levels, where a row names some
  Set<Fact> decided;                       ///< a fact whose change alone enabled and disabled it
};

/// Contexts that fulfil each row, and what changes when one input, the mode or the level changes.
std::map<Button, Conditions> conditions() {
  std::map<Button, Conditions> all;
  std::mt19937 random(1);
  const std::vector<Flip> inputs = flips();
  for (const driver::ButtonRow& row : driver::dmi_11_2) {
    Conditions& seen = all[row.button];
    const auto has = [&](const ButtonContext& c) { return driver::buttons(c).has(row.button); };
    int fulfilled = 0;
    for (int n = 0; n < 3000 && fulfilled < 60; ++n) {
      ButtonContext c;
      c.action.srs = SrsVersion::v4_0_0;
      c.action.desk_open = true;
      c.inputs = Set<driver::Input>::of_bits(~std::uint64_t{0});
      for (const Flip& flip : inputs)
        if (random() % 2 == 0) flip(c);
      std::vector<Mode> modes;
      for (const auto& mode : kModeRows)
        if (row.modes.has(mode.value)) modes.push_back(mode.value);
      c.action.mode = modes[random() % modes.size()];
      std::vector<Level> levels;
      for (const auto& level : kLevelRows)
        if (row.levels == Set<Level>{} || row.levels.has(level.value)) levels.push_back(level.value);
      c.action.level = levels[random() % levels.size()];
      // Towards what the row asks for.
      for (int round = 0; round < 3 && missing(row, c) != 0; ++round)
        for (const Flip& flip : inputs) {
          ButtonContext other = c;
          flip(other);
          if (other.action.level && missing(row, other) < missing(row, c)) c = other;
        }
      if (missing(row, c) != 0) continue;
      if (!(row.levels == Set<Level>{}) && !(c.action.level && row.levels.has(*c.action.level))) continue;
      ++fulfilled;
      EXPECT_TRUE(has(c)) << name(row.button);
      seen.enabled_in.insert(c.action.mode);
      for (const Flip& flip : inputs) {
        ButtonContext other = c;
        flip(other);
        if (has(other)) continue;
        const Set<Fact> changed = differing(driver::facts_of(c), driver::facts_of(other));
        for (std::size_t f = 0; f < kFactNames.size(); ++f) {
          Set<Fact> only;
          only.add(static_cast<Fact>(f));
          const bool asked = row.needs.has(static_cast<Fact>(f)) || row.without.has(static_cast<Fact>(f));
          // Of the facts that changed this one alone is asked for.
          Set<Fact> of_row = changed & row.needs;
          of_row |= changed & row.without;
          if (asked && of_row == only) seen.decided |= only;
        }
      }
      for (const auto& mode : kModeRows) {
        ButtonContext other = c;
        other.action.mode = mode.value;
        if (!has(other)) seen.disabled_in.insert(mode.value);
      }
      if (row.levels == Set<Level>{}) continue;
      seen.levels.insert(*c.action.level);
      for (const auto& level : kLevelRows) {
        ButtonContext other = c;
        other.action.level = level.value;
        if (!has(other)) seen.other_levels.insert(level.value);
      }
    }
    EXPECT_GT(fulfilled, 0) << name(row.button) << ": a row that nothing fulfils";
  }
  return all;
}

const std::map<Button, Conditions>& seen_conditions() {
  static const std::map<Button, Conditions> all = conditions();
  return all;
}

/// Facts that the rows of a button ask for.
Set<Fact> asked_for(Button button) {
  Set<Fact> all;
  for (const driver::ButtonRow& row : driver::dmi_11_2) {
    if (row.button != button) continue;
    all |= row.needs;
    all |= row.without;
  }
  return all;
}

TEST(DmiCoverage, EveryConditionOfAButtonIsSeenTrueAndFalse) {
  std::set<Button> with_rows;
  for (const driver::ButtonRow& row : driver::dmi_11_2) {
    with_rows.insert(row.button);
    const Conditions& seen = seen_conditions().at(row.button);
    for (const auto& mode : kModeRows) {
      if (!row.modes.has(mode.value)) continue;
      EXPECT_TRUE(seen.enabled_in.contains(mode.value)) << name(row.button) << ' ' << mode.name;
    }
    for (const auto& level : kLevelRows) {
      if (!row.levels.has(level.value)) continue;
      EXPECT_TRUE(seen.levels.contains(level.value)) << name(row.button) << ' ' << level.name;
    }
    EXPECT_EQ(seen.other_levels.empty(), row.levels == Set<Level>{} && seen.levels.empty()) << name(row.button);
  }
  EXPECT_EQ(with_rows.size(), kButtonRows.size());
  for (const auto& row : kButtonRows) {
    const Conditions& seen = seen_conditions().at(row.value);
    for (const auto& mode : kModeRows)
      EXPECT_TRUE(seen.enabled_in.contains(mode.value) || seen.disabled_in.contains(mode.value))
          << row.name << ' ' << mode.name;
    for (std::size_t f = 0; f < kFactNames.size(); ++f) {
      if (!asked_for(row.value).has(static_cast<Fact>(f))) continue;
      EXPECT_TRUE(seen.decided.has(static_cast<Fact>(f))) << row.name << ": " << kFactNames[f];
    }
  }
}

// The sequences of dialogues: 11.7.

std::string joined(const std::set<std::string>& items);

/// Presses one place after the other; false with a failure where one is not there or not enabled.
void press_each(State& state, std::string_view names, double& at) {
  while (!names.empty()) {
    const std::size_t end = std::min(names.find('|'), names.size());
    const std::string one(names.substr(0, end));
    EXPECT_TRUE(dmi::test::tap(state, one, at)) << one << " in " << dmi::row_of(state.window).title;
    names.remove_prefix(std::min(end + 1, names.size()));
    at += 0.3;
    dmi::tick(state, Duration{at});
  }
}

TEST(DmiCoverage, EverySequenceOfDialoguesIsGoneThrough) {
  for (const test::Sequence& sequence : test::kSequences) {
    Display display = rich();
    auto state = std::make_unique<State>();
    double at = display.now.si;
    for (const test::SequenceStep& step : sequence.steps) {
      if (step.step == nullptr) break;
      SCOPED_TRACE(std::string(sequence.clause) + " " + sequence.name + ": " + step.step + " " + step.presses);
      at += 0.2;
      display.now = Duration{at};
      if (step.onboard.change != nullptr) step.onboard.change(display);
      dmi::show(*state, display);
      dmi::take(*state);
      press_each(*state, step.presses, at);
      std::set<std::string> given = sent(dmi::take(*state));
      given.erase("`main`");
      EXPECT_EQ(dmi::row_of(state->window).title, std::string(dmi::row_of(step.window).title));
      const bool with_hour_glass = state->window == WindowId::main || state->window == WindowId::radio_data;
      EXPECT_EQ(with_hour_glass && dmi::is_waiting(*state), step.waits);
      EXPECT_EQ(dmi::close_enabled(*state), step.closes);
      EXPECT_EQ(joined(given), step.given);
    }
  }
}

// The page.

std::string joined(const std::set<std::string>& items) {
  std::string text;
  for (const std::string& item : items) text += (text.empty() ? "" : ", ") + item;
  return text;
}

void append_windows(std::string& page) {
  page +=
      "## Windows\n\nEverything that can be pressed. `e`: seen pressed enabled; `d`: pressed disabled, and nothing was "
      "hit. "
      "What it does is over all scenes:\nwhat the on-board gets, and the window that follows.\n";
  for (const dmi::WindowRow& row : dmi::kWindowRows) {
    page += std::string("\n### ") + (row.id == WindowId::default_ ? "Default window" : row.title) +
            "\n| pressed | seen | does |\n|---|---|---|\n";
    for (const auto& [what, touched] : record().windows[static_cast<std::size_t>(row.id)])
      page += "| " + what + " | " + (touched.enabled ? "e" : "") + (touched.disabled ? " d" : "") + " | " +
              joined(touched.effects) + " |\n";
  }
}

void append_conditions(std::string& page) {
  page +=
      "\n## Buttons of the menus\nThe conditions of Tables 33 to 37, of the rows of `src/driver/buttons.h`. Each was "
      "seen true and "
      "false: with the button enabled, its change\nalone disabled it. Of modes and levels those in which it was seen "
      "enabled; in "
      "all other modes it was seen disabled.\n\n| button | modes | levels | conditions |\n|---|---|---|---|\n";
  for (const auto& row : kButtonRows) {
    const Conditions& seen = seen_conditions().at(row.value);
    std::string modes, levels, facts;
    for (const Mode mode : seen.enabled_in) modes += std::string(modes.empty() ? "" : " ") + name(mode);
    for (const Level level : seen.levels) levels += std::string(levels.empty() ? "" : " ") + name(level);
    for (std::size_t f = 0; f < kFactNames.size(); ++f)
      if (seen.decided.has(static_cast<Fact>(f))) facts += std::string(facts.empty() ? "" : ", ") + kFactNames[f];
    page += std::string("| ") + row.name + " | " + modes + " | " + levels + " | " + facts + " |\n";
  }
}

void append_steps(std::string& page) {
  page +=
      "\n## Steps of the dialogue\nWhat the display shows when the on-board is at a step, and what can be pressed "
      "there.\n\n"
      "| procedure | step | waits for | window |\n|---|---|---|---|\n";
  for (const DialogueRow& row : kDialogueRows)
    page += std::string("| `") + row.procedure + "` | " + row.step + " | `" + row.waits_for + "` | " +
            record().steps.at(row.value) + " |\n";
}

void append_sequences(std::string& page) {
  page +=
      "\n## Sequences of dialogues\nGone through by presses; after each step the window, its hour glass, its button "
      "Close and what the on-board gets\nare compared with these rows (`tests/dmi_sequences.h`).\n";
  for (const test::Sequence& sequence : test::kSequences) {
    page += std::string("\n### ") + sequence.clause + ": " + sequence.name +
            "\n| step | the on-board | pressed | window | given |\n|---|---|---|---|---|\n";
    for (const test::SequenceStep& step : sequence.steps) {
      if (step.step == nullptr) break;
      std::string presses = step.presses;
      for (std::size_t n = presses.find('|'); n != std::string::npos; n = presses.find('|'))
        presses.replace(n, 1, ", ");
      page += std::string("| ") + step.step + " | " + step.onboard.what + " | " + presses + " | " +
              dmi::row_of(step.window).title + (step.waits ? ", waits" : "") + (step.closes ? "" : ", no Close") +
              " | " + step.given + " |\n";
    }
  }
}

std::string page() {
  std::string text =
      "# What of the driver-machine interface is touched by tests\nMade by `EVC_WRITE=1 dmi_coverage_test` of the rows "
      "that the "
      "display itself uses: a driver presses everything in every\nwindow that presses lead to. A test fails when a "
      "window, field, "
      "button or step is not touched, when a condition is not\nseen true and false, and when this page is not up to "
      "date.\n\n";
  append_windows(text);
  append_conditions(text);
  append_steps(text);
  append_sequences(text);
  return text;
}

TEST(DmiCoverage, ThePageIsUpToDate) {
  const std::string file = evc::test::source_folder() + "/docs/dmi-coverage.md";
  if (std::getenv("EVC_WRITE") != nullptr) std::ofstream(file) << page();
  std::ifstream in(file);
  const std::string committed{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  EXPECT_EQ(committed, page()) << "EVC_WRITE=1 dmi_coverage_test writes docs/dmi-coverage.md";
}

}  // namespace
}  // namespace evc
