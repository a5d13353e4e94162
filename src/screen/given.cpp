#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <string_view>

#include "base/units.h"
#include "dmi/geometry.h"
#include "dmi/windows.h"
#include "screen/condition_names.h"
#include "screen/scene.h"

namespace evc::screen {
namespace {

using dmi::ActionKind;
using io::JsonPlace;
using port::Display;

Speed kmh(double v) { return Speed{v / kKmh}; }
std::optional<Speed> speed_or_none(const JsonPlace& p) {
  return p.is_null() ? std::nullopt : std::optional(kmh(p.number(0.0, 1000.0)));
}
std::optional<Distance> metres_or_none(const JsonPlace& p) {
  return p.is_null() ? std::nullopt : std::optional(Distance{p.number(-1e6, 1e6)});
}
constexpr double kNoEnd = 40000.0;  // m, of an authority of which a case says nothing

template <class E, std::size_t N>
E named(const JsonPlace& p, const std::array<std::pair<const char*, E>, N>& rows) {
  std::array<const char*, N> names{};
  for (std::size_t i = 0; i < N; ++i) names[i] = rows[i].first;
  return rows[p.one_of(std::span<const char* const>(names))].second;
}

constexpr std::array<std::pair<const char*, Status>, 6> kStatuses{{{"none", Status::none},
                                                                   {"NoS", Status::Normal},
                                                                   {"IndS", Status::Indication},
                                                                   {"OvS", Status::Overspeed},
                                                                   {"WaS", Status::Warning},
                                                                   {"IntS", Status::Intervention}}};
constexpr std::array<std::pair<const char*, DataStatus>, 3> kDataStatuses{
    {{"unknown", DataStatus::unknown}, {"invalid", DataStatus::invalid}, {"valid", DataStatus::valid}}};
constexpr std::array<std::pair<const char*, RadioIndication>, 3> kRadio{
    {{"none", RadioIndication::none}, {"up", RadioIndication::up}, {"lost", RadioIndication::failed}}};
constexpr std::array<std::pair<const char*, port::AtoStatus>, 5> kAtoStatuses{
    {{"selected", port::AtoStatus::selected},
     {"ready", port::AtoStatus::ready},
     {"engaged", port::AtoStatus::engaged},
     {"disengaging", port::AtoStatus::disengaging},
     {"failure", port::AtoStatus::failure}}};
constexpr std::array<std::pair<const char*, port::AtoSkip>, 3> kSkips{{{"inactive", port::AtoSkip::inactive},
                                                                       {"by trackside", port::AtoSkip::by_trackside},
                                                                       {"by driver", port::AtoSkip::by_driver}}};
constexpr std::array<std::pair<const char*, port::AtoStop>, 3> kAtoStops{{{"overshoot", port::AtoStop::overshoot},
                                                                          {"undershoot", port::AtoStop::undershoot},
                                                                          {"accurate", port::AtoStop::accurate}}};
constexpr std::array<std::pair<const char*, port::AtoDoors>, 7> kAtoDoors{
    {{"open both sides", port::AtoDoors::open_both},
     {"open left", port::AtoDoors::open_left},
     {"open right", port::AtoDoors::open_right},
     {"are open", port::AtoDoors::are_open},
     {"close", port::AtoDoors::close},
     {"closing", port::AtoDoors::closing},
     {"closed", port::AtoDoors::closed}}};
constexpr std::array<std::pair<const char*, port::RadioNetworkType>, 3> kNetworkTypes{
    {{"FRMCS", port::RadioNetworkType::frmcs},
     {"FRMCS+GSM-R", port::RadioNetworkType::frmcs_and_gsmr},
     {"GSM-R", port::RadioNetworkType::gsmr}}};
/// By its words, or by the name of its symbol.
Picture condition_named(const JsonPlace& p) {
  for (const ConditionName& row : kConditionNames)
    if (p.string() == row.words) return row.picture;
  for (const PictureRow& row : kPictureRows)
    if (p.string() == row.name) return row.value;
  p.fail("a track condition that docs/dmi.md lists, or the name of a symbol, as TC03");
}

Level level_named(const JsonPlace& p) {
  constexpr std::array<std::pair<const char*, Level>, 5> levels{
      {{"0", Level::L0}, {"NTC", Level::NTC}, {"1", Level::L1}, {"2", Level::L2}, {"3", Level::L3}}};
  return named(p, levels);
}

constexpr std::uint8_t kNtc = 6;  // NID_NTC of the national system that a case names

void name_ntc(Display& display, std::string_view name) {
  port::NtcName row{kNtc, {}};
  std::copy_n(name.begin(), std::min(name.size(), row.characters.size()), row.characters.begin());
  display.config.ntc_names.clear();
  (void)display.config.ntc_names.push_back(row);
  display.nid_ntc = kNtc;
}

/// A VBC more among the data that are shown; false: there is no room.
bool add_cover(Display& display) {
  const auto number = static_cast<std::uint8_t>(display.data.covers.size() + 1);
  return display.data.covers.push_back({926, number, Duration{}, 4});
}

/// A string of at most eight digits.
double number_in(const JsonPlace& p) {
  const std::string& text = p.string();
  const bool digits = !text.empty() && text.size() <= 8 &&
                      std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (!digits) p.fail("a string of 1 to 8 digits");
  return std::stod(text);
}

std::uint32_t second_of(const JsonPlace& p) {
  const std::string& text = p.string();  // hh:mm or hh:mm:ss
  const bool with_seconds = text.size() == 8;
  const auto digits = [&](std::size_t at) {
    const bool fits =
        at + 1 < text.size() && text[at] >= '0' && text[at] <= '9' && text[at + 1] >= '0' && text[at + 1] <= '9';
    if (!fits) p.fail("a time as 17:33 or 17:33:05");
    return static_cast<std::uint32_t>((text[at] - '0') * 10 + (text[at + 1] - '0'));
  };
  if (text.size() != 5 && !with_seconds) p.fail("a time as 17:33 or 17:33:05");
  return digits(0) * 3600 + digits(3) * 60 + (with_seconds ? digits(6) : 0U);
}

/// What is set step by step, and needs more than one member of the case.
struct Setting {
  explicit Setting(Scene& of) : scene(of), display(of.player.display()) {
    context.action.driver_id_valid = context.action.train_data_valid = context.action.train_running_number_valid = true;
    context.contact_known = context.session_above_2_2 = true;
  }

