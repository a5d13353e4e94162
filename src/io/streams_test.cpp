#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <limits>

#include "io/file.h"
#include "io/input_stream.h"
#include "io/input_writer.h"
#include "io/number.h"
#include "io/output_lines.h"

namespace evc::io {
namespace {

std::string number(double v) {
  std::string s;
  append_number(s, v);
  return s;
}

TEST(Number, ReadsBackToTheSameDouble) {
  for (const double v : {0.1, 1.0 / 3.0, 1e300, -2.5e-7, 123456789.125, 5e-324, 38.888888888888886}) {
    EXPECT_EQ(Json::parse(number(v)).get<double>(), v);
  }
  EXPECT_EQ(number(0.0), "0");
  EXPECT_EQ(number(-0.0), "-0.0");
  EXPECT_TRUE(std::signbit(Json::parse(number(-0.0)).get<double>()));
  EXPECT_EQ(number(std::numeric_limits<double>::quiet_NaN()), "null");
  std::string micro;
  append_micro(micro, 140.0 / 3.6 * 3.6);
  EXPECT_EQ(micro, "140");
}

TEST(Number, StringsAreEscaped) {
  std::string s;
  append_string(s, "a\"b\\c\n\x01");
  EXPECT_EQ(s, R"("a\"b\\c\u000a\u0001")");
}

InputStream open(std::string text) {
  auto stream = InputStream::open("in.jsonl", lines_of(std::move(text)));
  if (!stream) throw std::runtime_error(stream.error().text());
  return *std::move(stream);
}

std::string error_in(std::string text) {
  auto stream = InputStream::open("in.jsonl", lines_of(std::move(text)));
  if (!stream) return stream.error().text();
  sim::CycleInputs cycle;
  for (;;) {
    const auto more = stream->next(cycle);
    if (!more) return more.error().text();
    if (!*more) return "";
  }
}

TEST(InputStream, ACycleConsumesEveryInputUpToItsTime) {
  auto stream = open(R"({"config":{"cycle_ms":200,"srs":"4.0.0","levels":["NTC","2"]}}
{"t_ms":0,"train":{"desk_open":true}}
{"t_ms":150,"odometer":{"nominal_m":1,"min_m":0.5,"max_m":2,"speed_mps":3}}

{"t_ms":200,"balise":{"telegram":"9002","at_m":0.5}}
{"t_ms":200,"radio":{"message":"180014"}}
{"t_ms":201,"radio":{"session":"lost"}}
{"t_ms":700,"driver":{"ack":["OS","level"],"select":"override","enter":{"driver_id":"12","level":"2"}}}
)");
  EXPECT_EQ(stream.configuration().cycle_ms, 200);
  EXPECT_EQ(stream.configuration().srs, SrsVersion::v4_0_0);
  EXPECT_EQ(stream.configuration().levels, (std::array<bool, 5>{false, true, false, true, false}));
  sim::CycleInputs cycle;
  ASSERT_TRUE(*stream.next(cycle));
  EXPECT_EQ(cycle.t_ms, 0);
  EXPECT_TRUE(cycle.levels.train.desk_open);
  ASSERT_TRUE(*stream.next(cycle));
  EXPECT_EQ(cycle.t_ms, 200);
  EXPECT_EQ(cycle.levels.odometry.V_max.si, 3.0);
  const auto& inputs = cycle.view();
  EXPECT_TRUE(inputs.train.desk_open);
  ASSERT_EQ(inputs.balise_telegrams.size(), 1u);
  EXPECT_EQ(inputs.balise_telegrams[0].bits, 16u);
  EXPECT_EQ(inputs.radio_messages[0].bytes[0], 0x18);
  ASSERT_TRUE(*stream.next(cycle));
  EXPECT_EQ(cycle.levels.radio_link, RadioLink::lost);
  EXPECT_TRUE(cycle.view().balise_telegrams.empty());
  ASSERT_TRUE(*stream.next(cycle));
  EXPECT_EQ(cycle.t_ms, 600);
  EXPECT_EQ(cycle.levels.radio_link, RadioLink::unchanged);
  ASSERT_TRUE(*stream.next(cycle));
  EXPECT_TRUE(cycle.levels.driver.has(Ack::OS));
  EXPECT_TRUE(cycle.levels.driver.has(Ack::level));
  EXPECT_TRUE(cycle.levels.driver.has(kernel::Select::override_));
  EXPECT_EQ(cycle.levels.driver.driver_id, DriverId("12"));
  EXPECT_FALSE(*stream.next(cycle));
}

/// `lost` and `connected` again in one cycle: both are delivered in order, before the inputs that follow them.
TEST(InputStream, TwoReportsOfTheBearerInOneCycle) {
  auto stream = open(R"({"t_ms":110,"radio":{"message":"180014"}}
{"t_ms":120,"radio":{"session":"lost"}}
{"t_ms":130,"radio":{"message":"190014"}}
{"t_ms":180,"radio":{"session":"connected"}}
{"t_ms":190,"radio":{"message":"200014"}}
{"t_ms":195,"radio":{"session":"lost"}}
{"t_ms":200,"train":{"desk_open":true}}
)");
  const auto first_bytes = [](const sim::CycleInputs& cycle) {
    std::vector<int> bytes;
    for (const auto& message : cycle.radio) bytes.push_back(message.bytes[0]);
    return bytes;
  };
  sim::CycleInputs cycle;
  ASSERT_TRUE(*stream.next(cycle));
  ASSERT_TRUE(*stream.next(cycle));
  EXPECT_EQ(cycle.t_ms, 100);
  EXPECT_EQ(cycle.levels.radio_link, RadioLink::unchanged);
  ASSERT_TRUE(*stream.next(cycle));
  EXPECT_EQ(cycle.t_ms, 200);
  EXPECT_EQ(cycle.levels.radio_link, RadioLink::lost);
  EXPECT_EQ(first_bytes(cycle), (std::vector<int>{0x18, 0x19}));
  EXPECT_TRUE(cycle.levels.train.desk_open) << "only the radio waits";
  ASSERT_TRUE(*stream.next(cycle));
  EXPECT_EQ(cycle.levels.radio_link, RadioLink::connected);
  EXPECT_EQ(first_bytes(cycle), (std::vector<int>{0x20}));
  ASSERT_TRUE(*stream.next(cycle));
  EXPECT_EQ(cycle.t_ms, 400);
  EXPECT_EQ(cycle.levels.radio_link, RadioLink::lost);
  EXPECT_FALSE(*stream.next(cycle));
}

TEST(InputStream, ErrorsNameTheLine) {
  EXPECT_EQ(error_in("{\"t_ms\":0}\n{\"t_ms\":0,\"radoi\":{}}\n").substr(0, 44),
            "in.jsonl: line 2 /radoi: found an unknown ke");
  EXPECT_EQ(error_in("{\"t_ms\":100}\n{\"t_ms\":50}\n"),
            "in.jsonl: line 2 /t_ms: found 50, expected a time not before 100");
  EXPECT_EQ(error_in("{\"t_ms\":0}\n{\"t_ms\":1\n").substr(0, 26), "in.jsonl: line 2 column 10");
  EXPECT_NE(error_in("{\"t_ms\":0}\n{\"t_ms\":0,\"config\":{}}\n").find("line 2 /config"), std::string::npos);
  EXPECT_NE(
      error_in("{\"t_ms\":0,\"odometer\":{\"nominal_m\":1,\"min_m\":2,\"max_m\":3,\"speed_mps\":0}}").find("min_m"),
      std::string::npos);
  EXPECT_NE(error_in("{\"odometer\":{}}"), "");
  EXPECT_EQ(error_in(R"({"t_ms":0,"driver":{"enter":{"rbc":{"NID_C":1,"NID_RBC":1,"NID_RADIO":"12ABFFFFFFFFFFFF"}}}})"),
            "in.jsonl: line 1 /driver/enter/rbc/NID_RADIO: found \"12ABFFFFFFFFFFFF\", expected 16 digits: decimal "
            "ones, filled up with F");
  EXPECT_NE(error_in(R"({"config":{"telephone_numbers":["C041790000000001"]}})").find("/telephone_numbers/0: found"),
            std::string::npos);
  EXPECT_NE(error_in("{\"t_ms\":0,\"radio\":{\"message\":\"123\"}}").find("even"), std::string::npos);
  EXPECT_NE(error_in("{\"t_ms\":9000000000}"), "");
  for (const char* wrong : {"false", "7", "null"}) {
    const std::string value = std::string(":") + wrong + "}";
    EXPECT_EQ(error_in("{\"t_ms\":0,\"end\"" + value),
              std::string("in.jsonl: line 1 /end: found ") + wrong + ", expected true");
    EXPECT_EQ(error_in("{\"t_ms\":0,\"power\":{\"off\"" + value + "}"),
              std::string("in.jsonl: line 1 /power/off: found ") + wrong + ", expected true");
  }
}

TEST(InputStream, PowerAndColdMovement) {
  auto stream = open(R"({"t_ms":0,"power":{"off":true}}
{"t_ms":100,"power":{"on":true,"moved":false}}
{"t_ms":200,"power":{"on":true,"moved":null}}
{"t_ms":300,"power":{"on":true,"moved":true}}
{"t_ms":400,"train":{"powered":true}}
)");
  sim::CycleInputs cycle;
  ASSERT_TRUE(*stream.next(cycle));
  EXPECT_FALSE(cycle.view().train.powered);
  for (const std::optional<bool> moved :
       {std::optional(false), std::optional<bool>{}, std::optional(true), std::optional<bool>{}}) {
    ASSERT_TRUE(*stream.next(cycle));
    EXPECT_TRUE(cycle.view().train.powered);
    EXPECT_EQ(cycle.view().moved, moved);
  }
}

TEST(InputStream, AnAcknowledgementMayNameTheText) {
  auto stream = open(R"({"t_ms":0,"driver":{"ack":{"id":3}}}
{"t_ms":100,"driver":{"ack":["OS",{"id":255}]}}
{"t_ms":200,"driver":{"ack":"text"}}
)");
  sim::CycleInputs cycle;
  for (const int id : {3, 255, 0}) {
    ASSERT_TRUE(*stream.next(cycle));
    EXPECT_TRUE(cycle.view().driver.has(Ack::text));
    EXPECT_EQ(cycle.view().driver.has(Ack::OS), id == 255);
    EXPECT_EQ(cycle.view().driver.acknowledged_text, id);
  }
  EXPECT_EQ(error_in(R"({"t_ms":0,"driver":{"ack":{"id":0}}})"),
            "in.jsonl: line 1 /driver/ack/id: found 0, expected an integer from 1 to " +
                std::to_string(kernel::kLastStatusId));
  EXPECT_EQ(error_in(R"({"t_ms":0,"driver":{"ack":[{"id":1},{"id":2}]}})"),
            "in.jsonl: line 1 /driver/ack/1: found an object, expected one text in a cycle");
}

TEST(InputStream, WithoutADetectorNobodyKnowsWhetherTheEngineWasMoved) {
  auto stream = open(R"({"t_ms":0,"config":{"cold_movement_detection":false},"power":{"off":true}}
{"t_ms":100,"power":{"on":true,"moved":false}}
)");
  sim::CycleInputs cycle;
  ASSERT_TRUE(*stream.next(cycle));
  ASSERT_TRUE(*stream.next(cycle));
  EXPECT_TRUE(cycle.view().train.powered);
  EXPECT_FALSE(cycle.view().moved);
}

/// Lines one by one; `read` counts those that were asked for.
InputStream::NextLine counted(std::vector<std::string> lines, int& read) {
  return [lines = std::move(lines), &read](std::string& line) {
    if (static_cast<std::size_t>(read) == lines.size()) return false;
    line = lines[static_cast<std::size_t>(read++)];
    return true;
  };
}

TEST(InputStream, EndGivesACycleBeforeTheNextLineIsThere) {
  int read = 0;
  auto stream =
      InputStream::open("in.jsonl", counted({R"({"t_ms":0})", R"({"t_ms":100,"end":true,"train":{"sleeping":true}})",
                                             R"({"t_ms":250,"end":true})", R"({"t_ms":250})"},
                                            read));
  ASSERT_TRUE(stream);
  sim::CycleInputs cycle;
  for (const int lines : {2, 2, 3}) {
    ASSERT_TRUE(*stream->next(cycle));
    EXPECT_EQ(read, lines) << cycle.t_ms;
  }
  EXPECT_EQ(cycle.t_ms, 200);
  EXPECT_TRUE(cycle.view().train.sleeping);
  const auto late = stream->next(cycle);
  ASSERT_FALSE(late);
  EXPECT_EQ(late.error().text(), "in.jsonl: line 4 /t_ms: found 250, expected a time after 250, which was ended");
}

TEST(InputStream, EndIsNoInputOfALaterCycle) {
  auto stream = open(R"({"t_ms":0}
{"t_ms":250,"end":true}
)");
  sim::CycleInputs cycle;
  for (const std::int64_t t_ms : {0, 100, 200}) {
    ASSERT_TRUE(*stream.next(cycle));
    EXPECT_EQ(cycle.t_ms, t_ms);
  }
  EXPECT_FALSE(*stream.next(cycle));
  EXPECT_EQ(error_in(R"({"t_ms":0,"end":false})"), "in.jsonl: line 1 /end: found false, expected true");
}

/// Lines that have arrived at a time each, until `now`.
struct Arriving {
  std::vector<std::pair<std::int64_t, std::string>> lines;
  std::int64_t now = 0;
  std::size_t read = 0;

