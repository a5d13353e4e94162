#include "procedures/mode_profile.h"

#include <gtest/gtest.h>

#include <optional>
#include <utility>
#include <vector>

#include "base/test_units.h"

namespace evc::procedures {
namespace {

using evc::test::at;

struct Profile {
  mode_profile::State state;
  mode_profile::Inputs in;
  std::vector<mode_profile::Area> areas;
  Profile(Mode mode, std::optional<Place> end = at(2000.0)) {
    areas.push_back({mode, at(1000.0), end, Speed{10.0}, Distance{200.0}});
    in.mode = Mode::FS;
    in.V_est = Speed{9.0};
  }
  /// The estimated front end at `front`, the confidence interval 10 m on either side.
  mode_profile::Result cycle(double front, Set<Ack> acknowledged = {}) {
    in.now += Duration{1.0};
    in.est_front = at(front);
    in.min_safe_front = at(front - 10.0);
    in.max_safe_front = at(front + 10.0);
    in.acknowledged = acknowledged;
    in.areas = areas;
    const mode_profile::Result r = step(state, in);
    if (r.asks_for) areas[*r.asks_for].asked = true;
    return r;
  }
};

TEST(ModeProfile, Demands_are_by_the_max_safe_front_end) {
  for (const Mode mode : {Mode::OS, Mode::LS, Mode::SH}) {
    Profile p(mode);
    const auto demanded = [&](const mode_profile::Result& r) {
      return mode == Mode::OS ? r.demands_OS : mode == Mode::LS ? r.demands_LS : r.demands_SH;
    };
    auto r = p.cycle(989.0);
    EXPECT_FALSE(demanded(r) || r.in_force || r.at_front.has_value());
    r = p.cycle(990.0);
    EXPECT_TRUE(demanded(r) && r.in_force);
    EXPECT_EQ(r.at_front, mode);
    r = p.cycle(1995.0);
    EXPECT_EQ(demanded(r), mode == Mode::SH);  // the max safe front end has left the area, SH has no end
    EXPECT_TRUE(r.in_force);                   // the min safe front end has not (5.9.6.1.1)
    r = p.cycle(2010.0);
    EXPECT_EQ(r.in_force, mode == Mode::SH);
    EXPECT_EQ(int{r.demands_OS} + int{r.demands_LS} + int{r.demands_SH}, mode == Mode::SH ? 1 : 0);
  }
  Profile endless(Mode::OS, std::nullopt);
  EXPECT_TRUE(endless.cycle(1.0e6).in_force);
}

TEST(ModeProfile, A_train_that_comes_from_another_mode_is_in_the_area_until_all_of_it_has_left) {
  for (const Mode from : {Mode::SR, Mode::UN, Mode::SN, Mode::SB, Mode::PT}) {
    Profile p(Mode::OS);
    p.in.mode = from;
    EXPECT_TRUE(p.cycle(1995.0).demands_OS) << name(from);
    EXPECT_FALSE(p.cycle(2010.0).demands_OS) << name(from);
  }
  Profile newer(Mode::OS);
  newer.in.srs = SrsVersion::v4_0_0;
  EXPECT_TRUE(newer.cycle(1995.0).demands_OS);
}

TEST(ModeProfile, Of_two_areas_the_further_one_counts) {
  Profile p(Mode::OS);
  p.areas.push_back({Mode::LS, at(2000.0), at(3000.0), Speed{10.0}, Distance{0.0}});
  const auto r = p.cycle(1995.0);
  EXPECT_TRUE(r.demands_LS);
  EXPECT_FALSE(r.demands_OS);
  EXPECT_EQ(r.at_front, Mode::LS);
}

TEST(ModeProfile, The_window_ahead_of_the_area) {
  for (const auto& [mode, ack] : {std::pair{Mode::OS, Ack::OS}, {Mode::LS, Ack::LS}, {Mode::SH, Ack::SH}}) {
    Profile p(mode);
    EXPECT_TRUE(p.cycle(799.0).effects.requests.empty());
    p.in.V_est = Speed{10.0};
    EXPECT_TRUE(p.cycle(800.0).effects.requests.empty());  // not slower than the limit
    p.in.srs = SrsVersion::v4_0_0;
    Profile newer = p;
    EXPECT_FALSE(newer.cycle(800.0).effects.requests.empty());
    p.in.srs = SrsVersion::v3_6_0;
    p.in.V_est = Speed{9.9};
    auto r = p.cycle(810.0);
    EXPECT_EQ(r.effects.requests, Set<Ack>{ack});
    EXPECT_EQ(r.front_in_OS_ack_area, mode == Mode::OS);
    EXPECT_EQ(r.front_in_LS_ack_area, mode == Mode::LS);
    p.in.V_est = Speed{20.0};
    EXPECT_EQ(p.cycle(820.0).effects.requests, Set<Ack>{ack});  // not withdrawn
    EXPECT_EQ(p.cycle(790.0).effects.requests, Set<Ack>{ack});
    Profile next = p;  // an area of the same mode further on: its own conditions count
    next.areas = {{mode, at(3000.0), at(4000.0), Speed{10.0}, Distance{200.0}}};
    EXPECT_TRUE(next.cycle(830.0).effects.requests.empty());
    p.areas.clear();
    EXPECT_TRUE(p.cycle(830.0).effects.requests.empty());
  }
}

TEST(ModeProfile, Only_from_FS_LS_and_OS_is_asked_ahead) {
  for (std::size_t m = 0; m < kModes; ++m) {
    Profile p(Mode::OS);
    p.in.mode = static_cast<Mode>(m);
    EXPECT_EQ(!p.cycle(850.0).effects.requests.empty(), full_supervision(p.in.mode) || p.in.mode == Mode::LS)
        << name(p.in.mode);
  }
}

TEST(ModeProfile, The_nearest_area_of_another_mode_is_asked_for) {
  Profile p(Mode::OS);
  p.areas.insert(p.areas.begin(), {Mode::LS, at(1500.0), at(1900.0), Speed{10.0}, Distance{2000.0}});
  EXPECT_EQ(p.cycle(850.0).effects.requests, Set<Ack>{Ack::OS});
  p.in.mode = Mode::OS;
  EXPECT_EQ(p.cycle(860.0).effects.requests, Set<Ack>{Ack::LS});  // the OS area is no longer ahead
}

TEST(ModeProfile, An_entry_without_acknowledgement_brakes_after_5_s) {
  struct Entry {
    Mode to;
    Ack ack;
    std::vector<int> numbers;
  };
  const Entry entries[] = {
      {Mode::OS, Ack::OS, {34, 40, 73}}, {Mode::LS, Ack::LS, {71, 72, 74}}, {Mode::SH, Ack::SH, {51, 61}}};
  for (const Entry& e : entries)
    for (const int n : e.numbers) {
      Profile p(e.to);
      mode_profile::on_mode_change(p.state, e.to, n, p.in.now);
      p.in.mode = e.to;
      for (int i = 0; i < 4; ++i) {
        const auto r = p.cycle(1100.0);
        EXPECT_EQ(r.effects.requests, Set<Ack>{e.ack});
        EXPECT_FALSE(r.overdue.has_value());
      }
      auto r = p.cycle(1100.0);
      EXPECT_TRUE(r.overdue.has_value()) << n;
      EXPECT_EQ(r.overdue, e.to);
      r = p.cycle(1100.0, {e.ack});
      EXPECT_FALSE(r.overdue.has_value());
      EXPECT_TRUE(r.effects.requests.empty());
    }
}

TEST(ModeProfile, An_acknowledged_entry_needs_nothing_more) {
  Profile p(Mode::OS);
  p.cycle(850.0);
  mode_profile::on_mode_change(p.state, Mode::OS, 15, p.in.now);
  p.in.mode = Mode::OS;
  const auto r = p.cycle(860.0);
  EXPECT_TRUE(r.effects.requests.empty());
  EXPECT_TRUE(r.front_in_OS_ack_area);
}

}  // namespace
}  // namespace evc::procedures
