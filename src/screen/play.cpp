#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <string_view>

#include "base/units.h"
#include "dmi/drawing.h"
#include "dmi/entry.h"
#include "dmi/labels.h"
#include "dmi/touch.h"
#include "dmi/windows.h"
#include "screen/scene.h"

namespace evc::screen {
namespace {

using dmi::Action;
using dmi::ActionKind;
using dmi::Area;
using io::JsonPlace;
using port::Display;

constexpr std::int64_t kBegin = 100;  // ms: what a case does to an open window
constexpr std::uint8_t kDelete = 10;  // the key Del

bool begins(std::string_view text, std::string_view with) { return text.substr(0, with.size()) == with; }

/// "what" of "mode what".
std::optional<std::string_view> behind(std::string_view text, std::string_view with) {
  if (!begins(text, with)) return std::nullopt;
  return text.substr(with.size());
}

/// The middle of what a case calls so: an area, or a place that reacts to touch ("close", "Yes", "Start"). Throws
/// ReadError.
dmi::Cell middle_named(const Scene& scene, std::string_view name, const JsonPlace& p) {
  for (const dmi::AreaRow& row : dmi::kAreaRows)
    if (name == row.name) return middle_of(row.at);
  const auto screen = scene.player.screen();
  for (const dmi::Touch& touch : screen->touch)
    if (touch.name.view() == name) return middle_of(touch.abs);
  p.fail("the name of an area or of a place that reacts to touch");
}

bool is_area(std::string_view name) {
  return std::any_of(dmi::kAreaRows.begin(), dmi::kAreaRows.end(),
                     [&](const dmi::AreaRow& row) { return name == row.name; });
}

/// Touches an area for `ms`, a place that has its own name as long as a button of its type needs to act.
void touch_named(Scene& scene, std::string_view name, const JsonPlace& p, std::int64_t ms) {
  Player& player = scene.player;
  const dmi::Cell at = middle_named(scene, name, p);
  const dmi::Targets targets = is_area(name) ? dmi::Targets{} : dmi::targets(player.state());
  for (const dmi::Target& target : targets) {
    if (!dmi::inside(target.abs, at.x, at.y)) continue;
    (void)player.touch(target);
    return;
  }
  (void)player.press(at);
  player.run_to(player.now_ms() + ms);
  player.release();
}

std::string characters_of(const Display& display, std::uint16_t id) {
  for (const port::DisplayedText& text : display.texts)
    if (text.id == id) return {text.characters.data(), text.length};
  return {};
}

bool key(Scene& scene, int number) {
  const auto target = scene.player.target(Action{ActionKind::key, static_cast<std::uint8_t>(number)});
  if (!target || !scene.player.press(middle_of(target->abs))) return false;
  scene.player.release();
  return true;
}

/// The number behind "key " or "field ", 1 to 99.
int number_behind(std::string_view digits, const JsonPlace& event) {
  int number = 0;
  for (const char digit : digits.substr(0, 2)) {
    const bool one = digit >= '0' && digit <= '9';
    if (one) number = 10 * number + (digit - '0');
    if (!one && number > 0) break;  // "key 5 (choice)"
    if (!one) event.fail("a number");
  }
  if (number == 0) event.fail("a number from 1");
  return number;
}

/// Types digits on the keyboard of the selected field.
void type(Scene& scene, std::string_view digits) {
  for (const char digit : digits) {
    (void)key(scene, digit == '0' ? 11 : digit - '0');
    // So long that the same key again is the next character (10.3.2.3).
    scene.player.run_to(scene.player.now_ms() + 2100);
  }
}

bool touch_field(Scene& scene, std::size_t place) {
  return scene.player.touch(Action{ActionKind::field, static_cast<std::uint8_t>(place)});
}

/// The place of a field by its label; it may be on another page.
std::optional<std::size_t> field_labelled(const Scene& scene, std::string_view label) {
  const auto& fields = scene.player.state().entry.fields;
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (dmi::label(fields[i].id, scene.player.state().display.config.srs) == label) return i;
  return std::nullopt;
}

/// Enters the values of the fields of a window, and says Yes.
void complete(Scene& scene) {
  for (std::size_t page = 0; page < dmi::pages_of(scene.player.state()); ++page)
    for (std::size_t i = 0; i < dmi::kFieldsPerPage; ++i) (void)touch_field(scene, scene.player.state().entry.selected);
  (void)scene.player.touch(Action{ActionKind::complete});
}

/// Answers a validation window.
void validate(Scene& scene, bool yes) {
  (void)key(scene, yes ? 8 : 7);
  (void)touch_field(scene, 0);
}

// ---- Events in words --------------------------------------------------------------------------------

std::optional<Status> status_named(std::string_view word) {
  constexpr std::array<std::pair<std::string_view, Status>, 5> all{{{"NoS", Status::Normal},
                                                                    {"IndS", Status::Indication},
                                                                    {"OvS", Status::Overspeed},
                                                                    {"WaS", Status::Warning},
                                                                    {"IntS", Status::Intervention}}};
  for (const auto& [name, status] : all)
    if (name == word) return status;
  return std::nullopt;
}
std::optional<Monitoring> monitoring_named(std::string_view word) {
  for (const auto& row : kMonitoringRows)
    if (row.name == word) return row.value;
  return std::nullopt;
}

std::optional<Mode> mode_named(std::string_view word) {
  for (const ModeRow& row : kModeRows)
    if (row.name == word) return row.value;
  return std::nullopt;
}

/// Mode, monitoring and status, as far as the words say them; a remark in brackets is none of them.
void take_words(Display& display, std::string_view words, const JsonPlace& event) {
  words = words.substr(0, words.find(" ("));
  while (!words.empty()) {
    const std::size_t end = std::min(words.find(' '), words.size());
    const std::string_view word = words.substr(0, end);
    const auto monitoring = monitoring_named(word);
    const auto status = status_named(word);
    const auto mode = mode_named(word);
    if (monitoring) display.monitoring = *monitoring;
    if (status) display.status = *status;
    if (mode) display.mode = *mode;
    if (!monitoring && !status && !mode && word != "mode")
      event.fail("modes, CSM, TSM, RSM, NoS, IndS, OvS, WaS or IntS before and behind the arrow");
    words.remove_prefix(std::min(end + 1, words.size()));
  }
}

/// "SM01" or "SM02", the arrows of the directions.
port::SmDirection direction_named(std::string_view word, const JsonPlace& event) {
  if (word != "SM01" && word != "SM02") event.fail("direction SM01 -> SM02, or the other way round");
  return word == "SM01" ? port::SmDirection::forward : port::SmDirection::backward;
}

/// The buttons that stay in a mode and, when the train moves, without standstill: by Tables 33 to 37 some row of this
/// mode and level enables them.
Set<Button> remaining_buttons(Scene& scene) {
  const Display& display = scene.player.display();
  if (scene.tables) {
    scene.tables->action.standstill = display.standstill;
    scene.tables->action.mode = display.mode;
    return driver::buttons(*scene.tables);
  }
  Set<driver::Fact> denied = scene.denied;
  denied.add(driver::Fact::standstill, !display.standstill);
  Set<Button> stay;
  for (const driver::ButtonRow& row : driver::dmi_11_2)
    if (row.modes.has(display.mode) && (row.needs & denied).empty() &&
        (row.levels.empty() || row.levels.has(display.level)))
      stay.add(row.button);
  return display.buttons & stay;
}

/// A change from one state to another: "TSM IndS -> OvS", "direction SM01 -> SM02".
void change(Scene& scene, const JsonPlace& place) {
  constexpr std::string_view arrow = " -> ";
  const std::string_view event = place.string();
  Display& display = scene.player.display();
  const std::size_t at = event.find(arrow);
  const std::string_view before = event.substr(0, at), after = event.substr(at + arrow.size());
  display.V_P = Speed{40.0};
  display.v = Speed{30.0};
  display.status = Status::Normal;
  if (const auto from = behind(before, "direction ")) {
    display.sm = direction_named(*from, place);
    scene.player.show();
    scene.player.forget_sounds();
    display.sm = direction_named(after, place);
  } else {
    take_words(display, before, place);
    scene.player.show();
    scene.player.forget_sounds();
    const Mode mode = display.mode;
    take_words(display, after, place);
    if (display.mode != mode) display.buttons = remaining_buttons(scene);
  }
  scene.player.run_to(scene.player.now_ms() + kBegin);
}

/// Events that are no change of what is supervised; false: not one of them.
bool happen(Scene& scene, std::string_view event) {
  Player& player = scene.player;
  Display& display = player.display();
  const auto then = [&](auto&& what) {
    player.show();
    player.forget_sounds();
    what();
    player.run_to(player.now_ms() + kBegin);
    return true;
  };
  if (event == "change of MRDT in TSM") {
    display.monitoring = Monitoring::TSM;
    display.status = Status::Indication;
    return then([&] { ++display.MRDT; });
  }
  if (event == "ack request displayed") return then([&] { (void)display.acks.push_back({Ack::OS, 0, player.now()}); });
  if (event == "brake commanded") return then([&] { display.brake = true; });
  if (event == "TTI disappears") {
    display.monitoring = Monitoring::CSM;
    display.TTI = Duration{8.0};
    return then([&] { display.TTI.reset(); });
  }
  if (event == "TTI appears") {
    display.monitoring = Monitoring::CSM;
    return then([&] { display.TTI = Duration{8.0}; });
  }
  if (event == "new text, group 1") return then([&] { (void)add_text(scene, "A", true, false); });
  if (event == "new text, group 2") return then([&] { (void)add_text(scene, "A", false, false); });
  if (event == "brake released, no acknowledgement") {
    display.brake = true;
    return then([&] { display.brake = false; });
  }
  if (event == "brake released by acknowledging ST01") {
    display.brake = true;
    (void)display.acks.push_back({Ack::brake, 0, player.now()});
    player.show();
    (void)player.press(middle_of(dmi::rect_of(Area::C9)));
    player.forget_sounds();  // the click
    player.release();
    player.run_to(player.now_ms() + kBegin);
    return true;
  }
  if (event == "ATO asks for a warning sound") return then([&] { display.ato.warning_sound = true; });
  if (event == "button pressed") return then([&] { (void)player.press(middle_of(dmi::rect_of(Area::F1))); });
  if (event == "train moves (not standstill)")
    return then([&] {
      display.standstill = false;
      display.buttons = remaining_buttons(scene);
    });
  return false;
}

void play_event(Scene& scene, const JsonPlace& event) {
  if (event.string().find(" -> ") != std::string::npos)
    change(scene, event);
  else if (!happen(scene, event.string()))
    event.fail("an event that docs/dmi.md lists");
}

// ---- Track conditions and texts one after another ------------------------------------------------------

void start_or_end_condition(Scene& scene, const JsonPlace& step) {
  const std::string_view text = step.string();
  const std::size_t blank = std::min(text.find(' '), text.size());
  const std::string_view name = text.substr(0, blank), what = text.substr(blank);
  const auto* row =
      std::find_if(kPictureRows.begin(), kPictureRows.end(), [&](const PictureRow& each) { return each.name == name; });
  if (row == kPictureRows.end() || (what != " starts" && what != " ends"))
    step.fail("a symbol that starts or ends, as \"TC03 starts\", a text that is shown, or \"acknowledged\"");
  const Picture picture = row->value;
  Display& display = scene.player.display();
  if (what == " starts") {
    // Other than that of every symbol that is shown, also after some of them have ended.
    std::uint16_t id = 1;
    for (const port::DisplayedCondition& condition : display.conditions)
      id = std::max(id, static_cast<std::uint16_t>(condition.id + 1));
    if (!display.conditions.push_back({id, picture, ConditionPhase::active})) step.fail("fewer conditions");
  } else {
    display.conditions.erase_if([&](const auto& condition) { return condition.picture == picture; });
  }
  scene.player.run_to(scene.player.now_ms() + kBegin);
}

/// "17:33" in the words of a step; none: they have no time.
std::optional<std::uint16_t> minute_in(std::string_view words) {
  const std::size_t colon = words.find(':');
  if (colon == std::string_view::npos || colon < 2 || colon + 2 >= words.size()) return std::nullopt;
  int minute = 0;
  for (const std::size_t at : {colon - 2, colon - 1, colon + 1, colon + 2}) {
    if (words[at] < '0' || words[at] > '9') return std::nullopt;
    minute += (words[at] - '0') * (at == colon - 2 ? 600 : at == colon - 1 ? 60 : at == colon + 1 ? 10 : 1);
  }
  return static_cast<std::uint16_t>(minute);
}

/// "text X (group 1, 17:33, ack) shown"; the id of the text.
std::uint16_t show_text(Scene& scene, std::string_view step) {
  const std::string_view begun = step.substr(std::string_view("text ").size());
  const std::string_view name = begun.substr(0, std::min(begun.find(" ("), begun.find(" shown")));
  const bool auxiliary = step.find("group 2") != std::string_view::npos;
  const bool asks = step.find(", ack)") != std::string_view::npos;
  const std::uint16_t id = add_text(scene, name, !auxiliary, asks);
  Display& display = scene.player.display();
  if (const auto minute = minute_in(step)) display.texts[display.texts.size() - 1].minute_of_day = *minute;
  if (asks) (void)display.acks.push_back({Ack::text, id, scene.player.now()});
  return id;
}

void play_sequence(Scene& scene, const JsonPlace& sequence) {
  std::uint16_t shown = 0;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    const std::string& step = sequence[i].string();
    if (begins(step, "text ")) {
      shown = show_text(scene, step);
      scene.player.run_to(scene.player.now_ms() + kBegin);
    } else if (begins(step, "acknowledged")) {
      (void)scene.player.press(middle_of(dmi::rect_of(Area::E7)));
      scene.player.forget_sounds();  // the click
      scene.player.release();
      // The acknowledgement may be the end of the text (8.2.3.4.8 c).
      if (step.find("display ended") != std::string::npos)
        scene.player.display().texts.erase_if([&](const port::DisplayedText& text) { return text.id == shown; });
      scene.player.run_to(scene.player.now_ms() + kBegin);
    } else {
      start_or_end_condition(scene, sequence[i]);
    }
  }
}

// ---- Buttons (015560 5.3.2.6) -----------------------------------------------------------------------------------

/// How often the watched button has acted.
int acts_of(const Scene& scene, const Action& action) {
  const dmi::State& state = scene.player.state();
  if (action.kind == ActionKind::open) return state.window == static_cast<dmi::WindowId>(action.argument) ? 1 : 0;
  if (action.kind == ActionKind::key) {
    const int typed = state.entry.fields[state.entry.selected].value.typed.length;
    return action.argument == kDelete ? 16 - typed : typed;
  }
  int acts = 0;
  for (const dmi::Commands& sent : scene.player.sent())
    if (sent.actions.has(port::Select::non_leading)) ++acts;
  return acts;
}

Action watched_action(Scene& scene, const JsonPlace& button) {
  const std::string& type = button.string();
  if (type == "up") return {ActionKind::open, static_cast<std::uint8_t>(dmi::WindowId::main)};
  if (type == "delay") {
    (void)open_window(scene, "Main");
    return {ActionKind::button, static_cast<std::uint8_t>(Button::non_leading)};
  }
  if (type == "down") {  // a key of an empty field
    scene.player.display().data.stored.train_running_number_status = DataStatus::unknown;
    scene.player.show();
    (void)open_window(scene, "Train running number");
    return {ActionKind::key, 5};
  }
  if (type != "down, repeat") button.fail("up, delay, down, or down, repeat");
  // The key Del of a full field.
  scene.player.display().data.stored.driver_id = DriverId{"1234567890123456"};
  scene.player.show();
  (void)open_window(scene, "Driver ID");
  return {ActionKind::key, kDelete};
}

void watch(Scene& scene, std::string_view what) {
  const int before = scene.watched.activations;
  scene.watched.activations = acts_of(scene, scene.watched.target->action);
  if (before == 0 && scene.watched.activations > 0 && scene.watched.acted_at.empty()) scene.watched.acted_at = what;
  scene.watched.pressed[scene.player.now_ms()] =
      dmi::looks_pressed(scene.player.state(), scene.watched.target->action, scene.player.now());
}

/// "press t0", "slide out t1.5", "release inside t0.3": without a time a tenth of a second after the one before.
void play_finger(Scene& scene, const JsonPlace& button, const JsonPlace& events) {
  const Action action = watched_action(scene, button);
  scene.watched.target = scene.player.target(action);
  if (!scene.watched.target) return;
  scene.watched.activations = acts_of(scene, action);
  scene.player.forget_sounds();
  const std::int64_t begin = scene.player.now_ms();
  const dmi::Cell inside = middle_of(scene.watched.target->abs), outside{1, 1};
  for (std::size_t i = 0; i < events.size(); ++i) {
    const std::string& event = events[i].string();
    const std::size_t time = event.rfind(" t");
    const bool timed =
        time != std::string::npos && time + 2 < event.size() && event[time + 2] >= '0' && event[time + 2] <= '9';
    const std::int64_t at =
        timed ? begin + static_cast<std::int64_t>(std::strtod(event.c_str() + time + 2, nullptr) * 1000.0 + 0.5)
              : scene.player.now_ms() + (i == 0 ? 0 : 100);
    while (scene.player.now_ms() < at) {
      scene.player.run_to(std::min(at, scene.player.now_ms() + 50));
      watch(scene, "hold");
    }
    if (begins(event, "press")) {
      (void)scene.player.press(inside);
      watch(scene, "press");
    } else if (begins(event, "slide out")) {
      scene.player.slide(outside);
    } else if (begins(event, "slide back")) {
      scene.player.slide(inside);
    } else if (begins(event, "release")) {
      scene.player.release();
      watch(scene, "release");
    } else {
      events[i].fail("press, slide out, slide back or release");
    }
  }
}

// ---- Windows ------------------------------------------------------------------------------------------------

void play_in_window(Scene& scene, const JsonPlace& event) {
  std::string_view text = event.string();
  // A time in front: "t1.5 key 3".
  if (text.size() > 1 && text[0] == 't' && text[1] >= '0' && text[1] <= '9') {
    const std::int64_t offset = static_cast<std::int64_t>(std::strtod(text.data() + 1, nullptr) * 1000.0 + 0.5);
    scene.player.run_to(std::max(scene.player.now_ms(), 10000 + offset));
    text.remove_prefix(text.find(' ') + 1);
  }
  if (const auto number = behind(text, "key ")) {
    (void)key(scene, number_behind(*number, event));
  } else if (const auto field = behind(text, "touch data field ")) {
    (void)touch_field(scene, static_cast<std::size_t>(number_behind(*field, event) - 1));
  } else if (const auto selected = behind(text, "select field ")) {
    (void)touch_field(scene, static_cast<std::size_t>(number_behind(*selected, event) - 1));
  } else if (const auto touched = behind(text, "touch field ")) {
    (void)touch_field(scene, static_cast<std::size_t>(number_behind(*touched, event) - 1));
  } else if (const auto touched_place = behind(text, "touch ")) {
    touch_named(scene, *touched_place, event, 0);
    scene.toggled.push_back(scene.player.state().toggles.speed);
  } else {
    event.fail("an event that docs/dmi.md lists");
  }
}

void play_entry(Scene& scene, const JsonPlace& given) {
  if (const auto entered = given.find("enter")) {
    const auto place = field_labelled(scene, given["field"].string());
    if (!place) given["field"].fail("the label of a field of the window");
    if (scene.player.state().entry.selected != *place) (void)touch_field(scene, *place);
    type(scene, entered->string());
    (void)touch_field(scene, *place);
  }
  if (const auto code = given.find("code")) {
    type(scene, code->string());
    complete(scene);
    validate(scene, true);
  }
  if (const auto id = given.find("RBC ID")) {
    type(scene, id->string());
    (void)touch_field(scene, 0);
    complete(scene);
  }
  if (const auto accept = given.find("accept")) validate(scene, accept->one_of({"No", "Yes"}) == 1);
  if (const auto data = given.find("data")) {
    type(scene, data->string());
    (void)touch_field(scene, 0);
    (void)open_window(scene, "Driver ID");
  }
}

void play_press(Scene& scene, const JsonPlace& press) {
  if (press.string() == "Yes") {
    // Each field is accepted, and the first one is selected again.
    for (std::size_t i = scene.player.state().entry.fields.size(); i > 0; --i)
      (void)touch_field(scene, scene.player.state().entry.selected);
    (void)scene.player.touch(Action{ActionKind::complete});
    return;
  }
  touch_named(scene, press.string(), press, kBegin);
  scene.player.show();
}

void play_modes(Scene& scene, const JsonPlace& modes) {
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const std::string& text = modes[i].string();
    const io::Json name = text.substr(0, text.find(' '));
    scene.player.display().mode = JsonPlace(name, modes.file()).term<kModeRows>();
    scene.player.run_to(scene.player.now_ms() + kBegin);
    if (text.find("toggled on") != std::string::npos) (void)scene.player.touch(Action{ActionKind::toggle_speed});
  }
}

