#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <vector>

#include "base/bit_cursor.h"
#include "kernel/evc.h"
#include "kernel/state.h"
#include "lang/encode.h"
#include "lang/packets.h"

namespace evc::kernel {
namespace {

/// A telegram made of packets, kept alive for the cycle.
struct Telegram {
  std::vector<std::uint8_t> bytes = std::vector<std::uint8_t>(104, 0);
  std::size_t bits = 0;
};

template <class... P>
Telegram telegram(std::uint16_t NID_BG, std::uint8_t N_PIG, std::uint8_t N_TOTAL, bool linked, const P&... packets) {
  Telegram t;
  BitWriter out(t.bytes);
  lang::TelegramHeader h;
  h.N_PIG.raw = N_PIG;
  h.N_TOTAL.raw = N_TOTAL;
  h.NID_C.raw = 1;
  h.NID_BG.raw = NID_BG;
  h.Q_LINK.raw = linked ? 1 : 0;
  lang::begin_telegram(out, h);
  (lang::encode(out, packets), ...);
  lang::end_telegram(out, 830);
  t.bits = 830;
  return t;
}

/// A unit with a train that is driven by hand.
class Unit : public ::testing::Test {
 protected:
  Unit() { power_up(*state, *derived, config); }

  /// One cycle of 100 ms at `v` m/s.
  const Outputs& cycle(double v = 0.0) {
    const double dx = (v + speed) / 2.0 * 0.1;
    in.odometry.A_est = {(v - speed) / 0.1};
    speed = v;
    front += dx;
    doubt += dx * 0.01;
    in.odometry.nominal = {{front}};
    in.odometry.min = {{front - doubt}};
    in.odometry.max = {{front + doubt}};
    in.odometry.V_est = {v};
    in.odometry.V_min = {v > 0.2 ? v - 0.2 : 0.0};
    in.odometry.V_max = {v > 0.0 ? v + 0.2 : 0.0};
    in.now = {t};
    t += 0.1;
    step(*state, *derived, in, out);
    in.balise_telegrams = {};
    in.driver = {};
    for (const Event& e : out.events) events.push_back(e);
    return out;
  }
  /// Passes a group of two balises 3 m apart while the train runs; the first telegram is that of N_PIG 0.
  void pass(const Telegram& first, const Telegram& second, double v) {
    const std::array<BaliseTelegram, 2> read{BaliseTelegram{first.bytes, first.bits, {{front}}},
                                             BaliseTelegram{second.bytes, second.bits, {{front + 3.0}}}};
    in.balise_telegrams = read;
    front += 3.0;
    doubt += 0.03;
    cycle(v);
  }
  void start_of_mission(modes::Level level, std::uint8_t nid_ntc, Ack ack) {
    in.train.desk_open = true;
    for (int i = 0; i < 10; ++i) cycle();
    in.driver.driver_id = 0x1234FFFF;
    cycle();
    in.driver.level = level;
    in.driver.nid_ntc = nid_ntc;
    cycle();
    in.driver.train_data = &config.train;
    cycle();
    in.driver.train_running_number = 0x4711FFFF;
    cycle();
    cycle();
    in.driver.selected = 1u << static_cast<unsigned>(Select::start);
    cycle();
    cycle();
    in.driver.acknowledged = 1u << static_cast<unsigned>(ack);
    cycle();
    cycle();
  }
  bool happened(const char* subject, const char* what) const {
    for (const Event& e : events)
      if (std::strcmp(e.subject, subject) == 0 &&
          (what == nullptr || (e.what != nullptr && std::strcmp(e.what, what) == 0)))
        return true;
    return false;
  }

