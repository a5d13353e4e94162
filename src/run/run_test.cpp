#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "base/test_paths.h"
#include "io/line_file.h"
#include "io/make_line.h"
#include "io/number.h"
#include "io/program_test.h"
#include "io/telegram_json.h"
#include "io/train_file.h"
#include "lang/encode.h"
#include "lang/messages.h"
#include "lang/packets/packet_15.h"
#include "run/sha256.h"

// The program as run by a user.
namespace evc::run {
namespace {

using nlohmann::json;

struct Finished {
  int exit_code = -1;
  std::string output;  // standard output and standard error
};

Finished evc(const std::string& arguments) {
  const std::string command = program() + arguments + " 2>&1";
  Finished finished;
  std::FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) return finished;
  char block[4096];
  for (std::size_t n = 0; (n = std::fread(block, 1, sizeof block, pipe)) > 0;) finished.output.append(block, n);
  const int status = ::pclose(pipe);
  finished.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return finished;
}

std::string shared_line() { return evc::test::shared_folder() + "/lines/amsterdam_utrecht.json"; }

/// The report has the display of the whole run, at most one list a second, and is small enough to be sent.
void expect_displays(const std::string& page) {
  EXPECT_LE(page.size(), 2'000'000u);  // of the 5 MB that it may have
  EXPECT_NE(page.find("export class Painter"), std::string::npos);
  const std::size_t at = page.find("{\"least_s\":1,\"shapes\":[[\"#031122\",0,\"M0 0L640 0");
  ASSERT_NE(at, std::string::npos);
  const json written = json::parse(page.substr(at, page.find(");\nconst D", at) - at));
  EXPECT_GT(written["lists"].size(), 900u);
  EXPECT_EQ(written["lists"][0][0], 0);
}

TEST(ShippedLine, IsWhatItsDescriptionGives) {
  const std::string folder = evc::test::source_folder() + "/data/lines/";
  const auto made = io::make_line(text_of(folder + "brunnental.description.json"), "brunnental.description.json");
  ASSERT_TRUE(made) << made.error().text();
  EXPECT_EQ(*made, text_of(folder + "brunnental.json"))
      << "run: evc make-line data/lines/brunnental.description.json -o data/lines/brunnental.json";
}

TEST(ShippedTrains, AreReadAndTheStandardOneIsTheDefault) {
  for (const auto& entry : std::filesystem::directory_iterator(evc::test::source_folder() + "/data/trains")) {
    const auto train = io::read_train(text_of(entry.path().string()), entry.path().string());
    ASSERT_TRUE(train) << train.error().text();
    if (entry.path().filename() != "standard.json") continue;
    EXPECT_EQ(train->data, train::TrainData{});
    EXPECT_EQ(train->dynamics.tractive_effort, sim::Dynamics{}.tractive_effort);
    EXPECT_EQ(train->dynamics.davis, sim::Dynamics{}.davis);
    EXPECT_EQ(train->dynamics.emergency_brake, sim::Dynamics{}.emergency_brake);
    EXPECT_EQ(train->dynamics.service_brake, sim::Dynamics{}.service_brake);
    EXPECT_EQ(train->dynamics.build_up_s, sim::Dynamics{}.build_up_s);
  }
}

TEST(MakeLine, ErrorsNameThePlace) {
  const auto error_of = [](const char* text) {
    const auto made = io::make_line(text, "d.json");
    return made ? std::string() : made.error().text();
  };
  EXPECT_NE(error_of(R"({"schema":"evc-line-description/1","name":"x","NID_C":1,"length_m":100,"start":{},
    "gradient":[[0,100,0]],"ssp":[[0,100,80]],"groups":[{"NID_BG":1,"at_m":0,"orders":[{"authorty":{}}]}],
    "radio":[]})")
                .find("/groups/0/orders/0"),
            std::string::npos);
  // The profile must reach 100 m beyond the danger point.
  const auto with_profiles = [&](const std::string& gradient, const std::string& ssp) {
    const std::string text = R"({"schema":"evc-line-description/1","name":"x","NID_C":1,"length_m":100,"start":{},
      "gradient":)" + gradient +
                             R"(,"ssp":)" + ssp +
                             R"(,"groups":[{"NID_BG":1,"at_m":0,"orders":[{"authority":{"to_m":90}}]}],"radio":[]})";
    return error_of(text.c_str());
  };
  EXPECT_EQ(with_profiles("[[0,190,0]]", "[[0,100,80],[100,190,60]]"), "");
  EXPECT_EQ(with_profiles("[[0,190,0]]", "[[0,100,80]]"),
            "d.json: /ssp: found an authority over places without ssp, expected ssp from 0 m to 190 m: from the group "
            "to 100 m beyond the danger point");
  EXPECT_EQ(with_profiles("[[0,100,0],[120,190,5]]", "[[0,190,80]]"),
            "d.json: /gradient/1/0: found 120 m, expected 100 m, where the step before ends");
  EXPECT_EQ(with_profiles("[[0,190,0]]", "[[0,100,80],[90.5,190,60]]"),
            "d.json: /ssp/1/0: found 90.5 m, expected 100 m, where the step before ends");
  EXPECT_EQ(with_profiles("[[0,190,0],[190,190,0]]", "[[0,190,80]]"),
            "d.json: /gradient/1/1: found 190 m, expected a place beyond 190 m");
}

/// What is for the reader only is text, too: another value is misplaced.
TEST(MakeLine, CommentsAreText) {
  const auto error_of = [](const std::string& about, const std::string& of_group, const std::string& of_message) {
    const auto made = io::make_line(
        R"({"schema":"evc-line-description/1","name":"x","about":)" + about +
            R"(,"NID_C":1,"length_m":900,"start":{},"gradient":[[0,3000,0]],"ssp":[[0,3000,80]],"groups":[{"NID_BG":7,
        "at_m":100,"note":)" +
            of_group + R"(}],"radio":[{"at_m":200,"lrbg":7,"orders":[],"note":)" + of_message + "}]}",
        "d.json");
    return made ? std::string() : made.error().text();
  };
  EXPECT_EQ(error_of(R"("a")", R"("b")", R"("c")"), "");
  EXPECT_EQ(error_of("[1]", R"("b")", R"("c")"), "d.json: /about: found an array of 1, expected a string");
  EXPECT_EQ(error_of(R"("a")", "5", R"("c")"), "d.json: /groups/0/note: found 5, expected a string");
  EXPECT_EQ(error_of(R"("a")", R"("b")", "{}"), "d.json: /radio/0/note: found an object, expected a string");
}

