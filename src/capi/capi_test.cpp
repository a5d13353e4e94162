#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "base/test_paths.h"
#include "capi/capi_test.h"
#include "openevc/language.h"
#include "openevc/openevc.h"

namespace {

using evc::capi::CUnit;
using evc::capi::Memory;

std::string file(const std::string& name) {
  std::ifstream in(evc::test::source_folder() + "/" + name);
  return {std::istreambuf_iterator<char>(in), {}};
}

constexpr std::uint8_t kPacket65[] = {0x41, 0x40, 0x8E, 0x83, 0x83, 0x52, 0x03, 0x20, 0x20};
constexpr const char* kPacket65Json =
    R"({"NID_PACKET":65,"Q_DIR":1,"L_PACKET":71,"Q_SCALE":1,"NID_TSR":7,"D_TSR":850,"L_TSR":400,"Q_FRONT":0,"V_TSR":16})";

openevc_reading packet() {
  openevc_reading r{};
  r.size = sizeof r;
  r.form = OPENEVC_PACKET;
  return r;
}

TEST(C, VersionIsTheHeaders) {
  const std::string version = std::to_string(OPENEVC_VERSION_MAJOR) + "." + std::to_string(OPENEVC_VERSION_MINOR) +
                              "." + std::to_string(OPENEVC_VERSION_PATCH);
  EXPECT_EQ(openevc_version(), version);
}

TEST(CDecode, TextIntoTheCallersBuffer) {
  const openevc_reading reading = packet();
  char json[512];
  std::size_t length = 0;
  ASSERT_EQ(openevc_decode(&reading, kPacket65, 71, json, sizeof json, &length, nullptr, 0), OPENEVC_OK);
  EXPECT_STREQ(json, kPacket65Json);
  EXPECT_EQ(length, std::strlen(kPacket65Json));
}

TEST(CDecode, BufferOfEachSize) {
  const openevc_reading reading = packet();
  const std::size_t needed = std::strlen(kPacket65Json) + 1;
  for (std::size_t size = 0; size <= needed; ++size) {
    std::vector<char> json(size + 1, '#');
    std::size_t length = 0;
    const openevc_result result = openevc_decode(&reading, kPacket65, 71, json.data(), size, &length, nullptr, 0);
    EXPECT_EQ(result, size < needed ? OPENEVC_TOO_SMALL : OPENEVC_OK) << size;
    EXPECT_EQ(length, needed - 1);
    EXPECT_EQ(json[size], '#') << "written beyond " << size;
  }
}

TEST(CDecode, WhyIsCutToItsBuffer) {
  const openevc_reading reading = packet();
  std::uint8_t wrong[sizeof kPacket65];
  std::memcpy(wrong, kPacket65, sizeof wrong);
  wrong[1] = 0x40;
  wrong[2] = 0x9E;  // L_PACKET 79
  char json[512], why[256];
  ASSERT_EQ(openevc_decode(&reading, wrong, 71, json, sizeof json, nullptr, why, sizeof why), OPENEVC_REFUSED);
  EXPECT_STREQ(why, "bit 10, packet 65, L_PACKET 79: L_PACKET reaches beyond the end");
  char part[8] = "#######";
  EXPECT_EQ(openevc_decode(&reading, wrong, 71, json, sizeof json, nullptr, part, 7), OPENEVC_REFUSED);
  EXPECT_STREQ(part, "bit 10");
}

TEST(CDecode, WhatIsNoArgument) {
  openevc_reading reading = packet();
  char json[512], why[64];
  EXPECT_EQ(openevc_decode(nullptr, kPacket65, 71, json, sizeof json, nullptr, why, sizeof why), OPENEVC_BAD_ARGUMENT);
  EXPECT_EQ(openevc_decode(&reading, nullptr, 71, json, sizeof json, nullptr, nullptr, 0), OPENEVC_BAD_ARGUMENT);
  EXPECT_EQ(openevc_decode(&reading, kPacket65, 71, nullptr, 0, nullptr, nullptr, 0), OPENEVC_TOO_SMALL);
  reading.form = 4;
  EXPECT_EQ(openevc_decode(&reading, kPacket65, 71, json, sizeof json, nullptr, nullptr, 0), OPENEVC_BAD_ARGUMENT);
  reading.size = 0;
  EXPECT_EQ(openevc_decode(&reading, kPacket65, 71, json, sizeof json, nullptr, nullptr, 0), OPENEVC_BAD_ARGUMENT);
}

/// A program that was compiled with a shorter struct: members it does not have count as zero.
TEST(CDecode, ShorterStruct) {
  openevc_reading reading = packet();
  reading.size = offsetof(openevc_reading, to_track);
  reading.to_track = 1;   // not part of it
  reading.version_x = 9;  // neither
  char json[512];
  EXPECT_EQ(openevc_decode(&reading, kPacket65, 71, json, sizeof json, nullptr, nullptr, 0), OPENEVC_OK);
}

class CCurves : public testing::Test {
 protected:
  CCurves() : memory(openevc_curves_size()) {}
  openevc_result build(const std::string& document) {
    return openevc_curves_build(memory.at(), memory.size(), document.data(), document.size(), &curves, why, sizeof why);
  }
  Memory memory;
  openevc_curves* curves = nullptr;
  char why[256] = "";
};

/// The row that `evc curves` prints for the same document (docs/curves.md).
TEST_F(CCurves, RowOfTheExample) {
  ASSERT_EQ(build(file("data/curves/passenger_eoa.json")), OPENEVC_OK) << why;
  EXPECT_TRUE(memory.fence_stands());
  openevc_distances d{};
  d.size = sizeof d;
  ASSERT_EQ(openevc_curves_at_speed(curves, 140 / 3.6, &d), OPENEVC_OK);
  EXPECT_NEAR(d.EBD, 1067.2, 0.05);
  EXPECT_NEAR(d.EBI, 1282.0, 0.05);
  EXPECT_NEAR(d.FLOI, 1694.2, 0.05);
  EXPECT_NEAR(d.P, 1849.7, 0.05);
  EXPECT_NEAR(d.I, 2335.1, 0.05);
  EXPECT_TRUE(std::isnan(d.GUI));  // no guidance curve
  EXPECT_EQ(d.size, sizeof d);
  openevc_speeds s{};
  s.size = sizeof s;
  ASSERT_EQ(openevc_curves_at_position(curves, 7000.0 - d.EBD, &s), OPENEVC_OK);
  EXPECT_NEAR(s.EBD, 140 / 3.6, 1e-6);
}

/// An object is plain memory: it may be moved as bytes.
TEST_F(CCurves, MovesAsBytes) {
  ASSERT_EQ(build(file("data/curves/workbook.json")), OPENEVC_OK) << why;
  openevc_distances a{}, b{};
  a.size = b.size = sizeof a;
  ASSERT_EQ(openevc_curves_at_speed(curves, 20.0, &a), OPENEVC_OK);
  Memory other(openevc_curves_size());
  std::memcpy(other.at(), memory.at(), memory.size());
  std::memset(memory.at(), 0, memory.size());
  EXPECT_EQ(openevc_curves_at_speed(curves, 20.0, &a), OPENEVC_BAD_ARGUMENT);
  ASSERT_EQ(openevc_curves_at_speed(static_cast<openevc_curves*>(other.at()), 20.0, &b), OPENEVC_OK);
  EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0);
}

