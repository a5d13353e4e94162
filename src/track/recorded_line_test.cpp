#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "base/test_paths.h"
#include "lang/decode.h"
#include "lang/messages.h"
#include "lang/si.h"
#include "track/from_packets.h"
#include "track/testing.h"
#include "track/withdraw.h"

// The radio messages of a recorded run, decoded from their bits and stored in order.
namespace evc::track {
namespace {

using namespace testing;
using nlohmann::json;

std::optional<json> recorded_line() {
  std::ifstream file(evc::test::shared_folder() + "/lines/amsterdam_utrecht.json");
  if (!file) return std::nullopt;
  return json::parse(file);
}
std::vector<std::uint8_t> bytes_of(const std::string& hex) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(hex.substr(i, 2), nullptr, 16)));
  return bytes;
}

/// Places of the groups, and the orientation in which the train passes them: rising N_PIG along the run is nominal.
struct Groups {
  std::map<std::uint32_t, double> place;
  std::map<std::uint32_t, Direction> orientation;
  std::map<std::uint32_t, bool> linked_reverse;
};
Groups groups_of(const json& line) {
  Groups g;
  for (const json& group : line["balise_groups"]) {
    const json& balises = group["balises"];
    std::uint32_t id = 0;
    std::map<unsigned, double> by_pig;
    for (const json& balise : balises) {
      const auto bytes = bytes_of(balise["telegram_hex"]);
      const auto view = lang::scan_telegram(bytes, balise["telegram_bits"].get<std::size_t>());
      EXPECT_EQ(view.fault, lang::Fault::none);
      id = (std::uint32_t{view.NID_C.raw} << 14) | view.NID_BG.raw;
      by_pig[view.N_PIG.raw] = balise["position_m"];
    }
    g.place[id] = by_pig.begin()->second;
    if (by_pig.size() > 1)
      g.orientation[id] = by_pig.begin()->second < by_pig.rbegin()->second ? Direction::nominal : Direction::reverse;
  }
  return g;
}

TEST(RecordedLine, EveryMovementAuthorityIsAcceptedAndCovered) {
  const std::optional<json> line = recorded_line();
  if (!line) GTEST_SKIP() << "the recorded line is not here (OPENEVC_SHARED)";
  Groups groups = groups_of(*line);
  Description d;
  int messages = 0, authorities = 0;
  double previous_end = 0;
  for (const json& m : (*line)["rbc_messages"]) {
    if (m.contains("missing_raw")) continue;
    const auto bytes = bytes_of(m["message_hex"]);
    const auto view = lang::scan_message_to_train(bytes, {1, 0});
    ASSERT_EQ(view.fault, lang::Fault::none) << "seq " << m["seq"];
    ++messages;
    const double front = m["trigger"]["position_m"];
    Contents c;
    c.medium = Medium::rbc;
    c.time = Duration{static_cast<double>(view.T_TRAIN.raw) / 100.0};
    Reference r;
    r.medium = Medium::rbc;
    r.place = at(groups.place.at(view.NID_LRBG.raw));
    if (groups.orientation.count(view.NID_LRBG.raw)) r.orientation = groups.orientation.at(view.NID_LRBG.raw);
    r.group = {static_cast<std::uint16_t>(view.NID_LRBG.raw >> 14),
               static_cast<std::uint16_t>(view.NID_LRBG.raw & 0x3FFF)};
    for (const auto& packet : view.packets) {
      const Added added = add(c, packet, r);
      EXPECT_NE(added, Added::faulty) << "seq " << m["seq"] << " packet " << packet.NID_PACKET;
      EXPECT_NE(added, Added::other_direction) << "seq " << m["seq"] << " packet " << packet.NID_PACKET;
    }
    EXPECT_TRUE(c.lost.empty());
    const Here here = front_at(front, 10.0);
    EXPECT_FALSE(advance(d, here).any());
    const Stored stored = store(d, c, here);
    if (view.NID_MESSAGE == 15) {
      lang::Message15 stop;
      ASSERT_EQ(lang::decode(view, stop), lang::Fault::none);
      const std::optional<Place> place = stop_location(stop, r);
      ASSERT_TRUE(place) << "seq " << m["seq"];
      EXPECT_NEAR(place->from_origin.si, m["stop_location_m"].get<double>(), 4.5) << "seq " << m["seq"];
      EXPECT_GT(front, place->from_origin.si + 10.0) << "passed already, seq " << m["seq"];
    }
    if (view.NID_MESSAGE != 3) continue;
    ++authorities;
    EXPECT_TRUE(stored.ma_accepted) << "seq " << m["seq"];
    EXPECT_FALSE(stored.shortened) << "seq " << m["seq"];
    EXPECT_TRUE(complete(d, here)) << "seq " << m["seq"];
    // The end agrees with the decoded fields of the recording.
    double length = 0;
    for (const json& p : m["packets"])
      if (p["nid_packet"] == 15) {
        const double scale = p["fields"]["Q_SCALE"] == 0 ? 0.1 : p["fields"]["Q_SCALE"] == 1 ? 1.0 : 10.0;
        for (const json& s : p["fields"]["iter"]) length += s["L_SECTION"].get<double>() * scale;
        length += p["fields"]["L_ENDSECTION"].get<double>() * scale;
      }
    EXPECT_NEAR((d.ma->end() - r.place).si, length, 1e-9) << "seq " << m["seq"];
    EXPECT_GE(d.ma->end().from_origin.si, previous_end - 1.0) << "seq " << m["seq"];
    previous_end = d.ma->end().from_origin.si;
    EXPECT_EQ(d.ma->release().kind, ReleaseSpeedChoice::national) << "seq " << m["seq"];
    const Mrsp f = mrsp(d, MrspQuery{at(front - 400), Distance{200}, {2, 4, 0}, {}});
    EXPECT_LE(f.at(here.est_front), Speed{160 / 3.6});
    EXPECT_GT(f.at(here.est_front), Speed{});
  }
  EXPECT_EQ(messages, 57);
  EXPECT_EQ(authorities, 16);
}