/// A line of two groups in level 1 with the given orders of the first group and radio messages.
json line_with(const std::string& first_group, const std::string& radio) {
  const auto made = io::make_line(
      R"({"schema":"evc-line-description/1","name":"x","NID_C":1,"length_m":900,"start":{},"gradient":[[0,3000,0]],
      "ssp":[[0,3000,80]],"groups":[{"NID_BG":7,"at_m":100,)" +
          first_group + R"(},{"NID_BG":8,"at_m":600}],"radio":[)" + radio + "]}",
      "d.json");
  return made ? json::parse(*made) : json(made.error().text());
}

/// The packets of a balise of the first group.
json packets_in(const json& line, std::size_t balise) {
  const auto bits = io::bits_of_hex(line["balise_groups"][0]["balises"][balise]["telegram_hex"].get<std::string>());
  std::string text;
  EXPECT_TRUE(bits && io::append_balise_json(text, bits->bytes, bits->bits));
  return json::parse(text)["packets"];
}

TEST(MakeLine, AnyPacketAndAnyMessage) {
  const std::string packet = R"({"NID_PACKET":45,"Q_DIR":1,"NID_MN":4711})";
  const json line = line_with(R"("orders":[{"packet":)" + packet + "}]",
                              R"({"at_m":300,"lrbg":7,"message":{"NID_MESSAGE":16,"NID_EM":3}})");
  ASSERT_TRUE(line.is_object()) << line;
  EXPECT_EQ(packets_in(line, 0)[0]["NID_MN"], 4711);
  EXPECT_EQ(line["balise_groups"][0]["balises"][0]["contains"][0], "45 Radio network registration");
  const json& message = line["rbc_messages"][0];
  EXPECT_EQ(message["nid_message"], 16);
  // NID_MESSAGE 16, L_MESSAGE 10 bytes, T_TRAIN 0, M_ACK 0, NID_LRBG 1 and 7, NID_EM 3 (8.7.6): 79 bits and one of
  // padding.
  EXPECT_EQ(message["message_hex"], "100280000000000800E6");
}

TEST(MakeLine, InfillCountsFromTheMainSignalInEveryTelegram) {
  const json line = line_with(R"("orders":[{"infill":8},{"authority":{"to_m":1500}},{"text":{"text":")" +
                                  std::string(80, 'x') + R"(","for_s":9}}])",
                              "");
  ASSERT_TRUE(line.is_object()) << line;
  const json first = packets_in(line, 0), second = packets_in(line, 1);
  EXPECT_EQ(first[0]["NID_PACKET"], 136);
  EXPECT_EQ(first[0]["NID_BG"], 8);
  EXPECT_EQ(first[1]["NID_PACKET"], 12);
  EXPECT_EQ(first[1]["L_ENDSECTION"], 900);
  EXPECT_EQ(second[0]["NID_PACKET"], 136);
  EXPECT_EQ(second[1]["NID_PACKET"], 72);
}

TEST(MakeLine, NationalValuesWithoutAMaximum) {
  const json line = line_with(
      R"("orders":[{"national_values":{"A_NVMAXREDADH1":"no maximum","A_NVMAXREDADH2":"no maximum, time to indication",
      "A_NVMAXREDADH3":0.7,"V_NVREL":25}}])",
      "");
  ASSERT_TRUE(line.is_object()) << line;
  const json packet = packets_in(line, 0)[0];
  EXPECT_EQ(packet["NID_PACKET"], 3);
  EXPECT_EQ(packet["NID_C"], 1);
  EXPECT_EQ(packet["V_NVREL"], 5);
  EXPECT_EQ(packet["A_NVMAXREDADH1"], 63);
  EXPECT_EQ(packet["A_NVMAXREDADH2"], 62);
  EXPECT_EQ(packet["A_NVMAXREDADH3"], 14);
}

TEST(MakeLine, NumberOfBalises) {
  const json line = line_with(R"("balises":1,"orders":[])", "");
  ASSERT_TRUE(line.is_object()) << line;
  EXPECT_EQ(line["balise_groups"][0]["balises"].size(), 1u);
  EXPECT_EQ(line["balise_groups"][1]["balises"].size(), 2u);
  const std::string refused = line_with(R"("balises":9)", "");
  EXPECT_NE(refused.find("/groups/0/balises"), std::string::npos) << refused;
}

TEST(MakeLine, WrongPacketsAndMessagesNameThePlace) {
  const std::string packet = line_with(R"("orders":[{"packet":{"NID_PACKET":45,"Q_DIR":1}}])", "");
  EXPECT_NE(packet.find("/groups/0/orders/0/packet: found"), std::string::npos) << packet;
  EXPECT_NE(packet.find("NID_MN"), std::string::npos) << packet;
  const std::string message = line_with(R"("orders":[])", R"({"at_m":300,"lrbg":7,"message":{"NID_MESSAGE":16}})");
  EXPECT_NE(message.find("/radio/0/message: found"), std::string::npos) << message;
  EXPECT_NE(message.find("NID_EM"), std::string::npos) << message;
  const std::string both =
      line_with(R"("orders":[])", R"({"at_m":300,"lrbg":7,"orders":[],"message":{"NID_MESSAGE":6}})");
  EXPECT_NE(both.find("/radio/0: found orders and a message"), std::string::npos) << both;
}