TEST_F(CCurves, WhatIsRefused) {
  EXPECT_EQ(build("{}"), OPENEVC_REFUSED);
  EXPECT_EQ(curves, nullptr);
  EXPECT_NE(std::string(why).find("schema"), std::string::npos) << why;
  EXPECT_EQ(build("{"), OPENEVC_REFUSED);
  const std::string document = file("data/curves/passenger_eoa.json");
  const auto with = [&](void* at, std::size_t size) {
    return openevc_curves_build(at, size, document.data(), document.size(), &curves, why, sizeof why);
  };
  EXPECT_EQ(with(nullptr, memory.size()), OPENEVC_BAD_ARGUMENT);
  EXPECT_EQ(with(memory.at(), memory.size() - 1), OPENEVC_BAD_ARGUMENT);
  EXPECT_EQ(with(static_cast<char*>(memory.at()) + 1, memory.size()), OPENEVC_BAD_ARGUMENT);
  EXPECT_STREQ(why, "memory: not aligned to openevc_alignment()");
  EXPECT_EQ(openevc_curves_build(memory.at(), memory.size(), nullptr, 0, &curves, why, sizeof why),
            OPENEVC_BAD_ARGUMENT);
  EXPECT_EQ(openevc_curves_build(memory.at(), memory.size(), "{}", 2, nullptr, why, sizeof why), OPENEVC_BAD_ARGUMENT);
  ASSERT_EQ(build(document), OPENEVC_OK);
  openevc_distances d{};
  EXPECT_EQ(openevc_curves_at_speed(curves, 20.0, &d), OPENEVC_BAD_ARGUMENT);  // no size
  d.size = sizeof d;
  for (const double v : {-1.0, std::nan(""), 1e9})
    EXPECT_EQ(openevc_curves_at_speed(curves, v, &d), OPENEVC_BAD_ARGUMENT);
  EXPECT_EQ(openevc_curves_at_speed(curves, 20.0, nullptr), OPENEVC_BAD_ARGUMENT);
  EXPECT_EQ(openevc_curves_at_speed(nullptr, 20.0, &d), OPENEVC_BAD_ARGUMENT);
  openevc_speeds s{};
  s.size = sizeof s;
  EXPECT_EQ(openevc_curves_at_position(curves, std::nan(""), &s), OPENEVC_BAD_ARGUMENT);
}