  Scene& scene;
  Display& display;
  driver::ButtonContext context;
  std::optional<bool> gsmr_fitted, frmcs_fitted;
  bool mrsp_given = false;
  std::optional<double> override_limit_kmh;
  bool tti_requested = true;
  std::optional<Duration> tti;
  bool in_reversing_area = false;
  bool at_stopping_point = true;
  bool level_acknowledged = false, level_ack_reached = false;
  double v_kmh = 0.0;
  std::string field;  ///< that the case enters, by its label
};

void set_speeds(Setting& s, const JsonPlace& list) {
  s.display.planning.speeds.clear();
  for (std::size_t i = 0; i < list.size(); ++i)
    if (!s.display.planning.speeds.push_back(
            {Distance{list[i]["from_m"].number(0.0, 1e6)}, kmh(list[i]["v"].number(0.0, 600.0)), {}}))
      list.fail("fewer restrictions");
  s.mrsp_given = true;
}

/// A change of speed at a place, from a speed that makes it an increase or a decrease.
void set_discontinuity(Setting& s, const JsonPlace& change) {
  const Speed V = kmh(change["v"].number(0.0, 600.0));
  const bool increase = change["increase"].boolean();
  const Distance at{change["at_m"].number(0.0, 1e6)};
  s.display.planning.speeds.clear();
  (void)s.display.planning.speeds.push_back({Distance{}, increase ? 0.5 * V : V + kmh(60.0), {}});
  (void)s.display.planning.speeds.push_back({at, V, {}});
  if (change["is_indication_target"].boolean()) {
    s.display.indication_target = at;
    s.display.indication_marker = 0.4 * at;
    s.display.monitoring = Monitoring::CSM;
  }
  s.mrsp_given = true;
}

/// Changes that are drawn with these symbols.
void set_discontinuities(Setting& s, const JsonPlace& list) {
  Speed V = kmh(160.0);
  s.display.planning.speeds.clear();
  (void)s.display.planning.speeds.push_back({Distance{}, V, {}});
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Picture picture = picture_named(list[i]["symbol"]);
    const Distance at{list[i]["at_m"].number(0.0, 1e6)};
    V = picture == Picture::PL21 ? V + kmh(30.0) : V - kmh(40.0);
    if (!s.display.planning.speeds.push_back({at, V, {}})) list.fail("fewer changes");
    if (picture != Picture::PL23 && picture != Picture::PL37) continue;
    s.display.indication_target = at;
    s.display.monitoring = Monitoring::CSM;
  }
  s.mrsp_given = true;
}

void set_gradients(Setting& s, const JsonPlace& list) {
  for (std::size_t i = 0; i < list.size(); ++i)
    if (!s.display.planning.gradients.push_back({Distance{list[i]["from_m"].number(0.0, 1e6)},
                                                 Distance{list[i]["to_m"].number(0.0, 1e6)},
                                                 static_cast<std::int16_t>(list[i]["permille"].integer(-254, 254))}))
      list.fail("fewer elements");
}

void set_orders(Setting& s, const JsonPlace& list) {
  for (std::size_t i = 0; i < list.size(); ++i)
    if (!s.display.orders.push_back(
            {picture_named(list[i]["symbol"]), Distance{list[i]["shown_from_m"].number(0.0, 1e6)}}))
      list.fail("fewer orders");
}

void set_texts(Setting& s, const JsonPlace& list) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    const bool important = list[i]["group"].integer(1, 2) == 1;
    const std::uint16_t id = add_text(s.scene, list[i]["text"].string(), important, false);
    const std::uint32_t second = second_of(list[i]["time"]);
    for (port::DisplayedText& text : s.display.texts)
      if (text.id == id) {
        text.minute_of_day = static_cast<std::uint16_t>(second / 60);
        text.since = Duration{static_cast<double>(second) - 86400.0};
      }
  }
}

