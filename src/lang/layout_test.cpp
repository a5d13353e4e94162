// The declarations of packets, messages and variables against the reference data, field by field.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "base/test_paths.h"
#include "lang/layouts.h"
#include "lang/message_table.h"
#include "lang/variable_table.h"

namespace evc::lang {
namespace {

using Json = nlohmann::json;

Json reference(const std::string& name) {
  std::ifstream file(evc::test::source_folder() + "/tests/reference/" + name + ".json");
  return Json::parse(file);
}

std::string text_of_test(const std::string& variable, const Test& test) {
  std::string text;
  for (std::uint8_t i = 0; i < test.count; ++i)
    text += (i > 0 ? " || " : "") + variable + (test.negated ? " != " : " == ") + std::to_string(test.codes[i]);
  return text;
}

/// Steps [from, to) of a list in the form of the reference data.
Json json_of(std::span<const Step> steps, std::size_t from, std::size_t to) {
  Json out = Json::array();
  const auto width_of = [](const char* variable) { return find_variable(variable)->bits; };
  for (std::size_t i = from; i < to; ++i) {
    const Step& s = steps[i];
    switch (s.kind) {
      case Step::Kind::field: {
        Json e{{"var", s.variable}};
        if (std::string(s.name) != s.variable) e["as"] = s.name;
        EXPECT_EQ(s.bits, width_of(s.variable));
        out.push_back(e);
        break;
      }
      case Step::Kind::when:
      case Step::Kind::when_around: {
        const std::string looked_at = s.kind == Step::Kind::when ? steps[s.condition].name : s.variable;
        out.push_back({{"if", text_of_test(looked_at, s.test)}, {"then", json_of(steps, i + 1, i + 1u + s.count)}});
        i += s.count;
        break;
      }
      case Step::Kind::repeat: {
        Json counter{{"var", s.variable}};
        if (std::string(s.counter) != s.variable) counter["as"] = s.counter;
        EXPECT_EQ(s.bits, width_of(s.variable));
        EXPECT_EQ(s.capacity, all_ones(s.bits));
        out.push_back(counter);
        out.push_back({{"repeat", s.counter}, {"name", s.name}, {"body", json_of(s.element(), 0, s.element().size())}});
        break;
      }
      case Step::Kind::rest:
        out.push_back({{"rest_of_packet", true}, {"as", s.name}});
        break;
    }
  }
  return out;
}

Versions versions_of(const Json& sv) {
  Versions v = 0;
  for (const Json& x : sv)
    v |= known_version({static_cast<std::uint8_t>(x.get<std::string>()[0] - '0'),
                        static_cast<std::uint8_t>(x.get<std::string>()[2] - '0')});
  return v;
}
Media media_of(const Json& list) {
  Media m = 0;
  for (const Json& x : list)
    m = static_cast<Media>(m | (x == "balise" ? media::balise
                                : x == "loop" ? media::loop
                                : x == "RBC"  ? media::RBC
                                              : media::RIU));
  return m;
}

void compare_packets(const char* file, Direction direction) {
  const Json data = reference(file);
  std::set<const PacketLayout*> met;
  for (const Json& p : data.at("packets")) {
    SCOPED_TRACE(p.at("id").dump() + " " + p.at("sv").dump());
    const Versions versions = versions_of(p.at("sv"));
    const PacketLayout* layout = nullptr;
    for (Versions v = 1; v <= v3_0; v = static_cast<Versions>(v * 2))
      if ((versions & v) != 0) {
        const PacketLayout* found = find_packet_layout(direction, v, p.at("id").get<std::uint8_t>());
        ASSERT_NE(found, nullptr);
        EXPECT_TRUE(layout == nullptr || layout == found);
        layout = found;
      }
    met.insert(layout);
    EXPECT_EQ(layout->info->versions, versions);
    EXPECT_EQ(layout->info->direction, direction);
    EXPECT_EQ(layout->info->name, p.at("name").get<std::string>());
    EXPECT_EQ(layout->info->ref, p.at("ref").get<std::string>());
    EXPECT_EQ(layout->info->note, p.value("note", ""));
    EXPECT_EQ(layout->info->media, media_of(p.at("media")));
    Json steps = json_of(layout->steps, 0, layout->steps.size());
    // NID_PACKET and L_PACKET are not stored.
    std::size_t place = 0;
    steps.insert(steps.begin(), Json{{"var", "NID_PACKET"}});
    place = layout->has_direction ? 2 : 1;
    if (layout->has_length) steps.insert(steps.begin() + static_cast<std::ptrdiff_t>(place), Json{{"var", "L_PACKET"}});
    EXPECT_EQ(steps, p.at("elements"));
  }
  std::size_t ours = 0;
  for (const PacketLayout& l : packet_layouts())
    if (l.info->direction == direction) ++ours;
  EXPECT_EQ(ours, met.size());
  EXPECT_EQ(ours, data.at("packets").size());
}
TEST(Layouts, PacketsToTrain) { compare_packets("packets_to_train", Direction::to_train); }
TEST(Layouts, PacketsToTrack) { compare_packets("packets_to_track", Direction::to_track); }

std::vector<int> numbers(std::span<const std::uint8_t> list) { return {list.begin(), list.end()}; }

void compare_messages(const char* file, Direction direction) {
  const Json data = reference(file);
  std::size_t rows = 0;
  for (const Json& m : data.at("messages")) {
    SCOPED_TRACE(m.at("id").dump() + " " + m.at("sv").dump());
    const auto id = m.at("id").get<std::uint8_t>();
    for (const Json& sv : m.at("sv")) {
      const SystemVersion version{static_cast<std::uint8_t>(sv.get<std::string>()[0] - '0'),
                                  static_cast<std::uint8_t>(sv.get<std::string>()[2] - '0')};
      const MessageRules* rules = find_message_rules(direction, id, version);
      ASSERT_NE(rules, nullptr);
      EXPECT_EQ(rules->versions, versions_of(m.at("sv")));
      EXPECT_EQ(rules->name, m.at("name").get<std::string>());
      EXPECT_EQ(rules->ref, m.at("ref").get<std::string>());
      EXPECT_EQ(rules->note, m.value("note", ""));
      EXPECT_EQ(rules->priority, m.at("priority").get<std::string>());
      EXPECT_EQ(rules->version_invariant, m.at("version_invariant").get<bool>());
      EXPECT_EQ(rules->media, media_of(m.at("media")));
      EXPECT_EQ(Json(numbers(rules->optional)), m.at("optional_packets"));
      if (m.contains("optional_packets_by_sender")) {
        EXPECT_EQ(Json(numbers(rules->optional_from_rbc)), m.at("optional_packets_by_sender").at("RBC"));
        EXPECT_EQ(Json(numbers(rules->optional_from_riu)), m.at("optional_packets_by_sender").at("RIU"));
      }
      const MessageLayout* layout = find_message_layout(direction, version, id);
      ASSERT_NE(layout, nullptr);
      Json steps = json_of(layout->steps, 0, layout->steps.size());
      steps.insert(steps.begin(), Json{{"var", "L_MESSAGE"}});
      steps.insert(steps.begin(), Json{{"var", "NID_MESSAGE"}});
      for (const auto& one_of : rules->required) {
        if (one_of.size() == 1) steps.push_back({{"packet", one_of[0]}});
        if (one_of.size() > 1) steps.push_back({{"packet_one_of", numbers(one_of)}});
      }
      EXPECT_EQ(steps, m.at("elements"));
    }
    ++rows;
  }
  std::size_t ours = 0;
  for (const MessageRules& m : message_rules())
    if (m.direction == direction) ++ours;
  EXPECT_EQ(ours, rows);
}
TEST(Layouts, MessagesToTrain) { compare_messages("messages_to_train", Direction::to_train); }
TEST(Layouts, MessagesToTrack) { compare_messages("messages_to_track", Direction::to_track); }

std::map<std::string, std::string> texts(std::span<const Meaning> list) {
  std::map<std::string, std::string> out;
  for (const Meaning& m : list) out[std::to_string(m.code)] = m.text;
  return out;
}
std::map<std::string, std::string> texts(const Json& j) {
  return j.is_null() ? std::map<std::string, std::string>{} : j.get<std::map<std::string, std::string>>();
}

TEST(Layouts, Variables) {
  const Json data = reference("variables");
  ASSERT_EQ(variables().size(), data.at("variables").size());
  std::set<std::string> names;
  for (const VariableInfo& v : variables()) names.insert(v.name);
  EXPECT_EQ(names.size(), 243u);
  for (const auto& [key, v] : data.at("variables").items()) {
    SCOPED_TRACE(key);
    const VariableInfo* info = find_variable(key.c_str());
    ASSERT_NE(info, nullptr);
    EXPECT_EQ(info->key, key);
    EXPECT_EQ(info->name, v.at("name").get<std::string>());
    EXPECT_EQ(info->bits, v.at("bits").get<unsigned>());
    EXPECT_EQ(info->is_signed, v.at("signed").get<bool>());
    EXPECT_EQ(info->unit, v.at("unit").is_null() ? "" : v.at("unit").get<std::string>());
    const Json& resolution = v.at("resolution");
    EXPECT_EQ(info->by_scale, resolution == "Q_SCALE");
    EXPECT_EQ(info->resolution, resolution.is_number() ? resolution.get<double>() : 0.0);
    EXPECT_EQ(info->versions, versions_of(v.at("sv")));
    EXPECT_EQ(texts(info->special), texts(v.value("special", Json())));
    if (!v.contains("table") || v.at("table").empty() || info->kind == Kind::enumeration) {
      if (!v.contains("table")) {
        EXPECT_EQ(texts(info->codes), texts(v.value("enum", Json())));
      }
    }
    EXPECT_EQ(texts(info->bit_meanings), texts(v.value("bits_meaning", Json())));
    std::vector<std::pair<std::uint64_t, std::uint64_t>> spare, expected;
    for (const Range& r : info->spare)
      if (r.first <= r.last) spare.emplace_back(r.first, r.last);
    for (const Json& r : v.at("spare")) expected.emplace_back(r[0].get<std::uint64_t>(), r[1].get<std::uint64_t>());
    EXPECT_EQ(spare, expected);
    std::map<std::string, double> table;
    for (const CodeNumber& n : info->numbers) table[std::to_string(n.code)] = n.number;
    EXPECT_EQ(table, (v.contains("table") ? v.at("table").get<std::map<std::string, double>>()
                                          : std::map<std::string, double>{}));
    EXPECT_EQ(info->ref, v.at("ref").get<std::string>());
    EXPECT_EQ(info->about, v.value("comment", ""));
    EXPECT_EQ(info->note, v.value("note", ""));
    // The greatest ordinary code, where it separates values from special codes.
    if (info->kind != Kind::enumeration && info->kind != Kind::bitset && info->kind != Kind::table &&
        !info->is_signed && v.at("max").get<std::uint64_t>() != all_ones(info->bits)) {
      EXPECT_EQ(info->max, v.at("max").get<std::uint64_t>());
    }
  }
}

}  // namespace
}  // namespace evc::lang