  Result<InputStream> open(std::optional<std::int64_t> cycle_ms = {}) {
    return InputStream::open_by_clock("in.jsonl",
                                      [this](std::string& line) {
                                        if (read == lines.size() || lines[read].first > now) return false;
                                        line = lines[read++].second;
                                        return true;
                                      },
                                      {[this] { return lines[read - 1].first; }, cycle_ms});
  }
};

TEST(InputStream, ByTheClockEveryCallGivesACycleWithWhatHasArrived) {
  Arriving arriving{{{0, R"({"config":{"cycle_ms":200}})"},
                     {150, R"({"odometer":{"nominal_m":1,"min_m":1,"max_m":1,"speed_mps":0}})"},
                     {150, R"({"t_ms":99,"end":true,"train":{"sleeping":true}})"},
                     {450, R"({"t_ms":0,"train":{"sleeping":false}})"},
                     {450, R"({"config":{}})"}}};
  auto stream = arriving.open();
  ASSERT_TRUE(stream);
  sim::CycleInputs cycle;
  ASSERT_TRUE(*stream->next(cycle));
  EXPECT_EQ(cycle.t_ms, 0);
  arriving.now = 205;
  ASSERT_TRUE(*stream->next(cycle));
  EXPECT_EQ(cycle.t_ms, 200);
  EXPECT_TRUE(cycle.view().train.sleeping);
  EXPECT_EQ(cycle.view().odometry.nominal, OdometerPlace{{1.0}});
  ASSERT_TRUE(cycle.view().odometry.measured);
  EXPECT_EQ(*cycle.view().odometry.measured, Duration{0.15});
  arriving.now = 460;  // late: what came after the time of the cycle is of the next one
  ASSERT_TRUE(*stream->next(cycle));
  EXPECT_EQ(cycle.t_ms, 400);
  EXPECT_TRUE(cycle.view().train.sleeping);
  const auto second = stream->next(cycle);
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().text(), "in.jsonl: line 5 /config: found an object, expected config on the first line only");
  EXPECT_FALSE(cycle.view().train.sleeping);