/// The labels of the keys, as the case calls them.
std::vector<std::string> key_labels(const Scene& scene, int last) {
  std::vector<std::string> labels;
  for (int n = 1; n <= last; ++n) {
    const dmi::Key shown = dmi::key_at(scene.player.state(), n);
    if (shown.label.empty()) continue;
    const auto called = scene.labels.find(std::string(shown.label.view()));
    labels.push_back(called == scene.labels.end() ? std::string(shown.label.view()) : called->second);
  }
  return labels;
}

/// Key 12 twice, and back to the begin: what `must` asks for is the first page.
void turn_choices(Scene& scene) {
  if (!key(scene, 12)) return;
  scene.choices_after_more = key_labels(scene, 11);
  (void)key(scene, 12);
  scene.choices_after_second_more = key_labels(scene, 11);
}

// ---- Events with times ----------------------------------------------------------------------------------------

void press_or_acknowledge(Scene& scene, const JsonPlace& event, std::int64_t at) {
  Player& player = scene.player;
  if (event.find("ack")) {
    // Touched so that it acts at this moment.
    const auto target = player.target(Action{ActionKind::ack});
    if (!target) return;
    player.run_to(at - (target->type == dmi::ButtonType::delay ? 2100 : 100));
    (void)player.press(middle_of(target->abs));
    player.run_to(at);
    player.release();
  }
  if (const auto press = event.find("press")) (void)player.press(middle_named(scene, press->string(), *press));
  if (event.find("slide_out")) player.slide({1, 1});
  if (event.find("release")) player.release();
}