/// A longer struct of a newer program: nothing is written beyond the library's own struct, and its size is kept.
TEST_F(CCurves, LongerStruct) {
  ASSERT_EQ(build(file("data/curves/passenger_eoa.json")), OPENEVC_OK) << why;
  struct {
    openevc_distances known;
    std::uint64_t newer;
  } d{};
  d.known.size = sizeof d;
  d.newer = 0x1234;
  ASSERT_EQ(openevc_curves_at_speed(curves, 20.0, &d.known), OPENEVC_OK);
  EXPECT_EQ(d.known.size, sizeof d);
  EXPECT_EQ(d.newer, 0x1234u);
}

TEST_F(CUnit, WindowsAlarmsAndTrainDataOfAnotherSource) {
  run(0, 80);
  ASSERT_EQ(out->mode, OPENEVC_UN);
  const auto brakes_for = [&](const char* name) {
    for (int32_t cause = 0; openevc_cause_name(cause) != nullptr; ++cause)
      if (((out->brake_causes >> cause) & 1u) != 0 && std::strcmp(openevc_cause_name(cause), name) == 0) return true;
    return false;
  };
  openevc_inputs in = at(80);
  in.national_service_brake = in.national_emergency_brake = 1;
  ASSERT_EQ(step(in), OPENEVC_OK) << why;
  EXPECT_FALSE(brakes_for("national system")) << "outside SN it has no access to the brakes (SUBSET-035 5.3.1.1)";
  in = at(81);
  in.open_windows = 1u << OPENEVC_WINDOW_TRAIN_DATA;
  in.nominal = in.min = in.max = 1.0;
  in.V_est = in.V_min = in.V_max = 5.0;
  ASSERT_EQ(step(in), OPENEVC_OK) << why;
  EXPECT_TRUE(brakes_for("movement while entering train data"));
  in = at(82);
  in.nominal = in.min = in.max = 302.0;
  in.V_est = in.V_min = in.V_max = 5.0;
  in.antenna_alarm = 1;
  ASSERT_EQ(step(in), OPENEVC_OK) << why;
  EXPECT_FALSE(brakes_for("balise antenna"));
  in.now = 8.3;
  in.nominal = in.min = in.max = 603.0;
  in.external_train_data = kTrain;
  in.external_train_data_length = 1;
  EXPECT_EQ(step(in), OPENEVC_REFUSED);
  EXPECT_NE(std::strstr(why, "inputs.external_train_data"), nullptr) << why;
  in.external_train_data = R"({"schema":"etcs-train/1","length_m":250})";
  in.external_train_data_length = std::strlen(in.external_train_data);
  in.external_data_trusted = 1;
  in.integrity = OPENEVC_INTEGRITY_LOST + 1;
  EXPECT_EQ(step(in), OPENEVC_BAD_ARGUMENT);
  EXPECT_NE(std::strstr(why, "inputs.integrity"), nullptr) << why;
  in.integrity = OPENEVC_INTEGRITY_OK;
  for (const openevc_consist_end wrong : {openevc_consist_end{300.0, 301.0, 310.0},
                                          {300.0, 290.0, 299.0},
                                          {300.0, 290.0, std::nan("")},
                                          {300.0, 290.0, 4096.0}}) {
    in.consist_front = {20.0, 19.0, 22.0};
    in.consist_rear = wrong;
    EXPECT_EQ(step(in), OPENEVC_BAD_ARGUMENT);
    EXPECT_NE(std::strstr(why, "inputs.consist"), nullptr) << why;
  }
  in.consist_rear = {300.0, 290.0, 310.0};
  in.length_confirmed = 200.0;
  ASSERT_EQ(step(in), OPENEVC_OK) << why;
  EXPECT_TRUE(brakes_for("balise antenna"));
  EXPECT_FALSE(brakes_for("train data changed"));
  EXPECT_TRUE(has_event("train data changed by an external source [5.17.2.2]")) << out->events[0].text;
  EXPECT_TRUE(has_event("train data valid [3.18.3]"));
}

