#include "screen/cases.h"

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "dmi/entry.h"
#include "dmi/geometry.h"
#include "dmi/windows.h"
#include "io/file.h"
#include "screen/scene.h"

namespace evc::screen {
namespace {

using dmi::Action;
using dmi::ActionKind;
using io::JsonPlace;

OrderedJson sounds_of(const Scene& scene) {
  OrderedJson out = OrderedJson::array();
  for (const Player::Heard& heard : scene.player.heard()) out.push_back(json_of(heard.order));
  return out;
}

/// Choices have the names of the case.
OrderedJson renamed(OrderedJson items, const std::map<std::string, std::string>& labels) {
  for (OrderedJson& item : items) {
    if (!item.contains("label") || !item["label"].is_string()) continue;
    if (const auto called = labels.find(item["label"].get<std::string>()); called != labels.end())
      item["label"] = called->second;
  }
  return items;
}

/// Lines of E5 to E9: time, words and style of each.
OrderedJson lines_of(const dmi::Screen& screen) {
  std::map<dmi::Area, OrderedJson> rows;
  for (const dmi::Item& item : screen.items) {
    if (item.kind != dmi::Kind::text || item.area < dmi::Area::E5 || item.area > dmi::Area::E9) continue;
    OrderedJson& row = rows.try_emplace(item.area, OrderedJson{"", "", ""}).first->second;
    const bool time = item.height == 10;  // 015560 8.2.3.4.6
    row[time ? 0 : 1] = std::string(item.text.view());
    row[2] = item.bold ? "bold" : "regular";
  }
  OrderedJson out = OrderedJson::array();
  for (auto& [area, row] : rows) out.push_back(std::move(row));
  return out;
}

/// One moment of a timeline, with what the case asks for.
OrderedJson moment_of(const Scene& scene, const JsonPlace& asked, std::int64_t begin) {
  OrderedJson out{{"t", asked["t"].number()}};
  const auto screen = scene.player.screen();
  const auto shown = [&](dmi::Kind kind) {
    return std::any_of(screen->items.begin(), screen->items.end(),
                       [&](const dmi::Item& item) { return item.kind == kind; });
  };
  if (asked.find("shown")) {
    const auto request = shown_request(scene);
    out["shown"] = request ? OrderedJson(*request) : OrderedJson();
  }
  if (asked.find("frame")) out["frame"] = shown(dmi::Kind::frame);
  if (asked.find("cursor")) out["cursor"] = shown(dmi::Kind::cursor);
  if (asked.find("frame_area"))
    out["frame_area"] = screen->flashing.empty() ? OrderedJson() : OrderedJson(dmi::name(screen->flashing[0]));
  if (asked.find("window")) out["window"] = std::string(screen->window.view());
  if (asked.find("sound")) {
    out["sound"] = nullptr;
    const auto at = static_cast<std::int64_t>(asked["t"].number() * 1000.0 + 0.5) + begin;
    for (const Player::Heard& heard : scene.player.heard())
      if (heard.ms == at && heard.order.sound != dmi::Sound::click) out["sound"] = dmi::name(heard.order.sound);
  }
  return out;
}

OrderedJson timeline_of(Scene& scene, const JsonPlace& given, const JsonPlace& asked) {
  OrderedJson out = OrderedJson::array();
  std::size_t next = 0;
  // A cursor or frame begins at a whole second.
  const std::int64_t begin = given.find("events") ? 0 : (scene.player.now_ms() / 1000 + 1) * 1000;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const auto ms = begin + ms_of(asked[i]["t"]);
    if (const auto events = given.find("events"))
      play_events_to(scene, *events, next, ms);
    else
      scene.player.run_to(ms);
    out.push_back(moment_of(scene, asked[i], begin));
  }
  return out;
}

bool enabled(const Scene& scene, Action action) {
  const auto target = scene.player.target(action);
  return target && target->enabled;
}

Action selected_field(const Scene& scene) { return {ActionKind::field, scene.player.state().entry.selected}; }

std::string window_words(const Scene& scene) {
  const dmi::State& state = scene.player.state();
  std::string words(dmi::title_of(state, state.window).view());
  if (dmi::pages_of(state) > 1) words += " page " + std::to_string(state.page + 1);
  return words;
}

/// What the driver has sent last of a kind.
template <class Of>
auto last_sent(const Scene& scene, Of of) {
  decltype(of(scene.player.sent().front())) last{};
  for (const dmi::Commands& sent : scene.player.sent())
    if (const auto value = of(sent)) last = value;
  return last;
}

OrderedJson states_of(const Scene& scene, const JsonPlace& asked) {
  OrderedJson out = OrderedJson::array();
  if (scene.watched.pressed.empty()) return out;
  const std::int64_t begin = scene.watched.pressed.begin()->first;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const double t = asked[i][std::size_t{0}].number(0.0, 1000.0);
    const auto seen = scene.watched.pressed.find(begin + static_cast<std::int64_t>(t * 1000.0 + 0.5));
    const bool pressed = seen != scene.watched.pressed.end() && seen->second;
    out.push_back({t, pressed ? "pressed" : "enabled"});
  }
  return out;
}

