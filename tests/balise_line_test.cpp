// The recorded run Amsterdam - Utrecht: every telegram of its 103 groups and every linking packet of its radio
// messages, read by a train with odometer errors, through balise groups, linking and relocation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "balise/balise.h"
#include "base/test_paths.h"
#include "lang/decode.h"
#include "lang/encode.h"
#include "lang/packets/packet_5.h"
#include "lang/si.h"
#include "lang/telegram.h"
#include "position/position.h"
#include "texts/texts.h"

namespace evc {
namespace {

using nlohmann::json;

constexpr Distance kAntenna{2.0};

std::string shared_file(const char* name) { return evc::test::shared_folder() + "/" + name; }

std::vector<std::uint8_t> bytes_of(const std::string& hex) {
  std::vector<std::uint8_t> out;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    out.push_back(static_cast<std::uint8_t>(std::stoul(hex.substr(i, 2), nullptr, 16)));
  return out;
}

/// An event when the true front end is at `front`.
struct Happening {
  double front = 0;
  bool is_balise = false;
  int NID_BG = -1;  // of a balise
  int N_PIG = -1;
  std::size_t bits = 0;
  std::vector<std::uint8_t> bytes;
};

std::vector<Happening> happenings(const json& line) {
  std::vector<Happening> all;
  for (const json& group : line["balise_groups"])
    for (const json& b : group["balises"])
      all.push_back({b["position_m"].get<double>() + kAntenna.si, true, group["nid_bg"].get<int>(),
                     b["n_pig"].get<int>(), b["telegram_bits"].get<std::size_t>(),
                     bytes_of(b["telegram_hex"].get<std::string>())});
  for (const json& m : line["rbc_messages"])
    if (!m.value("missing_raw", false))
      all.push_back({m["trigger"]["position_m"].get<double>(), false, -1, -1, m["message_bits"].get<std::size_t>(),
                     bytes_of(m["message_hex"].get<std::string>())});
  std::stable_sort(all.begin(), all.end(), [](const Happening& a, const Happening& b) { return a.front < b.front; });
  return all;
}

/// The two rooms together, as used in one cycle of the kernel.
struct Unit {
  position::State position;
  balise::State balise;
  balise::Situation situation;
  OdometerReading counter;
  double true_front = -50;  // where it starts
  double error;             // of the odometer's nominal counter
  int accepted = 0, rejected = 0, linked_ok = 0, reactions = 0, refused_linking = 0, lrbg_changes = 0;
  double largest_shift = 0;
  Reaction worst = Reaction::none;
  bool wrong_direction = false;
  std::string log;

  explicit Unit(double odometer_error) : error(odometer_error) {}