/// Takes back what `add_request` asked for (015560 5.4.1.9).
void revoke(Scene& scene, const JsonPlace& request) {
  Display& display = scene.player.display();
  const std::string& name = request.string();
  const auto asked_once =
      std::any_of(scene.names.begin(), scene.names.end(), [&](const auto& named) { return named.second == name; });
  Ack what = Ack::text;
  if (const auto mode = behind(name, "mode ")) {
    const io::Json ack = std::string(*mode);
    what = ack_named(JsonPlace(ack, request.file()));
  } else if (name == "level 0" || name == "level NTC") {
    what = Ack::level;
    const Level level = name == "level 0" ? Level::L0 : Level::NTC;
    if (!display.announced_level || display.announced_level->level != level)
      request.fail("the level that is announced");
    display.announced_level.reset();
  } else if (name == "brake release") {
    what = Ack::brake;
    display.brake = false;
  } else if (!asked_once) {
    request.fail("what was requested before");
  }
  display.acks.erase_if([&](const port::AskedAck& asked) {
    return asked.what == what && (what != Ack::text || scene.names[asked.id] == name);
  });
}

void play_timed(Scene& scene, const JsonPlace& event) {
  event.know_only({"t", "request", "revoke", "ack", "press", "release", "slide_out", "start_up", "window"});
  Display& display = scene.player.display();
  press_or_acknowledge(scene, event, ms_of(event["t"]));
  if (const auto request = event.find("request")) add_request(scene, *request);
  if (const auto request = event.find("revoke")) revoke(scene, *request);
  if (const auto window = event.find("window"); window && !open_window(scene, window->string()))
    window->fail("a window that can be opened from \"" + std::string(dmi::row_of(scene.player.state().window).title) +
                 "\"");
  if (const auto running = event.find("start_up")) {
    display.start_of_mission = running->one_of({"ended", "running"}) == 1;
    display.step = display.start_of_mission ? std::optional(Dialogue::start_S1) : std::nullopt;
  }
}