/// What cannot be encoded as it is written is an error, not something else.
TEST(MakeLine, NothingIsLostSilently) {
  const auto refused = [](const std::string& first_group, const std::string& radio = "") {
    const json line = line_with(first_group, radio);
    return line.is_string() ? line.get<std::string>() : "made";
  };
  const auto order = [&](const std::string& text) { return refused("\"orders\":[" + text + "]"); };
  const std::string one = ", expected one order: authority, ";
  const std::string TSR = R"("temporary_speed_restriction":{"NID_TSR":1,"from_m":500,"to_m":900,"kmh":30})";
  EXPECT_NE(order(R"({"authority":{"to_m":800},)" + TSR + "}").find("/groups/0/orders/0: found 2 keys" + one),
            std::string::npos)
      << order(R"({"authority":{"to_m":800},)" + TSR + "}");
  EXPECT_NE(order("{" + TSR + R"(,"authorty":{}})").find("found 2 keys" + one), std::string::npos);
  EXPECT_NE(order(R"({"infill":8,)" + TSR + "}").find("found 2 keys" + one), std::string::npos);
  EXPECT_NE(order("{}").find("found 0 keys" + one), std::string::npos);
  EXPECT_NE(order("[]").find("/groups/0/orders/0: found an array of 0, expected an object"), std::string::npos);
  EXPECT_NE(refused(R"("orders":[])", R"({"at_m":300,"lrbg":7,"orders":[{)" + TSR + R"(,"text":{}}]})")
                .find("/radio/0/orders/0: found 2 keys" + one),
            std::string::npos);
  // A speed that has no code, a place that L_ or D_ cannot hold (15 bits), more steps than N_ITER counts (5 bits).
  EXPECT_NE(order(R"({"temporary_speed_restriction":{"NID_TSR":1,"from_m":500,"to_m":900,"kmh":33}})")
                .find("/temporary_speed_restriction/kmh: found 33, expected a multiple of 5 km/h"),
            std::string::npos);
  EXPECT_NE(order(R"({"authority":{"to_m":800,"danger_point_m":850,"release_kmh":12}})").find("a multiple of 5 km/h"),
            std::string::npos);
  EXPECT_NE(order(R"({"national_values":{"V_NVREL":23}})").find("/V_NVREL: found 23, expected a multiple of 5 km/h"),
            std::string::npos);
  for (const char* beyond : {R"({"temporary_speed_restriction":{"NID_TSR":1,"from_m":70000,"to_m":70100,"kmh":30}})",
                             R"({"level_transition":{"at_m":70000,"level":"1","acknowledge_m":100}})",
                             R"({"mode_profile":{"mode":"OS","from_m":70000,"to_m":70100,"acknowledge_m":100}})"})
    EXPECT_NE(order(beyond).find("found 70000, expected a number from 100.0 to 32866.0"), std::string::npos) << beyond;
  EXPECT_NE(order(R"({"text":{"text":")" + std::string(256, 'x') + R"(","for_s":9}})").find("at most 255 characters"),
            std::string::npos);
  EXPECT_EQ(refused(R"("orders":[])"), "made");
}

/// `line_with`, with these profiles and groups.
std::string made_of(const std::string& profiles, const std::string& groups) {
  const auto made =
      io::make_line(R"({"schema":"evc-line-description/1","name":"x","NID_C":1,"length_m":900,"start":{},)" + profiles +
                        R"(,"groups":[)" + groups + R"(],"radio":[]})",
                    "d.json");
  return made ? *made : made.error().text();
}

TEST(MakeLine, ProfilesThatDoNotFitAreErrors) {
  std::string steps;
  for (int i = 0; i < 40; ++i)
    steps += (i == 0 ? "[" : ",[") + std::to_string(100 * i) + "," + std::to_string(100 * i + 100) + "," +
             std::to_string(i % 2) + "]";
  const std::string authority = R"({"NID_BG":7,"at_m":100,"orders":[{"authority":{"to_m":3500}}]})";
  EXPECT_NE(made_of(R"("gradient":[)" + steps + R"(],"ssp":[[0,4000,80]])", authority).find("at most 32 steps"),
            std::string::npos);
  EXPECT_NE(made_of(R"("gradient":[[0,4000,0]],"ssp":[[0,4000,82]])", authority)
                .find("/ssp/0/2: found 82, expected a multiple of 5 km/h"),
            std::string::npos);
  // From one step to the next, and from one group to the next, at most 32 767 m (15 bits).
  EXPECT_NE(made_of(R"("gradient":[[0,90000,0]],"ssp":[[0,90000,80]])",
                    R"({"NID_BG":7,"at_m":100,"orders":[{"authority":{"to_m":32100,"danger_point_m":36000}}]})")
                .find("at most 32767 m"),
            std::string::npos);
  EXPECT_NE(made_of(R"("gradient":[[0,90000,0]],"ssp":[[0,90000,80]])",
                    R"({"NID_BG":7,"at_m":100,"orders":[{"authority":{"to_m":1000}}]},{"NID_BG":8,"at_m":80000})")
                .find("at most 32767 m"),
            std::string::npos);
  EXPECT_NE(
      made_of(R"("gradient":[[0,4000,0]],"ssp":[[0,4000,80]])", R"({"NID_BG":7,"at_m":100},{"NID_BG":7,"at_m":200})")
          .find("/groups/1/NID_BG: found 7, expected a NID_BG of no other group"),
      std::string::npos);
}

/// What make-line accepts, the reader of lines accepts.
TEST(MakeLine, ALineThatCannotBeDrivenIsNotMade) {
  const std::string profiles = R"("gradient":[[0,4000,0]],"ssp":[[0,4000,80]])";
  EXPECT_NE(made_of(profiles, "").find("/groups: found an array of 0, expected at least one group"), std::string::npos);
  const std::string made = made_of(profiles, R"({"NID_BG":7,"at_m":100})");
  EXPECT_TRUE(io::read_line(made, "made.json")) << made;
}

