#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/test_paths.h"
#include "check/command.h"
#include "io/make_line.h"
#include "io/program_test.h"
#include "io/telegram_json.h"
#include "run/load.h"

// Defects planted in a copy of a line that has none.
namespace evc::check {
namespace {

using nlohmann::json;

const std::string kShipped = evc::test::source_folder() + "/data/lines/brunnental.json";
constexpr std::uint16_t kCountry = 1000;

/// The shipped line, its telegrams and messages as JSON. Its keys for readers are left out: the bits change.
class Copy {
 public:
  Copy() : line_(json::parse(text_of(kShipped))) {
    for (json& group : line_["balise_groups"]) {
      for (const char* key : {"nid_c", "nid_bg", "position_m"}) group.erase(key);
      for (json& balise : group["balises"]) balise.erase("contains");
    }
    for (json& message : line_["rbc_messages"])
      for (const char* key : {"nid_message", "contains", "nid_lrbg"}) message.erase(key);
  }
  json& document() { return line_; }
  json& group(std::size_t g) { return line_["balise_groups"][g]; }
  json& balise(std::size_t g, std::size_t b) { return group(g)["balises"][b]; }
  json& message(std::size_t m) { return line_["rbc_messages"][m]; }

  void edit(std::size_t g, std::size_t b, const std::function<void(json&)>& change) {
    json& place = balise(g, b);
    std::string text;
    const auto bits = io::bits_of_hex(place["telegram_hex"].get<std::string>());
    ASSERT_TRUE(bits && io::append_balise_json(text, bits->bytes, place["telegram_bits"].get<std::size_t>()));
    json telegram = json::parse(text);
    telegram.erase("bits");
    telegram.erase("padding");
    change(telegram);
    forget_lengths(telegram);
    const auto encoded = io::encode_balise_json(telegram);
    ASSERT_TRUE(encoded) << encoded.error().why << " " << encoded.error().variable;
    place["telegram_hex"] = io::hex_of_bits(encoded->bytes, encoded->bits);
    place["telegram_bits"] = encoded->bits;
  }
  void edit_group(std::size_t g, const std::function<void(json&)>& change) {
    for (std::size_t b = 0; b < group(g)["balises"].size(); ++b) edit(g, b, change);
  }
  void edit_message(std::size_t m, const std::function<void(json&)>& change) {
    std::string text;
    const auto bits = io::bits_of_hex(message(m)["message_hex"].get<std::string>());
    ASSERT_TRUE(bits && io::append_radio_json(text, bits->bytes, lang::Direction::to_train, {2, 1}));
    json decoded = json::parse(text);
    change(decoded);
    decoded.erase("L_MESSAGE");
    decoded.erase("padding");
    forget_lengths(decoded);
    const auto encoded = io::encode_radio_json(decoded);
    ASSERT_TRUE(encoded) << encoded.error().why << " " << encoded.error().variable;
    message(m)["message_hex"] = io::hex_of_bits(encoded->bytes, encoded->bits);
    message(m)["message_bits"] = encoded->bits;
  }
  /// A variable of a telegram, by its place in the bits.
  void set_bits(std::size_t g, std::size_t b, std::size_t first, unsigned width, unsigned value) {
    auto bits = io::bits_of_hex(balise(g, b)["telegram_hex"].get<std::string>());
    ASSERT_TRUE(bits);
    for (unsigned i = 0; i < width; ++i) {
      const std::size_t at = first + i;
      const auto mask = static_cast<std::uint8_t>(0x80u >> (at % 8));
      if ((value >> (width - 1 - i) & 1u) != 0)
        bits->bytes[at / 8] = static_cast<std::uint8_t>(bits->bytes[at / 8] | mask);
      else
        bits->bytes[at / 8] = static_cast<std::uint8_t>(bits->bytes[at / 8] & ~mask);
    }
    balise(g, b)["telegram_hex"] = io::hex_of_bits(bits->bytes, bits->bits);
  }
  /// A group of its own behind group `g` in the file.
  void add_group(std::size_t after, double at_m, unsigned NID_BG) {
    json more = group(after);
    const double shift = at_m - more["balises"][0]["position_m"].get<double>();
    for (json& balise : more["balises"]) balise["position_m"] = balise["position_m"].get<double>() + shift;
    json& groups = line_["balise_groups"];
    groups.insert(groups.begin() + static_cast<std::ptrdiff_t>(after) + 1, more);
    edit_group(after + 1, [&](json& t) {
      t["header"]["NID_BG"] = NID_BG;
      t["packets"] = json::array();
    });
  }
  std::string text() const { return line_.dump(); }