/// How long before its time an event has to be begun.
std::int64_t lead_of(const JsonPlace& event) { return event.find("ack") ? 2200 : 0; }

}  // namespace

std::int64_t ms_of(const JsonPlace& seconds) {
  return static_cast<std::int64_t>(seconds.number(0.0, 1e6) * 1000.0 + 0.5);
}

Picture picture_named(const JsonPlace& place) {
  for (const PictureRow& row : kPictureRows)
    if (place.string() == row.name) return row.value;
  place.fail("the name of a symbol, as PL21");
}

std::uint16_t add_text(Scene& scene, std::string_view words, bool important, bool acknowledge) {
  port::DisplayedText text;
  text.id = scene.next_text++;
  text.important = important;
  text.acknowledge = acknowledge;
  text.since = scene.player.now();
  text.minute_of_day = std::uint16_t{12 * 60};
  text.length = static_cast<std::uint8_t>(std::min<std::size_t>(words.size(), text.characters.size()));
  std::copy_n(words.begin(), text.length, text.characters.begin());
  (void)scene.player.display().texts.push_back(text);
  return text.id;
}

Ack ack_named(const JsonPlace& mode) { return mode.string() == "TR" ? Ack::trip : mode.term<kAckRows>(); }

void add_request(Scene& scene, const JsonPlace& request) {
  const std::string& name = request.string();
  Display& display = scene.player.display();
  port::AskedAck asked{Ack::text, 0, scene.player.now()};
  if (const auto mode = behind(name, "mode ")) {
    const io::Json ack = std::string(*mode);
    asked.what = ack_named(JsonPlace(ack, request.file()));
  } else if (const auto level = behind(name, "level ")) {
    if (*level != "0" && *level != "NTC") request.fail("level 0 or level NTC (5.10.4.1)");
    asked.what = Ack::level;
    display.announced_level = {*level == "0" ? Level::L0 : Level::NTC, 0};
  } else if (name == "brake release") {
    asked.what = Ack::brake;
    display.brake = true;
  } else if (begins(name, "text ") || name == "plain text" || name == "fixed text" || name == "system status" ||
             name == "NTC text") {
    asked.id = add_text(scene, name.substr(std::min<std::size_t>(name.size(), 5)), true, true);
    scene.names[asked.id] = name;
    port::DisplayedText& text = display.texts[display.texts.size() - 1];
    if (name == "fixed text") text.kind = port::TextKind::fixed;
    if (name == "fixed text") text.Q_TEXT = 1;
    if (name == "system status") text.kind = port::TextKind::status;
    if (name == "system status") text.status = StatusText::NL_no_longer_permitted;
    if (name == "NTC text") text.kind = port::TextKind::national;
  } else {
    request.fail("a request that docs/dmi.md lists");
  }
  if (!display.acks.push_back(asked)) request.fail("fewer requests");
}