/// G_A is in whole permille (7.5.1.37): a gradient between two codes is sent as the one further downhill.
TEST(MakeLine, AGradientIsRoundedDownhill) {
  const auto made = io::make_line(
      R"({"schema":"evc-line-description/1","name":"x","NID_C":1,"length_m":900,"start":{},
      "gradient":[[0,300,3.6],[300,600,-3.4],[600,3000,0.5]],"ssp":[[0,3000,80]],
      "groups":[{"NID_BG":7,"at_m":100,"orders":[{"authority":{"to_m":800}}]}],"radio":[]})",
      "d.json");
  ASSERT_TRUE(made) << made.error().text();
  const json packets = packets_in(json::parse(*made), 0);
  const json& gradient = packets[1]["NID_PACKET"] == 21 ? packets[1] : packets[2];
  EXPECT_EQ(gradient["Q_GDIR"], 1);
  EXPECT_EQ(gradient["G_A"], 3);
  EXPECT_EQ(gradient["steps"][0]["Q_GDIR"], 0);
  EXPECT_EQ(gradient["steps"][0]["G_A"], 4);
  EXPECT_EQ(gradient["steps"][1]["Q_GDIR"], 1);
  EXPECT_EQ(gradient["steps"][1]["G_A"], 0);
  EXPECT_EQ(json::parse(*made)["physical_track"]["gradient"][0]["gradient_permille"], 3.6);
}

TEST(MakeLine, TheStartAndTheRbcAreChecked) {
  const auto with = [](const std::string& start) {
    const auto made = io::make_line(
        R"({"schema":"evc-line-description/1","name":"x","NID_C":1,"length_m":900,"gradient":[[0,3000,0]],
        "ssp":[[0,3000,80]],"groups":[{"NID_BG":7,"at_m":100}],"radio":[],)" +
            start + "}",
        "d.json");
    return made ? *made : made.error().text();
  };
  EXPECT_EQ(with(R"("start":{"front_m":"x"})"), "d.json: /start/front_m: found \"x\", expected a number");
  EXPECT_EQ(with(R"("start":{"level":7})"),
            "d.json: /start/level: found 7, expected one of \"0\", \"NTC\", \"1\", \"2\", \"3\"");
  EXPECT_EQ(with(R"("start":{"zzz":1})"),
            "d.json: /start/zzz: found an unknown key, expected one of front_m, level, mode, nid_ntc");
  EXPECT_EQ(with(R"("start":[])"), "d.json: /start: found an array of 0, expected an object");
  EXPECT_EQ(with(R"("start":{"nid_ntc":256})"), "d.json: /start/nid_ntc: found 256, expected an integer from 0 to 255");
  EXPECT_EQ(with(R"("start":{},"rbc":{"NID_C":1,"NID_RBC":2})"),
            "d.json: /rbc: found no key \"NID_RADIO\", expected one");
  const json line = json::parse(with(
      R"("start":{"front_m":-20,"level":"2"},"rbc":{"NID_C":1,"NID_RBC":2,"NID_RADIO":"0041790000000001","shunting":"grant"})"));
  EXPECT_EQ(line["start"], json::parse(R"({"front_m":-20,"level":"2"})"));
  EXPECT_EQ(line["rbc"]["shunting"], "grant");
}

TEST(Sha256, OfTheStandard) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

/// Checks the summary of a whole journey.
void expect_clean_run(const json& s) {
  EXPECT_EQ(s["balise_groups"]["read"], s["balise_groups"]["on_line"]);
  EXPECT_EQ(s["balise_groups"]["missed"], 0);
  EXPECT_EQ(s["balise_groups"]["rejected"], 0);
  EXPECT_EQ(s["telegrams"]["rejected"], 0);
  EXPECT_EQ(s["movement_authorities"]["received"], s["movement_authorities"]["accepted"]);
  for (const char* kind : {"tco", "sb", "eb", "trip"}) EXPECT_EQ(s["interventions"][kind], 0) << kind;
  EXPECT_EQ(s["confidence_interval_violations"], 0);
  EXPECT_EQ(s["allocations_in_step"], 0);
  EXPECT_TRUE(s["svl_overrun_m"].is_null());
}

TEST(Run, TheShippedLineAndItsReplay) {
  const Folder folder("run");
  const Finished run = evc("run -o '" + folder.path() + "'");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const json summary = json::parse(text_of(folder / "summary.json"));
  expect_clean_run(summary);
  EXPECT_EQ(summary["modes"], json({"SB", "SR", "FS", "OS", "FS", "SN"}));
  EXPECT_EQ(summary["levels"], json({"1", "2", "NTC"}));
  EXPECT_EQ(summary["radio_messages"]["received"], summary["radio_messages"]["accepted"]);
  const std::string outputs = text_of(folder / "outputs.jsonl");
  EXPECT_EQ(summary["output_hash"], sha256(outputs));
  // Replaying the inputs gives the same outputs, byte for byte.
  const Finished replay = evc("replay '" + (folder / "inputs.jsonl") + "' -o '" + (folder / "replayed.jsonl") + "'");
  ASSERT_EQ(replay.exit_code, 0) << replay.output;
  EXPECT_TRUE(text_of(folder / "replayed.jsonl") == outputs);
  // The thinned streams are parts of the full one.
  const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
  const Finished every = evc("replay --every 10 '" + (folder / "inputs.jsonl") + "'");
  EXPECT_EQ(lines(every.output), (lines(outputs) + 9) / 10);
  const Finished changes = evc("replay --changes - < '" + (folder / "inputs.jsonl") + "'");
  EXPECT_GT(lines(changes.output), 100);
  EXPECT_LT(lines(changes.output), lines(outputs) / 2);
  // Where an advance display is asked for, the authority is in it; --changes has more lines by it.
  const Finished planning = evc("replay --changes --planning '" + (folder / "inputs.jsonl") + "'");
  EXPECT_GE(lines(planning.output), lines(changes.output));
  EXPECT_NE(planning.output.find(R"("planning":{"gradient":[{"from_m":0,)"), std::string::npos);
  EXPECT_NE(planning.output.find(R"("planning":null)"), std::string::npos);
  EXPECT_EQ(changes.output.find(R"("planning":{)"), std::string::npos);
  EXPECT_EQ(lines(text_of(folder / "trace.csv")), lines(outputs) + 1);
  const std::string page = text_of(folder / "report.html");
  EXPECT_EQ(page.find("/*DATA*/null"), std::string::npos);
  EXPECT_EQ(page.find("/*DISPLAY*/null"), std::string::npos);
  expect_displays(page);
  EXPECT_EQ(page.find("http"), std::string::npos) << "the page needs no network";
}

