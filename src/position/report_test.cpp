#include "position/report.h"

#include <gtest/gtest.h>

#include <random>

#include "position/testing.h"

namespace evc::position {
namespace {

using testing::moving;
using testing::spread;

static_assert(std::is_trivially_copyable_v<ReportState>);

Passage passage(std::uint16_t NID_BG, double c) {
  Passage p;
  p.id = {426, NID_BG};
  p.counter = spread(c);
  p.L_antenna = 2_m;
  p.Q_LOCACC = 5_m;
  p.counter_against_group = Direction::nominal;
  return p;
}
State after(double run, double under = 0, double over = 0) {
  State s;
  update(s, moving(spread(0)), 0_s);
  relocate(s, passage(352, 0));
  update(s, moving(spread(run, under, over)), 10_s);
  return s;
}
bool has(std::uint16_t why, Due d) { return (why & static_cast<std::uint16_t>(d)) != 0; }

TEST(Report, UnknownPosition) {
  State s;
  update(s, moving(spread(0), 160.0 / 3.6), 0_s);
  const Report r = report(s, {});
  EXPECT_EQ(r.NID_LRBG, kUnknownGroup);
  EXPECT_EQ(r.D_LRBG, kUnknownLength);
  EXPECT_EQ(r.L_DOUBTOVER, kUnknownLength);
  EXPECT_EQ(r.L_DOUBTUNDER, kUnknownLength);
  EXPECT_EQ(r.Q_DIRLRBG, 2);
  EXPECT_EQ(r.Q_DLRBG, 2);
  EXPECT_EQ(r.Q_DIRTRAIN, 2);
  EXPECT_EQ(r.V_TRAIN, 32);  // 160 km/h is a whole number of steps
  EXPECT_FALSE(r.NID_PRVLRBG);
  EXPECT_FALSE(r.L_TRAININT);
}

TEST(Report, ValuesOfAnOrdinaryPosition) {
  State s = after(101.24, 3.11, 4.22);
  const Report r = report(s, {});
  EXPECT_EQ(r.NID_LRBG, (426u << 14) | 352u);
  EXPECT_EQ(r.Q_SCALE, 0);
  EXPECT_EQ(r.D_LRBG, 1032);      // 103.24 m
  EXPECT_EQ(r.L_DOUBTOVER, 92);   // 5 + 4.22 - 0.04
  EXPECT_EQ(r.L_DOUBTUNDER, 82);  // 5 + 3.11 + 0.04
  EXPECT_EQ(r.Q_DIRLRBG, 1);
  EXPECT_EQ(r.Q_DLRBG, 1);
  EXPECT_EQ(r.Q_DIRTRAIN, 1);
  EXPECT_EQ(r.V_TRAIN, 8);  // 36 km/h
  EXPECT_FALSE(r.NID_PRVLRBG);
}

TEST(Report, BehindTheGroupAndBackward) {
  const Report r = report(after(-52), {});
  EXPECT_EQ(r.D_LRBG, 500);
  EXPECT_EQ(r.Q_DIRLRBG, 1);
  EXPECT_EQ(r.Q_DLRBG, 0);
  EXPECT_EQ(r.Q_DIRTRAIN, 0);
}

// The reported interval contains the supervised one, in every scale.
TEST(Report, RoundingIsToTheSafeSide) {
  std::mt19937 random(7);
  for (int i = 0; i < 5000; ++i) {
    const double reach = i % 3 == 0 ? 3000.0 : i % 3 == 1 ? 30000.0 : 300000.0;
    const double run = (static_cast<double>(random()) / 4294967295.0 * 2 - 1) * reach;
    const double under = static_cast<double>(random() % 100000u) / 1000.0;
    const double over = static_cast<double>(random() % 100000u) / 1000.0;
    State s = after(run, under, over);
    const Report r = report(s, {});
    const double step = r.Q_SCALE == 0 ? 0.1 : r.Q_SCALE == 1 ? 1.0 : 10.0;
    const double sign = r.Q_DLRBG == 1 ? 1.0 : -1.0;
    const double est = lrbg(s)->place.from_origin.si + sign * r.D_LRBG * step;
    const PlaceInterval f = front(s);
    ASSERT_NEAR(est, f.est.from_origin.si, step / 2 + 1e-6);
    ASSERT_LE(est - r.L_DOUBTOVER * step, f.min.from_origin.si + 2e-5) << run;
    ASSERT_GE(est + r.L_DOUBTUNDER * step, f.max.from_origin.si - 2e-5) << run;
    ASSERT_GE(est - r.L_DOUBTOVER * step, f.min.from_origin.si - step - 1e-6);
  }
}

TEST(Report, TooFarToTell) {
  const Report r = report(after(400000.0), {});
  EXPECT_EQ(r.NID_LRBG, (426u << 14) | 352u);
  EXPECT_EQ(r.Q_SCALE, 2);
  EXPECT_EQ(r.D_LRBG, kUnknownLength);
  EXPECT_EQ(r.L_DOUBTOVER, kUnknownLength);
}

TEST(Report, AnIntervalTooLargeToTellIsUnknown) {
  const Report r = report(after(10, 0, 400000.0), {});
  EXPECT_EQ(r.L_DOUBTOVER, kUnknownLength);
  EXPECT_NE(r.D_LRBG, kUnknownLength);
}

TEST(Report, SpeedIsRoundedUpAndLimited) {
  State s = after(10);
  s.now.V_est = Speed{0.01};
  EXPECT_EQ(report(s, {}).V_TRAIN, 1);
  s.now.V_est = Speed{-10.1};
  EXPECT_EQ(report(s, {}).V_TRAIN, 8);
  s.now.V_est = Speed{200};
  EXPECT_EQ(report(s, {}).V_TRAIN, 120);
  s.now.V_est = Speed{0};
  EXPECT_EQ(report(s, {}).V_TRAIN, 0);
}

TEST(Report, IntegrityCountsFromTheLastTimeItWasConfirmed) {
  State s = after(500);
  Report r = report(s, {Integrity::by_device, Place{99.5_m}, {}});
  EXPECT_EQ(r.Q_LENGTH, 1);
  EXPECT_EQ(r.L_TRAININT, 401);  // 500 - 99.5 up
  r = report(s, {Integrity::lost, Place{99.5_m}, {}});
  EXPECT_EQ(r.Q_LENGTH, 3);
  EXPECT_FALSE(r.L_TRAININT);
  EXPECT_EQ(report(s, {Integrity::by_driver, Place{99.5_m}, {}}).L_TRAININT, 401);
}

TEST(Report, IntegrityCountsFromTheReportedPlace) {  // 7.5.1.57
  for (const double run : {500.07, 4000.4, 4000.6, 40001.0, 40004.9, 40005.1, 49999.0}) {
    const State s = after(run);
    const Place rear{99.5_m};
    const Report r = report(s, {Integrity::by_device, rear, {}});
    ASSERT_TRUE(r.L_TRAININT) << run;
    if (*r.L_TRAININT == kUnknownLength) continue;
    const double step = r.Q_SCALE == 0 ? 0.1 : r.Q_SCALE == 1 ? 1.0 : 10.0;
    const double front = (lrbg(s)->place - Place{}).si + step * r.D_LRBG;
    EXPECT_LE(front - *r.L_TRAININT, 99.5 + 1e-6) << run << ": the reported rear end is not ahead of the safe one";
    EXPECT_GT(front - *r.L_TRAININT, 98.5 - 1e-6) << run;
  }
}

// 3.4.2.3.3: single balise groups.
State single_after(std::uint16_t NID_BG, bool back_between) {
  State s = after(100);
  if (back_between) update(s, moving(spread(50)), 11_s);
  Passage p = passage(NID_BG, back_between ? 50 : 100);
  p.single = true;
  p.counter_against_group = Direction::unknown;
  relocate(s, p);
  return s;
}

TEST(Report, ASingleGroupIsReportedWithThePreviousOne) {
  State s = single_after(7, false);
  const Report r = report(s, {});
  EXPECT_EQ(r.NID_LRBG, (426u << 14) | 7u);
  ASSERT_TRUE(r.NID_PRVLRBG);
  EXPECT_EQ(*r.NID_PRVLRBG, (426u << 14) | 352u);
  EXPECT_EQ(r.Q_DIRLRBG, 1);  // the movement from the previous one to it counts as nominal
  EXPECT_EQ(r.Q_DLRBG, 1);
  EXPECT_EQ(r.Q_DIRTRAIN, 1);
  EXPECT_EQ(orientation(s), Direction::unknown);
  // Read again: the pair is kept.
  Passage p = passage(7, 101);
  p.single = true;
  p.counter_against_group = Direction::unknown;
  relocate(s, p);
  EXPECT_EQ(*report(s, {}).NID_PRVLRBG, (426u << 14) | 352u);
}

TEST(Report, ATurnBetweenMakesThePreviousGroupUnknown) {
  State s = single_after(7, true);
  const Report r = report(s, {});
  ASSERT_TRUE(r.NID_PRVLRBG);
  EXPECT_EQ(*r.NID_PRVLRBG, kUnknownGroup);
  EXPECT_EQ(r.Q_DIRLRBG, 2);
  EXPECT_EQ(r.Q_DLRBG, 2);
  EXPECT_EQ(r.Q_DIRTRAIN, 2);
  note_reported(s, r);
  EXPECT_FALSE(assign_orientation(s, GroupId{426, 7}, Direction::nominal));
}

TEST(Report, AssignmentOfACoordinateSystem) {
  State s = single_after(7, false);
  const GroupId id{426, 7};
  EXPECT_FALSE(assign_orientation(s, id, Direction::nominal));  // not reported yet
  note_reported(s, report(s, {}));
  EXPECT_FALSE(assign_orientation(s, GroupId{426, 8}, Direction::nominal));    // not remembered
  EXPECT_FALSE(assign_orientation(s, GroupId{426, 352}, Direction::nominal));  // not single
  EXPECT_FALSE(assign_orientation(s, id, Direction::unknown));
  State reversed = s;
  EXPECT_TRUE(assign_orientation(s, id, Direction::nominal));
  EXPECT_EQ(orientation(s), Direction::nominal);
  EXPECT_FALSE(report(s, {}).NID_PRVLRBG);  // packet 0 from now on
  EXPECT_TRUE(assign_orientation(reversed, id, Direction::reverse));
  EXPECT_EQ(orientation(reversed), Direction::reverse);
  EXPECT_EQ(report(reversed, {}).Q_DIRTRAIN, 0);
}

// The train has turned back meanwhile, or the other cab leads: the reported pair still counts.
TEST(Report, AssignmentCountsFromThePairThatWasReported) {
  State s = single_after(7, false);
  note_reported(s, report(s, {}));
  update(s, moving(spread(200)), 12_s);
  relocate(s, passage(9, 200));
  update(s, moving(spread(150)), 13_s);
  Passage p = passage(7, 100);
  p.single = true;
  p.counter_against_group = Direction::unknown;
  relocate(s, p);
  State other_cab = s;
  EXPECT_TRUE(assign_orientation(s, GroupId{426, 7}, Direction::nominal));
  EXPECT_EQ(orientation(s), Direction::nominal);
  EXPECT_EQ(running_direction(s), Direction::reverse);
  change_cab(other_cab, 20_m);
  EXPECT_TRUE(assign_orientation(other_cab, GroupId{426, 7}, Direction::nominal));
  EXPECT_EQ(orientation(other_cab), Direction::reverse);
}

TEST(Report, AssignmentIsRefusedWhenReportedWithTwoDifferentPreviousGroups) {
  State s = single_after(7, false);
  note_reported(s, report(s, {}));
  note_reported(s, report(s, {}));  // the same pair twice is one pair
  EXPECT_FALSE(s.references.back().reported_ambiguously);
  relocate(s, passage(9, 150));
  Passage p = passage(7, 200);
  p.single = true;
  p.counter_against_group = Direction::unknown;
  relocate(s, p);
  note_reported(s, report(s, {}));
  EXPECT_FALSE(assign_orientation(s, GroupId{426, 7}, Direction::nominal));
}

TEST(ReportTriggers, WithoutParametersEveryCompliantGroup) {
  ReportState reports;
  State s = after(100);
  EXPECT_EQ(due(reports, s, {}, 200_m), 0);
  ReportEvents e;
  e.new_lrbg = true;
  EXPECT_TRUE(has(due(reports, s, e, 200_m), Due::lrbg));
  ReportParameters p;
  p.M_LOC = 2;
  set_parameters(reports, s, p);
  EXPECT_EQ(due(reports, s, e, 200_m), 0);
  p.M_LOC = 1;
  set_parameters(reports, s, p);
  EXPECT_TRUE(has(due(reports, s, e, 200_m), Due::lrbg));
  EXPECT_EQ(due(reports, s, {}, 200_m), 0);
  e.parameters_active = false;
  EXPECT_EQ(due(reports, s, e, 200_m), 0);
  clear_parameters(reports);
  EXPECT_TRUE(has(due(reports, s, e, 200_m), Due::lrbg));
}

TEST(ReportTriggers, StandstillOnce) {
  ReportState reports;
  State s = after(100);
  s.now.V_est = Speed{0};
  update(s, moving(spread(100), 0.0), 20_s);
  EXPECT_TRUE(has(due(reports, s, {}, 200_m), Due::standstill));
  EXPECT_EQ(due(reports, s, {}, 200_m), 0);
  update(s, moving(spread(110)), 21_s);
  EXPECT_EQ(due(reports, s, {}, 200_m), 0);
  update(s, moving(spread(110), 0.0), 31_s);
  ReportEvents e;
  e.standstill_active = false;
  EXPECT_EQ(due(reports, s, e, 200_m), 0);
}

TEST(ReportTriggers, StandstillLeftOnce) {  // 3.6.5.1.4 i of 4.0.0
  ReportEvents left;
  left.leaving_active = true;
  left.standstill_active = false;
  for (const ReportEvents& e : {left, ReportEvents{}}) {
    ReportState reports;
    State s = after(100);
    EXPECT_EQ(due(reports, s, e, 200_m), 0) << "it was not at standstill";
    update(s, moving(spread(100), 0.0), 20_s);
    (void)due(reports, s, e, 200_m);
    update(s, moving(spread(110)), 21_s);
    EXPECT_EQ(has(due(reports, s, e, 200_m), Due::standstill), e.leaving_active);
    update(s, moving(spread(120)), 22_s);
    EXPECT_EQ(due(reports, s, e, 200_m), 0);
  }
}

TEST(ReportTriggers, EveryEvent) {
  State s = after(100);
  for (int i = 0; i < 6; ++i) {
    ReportState reports;
    ReportEvents e;
    e.mode_change = i == 0;
    e.integrity_confirmed = i == 1;
    e.integrity_lost = i == 2;
    e.level_change = i == 3;
    e.session_established = i == 4;
    e.error_to_report = i == 5;
    EXPECT_TRUE(has(due(reports, s, e, 200_m), Due::event)) << i;
  }
}

TEST(ReportTriggers, NowTimeDistanceAndPlaces) {
  ReportState reports;
  State s = after(100);  // front interval 95..105
  ReportParameters p;
  p.T_CYCLOC = 6_s;
  p.D_CYCLOC = 50_m;
  p.M_LOC = 0;
  ASSERT_TRUE(p.at.push_back({Place{150_m}, true}));
  ASSERT_TRUE(p.at.push_back({Place{150_m}, false}));
  set_parameters(reports, s, p);
  EXPECT_EQ(due(reports, s, {}, 100_m), static_cast<std::uint16_t>(Due::now));
  EXPECT_EQ(due(reports, s, {}, 100_m), 0);
  update(s, moving(spread(144)), 11_s);
  EXPECT_EQ(due(reports, s, {}, 100_m), 0);
  update(s, moving(spread(145)), 12_s);
  EXPECT_EQ(due(reports, s, {}, 100_m), static_cast<std::uint16_t>(Due::place));  // max safe front
  update(s, moving(spread(150)), 13_s);
  EXPECT_EQ(due(reports, s, {}, 100_m), static_cast<std::uint16_t>(Due::cycle));  // 50 m
  update(s, moving(spread(151)), 16_s);
  EXPECT_EQ(due(reports, s, {}, 100_m), static_cast<std::uint16_t>(Due::cycle));  // 6 s
  update(s, moving(spread(101)), 17_s);
  EXPECT_EQ(due(reports, s, {}, 100_m), 0);
  update(s, moving(spread(100)), 17.1_s);
  EXPECT_EQ(due(reports, s, {}, 100_m), static_cast<std::uint16_t>(Due::cycle));  // 50 m back
  update(s, moving(spread(255)), 17.2_s);
  EXPECT_TRUE(has(due(reports, s, {}, 100_m), Due::place));  // min safe rear
  EXPECT_TRUE(reports.parameters->at.empty());
}

TEST(ReportTriggers, Borders) {
  ReportState reports;
  State s = after(100);
  reports.front_border = Place{106_m};
  reports.rear_border = Place{110_m};
  EXPECT_EQ(due(reports, s, {}, 100_m), 0);
  update(s, moving(spread(101)), 11_s);
  ReportEvents off;
  off.borders_active = false;
  EXPECT_EQ(due(reports, s, off, 100_m), 0);
  EXPECT_TRUE(has(due(reports, s, {}, 100_m), Due::border));
  EXPECT_FALSE(reports.front_border);
  update(s, moving(spread(214.9)), 12_s);
  EXPECT_EQ(due(reports, s, {}, 100_m), 0);
  update(s, moving(spread(215)), 13_s);
  EXPECT_TRUE(has(due(reports, s, {}, 100_m), Due::border));
  EXPECT_FALSE(reports.rear_border);
}

}  // namespace
}  // namespace evc::position