void set_text_to_acknowledge(Setting& s, const JsonPlace& p) {
  const std::uint16_t id = add_text(s.scene, p["text"].string(), true, true);
  for (port::DisplayedText& text : s.display.texts)
    if (text.id == id) text.minute_of_day = static_cast<std::uint16_t>(second_of(p["time"]) / 60);
  (void)s.display.acks.push_back({Ack::text, id, Duration{}});
}

void set_tunnel(Setting& s, const JsonPlace& p) {
  if (!p["known"].boolean()) return;
  port::TunnelStoppingArea tunnel;
  const auto where = p.find("state");
  tunnel.inside = where && where->one_of({"announcement", "inside"}) == 1;
  if (const auto distance = p.find("distance_m")) tunnel.distance = Distance{distance->number(0.0, 1e6)};
  s.display.tunnel = tunnel;
}

void set_geo(Setting& s, const JsonPlace& p) {
  if (!p["known"].boolean()) return;
  s.display.geo = Distance{1000.0 * p["km"].number(0.0, 9999.0) + p["m"].number(0.0, 999.0)};
}

void set_conditions(Setting& s, const JsonPlace& list) {
  for (std::size_t i = 0; i < list.size(); ++i)
    if (!s.display.conditions.push_back(
            {static_cast<std::uint16_t>(i + 1), condition_named(list[i]), ConditionPhase::active}))
      list.fail("fewer conditions");
}

void set_priority_table(Setting& s, const JsonPlace& list) {
  constexpr std::string_view ntc = "NTC ";
  s.display.data.levels = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string& text = list[i].string();
    if (std::string_view(text).substr(0, ntc.size()) == ntc) {
      name_ntc(s.display, std::string_view(text).substr(ntc.size()));
      (void)s.display.data.ntcs.push_back(kNtc);
      s.display.data.levels |= static_cast<std::uint8_t>(1U << terms::index(Level::NTC));
    } else {
      s.display.data.levels |= static_cast<std::uint8_t>(1U << terms::index(level_named(list[i])));
    }
  }
}

void set_choices(Setting& s, const JsonPlace& p) {
  const std::int64_t count = p.integer(1, static_cast<std::int64_t>(kTrainCategoryRows.size()));
  s.display.config.categories = Set<TrainCategory>::of_bits((std::uint64_t{1} << count) - 1);
  for (std::int64_t i = 0; i < count; ++i)
    s.scene.labels[kTrainCategoryRows[static_cast<std::size_t>(i)].name] = "choice " + std::to_string(i + 1);
}

/// The range of the field of the case, the length where it names none.
port::EntryRange& range_of(Setting& s, const JsonPlace& p) {
  port::DisplayConfig& config = s.display.config;
  const std::array<std::pair<std::string_view, port::EntryRange*>, 6> ranges{
      {{"", &config.L_TRAIN},
       {"Length (m)", &config.L_TRAIN},
       {"Brake percentage", &config.brake_percentage},
       {"Maximum speed (km/h)", &config.V_MAXTRAIN},
       {"SR speed (km/h)", &config.V_sr},
       {"SR distance (m)", &config.D_sr}}};
  for (const auto& [label, range] : ranges)
    if (label == s.field) return *range;
  p.fail("a field with a range: length, brake percentage, maximum speed, SR speed or SR distance");
}

void set_operational(Setting& s, const JsonPlace& p) {
  port::EntryRange& range = range_of(s, p);
  range.operational_least = p[0].number();
  range.operational_most = p[1].number();
}
void set_technical(Setting& s, const JsonPlace& p) {
  port::EntryRange& range = range_of(s, p);
  range.least = p[0].number();
  range.most = p[1].number();
}

using Setter = std::function<void(Setting&, const JsonPlace&)>;

/// A check that no train passes.
void set_failing_check(Setting& s, bool operational) {
  (void)s.display.config.cross_checks.push_back(
      {Set<TrainCategory>::of_bits(~std::uint64_t{0}), kmh(1.0), operational});
}

void set_step(Setting& s, const JsonPlace& p) {
  const Step& step = step_named(p);
  s.scene.step = &step;
  s.display.step = step.start;
  s.display.start_of_mission = step.start.has_value();
  s.display.data.asks_one_radio_system = step.asks_one_radio_system;
}

