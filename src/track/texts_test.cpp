#include <gtest/gtest.h>

#include "track/testing.h"

namespace evc::track {
namespace {

using namespace testing;

struct Display {
  Description d;
  TextReports reports;
  bool always_ends = false;  // X = 1 is operated
  explicit Display(Text t) {
    t.id = 7;
    if (!d.texts.push_back(t)) __builtin_trap();
  }
  TextDisplay run(double front, double now, Mode mode = Mode::FS, Level level = Level::L2, std::uint8_t ntc = 0,
                  std::uint8_t acknowledged = 0) {
    Here here = front_at(front);
    here.now = Duration{now};
    reports.clear();
    return show_texts(d, here, mode, level, ntc, {acknowledged, always_ends}, reports);
  }
  bool shown(double front, double now, Mode mode = Mode::FS, Level level = Level::L2, std::uint8_t ntc = 0) {
    return !run(front, now, mode, level, ntc).shown.empty();
  }
};

TEST(Texts, WithoutPartsAtOnceAndForEver) {
  Display x{Text{}};
  EXPECT_TRUE(x.shown(0, 0));
  EXPECT_TRUE(x.shown(1e6, 1e6));
}

TEST(Texts, OnePartIsEnough) {
  Text t;
  t.start_at = at(100);
  t.start_mode = Mode::OS;
  t.start_level = Level::NTC;
  t.start_NTC = 5;
  EXPECT_FALSE(Display{t}.shown(99, 0));
  EXPECT_TRUE(Display{t}.shown(100, 0));
  EXPECT_TRUE(Display{t}.shown(0, 0, Mode::OS));
  EXPECT_TRUE(Display{t}.shown(0, 0, Mode::FS, Level::NTC, 5));
  EXPECT_FALSE(Display{t}.shown(0, 0, Mode::FS, Level::NTC, 6)) << "another national system";
  t.all_parts = true;
  EXPECT_FALSE(Display{t}.shown(100, 0, Mode::OS));
  EXPECT_TRUE(Display{t}.shown(100, 0, Mode::OS, Level::NTC, 5));
}

TEST(Texts, EndsByPlaceTimeModeOrLevel) {
  Text t;
  t.end_at = at(200);
  t.T_TEXTDISPLAY = Duration{30};
  t.end_mode = Mode::FS;
  t.end_level = Level::L2;
  {
    Display x{t};
    EXPECT_TRUE(x.shown(199, 0));
    EXPECT_FALSE(x.shown(200, 1));
    EXPECT_FALSE(x.shown(100, 2)) << "it does not come back";
  }
  {
    Display x{t};
    EXPECT_TRUE(x.shown(0, 10));
    EXPECT_TRUE(x.shown(0, 39.9));
    EXPECT_FALSE(x.shown(0, 40));
  }
  {
    Display x{t};
    EXPECT_TRUE(x.shown(0, 0));
    EXPECT_FALSE(x.shown(0, 1, Mode::OS));
  }
  {
    Display x{t};
    EXPECT_TRUE(x.shown(0, 0));
    EXPECT_FALSE(x.shown(0, 1, Mode::FS, Level::L1));
  }
  {
    t.all_parts = true;
    Display x{t};
    EXPECT_TRUE(x.shown(0, 0));
    EXPECT_TRUE(x.shown(200, 1)) << "each part is latched";
    EXPECT_TRUE(x.shown(0, 2, Mode::OS));
    EXPECT_TRUE(x.shown(0, 3, Mode::FS, Level::L1));
    EXPECT_FALSE(x.shown(0, 31));
  }
}

TEST(Texts, AlreadyEndedIsNeverShown) {
  Text t;
  t.end_at = at(50);
  EXPECT_FALSE(Display{t}.shown(60, 0));
  t.Q_TEXTCONFIRM = 3;
  Display x{t};
  EXPECT_FALSE(x.shown(60, 0)) << "nor to be acknowledged (3.12.3.4.4)";
  EXPECT_FALSE(x.run(60, 1).emergency_brake);
}

TEST(Texts, EndsByATransitionFromItsModeOrLevel) {  // 3.12.3.4.3
  Text t;
  t.end_mode = Mode::SR;
  t.end_level = Level::L1;
  {
    Display x{t};
    EXPECT_TRUE(x.shown(0, 0)) << "not in the mode is not: has left it";
    EXPECT_TRUE(x.shown(0, 1, Mode::SR));
    EXPECT_FALSE(x.shown(0, 2, Mode::FS));
  }
  {
    Display x{t};
    EXPECT_TRUE(x.shown(0, 0));
    EXPECT_TRUE(x.shown(0, 1, Mode::FS, Level::L1));
    EXPECT_FALSE(x.shown(0, 2));
  }
  t.start_at = at(100);
  Display x{t};
  EXPECT_FALSE(x.shown(0, 0, Mode::SR));
  EXPECT_FALSE(x.shown(0, 1, Mode::FS)) << "the mode is left before the start";
  EXPECT_FALSE(x.shown(100, 2, Mode::FS));
}

TEST(Texts, Acknowledgement) {  // 3.12.3.4.7
  for (std::uint8_t confirm = 1; confirm <= 3; ++confirm) {
    Text t;
    t.end_at = at(100);
    t.Q_TEXTCONFIRM = confirm;
    t.report = true;
    t.NID_TEXTMESSAGE = 42;
    t.NID_C = 3;
    t.NID_RBC = 4;
    Display x{t};
    TextDisplay shown = x.run(0, 0);
    ASSERT_EQ(shown.to_acknowledge.size(), 1u);
    EXPECT_EQ(shown.to_acknowledge[0], 7);
    EXPECT_FALSE(shown.service_brake || shown.emergency_brake);
    shown = x.run(101, 1);
    EXPECT_EQ(shown.shown.size(), 1u) << "stays beyond its end";
    EXPECT_EQ(shown.service_brake, confirm == 2);
    EXPECT_EQ(shown.emergency_brake, confirm == 3);
    shown = x.run(101, 2, Mode::FS, Level::L2, 0, 9);
    EXPECT_EQ(shown.shown.size(), 1u) << "another text was acknowledged";
    shown = x.run(101, 3, Mode::FS, Level::L2, 0, 7);
    EXPECT_TRUE(shown.shown.empty());
    EXPECT_FALSE(shown.service_brake || shown.emergency_brake);
    ASSERT_EQ(x.reports.size(), 1u);
    EXPECT_EQ(x.reports[0].NID_TEXTMESSAGE, 42);
    EXPECT_EQ(x.reports[0].NID_C, 3);
    EXPECT_EQ(x.reports[0].NID_RBC, 4);
  }
}

TEST(Texts, AcknowledgementAndEnd) {  // Q_CONFTEXTDISPLAY
  Text t;
  t.end_at = at(100);
  t.Q_TEXTCONFIRM = 1;
  t.ack_and_end = true;
  Display x{t};
  EXPECT_EQ(x.run(0, 0, Mode::FS, Level::L2, 0, 7).shown.size(), 1u);
  EXPECT_TRUE(x.reports.empty());
  EXPECT_TRUE(x.run(0, 1).to_acknowledge.empty());
  EXPECT_TRUE(x.run(100, 2).shown.empty());
  Display y{t};
  y.always_ends = true;  // 6.6.2.1.1
  EXPECT_EQ(y.run(0, 0).shown.size(), 1u);
  EXPECT_TRUE(y.run(0, 1, Mode::FS, Level::L2, 0, 7).shown.empty());
}

// 3.12.3.4.7: without an act of the driver nothing is acknowledged, and X = 1 has to be said (6.6.2.1.1).
TEST(Texts, NothingIsAcknowledgedByItself) {
  Text t;
  t.Q_TEXTCONFIRM = 1;
  t.ack_and_end = true;
  t.end_at = at(200);
  t.id = 1;  // the first one that is assigned
  Description d;
  ASSERT_TRUE(d.texts.push_back(t));
  TextReports reports;
  const auto run = [&](TextAcknowledgement acknowledgement) {
    return show_texts(d, front_at(0), Mode::FS, Level::L2, 0, acknowledgement, reports);
  };
  EXPECT_EQ(run({}).to_acknowledge.size(), 1u);
  EXPECT_FALSE(d.texts[0].acknowledged);
  TextAcknowledgement of_it;
  of_it.id = 1;
  const TextDisplay display = run(of_it);
  EXPECT_TRUE(d.texts[0].acknowledged);
  EXPECT_EQ(display.shown.size(), 1u) << "until its end";
}

}  // namespace
}  // namespace evc::track