// The clock and the edition are those of the on-board, and replay has both again.
TEST(Run, HasTheClockAndTheEditionThatAreAskedFor) {
  const Folder folder("clock");
  const Finished run = evc("run --srs 4.0.0 --utc 2026-01-01T08:00:00Z -o '" + folder.path() + "'");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const std::string inputs = text_of(folder / "inputs.jsonl"), outputs = text_of(folder / "outputs.jsonl");
  EXPECT_NE(inputs.substr(0, inputs.find('\n')).find(R"("srs":"4.0.0")"), std::string::npos);
  EXPECT_NE(outputs.find(R"("local":"2026-01-01T08:01:00")"), std::string::npos);
  EXPECT_TRUE(evc("replay '" + (folder / "inputs.jsonl") + "'").output == outputs);
  for (const char* wrong : {"--utc 08:00", "--utc 2026-13-01T08:00:00Z", "--srs 5.0.0"})
    EXPECT_EQ(evc(std::string("run ") + wrong).exit_code, 2) << wrong;
}

TEST(Run, TheRecordedLine) {
  if (!std::filesystem::exists(shared_line())) GTEST_SKIP() << "needs " << shared_line();
  const Folder folder("recorded");
  const Finished run = evc("run '" + shared_line() + "' -o '" + folder.path() + "'");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const json s = json::parse(text_of(folder / "summary.json"));
  expect_clean_run(s);
  expect_displays(text_of(folder / "report.html"));
  EXPECT_EQ(s["modes"], json({"SB", "SN", "FS", "SN"}));
  EXPECT_EQ(s["levels"], json({"NTC", "2", "NTC"}));
  EXPECT_EQ(s["balise_groups"]["on_line"], 103);
  EXPECT_EQ(s["telegrams"]["decoded"], 206);
  EXPECT_EQ(s["radio_messages"]["received"], 57);
  EXPECT_EQ(s["radio_messages"]["accepted"], 18);
  EXPECT_EQ(s["radio_messages"]["refused"], 39);
  EXPECT_EQ(s["radio_messages"]["absent"], 1);
  EXPECT_EQ(s["movement_authorities"]["received"], 16);
}

TEST(Run, ARecklessDriverIsStoppedBeforeTheEndOfHisLastAuthority) {
  if (!std::filesystem::exists(shared_line())) GTEST_SKIP() << "needs " << shared_line();
  const Folder folder("reckless");
  for (const char* choice : {"--last-ma 5 --seed 3", "--last-ma 23 --seed 4", "--last-ma 32 --seed 5"}) {
    const Finished run = evc("run '" + shared_line() + "' --driver reckless " + choice + " -o '" + folder.path() + "'");
    ASSERT_EQ(run.exit_code, 0) << run.output;
    const json s = json::parse(text_of(folder / "summary.json"));
    EXPECT_EQ(s["confidence_interval_violations"], 0);
    EXPECT_EQ(s["interventions"]["trip"], 1) << choice;
    // The driver passes at or below the release speed of 15 km/h: 1 s, and the stopping distance from there.
    EXPECT_LT(s["svl_overrun_m"].get<double>(), 20.0) << choice;
  }
}

TEST(Run, ATelegramThatDoesNotDecodeIsCountedAndTheRunGoesOn) {
  const Folder folder("undecodable");
  json line = json::parse(text_of(evc::test::source_folder() + "/data/lines/brunnental.json"));
  // Group 117: the second balise is not its duplicate, its loss is an error of a linked group.
  line["balise_groups"][16]["balises"][1]["telegram_hex"] = std::string(208, 'F');
  ASSERT_TRUE(io::write_whole(folder / "line.json", line.dump()));
  const Finished run = evc("run '" + (folder / "line.json") + "' -o '" + folder.path() + "'");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const json s = json::parse(text_of(folder / "summary.json"));
  EXPECT_EQ(s["telegrams"]["rejected"], 1);
  EXPECT_EQ(s["balise_groups"]["rejected"], 1);
  EXPECT_GE(s["interventions"]["sb"], 1);  // Q_LINKREACTION is the service brake
  EXPECT_NE(text_of(folder / "outputs.jsonl").find("BG 117 message inconsistent [3.16.2.4.1]"), std::string::npos);
}

/// A description of a line in level 2 from its start: the second group gives the first authority.
std::string level_2_from_the_start(const std::string& level, const std::string& rbc, double first_authority_m) {
  std::string groups;
  for (int i = 0; i < 8; ++i)
    groups += (i == 0 ? "{\"NID_BG\":" : ",{\"NID_BG\":") + std::to_string(101 + i) +
              ",\"at_m\":" + std::to_string(80 + 500 * i) + "}";
  return R"({"schema":"evc-line-description/1","name":"level 2","NID_C":1000,"length_m":4000,
    "start":{"front_m":-20,"level":")" +
         level + R"("},)" + rbc + R"("gradient":[[-500,9000,0]],"ssp":[[-500,9000,80]],"groups":[)" + groups +
         R"(],"radio":[{"at_m":)" + std::to_string(first_authority_m) +
         R"(,"lrbg":101,"orders":[{"authority":{"to_m":3000,"danger_point_m":3100,"release_kmh":20}}]},
         {"at_m":1800,"lrbg":104,"orders":[{"authority":{"to_m":8000,"danger_point_m":8100,"release_kmh":20}}]}]})";
}