 private:
  static void forget_lengths(json& telegram) {
    for (json& packet : telegram["packets"]) packet.erase("L_PACKET");
  }
  json line_;
};

json& packet(json& telegram, int NID_PACKET) {
  for (json& packet : telegram["packets"])
    if (packet["NID_PACKET"] == NID_PACKET) return packet;
  ADD_FAILURE() << "no packet " << NID_PACKET;
  return telegram;
}

Where group(double at_m, unsigned NID_BG) { return {at_m, GroupId{kCountry, static_cast<std::uint16_t>(NID_BG)}, {}}; }
Where message(double at_m, int seq) { return {at_m, {}, seq}; }
Where track(double at_m) { return {at_m, {}, {}}; }

std::string all(const Review& review) { return "\n" + table_of(review); }

/// The one finding of the review.
void expect(const std::string& text, Severity severity, const Where& where, const std::string& clause,
            const io::Train* train = nullptr) {
  const auto reviewed = review(text, "copy.json", train);
  ASSERT_TRUE(reviewed) << reviewed.error().text();
  ASSERT_EQ(reviewed->findings.all().size(), 1u) << all(*reviewed);
  const Finding& found = reviewed->findings.all().front();
  EXPECT_EQ(found.severity, severity) << all(*reviewed);
  EXPECT_EQ(found.where, where) << all(*reviewed);
  EXPECT_EQ(found.clause, clause) << all(*reviewed);
}

struct Plant {
  const char* name;
  std::function<void(Copy&)> plant;
  Severity severity;
  Where where;
  const char* clause;
};
void PrintTo(const Plant& plant, std::ostream* out) { *out << plant.name; }

using enum Severity;

json& link_to(json& telegram, int NID_BG) {
  json& linking = packet(telegram, 5);
  if (linking["NID_BG"] == NID_BG) return linking;
  for (json& link : linking["links"])
    if (link["NID_BG"] == NID_BG) return link;
  ADD_FAILURE() << "no link to " << NID_BG;
  return linking;
}

const std::vector<Plant> kPlants = {
    // Bits
    {"NoEndPacket", [](Copy& c) { c.balise(5, 0)["telegram_bits"] = 50; }, error, group(5990, 106), "7.3.3.5"},
    {"SpareCode", [](Copy& c) { c.set_bits(0, 0, 58 + 2 + 13, 2, 3); }, error, group(80, 101), "3.16.1.1.1"},
    {"PacketForAnotherMedium",
     [](Copy& c) {
       // Packet 140, for which only radio is allowed (7.4.2.34): from 57 on, Q_DIR 1, 55 bits.
       c.edit(5, 0, [](json& t) {
         t["packets"].push_back({{"NID_PACKET", 140}, {"Q_DIR", 1}, {"NID_OPERATIONAL", 7}});
       });
     },
     error, group(5990, 106), "7.3.3.10"},
    {"VersionX", [](Copy& c) { c.set_bits(5, 0, 1, 7, 0x41); }, error, group(5990, 106), "3.17.3.5"},
    {"MessageLength",
     [](Copy& c) {
       c.message(3)["message_hex"] = c.message(3)["message_hex"].get<std::string>() + "00";
       c.message(3).erase("message_bits");
     },
     error, message(15900, 3), "8.4.4.2.1"},
    // Header
    {"IdentityInTheGroup", [](Copy& c) { c.edit(5, 1, [](json& t) { t["header"]["NID_BG"] = 999; }); }, error,
     group(5993, 106), "3.4.1.1"},
    {"NumberTwice", [](Copy& c) { c.edit(5, 1, [](json& t) { t["header"]["N_PIG"] = 0; }); }, error, group(5993, 106),
     "3.4.1.3"},
    {"NumberAboveTheTotal", [](Copy& c) { c.edit(5, 1, [](json& t) { t["header"]["N_PIG"] = 2; }); }, error,
     group(5993, 106), "3.4.1.2"},
    {"TotalsDiffer", [](Copy& c) { c.edit(5, 1, [](json& t) { t["header"]["N_TOTAL"] = 2; }); }, error,
     group(5993, 106), "3.4.1.2"},
    {"ABaliseIsMissing", [](Copy& c) { c.edit_group(5, [](json& t) { t["header"]["N_TOTAL"] = 2; }); }, error,
     group(5990, 106), "3.16.2.1.3"},
    {"CountersDiffer", [](Copy& c) { c.edit(5, 1, [](json& t) { t["header"]["M_MCOUNT"] = 77; }); }, error,
     group(5993, 106), "3.16.2.4.7"},
    {"Spacing", [](Copy& c) { c.balise(5, 1)["position_m"] = 6003.0; }, error, group(6003, 106), "SUBSET-040 4.1.1.2"},
    {"IdentityOfTwoGroups", [](Copy& c) { c.add_group(36, 40000.0, 137); }, error, group(40000, 137), "3.4.1.1"},
    {"ASingleUnlinkedBalise",
     [](Copy& c) {
       c.add_group(36, 40000.0, 900);
       c.group(37)["balises"].erase(1);
       c.edit(37, 0, [](json& t) {
         t["header"]["N_TOTAL"] = 0;
         t["header"]["Q_LINK"] = 0;
       });
     },
     error, group(40000, 900), "3.4.4.3.2"},
    {"OrderInTheFile", [](Copy& c) { std::swap(c.group(35), c.group(36)); }, warning, group(39850, 137),
     "docs/line.md"},
    // Messages
    {"OneNumberTwice", [](Copy& c) { c.message(3)["seq"] = 2; }, error, message(15900, 2), "docs/line.md"},
    {"LrbgNotOnTheLine", [](Copy& c) { c.edit_message(3, [](json& m) { m["NID_LRBG"] = kCountry * 16384 + 999; }); },
     error, message(15900, 3), "3.6.2.2.1"},
    {"LrbgNotPassed", [](Copy& c) { c.edit_message(3, [](json& m) { m["NID_LRBG"] = kCountry * 16384 + 120; }); },
     error, message(15900, 3), "3.6.2.2.2 b"},
    {"RevocationOfNothing", [](Copy& c) { c.edit_message(3, [](json& m) { packet(m, 66)["NID_TSR"] = 77; }); }, warning,
     message(15900, 3), "3.11.5.5"},
    {"StopAlreadyPassed",
     [](Copy& c) {
       c.edit_message(3, [](json& m) {
         m = {{"NID_MESSAGE", 15},    {"T_TRAIN", 0},
              {"M_ACK", 0},           {"NID_LRBG", m["NID_LRBG"]},
              {"NID_EM", 1},          {"Q_SCALE", 1},
              {"D_REF", 0},           {"Q_DIR", 1},
              {"D_EMERGENCYSTOP", 5}, {"packets", json::array()}};
       });
     },
     note, message(15900, 3), "3.10.2.2 a"},
    // Linking
    {"LinkingDistance",
     [](Copy& c) {
       c.edit_message(1, [](json& m) { link_to(m, 107)["D_LINK"] = 1080; });  // 20 m more
     },
     error, message(5300, 1), "3.4.4.4.3.2"},
    {"LinkingDistanceInsideTheAccuracy",
     [](Copy& c) { c.edit_message(1, [](json& m) { link_to(m, 107)["D_LINK"] = 1063; }); }, warning, message(5300, 1),
     "3.4.4.2.1"},
    {"WindowsOverlap",
     [](Copy& c) {
       c.add_group(33, 37025.0, 900);  // 40 m behind group 134
       c.edit_message(8, [](json& m) {
         json& links = packet(m, 5)["links"];
         for (std::size_t i = 0; i < links.size(); ++i)
           if (links[i]["NID_BG"] == 135) {
             json more = links[i];
             more["NID_BG"] = 900;
             more["D_LINK"] = 40;
             more["Q_LOCACC"] = 36;
             links[i]["D_LINK"] = links[i]["D_LINK"].get<int>() - 40;
             links.insert(links.begin() + static_cast<std::ptrdiff_t>(i), more);
             return;
           }
         ADD_FAILURE() << "no link to 135";
       });
     },
     error, message(34300, 8), "3.4.4.4.3.1"},
    {"LinkOrientation", [](Copy& c) { c.edit_message(1, [](json& m) { link_to(m, 107)["Q_LINKORIENTATION"] = 0; }); },
     error, message(5300, 1), "3.4.4.4.7"},
    {"LinkToNoGroup", [](Copy& c) { c.edit_message(1, [](json& m) { link_to(m, 109)["NID_BG"] = 555; }); }, error,
     message(5300, 1), "3.4.4.2.1"},
    {"GroupNotAnnounced", [](Copy& c) { c.add_group(5, 6500.0, 900); }, warning, group(6500, 900), "3.4.4.4.2"},
    // Authorities
    {"SpeedProfileTooShort",
     [](Copy& c) {
       c.edit_message(5, [](json& m) {
         json& step = packet(m, 27)["steps"].back();
         step["D_STATIC"] = step["D_STATIC"].get<int>() - 300;
       });
     },
     error, message(23400, 5), "3.7.2.3"},
    {"GradientProfileTooShort",
     [](Copy& c) {
       c.edit_message(5, [](json& m) {
         json& step = packet(m, 21)["steps"].back();
         step["D_GRADIENT"] = step["D_GRADIENT"].get<int>() - 300;
       });
     },
     error, message(23400, 5), "3.7.2.3"},
    {"EndBehindTheTrain", [](Copy& c) { c.edit_message(8, [](json& m) { packet(m, 15)["L_ENDSECTION"] = 50; }); },
     error, message(34300, 8), "3.8.1.1 a"},
    {"SectionTimerStopsBeyondItsSection",
     [](Copy& c) {
       c.edit_message(5, [](json& m) {
         json& ma = packet(m, 15);
         ma["Q_SECTIONTIMER"] = 1;
         ma["T_SECTIONTIMER"] = 1023;
         ma["D_SECTIONTIMERSTOPLOC"] = ma["L_ENDSECTION"].get<int>() + 50;
       });
     },
     error, message(23400, 5), "3.8.3.4"},
    {"SectionTimerTooShort",
     [](Copy& c) {
       c.edit_message(5, [](json& m) {
         json& ma = packet(m, 15);
         ma["Q_SECTIONTIMER"] = 1;
         ma["T_SECTIONTIMER"] = 10;
         ma["D_SECTIONTIMERSTOPLOC"] = ma["L_ENDSECTION"].get<int>() - 50;
       });
     },
     warning, message(23400, 5), "3.8.4.2.2"},
    {"EndTimerStartsBeforeTheEndSection",
     [](Copy& c) {
       c.edit_message(5, [](json& m) {
         json& ma = packet(m, 15);
         ma["Q_ENDTIMER"] = 1;
         ma["T_ENDTIMER"] = 100;
         ma["D_ENDTIMERSTARTLOC"] = ma["L_ENDSECTION"].get<int>() + 50;
       });
     },
     error, message(23400, 5), "3.8.4.1.1"},
    {"InfillForNoGroup",
     [](Copy& c) {
       c.edit(3, 0, [](json& t) {
         t["packets"].push_back({{"NID_PACKET", 136}, {"Q_DIR", 1}, {"Q_NEWCOUNTRY", 0}, {"NID_BG", 555}});
       });
     },
     error, group(3900, 104), "3.6.2.3.1"},
    // Level: "stop if in SR" in level NTC
    {"RejectedByTheLevel",
     [](Copy& c) {
       c.edit(36, 0, [](json& t) { t["packets"].push_back({{"NID_PACKET", 137}, {"Q_DIR", 1}, {"Q_SRSTOP", 1}}); });
     },
     warning, group(39850, 137), "4.8.3"},
    // The track, and what the file says about its bits
    {"TrackWithoutGradient",
     [](Copy& c) {
       json& first = c.document()["physical_track"]["gradient"][0];
       first["end_m"] = first["end_m"].get<double>() - 10.0;
     },
     warning, track(890), "docs/line.md"},
    {"TrackWithTwoGradients",
     [](Copy& c) {
       json& first = c.document()["physical_track"]["gradient"][0];
       first["end_m"] = first["end_m"].get<double>() + 10.0;
     },
     error, track(900), "docs/line.md"},
    {"DescribedIdentity",
     [](Copy& c) {
       c.group(5)["nid_bg"] = 105;
       c.balise(5, 1).erase("telegram_hex");
       c.edit(5, 0, [](json& t) { t["header"]["N_TOTAL"] = 0; });
     },
     error, group(5990, 106), "docs/line.md"},
    {"DescribedPackets", [](Copy& c) { c.balise(5, 0)["contains"] = {"3 National values"}; }, error, group(5990, 106),
     "docs/line.md"},
    {"DescribedByAText", [](Copy& c) { c.balise(5, 0)["n_pig"] = "0"; }, error, group(5990, 106), "docs/line.md"},
    {"DescribedByAnObject", [](Copy& c) { c.message(3)["nid_message"] = json::object(); }, error, message(15900, 3),
     "docs/line.md"},
    {"DescribedPacketsAreNoList", [](Copy& c) { c.balise(5, 0)["contains"] = 3; }, error, group(5990, 106),
     "docs/line.md"},
    {"DescribedPlaceIsNoNumber", [](Copy& c) { c.group(5)["position_m"] = true; }, error, group(5990, 106),
     "docs/line.md"},
    {"DescribedField",
     [](Copy& c) {
       c.message(3)["packets"] = {{{"nid_packet", 66}, {"fields", {{"Q_DIR", 1}, {"NID_TSR", 200}}}}};
     },
     error, message(15900, 3), "docs/line.md"},
};

class Planted : public testing::TestWithParam<Plant> {};

TEST_P(Planted, IsTheOnlyFinding) {
  const Plant& plant = GetParam();
  Copy copy;
  plant.plant(copy);
  expect(copy.text(), plant.severity, plant.where, plant.clause);
}

INSTANTIATE_TEST_SUITE_P(Check, Planted, testing::ValuesIn(kPlants),
                         [](const auto& plant) { return std::string(plant.param.name); });

TEST(Check, ACopyWithoutADefectHasNone) {
  const auto reviewed = review(Copy().text(), "copy.json", nullptr);
  ASSERT_TRUE(reviewed);
  EXPECT_TRUE(reviewed->findings.all().empty()) << all(*reviewed);
}

TEST(Check, TheShippedLineHasNoneWithAnyShippedTrain) {
  for (const auto& entry : std::filesystem::directory_iterator(evc::test::source_folder() + "/data/trains")) {
    const auto train = run::load_train(entry.path().string());
    ASSERT_TRUE(train) << train.error().text();
    const auto reviewed = review(text_of(kShipped), kShipped, &*train);
    ASSERT_TRUE(reviewed);
    EXPECT_TRUE(reviewed->findings.all().empty()) << entry.path() << all(*reviewed);
  }
}

/// Linking of an infill counts from the infill group (3.6.2.3.1): what is announced up to there stays announced, the
/// group itself too (3.7.3.1).
TEST(Check, TheExampleOfThePageHasNone) {
  const std::string page = text_of(evc::test::source_folder() + "/docs/line.md"), fence = "```json\n";
  const std::size_t from = page.find(fence) + fence.size();
  const auto reviewed = review(page.substr(from, page.find("```", from) - from), "docs/line.md", nullptr);
  ASSERT_TRUE(reviewed) << reviewed.error().text();
  EXPECT_TRUE(reviewed->findings.all().empty()) << all(*reviewed);
}

TEST(Check, LinkingOfAnInfill) {
  const json authority = {{"authority", {{"to_m", 3000.0}, {"danger_point_m", 3050.0}, {"release_kmh", 20}}}};
  const json further = {{"authority", {{"to_m", 4000.0}, {"danger_point_m", 4050.0}, {"release_kmh", 20}}}};
  const json description = {{"schema", "evc-line-description/1"},
                            {"name", "infill"},
                            {"NID_C", 1000},
                            {"length_m", 4000},
                            {"start", {{"front_m", -40}, {"level", "1"}}},
                            {"gradient", {{-200, 4200, 0}}},
                            {"ssp", {{-200, 4200, 100}}},
                            {"groups",
                             {{{"NID_BG", 1}, {"at_m", 80}, {"orders", {authority}}},
                              {{"NID_BG", 2}, {"at_m", 1200}, {"orders", {{{"infill", 3}}, further}}},
                              {{"NID_BG", 3}, {"at_m", 2000}},
                              {{"NID_BG", 4}, {"at_m", 2900}},
                              {{"NID_BG", 5}, {"at_m", 3600}}}},
                            {"radio", json::array()}};
  const auto line = io::make_line(description.dump(), "infill");
  ASSERT_TRUE(line) << line.error().text();
  const auto reviewed = review(*line, "infill", nullptr);
  ASSERT_TRUE(reviewed);
  EXPECT_TRUE(reviewed->findings.all().empty()) << all(*reviewed);
}

/// Message 5 arrives at 23400 m, where the train accelerates beyond 50 km/h, 420 m behind its LRBG; a restriction to
/// 40 km/h begins 80 m ahead.
TEST(Check, ARestrictionTooLateForTheBrakes) {
  Copy copy;
  copy.edit_message(5, [](json& m) {
    m["packets"].push_back({{"NID_PACKET", 65},
                            {"Q_DIR", 1},
                            {"Q_SCALE", 1},
                            {"NID_TSR", 9},
                            {"D_TSR", 500},
                            {"L_TSR", 500},
                            {"Q_FRONT", 1},
                            {"V_TSR", 8}});
  });
  const auto train = run::load_train("");
  ASSERT_TRUE(train);
  expect(copy.text(), error, message(23400, 5), "3.13.1.1", &*train);
  const auto without = review(copy.text(), "copy.json", nullptr);
  ASSERT_TRUE(without);
  EXPECT_TRUE(without->findings.all().empty()) << "without a train it is no defect" << all(*without);
}

/// What an independent program finds in the bits of the recorded line: links to a group that is not there, and
/// emergency stops that the train had passed already.
TEST(Check, TheRecordedLine) {
  const std::string file = evc::test::shared_folder() + "/lines/amsterdam_utrecht.json";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "needs " << file;
  const auto reviewed = review(text_of(file), file, nullptr);
  ASSERT_TRUE(reviewed);
  std::size_t links = 0, stops = 0;
  for (const Finding& f : reviewed->findings.all()) {
    links += f.text.find("links group 426/0 ") != std::string::npos ? 1u : 0u;
    stops += f.text.find("already passed") != std::string::npos ? 1u : 0u;
  }
  EXPECT_EQ(links, 4u);
  EXPECT_EQ(stops, 39u);
  EXPECT_EQ(reviewed->findings.all().size(), links + stops) << all(*reviewed);
}

TEST(CheckCommand, ExitStatusAndForms) {
  const Ended sound = ended("check --train '" + evc::test::source_folder() + "/data/trains/standard.json'");
  EXPECT_EQ(sound.exit_code, 0) << sound.errors;
  EXPECT_EQ(sound.output, "Brunnental - Seehausen: 0 errors, 0 warnings, 0 notes\n");
  const Folder folder("check");
  Copy copy;
  copy.edit(5, 1, [](json& t) { t["header"]["N_PIG"] = 0; });
  ASSERT_TRUE(io::write_whole(folder / "wrong.json", copy.text()));
  const Ended wrong = ended("check '" + folder / "wrong.json" + "'");
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_NE(wrong.output.find("error       5993.0 m  group 1000/106"), std::string::npos) << wrong.output;
  const Ended listed = ended("check '" + folder / "wrong.json" + "' --format json");
  EXPECT_EQ(listed.exit_code, 1);
  const json document = json::parse(listed.output);
  EXPECT_EQ(document["schema"], "evc-check/1");
  EXPECT_EQ(document["errors"], 1);
  const json& finding = document["findings"].at(0);
  EXPECT_EQ(finding["severity"], "error");
  EXPECT_EQ(finding["at_m"], 5993.0);
  EXPECT_EQ(finding["group"], (json{{"NID_C", 1000}, {"NID_BG", 106}}));
  EXPECT_EQ(finding["clause"], "3.4.1.3");
  copy = Copy();
  copy.group(36)["balises"][0]["telegram_hex"] = "90";
  ASSERT_TRUE(io::write_whole(folder / "short.json", copy.text()));
  EXPECT_EQ(ended("check '" + folder / "short.json" + "'").exit_code, 2) << "telegram_bits beyond the digits";
}

TEST(CheckCommand, WrongInputIsRefused) {
  const Folder folder("check_wrong");
  const auto refused = [&](const std::string& arguments, const char* text) {
    const Ended e = ended("check " + arguments);
    EXPECT_EQ(e.exit_code, 2) << arguments;
    EXPECT_NE(e.errors.find(text), std::string::npos) << e.errors;
    EXPECT_EQ(e.output, "");
  };
  refused("'" + folder / "none.json" + "'", "none.json");
  ASSERT_TRUE(
      io::write_whole(folder / "l.json", R"({"schema":"etcs-line/1","name":"x","length_m":1,"balise_groups":[]})"));
  refused("'" + folder / "l.json" + "'", "/balise_groups: found 0 groups");
  refused("--train '" + folder / "l.json" + "'", "etcs-train/1");
  refused("--format csv", "--format");
  // Half a header is a telegram that does not decode, not wrong input.
  Copy copy;
  copy.balise(36, 1)["telegram_bits"] = 20;
  ASSERT_TRUE(io::write_whole(folder / "half.json", copy.text()));
  EXPECT_EQ(ended("check '" + folder / "half.json" + "'").exit_code, 1);
  // Keys for readers may have any type.
  copy = Copy();
  copy.balise(5, 0)["packets"] = {1, "two", nullptr, {{"nid_packet", "x"}, {"fields", 3}}};
  copy.balise(5, 0)["header"] = 7;
  copy.message(3)["fields"] = json::array({1});
  copy.message(3)["nid_lrbg"] = "x";
  EXPECT_TRUE(review(copy.text(), "copy.json", nullptr)->findings.all().empty())
      << all(*review(copy.text(), "copy.json", nullptr));
}

}  // namespace
}  // namespace evc::check