  Config config;
  std::unique_ptr<State> state = std::make_unique<State>();
  std::unique_ptr<Derived> derived = std::make_unique<Derived>();
  Inputs in;
  Outputs out;
  std::vector<Event> events;
  double front = 0.0, doubt = 0.0, speed = 0.0, t = 0.0;
};

TEST_F(Unit, powers_up_into_stand_by) {
  EXPECT_EQ(cycle().mode, modes::Mode::SB);
  EXPECT_TRUE(happened("mode", nullptr));
}

TEST_F(Unit, without_power_is_NP_with_the_emergency_brake) {
  cycle();
  in.train.powered = false;
  cycle();
  EXPECT_EQ(out.mode, modes::Mode::NP);
  EXPECT_TRUE(out.eb);
}

TEST_F(Unit, starts_a_mission_in_level_NTC) {
  in.national_system.available = 2;
  start_of_mission(modes::Level::NTC, 1, Ack::SN);
  EXPECT_EQ(out.mode, modes::Mode::SN);
  EXPECT_EQ(out.level, modes::Level::NTC);
  EXPECT_FALSE(out.sb || out.eb || out.tco);
}

TEST_F(Unit, starts_a_mission_in_level_0) {
  start_of_mission(modes::Level::L0, 0, Ack::UN);
  EXPECT_EQ(out.mode, modes::Mode::UN);
}

TEST_F(Unit, starts_a_mission_in_level_1_in_SR) {
  start_of_mission(modes::Level::L1, 0, Ack::SR);
  EXPECT_EQ(out.mode, modes::Mode::SR);
  ASSERT_TRUE(out.V_P.has_value());
  EXPECT_NEAR(out.V_P->si * 3.6, 40.0, 1e-9);
}

TEST_F(Unit, supervises_standstill_in_stand_by) {
  in.train.desk_open = true;
  for (int i = 0; i < 10; ++i) cycle();
  for (int i = 0; i < 30; ++i) cycle(1.0);
  EXPECT_TRUE(out.eb);
}

/// MA of `length` m with SSP and level gradient, as a level 1 group gives it.
struct LevelOne {
  lang::Packet12 ma;
  lang::Packet21 gradient;
  lang::Packet27 ssp;
  explicit LevelOne(std::uint16_t length, std::uint8_t v5) {
    ma.Q_DIR.raw = 1;
    ma.Q_SCALE.raw = 1;
    ma.V_MAIN.raw = 32;
    ma.V_EMA.raw = 0;
    ma.T_EMA.raw = 1023;
    ma.L_ENDSECTION.raw = length;
    gradient.Q_DIR.raw = 1;
    gradient.Q_SCALE.raw = 1;
    gradient.Q_GDIR.raw = 1;
    gradient.G_A.raw = 0;
    ssp.Q_DIR.raw = 1;
    ssp.Q_SCALE.raw = 1;
    ssp.V_STATIC.raw = v5;
  }
};

TEST_F(Unit, enters_FS_on_an_MA_of_level_1_and_stops_the_train_before_its_end) {
  start_of_mission(modes::Level::L1, 0, Ack::SR);
  for (int i = 0; i < 50; ++i) cycle(8.0);
  const LevelOne data(2000, 20);
  const Telegram first = telegram(100, 0, 1, true, data.ma, data.gradient, data.ssp);
  const Telegram second = telegram(100, 1, 1, true);
  const double at = front;
  pass(first, second, 8.0);
  for (int i = 0; i < 10; ++i) cycle(8.0);
  EXPECT_EQ(out.mode, modes::Mode::FS);
  ASSERT_TRUE(out.EOA.has_value());
  const double antenna = config.train.L_antenna_front.si;
  EXPECT_NEAR(out.EOA->from_origin.si, at - antenna + 2000.0, 1.0);
  // Faster and faster towards the EOA: the unit brakes in time.
  double v = 8.0;
  bool braked = false;
  for (int i = 0; i < 3000 && !(braked && v <= 0.0); ++i) {
    braked = braked || out.eb || out.sb;
    if (out.eb || out.sb)
      v = v > 0.08 ? v - 0.08 : 0.0;
    else if (!braked)
      v = v < 30.0 ? v + 0.05 : v;
    cycle(v);
  }
  EXPECT_TRUE(braked);
  EXPECT_LT(front, at - antenna + 2000.0);
  EXPECT_EQ(out.mode, modes::Mode::FS);
}

TEST_F(Unit, refuses_an_MA_without_gradient) {
  start_of_mission(modes::Level::L1, 0, Ack::SR);
  for (int i = 0; i < 50; ++i) cycle(8.0);
  const LevelOne data(2000, 20);
  pass(telegram(100, 0, 1, true, data.ma, data.ssp), telegram(100, 1, 1, true), 8.0);
  for (int i = 0; i < 10; ++i) cycle(8.0);
  EXPECT_EQ(out.mode, modes::Mode::SR);
  EXPECT_FALSE(out.EOA.has_value());
}

TEST_F(Unit, derived_data_follow_from_the_state_alone) {
  start_of_mission(modes::Level::L1, 0, Ack::SR);
  for (int i = 0; i < 50; ++i) cycle(8.0);
  const LevelOne data(2000, 20);
  pass(telegram(100, 0, 1, true, data.ma, data.gradient, data.ssp), telegram(100, 1, 1, true), 8.0);
  for (int i = 0; i < 100; ++i) {
    // The same cycle with everything derived thrown away gives the same outputs.
    auto other_state = std::make_unique<State>(*state);
    auto other_derived = std::make_unique<Derived>();
    auto other_out = std::make_unique<Outputs>();
    Inputs same = in;
    same.now = {t};
    const double before = front;
    cycle(8.0);
    same.odometry = in.odometry;
    same.now = in.now;
    step(*other_state, *other_derived, same, *other_out);
    ASSERT_EQ(other_out->mode, out.mode);
    ASSERT_EQ(other_out->V_P, out.V_P);
    ASSERT_EQ(other_out->V_EBI, out.V_EBI);
    ASSERT_EQ(other_out->d_target, out.d_target);
    ASSERT_EQ(other_out->EOA, out.EOA);
    ASSERT_LT(before, front);
  }
}

TEST_F(Unit, the_state_is_small_and_plain) {
  EXPECT_LE(sizeof(State), 64u * 1024u);
  EXPECT_TRUE(std::is_trivially_copyable_v<State>);
}

}  // namespace
}  // namespace evc::kernel