int clicks(const Scene& scene) {
  int count = 0;
  for (const Player::Heard& heard : scene.player.heard()) count += heard.order.sound == dmi::Sound::click ? 1 : 0;
  return count;
}

/// "values of the previous entry" where the fields hold what was entered before the validation.
OrderedJson proposed_of(const Scene& scene) {
  const dmi::State& state = scene.player.state();
  const auto& before = state.validated.fields;
  const auto& now = state.entry.fields;
  bool same = before.size() == now.size() && !now.empty();
  for (std::size_t i = 0; same && i < now.size(); ++i)
    same = before[i].id == now[i].id && before[i].value == now[i].value;
  return same ? OrderedJson("values of the previous entry") : OrderedJson("other values");
}

using Answer = std::function<OrderedJson(const Scene&, const JsonPlace&)>;

const std::map<std::string, Answer, std::less<>>& answers() {
  using S = const Scene&;
  using J = const JsonPlace&;
  static const auto cover = [](S s) {
    return last_sent(s, [](const dmi::Commands& sent) { return sent.actions.cover; })
        .value_or(port::DriverActions::Cover{});
  };
  static const auto rbc = [](S s) {
    return last_sent(s, [](const dmi::Commands& sent) { return sent.actions.rbc_contact; });
  };
  static const auto stored = [](S s) -> OrderedJson {
    return last_sent(s, [](const dmi::Commands& sent) { return sent.train_data; }) ? "replaced" : "unchanged";
  };
  static const std::map<std::string, Answer, std::less<>> all{
      {"range_m", [](S s, J) { return OrderedJson(dmi::kRanges[s.player.state().zoom % dmi::kRanges.size()]); }},
      {"D9_enabled", [](S s, J) { return OrderedJson(enabled(s, {ActionKind::zoom_in})); }},
      {"D12_enabled", [](S s, J) { return OrderedJson(enabled(s, {ActionKind::zoom_out})); }},
      {"toggle_after", [](S s, J) { return OrderedJson(s.toggled); }},
      {"toggle_speed", [](S s, J) { return OrderedJson(s.player.state().toggles.speed); }},
      {"sounds", [](S s, J) { return sounds_of(s); }},
      {"change",
       [](S s, J) {
         return s.player.sent().empty() && !s.player.state().toggles.speed ? OrderedJson() : OrderedJson("changed");
       }},
      {"click", [](S s, J) { return OrderedJson(clicks(s)); }},
      {"activations", [](S s, J) { return OrderedJson(s.watched.activations); }},
      {"activations_min", [](S s, J) { return OrderedJson(s.watched.activations); }},
      {"activations_max", [](S s, J) { return OrderedJson(s.watched.activations); }},
      {"at", [](S s, J) { return OrderedJson(s.watched.acted_at); }},
      {"states", [](S s, J asked) { return states_of(s, asked); }},
      {"window", [](S s, J) { return OrderedJson(window_words(s)); }},
      {"process", [](S s, J) { return OrderedJson(s.player.state().entry.fields.empty() ? "stopped" : "running"); }},
      {"stored_train_data", [](S s, J) { return stored(s); }},
      {"proposed", [](S s, J) { return proposed_of(s); }},
      {"enter_enabled", [](S s, J) { return OrderedJson(enabled(s, selected_field(s))); }},
      {"enter_type", [](S s, J) { return OrderedJson(dmi::enter_is_delayed(s.player.state()) ? "delay" : "up"); }},
      {"yes_type", [](S s, J) { return OrderedJson(dmi::complete_is_delayed(s.player.state()) ? "delay" : "up"); }},
      {"close_enabled", [](S s, J) { return OrderedJson(enabled(s, {ActionKind::close})); }},
      {"next_enabled", [](S s, J) { return OrderedJson(enabled(s, {ActionKind::next})); }},
      {"previous_enabled", [](S s, J) { return OrderedJson(enabled(s, {ActionKind::previous})); }},
      {"yes_enabled", [](S s, J) { return OrderedJson(enabled(s, {ActionKind::complete})); }},
      {"after_More", [](S s, J) { return OrderedJson(s.choices_after_more); }},
      {"after_second_More",
       [](S s, J) {
         const auto& labels = s.choices_after_second_more;
         if (labels.empty()) return OrderedJson();
         return OrderedJson("choices " + labels.front().substr(labels.front().rfind(' ') + 1) + " to " +
                            labels.back().substr(labels.back().rfind(' ') + 1));
       }},
      {"NID_VBCMK", [](S s, J) { return OrderedJson(cover(s).NID_VBCMK); }},
      {"T_VBC", [](S s, J) { return OrderedJson(cover(s).T_VBC); }},
      {"NID_C", [](S s, J) { return OrderedJson(rbc(s) ? rbc(s)->NID_C : cover(s).NID_C); }},
      {"NID_RBC", [](S s, J) { return rbc(s) ? OrderedJson(rbc(s)->NID_RBC) : OrderedJson(); }},
  };
  return all;
}

