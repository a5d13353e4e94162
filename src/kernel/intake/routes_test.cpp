#include <gtest/gtest.h>

#include <array>
#include <cctype>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "base/test_paths.h"
#include "kernel/intake/routes.h"
#include "lang/encode.h"
#include "lang/packets/packet_180.h"
#include "lang/packets/packet_3.h"
#include "lang/packets/packet_41.h"
#include "lang/packets/packet_57.h"
#include "lang/packets/packet_58.h"
#include "lang/packets/packet_65.h"
#include "lang/packets/packet_68.h"
#include "lang/packets/packet_76.h"

// The routes of packets and messages compared with the reference data.
namespace evc::kernel {
namespace {

using nlohmann::json;

InformationRows rows_of_number(int NID_PACKET) {
  lang::PacketView view;
  view.NID_PACKET = static_cast<std::uint16_t>(NID_PACKET);
  return rows_of(route_of(view), view);
}

TEST(Routes, OnlyPacketsOfTheTurnRestHaveAFunction) {  // the other turns are steps of their own
  int functions = 0;
  for (int number = 0; number < 256; ++number) {
    lang::PacketView view;
    view.NID_PACKET = static_cast<std::uint16_t>(number);
    const PacketRoute& route = route_of(view);
    functions += route.take != nullptr;
    EXPECT_TRUE(route.take == nullptr || route.turn == Turn::rest) << number;
  }
  EXPECT_GT(functions, 30);
}

/// The packet as it is received; `bytes` holds its bits.
template <class P>
lang::PacketView view_of(const P& packet, std::span<std::uint8_t> bytes) {
  BitWriter out(bytes);
  lang::encode(out, packet);
  lang::PacketView view;
  view.NID_PACKET = P::info.NID_PACKET;
  view.L_PACKET = static_cast<std::uint16_t>(out.position());
  view.sv = {2, 1};
  view.bytes = bytes;
  return view;
}

template <class P>
InformationRows rows_of_contents(const P& packet) {
  std::array<std::uint8_t, 64> bytes{};
  const lang::PacketView view = view_of(packet, bytes);
  return rows_of(route_of(view), view);
}

template <class P>
bool placed(const P& packet) {
  std::array<std::uint8_t, 256> bytes{};
  const lang::PacketView view = view_of(packet, bytes);
  return has_place(route_of(view), view);
}

InformationRows rows_of_condition(std::uint8_t M_TRACKCOND) {
  lang::Packet68 p;
  p.M_TRACKCOND.raw = M_TRACKCOND;
  return rows_of_contents(p);
}

InformationRows rows_of_lssma(std::uint8_t Q_LSSMA) {
  lang::Packet180 p;
  p.Q_LSSMA.raw = Q_LSSMA;
  return rows_of_contents(p);
}

/// One row of the reference is several rows here where the two tables divide differently.
std::vector<std::string> informations(const std::string& id) {
  if (id == "track_conditions_no_bmm") return {"track_conditions_general", "track_conditions_horn_stopping"};
  if (id == "level_transition_orders") return {"level_transition_order", "conditional_level_transition_order"};
  return {id};
}

std::set<std::string> names(const InformationRows& rows) {
  std::set<std::string> out;
  for (const evc::Information row : rows) out.insert(name(row));
  return out;
}

TEST(Routes, PacketsAndMessagesFindTheRowsOfTheReference) {
  std::ifstream in(evc::test::source_folder() + "/tests/reference/acceptance_by_mode.json");
  const json file = json::parse(in);
  std::set<int> packets, messages;
  for (const json& r : file["information"]) {
    const std::string id = r["id"];
    const std::string from = r["packets"];
    for (std::size_t i = 0; i + 1 < from.size(); ++i) {
      const bool starts =
          (i == 0 || from[i - 1] == ' ' || from[i - 1] == '(') && std::isdigit(static_cast<unsigned char>(from[i + 1]));
      if (!starts || (from[i] != 'P' && from[i] != 'M') || from.find('[') < i || from.find("infill") < i) continue;
      const int number = std::stoi(from.substr(i + 1));
      std::set<std::string> found;
      if (from[i] == 'M') {
        if (number == 3 || number == 33) continue;  // the authority in them is packet 15
        messages.insert(number);
        if (const auto row = row_of_message(static_cast<std::uint8_t>(number))) found = {name(*row)};
      } else {
        packets.insert(number);
        found = names(rows_of_number(number));
        if (number == 68)
          for (const std::uint8_t kind : {std::uint8_t{0}, std::uint8_t{3}})
            found.merge(names(rows_of_condition(kind)));
        if (number == 180) found.merge(names(rows_of_lssma(1)));
      }
      bool any = false;
      for (const std::string& what : informations(id)) any = any || found.count(what) != 0;
      EXPECT_TRUE(any) << id << " " << from[i] << number;
    }
  }
  EXPECT_GE(packets.size(), 45u);
  EXPECT_GE(messages.size(), 17u);
  EXPECT_EQ(rows_of_number(12).size(), 2u);
  for (const int none : {0, 49, 63, 80, 145, 255, 199}) EXPECT_TRUE(rows_of_number(none).empty()) << none;
  for (const std::uint8_t none : std::array<std::uint8_t, 5>{3, 24, 33, 37, 200})
    EXPECT_FALSE(row_of_message(none)) << none;
}

TEST(Routes, EachPacketHasItsTurn) {  // 4.8.1.3, 4.8.1.6, 4.8.2.2, 4.8.3 [4]
  const std::map<int, Turn> turns{{0, Turn::before},         {2, Turn::version_order},   {136, Turn::before},
                                  {145, Turn::before},       {255, Turn::before},        {41, Turn::level_order},
                                  {46, Turn::level_order},   {5, Turn::linking},         {12, Turn::authority},
                                  {15, Turn::authority},     {49, Turn::with_authority}, {63, Turn::with_authority},
                                  {80, Turn::with_authority}};
  for (int NID_PACKET = 0; NID_PACKET < 256; ++NID_PACKET) {
    lang::PacketView view;
    view.NID_PACKET = static_cast<std::uint16_t>(NID_PACKET);
    const PacketRoute& route = route_of(view);
    const auto special = turns.find(NID_PACKET);
    if (special != turns.end()) {
      EXPECT_EQ(static_cast<int>(route.number), NID_PACKET);
    }
    if (static_cast<int>(route.number) != NID_PACKET) continue;  // no packet
    EXPECT_EQ(route.turn, special != turns.end() ? special->second : Turn::rest) << NID_PACKET;
  }
}

TEST(Routes, TheRowOfATrackConditionIsThatOfItsKind) {  // 4.8.3, 4.8.4
  for (std::uint8_t kind = 0; kind <= 10; ++kind)
    EXPECT_EQ(names(rows_of_condition(kind)),
              (std::set<std::string>{kind <= 2 ? "track_conditions_horn_stopping" : "track_conditions_general"}))
        << int{kind};
}

TEST(Routes,
     TheInitialStateIsAcceptedWhereAnyConditionIs) {  // 4.8.4: NL and TR take what is no horn and no stopping area
  lang::Packet68 p;
  p.Q_TRACKINIT.raw = 1;
  EXPECT_EQ(names(rows_of_contents(p)), (std::set<std::string>{"track_conditions_general"}));
}

TEST(Routes, LssmaIsSwitchedOnAndOff) {  // 7.4.2.38
  EXPECT_EQ(names(rows_of_lssma(0)), std::set<std::string>{"lssma_toggle_off"});
  EXPECT_EQ(names(rows_of_lssma(1)), std::set<std::string>{"lssma_toggle_on"});
}

TEST(Routes, SomePacketsHaveAPlaceByTheirContents) {
  constexpr std::uint32_t kSpecial = 32767;  // D_VALIDNV, D_LEVELTR, D_TEXTDISPLAY; L_TEXTDISPLAY: not limited
  lang::Packet3 values;
  EXPECT_TRUE(placed(values));
  values.D_VALIDNV.raw = kSpecial;
  EXPECT_FALSE(placed(values));
  lang::Packet41 order;
  EXPECT_TRUE(placed(order));
  order.D_LEVELTR.raw = kSpecial;
  EXPECT_FALSE(placed(order));
  lang::Packet58 reports;
  EXPECT_FALSE(placed(reports));
  ASSERT_TRUE(reports.locations.push_back({}));
  EXPECT_TRUE(placed(reports));
  lang::Packet76 text;
  text.D_TEXTDISPLAY.raw = kSpecial;
  EXPECT_TRUE(placed(text));
  text.L_TEXTDISPLAY.raw = kSpecial;
  EXPECT_FALSE(placed(text));
  text.D_TEXTDISPLAY.raw = 0;
  EXPECT_TRUE(placed(text));
  EXPECT_TRUE(placed(lang::Packet65{}));
  EXPECT_FALSE(placed(lang::Packet57{}));
}

TEST(Routes, MessagesThatAreNothingWithoutAPlace) {
  for (int NID_MESSAGE = 0; NID_MESSAGE < 128; ++NID_MESSAGE) {
    const bool place = std::set<int>{3, 4, 9, 15, 33, 34, 37}.count(NID_MESSAGE) != 0;
    EXPECT_EQ(has_place(static_cast<std::uint8_t>(NID_MESSAGE)), place) << NID_MESSAGE;
  }
}

}  // namespace
}  // namespace evc::kernel