  Arriving shorter{{{0, R"({"config":{"cycle_ms":200}})"}}};
  auto given = shorter.open(20);
  ASSERT_TRUE(*given->next(cycle));
  ASSERT_TRUE(*given->next(cycle));
  EXPECT_EQ(cycle.t_ms, 20);
}

TEST(InputStream, TimesOfMeasurement) {
  auto stream = open(R"({"t_ms":50,"odometer":{"nominal_m":1,"min_m":0.5,"max_m":2,"speed_mps":3}}
{"t_ms":150,"odometer":{"nominal_m":1,"min_m":0.5,"max_m":2,"speed_mps":3,"at_ms":120.5},"balise":{"telegram":"9002","at_ms":110}}
{"t_ms":250,"odometer":{"nominal_m":1,"min_m":0.5,"max_m":2,"speed_mps":3,"at_ms":251}}
)");
  sim::CycleInputs cycle;
  ASSERT_TRUE(*stream.next(cycle));
  ASSERT_TRUE(*stream.next(cycle));
  EXPECT_EQ(cycle.view().odometry.measured, Duration{0.05});
  ASSERT_TRUE(*stream.next(cycle));
  EXPECT_EQ(cycle.view().odometry.measured, Duration{0.1205});
  ASSERT_EQ(cycle.view().balise_telegrams.size(), 1u);
  EXPECT_EQ(cycle.view().balise_telegrams[0].passed, Duration{0.11});
  const auto later = stream.next(cycle);
  ASSERT_FALSE(later);
  EXPECT_NE(later.error().text().find("/odometer/at_ms: found 251, expected a time not after t_ms, 250"),
            std::string::npos)
      << later.error().text();
}

TEST(InputStream, TrainIntegrityIsKeptUntilChanged) {
  auto stream =
      open(R"({"config":{"engine_length_m":17.5},"t_ms":0,"train":{"integrity":"confirmed","train_length_m":200}}
{"t_ms":100,"train":{"desk_open":true}}
{"t_ms":200,"train":{"integrity":"confirmed"}}
)");
  EXPECT_EQ(stream.configuration().for_kernel().L_engine, 17.5_m);
  sim::CycleInputs cycle;
  for (const bool length : {true, true, false}) {
    ASSERT_TRUE(*stream.next(cycle));
    EXPECT_EQ(cycle.view().train.integrity, TrainIntegrity::confirmed);
    EXPECT_EQ(cycle.view().train.length_confirmed, length ? std::optional(200_m) : std::nullopt);
  }
}

TEST(InputStream, TrainDataOpenedAgainAreTheButtonOfTheFirstTime) {
  auto stream = open(R"({"t_ms":0,"driver":{"select":"new_train_data"}}
{"t_ms":100,"driver":{"select":["start","new_train_data"]}}
)");
  sim::CycleInputs cycle;
  ASSERT_TRUE(*stream.next(cycle));
  EXPECT_TRUE(cycle.levels.driver.has(kernel::Select::train_data));
  ASSERT_TRUE(*stream.next(cycle));
  EXPECT_TRUE(cycle.levels.driver.has(kernel::Select::train_data));
  EXPECT_TRUE(cycle.levels.driver.has(kernel::Select::start));
}

TEST(InputStream, SignalsThatNothingUsesAreAccepted) {
  auto stream = open(
      R"({"t_ms":0,"train":{"safe_consist_length":{"front_m":[0,0,0],"rear_m":[100,99,101]},"main_switch":"closed"}}
{"t_ms":100,"train":{"safe_consist_length":null,"traction_system":"AC 15 kV 16.7 Hz","desk_open":true}}
)");
  sim::CycleInputs cycle;
  ASSERT_TRUE(*stream.next(cycle));
  ASSERT_TRUE(*stream.next(cycle));
  EXPECT_TRUE(cycle.view().train.desk_open);
}

TEST(InputStream, TrainDataOfAnotherSourceAreForOneCycle) {
  auto stream = open(R"({"t_ms":0,"train":{"data":{"length_m":300}}}
{"t_ms":100,"train":{"antenna_alarm":true}}
{"t_ms":200,"train":{"data":{"length_m":310},"data_validation":false}}
)");
  sim::CycleInputs cycle;
  ASSERT_TRUE(*stream.next(cycle));
  ASSERT_NE(cycle.view().external_train_data.data, nullptr);
  EXPECT_EQ(cycle.view().external_train_data.data->L_TRAIN, 300_m);
  EXPECT_TRUE(cycle.view().external_train_data.driver_validates);
  EXPECT_FALSE(cycle.view().train.antenna_alarm);
  ASSERT_TRUE(*stream.next(cycle));
  EXPECT_EQ(cycle.view().external_train_data.data, nullptr);
  EXPECT_TRUE(cycle.view().train.antenna_alarm);
  ASSERT_TRUE(*stream.next(cycle));
  EXPECT_EQ(cycle.view().external_train_data.data->L_TRAIN, 310_m);
  EXPECT_FALSE(cycle.view().external_train_data.driver_validates);
  EXPECT_TRUE(cycle.view().train.antenna_alarm);
}

TEST(InputStream, WindowsAndBrakesOfTheNationalSystemLastUntilChanged) {
  auto stream = open(R"({"t_ms":0,"driver":{"window":{"opened":"train_data"}},"national_system":{"service_brake":true}}
{"t_ms":100,"driver":{"window":{"opened":"sr_data"}},"national_system":{"emergency_brake":true}}
{"t_ms":200,"driver":{"window":{"closed":"train_data"}},"national_system":{"service_brake":false}}
{"t_ms":300,"driver":{"window":{"closed":"sr_data","opened":"train_data"}}}
)");
  using Windows = Set<kernel::Window>;
  const Windows windows[] = {{kernel::Window::train_data},
                             {kernel::Window::train_data, kernel::Window::SR_data},
                             {kernel::Window::SR_data},
                             {kernel::Window::train_data}};
  const bool service[] = {true, true, false, false};
  const bool emergency[] = {false, true, true, true};
  sim::CycleInputs cycle;
  for (std::size_t i = 0; i < 4; ++i) {
    ASSERT_TRUE(*stream.next(cycle));
    EXPECT_EQ(cycle.view().windows, windows[i]) << i;
    EXPECT_EQ(cycle.view().national_system.service_brake, service[i]) << i;
    EXPECT_EQ(cycle.view().national_system.emergency_brake, emergency[i]) << i;
  }
}

TEST(InputStream, ErrorsInWindowsSignalsAndNationalSystem) {
  const auto error = [](const char* inputs) {
    const std::string text = error_in(std::string("{\"t_ms\":0,") + inputs + "}");
    const std::string place = "in.jsonl: line 1 ";
    return text.starts_with(place) ? text.substr(place.size()) : text;
  };
  EXPECT_EQ(error(R"("driver":{"window":{"opened":"level"}})"),
            "/driver/window/opened: found \"level\", expected one of \"train_data\", \"sr_data\"");
  EXPECT_EQ(error(R"("driver":{"window":{"closed":1}})"),
            "/driver/window/closed: found 1, expected one of \"train_data\", \"sr_data\"");
  EXPECT_EQ(error(R"("driver":{"window":"train_data"})"), "/driver/window: found \"train_data\", expected an object");
  EXPECT_EQ(error(R"("driver":{"window":{"open":"train_data"}})"),
            "/driver/window/open: found an unknown key, expected one of opened, closed");
  EXPECT_EQ(error(R"("train":{"antenna_alarm":1})"), "/train/antenna_alarm: found 1, expected true or false");
  EXPECT_EQ(error(R"("power":{"off":false})"), "/power/off: found false, expected true");
  EXPECT_EQ(error(R"("power":{"off":true,"moved":true})"),
            "/power/moved: found true, expected on, which it belongs to");
  EXPECT_EQ(error(R"("balise":{"telegram":"9002","at_m":1,"at_ms":0})"),
            "/balise/at_m: found 1, expected either at_m or at_ms");
  EXPECT_EQ(error(R"("balise_failed":{})"), "/balise_failed: found no key \"at_m\", expected one");
  EXPECT_EQ(error(R"("balise_failed":{"telegram":"9002","at_m":1})"),
            "/balise_failed/telegram: found an unknown key, expected one of at_m, at_ms");
  EXPECT_EQ(error(R"("train":{"integrity":"yes"})"),
            "/train/integrity: found \"yes\", expected one of \"unknown\", \"confirmed\", \"lost\"");
  EXPECT_EQ(error(R"("train":{"train_length_m":100})"),
            "/train/train_length_m: found 100, expected integrity, which it belongs to");
  EXPECT_EQ(error(R"("train":{"safe_consist_length":{"front_m":[0,0,0],"rear_m":[100,101,102]}})"),
            "/train/safe_consist_length/rear_m: found an array of 3, expected min <= nominal <= max");
  EXPECT_EQ(error(R"("train":{"safe_consist_length":{"front_m":[0]}})"),
            "/train/safe_consist_length/front_m: found an array of 1, expected [nominal, min, max]");
  EXPECT_EQ(error(R"("train":{"data":true})"), "/train/data: found true, expected an object");
  EXPECT_EQ(error(R"("train":{"data":{"length_m":0.5}})"),
            "/train/data/length_m: found 0.5, expected 1 to 4095 m (SUBSET-026 A.3.11)");
  EXPECT_EQ(error(R"("train":{"data":{},"data_validation":"driver"})"),
            "/train/data_validation: found \"driver\", expected true or false");
  EXPECT_EQ(error(R"("train":{"data_validation":true})"),
            "/train/data_validation: found true, expected data, which it belongs to");
  EXPECT_EQ(error(R"("train":{"cab":"C"})"), "/train/cab: found \"C\", expected one of \"A\", \"B\"");
  EXPECT_EQ(error(R"("national_system":{"service_brake":1})"),
            "/national_system/service_brake: found 1, expected true or false");
  EXPECT_EQ(error(R"("national_system":{"emergency_brake":null})"),
            "/national_system/emergency_brake: found null, expected true or false");
}

TEST(InputStream, TheLaterOfDeskAndCabHolds) {
  auto stream = open(R"({"t_ms":0,"train":{"cab":"B"}}
{"t_ms":100,"train":{"cab":null}}
{"t_ms":200,"train":{"desk_open":true}}
{"t_ms":300,"train":{"cab":"B"}}
{"t_ms":400,"train":{"desk_open":false}}
)");
  sim::CycleInputs cycle;
  for (const auto& [desk_open, cab] : {std::pair{true, kernel::Cab::B},
                                       {false, kernel::Cab::B},
                                       {true, kernel::Cab::A},
                                       {true, kernel::Cab::B},
                                       {false, kernel::Cab::B}}) {
    ASSERT_TRUE(stream.next(cycle).value());
    EXPECT_EQ(cycle.levels.train.desk_open, desk_open) << cycle.t_ms;
    EXPECT_EQ(cycle.levels.train.cab, cab) << cycle.t_ms;
  }
}

TEST(InputStream, AnEngineWithOneCabHasNoCabB) {
  auto stream = open(R"({"config":{"cabs":1},"t_ms":0,"train":{"cab":"A"}}
{"t_ms":100,"train":{"cab":"B"}}
)");
  sim::CycleInputs cycle;
  ASSERT_TRUE(stream.next(cycle).value());
  const auto refused = stream.next(cycle);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().text().find("/train/cab: found \"B\", expected A: the engine has one cab"),
            std::string::npos);
}