/// The summary of a run.
json driven_along(const Folder& folder, const std::string& line) {
  EXPECT_TRUE(io::write_whole(folder / "line.json", line));
  const Finished run = evc("run '" + (folder / "line.json") + "' -o '" + folder.path() + "'");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  return json::parse(text_of(folder / "summary.json"));
}

json driven(const Folder& folder, const std::string& description) {
  const auto made = io::make_line(description, "d.json");
  EXPECT_TRUE(made) << made.error().text();
  return driven_along(folder, made.value_or(""));
}

/// Start of mission in level 2 and 3 (5.4): contact entered, session, train data, authority or SR authorisation.
TEST(Run, AMissionStartsInLevel2) {
  const Folder folder("level_2");
  const char* rbc = R"("rbc":{"NID_C":1000,"NID_RBC":9,"NID_RADIO":"0041790000000001"},)";
  for (const char* level : {"2", "3"}) {
    const json s = driven(folder, level_2_from_the_start(level, rbc, 120.0));
    EXPECT_EQ(s["levels"], json({level}));
    // Without a place the RBC gives SR; the authority follows behind the first group.
    EXPECT_EQ(s["modes"], json({"SB", "SR", "FS"}));
    EXPECT_EQ(s["balise_groups"]["read"], 8);
    EXPECT_EQ(s["radio_messages"]["received"], 2);
    EXPECT_EQ(s["radio_messages"]["accepted"], 2);
    EXPECT_EQ(s["interventions"]["trip"], 0);
    EXPECT_NE(text_of(folder / "inputs.jsonl").find("\"rbc\":{\"NID_C\":1000,\"NID_RBC\":9"), std::string::npos);
  }
  // An authority that is there before the train knows a group waits for one (3.6.2.2.2).
  json line = json::parse(text_of(folder / "line.json"));
  line["rbc_messages"][0]["trigger"]["position_m"] = -100;
  const json early = driven_along(folder, line.dump());
  EXPECT_EQ(early["modes"], json({"SB", "SR", "FS"}));
  EXPECT_EQ(early["radio_messages"]["accepted"], 2);
  // Without a contact in the file there is one all the same.
  EXPECT_EQ(driven(folder, level_2_from_the_start("2", "", 120.0))["modes"], json({"SB", "SR", "FS"}));
}

/// A handover is reported, as there is no RBC that answers (3.15.1).
TEST(Run, TheCallOfASecondRbcIsTold) {
  const Folder folder("second_rbc");
  json description = json::parse(level_2_from_the_start("2", "", 120.0));
  description["groups"][1]["orders"].push_back({{"packet",
                                                 {{"NID_PACKET", 131},
                                                  {"Q_DIR", 1},
                                                  {"Q_SCALE", 1},
                                                  {"D_RBCTR", 2000},
                                                  {"NID_C", 1000},
                                                  {"NID_RBC", 10},
                                                  {"NID_RADIO", "0041790000000002"},
                                                  {"Q_SLEEPSESSION", 0}}}});
  EXPECT_GT(driven(folder, description.dump())["radio_messages"]["unanswered_calls"], 0);
  const Finished run = evc("run '" + (folder / "line.json") + "'");
  EXPECT_NE(run.output.find("\ncalls unanswered    "), std::string::npos) << run.output;
  EXPECT_NE(run.output.find(": one RBC is simulated, no other one and no radio infill unit\n"), std::string::npos)
      << run.output;
}

/// A mission that does not begin ends the run soon, and is reported.
TEST(Run, AMissionThatCannotStartIsReported) {
  const Folder folder("no_start");
  json line = json::parse(text_of(evc::test::source_folder() + "/data/lines/brunnental.json"));
  // The message of a session that is never set up.
  line["start"] = {{"front_m", 24500.0}, {"level", "1"}};
  ASSERT_TRUE(io::write_whole(folder / "line.json", line.dump()));
  ASSERT_TRUE(
      io::write_whole(folder / "t.json", R"({"schema":"etcs-train/1","dynamics":{"tractive_effort":[[0,0]]}})"));
  const Finished run =
      evc("run '" + (folder / "line.json") + "' --train '" + (folder / "t.json") + "' -o '" + folder.path() + "'");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.output.find("found a train that never moved, mode SR, level 1, "), std::string::npos) << run.output;
  const json s = json::parse(text_of(folder / "summary.json"));
  EXPECT_LT(s["duration_s"].get<double>(), 200.0);
  EXPECT_GT(s["radio_messages"]["undelivered"].get<int>(), 0);
}

TEST(Run, AnAuthorityWithoutGradientAndSpeedProfileIsRefused) {
  const Folder folder("no_profile");
  json line = json::parse(text_of(evc::test::source_folder() + "/data/lines/brunnental.json"));
  json& message = line["rbc_messages"][2];
  ASSERT_EQ(message["contains"][0], "15 Level 2/3 movement authority");
  // Only the same authority, to 19 900 m from group 108 at 8 180 m (3.7.2.3, 4.8.3 [4]).
  lang::Message3 header;
  header.NID_LRBG.raw = 1000u << 14 | 108u;
  lang::Packet15 authority;
  authority.Q_DIR.raw = 1;
  authority.Q_SCALE.raw = 1;
  authority.T_EMA.raw = 1023;
  authority.L_ENDSECTION.raw = 19900 - 8180;
  std::array<std::uint8_t, 64> bytes{};
  BitWriter out(bytes);
  lang::encode_message(out, header, authority);
  std::string digits;
  io::append_hex(digits, out.bytes());
  message["message_hex"] = digits;
  message["message_bits"] = 4 * digits.size();
  ASSERT_TRUE(io::write_whole(folder / "line.json", line.dump()));
  const Finished run = evc("run '" + (folder / "line.json") + "' -o '" + folder.path() + "'");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const json s = json::parse(text_of(folder / "summary.json"));
  EXPECT_EQ(s["movement_authorities"]["accepted"].get<int>(), s["movement_authorities"]["received"].get<int>() - 1);
  EXPECT_EQ(s["radio_messages"]["refused"], 1);
  EXPECT_NE(text_of(folder / "outputs.jsonl").find("message 3 refused [4.8.3"), std::string::npos);
}