std::optional<std::string> shown_request(const Scene& scene) {
  const auto& offered = scene.player.state().offered;
  const auto screen = scene.player.screen();
  if (!offered || screen->flashing.empty()) return std::nullopt;
  if (screen->flashing[0] == Area::E5_E9) {
    const auto called = scene.names.find(offered->ack.id);
    return called == scene.names.end() ? characters_of(scene.player.state().display, offered->ack.id) : called->second;
  }
  for (const dmi::Item& item : screen->items)
    if (item.kind == dmi::Kind::symbol && item.area == screen->flashing[0] && item.picture) return name(*item.picture);
  return std::nullopt;
}

bool open_window(Scene& scene, std::string_view title) {
  Player& player = scene.player;
  for (std::size_t i = 0; i < dmi::kWindows; ++i) {
    const dmi::WindowRow& row = dmi::row_of(static_cast<dmi::WindowId>(i));
    if (row.title != title && dmi::title_of(player.state(), row.id).view() != title) continue;
    if (player.state().window == row.id) return true;
    if (row.id == dmi::WindowId::default_) return false;  // another window is open
    if (row.layout == dmi::Layout::validation) {
      // What is validated is entered before: the stored train data, or a code of a cover (NID_C 926, number 48).
      const std::string_view entered = title.substr(std::string_view("Validate ").size());
      const bool set = entered == "set VBC", removed = entered == "remove VBC";
      if (!open_window(scene, set ? "Set VBC" : removed ? "Remove VBC" : "Train data")) return false;
      if (set || removed) type(scene, set ? "321456" : "50078");
      complete(scene);
      return player.state().window == row.id;
    }
    const auto opening = Action{ActionKind::open, static_cast<std::uint8_t>(row.id)};
    if (!player.target(opening) && row.parent != dmi::WindowId::default_ &&
        !open_window(scene, dmi::row_of(row.parent).title))
      return false;
    if (player.target(opening))
      (void)player.touch(opening);
    else
      (void)player.touch(Action{ActionKind::button, static_cast<std::uint8_t>(row.button)});
    return player.state().window == row.id;
  }
  return false;
}

