#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "base/test_paths.h"
#include "dmi/dmi.h"
#include "dmi/test_display.h"

// The cases of the default window against the reference list: what stands on the screen for a state of the on-board.
namespace evc::dmi {
namespace {

using nlohmann::json;
using port::Display;

template <class E, class Rows>
E named(const Rows& rows, const std::string& name) {
  for (const auto& row : rows)
    if (name == row.name) return row.value;
  ADD_FAILURE() << "no " << name;
  return {};
}

template <class T, std::size_t N>
void put(InplaceVector<T, N>& list, const T& element) {
  if (!list.push_back(element)) ADD_FAILURE() << "full";
}

Speed speed(const json& kmh) { return Speed{kmh.get<double>() / 3.6}; }
std::optional<Speed> optional_speed(const json& given, const char* key) {
  if (!given.contains(key) || given[key].is_null()) return std::nullopt;
  return speed(given[key]);
}

void set_monitoring(Display& d, const json& g) {
  if (g.contains("dial")) {
    const int most = g["dial"];
    d.config.dial = most == 140   ? port::Dial::to_140
                    : most == 180 ? port::Dial::to_180
                    : most == 250 ? port::Dial::to_250
                                  : port::Dial::to_400;
  }
  if (g.contains("mode")) d.mode = named<Mode>(kModeRows, g["mode"]);
  if (g.contains("monitoring")) d.monitoring = named<Monitoring>(kMonitoringRows, g["monitoring"]);
  static const std::map<std::string, Status> kStatuses{{"none", Status::none},       {"NoS", Status::Normal},
                                                       {"IndS", Status::Indication}, {"OvS", Status::Overspeed},
                                                       {"WaS", Status::Warning},     {"IntS", Status::Intervention}};
  if (g.contains("status")) d.status = kStatuses.at(g["status"]);
  if (g.contains("v")) d.v = speed(g["v"]);
  d.V_P = optional_speed(g, "v_perm");
  d.V_SBI = optional_speed(g, "v_sbi");
  d.V_target = optional_speed(g, "v_target");
  d.V_release = optional_speed(g, "v_release");
  d.LSSMA = optional_speed(g, "lssma");
  d.set_speed = optional_speed(g, "set_speed");
  d.target_information = g.value("target_info", false);
  if (d.target_information && !d.V_target) d.V_target = Speed{};
  if (g.contains("d_target")) d.d_target = Distance{g["d_target"].get<double>()};
  if (g.value("tti_requested", false)) d.TTI = Duration{g["tti_s"].get<double>()};
}

void set_planning(Display& d, const json& g) {
  const auto place = [](const json& m) { return Distance{m.get<double>()}; };
  if (g.contains("mrsp"))
    for (const json& step : g["mrsp"]) put(d.planning.speeds, {place(step["from_m"]), speed(step["v"]), {}});
  if (g.contains("zero_target_m")) d.planning.EOA = place(g["zero_target_m"]);
  if (g.contains("ma_end_m")) d.planning.EOA = place(g["ma_end_m"]);
  if (g.contains("first_indication_m") && !g["first_indication_m"].is_null())
    d.indication_marker = place(g["first_indication_m"]);
  if (g.contains("gradients"))
    for (const json& e : g["gradients"])
      put(d.planning.gradients, {place(e["from_m"]), place(e["to_m"]), e["permille"].get<std::int16_t>()});
  if (g.contains("orders"))
    for (const json& o : g["orders"])
      put(d.orders, {named<Picture>(kPictureRows, o["symbol"]), place(o["shown_from_m"])});
  if (g.contains("discontinuity")) {
    const json& change = g["discontinuity"];
    const Speed V = speed(change["v"]);
    put(d.planning.speeds, {Distance{}, change["increase"].get<bool>() ? V - Speed{1.0} : V + Speed{1.0}, {}});
    put(d.planning.speeds, {place(change["at_m"]), V, {}});
    if (change["is_indication_target"].get<bool>()) d.indication_target = place(change["at_m"]);
  }
  d.track_ahead_free = g.value("track_ahead_free", false);
}

void set_symbols(Display& d, const json& g) {
  static const std::map<std::string, Level> kLevels{
      {"0", Level::L0}, {"NTC", Level::NTC}, {"1", Level::L1}, {"2", Level::L2}};
  if (g.contains("level")) d.level = kLevels.at(g["level"]);
  d.level_valid = g.value("level_valid", false);
  if (g.contains("ntc_name")) {
    port::NtcName name{.nid_ntc = 9};
    const std::string text = g["ntc_name"];
    std::copy(text.begin(), text.end(), name.characters.begin());
    put(d.config.ntc_names, name);
    d.nid_ntc = 9;
  }
  if (g.contains("announced_level")) {
    d.announced_level = port::AnnouncedLevel{kLevels.at(g["announced_level"]), 9};
    if (g.value("ack_window_reached", false) && !g.value("acknowledged", true))
      put(d.acks, {.what = Ack::level, .since = d.now});
  }
  if (g.contains("mode_ack")) put(d.acks, {.what = Ack::OS, .since = d.now});
  d.override_active = g.value("override_active", false);
  d.brake = g.value("brake_commanded", false);
  d.slippery_rail = g.value("slippery_rail", false);
  d.bmm_inhibited = g.value("bmm_inhibited", false);
  d.reversing_permitted = g.value("in_reversing_area", false) && g.value("standstill", false);
  if (g.contains("radio"))
    d.radio = g["radio"] == "up"     ? RadioIndication::up
              : g["radio"] == "lost" ? RadioIndication::failed
                                     : RadioIndication::none;
  if (g.contains("sm_direction"))
    d.sm = g["sm_direction"] == "forward" ? port::SmDirection::forward : port::SmDirection::backward;
  if (g.contains("geo") && g["geo"]["known"].get<bool>())
    d.geo = Distance{g["geo"]["km"].get<double>() * 1000 + g["geo"]["m"].get<double>()};
  if (g.contains("local_time")) d.second_of_day = 7 * 3600 + 3 * 60 + 9;
  if (g.contains("tsa") && g["tsa"]["known"].get<bool>())
    d.tunnel = port::TunnelStoppingArea{g["tsa"]["state"] == "inside", Distance{g["tsa"].value("distance_m", 0.0)}};
  if (g.contains("track_conditions")) {
    static const std::map<std::string, Picture> kConditions{{"lower pantograph, automatic", Picture::TC02},
                                                            {"lower pantograph, driver", Picture::TC03},
                                                            {"pantograph lowered", Picture::TC01},
                                                            {"raise pantograph, driver", Picture::TC05},
                                                            {"neutral section announcement, driver", Picture::TC07},
                                                            {"in neutral section", Picture::TC06},
                                                            {"end of neutral section, driver", Picture::TC09},
                                                            {"non stopping area announcement", Picture::TC11},
                                                            {"in non stopping area", Picture::TC10},
                                                            {"radio hole", Picture::TC12},
                                                            {"regenerative brake inhibited", Picture::TC17},
                                                            {"change to DC 3 kV, driver", Picture::TC30},
                                                            {"sound horn", Picture::TC35},
                                                            {"level crossing not protected", Picture::LX01}};
    std::uint16_t id = 0;
    for (const json& c : g["track_conditions"]) put(d.conditions, {++id, kConditions.at(c), {}});
  }
  if (g.contains("ato_selector")) d.ato.on = g["ato_selector"] == "On";
  if (g.contains("dwell_s")) d.ato.dwell_s = g["dwell_s"].get<std::uint16_t>();
  if (g.contains("ato_status"))
    d.ato.status = g["ato_status"] == "ready" ? port::AtoStatus::ready : port::AtoStatus::selected;
  if (g.contains("skip_stop")) d.ato.skip = port::AtoSkip::inactive;
  d.ato.advice_speed = optional_speed(g, "advice_speed");
}

State state_of(const json& given) {
  Display display = test::neutral();
  set_monitoring(display, given);
  set_planning(display, given);
  set_symbols(display, given);
  State state;
  show(state, display);
  state.toggles.speed = given.value("toggle_speed", false);
  state.toggles.tunnel = given.contains("tsa") && given["tsa"].value("toggle", false);
  state.toggles.geo = given.contains("geo") && given["geo"].value("toggle", false);
  if (given.contains("range_m"))
    for (std::size_t i = 0; i < 6; ++i)
      if (given["range_m"] == 1000 << i) state.zoom = static_cast<std::uint8_t>(i);
  return state;
}

// The properties of an item as the cases name them. Those that are not listed for a kind are not compared.
json properties(const Item& item) {
  const Rect abs = absolute(item);
  json p{{"kind", name(item.kind)}, {"area", name(item.area)}, {"colour", name(item.colour)}};
  if (item.picture) p["id"] = name(*item.picture);
  p["value"] = std::string(item.text.view());
  p["height"] = item.height;
  p["bold"] = item.bold;
  constexpr const char* kAligns[] = {"left", "centre", "right"};
  p["align"] = kAligns[static_cast<int>(item.align)];
  p["centre"] = {abs.x + abs.w / 2.0, abs.y + abs.h / 2.0};
  p["x"] = item.at.x, p["y"] = item.at.y, p["w"] = item.at.w, p["h"] = item.at.h;
  p["abs"] = {abs.x, abs.y, abs.w, abs.h};
  p["x_rel_D"] = abs.x - 334, p["top_y_rel_D"] = abs.y - 15, p["bottom_y_rel_D"] = abs.y - 15 + abs.h;
  p["centre_y_rel_D"] = abs.y - 15 + abs.h / 2;
  if (item.align == Align::right) p["right_edge"] = abs.x + abs.w - item.indent;
  switch (item.kind) {
    case Kind::arc:
      p["from_deg"] = item.from_deg, p["to_deg"] = item.to_deg, p["r_in"] = item.r_in, p["r_out"] = item.r_out;
      break;
    case Kind::pointer:
    case Kind::disc:
      p["deg"] = item.from_deg, p["radius_on"] = item.r_in, p["diameter"] = item.w;
      break;
    case Kind::digits: {
      json columns = json::array();
      for (const char c : item.text.view()) columns.push_back(c == ' ' ? "" : std::string(1, c));
      p["columns"] = columns;
      break;
    }
    case Kind::dial_line:
      p["deg"] = item.from_deg, p["r_out"] = item.r_out, p["length"] = item.r_out - item.r_in, p["width"] = item.w,
      p["speed"] = item.number;
      break;
    case Kind::dial_number:
      p["near_deg"] = item.from_deg;
      break;
    case Kind::hook:
      p["edge_deg"] = item.from_deg, p["tangential"] = item.w, p["radial"] = item.r_out - item.r_in,
      p["r_in"] = item.r_in, p["r_out"] = item.r_out;
      break;
    case Kind::bar:
      p["top_row"] = item.at.y, p["bottom_row"] = item.at.y + item.at.h - 1;
      break;
    case Kind::pasp_step:
      p["from_m"] = item.from_m, p["to_m"] = item.to_m, p["width"] = item.at.w, p["quarters"] = item.number;
      break;
    case Kind::edge:
      p["sides"] = item.sides == kBottom ? json{"bottom"} : json{"top", "left"};
      p["width"] = item.w;
      break;
    case Kind::frame:
      p["width"] = item.w;
      break;
    case Kind::symbol:
      p["bar_bottom_y_rel_D"] = abs.y - 15 + (item.picture == Picture::PL21 ? 18 : 4);
      break;
    default:
      break;
  }
  return p;
}

bool agrees(const json& wanted, const json& found, double tolerance) {
  if (wanted.is_number() && found.is_number())
    return std::abs(wanted.get<double>() - found.get<double>()) <= tolerance + 1e-6;
  if (wanted.is_array() && found.is_array() && wanted.size() == found.size()) {
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (!agrees(wanted[i], found[i], tolerance)) return false;
    return true;
  }
  return wanted == found;
}

bool matches(const json& wanted, const json& found) {
  for (const auto& [key, value] : wanted.items()) {
    if (!found.contains(key)) continue;
    const bool angle = key.ends_with("deg");
    const double tolerance = angle             ? 0.1
                             : key == "centre" ? 0.5
                                               : wanted.value("tol", key.ends_with("m") && key != "from_m" ? 1.0 : 0.0);
    if (!agrees(value, found[key], tolerance)) return false;
  }
  return true;
}

std::vector<json> items_of(const Screen& screen) {
  std::vector<json> items;
  for (const Item& item : screen.items) items.push_back(properties(item));
  return items;
}

bool has(const std::vector<json>& items, const json& wanted) {
  return std::any_of(items.begin(), items.end(), [&](const json& found) { return matches(wanted, found); });
}

/// Kinds that only the whole program's list has, and items that a case describes in words.
bool comparable(const json& wanted) {
  static const std::set<std::string> kLeft{"count", "button", "pointer_shape", "line"};
  return wanted.is_object() && !kLeft.contains(wanted["kind"]) && !wanted.contains("position") &&
         !wanted.contains("border") && !wanted.contains("number_right_edge") && !wanted.contains("area_one_of");
}

class Cases : public ::testing::Test {
 protected:
  void SetUp() override {
    std::ifstream in(evc::test::shared_folder() + "/reference/dmi_test_cases.json");
    if (!in) GTEST_SKIP() << "no reference list";
    cases = json::parse(in)["cases"];
  }
  /// Compares the cases of a group; the number of items compared.
  int compare(const std::string& group) {
    int compared = 0;
    for (const json& c : cases) {
      const std::string id = c["id"];
      // HOOK-13 wants no item of kind hook in FS, where CSG-01 wants that of the gauge.
      if (id == "HOOK-13" || id.substr(0, id.find('-')) != group || c["given"].contains("sequence") ||
          c["given"].contains("discontinuities"))
        continue;
      const auto items = items_of(test::drawn(state_of(c["given"])));
      const json& expect = c["expect"];
      for (const json& wanted : expect.value("must", json::array()))
        if (comparable(wanted)) {
          ++compared;
          EXPECT_TRUE(has(items, wanted)) << id << " wants " << wanted;
        }
      for (const json& unwanted : expect.value("must_not", json::array())) {
        ++compared;
        EXPECT_FALSE(has(items, unwanted)) << id << " must not have " << unwanted;
      }
      std::size_t from = 0;
      for (const json& wanted : expect.value("order", json::array())) {
        if (!comparable(wanted)) continue;
        ++compared;
        while (from < items.size() && !matches(wanted, items[from])) ++from;
        EXPECT_LT(from, items.size()) << id << " wants in this order " << wanted;
      }
    }
    return compared;
  }
  json cases;
};

TEST_F(Cases, Dial) { EXPECT_GT(compare("DIAL"), 30); }
TEST_F(Cases, Pointer) { EXPECT_GT(compare("PTR"), 60); }
TEST_F(Cases, Gauge) { EXPECT_GT(compare("CSG"), 80); }
TEST_F(Cases, Hooks) { EXPECT_GT(compare("HOOK"), 15); }
TEST_F(Cases, ReleaseDigits) { EXPECT_GT(compare("REL"), 9); }
TEST_F(Cases, DistanceDigits) { EXPECT_GT(compare("TD"), 16); }
TEST_F(Cases, DistanceBar) { EXPECT_GT(compare("BAR"), 20); }
TEST_F(Cases, TimeToIndication) { EXPECT_GT(compare("TTI"), 20); }
TEST_F(Cases, LowestSupervisedSpeed) { EXPECT_GT(compare("LSSMA"), 3); }
TEST_F(Cases, PlanningRows) { EXPECT_GT(compare("PLY"), 20); }
TEST_F(Cases, PlanningScale) { EXPECT_GT(compare("PLS"), 30); }
TEST_F(Cases, PlanningVisible) { EXPECT_GT(compare("PLV"), 15); }
TEST_F(Cases, PlanningZoom) { EXPECT_GT(compare("PLZ"), 3); }
TEST_F(Cases, PlanningOrders) { EXPECT_GT(compare("PLO"), 0); }
TEST_F(Cases, PlanningProfile) { EXPECT_GT(compare("PASP"), 25); }
TEST_F(Cases, Gradient) { EXPECT_GT(compare("GRAD"), 10); }
TEST_F(Cases, Discontinuities) { EXPECT_GT(compare("DISC"), 8); }
TEST_F(Cases, Symbols) { EXPECT_GT(compare("SYM"), 55); }
TEST_F(Cases, Position) { EXPECT_GT(compare("GEO"), 4); }
TEST_F(Cases, SetSpeed) { EXPECT_GT(compare("SETV"), 2); }
TEST_F(Cases, TrackAheadFree) { EXPECT_GT(compare("TAF"), 3); }
TEST_F(Cases, AutomaticOperation) { EXPECT_GT(compare("ATO"), 3); }

}  // namespace
}  // namespace evc::dmi