TEST(Run, WrongInputsAreToldAndLeaveNothing) {
  const Folder folder("wrong");
  ASSERT_TRUE(io::write_whole(folder / "line.json", R"({"schema":"etcs-line/1","name":"x","length_m":1,
    "balise_groups":[{"balises":[{"position_m":"here","telegram_hex":"90"}]}]})"));
  const Finished line = evc("run '" + (folder / "line.json") + "' -o '" + (folder / "out") + "'");
  EXPECT_EQ(line.exit_code, 2);
  EXPECT_NE(line.output.find("/balise_groups/0/balises/0/position_m: found \"here\", expected a number"),
            std::string::npos)
      << line.output;
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  EXPECT_EQ(evc("run --driver sleepy").exit_code, 2);
  EXPECT_EQ(evc("run --train /nonexistent.json").exit_code, 2);
  EXPECT_EQ(evc("").exit_code, 2);
  EXPECT_EQ(evc("--help").exit_code, 0);
}

/// A folder never has an old summary with files of another run.
TEST(Run, AFolderHoldsOneRunOrTheOther) {
  const Folder folder("one_run");
  const std::string old = "of the run before";
  for (const char* name : {"inputs.jsonl", "outputs.jsonl", "report.html", "summary.json"})
    ASSERT_TRUE(io::write_whole(folder / name, old));
  // The third file cannot be written; reported after the run, like a full disk.
  std::filesystem::create_directory(folder / "trace.csv");
  const Finished failed = evc("run -o '" + folder.path() + "'");
  EXPECT_EQ(failed.exit_code, 2);
  EXPECT_NE(failed.output.find("/trace.csv: found a directory, expected a file that can be written"),
            std::string::npos);
  for (const char* name : {"inputs.jsonl", "outputs.jsonl", "report.html", "summary.json"})
    EXPECT_EQ(text_of(folder / name), old) << name;
  std::size_t entries = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path())) ++entries;
  EXPECT_EQ(entries, 5u) << "no temporary file stays";
  // A folder with the name of the test file is no obstacle.
  std::filesystem::remove(folder / "trace.csv");
  std::filesystem::create_directory(folder / "probe");
  const Finished run = evc("run -o '" + folder.path() + "'");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(json::parse(text_of(folder / "summary.json"))["output_hash"], sha256(text_of(folder / "outputs.jsonl")));
}

TEST(Run, TheFilesAreThereWhateverBecomesOfTheSummary) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  const Folder folder("lost");
  // More than standard output buffers: it fails in the middle.
  ASSERT_TRUE(
      io::write_whole(folder / "t.json", R"({"schema":"etcs-train/1","name":")" + std::string(20000, 'x') + "\"}"));
  const Finished run =
      evc("run --train '" + (folder / "t.json") + "' -o '" + folder.path() + "' 2>&1 >/dev/full | cat");
  EXPECT_EQ(run.output, "standard output: found No space left on device, expected space for the whole file\n");
  EXPECT_EQ(json::parse(text_of(folder / "summary.json"))["output_hash"], sha256(text_of(folder / "outputs.jsonl")));
}

TEST(Run, ATrainThatCannotBeSupervisedIsToldBeforeTheDrive) {
  const Folder folder("train");
  ASSERT_TRUE(io::write_whole(folder / "t.json", R"({"schema":"etcs-train/1","max_speed_kmh":250})"));
  const Finished run = evc("run --train '" + (folder / "t.json") + "'");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.output, (folder / "t.json") +
                            ": /max_speed_kmh: found 250, expected at most 200 km/h with a brake percentage "
                            "(SUBSET-026 3.13.3.2.1 a)\n");
}

TEST(Replay, KeepsWhatTheUnitKeepsWithoutPower) {  // 3.18.2.7
  const Folder folder("persistent");
  const std::string file = folder / "kept.json";
  const std::string option = "' --persistent '" + file + "'";
  // The driver enters a level; at the power off it is kept.
  ASSERT_TRUE(io::write_whole(folder / "a.jsonl",
                              "{\"config\":{\"national_values\":{\"V_NVSTFF\":35}}}\n"
                              "{\"t_ms\":0,\"train\":{\"desk_open\":true}}\n"
                              "{\"t_ms\":500,\"driver\":{\"enter\":{\"driver_id\":1}}}\n"
                              "{\"t_ms\":1000,\"driver\":{\"enter\":{\"level\":\"1\"}}}\n"
                              "{\"t_ms\":2000,\"power\":{\"off\":true}}\n"));
  const Finished a = evc("replay '" + (folder / "a.jsonl") + option + " -o /dev/null");
  ASSERT_EQ(a.exit_code, 0) << a.output;
  const json kept = json::parse(text_of(file));
  EXPECT_EQ(kept["level"]["level"], "1");
  EXPECT_EQ(kept["national_values"]["V_NVSTFF"], 35);
  // The next program.
  ASSERT_TRUE(io::write_whole(folder / "b.jsonl", "{\"t_ms\":0,\"power\":{\"on\":true,\"moved\":false}}\n"));
  const Finished b = evc("replay '" + (folder / "b.jsonl") + option + " -o '" + (folder / "out.jsonl") + "'");
  ASSERT_EQ(b.exit_code, 0) << b.output;
  const json first = json::parse(text_of(folder / "out.jsonl"));
  EXPECT_EQ(first["level"], "1");
  EXPECT_EQ(first["level_valid"], true);
  EXPECT_EQ(json::parse(text_of(file))["national_values"]["V_NVSTFF"], 35);
}