/// What the tables ask for, and what is lost without it: the national values permit it.
Setter permitted(bool driver::ActionContext::*field, driver::Fact fact) {
  return [field, fact](Setting& s, const JsonPlace& p) {
    s.context.action.*field = p.boolean();
    s.scene.denied.add(fact, !p.boolean());
  };
}

/// Fields of the train data with a number, by their place in the window (015560 11.3.9).
void set_fields(Setting& s, const JsonPlace& p) {
  port::ShownTrainData& train = s.display.data.stored.train;
  for (const auto& [place, value] : p.value().items()) {
    const JsonPlace field = p[place];
    const double number = number_in(field);
    if (place == "2")
      train.L_TRAIN = Distance{number};
    else if (place == "3")
      train.brake_percentage = number;
    else if (place == "4")
      train.V_MAXTRAIN = kmh(number);
    else
      field.fail("field 2 (length), 3 (brake percentage) or 4 (maximum speed)");
  }
}

void set_running_number(Setting& s, const JsonPlace& p) {
  std::uint32_t bcd = 0;
  (void)number_in(p);
  const std::string& digits = p.string();
  for (std::size_t i = 0; i < 8; ++i)
    bcd = (bcd << 4U) | (i < digits.size() ? static_cast<std::uint32_t>(digits[i] - '0') : 0xFU);
  s.display.data.stored.train_running_number = bcd;
  s.display.data.stored.train_running_number_status = DataStatus::invalid;
}

Setter flag(bool Display::*field) {
  return [field](Setting& s, const JsonPlace& p) { s.display.*field = p.boolean(); };
}
Setter speed(std::optional<Speed> Display::*field) {
  return [field](Setting& s, const JsonPlace& p) { s.display.*field = speed_or_none(p); };
}
Setter metres(std::optional<Distance> Display::*field) {
  return [field](Setting& s, const JsonPlace& p) { s.display.*field = metres_or_none(p); };
}
Setter action(bool driver::ActionContext::*field) {
  return [field](Setting& s, const JsonPlace& p) { s.context.action.*field = p.boolean(); };
}
Setter context(bool driver::ButtonContext::*field) {
  return [field](Setting& s, const JsonPlace& p) { s.context.*field = p.boolean(); };
}
Setter data(DataStatus port::ShownData::*field, bool driver::ActionContext::*valid) {
  return [field, valid](Setting& s, const JsonPlace& p) {
    s.display.data.stored.*field = named(p, kDataStatuses);
    s.context.action.*valid = s.display.data.stored.*field == DataStatus::valid;
  };
}
void nothing(Setting&, const JsonPlace&) {}