TEST_F(CUnit, StartOfMissionInLevel0) {
  run(0, 1);
  EXPECT_EQ(out->mode, OPENEVC_SB);
  EXPECT_TRUE(has_event("mode NP->SB [4]")) << out->events[0].text;
  run(1, 80);
  EXPECT_EQ(out->mode, OPENEVC_UN);
  EXPECT_EQ(out->level, OPENEVC_L0);
  EXPECT_EQ(out->LRBG_NID_BG, -1);
  EXPECT_EQ(out->M_VERSION >> 4, 2) << "3.17.2: X of the highest version that the on-board supports";
  EXPECT_TRUE(std::isnan(out->EOA));
  ASSERT_GT(out->symbols_count, 0u);
  bool unfitted = false;
  for (std::uint32_t i = 0; i < out->symbols_count; ++i) unfitted |= std::strcmp(out->symbols[i], "MO16") == 0;
  EXPECT_TRUE(unfitted) << "4.7.2: the symbol of UN";
  EXPECT_TRUE(memory.fence_stands());
}

/// A brake, its cause by name: standstill supervision in SB (3.14.4).
TEST_F(CUnit, BrakeHasACause) {
  run(0, 3);
  for (int n = 3; n < 40; ++n) {
    openevc_inputs in = at(n);
    in.entered = in.selected = in.acknowledged = 0;
    in.nominal = in.min = in.max = 0.2 * (n - 2);
    in.V_est = in.V_min = in.V_max = 2.0;
    ASSERT_EQ(step(in), OPENEVC_OK) << why;
  }
  ASSERT_NE(out->brake_causes, 0u);
  EXPECT_TRUE(out->sb || out->eb);
  std::string causes;
  for (int n = 0; n < 64; ++n)
    if ((out->brake_causes >> n) & 1u) causes += std::string(openevc_cause_name(n)) + ";";
  EXPECT_NE(causes.find("standstill;"), std::string::npos) << causes;
  EXPECT_EQ(openevc_cause_name(-1), nullptr);
  EXPECT_EQ(openevc_cause_name(64), nullptr);
  EXPECT_STREQ(openevc_status_text_name(0), "Balise read error");
  EXPECT_EQ(openevc_status_text_name(-1), nullptr);
  EXPECT_EQ(openevc_status_text_name(64), nullptr);
  EXPECT_STREQ(openevc_input_name(0), "train_data");
  EXPECT_EQ(openevc_input_name(-1), nullptr);
  EXPECT_EQ(openevc_input_name(64), nullptr);
  EXPECT_STREQ(openevc_output_name(3), "permitted_speed");
  EXPECT_EQ(openevc_output_name(-1), nullptr);
  EXPECT_EQ(openevc_output_name(64), nullptr);
  EXPECT_STREQ(openevc_dialogue(9).procedure, "start_of_mission");
  EXPECT_STREQ(openevc_dialogue(9).step, "S12");
  EXPECT_STREQ(openevc_dialogue(9).waits_for, "train_data");
  EXPECT_EQ(openevc_dialogue(-1).step, nullptr);
  EXPECT_EQ(openevc_dialogue(64).step, nullptr);
}