  void run_to(double front, double t) {
    const auto ahead = [](OdometerPlace& c, double d) { c = c + Distance{d}; };
    const double run = front - true_front;
    true_front = front;
    ahead(counter.nominal, run * (1 + error));
    ahead(counter.min, run * (1 + error - 0.05));
    ahead(counter.max, run * (1 + error + 0.05));
    position::update(position, {counter, Speed{30}, {}, {}, {}}, Duration{t});
  }
  void take(const balise::Outcome& outcome) {
    for (const balise::Event& e : outcome.events) {
      linked_ok += e.what == What::linking_ok ? 1 : 0;
      if (e.what == What::linking_ok || e.what == What::group_accepted) continue;
      log += std::string(texts::text_of(e.what).text) + " " + std::to_string(e.id.NID_BG) + "; ";
    }
    if (stronger(outcome.reaction, worst)) worst = outcome.reaction;
    wrong_direction = wrong_direction || outcome.wrong_direction;
    reactions += outcome.reaction != Reaction::none ? 1 : 0;
    for (const balise::Group& group : outcome.groups) {
      (group.accepted ? accepted : rejected)++;
      if (!group.lrbg_compliant) continue;
      const Distance shift =
          position::relocate(position, {group.id, group.counter, kAntenna, group.link_place,
                                        group.Q_LOCACC.value_or(12_m), group.counter_against_group, group.single})
              .unlinked.shift;
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
      situation.linking_checked = true;  // with the first authority the train enters full supervision
    }
  }
};

struct RecordedLine : testing::Test {
  json line;
  std::vector<Happening> all;
  void SetUp() override {
    std::ifstream file(shared_file("lines/amsterdam_utrecht.json"));
    if (!file) GTEST_SKIP() << "the recorded line is not here (OPENEVC_SHARED)";
    line = json::parse(file);
    all = happenings(line);
  }
  /// 108 km/h, a cycle of 0.1 s; `after` checks the unit after every event.
  template <class After>
  static void drive(Unit& unit, const std::vector<Happening>& happenings, After after) {
    double t = 0, front = -50;
    unit.run_to(front, t);
    for (const Happening& h : happenings) {
      while (front + 3 < h.front) {
        front += 3;
        unit.run_to(front, t += 0.1);
        unit.cycle();
      }
      front = h.front;
      unit.run_to(front, t += 0.1);
      h.is_balise ? unit.read(h) : unit.receive(h);
      after(front);
    }
    for (int i = 0; i < 20; ++i) {
      unit.run_to(front += 3, t += 0.1);
      unit.cycle();
    }
  }
  static Unit driven(const std::vector<Happening>& happenings) {
    Unit unit(0.01);
    drive(unit, happenings, [](double) {});
    return unit;
  }
  /// The announced groups to which no linking packet refers: a missing one does not affect the rest of the line.
  std::vector<int> announced() const {
    std::vector<int> out;
    for (const json& group : line["balise_groups"]) {
      const int id = group["nid_bg"].get<int>();
      const auto refers = [id](const json& m) {
        return !m.value("missing_raw", false) && m["nid_lrbg"]["NID_BG"] == id &&
               std::any_of(m["packets"].begin(), m["packets"].end(),
                           [](const json& q) { return q["nid_packet"] == 5; });
      };
      const bool referred = std::any_of(line["rbc_messages"].begin(), line["rbc_messages"].end(), refers);
      if (!referred && id != 352 && id != 353 && id != 354 && id != 979) out.push_back(id);
    }
    return out;
  }
};

TEST_F(RecordedLine, AllGroupsAreAcceptedAndAllAnnouncedOnesFound) {
  for (const double error : {0.0, 0.01, -0.01, 0.03, -0.03, 0.049, -0.049}) {
    SCOPED_TRACE(error);
    Unit unit(error);
    drive(unit, all, [&](double front) {
      // The places of the file from group 354 on are sums of D_LINK: the true front end must be in the interval.
      if (unit.linked_ok == 0) return;
      const PlaceInterval f = position::front(unit.position);
      const position::Reference& lrbg = *position::lrbg(unit.position);
      for (const json& group : line["balise_groups"]) {
        if (group["nid_bg"] != lrbg.id.NID_BG) continue;
        const double true_distance = front - group["position_m"].get<double>();
        EXPECT_LE((f.min - lrbg.place).si, true_distance + 1e-6) << lrbg.id.NID_BG;
        EXPECT_GE((f.max - lrbg.place).si, true_distance - 1e-6) << lrbg.id.NID_BG;
      }
    });
    EXPECT_EQ(unit.accepted, 103);
    EXPECT_EQ(unit.rejected, 0);
    EXPECT_EQ(unit.reactions, 0);
    EXPECT_EQ(unit.refused_linking, 0);
    EXPECT_EQ(unit.lrbg_changes, 101);  // all but the two marked unlinked
    EXPECT_EQ(unit.linked_ok, 99);      // all but 352, 353, 354 before the first linking and the unlinked 979
    EXPECT_EQ(unit.log, "");
    // Odometer error between two groups, which are at most 874 m apart.
    EXPECT_LE(unit.largest_shift, 874 * (error < 0 ? -error : error) + 1e-6);
  }
}

TEST_F(RecordedLine, ASilentGroupTripsAndTheRestIsFound) {
  const std::vector<int> groups = announced();
  ASSERT_GT(groups.size(), 70u);
  for (const int silent : groups) {
    SCOPED_TRACE(silent);
    std::vector<Happening> left = all;
    std::erase_if(left, [=](const Happening& h) { return h.NID_BG == silent; });
    const Unit unit = driven(left);
    // Groups close to each other: the next one may be read while the window of the missing one is open.
    const std::string id = std::to_string(silent);
    EXPECT_TRUE(unit.log == "not found in its window " + id + "; " ||
                unit.log == "a later group found in its window " + id + "; ")
        << unit.log;
    EXPECT_EQ(unit.worst, Reaction::trip);  // the linking reaction of this line
    EXPECT_EQ(unit.accepted, 102);
    EXPECT_EQ(unit.rejected, 0);
  }
}

TEST_F(RecordedLine, OneSilentBaliseIsMadeGoodByItsDuplicate) {
  for (const int group : announced()) {
    for (int silent = 0; silent < 2; ++silent) {
      SCOPED_TRACE(std::to_string(group) + " balise " + std::to_string(silent));
      std::vector<Happening> left = all;
      std::erase_if(left, [=](const Happening& h) { return h.NID_BG == group && h.N_PIG == silent; });
      const Unit unit = driven(left);
      EXPECT_EQ(unit.log, "");
      EXPECT_EQ(unit.linked_ok, 99);
      EXPECT_EQ(unit.accepted, 103);
    }
  }
}

TEST_F(RecordedLine, AGroupCrossedInTheOtherDirectionTrips) {
  for (const int turned : announced()) {
    SCOPED_TRACE(turned);
    std::vector<Happening> swapped = all;
    Happening* first = nullptr;
    for (Happening& h : swapped) {
      if (h.NID_BG != turned) continue;
      if (first != nullptr) std::swap(first->bytes, h.bytes);
      first = &h;
    }
    const Unit unit = driven(swapped);
    EXPECT_TRUE(unit.wrong_direction);  // condition [66]
    EXPECT_EQ(unit.worst, Reaction::none);
    EXPECT_NE(unit.log.find("crossed in the wrong direction " + std::to_string(turned)), std::string::npos) << unit.log;
    EXPECT_EQ(unit.rejected, 1);
    EXPECT_EQ(unit.accepted, 102);
  }
}

/// A balise of an invented line.
Happening balise_at(double place, int NID_BG, unsigned N_PIG, unsigned N_TOTAL, unsigned M_DUP) {
  Happening h;
  h.front = place + kAntenna.si;
  h.is_balise = true;
  h.NID_BG = NID_BG;
  h.N_PIG = static_cast<int>(N_PIG);
  h.bytes.resize(27);
  BitWriter out(h.bytes);
  lang::TelegramHeader header;
  header.N_PIG.raw = static_cast<std::uint8_t>(N_PIG);
  header.N_TOTAL.raw = static_cast<std::uint8_t>(N_TOTAL);
  header.M_DUP.raw = static_cast<std::uint8_t>(M_DUP);
  header.NID_C.raw = 1;
  header.NID_BG.raw = static_cast<std::uint16_t>(NID_BG);
  header.Q_LINK.raw = 1;
  lang::begin_telegram(out, header);
  lang::end_telegram(out, 210);
  h.bits = 210;
  return h;
}

// On any line: while odometer and balises are within their bounds and the linking is correct, no group is rejected,
// there is no reaction, and the train is inside its interval.
TEST(AnyLine, WithinItsBoundsNothingReacts) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto uniform = [&](double a, double b) {
      return a + (b - a) * (static_cast<double>(random()) / 4294967295.0);
    };
    struct Planned {
      double place;     // according to trackside
      double accuracy;  // whole metres
      bool nominal, single;
      double off;  // of its true place
    };
    std::vector<Planned> plan;
    double place = 0;
    for (int i = 0; i < 60; ++i) {
      const double accuracy = static_cast<double>(random() % 11);
      plan.push_back({place, accuracy, random() % 2 == 0, i > 0 && random() % 4 == 0, uniform(-accuracy, accuracy)});
      place += 50 + static_cast<double>(random() % 900);
    }
    Unit unit(0);
    unit.situation.linking_checked = true;
    double t = 0, linked_to = 0;
    unit.run_to(-50, t);
    for (std::size_t i = 0; i < plan.size(); ++i) {
      const Planned& g = plan[i];
      const int balises = g.single ? 1 : 2 + static_cast<int>(random() % 3);
      for (int k = 0; k < balises; ++k) {
        const int N_PIG = g.nominal ? k : balises - 1 - k;
        const double offset = (g.nominal ? 1.0 : -1.0) * 3.0 * N_PIG;
        const Happening h = balise_at(g.place + g.off + offset, static_cast<int>(i + 1), static_cast<unsigned>(N_PIG),
                                      static_cast<unsigned>(balises - 1), 0);
        while (unit.true_front + 3 < h.front) {
          unit.error = uniform(-0.045, 0.045);
          unit.run_to(unit.true_front + 3, t += 0.1);
          unit.cycle();
        }
        unit.run_to(h.front, t += 0.1);
        unit.read(h);
      }
      const position::Reference& lrbg = *position::lrbg(unit.position);
      ASSERT_EQ(lrbg.id.NID_BG, i + 1);
      ASSERT_EQ(position::orientation(unit.position), g.nominal ? Direction::nominal : Direction::reverse);
      const PlaceInterval f = position::front(unit.position);
      ASSERT_LE((f.min - lrbg.place).si, unit.true_front - g.place + 1e-6);
      ASSERT_GE((f.max - lrbg.place).si, unit.true_front - g.place - 1e-6);
      // New linking from time to time, early enough, from this group or one before; the first list from the first
      // group.
      if (i > 0 && g.place + 1 < linked_to && random() % 3 != 0) continue;
      std::size_t from = i;
      while (from > 0 && i - from < 5 && random() % 2 == 0) --from;
      balise::LinkingList list;
      for (std::size_t k = from + 1; k < plan.size() && !list.entries.full() && (k < i + 3 || random() % 8 != 0); ++k) {
        ASSERT_TRUE(list.entries.push_back({Distance{plan[k].place - plan[k - 1].place}, std::nullopt,
                                            static_cast<std::uint16_t>(k + 1), plan[k].nominal, Reaction::trip,
                                            Distance{plan[k].accuracy}}));
        linked_to = plan[k].place;
      }
      const position::Reference* reference = position::find(unit.position, {1, static_cast<std::uint16_t>(from + 1)});
      ASSERT_NE(reference, nullptr);
      ASSERT_TRUE(balise::store(unit.balise.linking, list, {reference->id, reference->place, 1, true, false},
                                position::antenna(unit.position, kAntenna), balise::CurrentLrbg{lrbg.id, lrbg.place})
                      .complete);
    }
    EXPECT_EQ(unit.log, "");
    EXPECT_EQ(unit.accepted, 60);
    EXPECT_EQ(unit.linked_ok, 59);
  }
}

}  // namespace
}  // namespace evc
