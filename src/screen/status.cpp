#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "dmi/labels.h"
#include "dmi/touch.h"
#include "driver/driver.h"
#include "screen/scene.h"

// System status texts of a case (015560 15): the unit's own rules start and end them.
namespace evc::screen {
namespace {

using dmi::Action;
using dmi::ActionKind;
using io::JsonPlace;
using port::Display;

constexpr std::string_view kEnded = "first end condition met";

/// What starts the texts of a case.
struct Start {
  Set<Inform> inform;
  Set<Cause> brakes;
  Set<Suitability> unsuitable;
  bool described_under_train = true;
};

/// Texts of Tables 68 to 70 that others start than this unit: the interface to national systems (SUBSET-035 10.7.3.4,
/// 10.14.1), automatic train operation (SUBSET-125 7.14.2.13) and FRMCS, which this unit does not have.
struct OtherText {
  std::string_view name;
  std::string_view words;  ///< behind the name of the national system
  bool national;
  bool acknowledge;  ///< (015560 15.1.1.4.1)
  SrsVersion since = SrsVersion::v3_4_0;
  bool until_main_window = false;  ///< a button of the main window ends it
};
constexpr std::array<OtherText, 4> kOtherTexts{
    {{"[name of NTC] needs data", " needs data", true, false},
     {"[name of NTC] failed", " failed", true, true},
     {"ATO needs data", "ATO needs data", false, false, SrsVersion::v4_0_0},
     {"FRMCS network registration failed", "FRMCS network registration failed", false, false, SrsVersion::v4_0_0,
      true}}};

/// Shows one of these; false: the words name none.
bool start_other(Scene& scene, std::string_view name) {
  Display& display = scene.player.display();
  const auto* text =
      std::find_if(kOtherTexts.begin(), kOtherTexts.end(), [&](const OtherText& each) { return each.name == name; });
  if (text == kOtherTexts.end()) return false;
  if (display.config.srs < text->since) return true;  // that version does not have it
  const dmi::Words system = dmi::ntc_label(display, display.nid_ntc);
  const std::string words = (text->national ? std::string(system.view()) : std::string()) + std::string(text->words);
  const std::uint16_t id = add_text(scene, words, true, text->acknowledge);
  display.texts[display.texts.size() - 1].kind = port::TextKind::national;
  if (text->acknowledge) (void)display.acks.push_back({Ack::text, id, scene.player.now()});
  return true;
}

/// A button of the main window was selected.
void end_until_main_window(Display& display) {
  display.texts.erase_if([](const port::DisplayedText& text) {
    const std::string_view words(text.characters.data(), text.length);
    return text.kind == port::TextKind::national &&
           std::any_of(kOtherTexts.begin(), kOtherTexts.end(),
                       [&](const OtherText& each) { return each.until_main_window && each.words == words; });
  });
}

/// What is to be acknowledged stays.
void end_others(Display& display) {
  display.texts.erase_if(
      [](const port::DisplayedText& text) { return text.kind == port::TextKind::national && !text.acknowledge; });
}

/// The text with whose name the words begin; that of a national system begins with "[name of NTC]", and 4.0.0 names the
/// network that failed.
std::optional<StatusText> text_named(std::string_view words) {
  std::string named(words);
  constexpr std::array<std::pair<std::string_view, std::string_view>, 2> called{
      {{"[name of NTC]", "National system"}, {"GSM-R network", "Radio network"}}};
  for (const auto& [said, name] : called)
    if (words.substr(0, said.size()) == said) named = std::string(name) + std::string(words.substr(said.size()));
  for (const auto& row : kStatusTextRows)
    if (named.rfind(row.name, 0) == 0) return row.value;
  return std::nullopt;
}

/// The condition of 4.6.3 that the words name: "SH refused [4.6.3 35]".
std::optional<int> condition_in(std::string_view words) {
  constexpr std::string_view clause = "4.6.3 ";
  const std::size_t at = words.find(clause);
  if (at == std::string_view::npos) return std::nullopt;
  int number = 0;
  for (const char c : words.substr(at + clause.size())) {
    if (c < '0' || c > '9' || number > 99) break;
    number = 10 * number + (c - '0');
  }
  return number;
}

/// The first condition of 4.6.3 by which this is the reason of a trip.
std::optional<int> trip_of(StatusText text) {
  for (int condition = 1; condition <= 99; ++condition)
    if (driver::trip_reason(condition) == text) return condition;
  return std::nullopt;
}

/// A mode that shows the output: that of the case if it does.
void enter_mode_that_shows(Display& display, driver::Output output) {
  if (driver::allowed(output, display.mode, display.config.srs)) return;
  for (const auto& row : kModeRows)
    if (driver::allowed(output, row.value, display.config.srs)) {
      display.mode = row.value;
      return;
    }
}

void start(Scene& scene, const JsonPlace& place, Start& facts) {
  Display& display = scene.player.display();
  const std::string& words = place.string();
  if (start_other(scene, words)) return;
  const auto text = text_named(words);
  if (!text) place.fail("the name of a system status text, or \"first end condition met\"");
  const auto* row = std::find_if(driver::srs_status_texts.begin(), driver::srs_status_texts.end(),
                                 [&](const driver::StatusRow& each) { return each.text == *text; });
  auto condition = condition_in(words);
  if (!condition && row == driver::srs_status_texts.end()) condition = trip_of(*text);
  if (condition) {
    if (driver::trip_reason(*condition) != text) place.fail("a condition of 4.6.3 that trips with this reason");
    driver::enter_trip(scene.status_texts, *condition);
    enter_mode_that_shows(display, driver::Output::trip_reason);
    return;
  }
  if (row->inform) facts.inform.add(*row->inform);
  if (row->unsuitable) facts.unsuitable.add(*row->unsuitable);
  facts.brakes |= row->brakes;
  if (row->entering) display.mode = *row->entering;
  facts.described_under_train &= !row->entering;
  enter_mode_that_shows(display, row->output);
}

void step(Scene& scene, const Start& start, bool main_window) {
  Display& display = scene.player.display();
  driver::StatusFacts facts;
  facts.now = scene.player.now();
  facts.mode = display.mode;
  facts.srs = display.config.srs;
  facts.inform = start.inform;
  facts.brakes = start.brakes;
  facts.unsuitable = start.unsuitable;
  facts.described_under_train = start.described_under_train;
  facts.main_window_selection = main_window;
  driver::step(scene.status_texts, facts);
  display.texts.erase_if([](const port::DisplayedText& text) { return text.kind == port::TextKind::status; });
  for (const auto& row : kStatusTextRows) {
    if (!scene.status_texts.shown.has(row.value)) continue;
    port::DisplayedText text;
    text.id = static_cast<std::uint16_t>(port::kFirstStatusId + terms::index(row.value));
    text.kind = port::TextKind::status;
    text.status = row.value;
    text.nid_ntc = display.nid_ntc;
    text.important = true;
    text.acknowledge = asks_acknowledgement(row.value);
    text.since = scene.status_texts.since[terms::index(row.value)];
    text.minute_of_day = std::uint16_t{12 * 60};
    (void)display.texts.push_back(text);
    if (text.acknowledge) (void)display.acks.push_back({Ack::text, text.id, facts.now});
  }
}

}  // namespace

void play_status_texts(Scene& scene, const JsonPlace& given) {
  const JsonPlace list = given["system_status"];
  const auto after = given.find("t_after_start_s");
  const bool pressed = given.find("press").has_value();
  Start facts;
  bool ended = false;
  for (std::size_t i = 0; i < list.size(); ++i)
    if (list[i].string() == kEnded)
      ended = true;
    else
      start(scene, list[i], facts);
  step(scene, facts, false);
  scene.player.show();
  if (after) {
    scene.player.run_to(ms_of(*after));
    step(scene, {}, false);
  } else if (ended) {
    // The reason has ended, 30 s have gone by, and a button of the main window was touched: each is the end of some
    // text.
    end_others(scene.player.display());
    step(scene, {}, false);
    scene.player.run_to(scene.player.now_ms() + 31000);
    step(scene, {}, true);
  }
  if (pressed) {
    (void)open_window(scene, "Main");
    (void)scene.player.touch(Action{ActionKind::button, static_cast<std::uint8_t>(Button::driver_id)});
    const bool selected = std::any_of(scene.player.sent().begin(), scene.player.sent().end(),
                                      [](const auto& sent) { return sent.actions.has(port::Select::main); });
    step(scene, {}, selected);
    if (selected) end_until_main_window(scene.player.display());
  }
  scene.player.run_to(scene.player.now_ms() + 100);
}

}  // namespace evc::screen