/// A telegram that cannot be decoded is handled by the unit, not rejected as an argument.
TEST_F(CUnit, TelegramIsRead) {
  run(0, 80);
  std::uint8_t bytes[104] = {};
  const openevc_telegram telegram{bytes, 830, 0, 0.0};
  openevc_inputs in = at(80);
  in.telegrams = &telegram;
  in.telegrams_count = 1;
  ASSERT_EQ(step(in), OPENEVC_OK);
  ASSERT_GT(out->events_count, 0u);
  in.telegrams = nullptr;
  EXPECT_EQ(step(in), OPENEVC_BAD_ARGUMENT);
}

/// As many as there is room for; one more is refused, and the unit stays as it was.
TEST_F(CUnit, MoreDataThanACycleTakes) {
  run(0, 80);
  const std::uint8_t bytes[104] = {};
  const std::vector<openevc_telegram> telegrams(OPENEVC_RECEIVED + 1, {bytes, 830, 0, 0.0});
  const std::vector<openevc_message> messages(OPENEVC_RECEIVED + 1, {bytes, 20});
  openevc_inputs in = at(80);
  in.telegrams = telegrams.data();
  in.loops = in.radio = messages.data();
  std::vector<unsigned char> before(openevc_snapshot_size()), after(openevc_snapshot_size());
  ASSERT_EQ(openevc_snapshot(unit, before.data(), before.size()), OPENEVC_OK);
  for (std::size_t* const count : {&in.telegrams_count, &in.loops_count, &in.radio_count}) {
    *count = OPENEVC_RECEIVED + 1;
    EXPECT_EQ(step(in), OPENEVC_BAD_ARGUMENT);
    EXPECT_NE(std::strstr(why, "more than 64"), nullptr) << why;
    *count = OPENEVC_RECEIVED;
  }
  ASSERT_EQ(openevc_snapshot(unit, after.data(), after.size()), OPENEVC_OK);
  EXPECT_TRUE(before == after);
  EXPECT_EQ(step(in), OPENEVC_OK) << why;
}

TEST_F(CUnit, SnapshotInOtherMemory) {
  run(0, 65);
  std::vector<unsigned char> snapshot(openevc_snapshot_size());
  ASSERT_EQ(openevc_snapshot(unit, snapshot.data(), snapshot.size()), OPENEVC_OK);
  EXPECT_EQ(openevc_snapshot(unit, snapshot.data(), snapshot.size() - 1), OPENEVC_TOO_SMALL);
  run(65, 80);
  const openevc_outputs expected = *out;
  Memory other(openevc_unit_size());
  openevc_unit* woken = nullptr;
  ASSERT_EQ(openevc_restore(other.at(), other.size(), snapshot.data(), snapshot.size(), &woken, why, sizeof why),
            OPENEVC_OK)
      << why;
  unit = woken;
  *out = openevc_outputs{};
  out->size = sizeof *out;
  run(65, 80);
  EXPECT_EQ(std::memcmp(&expected, out.get(), offsetof(openevc_outputs, V_P)), 0);
  EXPECT_EQ(out->mode, OPENEVC_UN);
  snapshot[100] ^= 1;
  EXPECT_EQ(openevc_restore(other.at(), other.size(), snapshot.data(), snapshot.size(), &woken, why, sizeof why),
            OPENEVC_REFUSED);
  EXPECT_STREQ(why, "damaged");
  run(80, 81);  // the unit is unchanged
}

