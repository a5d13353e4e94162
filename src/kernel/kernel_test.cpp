#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <vector>

#include "base/bit_cursor.h"
#include "kernel/evc.h"
#include "kernel/here.h"
#include "kernel/intake/shortening.h"
#include "kernel/state.h"
#include "lang/encode.h"
#include "lang/packets/packet_12.h"
#include "lang/packets/packet_135.h"
#include "lang/packets/packet_136.h"
#include "lang/packets/packet_141.h"
#include "lang/packets/packet_21.h"
#include "lang/packets/packet_27.h"
#include "lang/packets/packet_5.h"
#include "lang/packets/packet_65.h"
#include "lang/packets/packet_66.h"
#include "lang/packets/packet_80.h"
#include "lang/packets/packet_88.h"

namespace evc::kernel::test {
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

/// A unit with a train driven by the test.
class Unit : public ::testing::Test {
 protected:
  Unit() { power_up(*state, *derived, config); }

  /// One cycle of 100 ms at `v` m/s.
  const Outputs& cycle(double v = 0.0) {
    const double dx = (v + speed) / 2.0 * 0.1;
    in.odometry.A_est = {(v - speed) / 0.1};
    speed = v;
    front += dx;
    doubt += (dx < 0.0 ? -dx : dx) * 0.01;
    in.odometry.nominal = {{front}};
    in.odometry.min = {{front - doubt}};
    in.odometry.max = {{front + doubt}};
    in.odometry.V_est = {v};
    in.odometry.V_min = {v > 0.2 || v < 0.0 ? v - 0.2 : 0.0};
    in.odometry.V_max = {v > 0.0 || v < -0.2 ? v + 0.2 : 0.0};
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
  void start_of_mission(Level level, std::uint8_t nid_ntc, Ack ack) {
    in.train.desk_open = true;
    for (int i = 0; i < 10; ++i) cycle();
    in.driver.driver_id = DriverId("1234");
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
  bool happened(What what) const {
    return std::any_of(events.begin(), events.end(), [what](const Event& e) { return e.what == what; });
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
  EXPECT_EQ(cycle().mode, Mode::SB);
  EXPECT_TRUE(happened(What::mode_changed));
}

TEST_F(Unit, keeps_its_place_when_a_group_has_none) {  // 4.4.5
  for (const double v : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    power_up(*state, *derived, config);
    t = 0.0;
    cycle();
    cycle();
    ASSERT_EQ(out.mode, Mode::SB);
    const double before = out.est_front.from_origin.si;
    const Telegram first = telegram(100, 0, 1, true), second = telegram(100, 1, 1, true);
    const std::array<BaliseTelegram, 2> read{BaliseTelegram{first.bytes, first.bits, {{v}}},
                                             BaliseTelegram{second.bytes, second.bits, {{v}}}};
    in.balise_telegrams = read;
    step(*state, *derived, in, out);
    EXPECT_EQ(out.mode, Mode::SF);
    in.balise_telegrams = {};
    step(*state, *derived, in, out);
    EXPECT_FALSE(out.lrbg.has_value());
    EXPECT_EQ(out.est_front.from_origin.si, before);
  }
}

TEST_F(Unit, fails_safe_on_odometry_that_is_not_sound) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  const std::array<void (*)(Inputs&, double), 6> spoilers{
      [](Inputs& i, double v) {
        static BaliseTelegram telegram;
        telegram.at.from_origin.si = v;
        i.balise_telegrams = {&telegram, 1};
      },

      [](Inputs& i, double v) { i.odometry.nominal.from_origin.si = v; },
      [](Inputs& i, double v) { i.odometry.V_est.si = v; },
      [](Inputs& i, double v) { i.odometry.A_est.si = v; },
      [](Inputs& i, double v) { i.odometry.min.from_origin.si = v; },
      [](Inputs& i, double v) { i.now.si = v; }};
  for (const auto spoil : spoilers)
    for (const double v : {nan, infinite, -infinite}) {
      power_up(*state, *derived, config);
      t = 0.0;
      cycle();
      cycle();
      ASSERT_EQ(out.mode, Mode::SB);
      spoil(in, v);
      step(*state, *derived, in, out);
      EXPECT_EQ(out.mode, Mode::SF);
      EXPECT_TRUE(out.eb);
      cycle();
      EXPECT_EQ(out.mode, Mode::SF) << "until the power is switched off";
      EXPECT_TRUE(out.eb);
    }
  power_up(*state, *derived, config);
  t = 10.0;
  cycle();
  t = 9.0;
  EXPECT_EQ(cycle().mode, Mode::SF) << "time goes back";
  in.odometry.min = {{front + 1.0}};
  power_up(*state, *derived, config);
  in.now = {100.0};
  step(*state, *derived, in, out);
  EXPECT_TRUE(out.eb) << "the nominal counter below its lower bound";
}

// A source that gives lengths that cannot be does not work: none are available (3.18.3.2.5).
TEST_F(Unit, uses_no_consist_length_that_cannot_be) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  const auto end = [](double nominal, double min, double max) { return ConsistEnd{{nominal}, {min}, {max}}; };
  config.srs = SrsVersion::v4_0_0;
  for (const ConsistEnd& wrong : {end(nan, 0, 9), end(5, nan, 9), end(5, 0, nan), end(5, 0, infinite), end(5, -1, 9),
                                  end(5, 6, 9), end(5, 0, 4), end(5, 0, 4096)})
    for (const bool in_front : {false, true}) {
      power_up(*state, *derived, config);
      t = 0.0;
      const ConsistEnd right = end(30.0, 20.0, 40.0);
      in.train.consist = ConsistLength{right, right};
      cycle();
      ASSERT_TRUE(state->manoeuvre.available);
      (in_front ? in.train.consist->front : in.train.consist->rear) = wrong;
      cycle();
      EXPECT_TRUE(happened(What::consist_lost));
      EXPECT_FALSE(state->manoeuvre.available);
      EXPECT_FALSE(state->manoeuvre.consist.has_value());
      EXPECT_TRUE(std::isfinite(out.min_safe_front.from_origin.si) && std::isfinite(out.max_safe_front.from_origin.si));
      const std::uint32_t revision = state->revision;
      cycle();
      EXPECT_EQ(state->revision, revision) << "nothing changes any more";
    }
  in.train.consist.reset();
}

TEST_F(Unit, fails_safe_on_a_mode_that_the_level_excludes) {  // 4.4
  start_of_mission(Level::L0, 0, Ack::UN);
  ASSERT_EQ(out.mode, Mode::UN);
  state->level.level = Level::L2;
  cycle();
  EXPECT_TRUE(happened(What::mode_not_of_level));
  EXPECT_EQ(out.mode, Mode::SF);
  EXPECT_TRUE(out.eb);
}

TEST_F(Unit, fails_safe_on_a_configuration_out_of_range) {
  config.train.L_TRAIN = {-1.0};
  power_up(*state, *derived, config);
  cycle();
  EXPECT_EQ(cycle().mode, Mode::SF);
  EXPECT_TRUE(out.eb);
}

TEST_F(Unit, without_power_is_NP_with_the_emergency_brake) {
  cycle();
  in.train.powered = false;
  cycle();
  EXPECT_EQ(out.mode, Mode::NP);
  EXPECT_TRUE(out.eb);
}

TEST_F(Unit, starts_a_mission_in_level_NTC) {
  in.national_system.available = 2;
  start_of_mission(Level::NTC, 1, Ack::SN);
  EXPECT_EQ(out.mode, Mode::SN);
  EXPECT_EQ(out.level, Level::NTC);
  EXPECT_FALSE(out.sb || out.eb || out.tco);
}

TEST_F(Unit, starts_a_mission_in_level_0) {
  start_of_mission(Level::L0, 0, Ack::UN);
  EXPECT_EQ(out.mode, Mode::UN);
}

TEST_F(Unit, starts_a_mission_in_level_1_in_SR) {
  start_of_mission(Level::L1, 0, Ack::SR);
  EXPECT_EQ(out.mode, Mode::SR);
  ASSERT_TRUE(out.V_P.has_value());
  EXPECT_NEAR(out.V_P->si * 3.6, 40.0, 1e-9);
}

/// A restriction of every kind in force at the train, each with a different speed.
void restrict_by_everything(State& s) {
  track::Description& d = s.track;
  const Place from{{-1000.0}};
  const Place to{{5000.0}};
  track::StaticSpeed ssp;
  ssp.V_STATIC = 2;
  ASSERT_TRUE(d.ssp.append(from, ssp));
  track::TemporarySpeedRestriction tsr;
  tsr.from = from;
  tsr.to = to;
  tsr.V_TSR = 5;
  ASSERT_TRUE(d.tsr.push_back(tsr));
  (void)d.signalling.push_back(track::SignallingSpeed{from, 1, to});
  ++d.revision;
}

TEST_F(Unit, the_MRSP_is_made_of_what_counts_in_the_mode) {
  // 4.5.2: UN and SR have temporary restrictions, the maximum train speed and the mode's speed, SH only its own speed.
  start_of_mission(Level::L0, 0, Ack::UN);
  restrict_by_everything(*state);
  EXPECT_NEAR(cycle().V_MRSP->si * 3.6, 25.0, 1e-9);
  state->track.tsr.clear();
  ++state->track.revision;
  EXPECT_NEAR(cycle().V_MRSP->si * 3.6, 100.0, 1e-9);
  in.driver.selected = 1u << static_cast<unsigned>(Select::shunting);
  for (int i = 0; i < 5; ++i) cycle();
  ASSERT_EQ(out.mode, Mode::SH);
  restrict_by_everything(*state);
  EXPECT_NEAR(cycle().V_MRSP->si * 3.6, 30.0, 1e-9);
}

TEST_F(Unit, supervises_standstill_in_stand_by) {
  in.train.desk_open = true;
  for (int i = 0; i < 10; ++i) cycle();
  for (int i = 0; i < 30; ++i) cycle(1.0);
  EXPECT_TRUE(out.eb);
}

/// MA of `length` m with SSP and level gradient, as sent by a level 1 group.
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

/// An unprotected level crossing `D_LX` m on, with its speed of 20 km/h.
lang::Packet88 unprotected_crossing(std::uint16_t D_LX, std::uint8_t NID_LX = 1) {
  lang::Packet88 p;
  p.Q_DIR.raw = 1;
  p.Q_SCALE.raw = 1;
  p.NID_LX.raw = NID_LX;
  p.D_LX.raw = D_LX;
  p.L_LX.raw = 10;
  p.Q_LXSTATUS.raw = 1;
  p.V_LX.raw = 4;
  return p;
}
/// The same with an order to stop in rear of it.
lang::Packet88 crossing_with_stop(std::uint16_t D_LX, std::uint16_t L_STOPLX) {
  lang::Packet88 p = unprotected_crossing(D_LX);
  p.Q_STOPLX.raw = 1;
  p.L_STOPLX.raw = L_STOPLX;
  return p;
}

TEST_F(Unit, enters_FS_on_an_MA_of_level_1_and_stops_the_train_before_its_end) {
  start_of_mission(Level::L1, 0, Ack::SR);
  for (int i = 0; i < 50; ++i) cycle(8.0);
  const LevelOne data(2000, 20);
  const Telegram first = telegram(100, 0, 1, true, data.ma, data.gradient, data.ssp);
  const Telegram second = telegram(100, 1, 1, true);
  const double at = front;
  pass(first, second, 8.0);
  for (int i = 0; i < 10; ++i) cycle(8.0);
  EXPECT_EQ(out.mode, Mode::FS);
  ASSERT_TRUE(out.EOA.has_value());
  const double antenna = config.train.L_antenna_front.si;
  EXPECT_NEAR(out.EOA->from_origin.si, at - antenna + 2000.0, 1.0);
  // Accelerating towards the EOA: the unit brakes in time.
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
  EXPECT_EQ(out.mode, Mode::FS);
}

TEST_F(Unit, asks_whether_the_train_can_stop_without_touching_what_is_in_force) {
  start_of_mission(Level::L1, 0, Ack::SR);
  for (int i = 0; i < 50; ++i) cycle(8.0);
  const LevelOne data(2000, 20);
  pass(telegram(100, 0, 1, true, data.ma, data.gradient, data.ssp), telegram(100, 1, 1, true), 8.0);
  for (int i = 0; i < 10; ++i) cycle(8.0);
  ASSERT_EQ(out.mode, Mode::FS);
  ASSERT_TRUE(state->track.ma.has_value());
  track::AuthorityContents far, near;
  far.ma = near.ma = state->track.ma;
  near.ma->sections.back().stop = near.ma->sections.back().end =
      state->track.ma->sections.back().end - Distance{1950.0};
  const auto question = [&](const track::AuthorityContents& proposal) {
    return can_stop_before(*state, derived->scratch.curves, in.train, here(*state), proposal);
  };
  const State state_before = *state;
  const auto in_force_before = std::make_unique<Derived::Curves>(derived->in_force);
  EXPECT_TRUE(question(far));
  EXPECT_FALSE(question(near));
  EXPECT_EQ(std::memcmp(&state_before, state.get(), sizeof(State)), 0);
  EXPECT_EQ(std::memcmp(in_force_before.get(), &derived->in_force, sizeof(Derived::Curves)), 0);
  EXPECT_EQ(derived->built, state->basis.number);
}

TEST_F(Unit, refuses_an_MA_without_gradient) {
  start_of_mission(Level::L1, 0, Ack::SR);
  for (int i = 0; i < 50; ++i) cycle(8.0);
  const LevelOne data(2000, 20);
  pass(telegram(100, 0, 1, true, data.ma, data.ssp), telegram(100, 1, 1, true), 8.0);
  for (int i = 0; i < 10; ++i) cycle(8.0);
  EXPECT_EQ(out.mode, Mode::SR);
  EXPECT_FALSE(out.EOA.has_value());
}

TEST(Outputs, sessions_differ_by_their_RBC_and_their_phase) {
  const port::RbcSession one{1, 2, SessionPhase::idle};
  EXPECT_EQ(one, (port::RbcSession{1, 2, SessionPhase::idle}));
  EXPECT_FALSE(one == (port::RbcSession{2, 2, SessionPhase::idle}));
  EXPECT_FALSE(one == (port::RbcSession{1, 3, SessionPhase::idle}));
  EXPECT_FALSE(one == (port::RbcSession{1, 2, SessionPhase::connecting}));
}

/// Every output, as far as a cycle can differ in it.
void expect_same(const Outputs& a, const Outputs& b) {
  EXPECT_EQ(a.now.si, b.now.si);
  EXPECT_EQ(a.nid_ntc, b.nid_ntc);
  EXPECT_EQ(a.v, b.v);
  EXPECT_EQ(a.radio_connect.has_value(), b.radio_connect.has_value());
  EXPECT_EQ(a.radio_disconnect.has_value(), b.radio_disconnect.has_value());
  ASSERT_EQ(a.texts.size(), b.texts.size());
  for (std::size_t i = 0; i < a.texts.size(); ++i) EXPECT_EQ(a.texts[i].id, b.texts[i].id);
  EXPECT_EQ(a.mode, b.mode);
  EXPECT_EQ(a.level, b.level);
  EXPECT_EQ(a.lrbg, b.lrbg);
  EXPECT_EQ(a.est_front, b.est_front);
  EXPECT_EQ(a.min_safe_front, b.min_safe_front);
  EXPECT_EQ(a.max_safe_front, b.max_safe_front);
  EXPECT_EQ(a.monitoring, b.monitoring);
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.V_P, b.V_P);
  EXPECT_EQ(a.V_W, b.V_W);
  EXPECT_EQ(a.V_SBI, b.V_SBI);
  EXPECT_EQ(a.V_EBI, b.V_EBI);
  EXPECT_EQ(a.V_MRSP, b.V_MRSP);
  EXPECT_EQ(a.V_target, b.V_target);
  EXPECT_EQ(a.V_release, b.V_release);
  EXPECT_EQ(a.d_target, b.d_target);
  EXPECT_EQ(a.EOA, b.EOA);
  EXPECT_EQ(a.SvL, b.SvL);
  EXPECT_EQ(a.tco, b.tco);
  EXPECT_EQ(a.sb, b.sb);
  EXPECT_EQ(a.eb, b.eb);
  EXPECT_EQ(a.brake_reasons, b.brake_reasons);
  EXPECT_EQ(a.requests, b.requests);
  EXPECT_EQ(a.entries, b.entries);
  EXPECT_EQ(a.start_offered, b.start_offered);
  EXPECT_TRUE(std::equal(a.symbols.begin(), a.symbols.end(), b.symbols.begin(), b.symbols.end()));
  ASSERT_EQ(a.radio_out.size(), b.radio_out.size());
  for (std::size_t i = 0; i < a.radio_out.size(); ++i) EXPECT_EQ(a.radio_out[i].bytes, b.radio_out[i].bytes);
  ASSERT_EQ(a.events.size(), b.events.size());
  for (std::size_t i = 0; i < a.events.size(); ++i) EXPECT_EQ(a.events[i], b.events[i]);
}

TEST_F(Unit, gives_outputs_that_nothing_of_the_last_cycle_is_left_in) {
  start_of_mission(Level::L1, 0, Ack::SR);
  for (int i = 0; i < 50; ++i) cycle(8.0);
  const auto same_state = std::make_unique<State>(*state);
  const auto same_derived = std::make_unique<Derived>(*derived);
  in.now = {t};
  Outputs clean;
  step(*state, *derived, in, clean);
  std::memset(static_cast<void*>(&out), 0xFF, sizeof out);
  step(*same_state, *same_derived, in, out);
  expect_same(out, clean);
}

class AnyEdition : public Unit, public ::testing::WithParamInterface<SrsVersion> {
 protected:
  AnyEdition() {
    config.srs = GetParam();
    power_up(*state, *derived, config);
  }
};
INSTANTIATE_TEST_SUITE_P(Kernel, AnyEdition,
                         ::testing::Values(SrsVersion::v3_4_0, SrsVersion::v3_6_0, SrsVersion::v4_0_0));

TEST_P(AnyEdition, a_group_at_the_EOA_trips_in_release_speed_monitoring_of_4_0_0) {
  start_of_mission(Level::L1, 0, Ack::SR);
  for (int i = 0; i < 50; ++i) cycle(8.0);
  LevelOne data(2000, 20);
  data.ma.Q_DANGERPOINT.raw = 1;
  data.ma.D_DP.raw = 100;
  data.ma.V_RELEASEDP.raw = 6;
  lang::Packet5 linking;
  linking.Q_DIR.raw = 1;
  linking.Q_SCALE.raw = 1;
  linking.D_LINK.raw = 2006;
  linking.NID_BG.raw = 101;
  linking.Q_LINKORIENTATION.raw = 1;
  linking.Q_LINKREACTION.raw = 2;
  linking.Q_LOCACC.raw = 5;
  pass(telegram(100, 0, 1, true, linking, data.ma, data.gradient, data.ssp), telegram(100, 1, 1, true), 8.0);
  const double group_101 = front - 3.0 + 2006.0;
  for (int i = 0; i < 10; ++i) cycle(8.0);
  ASSERT_EQ(out.mode, Mode::FS);
  state->level.level = Level::L2;  // as after a transition that does not delete the authority
  while (front < group_101 - 1.0) cycle(8.0);
  ASSERT_EQ(out.monitoring, Monitoring::RSM);
  ASSERT_EQ(out.mode, Mode::FS) << "the min safe front end is in rear of the EOA";
  const std::optional<OdometerPlace> EOA = out.EOA;
  // Only one of the two balises is read: no message, no new position. Only the place of the group gives the train's
  // position.
  front = group_101;
  const Telegram first = telegram(101, 0, 1, true);
  const std::array<BaliseTelegram, 1> read{BaliseTelegram{first.bytes, first.bits, {{front}}}};
  in.balise_telegrams = read;
  for (int i = 0; i < 30; ++i) cycle(5.0);
  ASSERT_LT(out.min_safe_front, EOA);
  EXPECT_EQ(out.mode, GetParam() == SrsVersion::v4_0_0 ? Mode::TR : Mode::FS);
}

TEST_P(AnyEdition, derived_data_follow_from_the_state_alone) {
  start_of_mission(Level::L1, 0, Ack::SR);
  for (int i = 0; i < 50; ++i) cycle(8.0);
  LevelOne data(2000, 20);
  data.ma.Q_DANGERPOINT.raw = 1;
  data.ma.D_DP.raw = 50;
  data.ma.V_RELEASEDP.raw = 126;  // calculated on board
  lang::Packet5 linking;
  linking.Q_DIR.raw = 1;
  linking.Q_SCALE.raw = 1;
  linking.D_LINK.raw = 500;
  linking.NID_BG.raw = 101;
  linking.Q_LINKORIENTATION.raw = 1;
  linking.Q_LINKREACTION.raw = 2;
  linking.Q_LOCACC.raw = 5;
  pass(telegram(100, 0, 1, true, linking, data.ma, data.gradient, data.ssp), telegram(100, 1, 1, true), 8.0);
  const double group_101 = front - 3.0 + 500.0;
  double v = 8.0;
  bool second = false;
  for (int i = 0; i < 1500 && !HasFailure(); ++i) {
    // The same cycle without the derived data gives the same outputs.
    auto other_state = std::make_unique<State>(*state);
    auto other_derived = std::make_unique<Derived>();
    auto other_out = std::make_unique<Outputs>();
    // Towards the target, too fast until the unit brakes, then slowly: all types of monitoring and
    // statuses.
    v = out.sb || out.eb || out.tco ? (v > 3.0 ? v - 0.1 : v) : v < 24.0 ? v + 0.03 : v;
    const Telegram first = telegram(101, 0, 1, true);
    const Telegram last = telegram(101, 1, 1, true);
    const std::array<BaliseTelegram, 2> read{BaliseTelegram{first.bytes, first.bits, {{front}}},
                                             BaliseTelegram{last.bytes, last.bits, {{front + 3.0}}}};
    Inputs same;
    if (!second && front >= group_101) {
      second = true;
      in.balise_telegrams = read;
    }
    same = in;
    cycle(v);
    same.odometry = in.odometry;
    same.now = in.now;
    step(*other_state, *other_derived, same, *other_out);
    expect_same(*other_out, out);
    if (HasFailure()) ADD_FAILURE() << "cycle " << i << ", v " << v;
  }
  EXPECT_TRUE(second);
  EXPECT_TRUE(happened(What::linking_ok));
}

/// An on sight area of 50 m from 100 m on, then one of 500 m at a lower speed.
TEST_F(Unit, takes_the_speed_of_an_adjoining_area_of_the_same_mode) {
  start_of_mission(Level::L1, 0, Ack::SR);
  for (int i = 0; i < 50; ++i) cycle(5.0);
  const LevelOne data(2000, 20);
  lang::Packet80 profile;
  profile.Q_DIR.raw = 1;
  profile.Q_SCALE.raw = 1;
  profile.D_MAMODE.raw = 100;
  profile.M_MAMODE.raw = 0;
  profile.V_MAMODE.raw = 5;
  profile.L_MAMODE.raw = 150;
  profile.L_ACKMAMODE.raw = 100;
  lang::Packet80_modes next;
  next.D_MAMODE.raw = 150;
  next.M_MAMODE.raw = 0;
  next.V_MAMODE.raw = 3;
  next.L_MAMODE.raw = 500;
  next.L_ACKMAMODE.raw = 50;
  ASSERT_TRUE(profile.modes.push_back(next));
  const double at = front;
  pass(telegram(100, 0, 1, true, data.ma, data.gradient, data.ssp, profile), telegram(100, 1, 1, true), 5.0);
  double slowest = 100.0;
  double fastest_in_OS = 0.0;
  for (int i = 0; i < 800 && front < at + 400.0; ++i) {
    if (out.requests.has(Ack::OS)) in.driver.acknowledged = 1u << static_cast<unsigned>(Ack::OS);
    cycle(out.mode == Mode::OS && front > at + 200.0 ? 3.0 : 5.0);
    if (out.mode != Mode::OS || !out.V_P) continue;
    fastest_in_OS = std::max(fastest_in_OS, out.V_P->si * 3.6);
    slowest = std::min(slowest, out.V_P->si * 3.6);
  }
  EXPECT_NEAR(fastest_in_OS, 25.0, 1e-9);
  EXPECT_NEAR(slowest, 15.0, 1e-9) << "the lower speed of the second area";
}

TEST_F(Unit, refuses_a_group_with_more_packets_than_it_takes) {
  start_of_mission(Level::L1, 0, Ack::SR);
  for (int i = 0; i < 50; ++i) cycle(8.0);
  lang::Packet66 revocation;
  revocation.Q_DIR.raw = 1;
  lang::Packet135 the_one_too_many;
  the_one_too_many.Q_DIR.raw = 1;
  std::array<Telegram, 2> telegrams;
  for (std::uint8_t pig = 0; pig < 2; ++pig) {
    Telegram& full = telegrams[pig];
    BitWriter bits(full.bytes);
    lang::TelegramHeader h;
    h.N_PIG.raw = pig;
    h.N_TOTAL.raw = 1;
    h.NID_C.raw = 1;
    h.NID_BG.raw = 300;
    h.Q_LINK.raw = 1;
    lang::begin_telegram(bits, h);
    for (int i = 0; i < 24; ++i) {
      ++revocation.NID_TSR.raw;
      lang::encode(bits, revocation);
    }
    if (pig == 1) lang::encode(bits, the_one_too_many);
    lang::end_telegram(bits, 830);
    ASSERT_FALSE(bits.faulty());
    full.bits = 830;
  }
  pass(telegrams[0], telegrams[1], 8.0);
  for (int i = 0; i < 3; ++i) cycle(8.0);
  EXPECT_TRUE(happened(What::group_too_many_packets));
  EXPECT_TRUE(out.sb) << "as for a message that is not consistent";
}

TEST_F(Unit, a_ninth_unprotected_crossing_ends_the_authority_in_front_of_it) {
  start_of_mission(Level::L1, 0, Ack::SR);
  for (int i = 0; i < 50; ++i) cycle(8.0);
  const LevelOne data(3000, 20);
  std::array<lang::Packet88, 9> crossings;
  for (std::size_t i = 0; i < crossings.size(); ++i)
    crossings[i] = unprotected_crossing(i < 8 ? 2500 : 1500, static_cast<std::uint8_t>(i));
  const double at = front;
  pass(telegram(100, 0, 1, true, data.ma, data.gradient, data.ssp, crossings[0], crossings[1], crossings[2]),
       telegram(100, 1, 1, true, crossings[3], crossings[4], crossings[5], crossings[6], crossings[7], crossings[8]),
       8.0);
  for (int i = 0; i < 3; ++i) cycle(8.0);
  EXPECT_TRUE(happened(What::track_description_ended));
  ASSERT_TRUE(out.EOA.has_value());
  EXPECT_NEAR(out.EOA->from_origin.si, at - config.train.L_antenna_front.si + 1500.0, 1.0);
}

TEST_F(Unit, takes_no_SR_speed_that_is_none) {
  start_of_mission(Level::L1, 0, Ack::SR);
  for (const double v : {-1.0, std::numeric_limits<double>::quiet_NaN(), 500.0}) {
    in.driver.V_sr = Speed{v};
    cycle();
    EXPECT_TRUE(happened(What::SR_data_out_of_range));
    EXPECT_NEAR(out.V_P->si * 3.6, 40.0, 1e-9);
    events.clear();
  }
  in.driver.V_sr = Speed{25.0 / 3.6};
  cycle();
  EXPECT_NEAR(out.V_P->si * 3.6, 25.0, 1e-9);
}

/// Group 102 gives the train an on sight area 300 m on in its own authority, and behind packet 136 one 800 m beyond
/// group 103 in that of the infill: each belongs to its own.
TEST_F(Unit, keeps_the_mode_profiles_before_and_behind_packet_136_apart) {
  start_of_mission(Level::L1, 0, Ack::SR);
  for (int i = 0; i < 50; ++i) cycle(8.0);
  lang::Packet5 linking;
  linking.Q_DIR.raw = 1;
  linking.Q_SCALE.raw = 1;
  linking.D_LINK.raw = 1000;
  linking.NID_BG.raw = 103;
  linking.Q_LINKORIENTATION.raw = 1;
  linking.Q_LINKREACTION.raw = 2;
  linking.Q_LOCACC.raw = 5;
  const LevelOne data(1500, 20);
  lang::Packet80 main;
  main.Q_DIR.raw = 1;
  main.Q_SCALE.raw = 1;
  main.D_MAMODE.raw = 300;
  main.M_MAMODE.raw = 0;
  main.V_MAMODE.raw = 6;
  main.L_MAMODE.raw = 100;
  pass(telegram(101, 0, 1, true, data.ma, data.gradient, data.ssp), telegram(101, 1, 1, true), 8.0);
  for (int i = 0; i < 10; ++i) cycle(8.0);
  ASSERT_EQ(out.mode, Mode::FS) << "infill is taken with an authority only";
  lang::Packet136 infill;
  infill.Q_DIR.raw = 1;
  infill.NID_BG.raw = 103;
  LevelOne beyond(1500, 20);
  lang::Packet80 later = main;
  later.D_MAMODE.raw = 800;
  const double at = front - config.train.L_antenna_front.si;
  pass(telegram(102, 0, 1, true, linking, data.ma, data.gradient, data.ssp, main),
       telegram(102, 1, 1, true, infill, beyond.ma, beyond.gradient, beyond.ssp, later), 8.0);
  for (int i = 0; i < 3; ++i) cycle(8.0);
  std::vector<double> areas;
  for (const track::ModeArea& a : state->track.mode_profile)
    areas.push_back(position::counter_of(state->position, a.from).from_origin.si - at);
  ASSERT_EQ(areas.size(), 2u);
  EXPECT_NEAR(areas[0], 300.0, 1.0);
  EXPECT_NEAR(areas[1], 1800.0, 1.0);
}

TEST_F(Unit, supervises_the_ceiling_also_backwards) {
  start_of_mission(Level::L1, 0, Ack::SR);
  in.driver.selected = 1u << static_cast<unsigned>(Select::shunting);
  for (int i = 0; i < 5; ++i) cycle();
  ASSERT_EQ(out.mode, Mode::SH);
  in.train.direction_controller = DirectionController::backward;
  double v = 0.0;
  for (int i = 0; i < 400 && !out.eb && v > -20.0; ++i) {
    v -= 0.1;
    cycle(v);
  }
  EXPECT_TRUE(out.eb) << "propelled at " << v * 3.6 << " km/h";
  EXPECT_LT(v, -30.0 / 3.6);
  EXPECT_GT(v, -45.0 / 3.6);
}

/// An LOA at 2000 m and an unprotected crossing at 1500 m: the crossing is the end, until it is reported protected.
TEST_F(Unit, an_unprotected_crossing_is_supervised_in_rear_of_an_LOA) {
  start_of_mission(Level::L1, 0, Ack::SR);
  for (int i = 0; i < 50; ++i) cycle(8.0);
  LevelOne data(2000, 20);
  data.ma.V_EMA.raw = 8;
  const lang::Packet88 crossing = crossing_with_stop(1500, 50);
  const double at = front - config.train.L_antenna_front.si;
  pass(telegram(100, 0, 1, true, data.ma, data.gradient, data.ssp, crossing), telegram(100, 1, 1, true), 8.0);
  double v = 8.0;
  bool braked = false;
  for (int i = 0; i < 4000 && !(braked && v <= 0.0); ++i) {
    braked = braked || out.eb || out.sb;
    v = braked ? (v > 0.08 ? v - 0.08 : 0.0) : v < 25.0 ? v + 0.05 : v;
    cycle(v);
  }
  EXPECT_TRUE(braked);
  EXPECT_LT(front, at + 1500.0) << "stopped in rear of the crossing";
  EXPECT_EQ(out.mode, Mode::FS);
}

/// The driver stops in the stopping area: then the crossing may be passed at its speed (5.16.2).
TEST_F(Unit, a_stop_in_the_stopping_area_lifts_the_stop_at_a_crossing) {
  start_of_mission(Level::L1, 0, Ack::SR);
  for (int i = 0; i < 50; ++i) cycle(8.0);
  const LevelOne data(2000, 20);
  const lang::Packet88 crossing = crossing_with_stop(400, 60);
  const double at = front - config.train.L_antenna_front.si;
  pass(telegram(100, 0, 1, true, data.ma, data.gradient, data.ssp, crossing), telegram(100, 1, 1, true), 8.0);
  cycle(8.0);
  ASSERT_TRUE(out.EOA.has_value());
  EXPECT_NEAR(out.EOA->from_origin.si, at + 400.0, 1.0);
  while (front < at + 250.0) cycle(6.0);
  for (int i = 0; i < 20; ++i) cycle(0.0);
  EXPECT_NEAR(out.EOA->from_origin.si, at + 400.0, 1.0) << "too early to count";
  while (front < at + 360.0) cycle(2.0);
  for (int i = 0; i < 20; ++i) cycle(0.0);
  EXPECT_TRUE(happened(What::level_crossing_speed));
  EXPECT_NEAR(out.EOA->from_origin.si, at + 2000.0, 1.0);
  EXPECT_NEAR(out.V_P->si * 3.6, 20.0, 1e-9);
}

/// A restriction ahead in SR where no gradient is known: the default gradient of packet 141 brakes it earlier
/// (3.13.4.1.3).
TEST_F(Unit, the_default_gradient_counts_for_a_restriction_on_unknown_track) {
  const auto speed_at_which_it_brakes = [this](bool with_default) {
    power_up(*state, *derived, config);
    front = doubt = speed = t = 0.0;
    events.clear();
    start_of_mission(Level::L1, 0, Ack::SR);
    in.driver.V_sr = Speed{110.0 / 3.6};
    for (int i = 0; i < 50; ++i) cycle(0.0);
    for (int i = 0; i < 50; ++i) cycle(8.0);
    lang::Packet65 tsr;
    tsr.Q_DIR.raw = 1;
    tsr.Q_SCALE.raw = 1;
    tsr.NID_TSR.raw = 1;
    tsr.D_TSR.raw = 1500;
    tsr.L_TSR.raw = 500;
    tsr.V_TSR.raw = 4;
    lang::Packet141 fall;
    fall.Q_DIR.raw = 1;
    fall.Q_GDIR.raw = 0;
    fall.G_TSR.raw = 20;
    if (with_default)
      pass(telegram(100, 0, 1, true, tsr, fall), telegram(100, 1, 1, true), 8.0);
    else
      pass(telegram(100, 0, 1, true, tsr), telegram(100, 1, 1, true), 8.0);
    const double at = front;
    double v = 8.0;
    while (!out.sb && !out.eb && front < at + 1500.0) {
      v = v < 25.0 ? v + 0.05 : v;
      cycle(v);
    }
    return front - at;
  };
  const double level = speed_at_which_it_brakes(false);
  const double falling = speed_at_which_it_brakes(true);
  EXPECT_LT(falling, level - 50.0);
}

TEST_F(Unit, the_state_is_small_and_plain) {
  EXPECT_LE(sizeof(State), 64u * 1024u);
  EXPECT_TRUE(std::is_trivially_copyable_v<State>);
}

}  // namespace
}  // namespace evc::kernel::test