/// Train data that the driver entered otherwise than they were given are written with the whole train, and read back.
TEST(InputWriter, ChangedTrainDataAreWritten) {
  Configuration configuration;
  configuration.train =
      read_train(R"({"schema":"etcs-train/1","length_m":123,"category":{"axles":8}})", "train").value();
  configuration.document = configuration_document(configuration);
  InputWriter writer(configuration);
  sim::CycleInputs cycle;
  train::TrainData entered = configuration.train.data;
  entered.L_TRAIN = 321.0_m;
  entered.V_MAXTRAIN = Speed{115.0 / 3.6};
  entered.brake_percentage = 98;
  entered.brake_position = train::BrakePosition::FreightG;
  entered.other_categories = train::kFreightG | train::kPassenger;
  entered.cant_deficiency_mm = 80;
  entered.axle_load = train::AxleLoad::D4XL;
  entered.loading_gauge = train::LoadingGauge::GC;
  entered.airtight = true;
  cycle.train_data = entered;
  std::string text;
  writer.append(text, cycle);
  auto stream = open(text);
  sim::CycleInputs read;
  ASSERT_TRUE(stream.next(read).value()) << text;
  ASSERT_TRUE(read.train_data) << text;
  EXPECT_EQ(*read.train_data, entered) << text;
}