OrderedJson result_of(const Scene& scene, const JsonPlace& asked) {
  OrderedJson out = OrderedJson::object();
  for (const auto& member : asked.value().items()) {
    const auto found = answers().find(member.key());
    if (found != answers().end()) {
      out[member.key()] = found->second(scene, asked[member.key()]);
      continue;
    }
    for (const dmi::ColourRow& row : dmi::kColourRows)
      if (member.key() == row.name) out[member.key()] = row.rgb;
    if (!out.contains(member.key())) asked[member.key()].fail("a result that docs/dmi.md lists");
  }
  return out;
}

/// How the value of the first field stands on its lines (015560 5.1.5).
OrderedJson display_of(const Scene& scene) {
  const dmi::State& state = scene.player.state();
  if (state.entry.fields.empty()) return nullptr;
  const dmi::Words shown = dmi::shown_value(state, state.entry.fields[0]);
  std::string_view text = shown.view();
  OrderedJson out{{"lines", OrderedJson::array()}, {"lines_chars", OrderedJson::array()}};
  std::size_t spaces = 0, longest = 0;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    const auto blanks = static_cast<std::size_t>(std::count(line.begin(), line.end(), ' '));
    spaces = std::max(spaces, blanks);
    std::size_t group = 0;
    for (const char c : line) {
      group = c == ' ' ? 0 : group + 1;
      longest = std::max(longest, group);
    }
    out["lines"].push_back(std::string(line));
    out["lines_chars"].push_back(line.size() - blanks);
  }
  out["spaces_per_line"] = spaces;
  out["max_group"] = longest;
  return out;
}

/// The place that is touched for what the case is about; null: none.
OrderedJson touched_of(const Scene& scene, const JsonPlace& given) {
  const Action action{given.find("tsa") ? ActionKind::toggle_tunnel : ActionKind::toggle_geo};
  const auto target = scene.player.target(action);
  if (!target) return nullptr;
  return {target->abs.x, target->abs.y, target->abs.w, target->abs.h};
}

bool asks_for_items(const JsonPlace& expect) {
  for (const char* key : {"must", "must_not", "order", "count", "rule", "buttons"})
    if (expect.find(key)) return true;
  return false;
}

}  // namespace

OrderedJson answer(const JsonPlace& one_case) {
  const JsonPlace given = one_case["given"], expect = one_case["expect"];
  const auto scene = std::make_unique<Scene>();
  OrderedJson out{{"id", one_case["id"].string()}};
  set_given(*scene, given, expect);
  play(*scene, given, expect);
  if (const auto asked = expect.find("timeline")) out["timeline"] = timeline_of(*scene, given, *asked);
  const auto screen = scene->player.screen();
  if (asks_for_items(expect)) out["items"] = renamed(items_of(*screen), scene->labels);
  if (expect.find("lines")) out["lines"] = lines_of(*screen);
  if (expect.find("touch")) out["touch"] = touched_of(*scene, given);
  if (expect.find("sounds")) out["sounds"] = sounds_of(*scene);
  if (const auto asked = expect.find("result")) out["result"] = result_of(*scene, *asked);
  if (expect.find("display")) out["display"] = display_of(*scene);
  if (expect.find("ack_required")) out["ack_required"] = shown_request(*scene).has_value();
  return out;
}

int cases(const std::string& input, const std::string& output) {
  using io::complain;
  if (const auto apart = io::not_the_input(input, output); !apart) return complain(apart.error());
  const auto text = io::read_text(input);
  if (!text) return complain(text.error());
  struct Answers {
    std::string lines;
    std::vector<io::Diagnostic> refused;
  };
  const auto answers = io::guarded([&] {
    const io::Json file = io::parse_json(*text, input);
    const JsonPlace list = JsonPlace(file, input)["cases"];
    Answers out;
    for (std::size_t i = 0; i < list.size(); ++i) {
      const std::string id = list[i]["id"].string();
      const auto answered = io::guarded([&] { return answer(list[i]).dump(); });
      // A case that cannot be set takes nothing from the others.
      out.lines += answered ? *answered : OrderedJson{{"id", id}, {"error", answered.error().text()}}.dump();
      out.lines += '\n';
      if (!answered) out.refused.push_back(answered.error());
    }
    return out;
  });
  if (!answers) return complain(answers.error());
  const auto written = io::write_whole(output, answers->lines);
  if (!written) return complain(written.error());
  for (const io::Diagnostic& refused : answers->refused) (void)complain(refused);
  return answers->refused.empty() ? 0 : 1;
}

}  // namespace evc::screen
