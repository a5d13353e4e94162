// The recorded passage Amsterdam - Utrecht: every telegram of its 103 groups and every linking packet of its
// radio messages, read by a train whose odometer errs, through balise groups, linking and relocation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "balise/balise.h"
#include "lang/decode.h"
#include "lang/si.h"
#include "lang/telegram.h"
#include "position/position.h"

namespace evc {
namespace {

using nlohmann::json;

constexpr Distance kAntenna{2.0};

std::string shared_file(const char* name) {
  const char* folder = std::getenv("OPENEVC_SHARED");
  return (folder != nullptr ? std::string(folder) : std::string(EVC_SOURCE_DIR "/../shared")) + "/" + name;
}

std::vector<std::uint8_t> bytes_of(const std::string& hex) {
  std::vector<std::uint8_t> out;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    out.push_back(static_cast<std::uint8_t>(std::stoul(hex.substr(i, 2), nullptr, 16)));
  return out;
}

/// Something that happens when the true front end is at `front`.
struct Happening {
  double front = 0;
  bool is_balise = false;
  std::size_t bits = 0;
  std::vector<std::uint8_t> bytes;
};

std::vector<Happening> happenings(const json& line) {
  std::vector<Happening> all;
  for (const json& group : line["balise_groups"])
    for (const json& b : group["balises"])
      all.push_back({b["position_m"].get<double>() + kAntenna.si, true, b["telegram_bits"].get<std::size_t>(),
                     bytes_of(b["telegram_hex"].get<std::string>())});
  for (const json& m : line["rbc_messages"])
    if (!m.value("missing_raw", false))
      all.push_back({m["trigger"]["position_m"].get<double>(), false, m["message_bits"].get<std::size_t>(),
                     bytes_of(m["message_hex"].get<std::string>())});
  std::stable_sort(all.begin(), all.end(), [](const Happening& a, const Happening& b) { return a.front < b.front; });
  return all;
}

/// The two rooms together, as one cycle of the kernel uses them.
struct Unit {
  position::State position;
  balise::State balise;
  balise::Situation situation;
  double error;  // of the odometer's nominal counter
  int accepted = 0, rejected = 0, linked_ok = 0, reactions = 0, refused_linking = 0, lrbg_changes = 0;
  double largest_shift = 0, worst_excess = 0;
  std::string told;

  explicit Unit(double odometer_error) : error(odometer_error) {}

