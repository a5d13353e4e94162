#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "capi/inputs.h"
#include "capi/outputs.h"
#include "openevc/evc.h"
#include "openevc/openevc.h"

// The members of C one by one, with those of the kernel (tools/check_ports.py: there is one for each).
namespace evc::capi {
namespace {

openevc_inputs defaults() {
  openevc_inputs in;
  EXPECT_EQ(openevc_inputs_init(&in, sizeof in), OPENEVC_OK);
  return in;
}

class Taken {
 public:
  explicit Taken(const openevc_inputs& in) : cycle_(std::make_unique<Cycle>()) {
    EXPECT_EQ(take_inputs(*cycle_, &in, {why_, sizeof why_}), OPENEVC_OK) << why_;
  }
  const kernel::Inputs& operator*() const { return cycle_->inputs; }
  const kernel::Inputs* operator->() const { return &cycle_->inputs; }

 private:
  char why_[256] = "";
  std::unique_ptr<Cycle> cycle_;
};

TEST(CInputs, WithoutAWordTheyAreTheKernelsDefaults) {
  const Taken taken(defaults());
  EXPECT_FALSE(taken->odometry.measured.has_value());
  EXPECT_FALSE(taken->radio_link_with.has_value());
  EXPECT_FALSE(taken->moved.has_value());
  EXPECT_FALSE(taken->train.brake_pressure_kpa.has_value());
  EXPECT_FALSE(taken->train.length_confirmed.has_value());
  EXPECT_EQ(taken->radio_link, RadioLink::unchanged);
  EXPECT_EQ(taken->train.direction_controller, kernel::DirectionController::forward);
  EXPECT_TRUE(taken->train.powered && taken->train.ep_brake_active && taken->windows.empty());
  EXPECT_EQ(taken->national_system, kernel::NationalSystem{});
}

TEST(CInputs, TheSafeConsistLengthIsWholeOrAbsent) {
  openevc_inputs in = defaults();
  EXPECT_FALSE(Taken(in)->train.consist.has_value());
  in.consist_front = {20.0, 19.0, 22.0};
  in.consist_rear = {300.0, 290.0, 310.0};
  const Taken taken(in);
  ASSERT_TRUE(taken->train.consist.has_value());
  EXPECT_EQ(*taken->train.consist, (ConsistLength{{{20.0}, {19.0}, {22.0}}, {{300.0}, {290.0}, {310.0}}}));
}

TEST(CInputs, TimesOfOdometerAndBalises) {
  openevc_inputs in = defaults();
  in.now = 5.0;
  in.measured = 4.75;
  const std::uint8_t bytes[] = {0x90};
  const openevc_telegram telegrams[] = {{bytes, 8, 0, 11.0}, {bytes, 7, 0, 12.0}};
  in.telegrams = telegrams;
  in.telegrams_count = 2;
  EXPECT_FALSE(Taken(in)->balise_telegrams[1].passed.has_value());
  const double passed[] = {std::nan(""), 4.5};
  in.telegrams_passed = passed;
  const Taken taken(in);
  EXPECT_EQ(taken->now, Duration{5.0});
  EXPECT_EQ(taken->odometry.measured, Duration{4.75});
  ASSERT_EQ(taken->balise_telegrams.size(), 2u);
  EXPECT_FALSE(taken->balise_telegrams[0].passed.has_value());
  EXPECT_EQ(taken->balise_telegrams[0].at.from_origin.si, 11.0);
  EXPECT_EQ(taken->balise_telegrams[1].passed, Duration{4.5});
  EXPECT_EQ(taken->balise_telegrams[1].bits, 7u);
  EXPECT_EQ(taken->balise_telegrams[1].bytes.size(), 1u);
}

TEST(CInputs, TheRbcOfMessagesAndReports) {
  openevc_inputs in = defaults();
  const std::uint8_t bytes[] = {0x20, 0x21};
  const openevc_message messages[] = {{bytes, 2}, {bytes, 1}};
  in.radio = messages;
  in.radio_count = 2;
  in.link = OPENEVC_LINK_LOST;
  EXPECT_FALSE(Taken(in)->radio_messages[1].from.has_value());
  const openevc_rbc from[] = {{0, 9, 9, 0}, {1, 3, 4, 0}};
  in.radio_from = from;
  in.link_with = {1, 5, 6, 0};
  const Taken taken(in);
  ASSERT_EQ(taken->radio_messages.size(), 2u);
  EXPECT_FALSE(taken->radio_messages[0].from.has_value());
  EXPECT_EQ(taken->radio_messages[1].from, (kernel::RbcIdentity{3, 4}));
  EXPECT_EQ(taken->radio_link, RadioLink::lost);
  EXPECT_EQ(taken->radio_link_with, (kernel::RbcIdentity{5, 6}));
}

TEST(CInputs, RadioInfillUnits) {
  openevc_inputs in = defaults();
  const std::uint8_t bytes[] = {0x20};
  const openevc_message messages[] = {{bytes, 1}, {bytes, 1}, {bytes, 1}};
  const openevc_rbc from[] = {{0, 0, 0, 0}, {0, 0, 0, 1}, {1, 3, 4, 1}};
  in.radio = messages;
  in.radio_count = 3;
  in.radio_from = from;
  EXPECT_FALSE(Taken(in)->radio_link_of_infill_unit);
  in.link_with = {1, 5, 6, 1};
  const Taken taken(in);
  EXPECT_FALSE(taken->radio_messages[0].infill_unit);
  EXPECT_TRUE(taken->radio_messages[1].infill_unit && !taken->radio_messages[1].from);
  EXPECT_TRUE(taken->radio_messages[2].infill_unit);
  EXPECT_EQ(taken->radio_messages[2].from, (kernel::RbcIdentity{3, 4}));
  EXPECT_TRUE(taken->radio_link_of_infill_unit);
  EXPECT_EQ(taken->radio_link_with, (kernel::RbcIdentity{5, 6}));
}

TEST(CInputs, Clock) {
  openevc_inputs in = defaults();
  in.utc = 1795342500;
  EXPECT_FALSE(Taken(in)->utc.has_value());
  in.utc_given = 1;
  EXPECT_EQ(Taken(in)->utc, 1795342500);
}

TEST(CInputs, ColdMovement) {
  openevc_inputs in = defaults();
  in.moved = OPENEVC_NOT_MOVED;
  EXPECT_EQ(Taken(in)->moved, false);
  in.moved = OPENEVC_MOVED;
  EXPECT_EQ(Taken(in)->moved, true);
  in.moved = OPENEVC_MOVED + 1;
  Cycle cycle;
  char why[64] = "";
  EXPECT_EQ(take_inputs(cycle, &in, {why, sizeof why}), OPENEVC_BAD_ARGUMENT);
  EXPECT_STREQ(why, "inputs.moved: not an openevc_movement");
}

/// A program with the header before `measured`.
TEST(CInputs, OfAnOlderHeader) {
  openevc_inputs in = defaults();
  in.measured = 1.0;
  in.link_with.given = 1;
  in.moved = OPENEVC_MOVED;
  in.size = offsetof(openevc_inputs, measured);
  const Taken taken(in);
  EXPECT_FALSE(taken->odometry.measured || taken->radio_link_with || taken->moved);
}

std::unique_ptr<openevc_outputs> given(const kernel::Outputs& o) {
  auto out = std::make_unique<openevc_outputs>();
  give_outputs(*out, o);
  return out;
}

TEST(COutputs, TextsAndHowTheyAreShown) {
  const auto o = std::make_unique<kernel::Outputs>();
  kernel::ShownText text;
  text.id = 7;
  text.important = true;
  text.since = {3.5};
  text.length = 2;
  text.characters[0] = 'a';
  text.characters[1] = '\xE9';
  ASSERT_TRUE(o->texts.push_back(text));
  text.important = false;
  text.acknowledge = true;
  text.since = {4.0};
  text.Q_TEXT = 1;
  ASSERT_TRUE(o->texts.push_back(text));
  ASSERT_TRUE(o->status_texts.push_back({StatusText{3}, {9.0}}));
  ASSERT_TRUE(o->status_texts.push_back({StatusText{0}, {8.0}}));
  const auto out = given(*o);
  ASSERT_EQ(out->texts_count, 2u);
  EXPECT_EQ(std::string(out->texts[0].characters, out->texts[0].characters + out->texts[0].length), "a\xE9");
  EXPECT_EQ(out->texts[0].id, 7);
  EXPECT_EQ(out->texts[0].Q_TEXT, -1);
  EXPECT_EQ(out->texts[1].Q_TEXT, 1);
  EXPECT_EQ(out->texts_shown[0].since, 3.5);
  EXPECT_TRUE(out->texts_shown[0].important == 1 && out->texts_shown[0].acknowledge == 0);
  EXPECT_TRUE(out->texts_shown[1].important == 0 && out->texts_shown[1].acknowledge == 1);
  EXPECT_EQ(out->status_texts, 0b1001u);
  ASSERT_EQ(out->statuses_count, 2u);
  EXPECT_TRUE(out->statuses[0].text == 3 && out->statuses[0].since == 9.0);
  EXPECT_TRUE(out->statuses[1].text == 0 && out->statuses[1].since == 8.0);
}

TEST(COutputs, WhatAProcedureWaitsFor) {
  const auto o = std::make_unique<kernel::Outputs>();
  EXPECT_EQ(given(*o)->national_system, -1);
  EXPECT_EQ(given(*o)->network, -1);
  o->national_system = 7;
  o->data.network = 0x26210F;
  o->set_speed = Speed{10.0};
  EXPECT_EQ(given(*o)->national_system, 7);
  EXPECT_EQ(given(*o)->network, 0x26210F);
  EXPECT_EQ(given(*o)->set_speed, 10.0);
  o->shown = {DriverOutput::level};
  EXPECT_EQ(given(*o)->shown, 2u);
  EXPECT_EQ(given(*o)->dialogue, -1);
  o->dialogue = kernel::ShownDialogue{Dialogue::start_S12, {}};
  EXPECT_EQ(given(*o)->dialogue, 9);
  EXPECT_EQ(given(*o)->dialogue_acknowledge, -1);
  o->dialogue = kernel::ShownDialogue{Dialogue::start_S24, Ack::SR};
  EXPECT_EQ(given(*o)->dialogue_acknowledge, OPENEVC_ACK_SR);
}

TEST(COutputs, RadioWithTwoRbcs) {
  const auto o = std::make_unique<kernel::Outputs>();
  kernel::OutgoingMessage message;
  ASSERT_TRUE(message.bytes.push_back(0x88));
  ASSERT_TRUE(o->radio_out.push_back(message));
  message.to = kernel::RbcIdentity{3, 4};
  ASSERT_TRUE(o->radio_out.push_back(message));
  ASSERT_TRUE(o->sessions.push_back({1, 2, SessionPhase::up, SessionRole::supervising}));
  ASSERT_TRUE(o->sessions.push_back({3, 4, SessionPhase::connecting, SessionRole::accepting}));
  o->radio_connect = kernel::RbcAddress{3, 4, 0x123F};
  const auto out = given(*o);
  ASSERT_EQ(out->radio_out_count, 2u);
  EXPECT_TRUE(out->radio_out[1].size == 1 && out->radio_out[1].bytes[0] == 0x88);
  EXPECT_EQ(out->radio_out_to[0].given, 0);
  EXPECT_TRUE(out->radio_out_to[1].given == 1 && out->radio_out_to[1].NID_C == 3 && out->radio_out_to[1].NID_RBC == 4);
  ASSERT_EQ(out->sessions_count, 2u);
  EXPECT_TRUE(out->sessions[0].phase == OPENEVC_SESSION_UP && out->sessions_role[0] == OPENEVC_SUPERVISING);
  EXPECT_TRUE(out->sessions[1].NID_C == 3 && out->sessions[1].NID_RBC == 4);
  EXPECT_TRUE(out->sessions[1].phase == OPENEVC_SESSION_CONNECTING && out->sessions_role[1] == OPENEVC_ACCEPTING);
  EXPECT_TRUE(out->connect.given == 1 && out->connect.NID_RADIO == 0x123F && out->disconnect.given == 0);
}

TEST(COutputs, RadioInfillUnits) {
  const auto o = std::make_unique<kernel::Outputs>();
  kernel::OutgoingMessage message;
  ASSERT_TRUE(message.bytes.push_back(0x99));
  message.to = kernel::RbcIdentity{1, 7};
  message.infill_unit = true;
  ASSERT_TRUE(o->radio_out.push_back(message));
  ASSERT_TRUE(o->infill_sessions.push_back({1, 7, SessionPhase::up, {}}));
  ASSERT_TRUE(o->infill_sessions.push_back({1, 8, SessionPhase::connecting, {}}));
  o->radio_connect = kernel::RbcAddress{1, 8, 0x123F, true};
  o->radio_disconnect = kernel::RbcAddress{1, 9, 0x123F};
  const auto out = given(*o);
  EXPECT_TRUE(out->radio_out_to[0].given == 1 && out->radio_out_to[0].infill_unit == 1);
  EXPECT_EQ(out->sessions_count, 0u);
  ASSERT_EQ(out->infill_sessions_count, 2u);
  EXPECT_TRUE(out->infill_sessions[0].NID_RBC == 7 && out->infill_sessions[0].phase == OPENEVC_SESSION_UP);
  EXPECT_TRUE(out->infill_sessions[1].NID_C == 1 && out->infill_sessions[1].phase == OPENEVC_SESSION_CONNECTING);
  EXPECT_TRUE(out->connect.infill_unit == 1 && out->disconnect.infill_unit == 0);
}

TEST(COutputs, TrackConditionsForTheDriver) {
  const auto o = std::make_unique<kernel::Outputs>();
  ASSERT_TRUE(o->track_conditions.push_back(
      {Symbol::TC10, TrackConditionKind::sound_horn, {{5.0}}, {{6.0}}, ConditionPhase::active}));
  ASSERT_TRUE(o->track_conditions.push_back({Symbol::TC23, std::nullopt, {{7.0}}, {{7.0}}, ConditionPhase::announced}));
  o->sound_horn = true;
  const auto out = given(*o);
  ASSERT_EQ(out->conditions_count, 2u);
  EXPECT_STREQ(out->conditions[0].symbol, "TC10");
  EXPECT_EQ(out->conditions[0].kind, OPENEVC_SOUND_HORN);
  EXPECT_EQ(out->conditions[0].phase, OPENEVC_CONDITION_ACTIVE);
  EXPECT_TRUE(out->conditions[0].from == 5.0 && out->conditions[0].to == 6.0);
  EXPECT_EQ(out->conditions[1].kind, -1);
  EXPECT_EQ(out->conditions[1].phase, OPENEVC_CONDITION_ANNOUNCED);
  EXPECT_TRUE(out->sound_horn == 1 && out->remote_shunting == 0 && out->engine_orientation == 0);
}

TEST(COutputs, OrdersForTheTrain) {
  const auto o = std::make_unique<kernel::Outputs>();
  ASSERT_TRUE(o->ordered_areas.push_back({TrackConditionKind::air_tightness, Distance{-3.0}, {40.0}}));
  ASSERT_TRUE(o->ordered_areas.push_back({TrackConditionKind::powerless_main_switch_off, std::nullopt, {-1.0}}));
  ASSERT_TRUE(o->ordered_platforms.push_back({Distance{10.0}, {210.0}, 4, 2}));
  o->ordered_traction = kernel::OrderedTraction{{500.0}, 3, 17};
  o->ordered_current = kernel::OrderedCurrent{{600.0}, 250};
  o->remote_shunting = true;
  o->engine_orientation = EngineOrientation::opposite;
  const auto out = given(*o);
  ASSERT_EQ(out->areas_count, 2u);
  EXPECT_EQ(out->areas[0].kind, OPENEVC_AIR_TIGHTNESS);
  EXPECT_TRUE(out->areas[0].to_start == -3.0 && out->areas[0].to_end == 40.0);
  EXPECT_EQ(out->areas[1].kind, OPENEVC_POWERLESS_MAIN_SWITCH_OFF);
  EXPECT_TRUE(std::isnan(out->areas[1].to_start) && out->areas[1].to_end == -1.0);
  ASSERT_EQ(out->platforms_count, 1u);
  EXPECT_TRUE(out->platforms[0].to_start == 10.0 && out->platforms[0].to_end == 210.0);
  EXPECT_TRUE(out->platforms[0].M_PLATFORM == 4 && out->platforms[0].Q_PLATFORM == 2);
  EXPECT_TRUE(out->traction.given == 1 && out->traction.M_VOLTAGE == 3 && out->traction.NID_CTRACTION == 17);
  EXPECT_EQ(out->traction.to_start, 500.0);
  EXPECT_TRUE(out->current.given == 1 && out->current.amperes == 250 && out->current.to_start == 600.0);
  EXPECT_TRUE(out->remote_shunting == 1 && out->sound_horn == 0 && out->engine_orientation == -1);
  o->engine_orientation = EngineOrientation::same;
  EXPECT_EQ(given(*o)->engine_orientation, 1);
  o->ordered_current->amperes.reset();
  o->ordered_traction.reset();
  EXPECT_EQ(given(*o)->current.amperes, -1);
  EXPECT_EQ(given(*o)->traction.given, 0);
}

TEST(COutputs, StoredData) {
  const auto o = std::make_unique<kernel::Outputs>();
  EXPECT_EQ(given(*o)->data.driver_id_status, OPENEVC_DATA_UNKNOWN);
  EXPECT_EQ(given(*o)->data.covers_count, 0);
  EXPECT_TRUE(std::isnan(given(*o)->data.brake_percentage) && std::isnan(given(*o)->data.D_sr));
  kernel::ShownData& d = o->data;
  d.driver_id_status = d.rbc_status = DataStatus::valid;
  d.train_running_number_status = d.level_status = DataStatus::invalid;
  d.train_status = d.SR.status = DataStatus::valid;
  d.slippery_rail = true;
  d.driver_id = DriverId("4711");
  d.train_running_number = 0x12FFFFFF;
  d.rbc = {1, 2, 0x123F};
  d.train = {Distance{300.0}, {40.0}, 120.0, 150, 5, train::AxleLoad::C2, train::LoadingGauge::GB, true};
  d.SR.V = {10.0};
  d.SR.D = Distance{55.0};
  while (o->covers.grow() != nullptr) o->covers.back() = {7, 9, {60.0}};
  const auto out = given(*o);
  const openevc_data& data = out->data;
  EXPECT_TRUE(data.driver_id_status == OPENEVC_DATA_VALID && data.driver_id == 0x4711FFFF);
  EXPECT_STREQ(out->driver_id_text, "4711");
  EXPECT_STREQ(out->language, "en");
  d.driver_id = DriverId("A1");
  EXPECT_EQ(given(*o)->data.driver_id, 0xFFFFFFFF);
  d.driver_id = DriverId("123456789");
  EXPECT_EQ(given(*o)->data.driver_id, 0xFFFFFFFF);
  EXPECT_TRUE(data.train_running_number_status == OPENEVC_DATA_INVALID && data.train_running_number == 0x12FFFFFF);
  EXPECT_TRUE(data.level_status == OPENEVC_DATA_INVALID && data.rbc_status == OPENEVC_DATA_VALID);
  EXPECT_TRUE(data.rbc.given == 1 && data.rbc.NID_C == 1 && data.rbc.NID_RBC == 2 && data.rbc.NID_RADIO == 0x123F);
  EXPECT_TRUE(data.train_status == OPENEVC_DATA_VALID && data.L_TRAIN == 300.0 && data.V_MAXTRAIN == 40.0);
  EXPECT_TRUE(data.brake_percentage == 120.0 && data.cant_deficiency_mm == 150 && data.other_categories == 5);
  EXPECT_TRUE(data.M_AXLELOADCAT == 4 && data.M_LOADINGGAUGE == 3 && data.airtight == 1);
  EXPECT_TRUE(data.SR_status == OPENEVC_DATA_VALID && data.V_sr == 10.0 && data.D_sr == 55.0);
  EXPECT_EQ(data.slippery_rail, 1);
  ASSERT_EQ(data.covers_count, 16);
  EXPECT_TRUE(data.covers[15].NID_C == 7 && data.covers[15].NID_VBCMK == 9 && data.covers[15].left == 60.0);
}

TEST(COutputs, Clock) {
  const auto o = std::make_unique<kernel::Outputs>();
  EXPECT_EQ(given(*o)->utc_given, 0u);
  o->clock = kernel::DateTime{1795342500, -90};
  const auto out = given(*o);
  EXPECT_TRUE(out->utc_given == 1 && out->utc == 1795342500 && out->local_offset_min == -90);
}

TEST(COutputs, ForwardedData) {
  const auto o = std::make_unique<kernel::Outputs>();
  while (o->forwarded.grow() != nullptr) o->forwarded.back() = {};
  kernel::ForwardedData& data = o->forwarded[1];
  data.NID_XUSER = 102;
  data.NID_NTC = 11;
  data.bits = 12;
  ASSERT_TRUE(data.bytes.push_back(0xAB) && data.bytes.push_back(0xC0));
  const auto out = given(*o);
  ASSERT_EQ(out->forwarded_count, 8u);
  EXPECT_EQ(out->forwarded[0].NID_NTC, -1);
  const openevc_forwarded& f = out->forwarded[1];
  EXPECT_TRUE(f.NID_XUSER == 102 && f.NID_NTC == 11 && f.bits == 12 && f.size == 2);
  EXPECT_TRUE(f.bytes[0] == 0xAB && f.bytes[1] == 0xC0);
}

TEST(COutputs, Planning) {
  const auto p = std::make_unique<kernel::Planning>();
  ASSERT_TRUE(p->speeds.push_back({Distance{10.0}, {20.0}, {MrspSource::SSP, MrspSource::mode}}));
  ASSERT_TRUE(p->gradients.push_back({Distance{1.0}, {2.0}, -6}));
  ASSERT_TRUE(p->conditions.push_back({Symbol::PL24, TrackConditionKind::sound_horn, {30.0}}));
  ASSERT_TRUE(p->conditions.push_back({Symbol::PL28, std::nullopt, {40.0}}));
  p->EOA = Distance{50.0};
  const auto out = std::make_unique<openevc_planning>();
  give_planning(*out, p.get());
  EXPECT_EQ(out->given, 1u);
  ASSERT_TRUE(out->speeds_count == 1 && out->gradients_count == 1 && out->conditions_count == 2);
  EXPECT_TRUE(out->speeds[0].at == 10.0 && out->speeds[0].V == 20.0);
  EXPECT_EQ(out->speeds[0].sources, 1u << OPENEVC_MRSP_SSP | 1u << OPENEVC_MRSP_MODE);
  EXPECT_TRUE(out->gradients[0].from == 1.0 && out->gradients[0].to == 2.0 && out->gradients[0].permille == -6);
  EXPECT_STREQ(out->conditions[0].symbol, "PL24");
  EXPECT_TRUE(out->conditions[0].kind == OPENEVC_SOUND_HORN && out->conditions[0].at == 30.0);
  EXPECT_EQ(out->conditions[1].kind, -1);
  EXPECT_TRUE(out->EOA == 50.0 && std::isnan(out->LOA) && std::isnan(out->V_LOA));
  p->EOA.reset();
  p->LOA = Distance{60.0};
  p->V_LOA = {5.0};
  give_planning(*out, p.get());
  EXPECT_TRUE(std::isnan(out->EOA) && out->LOA == 60.0 && out->V_LOA == 5.0);
  while (p->speeds.grow() != nullptr) p->speeds.back() = {};
  while (p->gradients.grow() != nullptr) p->gradients.back() = {};
  while (p->conditions.grow() != nullptr) p->conditions.back() = {};
  give_planning(*out, p.get());
  EXPECT_TRUE(out->speeds_count == 128 && out->gradients_count == 96 && out->conditions_count == 97);
}

/// Each change of the record changes a member, and nothing else.
TEST(CDisplay, EveryMemberIsGiven) {
  const auto record = std::make_unique<kernel::Display>();
  const auto given = [&] {
    auto out = std::make_unique<openevc_display>();
    give_display(*out, *record);
    return out;
  };
  auto before = given();
  EXPECT_TRUE(std::isnan(before->V_P) && std::isnan(before->TTI) && std::isnan(before->geo));
  EXPECT_TRUE(before->second_of_day == -1 && before->step == -1 && before->network == -1);
  using D = kernel::Display;
  const std::vector<void (*)(D&)> changes{
      [](D& d) { d.now = Duration{1.0}; },
      [](D& d) { d.second_of_day = 5; },
      [](D& d) { d.mode = Mode::FS; },
      [](D& d) { d.level = Level::L2; },
      [](D& d) { d.level_valid = true; },
      [](D& d) { d.nid_ntc = 7; },
      [](D& d) { d.standstill = false; },
      [](D& d) {
        d.language = Language{{'d', 'e'}};
      },
      [](D& d) { d.v = Speed{10.0}; },
      [](D& d) { d.monitoring = Monitoring::TSM; },
      [](D& d) { d.status = Status::Warning; },
      [](D& d) { d.V_P = Speed{1.0}; },
      [](D& d) { d.V_SBI = Speed{1.0}; },
      [](D& d) { d.V_target = Speed{1.0}; },
      [](D& d) { d.V_release = Speed{1.0}; },
      [](D& d) { d.target_information = true; },
      [](D& d) { d.MRDT = 9; },
      [](D& d) { d.d_target = Distance{1.0}; },
      [](D& d) { d.TTI = Duration{1.0}; },
      [](D& d) { d.LSSMA = Speed{1.0}; },
      [](D& d) { d.set_speed = Speed{1.0}; },
      [](D& d) { d.slippery_rail = true; },
      [](D& d) { d.sm = port::SmDirection::backward; },
      [](D& d) { d.override_active = true; },
      [](D& d) { d.reversing_permitted = true; },
      [](D& d) { d.bmm_inhibited = true; },
      [](D& d) { d.brake = true; },
      [](D& d) { d.brake_for_missing_ack = true; },
      [](D& d) {
        d.announced_level = port::AnnouncedLevel{Level::NTC, 3};
      },
      [](D& d) { d.radio = RadioIndication::up; },
      [](D& d) { d.geo = Distance{12.0}; },
      [](D& d) {
        (void)d.conditions.push_back({4, Picture::TC36, ConditionPhase::active});
      },
      [](D& d) {
        d.tunnel = port::TunnelStoppingArea{true, Distance{5.0}};
      },
      [](D& d) { d.track_ahead_free = true; },
      [](D& d) {
        (void)d.planning.gradients.push_back({Distance{1.0}, Distance{2.0}, 3});
      },
      [](D& d) {
        (void)d.orders.push_back({Picture::PL37, Distance{6.0}});
      },
      [](D& d) { d.indication_marker = Distance{1.0}; },
      [](D& d) { d.indication_target = Distance{1.0}; },
      [](D& d) { (void)d.texts.push_back({.id = 300, .kind = port::TextKind::status}); },
      [](D& d) { d.texts[0].minute_of_day = 61; },
      [](D& d) { d.texts[0].characters[254] = 'x'; },
      [](D& d) {
        (void)d.acks.push_back({Ack::text, 4, Duration{2.0}});
      },
      [](D& d) { d.data.stored.train_status = DataStatus::valid; },
      [](D& d) { d.data.stored.network = 0x26203F; },
      [](D& d) { d.data.levels = 5; },
      [](D& d) { (void)d.data.ntcs.push_back(8); },
      [](D& d) { (void)d.data.networks.push_back(0x26203F); },
      [](D& d) {
        (void)d.data.covers.push_back({1, 2, Duration{3.0}, 4});
      },
      [](D& d) { d.data.M_VERSION = 0x21; },
      [](D& d) { d.data.gsmr_registered = true; },
      [](D& d) { d.data.D_sr_most = Distance{7.0}; },
      [](D& d) { d.buttons.add(Button::start); },
      [](D& d) { d.enabled.add(DriverInput::start); },
      [](D& d) { d.step = Dialogue::start_S1; },
      [](D& d) { d.start_of_mission = true; },
      [](D& d) { d.waiting = port::Waiting::session; },
      [](D& d) { d.ato.on = true; },
      [](D& d) { d.config.dial = port::Dial::to_140; },
      [](D& d) { d.config.asks_brake_percentage = false; },
      [](D& d) { d.config.T_dispTTI = Duration{9.0}; },
  };
  for (std::size_t i = 0; i < changes.size(); ++i) {
    changes[i](*record);
    auto after = given();
    EXPECT_NE(std::memcmp(before.get(), after.get(), sizeof *after), 0) << i;
    before = std::move(after);
  }
  EXPECT_STREQ(before->conditions[0].symbol, "TC36");
  EXPECT_STREQ(before->orders[0].symbol, "PL37");
  EXPECT_TRUE(before->data.covers_count == 1 && before->data.covers[0].T_VBC == 4);
  EXPECT_EQ(before->SM_direction, -1);
}

TEST(CDisplay, FullLists) {
  const auto d = std::make_unique<kernel::Display>();
  while (d->conditions.grow() != nullptr) d->conditions.back() = {};
  while (d->orders.grow() != nullptr) d->orders.back() = {};
  while (d->texts.grow() != nullptr) d->texts.back() = {};
  while (d->acks.grow() != nullptr) d->acks.back() = {};
  while (d->data.ntcs.grow() != nullptr) d->data.ntcs.back() = {};
  while (d->data.networks.grow() != nullptr) d->data.networks.back() = {};
  while (d->data.covers.grow() != nullptr) d->data.covers.back() = {};
  const auto out = std::make_unique<openevc_display>();
  give_display(*out, *d);
  EXPECT_TRUE(out->conditions_count == 50 && out->orders_count == 97 && out->texts_count == 32);
  EXPECT_TRUE(out->asked_count == 32 && out->national_systems_count == 16 && out->networks_count == 16);
  EXPECT_EQ(out->data.covers_count, 16u);
}

/// Every list is full: nothing is left out, and nothing is written beyond it.
TEST(COutputs, FullLists) {
  const auto o = std::make_unique<kernel::Outputs>();
  while (o->symbols.grow() != nullptr) o->symbols.back() = Symbol::MO07;
  while (o->events.grow() != nullptr) o->events.back() = {};
  while (o->texts.grow() != nullptr) o->texts.back() = {};
  while (o->radio_out.grow() != nullptr) o->radio_out.back() = {};
  while (o->sessions.grow() != nullptr) o->sessions.back() = {};
  while (o->status_texts.grow() != nullptr) o->status_texts.back() = {};
  while (o->track_conditions.grow() != nullptr) o->track_conditions.back() = {};
  while (o->ordered_areas.grow() != nullptr) o->ordered_areas.back() = {};
  while (o->ordered_platforms.grow() != nullptr) o->ordered_platforms.back() = {};
  const auto out = given(*o);
  EXPECT_EQ(out->symbols_count, 32u);
  EXPECT_EQ(out->events_count, 96u);
  EXPECT_EQ(out->texts_count, 6u);
  EXPECT_EQ(out->radio_out_count, 24u);
  EXPECT_EQ(out->sessions_count, 2u);
  EXPECT_EQ(out->statuses_count, 20u);
  EXPECT_EQ(out->conditions_count, 49u);
  EXPECT_EQ(out->areas_count, 48u);
  EXPECT_EQ(out->platforms_count, 40u);
}

}  // namespace
}  // namespace evc::capi