TEST_F(CUnit, WhatIsRefused) {
  EXPECT_EQ(power_up("{"), OPENEVC_REFUSED);
  EXPECT_EQ(unit, nullptr);
  EXPECT_EQ(power_up(R"({"cycle_ms":0})"), OPENEVC_REFUSED);
  EXPECT_NE(std::string(why).find("cycle_ms"), std::string::npos) << why;
  openevc_inputs in = at(1);
  EXPECT_EQ(step(in), OPENEVC_BAD_ARGUMENT);  // no unit
  ASSERT_EQ(power_up(R"({"cycle_ms":200,"srs":"4.0.0"})"), OPENEVC_OK) << why;
  in.direction = 2;
  EXPECT_EQ(step(in), OPENEVC_BAD_ARGUMENT);
  EXPECT_STREQ(why, "inputs.direction: not -1, 0 or 1");
  in = at(1);
  in.acknowledged_text = 256 + 64;
  EXPECT_EQ(step(in), OPENEVC_BAD_ARGUMENT);
  EXPECT_STREQ(why, "inputs.acknowledged_text: no such id");
  in = at(1);
  in.link = 4;
  EXPECT_EQ(step(in), OPENEVC_BAD_ARGUMENT);
  in = at(1);
  openevc_telegram failed{};
  in.telegrams = &failed;
  in.telegrams_count = 1;
  EXPECT_EQ(step(in), OPENEVC_OK) << why;  // no telegram (3.16.2.4)
  failed.bits = 8;
  EXPECT_EQ(step(in), OPENEVC_BAD_ARGUMENT);
  EXPECT_STREQ(why, "inputs.telegrams: without bytes");
  in = at(20);
  in.level = 5;
  EXPECT_EQ(step(in), OPENEVC_BAD_ARGUMENT);
  const auto contact = [&](std::uint16_t NID_C, std::uint16_t NID_RBC, std::uint64_t NID_RADIO) {
    in = at(1);
    in.entered = 1u << OPENEVC_ENTRY_RBC_CONTACT;
    in.NID_C = NID_C;
    in.NID_RBC = NID_RBC;
    in.NID_RADIO = NID_RADIO;
    EXPECT_EQ(step(in), OPENEVC_BAD_ARGUMENT);
    return std::string(why);
  };
  EXPECT_EQ(contact(1024, 1, 0), "inputs.NID_C: above 1023");
  EXPECT_EQ(contact(1, 16384, 0), "inputs.NID_RBC: above 16383");
  EXPECT_EQ(contact(1, 1, 0x12ABu), "inputs.NID_RADIO: a digit from A to E (7.5.1.95)");
  in = at(40);
  in.train_data_length -= 1;
  EXPECT_EQ(step(in), OPENEVC_REFUSED);
  EXPECT_EQ(std::string(why).rfind("inputs.train_data: ", 0), 0u) << why;
  out->size = 0;
  EXPECT_EQ(step(at(1)), OPENEVC_BAD_ARGUMENT);
  EXPECT_EQ(openevc_step(unit, nullptr, out.get(), why, sizeof why), OPENEVC_BAD_ARGUMENT);
  EXPECT_EQ(openevc_inputs_init(nullptr, sizeof in), OPENEVC_BAD_ARGUMENT);
}

/// 5 m/s for half a second (3.6.4); a reading of more than a second ago is none (4.4.5).
TEST_F(CUnit, OdometerWithItsOwnTime) {
  run(0, 80);
  openevc_inputs in = at(80);
  in.nominal = in.min = in.max = 10.0;
  in.V_est = in.V_min = in.V_max = 5.0;
  in.measured = in.now - 0.5;
  ASSERT_EQ(step(in), OPENEVC_OK) << why;
  EXPECT_NEAR(out->est_front, 12.5, 1e-9);
  in.now = 9.5;
  ASSERT_EQ(step(in), OPENEVC_OK) << why;
  EXPECT_EQ(out->mode, OPENEVC_SF);
}