  void run_to(double front, double t) {
    const double run = front + 50;  // it started 50 m before the first group
    const auto at = [](double x) { return OdometerPlace{Distance{x}}; };
    position::update(
        position,
        {{at(run * (1 + error)), at(run * (1 + error - 0.05)), at(run * (1 + error + 0.05))}, Speed{30}, {}, {}, {}},
        Duration{t});
  }
  void take(const balise::Outcome& outcome) {
    for (const balise::Event& e : outcome.events) {
      linked_ok += e.what == balise::Happened::linking_ok ? 1 : 0;
      if (e.what == balise::Happened::linking_ok || e.what == balise::Happened::group_accepted) continue;
      told += std::string(balise::name_of(e.what)) + " " + std::to_string(e.id.NID_BG) + "; ";
    }
    reactions += outcome.reaction != balise::Reaction::none ? 1 : 0;
    for (const balise::Group& group : outcome.groups) {
      (group.accepted ? accepted : rejected)++;
      if (!group.lrbg_compliant) continue;
      const Distance shift =
          position::relocate(position, {group.id, group.counter, kAntenna, group.link_place,
                                        group.Q_LOCACC.value_or(12_m), group.counter_against_group, group.single});
      largest_shift = std::max(largest_shift, shift.si < 0 ? -shift.si : shift.si);
      ++lrbg_changes;
    }
  }
  void cycle() {
    balise::Outcome outcome;
    balise::close_overdue(balise, position.now.counter, situation, outcome);
    take(outcome);
    balise::expect(balise, position::antenna(position, kAntenna), situation, outcome);
    take(outcome);
  }
  void read(const Happening& h) {
    const OdometerReading counter = position.now.counter;
    balise::Outcome outcome;
    balise::read(balise, {h.bytes, h.bits, counter, position::antenna_at(position, counter, kAntenna)}, situation,
                 outcome);
    take(outcome);
  }
  void receive(const Happening& h) {
    const lang::MessageToTrainView message = lang::scan_message_to_train(h.bytes, {1, 0});
    ASSERT_EQ(message.fault, lang::Fault::none);
    const auto lrbg = lang::group(message.NID_LRBG);
    for (const lang::PacketView& view : message.packets) {
      if (view.NID_PACKET != 5) continue;
      lang::Packet5 packet;
      ASSERT_EQ(lang::decode(view, packet), lang::Fault::none);
      ASSERT_TRUE(lrbg);
      const position::Reference* reference = position::find(position, {lrbg->NID_C, lrbg->NID_BG});
      if (reference == nullptr || !balise::valid_for(packet.Q_DIR.raw, reference->orientation)) {
        ++refused_linking;
        continue;
      }
      const position::Reference* current = position::lrbg(position);
      const balise::Stored stored =
          balise::store(balise.linking, balise::linking_list(packet),
                        {reference->id, reference->place, reference->id.NID_C, true, false},
                        position::antenna(position, kAntenna), balise::CurrentLrbg{current->id, current->place});
      EXPECT_TRUE(stored.complete);
      situation.linking_checked = true;  // with the first authority the train goes into full supervision
    }
  }
};

TEST(RecordedLine, AllGroupsAreAcceptedAndAllAnnouncedOnesFound) {
  std::ifstream file(shared_file("lines/amsterdam_utrecht.json"));
  if (!file) GTEST_SKIP() << "the recorded line is not here (OPENEVC_SHARED)";
  const json line = json::parse(file);
  const std::vector<Happening> all = happenings(line);
  for (const double error : {0.0, 0.01, -0.01, 0.03, -0.03, 0.049, -0.049}) {
    SCOPED_TRACE(error);
    Unit unit(error);
    double t = 0, front = -50;
    unit.run_to(front, t);
    for (const Happening& h : all) {
      while (front + 3 < h.front) {  // 108 km/h, a cycle of 0.1 s
        front += 3;
        unit.run_to(front, t += 0.1);
        unit.cycle();
      }
      front = h.front;
      unit.run_to(front, t += 0.1);
      h.is_balise ? unit.read(h) : unit.receive(h);
      // The places of the file from group 354 on are sums of D_LINK: the true front must lie in the interval.
      if (unit.linked_ok == 0) continue;
      const PlaceInterval f = position::front(unit.position);
      const position::Reference& lrbg = *position::lrbg(unit.position);
      for (const json& group : line["balise_groups"]) {
        if (group["nid_bg"] != lrbg.id.NID_BG) continue;
        const double true_distance = front - group["position_m"].get<double>();
        EXPECT_LE((f.min - lrbg.place).si, true_distance + 1e-6) << lrbg.id.NID_BG;
        EXPECT_GE((f.max - lrbg.place).si, true_distance - 1e-6) << lrbg.id.NID_BG;
      }
    }
    for (int i = 0; i < 20; ++i) {
      unit.run_to(front += 3, t += 0.1);
      unit.cycle();
    }
    EXPECT_EQ(unit.accepted, 103);
    EXPECT_EQ(unit.rejected, 0);
    EXPECT_EQ(unit.reactions, 0);
    EXPECT_EQ(unit.refused_linking, 0);
    EXPECT_EQ(unit.lrbg_changes, 101);  // all but the two marked unlinked
    EXPECT_EQ(unit.linked_ok, 99);      // all but 352, 353, 354 before the first linking and the unlinked 979
    EXPECT_EQ(unit.told, "");
    // What the odometer erred between two groups, and the extra telegrams of a group.
    EXPECT_LT(unit.largest_shift, 900 * (error < 0 ? -error : error) + 1.0);
    std::cout << "odometer error " << error << ": largest shift " << unit.largest_shift << " m\n";
  }
}

}  // namespace
}  // namespace evc