TEST(RecordedLine, GradientAndSpeedAreThoseOfTheTrack) {
  const std::optional<json> line = recorded_line();
  if (!line) GTEST_SKIP() << "the recorded line is not here (OPENEVC_SHARED)";
  Groups groups = groups_of(*line);
  Description d;
  std::map<int, Description> after;
  for (const json& m : (*line)["rbc_messages"]) {
    if (m.contains("missing_raw")) continue;
    const auto bytes = bytes_of(m["message_hex"]);
    const auto view = lang::scan_message_to_train(bytes, {1, 0});
    Contents c;
    Reference r;
    r.medium = Medium::rbc;
    r.place = at(groups.place.at(view.NID_LRBG.raw));
    r.orientation =
        groups.orientation.count(view.NID_LRBG.raw) ? groups.orientation.at(view.NID_LRBG.raw) : Direction::unknown;
    for (const auto& packet : view.packets) add(c, packet, r);
    const Here here = front_at(m["trigger"]["position_m"], 10.0);
    advance(d, here);
    store(d, c, here);
    after[m["seq"]] = d;
  }
  // Each stretch of track names the message that sent it.
  int checked = 0;
  for (const json& g : (*line)["physical_track"]["gradient"]) {
    const auto it = after.find(g["src_seq"].get<int>());
    if (it == after.end()) continue;
    const std::optional<Gradient> told = it->second.gradient.at(at(g["start_m"].get<double>() + 0.5));
    ASSERT_TRUE(told) << g;
    EXPECT_EQ(told->permille, g["gradient_permille"].get<int>()) << g;
    ++checked;
  }
  EXPECT_GT(checked, 50);
  checked = 0;
  for (const json& s : (*line)["physical_track"]["ssp"]) {
    if (!s.contains("src_seq")) continue;
    const auto it = after.find(s["src_seq"].get<int>());
    if (it == after.end()) continue;
    const std::optional<StaticSpeed> told = it->second.ssp.at(at(s["start_m"].get<double>() + 0.5));
    ASSERT_TRUE(told) << s;
    EXPECT_EQ(told->V_STATIC * 5, s["v_kmh"].get<int>()) << s;
    ++checked;
  }
  EXPECT_GT(checked, 3);
}

}  // namespace
}  // namespace evc::track