TEST(Replay, TellsWhatIsWrongInTheFileOfWhatIsKept) {
  const Folder folder("persistent_faults");
  const std::string file = folder / "kept.json";
  ASSERT_TRUE(io::write_whole(folder / "in.jsonl", "{\"t_ms\":0}\n{\"t_ms\":\n"));
  const auto told = [&](const std::string& name) {
    const Finished replay = evc("replay '" + (folder / "in.jsonl") + "' --persistent '" + name + "'");
    EXPECT_EQ(replay.exit_code, 2);
    return replay.output;
  };
  const std::string other = R"({"schema":"etcs-train/1"})";
  ASSERT_TRUE(io::write_whole(file, other));
  EXPECT_EQ(told(file), file +
                            ": /schema: found \"etcs-train/1\" (a train: evc run --train reads it), expected "
                            "\"evc-persistent/1\"\n");
  EXPECT_EQ(text_of(file), other);
  EXPECT_EQ(told(folder / "no/kept.json"),
            (folder / "no") + ": found No such file or directory, expected a folder that can be written\n");
  EXPECT_EQ(told("-"), "-: found standard input, expected a file\n");
  EXPECT_EQ(told(folder / "in.jsonl"),
            (folder / "in.jsonl") + ": found the input, expected another file for the output\n");
  EXPECT_EQ(told(folder.path()), folder.path() + ": found a directory, expected a file that can be read\n");
  // After an error of the stream nothing is written.
  EXPECT_NE(told(folder / "new.json").find("line 2"), std::string::npos);
  EXPECT_EQ(text_of(folder / "new.json"), "");
}

TEST(Replay, TellsAFileOfAnotherKind) {
  const Folder folder("replay_kinds");
  const auto told = [&](const std::string& text) {
    EXPECT_TRUE(io::write_whole(folder / "in.json", text));
    const Finished replay = evc("replay '" + (folder / "in.json") + "' -o '" + (folder / "out.jsonl") + "'");
    EXPECT_EQ(replay.exit_code, 2);
    return replay.output.substr((folder / "in.json").size());
  };
  const std::string line =
      ": /schema: found \"etcs-line/1\" (a line: evc run drives it), expected a stream of inputs, as "
      "inputs.jsonl of evc run\n";
  EXPECT_EQ(told("{\n \"schema\": \"etcs-line/1\"\n}\n"), line);
  EXPECT_EQ(told("{\"schema\": \"etcs-line/1\"}\n"), line);
  EXPECT_EQ(told("{\n \"schema\": \"x\"\n}\n"), ": line 1 column 2: found the end of the text, expected JSON\n");
}

/// Every command says what a file of another kind is for.
TEST(Files, OfAnotherKind) {
  const Folder folder("kinds");
  ASSERT_TRUE(io::write_whole(folder / "d.json", R"({"schema":"evc-line-description/1"})"));
  ASSERT_TRUE(io::write_whole(folder / "l.json", R"({"schema":"etcs-line/1"})"));
  ASSERT_TRUE(io::write_whole(folder / "n.json", "{}"));
  ASSERT_TRUE(io::write_whole(folder / "in.jsonl", "{\"t_ms\":0}\n"));
  const auto refused = [&](const std::string& before, const char* file, const std::string& after = "") {
    const Finished run = evc(before + " '" + (folder / file) + "' " + after);
    EXPECT_EQ(run.exit_code, 2) << before;
    return run.output.substr(std::min((folder / file).size(), run.output.size()));
  };
  const std::string line =
      ": /schema: found \"evc-line-description/1\" (a description: evc make-line encodes it), expected "
      "\"etcs-line/1\"\n";
  EXPECT_EQ(refused("run", "d.json"), line);
  EXPECT_EQ(refused("check", "d.json"), line);
  EXPECT_EQ(refused("track --at 1", "d.json"), line);
  EXPECT_EQ(refused("run", "n.json"), ": /: found no key \"schema\", expected \"schema\": \"etcs-line/1\"\n");
  EXPECT_EQ(refused("make-line", "l.json"),
            ": /schema: found \"etcs-line/1\" (a line: evc run drives it), expected \"evc-line-description/1\"\n");
  EXPECT_EQ(refused("replay '" + (folder / "in.jsonl") + "' --config", "l.json"),
            ": /schema: found \"etcs-line/1\" (a line: evc run drives it), expected a configuration\n");
}

TEST(Replay, AStreamWithoutInputIsToldAndLeavesNothing) {
  const Folder folder("replay_empty");
  for (const char* text : {"", "\n \r\n\n", "{\"config\":{}}\n"}) {
    ASSERT_TRUE(io::write_whole(folder / "in.jsonl", text));
    const Finished replay = evc("replay '" + (folder / "in.jsonl") + "' -o '" + (folder / "out.jsonl") +
                                "' --persistent '" + (folder / "kept.json") + "'");
    EXPECT_EQ(replay.exit_code, 2) << text;
    EXPECT_EQ(replay.output, (folder / "in.jsonl") + ": found no input, expected a line with t_ms, as {\"t_ms\":0}\n");
    EXPECT_FALSE(std::filesystem::exists(folder / "out.jsonl"));
    EXPECT_FALSE(std::filesystem::exists(folder / "kept.json"));
  }
}

TEST(Replay, EndsAtALineThatDoesNotParseWithWholeOutputs) {
  const Folder folder("replay");
  ASSERT_TRUE(io::write_whole(folder / "in.jsonl", "{\"t_ms\":0,\"config\":{}}\n{\"t_ms\":100}\n{\"t_ms\":\n"));
  const Finished replay = evc("replay '" + (folder / "in.jsonl") + "' -o '" + (folder / "out.jsonl") + "'");
  EXPECT_EQ(replay.exit_code, 2);
  EXPECT_NE(replay.output.find("line 3"), std::string::npos) << replay.output;
  const std::string outputs = text_of(folder / "out.jsonl");
  ASSERT_FALSE(outputs.empty());
  EXPECT_EQ(outputs.back(), '\n');
  EXPECT_TRUE(json::accept(outputs.substr(0, outputs.find('\n'))));
}

}  // namespace
}  // namespace evc::run