const std::map<std::string, Setter, std::less<>>& train_setters() {
  static const std::map<std::string, Setter, std::less<>> all{
      {"srs", [](Setting& s, const JsonPlace& p) { s.display.config.srs = p.term<kSrsVersionRows>(); }},
      {"mode", [](Setting& s, const JsonPlace& p) { s.display.mode = p.term<kModeRows>(); }},
      {"level", [](Setting& s, const JsonPlace& p) { s.display.level = level_named(p); }},
      {"level_valid", flag(&Display::level_valid)},
      {"ntc_name", [](Setting& s, const JsonPlace& p) { name_ntc(s.display, p.string()); }},
      {"standstill", flag(&Display::standstill)},
      {"v",
       [](Setting& s, const JsonPlace& p) {
         s.v_kmh = p.number(0.0, 1000.0);
         s.display.v = kmh(s.v_kmh);
       }},
      {"monitoring", [](Setting& s, const JsonPlace& p) { s.display.monitoring = p.term<kMonitoringRows>(); }},
      {"status", [](Setting& s, const JsonPlace& p) { s.display.status = named(p, kStatuses); }},
      {"v_perm", speed(&Display::V_P)},
      {"v_sbi", speed(&Display::V_SBI)},
      {"v_target", speed(&Display::V_target)},
      {"v_release", speed(&Display::V_release)},
      {"target_info", flag(&Display::target_information)},
      {"d_target", metres(&Display::d_target)},
      {"tti_s", [](Setting& s, const JsonPlace& p) { s.tti = Duration{p.number(0.0, 1000.0)}; }},
      {"tti_requested", [](Setting& s, const JsonPlace& p) { s.tti_requested = p.boolean(); }},
      {"lssma", speed(&Display::LSSMA)},
      {"set_speed", speed(&Display::set_speed)},
      {"local_time", [](Setting& s, const JsonPlace& p) { s.display.second_of_day = second_of(p); }},
      {"slippery_rail", flag(&Display::slippery_rail)},
      {"override_active", flag(&Display::override_active)},
      {"brake_commanded", flag(&Display::brake)},
      {"bmm_inhibited", flag(&Display::bmm_inhibited)},
      {"in_reversing_area", [](Setting& s, const JsonPlace& p) { s.in_reversing_area = p.boolean(); }},
      {"sm_direction",
       [](Setting& s, const JsonPlace& p) {
         s.display.sm =
             p.one_of({"forward", "backward"}) == 0 ? port::SmDirection::forward : port::SmDirection::backward;
       }},
      {"radio", [](Setting& s, const JsonPlace& p) { s.display.radio = named(p, kRadio); }},
      {"announced_level",
       [](Setting& s, const JsonPlace& p) {
         s.display.announced_level = {level_named(p), kNtc};
       }},
      {"ack_window_reached", [](Setting& s, const JsonPlace& p) { s.level_ack_reached = p.boolean(); }},
      {"acknowledged", [](Setting& s, const JsonPlace& p) { s.level_acknowledged = p.boolean(); }},
      {"mode_ack",
       [](Setting& s, const JsonPlace& p) {
         (void)s.display.acks.push_back({ack_named(p), 0, Duration{}});
       }},
      {"track_conditions", set_conditions},
      {"tsa", set_tunnel},
      {"geo", set_geo},
      {"track_ahead_free", flag(&Display::track_ahead_free)},
      {"ato_selector",
       [](Setting& s, const JsonPlace& p) {
         s.display.ato.on = p.one_of({"Stand-by", "On"}) == 1;
       }},
      {"ato_status", [](Setting& s, const JsonPlace& p) { s.display.ato.status = named(p, kAtoStatuses); }},
      {"skip_stop", [](Setting& s, const JsonPlace& p) { s.display.ato.skip = named(p, kSkips); }},
      {"dwell_s",
       [](Setting& s, const JsonPlace& p) { s.display.ato.dwell_s = static_cast<std::uint16_t>(p.integer(0, 5999)); }},
      {"at_stopping_point", [](Setting& s, const JsonPlace& p) { s.at_stopping_point = p.boolean(); }},
      {"ato_stop", [](Setting& s, const JsonPlace& p) { s.display.ato.stop = named(p, kAtoStops); }},
      {"ato_hold", [](Setting& s, const JsonPlace& p) { s.display.ato.hold = p.boolean(); }},
      {"ato_doors", [](Setting& s, const JsonPlace& p) { s.display.ato.doors = named(p, kAtoDoors); }},
      {"coasting_advice", [](Setting& s, const JsonPlace& p) { s.display.ato.coasting_advice = p.boolean(); }},
      {"advice_speed", [](Setting& s, const JsonPlace& p) { s.display.ato.advice_speed = speed_or_none(p); }},
  };
  return all;
}

const std::map<std::string, Setter, std::less<>>& track_setters() {
  static const std::map<std::string, Setter, std::less<>> all{
      {"dial",
       [](Setting& s, const JsonPlace& p) {
         constexpr std::array<std::int64_t, 4> dials{140, 180, 250, 400};
         const auto place = std::find(dials.begin(), dials.end(), p.integer(140, 400));
         if (place == dials.end()) p.fail("140, 180, 250 or 400");
         s.display.config.dial = static_cast<port::Dial>(place - dials.begin());
       }},
      {"mrsp", set_speeds},
      {"gradients", set_gradients},
      {"orders", set_orders},
      {"discontinuity", set_discontinuity},
      {"discontinuities", set_discontinuities},
      {"first_indication_m", metres(&Display::indication_marker)},
      {"texts", set_texts},
      {"text_to_ack", set_text_to_acknowledge},
      {"priority_table", set_priority_table},
      {"choices", set_choices},
      {"fields", set_fields},
      {"value", set_running_number},
      {"operational_range", set_operational},
      {"technical_range", set_technical},
      {"technical_resolution", [](Setting& s, const JsonPlace& p) { range_of(s, p).step = p.number(1.0, 1e5); }},
      {"technical_cross_check_fails", [](Setting& s, const JsonPlace&) { set_failing_check(s, false); }},
      {"operational_cross_check_fails", [](Setting& s, const JsonPlace&) { set_failing_check(s, true); }},
      {"all_fields_valued",
       [](Setting& s, const JsonPlace& p) {
         if (!p.boolean()) s.display.data.stored.train_status = DataStatus::unknown;
       }},
      {"entry",
       [](Setting& s, const JsonPlace& p) {
         s.display.config.train_data_entry =
             static_cast<port::TrainDataEntry>(p.one_of({"flexible", "fixed", "switchable"}));
       }},
      {"stored_distance",
       [](Setting& s, const JsonPlace& p) {
         if (p.string() != "infinite") p.fail("\"infinite\"");
         s.display.data.stored.SR.D = std::nullopt;
         s.display.data.D_sr_most = Distance{s.display.config.D_sr.most};
       }},
      {"start_up", [](Setting& s, const JsonPlace& p) { s.display.start_of_mission = p.boolean(); }},
      {"step", set_step},
  };
  return all;
}