/// 4.11.1: the level is valid again after power off where the engine was not moved.
TEST_F(CUnit, ColdMovement) {
  for (const openevc_movement moved : {OPENEVC_NOT_MOVED, OPENEVC_MOVED, OPENEVC_MOVEMENT_UNKNOWN}) {
    ASSERT_EQ(power_up(nullptr), OPENEVC_OK) << why;
    run(0, 80);
    EXPECT_EQ(out->level_valid, 1);
    for (int n = 80; n <= 85; ++n) {
      openevc_inputs in = at(n);
      in.desk_open = 0;
      in.powered = n == 85;
      if (n == 85) in.moved = moved;
      ASSERT_EQ(step(in), OPENEVC_OK) << why;
      EXPECT_EQ(out->mode, n == 85 ? OPENEVC_SB : OPENEVC_NP);
    }
    EXPECT_EQ(out->level_valid, moved == OPENEVC_NOT_MOVED ? 1 : 0) << moved;
  }
}

TEST_F(CUnit, WithoutAnAdvanceDisplayItsNumbersDoNotExist) {
  ASSERT_EQ(power_up(nullptr), OPENEVC_OK) << why;
  run(0, 10);
  openevc_planning planning{};
  planning.size = sizeof planning;
  ASSERT_EQ(openevc_plan(unit, &planning), OPENEVC_OK);
  EXPECT_EQ(planning.given, 0u);
  EXPECT_TRUE(std::isnan(planning.EOA) && std::isnan(planning.LOA) && std::isnan(planning.V_LOA));
}

/// The driver's display: the steps of the start of mission with the buttons that they leave (015560 11.7.2, 11.2).
TEST_F(CUnit, TheDisplayFollowsTheStartOfMission) {
  ASSERT_EQ(power_up(nullptr), OPENEVC_OK) << why;
  const auto shown = std::make_unique<openevc_display>();
  shown->size = sizeof *shown;
  ASSERT_EQ(openevc_show(unit, shown.get()), OPENEVC_OK);
  EXPECT_EQ(shown->mode, OPENEVC_NP) << "no step was made";
  const auto has = [&](const char* label) {
    for (std::int32_t n = 0; openevc_button_name(n) != nullptr; ++n)
      if (std::strcmp(openevc_button_name(n), label) == 0) return (shown->buttons >> n & 1u) != 0;
    ADD_FAILURE() << "no button " << label;
    return false;
  };
  const auto after = [&](int from, int to) {
    run(from, to);
    ASSERT_EQ(openevc_show(unit, shown.get()), OPENEVC_OK);
    EXPECT_EQ(shown->mode, out->mode);
    EXPECT_EQ(shown->now, out->now);
  };
  after(0, 10);
  EXPECT_STREQ(openevc_dialogue(shown->step).step, "S1");
  EXPECT_EQ(shown->start_of_mission, 1);
  EXPECT_FALSE(has("Train data"));
  after(10, 35);
  EXPECT_EQ(shown->start_of_mission, 0);
  EXPECT_TRUE(has("Train data") && has("Driver ID") && !has("Start"));
  EXPECT_STREQ(shown->driver_id_text, out->driver_id_text);
  EXPECT_EQ(shown->asks_brake_percentage, 1);
  after(35, 60);
  EXPECT_TRUE(has("Start"));
  EXPECT_EQ(shown->data.L_TRAIN, 300.0);
  after(60, 61);
  EXPECT_EQ(shown->asked_count, 1u);
  EXPECT_EQ(shown->asked[0].what, OPENEVC_ACK_UN);
  after(61, 80);
  EXPECT_EQ(shown->mode, OPENEVC_UN);
  EXPECT_EQ(shown->asked_count, 0u);
  EXPECT_EQ(shown->enabled, out->enabled);
}

/// Nothing is written behind the size that the caller has, and a size is needed.
TEST_F(CUnit, TheDisplayOfAnOlderHeaderIsShorter) {
  run(0, 3);
  std::vector<unsigned char> bytes(sizeof(openevc_display), 0x5A);
  auto* const shorter = reinterpret_cast<openevc_display*>(bytes.data());
  shorter->size = offsetof(openevc_display, now);
  ASSERT_EQ(openevc_show(unit, shorter), OPENEVC_OK);
  EXPECT_EQ(shorter->mode, out->mode);
  EXPECT_EQ(shorter->size, offsetof(openevc_display, now));
  for (std::size_t i = offsetof(openevc_display, now); i < bytes.size(); ++i) ASSERT_EQ(bytes[i], 0x5A) << i;
  shorter->size = 3;
  EXPECT_EQ(openevc_show(unit, shorter), OPENEVC_BAD_ARGUMENT);
  EXPECT_EQ(openevc_show(unit, nullptr), OPENEVC_BAD_ARGUMENT);
  EXPECT_EQ(openevc_show(nullptr, shorter), OPENEVC_BAD_ARGUMENT);
  EXPECT_EQ(openevc_button_name(-1), nullptr);
}