/// Everything that a cycle of a simulated world can contain is written and read back unchanged.
TEST(InputWriter, RoundTrip) {
  Configuration configuration;
  configuration.train.document = R"({"schema":"etcs-train/1","length_m":123})";
  configuration.document = configuration_document(configuration);
  InputWriter writer(configuration);
  sim::CycleInputs first;
  first.levels.train.desk_open = true;
  first.levels.train.cab = kernel::Cab::B;
  first.levels.train.direction_controller = kernel::DirectionController::backward;
  first.levels.train.brake_pressure_kpa = 480.5;
  first.levels.national_system.available = 2;
  first.levels.national_system.service_brake = first.levels.national_system.emergency_brake = true;
  first.levels.train.antenna_alarm = true;
  first.levels.train.integrity = TrainIntegrity::confirmed;
  first.levels.train.length_confirmed = 123.5_m;
  first.levels.windows = {kernel::Window::SR_data};
  first.levels.radio_link = RadioLink::connected;
  auto& d = first.levels.driver;
  d.selected = 5;
  d.acknowledged = 0x801;
  d.driver_id = DriverId("Driver4711");
  d.level = Level::NTC;
  d.nid_ntc = 1;
  d.train_running_number = 0x12345678;
  d.rbc_contact = {426, 7, 0x0031840880150FFFu};
  d.D_sr = 500_m;
  d.set_speed = 18_km_h;
  d.language = Language{{'d', 'e'}};
  first.train_data = train::TrainData{};
  first.balises.push_back({{std::vector<std::uint8_t>(104, 0xAB), 830}, {{12.345}}});
  first.balises.push_back({{{0x90, 0x02}, 13}, {{13.5}}});
  first.balises.push_back({{{0x90, 0x02}, 13}, {}, Duration{0.0}});
  first.radio.push_back({{{0x18, 0x00, 0x14}, 24}, kernel::RbcIdentity{1, 2}});
  first.loops.push_back({{0x01}, 8});
  std::string text;
  writer.append(text, first);
  sim::CycleInputs second;
  second.t_ms = 100;
  second.levels.train = first.levels.train;
  second.levels.odometry = {{{1.25}}, {{1.0}}, {{1.5}}, {2.0}, {1.9}, {2.1}, {-0.5}};
  second.levels.odometry.measured = Duration{0.09};
  second.levels.safety_fault = true;
  second.levels.moved = false;
  second.levels.windows = {kernel::Window::train_data};
  second.levels.national_system.service_brake = true;
  writer.append(text, second);

  auto stream = open(text);
  EXPECT_EQ(stream.configuration().train.data.L_TRAIN, 123_m);
  sim::CycleInputs read;
  ASSERT_TRUE(*stream.next(read));
  const auto& rd = read.levels.driver;
  EXPECT_EQ(rd.selected, d.selected);
  EXPECT_EQ(rd.acknowledged, d.acknowledged);
  EXPECT_EQ(rd.driver_id, d.driver_id);
  EXPECT_EQ(rd.level, d.level);
  EXPECT_EQ(rd.nid_ntc, d.nid_ntc);
  EXPECT_EQ(rd.train_running_number, d.train_running_number);
  EXPECT_EQ(rd.rbc_contact->NID_RADIO, d.rbc_contact->NID_RADIO);
  EXPECT_EQ(rd.D_sr, d.D_sr);
  EXPECT_EQ(rd.set_speed, d.set_speed);
  EXPECT_EQ(rd.language, d.language);
  EXPECT_EQ(read.train_data->L_TRAIN, 123_m);
  EXPECT_EQ(read.levels.radio_link, RadioLink::connected);
  EXPECT_EQ(read.levels.train.brake_pressure_kpa, 480.5);
  EXPECT_EQ(read.levels.train.direction_controller, kernel::DirectionController::backward);
  EXPECT_EQ(read.levels.national_system, first.levels.national_system);
  EXPECT_TRUE(read.levels.train.antenna_alarm);
  EXPECT_EQ(read.levels.train.integrity, TrainIntegrity::confirmed);
  EXPECT_EQ(read.levels.train.length_confirmed, 123.5_m);
  EXPECT_EQ(read.levels.windows, first.levels.windows);
  ASSERT_EQ(read.balises.size(), 3u);
  EXPECT_FALSE(read.balises[1].passed);
  EXPECT_EQ(read.balises[2].passed, Duration{0.0});
  EXPECT_EQ(read.balises[0].bits.size, 830u);
  EXPECT_EQ(read.balises[0].bits.bytes, first.balises[0].bits.bytes);
  EXPECT_EQ(read.balises[1].bits.size, 13u);
  EXPECT_EQ(read.balises[1].at, first.balises[1].at);
  EXPECT_EQ(read.radio[0].bytes, first.radio[0].bytes);
  EXPECT_EQ(read.radio[0].from, first.radio[0].from);
  EXPECT_EQ(read.loops[0].bytes, first.loops[0].bytes);
  ASSERT_TRUE(*stream.next(read));
  EXPECT_EQ(read.levels.odometry.A_est.si, -0.5);
  EXPECT_EQ(read.levels.odometry.measured, Duration{0.09});
  EXPECT_EQ(read.levels.moved, false);
  EXPECT_EQ(read.levels.odometry.min.from_origin.si, 1.0);
  EXPECT_TRUE(read.levels.safety_fault);
  EXPECT_FALSE(*stream.next(read));
}

kernel::Outputs some_outputs() {
  kernel::Outputs o;
  o.mode = Mode::FS;
  o.level = Level::L2;
  o.lrbg = kernel::NidLrbg{426, 352};
  o.est_front = {{1200.5}};
  o.v = 139.7_km_h;
  o.monitoring = Monitoring::TSM;
  o.status = Status::Indication;
  o.V_P = 140_km_h;
  o.V_target = 0_km_h;
  o.d_target = 812.4_m;
  o.sb = true;
  o.brake_reasons.add(Cause::overspeed_service);
  o.requests.add(Ack::OS);
  (void)o.symbols.push_back(Symbol::MO07);
  kernel::OutgoingMessage m;
  (void)m.bytes.push_back(0x9B);
  (void)o.radio_out.push_back(m);
  o.radio_connect = kernel::RbcAddress{426, 1, 0x0031840880150FFFu};
  (void)o.events.push_back(kernel::Event::mode_changed(Mode::SR, Mode::FS, 31));
  (void)o.events.push_back({.what = What::linking_ok, .id = 353});
  (void)o.events.push_back({.what = What::packet_refused, .id = 65, .clause = "4.8.3"_srs});
  return o;
}

TEST(InputStream, RefusesWhatIsNoDriverIdOrLanguage) {
  const auto reads = [](const std::string& entered) {
    auto stream = open(R"({"t_ms":0,"driver":{"enter":{)" + entered + "}}}\n");
    sim::CycleInputs cycle;
    const auto next = stream.next(cycle);
    return next.has_value() && *next;
  };
  for (const char* good : {R"("driver_id":"Abc4567890123456")", R"("driver_id":7)", R"("language":"de")"})
    EXPECT_TRUE(reads(good)) << good;
  for (const char* bad : {R"("driver_id":"")", R"("driver_id":"12345678901234567")", R"("driver_id":"a b")",
                          R"("language":"d")", R"("language":"deu")", R"("language":"DE")"})
    EXPECT_FALSE(reads(bad)) << bad;
}

TEST(InputStream, WhatTheTrainDoesByItself) {
  const auto c = read_configuration(R"({"by_train":["air tightness","change of traction system"]})", "c");
  ASSERT_TRUE(c);
  const ByTrain by_train = c->for_kernel().by_train;
  EXPECT_TRUE(by_train.traction_system);
  for (const auto& row : kTrackConditionRows)
    EXPECT_EQ(by_train.conditions[terms::index(row.value)], row.value == TrackConditionKind::air_tightness) << row.name;
  // The driver alone sounds the horn, and nobody acts at the others.
  for (const char* wrong : {"sound horn", "radio hole", "non stopping area", "tunnel stopping area", "brakes", ""}) {
    const auto refused = read_configuration(std::string(R"({"by_train":[")") + wrong + "\"]}", "c");
    ASSERT_FALSE(refused) << wrong;
    EXPECT_EQ(refused.error().where, "/by_train/0");
  }
  for (const char* name : {"air tightness", "change of traction system"}) {
    const std::string twice = std::string("\"") + name + '"';
    const auto refused =
        read_configuration("{\"by_train\":[" + twice + ",\"switch off magnetic shoe brake\"," + twice + "]}", "c");
    ASSERT_FALSE(refused) << name;
    EXPECT_EQ(refused.error().text(), "c: /by_train/2: found " + twice + ", expected each name once");
  }
}