void play_events_to(Scene& scene, const JsonPlace& events, std::size_t& next, std::int64_t ms) {
  while (next < events.size() && ms_of(events[next]["t"]) <= ms) {
    const std::int64_t at = ms_of(events[next]["t"]);
    scene.player.run_to(std::max(scene.player.now_ms(), at - lead_of(events[next])));
    // What happens at one moment is shown in one cycle.
    for (; next < events.size() && ms_of(events[next]["t"]) == at; ++next) play_timed(scene, events[next]);
    scene.player.run_to(std::max(at, scene.player.now_ms()));
    scene.player.show();
  }
  scene.player.run_to(std::max(ms, scene.player.now_ms()));
}

void play(Scene& scene, const JsonPlace& given, const JsonPlace& expect) {
  if (expect.find("sounds") && !given.find("event")) scene.player.forget_sounds();
  if (const auto shown = given.find("ack_shown")) add_request(scene, *shown);
  if (const auto list = given.find("fifo"))
    for (std::size_t i = 0; i < list->size(); ++i) {
      scene.player.run_to(scene.player.now_ms() + kBegin);
      add_request(scene, (*list)[i]);
    }
  if (given.find("ack_shown")) scene.player.run_to(scene.player.now_ms() + kBegin);
  port::Waiting waits = port::Waiting::nothing;
  // The hour glass is in the title of one of two windows (015560 11.2.1.6, 11.2.5.6).
  if (const auto waiting = given.find("waiting"); waiting && waiting->boolean())
    waits = scene.player.state().window == dmi::WindowId::radio_data ? port::Waiting::network_list
                                                                     : port::Waiting::answer_to_ma_request;
  if (scene.step != nullptr && scene.step->waiting != port::Waiting::nothing) waits = scene.step->waiting;
  if (waits != port::Waiting::nothing) {
    scene.player.display().waiting = waits;
    const std::int64_t begin = scene.player.now_ms();
    scene.player.show();
    if (const auto passed = given.find("t_s")) scene.player.run_to(begin + ms_of(*passed));
  }
  if (const auto layout = given.find("layout");
      layout && layout->one_of({"flexible", "fixed"}) == 1 && !scene.player.state().fixed_train_entry)
    (void)scene.player.touch(Action{ActionKind::switch_entry});
  if (given.find("system_status")) return play_status_texts(scene, given);
  play_entry(scene, given);
  if (const auto sequence = given.find("sequence")) play_sequence(scene, *sequence);
  if (const auto modes = given.find("mode_sequence")) play_modes(scene, *modes);
  if (const auto event = given.find("event")) play_event(scene, *event);
  if (const auto press = given.find("press")) play_press(scene, *press);
  if (const auto presses = given.find("presses"))
    for (std::size_t i = 0; i < presses->size(); ++i) play_press(scene, (*presses)[i]);
  if (const auto events = given.find("events"); events && events->size() > 0 && (*events)[0].is_string()) {
    if (const auto button = given.find("button")) return play_finger(scene, *button, *events);
    for (std::size_t i = 0; i < events->size(); ++i) play_in_window(scene, (*events)[i]);
  }
  if (given.find("choices")) turn_choices(scene);
}

}  // namespace evc::screen