/// A report and a message count for the RBC that they name (3.5.3.7).
TEST_F(CUnit, RbcsAreNamed) {
  const auto message_32 = evc::language::encode(
      R"({"NID_MESSAGE":32,"T_TRAIN":100,"M_ACK":0,"NID_LRBG":16777215,"M_VERSION":33})", {evc::language::Form::radio});
  ASSERT_FALSE(message_32.error) << message_32.error->why;
  const openevc_message message{message_32.bytes.data(), message_32.bytes.size()};
  const openevc_rbc ours{1, 1, 1, 0}, other{1, 1, 2, 0};
  ASSERT_EQ(power_up(R"({"terminals":2})"), OPENEVC_OK) << why;
  run(0, 20);
  int n = 20;
  const auto phase_after = [&](auto fill) {
    openevc_inputs in = at(n == 20 ? 21 : n);
    in.now = 0.1 * n++;
    in.entered = in.selected = in.acknowledged = 0;
    fill(in);
    EXPECT_EQ(step(in), OPENEVC_OK) << why;
    return out->sessions_count == 0 ? -1 : out->sessions[0].phase;
  };
  phase_after([](openevc_inputs& in) {
    in.entered = 1u << OPENEVC_ENTRY_LEVEL;
    in.level = OPENEVC_L2;
  });
  EXPECT_EQ(phase_after([](openevc_inputs& in) {
              in.entered = 1u << OPENEVC_ENTRY_RBC_CONTACT;
              in.NID_C = in.NID_RBC = 1;
              in.NID_RADIO = ~std::uint64_t{0};
            }),
            OPENEVC_SESSION_CONNECTING);
  EXPECT_TRUE(out->connect.given == 1 && out->connect.NID_RBC == 1);
  EXPECT_EQ(out->sessions_role[0], OPENEVC_SUPERVISING);
  const auto connected = [](const openevc_rbc& rbc) {
    return [rbc](openevc_inputs& in) {
      in.link = OPENEVC_LINK_CONNECTED;
      in.link_with = rbc;
    };
  };
  EXPECT_EQ(phase_after(connected(other)), OPENEVC_SESSION_CONNECTING);
  EXPECT_EQ(phase_after(connected(ours)), OPENEVC_SESSION_WAITING_VERSION);
  ASSERT_EQ(out->radio_out_count, 1u);
  EXPECT_EQ(out->radio_out[0].bytes[0], 155);
  EXPECT_TRUE(out->radio_out_to[0].given == 0 || out->radio_out_to[0].NID_RBC == 1);
  const auto heard = [&message](const openevc_rbc& rbc) {
    return [&message, &rbc](openevc_inputs& in) {
      in.radio = &message;
      in.radio_count = 1;
      in.radio_from = &rbc;
    };
  };
  EXPECT_EQ(phase_after(heard(other)), OPENEVC_SESSION_WAITING_VERSION);
  EXPECT_EQ(phase_after(heard(ours)), OPENEVC_SESSION_UP);
}

/// A program with an older header: members it does not have keep their defaults, and nothing is written beyond its
/// outputs.
TEST_F(CUnit, ShorterStructs) {
  run(0, 1);
  openevc_inputs in = at(1);
  in.size = offsetof(openevc_inputs, powered);
  in.powered = 0;  // not part of it
  out->size = offsetof(openevc_outputs, V_P);
  out->V_P = 12345.0;
  ASSERT_EQ(step(in), OPENEVC_OK) << why;
  EXPECT_EQ(out->mode, OPENEVC_SB);
  EXPECT_EQ(out->V_P, 12345.0);
  EXPECT_EQ(out->size, offsetof(openevc_outputs, V_P));
}

}  // namespace