TEST(OutputLines, NamesOfNationalSystems) {
  const auto c = read_configuration(R"({"ntc_names":{"1":"PZB","255":"ASFA"}})", "c");
  ASSERT_TRUE(c);
  kernel::Outputs o;
  o.national_system = 1;
  o.trip_reason = StatusText::national_system_brake_demand;
  (void)o.status_texts.push_back({StatusText::national_system_not_available, {}});
  const auto line = [&o, &c] {
    std::string out;
    append_output(out, 0, o, nullptr, c->ntc_names);
    return out;
  };
  EXPECT_NE(line().find("\"trip_reason\":\"PZB brake demand\""), std::string::npos);
  EXPECT_NE(line().find("\"text\":\"PZB is not available\""), std::string::npos);
  o.national_system = 2;  // without a name
  EXPECT_NE(line().find("\"trip_reason\":\"National system brake demand\""), std::string::npos);
  for (const char* wrong : {"256", "-1", "x", "", "0001"})
    EXPECT_FALSE(read_configuration(std::string(R"({"ntc_names":{")") + wrong + R"(":"PZB"}})", "c")) << wrong;
  for (const char* wrong : {"null", "[]", "[\"PZB\"]", "\"PZB\""}) {
    const auto read = read_configuration(std::string("{\"ntc_names\":") + wrong + "}", "c");
    ASSERT_FALSE(read) << wrong;
    EXPECT_EQ(read.error().where, "/ntc_names") << wrong;
    EXPECT_EQ(read.error().expected, "an object") << wrong;
  }
}

TEST(OutputLines, Json) {
  std::string line;
  append_output(line, 12300, some_outputs());
  EXPECT_EQ(
      line,
      "{\"t_ms\":12300,\"mode\":\"FS\",\"level\":\"2\",\"lrbg\":{\"NID_C\":426,\"NID_BG\":352},\"est_front_m\":1200.5,"
      "\"min_safe_front_m\":0,\"max_safe_front_m\":0,\"v_kmh\":139.7,\"monitoring\":\"TSM\",\"status\":\"Indication\","
      "\"V_P\":140,\"V_W\":null,\"V_SBI\":null,\"V_EBI\":null,\"V_MRSP\":null,\"V_target\":0,\"d_target_m\":812.4,"
      "\"V_release\":null,\"EOA_m\":null,\"SvL_m\":null,\"tco\":false,\"sb\":true,\"eb\":false,"
      "\"brake_reasons\":[\"overspeed: SBI\"],\"driver\":{\"requests\":[\"OS\"],\"texts\":[],\"symbols\":[\"MO07\"]},"
      "\"radio_out\":[\"9B\"],\"radio_connect\":{\"NID_C\":426,\"NID_RBC\":1,\"NID_RADIO\":\"0031840880150FFF\"},"
      "\"radio_disconnect\":null,\"events\":[\"mode SR->FS [31]\",\"linking BG 353 ok\",\"packet 65 refused "
      "[4.8.3]\"],\"V_I\":null,\"tti_s\":null,\"lssma_kmh\":null,\"mrdt_changed\":false,\"d_indication_m\":null,"
      "\"memo_status\":null,\"level_valid\":false,\"trip_reason\":null,\"geo_m\":null,\"rv_left_m\":null,\"version\":"
      "\"0.0\",\"radio_register\":null,\"set_speed_kmh\":null,\"language\":\"en\","
      "\"levels_allowed\":[],\"enabled\":[],\"messages\":[],\"sessions\":[],\"track_conditions\":[],"
      "\"train_orders\":{\"pantograph\":[],\"air_tightness\":[],\"regenerative_brake_inhibited\":[],"
      "\"eddy_current_service_brake_inhibited\":[],\"magnetic_shoe_brake_inhibited\":[],\"main_switch\":[],"
      "\"eddy_current_emergency_brake_inhibited\":[],\"traction_system\":null,\"allowed_current_a\":null,"
      "\"station_platform\":[],\"remote_shunting\":false,\"engine_orientation\":null,\"sound_horn\":false},"
      "\"data\":{\"driver_id\":{\"value\":null,\"status\":\"unknown\"},"
      "\"train_running_number\":{\"value\":null,\"status\":\"unknown\"},"
      "\"level\":{\"value\":null,\"status\":\"unknown\"},\"rbc\":{\"value\":null,\"status\":\"unknown\"},"
      "\"train_data\":{\"value\":null,\"status\":\"unknown\"},\"sr\":{\"value\":null,\"status\":\"unknown\"},"
      "\"vbc\":{\"value\":[],\"status\":\"valid\"},"
      "\"adhesion\":{\"value\":\"non slippery "
      "rail\",\"status\":\"valid\"},\"network\":{\"value\":null,\"status\":\"unknown\"}},\"forwarded\":[],\"clock\":"
      "null,\"dialogue\":null,\"shown\":[],\"planning\":null,\"dmi\":null}"
      "\n");
  EXPECT_TRUE(Json::accept(line));
}

/// One value in each field of the second edition.
kernel::Outputs second_edition() {
  kernel::Outputs o;
  o.V_I = 36_km_h;
  o.TTI = Duration{12.5};
  o.LSSMA = 72_km_h;
  o.MRDT_changed = true;
  o.d_indication = 250.5_m;
  o.memo_status = MemoStatus::SB;
  o.level_valid = true;
  o.trip_reason = StatusText::SH_stop_order;
  o.geo = Distance{25000.0};
  o.rv_left = 80_m;
  o.M_VERSION = 0x21;
  o.radio_register = 0x26210F;
  o.set_speed = 18_km_h;
  o.language = {{'d', 'e'}};
  o.levels_allowed = {Level::L0, Level::L2};
  o.enabled = {DriverInput::adhesion, DriverInput::ack_OS, DriverInput::isolation};
  kernel::ShownText text;
  text.id = 3;
  text.important = text.acknowledge = true;
  text.since = Duration{1.5};
  text.length = 2;
  text.characters[0] = 'O';
  text.characters[1] = 'K';
  (void)o.texts.push_back(text);
  (void)o.status_texts.push_back({StatusText::balise_read_error, Duration{2.0}});
  (void)o.sessions.push_back({426, 1, SessionPhase::waiting_version});
  (void)o.infill_sessions.push_back({426, 7, SessionPhase::up});
  (void)o.track_conditions.push_back({.symbol = Symbol::TC01,
                                      .kind = TrackConditionKind::powerless_lower_pantograph,
                                      .from = {1200_m},
                                      .to = {1500.5_m},
                                      .phase = ConditionPhase::announced});
  (void)o.ordered_areas.push_back({TrackConditionKind::powerless_lower_pantograph, 200_m, 500.5_m});
  (void)o.ordered_areas.push_back({TrackConditionKind::powerless_main_switch_off, std::nullopt, 80_m});
  o.ordered_traction = {.to_start = 40_m, .M_VOLTAGE = 4, .NID_CTRACTION = 7};
  o.ordered_current = {.to_start = Distance{-3.0}, .amperes = 600};
  (void)o.ordered_platforms.push_back({10_m, 310_m, 5, 2});
  o.remote_shunting = o.sound_horn = true;
  o.engine_orientation = EngineOrientation::opposite;
  o.data.driver_id_status = o.data.level_status = o.data.train_status = o.data.SR.status = DataStatus::valid;
  o.data.train_running_number_status = o.data.rbc_status = DataStatus::invalid;
  o.data.driver_id = DriverId("4711");
  o.data.train_running_number = 0x12FFFFFF;
  o.data.rbc = {1, 2, 0x123F};
  o.data.train = {300_m, 144_km_h, 120.0, 150, 5, train::AxleLoad::C2, train::LoadingGauge::GB, true};
  o.data.SR.V = 36_km_h;
  o.data.SR.D = 55_m;
  o.data.slippery_rail = true;
  o.data.network = 0x26210F;
  o.clock = kernel::DateTime{1795342500, 120};
  o.dialogue = kernel::ShownDialogue{Dialogue::start_S24, Ack::SR};
  o.shown = {DriverOutput::mode, DriverOutput::set_speed};
  kernel::ForwardedData data{102, 11, 12, {}};
  (void)(data.bytes.push_back(0xAB) && data.bytes.push_back(0xC0));
  (void)o.forwarded.push_back(data);
  (void)o.forwarded.push_back({5, std::nullopt, 0, {}});
  (void)o.covers.push_back({7, 9, Duration{60.0}});
  (void)o.covers.push_back({7, 10, Duration{90.0}, 5});
  return o;
}

TEST(OutputLines, SecondEdition) {
  std::string line;
  append_output(line, 0, second_edition());
  EXPECT_TRUE(Json::accept(line));
  const std::string expected =
      "\"V_I\":36,\"tti_s\":12.5,\"lssma_kmh\":72,\"mrdt_changed\":true,\"d_indication_m\":250.5,"
      "\"memo_status\":\"SB\",\"level_valid\":true,\"trip_reason\":\"SH stop order\",\"geo_m\":25000,"
      "\"rv_left_m\":80,\"version\":\"2.1\",\"radio_register\":\"26210\",\"set_speed_kmh\":18,\"language\":\"de\","
      "\"levels_allowed\":["
      "\"0\",\"2\"],"
      "\"enabled\":[\"slippery_rail\",\"adhesion_normal\",\"isolate\"],\"messages\":["
      "{\"id\":3,\"kind\":\"plain\",\"text\":\"OK\",\"class\":\"important\",\"ack\":true,\"since_ms\":1500},"
      "{\"id\":256,\"kind\":\"status\",\"text\":\"Balise read error\",\"class\":\"important\",\"ack\":false,"
      "\"since_ms\":2000}],\"sessions\":[{\"NID_C\":426,\"NID_RBC\":1,\"state\":\"version "
      "check\",\"role\":\"supervising\"},{\"NID_C\":426,\"NID_RIU\":7,\"state\":\"open\",\"role\":\"infill\"}],"
      "\"track_conditions\":[{\"symbol\":\"TC01\",\"kind\":\"powerless section, lower pantograph\",\"from_m\":1200,"
      "\"to_m\":1500.5,\"phase\":\"announced\"}],"
      "\"train_orders\":{\"pantograph\":[{\"to_start_m\":200,\"to_end_m\":500.5}],\"air_tightness\":[],"
      "\"regenerative_brake_inhibited\":[],\"eddy_current_service_brake_inhibited\":[],"
      "\"magnetic_shoe_brake_inhibited\":[],\"main_switch\":[{\"to_start_m\":null,\"to_end_m\":80}],"
      "\"eddy_current_emergency_brake_inhibited\":[],"
      "\"traction_system\":{\"to_start_m\":40,\"M_VOLTAGE\":4,\"NID_CTRACTION\":7},"
      "\"allowed_current_a\":{\"to_start_m\":-3,\"current_a\":600},"
      "\"station_platform\":[{\"to_start_m\":10,\"to_end_m\":310,\"M_PLATFORM\":5,\"Q_PLATFORM\":2}],"
      "\"remote_shunting\":true,\"engine_orientation\":\"opposite\",\"sound_horn\":true},"
      "\"data\":{\"driver_id\":{\"value\":\"4711\",\"status\":\"valid\"},"
      "\"train_running_number\":{\"value\":\"12\",\"status\":\"invalid\"},"
      "\"level\":{\"value\":\"0\",\"status\":\"valid\"},"
      "\"rbc\":{\"value\":{\"NID_C\":1,\"NID_RBC\":2,\"NID_RADIO\":\"000000000000123F\"},\"status\":\"invalid\"},"
      "\"train_data\":{\"value\":{\"length_m\":300,\"max_speed_kmh\":144,\"brake_percentage\":120,"
      "\"category\":{\"cant_deficiency_mm\":150,\"other\":[\"FreightP\",\"Passenger\"],\"axle_load\":\"C2\","
      "\"loading_gauge\":\"GB\",\"airtight\":true}},\"status\":\"valid\"},"
      "\"sr\":{\"value\":{\"V_sr_kmh\":36,\"D_sr_m\":55},\"status\":\"valid\"},"
      "\"vbc\":{\"value\":[{\"NID_C\":7,\"NID_VBCMK\":9,\"left_s\":60,\"T_VBC\":0},{\"NID_C\":7,\"NID_VBCMK\":10,"
      "\"left_s\":90,\"T_VBC\":5}],"
      "\"status\":\"valid\"},"
      "\"adhesion\":{\"value\":\"slippery rail\",\"status\":\"valid\"},"
      "\"network\":{\"value\":\"26210\",\"status\":\"valid\"}},"
      "\"forwarded\":[{\"NID_XUSER\":102,\"NID_NTC\":11,\"bits\":12,\"data\":\"ABC0\"},"
      "{\"NID_XUSER\":5,\"NID_NTC\":null,\"bits\":0,\"data\":\"\"}],\"clock\":{\"utc\":\"2026-11-22T10:15:00Z\","
      "\"local\":\"2026-11-22T12:15:00\"},\"dialogue\":{\"procedure\":\"start_of_mission\",\"step\":\"S24\","
      "\"waits_for\":\"SR_ack\"},\"shown\":[\"mode\",\"set_speed\"],\"planning\":null,\"dmi\":null}\n";
  ASSERT_GE(line.size(), expected.size());
  EXPECT_EQ(line.substr(line.size() - expected.size()), expected);
  std::string row;
  append_trace(row, 0, second_edition());
  const std::string end = ",36,12.5,72,true,250.5,SB,true,SH stop order,25000,80,2.1,26210,18,de\n";
  ASSERT_GE(row.size(), end.size());
  EXPECT_EQ(row.substr(row.size() - end.size()), end);
}

/// One element of each list of the advance display.
kernel::Planning some_planning() {
  kernel::Planning p;
  (void)p.gradients.push_back({0_m, 800.5_m, -6});
  (void)p.speeds.push_back({Distance{}, 140_km_h, {MrspSource::SSP, MrspSource::train}});
  (void)p.conditions.push_back({Symbol::PL02, TrackConditionKind::powerless_lower_pantograph, 600_m});
  (void)p.conditions.push_back({Symbol::PL28, std::nullopt, 700_m});
  p.EOA = 2000_m;
  return p;
}

TEST(OutputLines, Planning) {
  kernel::Outputs o;
  o.d_indication = 250.5_m;
  kernel::Planning p = some_planning();
  const auto of = [&] {
    std::string line;
    append_output(line, 0, o, &p);
    return line.substr(line.find("\"planning\":") + 11);
  };
  EXPECT_EQ(of(), R"({"gradient":[{"from_m":0,"to_m":800.5,"permille":-6}],)"
                  R"("mrsp":[{"at_m":0,"v_kmh":140,"from":["SSP","train"]}],)"
                  R"("orders":[{"symbol":"PL02","kind":"powerless section, lower pantograph","at_m":600},)"
                  R"({"symbol":"PL28","kind":"change of traction system","at_m":700}],)"
                  R"("indication_m":250.5,"EOA_m":2000,"LOA_m":null,"V_LOA_kmh":null},"dmi":null})"
                  "\n");
  p = {};
  p.LOA = 900_m;
  p.V_LOA = 36_km_h;
  o.d_indication.reset();
  EXPECT_EQ(
      of(),
      R"({"gradient":[],"mrsp":[],"orders":[],"indication_m":null,"EOA_m":null,"LOA_m":900,"V_LOA_kmh":36},"dmi":null})"
      "\n");
}

TEST(OutputLines, ChangesOfThePlanning) {
  const kernel::Planning before = some_planning();
  const auto changed = [&before](auto change) {
    kernel::Planning after = before;
    change(after);
    return differ_beyond_motion(&before, &after);
  };
  using P = kernel::Planning;
  EXPECT_FALSE(changed([](P& p) { p.EOA = p.speeds[0].at = p.gradients[0].to = p.conditions[0].at = 1_m; }));
  EXPECT_TRUE(changed([](P& p) { p.speeds[0].V = 36_km_h; }));
  EXPECT_TRUE(changed([](P& p) { p.speeds[0].sources.add(MrspSource::TSR); }));
  EXPECT_TRUE(changed([](P& p) { p.gradients.clear(); }));
  EXPECT_TRUE(changed([](P& p) { p.gradients[0].permille = 1; }));
  EXPECT_TRUE(changed([](P& p) { p.conditions[1].symbol = Symbol::PL30; }));
  EXPECT_TRUE(changed([](P& p) { p.EOA.reset(); }));
  EXPECT_TRUE(changed([](P& p) { p.LOA = 1_m; }));
  EXPECT_TRUE(differ_beyond_motion(&before, nullptr));
  EXPECT_FALSE(differ_beyond_motion(static_cast<const P*>(nullptr), nullptr));
}

TEST(OutputLines, CsvHasOneFieldPerColumn) {
  const auto fields = [](const std::string& row) {
    std::size_t n = 1;
    bool quoted = false;
    for (const char c : row) {
      if (c == '"') quoted = !quoted;
      if (c == ',' && !quoted) ++n;
    }
    return n;
  };
  for (const auto& outputs : {some_outputs(), second_edition(), kernel::Outputs{}}) {
    std::string row;
    append_trace(row, 12300, outputs);
    EXPECT_EQ(fields(row), fields(trace_header())) << row;
  }
}

TEST(OutputLines, ChangesAreWhatIsNotMotion) {
  kernel::Outputs a;
  kernel::Outputs b;
  b.v = 10_km_h;
  b.est_front = {{5.0}};
  EXPECT_FALSE(differ_beyond_motion(a, b));
  b.tco = true;
  EXPECT_TRUE(differ_beyond_motion(a, b));
  EXPECT_TRUE(differ_beyond_motion(a, some_outputs()));
}

TEST(OutputLines, ChangesOfTheSecondEdition) {
  const kernel::Outputs before;
  const auto changed = [&before](auto change) {
    kernel::Outputs after;
    change(after);
    return differ_beyond_motion(before, after);
  };
  using Out = kernel::Outputs;
  EXPECT_FALSE(changed([](Out& o) { o.V_I = 36_km_h; }));
  EXPECT_FALSE(changed([](Out& o) { o.TTI = Duration{1.0}; }));
  EXPECT_FALSE(changed([](Out& o) { o.d_indication = o.geo = o.rv_left = 1_m; }));
  EXPECT_FALSE(changed([](Out& o) { o.data.SR.D = 1_m; }));
  EXPECT_TRUE(changed([](Out& o) { o.data.SR.V = 36_km_h; }));
  EXPECT_TRUE(changed([](Out& o) { o.data.train_status = DataStatus::invalid; }));
  EXPECT_TRUE(changed([](Out& o) { o.data.driver_id = DriverId("1"); }));
  EXPECT_TRUE(changed([](Out& o) { o.data.rbc.NID_RADIO = 1; }));
  EXPECT_TRUE(changed([](Out& o) { o.data.train.airtight = true; }));
  EXPECT_TRUE(changed([](Out& o) { o.data.slippery_rail = true; }));
  EXPECT_TRUE(changed([](Out& o) { (void)o.forwarded.push_back({}); }));
  EXPECT_TRUE(changed([](Out& o) { (void)o.covers.push_back({}); }));
  EXPECT_TRUE(changed([](Out& o) { o.LSSMA = 72_km_h; }));
  EXPECT_TRUE(changed([](Out& o) { o.MRDT_changed = true; }));
  EXPECT_TRUE(changed([](Out& o) { o.memo_status = MemoStatus::P; }));
  EXPECT_TRUE(changed([](Out& o) { o.level_valid = true; }));
  EXPECT_TRUE(changed([](Out& o) { o.trip_reason = StatusText::emergency_stop; }));
  EXPECT_TRUE(changed([](Out& o) { o.levels_allowed.add(Level::L1); }));
  EXPECT_TRUE(changed([](Out& o) { o.enabled.add(DriverInput::start); }));
  EXPECT_TRUE(changed([](Out& o) { (void)o.status_texts.push_back({}); }));
  EXPECT_TRUE(changed([](Out& o) { (void)o.sessions.push_back({}); }));
  EXPECT_TRUE(changed([](Out& o) { (void)o.infill_sessions.push_back({}); }));
  EXPECT_TRUE(changed([](Out& o) { (void)o.track_conditions.push_back({}); }));
  EXPECT_TRUE(changed([](Out& o) { (void)o.ordered_areas.push_back({}); }));
  EXPECT_TRUE(changed([](Out& o) { (void)o.ordered_platforms.push_back({}); }));
  EXPECT_TRUE(changed([](Out& o) { o.ordered_traction.emplace(); }));
  EXPECT_TRUE(changed([](Out& o) { o.ordered_current.emplace(); }));
  EXPECT_TRUE(changed([](Out& o) { o.sound_horn = true; }));
  EXPECT_TRUE(changed([](Out& o) { o.remote_shunting = true; }));
  EXPECT_TRUE(changed([](Out& o) { o.engine_orientation = EngineOrientation::same; }));
  EXPECT_TRUE(changed([](Out& o) { o.M_VERSION = 0x11; }));
  const auto moved = [](double to_start) {
    Out o;
    (void)o.ordered_areas.push_back({TrackConditionKind::powerless_lower_pantograph, Distance{to_start}, 500_m});
    return o;
  };
  EXPECT_FALSE(differ_beyond_motion(moved(200.0), moved(190.0)));
}

TEST(WholeFile, AppearsOnlyWhenWhole) {
  const std::string file = ::testing::TempDir() + "/whole_file_test.txt";
  std::filesystem::remove(file);
  {
    auto out = WholeFile::create(file);
    ASSERT_TRUE(out);
    out->write("half");
  }
  EXPECT_FALSE(std::filesystem::exists(file));
  ASSERT_TRUE(write_whole(file, "whole"));
  EXPECT_EQ(*read_text(file), "whole");
  std::filesystem::remove(file);
  EXPECT_FALSE(write_whole("/nonexistent/folder/file", "x"));
  EXPECT_FALSE(read_text("/nonexistent/file"));
  EXPECT_FALSE(read_text("/"));
}

/// A new empty folder.
class Folder {
 public:
  explicit Folder(const char* name) : path_(::testing::TempDir() + "/openevc_" + name) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  std::string operator/(const char* name) const { return path_ + "/" + name; }
  const std::string& path() const { return path_; }
  std::size_t entries() const {
    const std::filesystem::directory_iterator all(path_);
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
  }

 private:
  std::string path_;
};

TEST(WholeFile, BothOrNeither) {
  const Folder folder("together");
  ASSERT_TRUE(write_whole(folder / "a", "old"));
  {
    auto a = WholeFile::create(folder / "a");
    auto full = WholeFile::create("/dev/full");
    ASSERT_TRUE(a && full);
    a->write("new");
    full->write("no room");
    const auto done = commit_together({&*a, &*full});
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().text(), "/dev/full: found No space left on device, expected space for the whole file");
  }
  EXPECT_EQ(*read_text(folder / "a"), "old");
  EXPECT_EQ(folder.entries(), 1u);
  auto a = WholeFile::create(folder / "a");
  auto b = WholeFile::create(folder / "b");
  ASSERT_TRUE(a && b);
  a->write("new");
  ASSERT_TRUE(commit_together({&*a, &*b}));
  EXPECT_EQ(*read_text(folder / "a"), "new");
  EXPECT_EQ(*read_text(folder / "b"), "");
}

