#include "screen/cases.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "base/test_paths.h"
#include "dmi/screen.h"
#include "dmi/windows.h"
#include "driver/status_texts.h"
#include "screen/condition_names.h"

// The 495 cases of tests/data/dmi_test_cases.json against their `expect`, as the head of that file explains it, and
// those of windows and dialogues in dmi_window_cases.json.
namespace evc::screen {
namespace {

using io::Json;

Json read_cases(const std::string& name) {
  return Json::parse(std::ifstream(test::source_folder() + "/tests/data/" + name));
}
const Json& file() {
  static const Json cases = read_cases("dmi_test_cases.json");
  return cases;
}

/// Cases that are not compared, each with its reason.
const std::map<std::string, std::string>& exempted() {
  static const std::map<std::string, std::string> all{
      {"HOOK-13",
       "FS has no basic hooks, but the hook of the gauge at the permitted speed, which CSG-01 asks for, is of "
       "the kind hook too"},
  };
  return all;
}

constexpr double kAngle = 0.1, kCells = 1.0, kCentre = 0.5;

bool is_angle(const std::string& key) { return key.find("deg") != std::string::npos; }

/// Words and properties of a case that are not members of an item of that name.
bool is_rule(const std::string& key) { return key == "tol" || key == "over" || key == "area_one_of"; }

bool near(const Json& a, const Json& b, double tolerance) {
  return a.is_number() && b.is_number() && std::abs(a.get<double>() - b.get<double>()) <= tolerance + 1e-9;
}

/// Whether a member of an item is what the case expects.
bool agrees(const std::string& key, const Json& wanted, const Json& found, double tolerance) {
  if (key == "max_w" || key == "max_h") return found.is_number() && found.get<double>() <= wanted.get<double>();
  if (is_angle(key)) return near(found, wanted, kAngle);
  if (key == "centre" || key == "abs" || key == "touch" || key == "rect") {
    if (!found.is_array() || !wanted.is_array() || found.size() < wanted.size()) return false;
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (!near(found[i], wanted[i], key == "centre" ? kCentre : 0.0)) return false;
    return true;
  }
  // Sizes of letters, numbers of fields and counts are exact; places are to a cell.
  const bool exact = key == "height" || key == "label_height" || key == "n" || key == "quarters" || key == "speed" ||
                     key == "from_m" || key == "to_m" || key == "length" || key == "r_out" || key == "r_in";
  if (wanted.is_number()) return near(found, wanted, exact ? 0.0 : tolerance);
  return found == wanted;
}

bool matches(const Json& wanted, const Json& item) {
  const double tolerance = wanted.value("tol", kCells);
  for (const auto& [key, value] : wanted.items()) {
    if (is_rule(key)) continue;
    if (key == "value_starts") {
      if (item.value("value", "").rfind(value.get<std::string>(), 0) != 0) return false;
      continue;
    }
    if (!item.contains(key) || !agrees(key, value, item[key], tolerance)) return false;
  }
  if (wanted.contains("area_one_of")) {
    bool one = false;
    for (const Json& area : wanted["area_one_of"]) one |= item.value("area", "") == area.get<std::string>();
    if (!one) return false;
  }
  return true;
}

/// Whether the item lies inside the area: "E5-E9" has those of E5.
bool in_area(const Json& item, const std::string& area) {
  if (item.value("area", "") == area) return true;
  if (!item.contains("abs")) return false;
  for (const dmi::AreaRow& row : dmi::kAreaRows) {
    if (row.name != area || area.find_first_of("+-") == std::string::npos) continue;
    const Json& a = item["abs"];
    return a[0] >= row.at.x && a[1] >= row.at.y && a[0].get<int>() + a[2].get<int>() <= row.at.x + row.at.w &&
           a[1].get<int>() + a[3].get<int>() <= row.at.y + row.at.h;
  }
  return false;
}

/// For `must_not`: only the properties that the case names are compared, and areas that consist of several count.
bool is_forbidden(const Json& wanted, Json item) {
  if (wanted.contains("area") && in_area(item, wanted["area"])) item["area"] = wanted["area"];
  return matches(wanted, item);
}

int count_of(const std::string& what, const Json& items) {
  int count = 0;
  for (const Json& item : items) {
    const std::string kind = item["kind"], area = item.value("area", "");
    if (what == "A3 scale lines")
      count += kind == "rect" && area == "A3" ? 1 : 0;
    else if (what == "D1 numbers")
      count += kind == "text" && area == "D1" ? 1 : 0;
    else if (what == "long")
      count += kind == "dial_line" && item["length"] == 25.0 ? 1 : 0;
    else
      count += kind == what ? 1 : 0;
  }
  return count;
}

/// The layers of PLO-05.
bool is_layer(const std::string& layer, const Json& item) {
  const std::string kind = item["kind"], area = item.value("area", ""), name = item.value("name", "");
  if (layer == "PASP") return kind == "pasp_step";
  if (layer == "distance scale") return kind == "rect" && area == "D" && item["w"] == 200;
  if (layer == "ATO next advice marker") return name == "advice change";
  if (layer == "indication marker") return name == "indication marker";
  return area == "D5" || ((area == "D2" || area == "D3" || area == "D4" || area == "D6+D7") && kind == "symbol");
}

/// Faults found in a case.
class Faults {
 public:
  template <class... Parts>
  void add(const Parts&... parts) {
    std::ostringstream text;
    (text << ... << parts);
    text_ += (text_.empty() ? "" : "; ") + text.str();
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

void check_items(const Json& expect, const Json& items, Faults& faults) {
  if (expect.contains("must"))
    for (const Json& wanted : expect["must"]) {
      if (wanted["kind"] == "count") {
        const int count = count_of(wanted["of"], items);
        if (count != wanted["value"]) faults.add(wanted["of"], ": ", count, ", expected ", wanted["value"]);
        continue;
      }
      bool found = false;
      for (const Json& item : items) found |= matches(wanted, item);
      if (!found) faults.add("nothing is ", wanted.dump());
    }
  if (expect.contains("must_not"))
    for (const Json& forbidden : expect["must_not"])
      for (const Json& item : items)
        if (is_forbidden(forbidden, item)) faults.add("there is ", item.dump());
  if (expect.contains("count"))
    for (const auto& [what, number] : expect["count"].items())
      if (count_of(what, items) != number) faults.add(what, ": ", count_of(what, items), ", expected ", number);
}

void check_order(const Json& order, const Json& items, Faults& faults) {
  std::size_t at = 0;
  for (const Json& wanted : order) {
    const auto fits = [&](const Json& item) {
      return wanted.is_string() ? is_layer(wanted, item) : matches(wanted, item);
    };
    // The first of the kind behind those before; of a layer every item is behind them.
    const std::size_t begin = at;
    while (at < items.size() && !fits(items[at])) ++at;
    if (at == items.size()) return faults.add("not in this order: ", wanted.dump());
    for (std::size_t before = 0; wanted.is_string() && before < begin; ++before)
      if (fits(items[before])) return faults.add("too early: ", wanted.dump());
  }
}

void check_lines(const Json& wanted, const Json& found, Faults& faults) {
  bool same = found.size() == wanted.size();
  for (std::size_t i = 0; same && i < wanted.size(); ++i)
    for (std::size_t k = 0; k < wanted[i].size(); ++k) same &= wanted[i][k] == "*" || wanted[i][k] == found[i][k];
  if (!same) faults.add("lines ", found.dump(), ", expected ", wanted.dump());
}

/// Each member that the case names is what was found; of -_min and -_max it is a bound.
void check_members(const Json& wanted, const Json& found, const char* where, Faults& faults) {
  for (const auto& [key, value] : wanted.items()) {
    const Json seen = found.contains(key) ? found[key] : Json("nothing");
    bool same = seen == value;
    if (key == "activations_min") same = seen.is_number() && seen >= value;
    if (key == "activations_max" || key == "max_group") same = seen.is_number() && seen <= value;
    if (!same) faults.add(where, " ", key, ": ", seen.dump(), ", expected ", value.dump());
  }
}

/// The cases with a rule in words.
void check_rule(const std::string& id, const Json& items, Faults& faults) {
  const auto find = [&](const char* kind, const std::string& key, const Json& value) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < items.size(); ++i)
      if (items[i]["kind"] == kind && items[i].value(key, Json()) == value) places.push_back(i);
    return places;
  };
  if (id == "TXT-02") {
    const auto first = find("text", "area", "E5"), second = find("text", "area", "E6");
    if (first.size() != 2 || second.size() != 1) return faults.add("lines ", first.size(), " ", second.size());
    const Json &time = items[first[0]], &words = items[first[1]], &rest = items[second[0]];
    if (time["height"] != 10 || words["x"] != rest["x"]) faults.add("time or second line");
    if (words["value"].get<std::string>() + " " + rest["value"].get<std::string>() !=
        "No MA received at level transition")
      faults.add("words ", words["value"], rest["value"]);
    if (rest["abs"][0].get<int>() + rest["abs"][2].get<int>() > 288) faults.add("beyond 288");
  } else if (id == "PLO-02") {
    std::set<std::string> columns;
    for (const char* symbol : {"PL02", "PL06", "PL24"})
      for (const std::size_t i : find("symbol", "id", symbol)) columns.insert(items[i]["area"].get<std::string>());
    if (columns.size() != 3) faults.add("columns: ", columns.size());
  } else if (id == "PLO-03") {
    // The nearest and the farthest share a column.
    const auto near_one = find("symbol", "id", "PL02"), far_one = find("symbol", "id", "PL10");
    if (near_one.size() != 1 || far_one.size() != 1) return faults.add("symbols");
    if (items[near_one[0]]["area"] != items[far_one[0]]["area"]) faults.add("columns");
    if (near_one[0] < far_one[0]) faults.add("the nearer one is below");
  } else if (id == "WIN-25") {
    for (const std::size_t i : find("field", "label", "SR distance (m)"))
      if (items[i].value("value", "").find_first_of("123456789") == std::string::npos) faults.add("no value");
    if (find("field", "label", "SR distance (m)").empty()) faults.add("no field");
  } else {
    faults.add("an unknown rule");
  }
}

std::string faults_of(const Json& one) {
  Faults faults;
  const Json& expect = one["expect"];
  Json found;
  try {
    found = Json::parse(answer(io::JsonPlace(one, one["id"].get<std::string>())).dump());
  } catch (const io::ReadError& error) {
    return error.diagnostic.text();
  }
  const Json items = found.value("items", Json::array());
  check_items(expect, items, faults);
  if (expect.contains("order")) check_order(expect["order"], items, faults);
  if (expect.contains("rule")) check_rule(one["id"], items, faults);
  if (expect.contains("lines")) check_lines(expect["lines"], found["lines"], faults);
  if (expect.contains("buttons"))
    for (const Json& item : items)
      if (item["kind"] == "button" && item.value("enabled", false)) faults.add("enabled: ", item["id"]);
  for (const char* key : {"result", "display"})
    if (expect.contains(key)) check_members(expect[key], found[key], key, faults);
  for (const char* key : {"sounds", "touch", "ack_required"})
    if (expect.contains(key) && found[key] != expect[key])
      faults.add(key, ": ", found[key].dump(), ", expected ", expect[key].dump());
  if (expect.contains("timeline"))
    for (std::size_t i = 0; i < expect["timeline"].size(); ++i)
      check_members(expect["timeline"][i], found["timeline"][i], "timeline", faults);
  return faults.text();
}

TEST(Cases, AreAllAsExpected) {
  const Json& cases = file()["cases"];
  ASSERT_EQ(cases.size(), 495U);
  std::size_t compared = 0;
  for (const Json& one : cases) {
    const std::string id = one["id"];
    if (exempted().contains(id)) continue;
    EXPECT_EQ(faults_of(one), "") << id << ": " << one["given"].dump();
    ++compared;
  }
  EXPECT_EQ(compared + exempted().size(), 495U);
}

// Windows, fields, checks and dialogues of 015560 chapters 10 and 11.
TEST(Cases, OfWindowsAreAllAsExpected) {
  const Json cases = read_cases("dmi_window_cases.json")["cases"];
  EXPECT_GT(cases.size(), 300U);
  std::set<std::string> ids;
  for (const Json& one : cases) {
    const std::string id = one["id"];
    EXPECT_TRUE(ids.insert(id).second) << id;
    EXPECT_EQ(faults_of(one), "") << id << ": " << one["given"].dump();
  }
}

// A case that is exempted does contradict the display; else it need not be.
TEST(Cases, ThatAreExemptedWouldFail) {
  for (const Json& one : file()["cases"]) {
    if (!exempted().contains(one["id"].get<std::string>())) continue;
    EXPECT_NE(faults_of(one), "") << one["id"];
  }
}

// The comparison sees what is wrong: a changed expectation is a fault.
TEST(Cases, WithAnotherExpectationFail) {
  const std::map<std::string, std::function<void(Json&)>> changes{
      {"PTR-01", [](Json& e) { e["must"][0]["deg"] = -19.5; }},
      {"PTR-02", [](Json& e) { e["must"][0]["colour"] = "red"; }},
      {"CSG-01",
       [](Json& e) {
         e["must_not"].push_back({{"kind", "arc"}, {"colour", "dark_grey"}});
       }},
      {"TD-01", [](Json& e) { e["must"][0]["right_edge"] = 40; }},
      {"SYM-01",
       [](Json& e) {
         e["must"][0]["centre"] = {309.0, 289.0};
       }},
      {"DIAL-21", [](Json& e) { e["count"]["dial_line"] = 40; }},
      {"TXT-01", [](Json& e) { e["lines"][0][1] = "D"; }},
      {"SND-01", [](Json& e) { e["sounds"] = Json::array(); }},
      {"ACK-03", [](Json& e) { e["timeline"][1]["shown"] = "MO08"; }},
      {"PLZ-01", [](Json& e) { e["result"]["range_m"] = 8000; }},
      {"SETV-02", [](Json& e) { std::swap(e["order"][0], e["order"][1]); }},
      {"GEO-03",
       [](Json& e) {
         e["touch"] = {397, 415, 120, 50};
       }},
      {"BTN-01", [](Json& e) { e["must"][0]["enabled"] = false; }},
  };
  for (Json one : file()["cases"]) {
    const auto change = changes.find(one["id"]);
    if (change == changes.end()) continue;
    change->second(one["expect"]);
    EXPECT_NE(faults_of(one), "") << one["id"];
  }
}

/// The answer to a case with this `given`.
Json answer_to(const Json& given, const Json& expect) {
  const Json one{{"id", "made"}, {"given", given}, {"expect", expect}};
  return Json::parse(answer(io::JsonPlace(one, "made")).dump());
}

// A case may name what the cases of the file do not: every track condition, by its words and by its symbol.
TEST(Cases, NameEveryTrackCondition) {
  std::set<Picture> named;
  for (const ConditionName& row : kConditionNames) {
    named.insert(row.picture);
    for (const std::string& called : {std::string(row.words), std::string(name(row.picture))}) {
      const Json items =
          answer_to({{"mode", "FS"}, {"track_conditions", {called}}}, {{"must", Json::array()}})["items"];
      EXPECT_TRUE(std::any_of(items.begin(), items.end(), [&](const Json& item) {
        return item["kind"] == "symbol" && item["id"] == name(row.picture) && item["area"] == "B3";
      })) << called;
    }
  }
  // TC36 and TC37 are those of area C2.
  for (auto i = terms::index(Picture::TC01); i < terms::index(Picture::TC36); ++i)
    EXPECT_TRUE(named.count(static_cast<Picture>(i))) << name(static_cast<Picture>(i));
}

TEST(Cases, NameEveryStatusText) {
  for (const auto& row : kStatusTextRows) {
    const Json lines = answer_to({{"system_status", {row.name}}}, {{"lines", Json::array()}})["lines"];
    EXPECT_FALSE(lines.empty()) << row.name;
    const Json ended =
        answer_to({{"system_status", {row.name, "first end condition met"}}}, {{"lines", Json::array()}})["lines"];
    // The reason of a trip is shown until PT is left (4.4.14.1.2.1); the other two wait for the driver and the train.
    const bool stays = std::none_of(driver::srs_status_texts.begin(), driver::srs_status_texts.end(),
                                    [&](const auto& text) { return text.text == row.value; }) ||
                       row.value == StatusText::NL_no_longer_permitted || row.value == StatusText::train_data_changed;
    EXPECT_EQ(!ended.empty(), stays) << row.name;
  }
}

TEST(Cases, OpenEveryWindow) {
  for (std::size_t i = 0; i < dmi::kWindows; ++i) {
    const dmi::WindowRow& row = dmi::row_of(static_cast<dmi::WindowId>(i));
    if (row.id == dmi::WindowId::default_) continue;
    EXPECT_FALSE(answer_to({{"window", row.title}}, {{"must", Json::array()}})["items"].empty()) << row.title;
  }
}

/// Whether an item has these members.
bool shows(const Json& items, const Json& wanted) {
  return std::any_of(items.begin(), items.end(), [&](const Json& item) { return matches(wanted, item); });
}

// 015560 10.3.5.3, 10.5.1: a window is shown at the page that the case names.
TEST(Cases, TurnToTheirPage) {
  const Json any{{"must", Json::array()}};
  for (const int page : {1, 2}) {
    const Json items = answer_to({{"window", "Data view"}, {"page", page}}, any)["items"];
    const std::string title = "Data view (" + std::to_string(page) + "/2)";
    EXPECT_TRUE(shows(items, {{"kind", "text"}, {"value", title}})) << page;
    EXPECT_EQ(shows(items, {{"kind", "view_item"}, {"label", "Driver ID"}}), page == 1);
  }
  EXPECT_THROW((void)answer_to({{"window", "Data view"}, {"page", 3}}, any), io::ReadError);
  EXPECT_THROW((void)answer_to({{"mode", "FS"}, {"page", 2}}, any), io::ReadError);
}

// The pages of the data view follow from the VBCs, those of train data from the fields: `pages` of a case is compared.
TEST(Cases, HaveThePagesThatTheyName) {
  const auto items = [](const char* window, int pages, int page) {
    const Json given{{"window", window}, {"page", page}, {"pages", pages}};
    return answer_to(given, {{"must", Json::array()}})["items"];
  };
  const Json third = items("Data view", 3, 3);
  EXPECT_TRUE(shows(third, {{"kind", "text"}, {"value", "Data view (3/3)"}}));
  EXPECT_TRUE(shows(third, {{"kind", "view_item"}, {"n", 1}, {"label", "VBC #10 set code"}}));
  EXPECT_FALSE(shows(items("Data view", 2, 2), {{"kind", "view_item"}, {"label", "VBC #1 set code"}}));
  EXPECT_TRUE(shows(items("Train data", 2, 1), {{"kind", "text"}, {"value", "Train data (1/2)"}}));
  EXPECT_THROW((void)items("Train data", 3, 1), io::ReadError);
  EXPECT_THROW((void)items("Data view", 1, 1), io::ReadError);
  const Json two =
      answer_to({{"window", "Data view"}, {"page", 2}, {"vbc_count", 2}}, {{"must", Json::array()}})["items"];
  EXPECT_TRUE(shows(two, {{"kind", "view_item"}, {"label", "VBC #2 set code"}}));
}

// Symbols of buttons and keys are found by their names, as those of areas are.
TEST(Cases, NameTheSymbolsOfButtonsAndKeys) {
  const auto items = [](const Json& given) { return answer_to(given, {{"must", Json::array()}})["items"]; };
  const auto symbol = [](const char* id, const char* area, double x, double y) {
    return Json{{"kind", "symbol"}, {"id", id}, {"area", area}, {"w", 32}, {"h", 32}, {"centre", {x, y}}};
  };
  EXPECT_TRUE(shows(items({{"mode", "FS"}}), symbol("SE04", "F5", 610, 240)));
  const Json settings = items({{"window", "Settings"}});
  EXPECT_TRUE(shows(settings, symbol("SE03", "half", 410.5, 90)));
  EXPECT_TRUE(shows(settings, symbol("SE02", "half", 563.5, 90)));
  EXPECT_TRUE(shows(settings, symbol("SE01", "half", 410.5, 140)));
  EXPECT_TRUE(shows(settings, symbol("NA11", "half", 375, 440)));
  const Json train = items({{"window", "Train data"}});
  EXPECT_TRUE(shows(train, symbol("NA19", "full", 457, 440)));
  EXPECT_TRUE(shows(train, symbol("NA17", "full", 539, 440)));
  EXPECT_TRUE(shows(train, symbol("NA23", "full", 589, 390)));
  EXPECT_TRUE(shows(items({{"window", "Driver ID"}}), symbol("NA21", "half", 385, 390)));
}

// The words of 3.6.0: its radio network, and level 3.
TEST(Cases, FollowTheirEdition) {
  const auto items = [](Json given, const char* srs) {
    given["srs"] = srs;
    return answer_to(given, {{"must", Json::array()}})["items"];
  };
  const Json window{{"window", "Radio network ID"}};
  EXPECT_TRUE(shows(items(window, "3.6.0"), {{"kind", "text"}, {"value", "Radio network ID"}}));
  EXPECT_TRUE(
      shows(items({{"window", "GSM-R network ID"}}, "4.0.0"), {{"kind", "text"}, {"value", "GSM-R network ID"}}));
  EXPECT_TRUE(shows(items({{"level", "3"}, {"level_valid", true}}, "3.6.0"),
                    {{"kind", "symbol"}, {"id", "LE05"}, {"area", "C8"}}));
  EXPECT_THROW((void)items(window, "4.0.0"), io::ReadError);
}

// 015560 8.2.3.4.7 e: E11 shows the next line.
TEST(Cases, ScrollTheirTexts) {
  Json texts = Json::array();
  for (int i = 0; i < 8; ++i)
    texts.push_back({{"text", "t" + std::to_string(i)}, {"time", "10:0" + std::to_string(i)}, {"group", 2}});
  const auto first = [&](int lines) {
    return answer_to({{"texts", texts}, {"scroll_lines", lines}}, {{"lines", Json::array()}})["lines"][0][1];
  };
  EXPECT_EQ(first(0), "t7");
  EXPECT_EQ(first(2), "t5");
  EXPECT_EQ(first(3), "t4");
  EXPECT_THROW((void)first(4), io::ReadError);
}

const Json kDriving{{"mode", "SB"},
                    {"level", "2"},
                    {"standstill", true},
                    {"ack_pending", false},
                    {"driver_id", "valid"},
                    {"session", true},
                    {"train_data", "valid"},
                    {"gsmr_registered", true},
                    {"v", 0},
                    {"trn", "valid"},
                    {"radio_type", "GSM-R"},
                    {"v_override_limit", 40},
                    {"level_valid", true},
                    {"rbc_contact", "valid"}};

/// Whether a button is enabled in its window; none: it is not shown.
std::optional<bool> enabled_in(const std::string& window, const std::string& button,
                               const Json& changes = Json::object()) {
  Json given = kDriving;
  given.update(changes);
  given["window"] = window;
  const Json answered = answer_to(given, {{"must", Json::array()}});
  for (const Json& item : answered["items"])
    if (item["kind"] == "button" && item["id"] == button) return item["enabled"].get<bool>();
  return std::nullopt;
}

// 015560 11.2.5.4, Table 37: also where Main's button of the window is disabled.
TEST(Cases, ShowTheRadioDataWindowWhereItsButtonIsDisabled) {
  const std::string contact = "Contact last RBC";
  EXPECT_EQ(enabled_in("Radio data", contact), true);
  EXPECT_EQ(enabled_in("Radio data", contact, {{"mode", "SH"}}), false);
  EXPECT_EQ(enabled_in("Radio data", contact, {{"standstill", false}}), false);
  EXPECT_EQ(enabled_in("Radio data", contact, {{"ack_pending", true}}), false);
  EXPECT_EQ(enabled_in("Radio data", contact, {{"gsmr_registered", false}}), false);
  EXPECT_EQ(enabled_in("Main", "Radio data", {{"mode", "SH"}}), false);
}

// Table 35 #4: what is inhibited can be revoked, and is not inhibited again.
TEST(Cases, RevokeTheInhibitionOfTheMetalMassReaction) {
  const Json in_SR{{"mode", "SR"}, {"bmm_inhibited", true}};
  EXPECT_EQ(enabled_in("Special", "Revoke BMM reaction inhibition", in_SR), true);
  EXPECT_EQ(enabled_in("Special", "Revoke BMM reaction inhibition", {{"mode", "SR"}}).value_or(false), false);
  EXPECT_EQ(enabled_in("Special", "BMM reaction inhibition", {{"mode", "SR"}}), true);
}

// Table 33 #11: the system version of the RBC is above 2.2 unless the case says otherwise; without a session it is not.
TEST(Cases, EnableTheSupervisedManoeuvre) {
  Json facts{{"mode", "SM"}, {"safe_consist_length", true}};
  EXPECT_EQ(enabled_in("Main", "Continue in SM", facts), true);
  facts["session_above_2_2"] = false;
  EXPECT_EQ(enabled_in("Main", "Continue in SM", facts), false);
  facts.erase("session_above_2_2");
  facts["session"] = false;
  EXPECT_EQ(enabled_in("Main", "Continue in SM", facts), false);
  const Json in_FS{{"mode", "FS"}, {"safe_consist_length", true}};
  EXPECT_EQ(enabled_in("Main", "Initiate SM", in_FS), true);
  EXPECT_EQ(enabled_in("Main", "Initiate SM", {{"mode", "FS"}}), false);
}

// What a case does not name is stored and valid.
TEST(Cases, TakeDataThatTheyDoNotNameAsValid) {
  const Json given{{"mode", "SB"},           {"level", "2"},
                   {"standstill", true},     {"session", true},
                   {"ack_pending", false},   {"gsmr_registered", true},
                   {"window", "Radio data"}, {"v", 0},
                   {"radio_type", "GSM-R"}};
  const auto contact_enabled = [](const Json& of) {
    return shows(answer_to(of, {{"must", Json::array()}})["items"],
                 {{"kind", "button"}, {"id", "Contact last RBC"}, {"enabled", true}});
  };
  EXPECT_TRUE(contact_enabled(given));
  for (const char* member : {"rbc_contact", "driver_id"}) {
    Json unknown = given;
    unknown[member] = "unknown";
    EXPECT_FALSE(contact_enabled(unknown)) << member;
  }
  Json no_level = given;
  no_level["level_valid"] = false;
  EXPECT_FALSE(contact_enabled(no_level));
}

// Table 34 asks for train data in SB and PT only, where SRS 5.8 asks for it always.
TEST(Cases, EnableAnOverrideByTheTableAlone) {
  for (const char* mode : {"FS", "AD", "LS", "SR", "OS", "UN", "SN", "SH"})
    EXPECT_EQ(enabled_in("Override", "EOA", {{"mode", mode}, {"train_data", "invalid"}}), true) << mode;
  for (const char* mode : {"SB", "PT"}) {
    EXPECT_EQ(enabled_in("Override", "EOA", {{"mode", mode}, {"train_data", "invalid"}}), false) << mode;
    EXPECT_EQ(enabled_in("Override", "EOA", {{"mode", mode}}), true) << mode;
  }
}

// 015560 11.7.1.7, Table 48: with the standstill every button is lost that needs it, and windows close with theirs.
TEST(Cases, LoseTheButtonsThatNeedStandstill) {
  const auto window_after = [](const char* mode, const char* window) {
    return answer_to({{"mode", mode}, {"window", window}, {"event", "train moves (not standstill)"}},
                     {{"result", {{"window", ""}}}})["result"]["window"];
  };
  EXPECT_EQ(window_after("SR", "SR speed / distance"), "Special");
  EXPECT_EQ(window_after("FS", "Level"), "Main");
  EXPECT_EQ(window_after("SB", "Driver ID"), "Main");
  EXPECT_EQ(window_after("SB", "Train running number"), "Main");
  EXPECT_EQ(window_after("SB", "RBC data"), "Radio data");
  EXPECT_EQ(window_after("SB", "Language"), "Settings");
  // These do not need it.
  EXPECT_EQ(window_after("FS", "Train running number"), "Train running number");
  EXPECT_EQ(window_after("FS", "Language"), "Language");
  EXPECT_EQ(window_after("SB", "Set VBC"), "Set VBC");
  const Json moving{{"mode", "FS"}, {"event", "train moves (not standstill)"}};
  EXPECT_EQ(enabled_in("Main", "Driver ID", moving), false);
  EXPECT_EQ(enabled_in("Main", "Train running number", moving), true);
  Json permitted = moving;
  permitted["nv_driver_id_running"] = true;
  EXPECT_EQ(enabled_in("Main", "Driver ID", permitted), true);
}

// 015560 5.4.1.9: what is revoked is no longer on offer, and its symbol goes.
TEST(Cases, RevokeEachKindOfRequest) {
  for (const char* request : {"level 0", "level NTC", "brake release", "mode OS", "text Y"}) {
    Json given{{"mode", "FS"}, {"events", {{{"t", 0}, {"request", request}}}}};
    const Json expect{{"timeline", {{{"t", 1.5}, {"shown", ""}}, {{"t", 2.5}, {"shown", ""}}}},
                      {"must", Json::array()}};
    const Json asked = answer_to(given, expect);
    EXPECT_TRUE(asked["timeline"][1]["shown"].is_string()) << request;
    given["events"].push_back({{"t", 2}, {"revoke", request}});
    const Json revoked = answer_to(given, expect);
    EXPECT_TRUE(revoked["timeline"][0]["shown"].is_string()) << request;
    EXPECT_TRUE(revoked["timeline"][1]["shown"].is_null()) << request;
    for (const char* area : {"C1", "C9"})
      EXPECT_FALSE(shows(revoked["items"], {{"kind", "symbol"}, {"area", area}})) << request;
  }
}

// 015560 Tables 69 and 70: texts of national systems have their names; a failure is to be acknowledged (15.1.1.4.1).
TEST(Cases, NameTheNationalSystemInItsTexts) {
  const auto answered = [](const char* text, const Json& changes = Json::object()) {
    Json given{{"mode", "SN"}, {"level", "NTC"}, {"ntc_name", "PZB"}, {"system_status", {text}}};
    given.update(changes);
    return answer_to(given, {{"lines", Json::array()}, {"ack_required", false}});
  };
  for (const char* ending : {"is not available", "needs data", "failed", "brake demand"}) {
    const Json shown = answered((std::string("[name of NTC] ") + ending).c_str());
    ASSERT_EQ(shown["lines"].size(), 1U) << ending;
    EXPECT_EQ(shown["lines"][0][1], std::string("PZB ") + ending);
    EXPECT_EQ(shown["lines"][0][2], "bold");
    EXPECT_EQ(shown["ack_required"], ending == std::string("failed")) << ending;
  }
  EXPECT_EQ(answered("ATO needs data")["lines"][0][1], "ATO needs data");
  EXPECT_EQ(answered("ATO needs data")["ack_required"], false);
  EXPECT_TRUE(answered("ATO needs data", {{"srs", "3.6.0"}})["lines"].empty());
  const auto ended = [&](const char* text) {
    return answered(text, {{"system_status", {text, "first end condition met"}}})["lines"].empty();
  };
  EXPECT_TRUE(ended("[name of NTC] needs data"));
  EXPECT_TRUE(ended("ATO needs data"));
  EXPECT_FALSE(ended("[name of NTC] failed"));  // until it is acknowledged
}

// 015560 Table 68: each radio system has its text in 4.0.0, until a button of the main window is selected.
TEST(Cases, NameTheRadioSystemThatFailed) {
  const auto lines = [](Json given) { return answer_to(given, {{"lines", Json::array()}})["lines"]; };
  for (const char* text : {"FRMCS network registration failed", "GSM-R network registration failed"}) {
    const Json shown = lines({{"system_status", {text}}});
    std::string words;
    for (const Json& line : shown) words += (words.empty() ? "" : " ") + line[1].get<std::string>();
    EXPECT_EQ(words, text);
    EXPECT_TRUE(lines({{"system_status", {text}}, {"press", "any button of the Main window"}}).empty()) << text;
    EXPECT_TRUE(lines({{"system_status", {text, "first end condition met"}}}).empty()) << text;
  }
  EXPECT_TRUE(lines({{"srs", "3.6.0"}, {"system_status", {"FRMCS network registration failed"}}}).empty());
}

// 015560 8.2.3.4.7, 8.2.3.4.8 c: texts one after another, each with its group and time.
TEST(Cases, ShowTheTextsOfASequence) {
  const auto lines = [](const Json& sequence) {
    return answer_to({{"mode", "FS"}, {"sequence", sequence}}, {{"lines", Json::array()}})["lines"];
  };
  const char* asked = "text Y (group 2, 17:34, ack) shown";
  EXPECT_EQ(lines({"text X (group 1, 17:33) shown"}), Json::array({{"17:33", "X", "bold"}}));
  EXPECT_EQ(lines({"text X (group 1, 17:33) shown", asked}), Json::array({{"17:34", "Y", "regular"}}));
  EXPECT_EQ(lines({"text X (group 1, 17:33) shown", asked, "acknowledged, display not ended"}),
            Json::array({{"17:33", "X", "bold"}, {"17:34", "Y", "regular"}}));
  EXPECT_EQ(lines({"text X (group 1, 17:33) shown", asked, "acknowledged, display ended"}),
            Json::array({{"17:33", "X", "bold"}}));
}

// 015560 8.2.3.5.3: what begins after others have ended is one of its own.
TEST(Cases, TellTheConditionsOfASequenceApart) {
  const Json items = answer_to(
      {{"mode", "FS"}, {"sequence", {"TC02 starts", "TC06 starts", "TC02 ends", "LX01 starts", "TC35 starts"}}},
      {{"must", Json::array()}})["items"];
  EXPECT_TRUE(shows(items, {{"kind", "symbol"}, {"id", "LX01"}, {"area", "B3"}}));
  EXPECT_TRUE(shows(items, {{"kind", "symbol"}, {"id", "TC06"}, {"area", "B4"}}));
  EXPECT_TRUE(shows(items, {{"kind", "symbol"}, {"id", "TC35"}, {"area", "B5"}}));
}

// 015560 8.5.1.2: accuracy, dwell time and doors are shown at stopping points alone.
TEST(Cases, ShowNoDwellTimeOutsideStoppingPoints) {
  for (const bool at : {true, false}) {
    const Json items = answer_to({{"mode", "AD"},
                                  {"ato_selector", "On"},
                                  {"at_stopping_point", at},
                                  {"ato_stop", "accurate"},
                                  {"ato_doors", "are open"},
                                  {"dwell_s", 59}},
                                 {{"must", Json::array()}})["items"];
    EXPECT_EQ(shows(items, {{"kind", "symbol"}, {"area", "G2"}}), at);
    EXPECT_EQ(shows(items, {{"kind", "text"}, {"area", "G3"}}), at);
    EXPECT_EQ(shows(items, {{"kind", "symbol"}, {"area", "G4"}}), at);
  }
}

// 015560 10.3.4.2, 10.3.4.5: the limits of a case are those of its field.
TEST(Cases, LimitTheFieldThatTheyName) {
  for (const char* field : {"Length (m)", "Brake percentage", "Maximum speed (km/h)"}) {
    Json given{{"window", "Train data"}, {"field", field}, {"technical_range", {50, 150}}, {"enter", "160"}};
    const auto red = [&] {
      const Json items = answer_to(given, {{"must", Json::array()}})["items"];
      return shows(items, {{"kind", "echo"}, {"label", field}, {"value", "++++"}, {"colour", "red"}});
    };
    EXPECT_TRUE(red()) << field;
    given["enter"] = "150";
    EXPECT_FALSE(red()) << field;
  }
}

// 015560 11.2.5.6: the hour glass of the window Radio data.
TEST(Cases, WaitInTheWindowThatTheyName) {
  for (const char* window : {"Main", "Radio data"}) {
    const Json items =
        answer_to({{"window", window}, {"waiting", true}, {"t_s", 1.5}}, {{"must", Json::array()}})["items"];
    EXPECT_TRUE(shows(items, {{"kind", "symbol"}, {"id", "ST05"}, {"abs", {402, 17}}})) << window;
    EXPECT_TRUE(shows(items, {{"kind", "text"}, {"value", window}})) << window;
  }
}

// 015560 5.3.2.6.4: a down button acts once, when it is touched.
TEST(Cases, WatchADownButton) {
  const Json result = answer_to({{"button", "down"}, {"events", {"press t0", "release t4.0"}}},
                                {{"result", {{"click", 1}, {"activations", 1}, {"at", ""}}}})["result"];
  EXPECT_EQ(result["click"], 1);
  EXPECT_EQ(result["activations"], 1);
  EXPECT_EQ(result["at"], "press");
}

TEST(Cases, RefuseEventsThatCannotHappen) {
  const Json expect{{"timeline", {{{"t", 3}, {"window", ""}}}}};
  const auto refused = [&](const Json& events) {
    try {
      (void)answer_to({{"mode", "FS"}, {"events", events}}, expect);
    } catch (const io::ReadError& error) {
      return error.diagnostic.text();
    }
    return std::string();
  };
  const Json opened{{"t", 0}, {"window", "Train data"}};
  EXPECT_EQ(refused(Json::array({opened})), "");
  EXPECT_NE(refused({opened, {{"t", 1}, {"window", "Settings"}}}).find("from \"Train data\""), std::string::npos);
  EXPECT_NE(refused({{{"t", 1}, {"revoke", "level 0"}}}).find("level that is announced"), std::string::npos);
  EXPECT_NE(refused({{{"t", 1}, {"revoke", "text Y"}}}).find("requested before"), std::string::npos);
  EXPECT_NE(refused({{{"t", 1}, {"revoke", "mode XX"}}}), "");
}

// A change may be of the mode; with it come its symbol and its sounds.
TEST(Cases, ChangeTheModeInAnEvent) {
  const auto mode_symbol = [](const char* event) {
    const Json items = answer_to({{"event", event}}, {{"must", Json::array()}})["items"];
    for (const Json& item : items)
      if (item["kind"] == "symbol" && item["area"] == "B7") return item["id"].get<std::string>();
    return std::string();
  };
  EXPECT_EQ(mode_symbol("mode FS -> OS"), "MO07");
  EXPECT_EQ(mode_symbol("OS -> FS"), "MO11");
  EXPECT_EQ(mode_symbol("SR CSM WaS -> FS"), "MO11");
  EXPECT_NE(mode_symbol("mode FS -> AD"), mode_symbol("mode AD -> FS"));
  for (const char* event : {"mode FS -> XX", "speed high -> low", "CSM -> TSM now", "direction SM01 -> SM03"})
    EXPECT_THROW((void)mode_symbol(event), io::ReadError) << event;
}

TEST(Cases, RefuseWordsThatSayNothing) {
  const Json none{{"must", Json::array()}};
  for (const Json& given : std::initializer_list<Json>{{{"track_conditions", {"snow"}}},
                                                       {{"system_status", {"All is well"}}},
                                                       {{"system_status", {"SR distance exceeded [4.6.3 20]"}}},
                                                       {{"fields", {{"2", "long"}}}},
                                                       {{"fields", {{"1", "200"}}}},
                                                       {{"value", "12a"}},
                                                       {{"window", "Train data"}, {"events", {"key x"}}},
                                                       {{"window", "Train data"}, {"events", {"touch nothing"}}},
                                                       {{"sequence", {"TC03"}}},
                                                       {{"sequence", {"TC99 starts"}}},
                                                       {{"sequence", {"TC03 begins"}}},
                                                       {{"events", {{{"t", 0}, {"request", "level 1"}}}}},
                                                       {{"step", "start-up S99"}},
                                                       {{"field", "RBC ID"}, {"technical_range", {0, 9}}},
                                                       {{"press", "Kitchen"}},
                                                       {{"window", "Kitchen"}}})
    EXPECT_THROW((void)answer_to(given, given.contains("events") && given["events"][0].is_object()
                                            ? Json{{"timeline", {{{"t", 1}}}}}
                                            : none),
                 io::ReadError)
        << given.dump();
}

}  // namespace
}  // namespace evc::screen
