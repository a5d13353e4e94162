#include "io/display_json.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "base/test_units.h"
#include "io/display_reader.h"
#include "io/json.h"
#include "io/latin1.h"

namespace evc::io {
namespace {

using kernel::Display;

Json record(const Display& d) {
  std::string text;
  append_display(text, d);
  return Json::parse(text);
}

template <std::size_t N>
std::array<char, N> characters(std::string_view text) {
  std::array<char, N> out{};
  text.copy(out.data(), N);
  return out;
}

/// One element in each list, so that its members can be changed.
Display filled() {
  Display d;
  (void)d.config.ntc_names.push_back({1, characters<8>("PZB")});
  (void)d.config.languages.push_back({});
  (void)d.config.train_types.push_back({});
  (void)d.config.cross_checks.push_back({});
  d.level = Level::NTC;
  d.announced_level = port::AnnouncedLevel{Level::NTC, 1};
  (void)d.conditions.push_back({});
  d.tunnel = port::TunnelStoppingArea{};
  (void)d.planning.speeds.push_back({});
  (void)d.planning.gradients.push_back({});
  d.planning.LOA = 100_m;
  (void)d.orders.push_back({});
  for (const auto kind : {port::TextKind::fixed, port::TextKind::plain, port::TextKind::status}) {
    port::DisplayedText text;
    text.kind = kind;
    text.status = StatusText::national_system_not_available;
    (void)d.texts.push_back(text);
  }
  (void)d.acks.push_back({.what = Ack::text});
  return d;
}

/// What changes, and how, in order of the members of Display and the structs in it.
struct Change {
  const char* what;
  std::function<void(Display&)> make;
  bool motion = false;  ///< `--changes` does not count it
};

const std::vector<Change>& changes() {
  using D = Display;
  static const std::vector<Change> all{
      {"config.srs", [](D& d) { d.config.srs = SrsVersion::v3_6_0; }},
      {"config.dial", [](D& d) { d.config.dial = port::Dial::to_180; }},
      {"ntc nid_ntc", [](D& d) { d.config.ntc_names[0].nid_ntc = 9; }},
      {"ntc name", [](D& d) { d.config.ntc_names[0].characters[0] = 'L'; }},
      {"languages",
       [](D& d) {
         d.config.languages[0].letters = {'d', 'e'};
       }},
      {"train_data_entry", [](D& d) { d.config.train_data_entry = port::TrainDataEntry::fixed; }},
      {"train type name", [](D& d) { d.config.train_types[0].name[0] = 'A'; }},
      {"train type data", [](D& d) { d.config.train_types[0].data.L_TRAIN = 100_m; }},
      {"categories", [](D& d) { d.config.categories.remove(TrainCategory::TILT3); }},
      {"axle_loads", [](D& d) { d.config.axle_loads = 3; }},
      {"loading_gauges", [](D& d) { d.config.loading_gauges = 3; }},
      {"L_TRAIN", [](D& d) { d.config.L_TRAIN.least = 1; }},
      {"brake_percentage", [](D& d) { d.config.brake_percentage.most = 1; }},
      {"asks_brake_percentage", [](D& d) { d.config.asks_brake_percentage = false; }},
      {"V_MAXTRAIN", [](D& d) { d.config.V_MAXTRAIN.step = 2; }},
      {"V_sr", [](D& d) { d.config.V_sr.operational_least = 1; }},
      {"D_sr", [](D& d) { d.config.D_sr.operational_most = 1; }},
      {"check categories", [](D& d) { d.config.cross_checks[0].categories = {TrainCategory::FG1}; }},
      {"check V_most", [](D& d) { d.config.cross_checks[0].V_most = 36_km_h; }},
      {"check operational", [](D& d) { d.config.cross_checks[0].operational = true; }},
      {"gsmr_fitted", [](D& d) { d.config.gsmr_fitted = false; }},
      {"frmcs_fitted", [](D& d) { d.config.frmcs_fitted = true; }},
      {"T_dispTTI", [](D& d) { d.config.T_dispTTI = 10_s; }},
      {"now", [](D& d) { d.now = 1_s; }, true},
      {"second_of_day", [](D& d) { d.second_of_day = 1; }, true},
      {"mode", [](D& d) { d.mode = Mode::FS; }},
      {"level", [](D& d) { d.level = Level::L2; }},
      {"level_valid", [](D& d) { d.level_valid = true; }},
      {"nid_ntc", [](D& d) { d.nid_ntc = 4; }},
      {"standstill", [](D& d) { d.standstill = false; }},
      {"language",
       [](D& d) {
         d.language.letters = {'d', 'e'};
       }},
      {"v", [](D& d) { d.v = 36_km_h; }, true},
      {"monitoring", [](D& d) { d.monitoring = Monitoring::TSM; }},
      {"status", [](D& d) { d.status = Status::Warning; }},
      {"V_P", [](D& d) { d.V_P = 36_km_h; }},
      {"V_SBI", [](D& d) { d.V_SBI = 36_km_h; }},
      {"V_target", [](D& d) { d.V_target = 36_km_h; }},
      {"V_release", [](D& d) { d.V_release = 36_km_h; }},
      {"target_information", [](D& d) { d.target_information = true; }},
      {"MRDT", [](D& d) { d.MRDT = 1; }},
      {"d_target", [](D& d) { d.d_target = 1_m; }},
      {"TTI", [](D& d) { d.TTI = 1_s; }},
      {"LSSMA", [](D& d) { d.LSSMA = 36_km_h; }},
      {"set_speed", [](D& d) { d.set_speed = 36_km_h; }},
      {"slippery_rail", [](D& d) { d.slippery_rail = true; }},
      {"sm", [](D& d) { d.sm = port::SmDirection::backward; }},
      {"override_active", [](D& d) { d.override_active = true; }},
      {"reversing_permitted", [](D& d) { d.reversing_permitted = true; }},
      {"bmm_inhibited", [](D& d) { d.bmm_inhibited = true; }},
      {"brake", [](D& d) { d.brake = true; }},
      {"brake_for_missing_ack", [](D& d) { d.brake_for_missing_ack = true; }},
      {"announced level", [](D& d) { d.announced_level->level = Level::L1; }},
      {"announced nid_ntc", [](D& d) { d.announced_level->nid_ntc = 2; }},
      {"radio", [](D& d) { d.radio = RadioIndication::up; }},
      {"geo", [](D& d) { d.geo = 1_m; }},
      {"condition id", [](D& d) { d.conditions[0].id = 5; }},
      {"condition picture", [](D& d) { d.conditions[0].picture = Picture::TC03; }},
      {"condition phase", [](D& d) { d.conditions[0].phase = ConditionPhase::active; }},
      {"tunnel inside", [](D& d) { d.tunnel->inside = true; }},
      {"tunnel distance", [](D& d) { d.tunnel->distance = 5_m; }, true},
      {"track_ahead_free", [](D& d) { d.track_ahead_free = true; }},
      {"speed at", [](D& d) { d.planning.speeds[0].at = 5_m; }, true},
      {"speed V", [](D& d) { d.planning.speeds[0].V = 36_km_h; }},
      {"speed sources", [](D& d) { d.planning.speeds[0].sources.add(MrspSource::TSR); }},
      {"gradient from", [](D& d) { d.planning.gradients[0].from = 5_m; }, true},
      {"gradient to", [](D& d) { d.planning.gradients[0].to = 5_m; }, true},
      {"gradient permille", [](D& d) { d.planning.gradients[0].permille = 5; }},
      {"EOA", [](D& d) { d.planning.EOA = 5_m; }},
      {"LOA", [](D& d) { d.planning.LOA = 5_m; }, true},
      {"V_LOA", [](D& d) { d.planning.V_LOA = 36_km_h; }},
      {"order picture", [](D& d) { d.orders[0].picture = Picture::PL02; }},
      {"order at", [](D& d) { d.orders[0].at = 5_m; }, true},
      {"indication_marker", [](D& d) { d.indication_marker = 5_m; }},
      {"indication_target", [](D& d) { d.indication_target = 5_m; }},
      {"text id", [](D& d) { d.texts[0].id = 5; }},
      {"text kind", [](D& d) { d.texts[1].kind = port::TextKind::national; }},
      {"text important", [](D& d) { d.texts[0].important = true; }},
      {"text acknowledge", [](D& d) { d.texts[0].acknowledge = true; }},
      {"text since", [](D& d) { d.texts[0].since = 5_s; }},
      {"text minute_of_day", [](D& d) { d.texts[0].minute_of_day = 5; }},
      {"text Q_TEXT", [](D& d) { d.texts[0].Q_TEXT = 1; }},
      {"text characters",
       [](D& d) {
         d.texts[1].length = 1;
         d.texts[1].characters[0] = '\xE4';
       }},
      {"text status", [](D& d) { d.texts[2].status = StatusText::SH_refused; }},
      {"text nid_ntc", [](D& d) { d.texts[2].nid_ntc = 5; }},
      {"ack what", [](D& d) { d.acks[0].what = Ack::OS; }},
      {"ack id", [](D& d) { d.acks[0].id = 5; }},
      {"ack since", [](D& d) { d.acks[0].since = 5_s; }},
      {"stored", [](D& d) { d.data.stored.driver_id_status = DataStatus::invalid; }},
      {"train_type", [](D& d) { d.data.train_type = 1; }},
      {"levels", [](D& d) { d.data.levels = 3; }},
      {"ntcs", [](D& d) { (void)d.data.ntcs.push_back(7); }},
      {"networks", [](D& d) { (void)d.data.networks.push_back(0x26210F); }},
      {"covers",
       [](D& d) {
         (void)d.data.covers.push_back({7, 9, 60_s});
       }},
      {"M_VERSION", [](D& d) { d.data.M_VERSION = 0x21; }},
      {"radio network type", [](D& d) { d.data.radio = port::RadioNetworkType::frmcs; }},
      {"gsmr_registered", [](D& d) { d.data.gsmr_registered = true; }},
      {"frmcs_registered", [](D& d) { d.data.frmcs_registered = true; }},
      {"asks_one_radio_system", [](D& d) { d.data.asks_one_radio_system = true; }},
      {"D_sr_most", [](D& d) { d.data.D_sr_most = 5_m; }},
      {"buttons", [](D& d) { d.buttons.add(Button::start); }},
      {"enabled", [](D& d) { d.enabled.add(DriverInput::start); }},
      {"step", [](D& d) { d.step = Dialogue::start_S1; }},
      {"start_of_mission", [](D& d) { d.start_of_mission = true; }},
      {"waiting", [](D& d) { d.waiting = port::Waiting::answer_to_sm_request; }},
      {"ato on", [](D& d) { d.ato.on = true; }},
      {"ato status", [](D& d) { d.ato.status = port::AtoStatus::failure; }},
      {"ato stop", [](D& d) { d.ato.stop = port::AtoStop::accurate; }},
      {"ato dwell", [](D& d) { d.ato.dwell_s = 5; }, true},
      {"ato hold", [](D& d) { d.ato.hold = true; }},
      {"ato doors", [](D& d) { d.ato.doors = port::AtoDoors::closed; }},
      {"ato skip", [](D& d) { d.ato.skip = port::AtoSkip::by_driver; }},
      {"ato coasting", [](D& d) { d.ato.coasting_advice = true; }},
      {"ato warning", [](D& d) { d.ato.warning_sound = true; }},
      {"ato advice speed", [](D& d) { d.ato.advice_speed = 36_km_h; }},
      {"ato name",
       [](D& d) {
         d.ato.name_length = 1;
         d.ato.name[0] = 'A';
       }},
      {"ato arrival", [](D& d) { d.ato.arrival_second_of_day = 5; }},
      {"ato stopping points", [](D& d) { (void)d.ato.stopping_points.push_back(5_m); }},
      {"ato advice change", [](D& d) { d.ato.advice_change = 5_m; }},
  };
  return all;
}

TEST(DisplayJson, EveryMemberIsInTheRecordAndNoTwoLookTheSame) {
  const auto before = std::make_unique<Display>(filled());
  std::set<std::string> seen{record(*before).dump()};
  for (const Change& change : changes()) {
    const auto after = std::make_unique<Display>(*before);
    change.make(*after);
    EXPECT_TRUE(seen.insert(record(*after).dump()).second) << change.what;
  }
}

/// What the record that was read is written as; empty: it is none.
std::string again(const std::string& text) {
  const auto read = std::make_unique<Display>();
  std::string written;
  if (read_display(text, *read)) append_display(written, *read);
  return written;
}

TEST(DisplayReader, EveryMemberIsReadAsItWasWritten) {
  const auto before = std::make_unique<Display>(filled());
  std::vector<Change> all = changes();
  all.push_back({"nothing", [](Display&) {}});
  all.push_back({"stored data", [](Display& d) {
                   kernel::ShownData& stored = d.data.stored;
                   stored.driver_id_status = stored.train_running_number_status = stored.level_status =
                       stored.rbc_status = stored.train_status = DataStatus::valid;
                   stored.SR = {DataStatus::valid, 36_km_h, 500_m};
                   stored.slippery_rail = true;
                   stored.driver_id = DriverId("Ab4711");
                   stored.train_running_number = 0x471FFFFF;
                   stored.rbc = {7, 9, 0x0049170FFFFFFFFF};
                   stored.network = 0x26210F;
                   stored.train = {100_m, 36_km_h, 135.0, 130, 5, train::AxleLoad(3), train::LoadingGauge(2), true};
                 }});
  for (std::size_t n = 0; n < terms::index(Dialogue::count); ++n)
    all.push_back({"step", [n](Display& d) { d.step = static_cast<Dialogue>(n); }});
  for (const Change& change : all) {
    const auto after = std::make_unique<Display>(*before);
    change.make(*after);
    std::string text;
    append_display(text, *after);
    EXPECT_EQ(again(text), text) << change.what;
  }
}

TEST(DisplayReader, WhatIsNoRecordIsRefused) {
  std::string text;
  append_display(text, *std::make_unique<Display>(filled()));
  ASSERT_EQ(again(text), text);
  for (std::size_t size = 0; size < text.size(); size += 7) EXPECT_EQ(again(text.substr(0, size)), "") << size;
  const Json whole = Json::parse(text), flat = whole.flatten();
  for (const auto& [pointer, value] : flat.items()) {
    Json other = whole;
    other[Json::json_pointer(pointer)] = Json::array({1, "x"});   // of no member
    if (pointer.find("/stored/") != std::string::npos) continue;  // of a datum that is not known no value is read
    if (pointer == "/sounds") continue;                           // a display makes its own
    EXPECT_EQ(again(other.dump()), "") << pointer;
  }
  for (const auto& [key, value] : whole.items()) {
    if (key == "sounds") continue;
    Json other = whole;
    other.erase(key);
    EXPECT_EQ(again(other.dump()), "") << key;
  }
  // More than there is room for.
  Json many = whole;
  for (int n = 0; n < 64; ++n) many["acks"].push_back(whole["acks"][0]);
  EXPECT_EQ(again(many.dump()), "");
}

TEST(DisplayJson, MotionAndTimeDoNotCountAsChanges) {
  const auto before = std::make_unique<Display>(filled());
  for (const Change& change : changes()) {
    const auto after = std::make_unique<Display>(*before);
    change.make(*after);
    EXPECT_EQ(motionless(*after) == motionless(*before), change.motion) << change.what;
  }
  // A value that is there, wherever it is.
  const auto there = [](double at) {
    const auto d = std::make_unique<Display>(filled());
    const Distance distance{at};
    d->d_target = d->geo = d->planning.EOA = d->indication_marker = d->indication_target = distance;
    d->data.stored.SR = {DataStatus::valid, {}, distance};
    d->V_P = d->V_SBI = Speed{at};
    d->TTI = Duration{at};
    (void)d->data.covers.push_back({7, 9, Duration{at}});
    (void)d->ato.stopping_points.push_back(distance);
    d->ato.advice_change = distance;
    return motionless(*d);
  };
  EXPECT_EQ(there(1.0), there(2.0));
  EXPECT_NE(there(1.0), motionless(*before));
}

TEST(DisplayJson, Texts) {
  auto d = std::make_unique<Display>(filled());
  d->texts[1].length = 2;
  d->texts[1].characters = characters<255>("\xC4h");
  d->texts[2].nid_ntc = 6;
  const Json texts = record(*d)["texts"];
  EXPECT_EQ(texts[0]["kind"], "fixed");
  EXPECT_EQ(texts[0]["q_text"], 0);
  EXPECT_EQ(texts[1]["text"], "\xC3\x84h");
  EXPECT_EQ(texts[2]["status"], "National system is not available");
  EXPECT_EQ(texts[2]["nid_ntc"], 6);
  EXPECT_EQ(record(*d)["schema"], "evc-dmi/1");
  EXPECT_EQ(record(*d)["config"]["ntc_names"], Json::parse(R"([{"nid_ntc":1,"name":"PZB"}])"));
}

TEST(Latin1, IsUtf8AndBack) {
  std::string all, utf8;
  for (int c = 1; c < 256; ++c) all += static_cast<char>(c);
  append_utf8(utf8, all);
  EXPECT_EQ(utf8.size(), 127u + 2u * 128u);
  EXPECT_EQ(latin1_of(utf8), all);
  EXPECT_EQ(latin1_of("a\xE2\x82\xAC"
                      "b\xF0\x9F\x9A\x82\xC4\x80"),
            "a?b??");  // euro sign, locomotive, a letter beyond
  EXPECT_EQ(latin1_of("\xC3"), "?");
}

}  // namespace
}  // namespace evc::io
