#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <set>

#include "ways.h"

// The rules for the contents of telegrams and messages (8.4).
namespace evc::through_step {
namespace {

BitList packets(const std::vector<std::pair<unsigned, Codes>>& list, const std::string& sv = "2.1") {
  BitList bits;
  for (const auto& [id, codes] : list) put_packet(bits, *find_packet("to_train", id, sv), codes);
  return bits;
}
bool accepted_by_group(const std::vector<std::pair<unsigned, Codes>>& list, const char* start = kFS1,
                       const std::string& sv = "2.1") {
  OnBoard unit(OnBoard::after(start));
  const Answer answer = unit.pass(200, packets(list, sv), sv);
  const bool refused = !answer.event({"not decoded [3.16.1.1]"}).empty() || !answer.event({"inconsistent"}).empty();
  EXPECT_NE(refused, !answer.event({"group 200 accepted"}).empty()) << answer.text();
  return !refused;
}
/// `infill_unit`: of a radio infill unit.
bool accepted_by_message(unsigned NID_MESSAGE, const std::vector<std::pair<unsigned, Codes>>& list,
                         const Codes& codes = {}, const std::string& start = kFS2, bool infill_unit = false,
                         const std::string& sv = "2.1") {
  OnBoard unit(OnBoard::after(start));
  const Answer answer = unit.receive(NID_MESSAGE, codes, packets(list, sv), sv, infill_unit);
  return answer.event({"rejected [3.16.3.1.1]"}).empty();
}

/// Whether message NID_MESSAGE may have a packet behind its own ones (8.4.4.4.1), by the reference data and by the
/// unit.
void check_list(unsigned NID_MESSAGE, unsigned id, const std::string& sv, const std::string& sender) {
  const Json& row = *find_message("to_train", NID_MESSAGE, sv);
  std::vector<std::pair<unsigned, Codes>> list;
  for (const Json& e : row.at("elements")) {
    if (!e.contains("packet")) continue;
    const unsigned own = e.at("packet");
    if (own == id) return;
    list.emplace_back(own, own == 136 ? Codes{{"NID_BG", 101}} : Codes{});
  }
  list.emplace_back(id, Codes{});
  const bool infill_unit = sender == "RIU";
  const Json& optional = row.contains("optional_packets_by_sender") ? row.at("optional_packets_by_sender").at(sender)
                                                                    : row.at("optional_packets");
  const bool ignored = id == 76 && sv[0] == '1';  // 6.6.3.1.1.1: not read, wherever it is
  const bool listed = ignored || std::find(optional.begin(), optional.end(), id) != optional.end();
  const std::string start = in_version(infill_unit ? kInfillUnit : kFS2, sv);
  EXPECT_EQ(accepted_by_message(NID_MESSAGE, list, {}, start, infill_unit, sv), listed)
      << "packet " << id << " in message " << NID_MESSAGE << " of " << sender << " " << sv;
}

/// Each packet in each place in which it may not be.
TEST(LanguageThroughStep, MediaOfEachPacket) {
  for (const Json& p : reference("packets_to_train").at("packets")) {
    const unsigned id = p.at("id");
    if (id == 255) continue;
    const Json& media = p.at("media");
    const auto sent_by = [&](const char* medium) {
      return std::find(media.begin(), media.end(), medium) != media.end();
    };
    for (const char* sv : {"1.0", "1.1", "2.0", "2.1"}) {
      if (find_packet("to_train", id, sv) != &p) continue;
      EXPECT_EQ(accepted_by_group({{id, {}}}, kFS1, sv), sent_by("balise") || (id == 76 && sv[0] == '1'))
          << "packet " << id << " in a telegram of " << sv;
      for (const unsigned message : {2u, 3u, 9u, 24u, 28u, 33u}) check_list(message, id, sv, "RBC");
      for (const unsigned message : {24u, 37u}) check_list(message, id, sv, "RIU");
    }
  }
}

TEST(LanguageThroughStep, PacketsThatMayComeAgain) {
  const std::set<unsigned> again{0, 6, 44, 65, 66, 88, 145, 254};
  for (const Json& p : reference("packets_to_train").at("packets")) {
    const unsigned id = p.at("id");
    const Json& media = p.at("media");
    if (find_packet("to_train", id, "2.1") != &p || id == 255) continue;
    if (std::find(media.begin(), media.end(), "balise") == media.end()) continue;
    // Those with an identity differ in it.
    Codes first, second;
    for (const char* identity : {"NID_TSR", "NID_LX", "NID_VBCMK"})
      for (const Field& f : fields_of(p.at("elements")))
        if (f.path == identity && again.contains(id)) {
          first[identity] = 1;
          second[identity] = 2;
        }
    EXPECT_EQ(accepted_by_group({{id, first}, {id, second}}), again.contains(id)) << "packet " << id;
    // One for each direction is no repetition.
    if (id == 0 || id == 136) continue;
    Codes other = first;
    other["Q_DIR"] = 0;
    EXPECT_TRUE(accepted_by_group({{id, first}, {id, other}})) << "packet " << id;
  }
  for (const unsigned id : {65u, 66u, 88u, 6u})
    EXPECT_FALSE(accepted_by_group({{id, {}}, {id, {}}})) << "packet " << id;
  // 255 is no identity of a restriction (7.5.1.99).
  EXPECT_TRUE(accepted_by_group({{65, {{"NID_TSR", 255}}}, {65, {{"NID_TSR", 255}}}}));
  EXPECT_FALSE(accepted_by_message(24, {{21, {}}, {21, {}}}));
  EXPECT_TRUE(accepted_by_message(24, {{44, {}}, {44, {}}}));
  // 8.4.1.4.6 is for balise groups.
  EXPECT_TRUE(accepted_by_message(24, {{44, {}}, {44, {}}, {254, {}}}, {}, kInfillUnit, true));
  EXPECT_FALSE(accepted_by_message(24, {{254, {}}, {254, {}}}, {}, kInfillUnit, true));
}

TEST(LanguageThroughStep, OrderOfPackets) {
  const std::vector<std::pair<unsigned, Codes>> contents{
      {12, {{"L_ENDSECTION", 2000}}},
      {21, {{"D_GRADIENT", 300}, {"G_A", 5}}},
      {27, {{"D_STATIC", 700}, {"V_STATIC", 20}}},
      {65, {{"D_TSR", 900}}},
      {68, {{"D_TRACKCOND", 200}, {"L_TRACKCOND", 100}, {"M_TRACKCOND", 3}}}};
  // What the unit shows and, in any order, what it has said.
  const auto after = [&](const std::vector<std::size_t>& order) {
    OnBoard unit(OnBoard::after(kFS1));
    std::vector<std::pair<unsigned, Codes>> list;
    for (const std::size_t i : order) list.push_back(contents[i]);
    const Answer answer = unit.pass(200, packets(list));
    for (const auto& [id, codes] : list)
      EXPECT_NE(answer.event({"packet " + std::to_string(id) + " accepted"}), "") << id << answer.text();
    Json output = unit.output();
    output.erase("events");
    return std::pair(output, std::multiset<std::string>(answer.events.begin(), answer.events.end()));
  };
  std::vector<std::size_t> order{0, 1, 2, 3, 4};
  const auto whole = after(order);
  // Each of them is seen in the outputs.
  for (std::size_t without = 0; without < contents.size(); ++without) {
    std::vector<std::size_t> others = order;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(without));
    EXPECT_NE(after(others).first, whole.first) << "packet " << contents[without].first;
  }
  while (std::next_permutation(order.begin(), order.end())) EXPECT_EQ(after(order), whole);
}

TEST(LanguageThroughStep, PlacesOfPackets) {
  EXPECT_TRUE(accepted_by_group({{0, {}}, {0, {{"NID_VBCMK", 2}}}, {65, {}}}));
  EXPECT_FALSE(accepted_by_group({{65, {}}, {0, {}}}));  // 8.4.2.3
  // 8.4.2.2: the packet ends beyond the telegram.
  BitList longer;
  put_packet(longer, *find_packet("to_train", 44, "2.1"), {}, 900);
  OnBoard unit(OnBoard::after(kFS1));
  EXPECT_NE(unit.pass(200, longer).event({"not decoded [3.16.1.1]"}), "");
  // 8.4.4.3, 8.4.4.4: the packets of the message itself come first, then the optional ones; none is missing.
  EXPECT_TRUE(accepted_by_message(3, {{15, {}}, {21, {}}}));
  EXPECT_FALSE(accepted_by_message(3, {{21, {}}, {15, {}}}));
  EXPECT_FALSE(accepted_by_message(3, {{21, {}}}));
  EXPECT_FALSE(accepted_by_message(33, {}));
}

}  // namespace
}  // namespace evc::through_step