TEST(WholeFile, FinishedButNotCommittedIsGone) {
  const Folder folder("finished");
  {
    auto out = WholeFile::create(folder / "x");
    ASSERT_TRUE(out);
    out->write("whole");
    ASSERT_TRUE(out->finish());
    EXPECT_FALSE(std::filesystem::exists(folder / "x"));
  }
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(File, TheSameFileHoweverItIsNamed) {
  const Folder folder("same");
  EXPECT_TRUE(same_file(folder / "new", folder / "../openevc_same/new"));
  EXPECT_FALSE(same_file(folder / "new", folder / "other"));
  ASSERT_TRUE(write_whole(folder / "new", "x"));
  std::filesystem::create_symlink(folder / "new", folder / "link");
  EXPECT_TRUE(same_file(folder / "new", folder / "link"));
  EXPECT_FALSE(same_file(folder / "new", folder / "other"));
  EXPECT_FALSE(same_file("/dev/null", "/dev/null"));
}

TEST(File, AFolderIsTriedUnderANameOfItsOwn) {
  const Folder folder("probe");
  std::filesystem::create_directory(folder / "probe");
  EXPECT_TRUE(can_be_written_in(folder.path()));
  EXPECT_EQ(folder.entries(), 1u);
  const auto missing = can_be_written_in("/nonexistent");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().text(),
            "/nonexistent: found No such file or directory, expected a folder that can be written");
}

}  // namespace
}  // namespace evc::io