const std::map<std::string, Setter, std::less<>>& button_setters() {
  using A = driver::ActionContext;
  using C = driver::ButtonContext;
  static const std::map<std::string, Setter, std::less<>> all{
      {"driver_id", data(&port::ShownData::driver_id_status, &A::driver_id_valid)},
      {"train_data", data(&port::ShownData::train_status, &A::train_data_valid)},
      {"trn", data(&port::ShownData::train_running_number_status, &A::train_running_number_valid)},
      {"session", action(&A::session_open)},
      {"train_data_acked", action(&A::train_data_acknowledged)},
      {"pending_emergency_stop", context(&C::emergency_stop_pending)},
      {"nv_driver_id_running", permitted(&A::driver_id_while_running, driver::Fact::driver_id_while_running)},
      {"nv_adhesion_by_driver", permitted(&A::driver_may_change_adhesion, driver::Fact::adhesion_by_driver)},
      {"non_leading_signal", action(&A::non_leading_signal)},
      {"passive_shunting_signal", action(&A::passive_shunting_signal)},
      {"position_valid_lrbg", context(&C::position_valid)},
      {"integrity_range_ok", context(&C::length_in_range)},
      {"safe_consist_length", context(&C::consist_known)},
      {"session_above_2_2", context(&C::session_above_2_2)},
      {"consist_acknowledged", context(&C::consist_acknowledged)},
      {"second_session", context(&C::second_session)},
      {"rbc_transition_order", context(&C::RBC_transition_ordered)},
      {"one_radio_system", context(&C::one_radio_system)},
      {"gsmr_fitted", [](Setting& s, const JsonPlace& p) { s.gsmr_fitted = p.boolean(); }},
      {"frmcs_fitted", [](Setting& s, const JsonPlace& p) { s.frmcs_fitted = p.boolean(); }},
      {"consist_front_m",
       [](Setting& s, const JsonPlace& p) { s.context.consist_in_front = p.number(0.0, 1e5) > 0.0; }},
      {"v_override_limit", [](Setting& s, const JsonPlace& p) { s.override_limit_kmh = p.number(0.0, 600.0); }},
      {"vbc_count",
       [](Setting& s, const JsonPlace& p) {
         const std::int64_t count = p.integer(0, 1000);
         s.context.cover_stored = count > 0;
         for (std::int64_t i = 0; i < count && add_cover(s.display); ++i) {
         }
       }},
      {"vbc_capacity", nothing},
      {"rbc_contact",
       [](Setting& s, const JsonPlace& p) {
         s.context.contact_known = named(p, kDataStatuses) != DataStatus::unknown;
       }},
      {"radio_type",
       [](Setting& s, const JsonPlace& p) {
         s.display.data.radio = named(p, kNetworkTypes);
         s.display.config.frmcs_fitted = s.display.data.radio != port::RadioNetworkType::gsmr;
         s.context.network_type = s.display.data.radio == port::RadioNetworkType::gsmr    ? driver::NetworkType::gsmr
                                  : s.display.data.radio == port::RadioNetworkType::frmcs ? driver::NetworkType::frmcs
                                                                                          : driver::NetworkType::both;
       }},
      {"gsmr_registered", [](Setting& s, const JsonPlace& p) { s.context.gsmr.registered = p.boolean(); }},
      {"frmcs_registered", [](Setting& s, const JsonPlace& p) { s.context.frmcs.registered = p.boolean(); }},
      {"ack_pending",
       [](Setting& s, const JsonPlace& p) {
         if (p.boolean()) (void)s.display.acks.push_back({Ack::OS, 0, Duration{}});
       }},
  };
  return all;
}

/// What is done after the display is shown, and what `play` reads.
constexpr std::array kLater{
    "toggle_speed",  "range_m",         "zero_target_m", "window",    "page",    "pages",         "waiting",
    "t_s",           "keyboard",        "layout",        "press",     "presses", "events",        "event",
    "sequence",      "button",          "enter",         "field",     "accept",  "code",          "data",
    "process",       "cursor",          "RBC ID",        "ack_shown", "fifo",    "system_status", "scroll_lines",
    "mode_sequence", "t_after_start_s", "ma_end_m"};

/// The authority ends at a place, and the speed is 100 km/h up to there unless the case says otherwise.
void finish_planning(Setting& s, const JsonPlace& given) {
  port::Planning& planning = s.display.planning;
  if (!s.mrsp_given) {
    planning.speeds.clear();
    (void)planning.speeds.push_back({Distance{}, kmh(100.0), {}});
  }
  double end = kNoEnd;
  if (const auto p = given.find("ma_end_m")) end = p->number(0.0, 1e6);
  if (const auto p = given.find("zero_target_m")) end = p->number(0.0, 1e6);
  const bool stops_before =
      std::any_of(planning.speeds.begin(), planning.speeds.end(), [](const auto& step) { return step.V <= Speed{}; });
  if (!stops_before) planning.EOA = Distance{end};  // 3.15.10.4
}

void finish_train(Setting& s) {
  Display& d = s.display;
  d.config.gsmr_fitted = s.gsmr_fitted.value_or(d.config.gsmr_fitted);
  d.config.frmcs_fitted = s.frmcs_fitted.value_or(d.config.frmcs_fitted);
  if (s.tti_requested) d.TTI = s.tti;
  d.reversing_permitted = s.in_reversing_area && d.standstill;
  // Accuracy, dwell time and doors are those of a stopping point (015560 8.5.1.2 c).
  if (!s.at_stopping_point) {
    d.ato.stop = port::AtoStop::none;
    d.ato.doors = port::AtoDoors::none;
    d.ato.dwell_s.reset();
    d.ato.hold = false;
  }
  if (d.monitoring != Monitoring::none && d.status == Status::none) d.status = Status::Normal;
  // A target of which the case gives the distance alone is a stop.
  if (d.d_target && !d.V_target && d.monitoring != Monitoring::none &&
      (d.monitoring != Monitoring::CSM || d.target_information))
    d.V_target = Speed{};
  if (d.announced_level && s.level_ack_reached && !s.level_acknowledged)
    (void)d.acks.push_back({Ack::level, 0, Duration{}});
}

/// The buttons by Tables 33 to 37, where the case says on what they depend; none: all stay enabled.
std::optional<Set<Button>> buttons_by_tables(Setting& s, const JsonPlace& given) {
  if (!given.find("ack_pending")) {
    s.display.standstill = true;
    return std::nullopt;
  }
  driver::ButtonContext& c = s.context;
  c.action.srs = s.display.config.srs;
  c.action.mode = s.display.mode;
  c.action.desk_open = true;
  c.action.alarm_inhibited = s.display.bmm_inhibited;
  c.action.standstill = s.display.standstill;
  const bool level_valid = s.display.level_valid || !given.find("level_valid");
  c.action.level = level_valid ? std::optional(s.display.level) : std::nullopt;
  c.action.slow_enough_for_override = s.override_limit_kmh && s.v_kmh <= *s.override_limit_kmh;
  c.gsmr.fitted = s.display.config.gsmr_fitted;
  c.frmcs.fitted = s.display.config.frmcs_fitted;
  if (const auto capacity = given.find("vbc_capacity"))
    c.covers_full = given["vbc_count"].integer(0, 1000) >= capacity->integer(0, 1000);
  c.inputs = Set<driver::Input>::of_bits(~std::uint64_t{0});  // the tables alone decide: 4.7.2 asks for more
  s.scene.tables = c;
  return driver::buttons(c);
}

/// Something in every layer of the planning area, for a case that asks for their order.
void fill_layers(Setting& s) {
  s.display.ato.on = true;
  s.display.ato.advice_change = Distance{700.0};
  s.display.indication_marker = Distance{900.0};
  s.display.monitoring = Monitoring::CSM;
  (void)s.display.orders.push_back({Picture::PL02, Distance{600.0}});
  (void)s.display.planning.gradients.push_back({Distance{200.0}, Distance{1500.0}, 5});
  (void)s.display.planning.speeds.push_back({Distance{1800.0}, kmh(60.0), {}});
}

void set_zoom(Scene& scene, const JsonPlace& range) {
  const std::int64_t wanted = range.integer(1000, 32000);
  for (std::size_t presses = 0; presses < dmi::kRanges.size(); ++presses) {
    const std::int64_t now = dmi::kRanges[scene.player.state().zoom % dmi::kRanges.size()];
    if (now == wanted) return;
    if (!scene.player.touch(dmi::Action{now > wanted ? ActionKind::zoom_in : ActionKind::zoom_out}))
      return;  // no planning area
  }
}

/// The window of the case, of its step, or of the button which it looks for.
std::optional<std::string> window_of(const Scene& scene, const JsonPlace& given, const JsonPlace& expect) {
  if (const auto window = given.find("window")) return window->string();
  if (scene.step != nullptr && scene.step->window != nullptr) return scene.step->window;
  const auto must = expect.find("must");
  if (!must) return std::nullopt;
  for (std::size_t i = 0; i < must->size(); ++i)
    if (const auto window = (*must)[i].find("window")) return window->string();
  return std::nullopt;
}

std::optional<std::string_view> window_of_keyboard(const JsonPlace& given) {
  const auto keyboard = given.find("keyboard");
  if (!keyboard) return std::nullopt;
  constexpr std::array<std::pair<const char*, std::string_view>, 3> windows{
      {{"numeric", "Train running number"}, {"alphanumeric", "Driver ID"}, {"dedicated", "Train data"}}};
  return named(*keyboard, windows);
}

void touch_often(Scene& scene, ActionKind what, const JsonPlace& times, std::int64_t count, const char* expected) {
  for (std::int64_t i = 0; i < count; ++i)
    if (!scene.player.touch(dmi::Action{what})) times.fail(expected);
}

/// Gives the window this number of pages. Those of the data view follow from the VBCs on them (015560 Table 45); where
/// they follow from the fields, as those of train data, another number is an error.
void fill_pages(Scene& scene, const JsonPlace& pages) {
  const auto wanted = static_cast<std::size_t>(pages.integer(1, 99));
  const auto found = [&] { return std::size_t{dmi::pages_of(scene.player.state())}; };
  const bool views = scene.player.state().window == dmi::WindowId::data_view;
  while (views && found() < wanted && add_cover(scene.player.display())) scene.player.show();
  if (found() != wanted) pages.fail("the number of pages of the window, " + std::to_string(found()));
}

/// Opens the window of the case at its page, and scrolls the texts (015560 10.3.5.3, 10.5.1, 8.2.3.4.7 e).
void open_wanted(Scene& scene, const JsonPlace& given, const JsonPlace& expect) {
  auto window = window_of(scene, given, expect);
  if (const auto keyboard = window_of_keyboard(given)) window = std::string(*keyboard);
  if (given.find("data") || given.find("cursor")) window = "Driver ID";
  if (window && !open_window(scene, *window)) given.fail("a window that can be opened, found \"" + *window + "\"");
  if (const auto pages = given.find("pages")) fill_pages(scene, *pages);
  if (const auto page = given.find("page"))
    touch_often(scene, ActionKind::next, *page, page->integer(1, 99) - 1, "a page that the window has");
  if (const auto lines = given.find("scroll_lines"))
    touch_often(scene, ActionKind::scroll_down, *lines, lines->integer(0, 99), "no more lines than are below");
}

}  // namespace

Scene::Scene() {
  Display& d = player.display();
  d.config.srs = SrsVersion::v4_0_0;
  d.config.frmcs_fitted = false;
  (void)d.config.languages.push_back(Language{});
  d.mode = Mode::SB;
  d.level = Level::L1;
  d.standstill = false;
  d.buttons = Set<Button>::of_bits(~std::uint64_t{0});
  d.data.levels = 0x1F;
  port::ShownData& data = d.data.stored;
  data.driver_id = DriverId{"1234"};
  data.driver_id_status = data.train_running_number_status = data.level_status = data.rbc_status = data.train_status =
      DataStatus::valid;
  data.train_running_number = 0x4567FFFF;
  data.rbc = {352, 12, 0x1234FFFFFFFFFFFF, false};
  data.train = {.L_TRAIN = Distance{200.0},
                .V_MAXTRAIN = kmh(160.0),
                .brake_percentage = 120.0,
                .cant_deficiency_mm = 80,
                .other_categories = train::kPassenger,
                .axle_load = {},
                .loading_gauge = {},
                .airtight = false};
  data.SR = {DataStatus::valid, kmh(40.0), Distance{500.0}};
  data.network = 0x208010;
  (void)d.data.networks.push_back(0x208010);
}

void set_given(Scene& scene, const JsonPlace& given, const JsonPlace& expect) {
  Setting setting(scene);
  if (const auto field = given.find("field")) setting.field = field->string();
  for (const auto& member : given.value().items()) {
    const std::string& key = member.key();
    bool known = std::find(kLater.begin(), kLater.end(), key) != kLater.end();
    for (const auto* setters : {&train_setters(), &track_setters(), &button_setters()}) {
      const auto setter = setters->find(key);
      if (setter == setters->end()) continue;
      setter->second(setting, given[key]);
      known = true;
    }
    if (!known) given[key].fail("a member of `given` that docs/dmi.md lists");
  }
  finish_train(setting);
  finish_planning(setting, given);
  const auto buttons = buttons_by_tables(setting, given);
  const auto order = expect.find("order");
  if (order && order->size() > 0 && (*order)[0].is_string()) fill_layers(setting);
  const auto asked = setting.display.acks;
  if (buttons) setting.display.acks.clear();
  scene.player.show();
  if (const auto toggle = given.find("toggle_speed"); toggle && toggle->boolean())
    (void)scene.player.touch(dmi::Action{ActionKind::toggle_speed});
  for (const auto& [key, action] : {std::pair{"tsa", ActionKind::toggle_tunnel}, {"geo", ActionKind::toggle_geo}})
    if (const auto p = given.find(key); p && (*p)["toggle"].boolean()) (void)scene.player.touch(dmi::Action{action});
  if (const auto range = given.find("range_m")) set_zoom(scene, *range);
  open_wanted(scene, given, expect);
  if (!buttons) return;
  // Only now: the window whose buttons the case asks for may be opened by one that is disabled (015560 11.2.5.4).
  setting.display.acks = asked;
  setting.display.buttons = *buttons;
  scene.player.show();
}

}  // namespace evc::screen
