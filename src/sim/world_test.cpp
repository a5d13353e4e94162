#include "sim/world.h"

#include <gtest/gtest.h>

#include <cmath>

namespace evc::sim {
namespace {

Line plain_line() {
  Line line;
  line.name = "plain";
  line.length_m = 3000;
  line.groups = 2;
  for (std::size_t g = 0; g < 2; ++g) {
    for (unsigned pig = 0; pig < 2; ++pig) {
      Balise b;
      b.position_m = 500.0 + 1000.0 * static_cast<double>(g) + 4.0 * pig;
      b.group = g;
      b.telegram = {std::vector<std::uint8_t>(27, 0), 210};
      // N_PIG in bits 9..11, NID_BG in bits 35..48.
      b.telegram.bytes[1] = static_cast<std::uint8_t>(pig << 4);
      b.telegram.bytes[5] = static_cast<std::uint8_t>((g + 1) >> 1);
      b.telegram.bytes[6] = static_cast<std::uint8_t>((g + 1) << 7);
      line.balises.push_back(b);
    }
  }
  line.ssp = {{0, 2000, 80}, {2000, 3000, 40}};
  line.gradient = {{0, 1000, 5}, {1000, 3000, -5}};
  return line;
}

/// An on-board that lets the train run, without any supervision.
port::Outputs in_SN(const port::Inputs& inputs) {
  port::Outputs o;
  o.mode = Mode::SN;
  o.level = Level::NTC;
  o.v = inputs.odometry.V_est;
  o.est_front = inputs.odometry.nominal;
  return o;
}

TEST(World, RunsToTheEndReadsEveryBaliseAndStaysWithinTheOdometersBounds) {
  const Line line = plain_line();
  const train::TrainData train;
  World world(line, train, Dynamics{}, {});
  double fastest = 0.0, fastest_at_the_end = 0.0;
  std::size_t cycles = 0;
  while (!world.finished() && ++cycles < 10000) {
    CycleInputs& inputs = world.advance();
    const auto& o = inputs.levels.odometry;
    const double way = world.front_m() - line.start_front_m;
    EXPECT_LE(o.min.from_origin.si, way + 2e-3);
    EXPECT_GE(o.max.from_origin.si, way - 2e-3);
    EXPECT_LE(o.V_min.si, world.motion().speed() + 2e-3);
    EXPECT_GE(o.V_max.si, world.motion().speed() - 2e-3);
    fastest = std::max(fastest, world.motion().speed() * 3.6);
    if (world.front_m() > 2010.0) fastest_at_the_end = std::max(fastest_at_the_end, world.motion().speed() * 3.6);
    world.observe(in_SN(inputs.view()));
  }
  EXPECT_EQ(world.telegrams_read(), 4u);
  ASSERT_EQ(world.passings().size(), 2u);
  EXPECT_EQ(world.passings()[0].position_m, 500.0);  // the balise N_PIG 0
  EXPECT_EQ(world.passings()[1].NID_BG, 2);
  const auto reference = world.reference({0, 1});
  ASSERT_TRUE(reference);
  // The front end was at the group one antenna distance before the antenna.
  EXPECT_NEAR(reference->nominal_m, 550.0, 5.0);
  EXPECT_LE(fastest, 60.0);  // before level 2
  EXPECT_GT(fastest, 50.0);
  EXPECT_LE(fastest_at_the_end, 40.5);
}

TEST(World, TheSameSeedGivesTheSameWorld) {
  const Line line = plain_line();
  const train::TrainData train;
  World::Settings settings;
  settings.seed = 7;
  World a(line, train, Dynamics{}, settings);
  World b(line, train, Dynamics{}, settings);
  settings.seed = 8;
  World c(line, train, Dynamics{}, settings);
  bool other_differs = false;
  for (int i = 0; i < 600; ++i) {
    const auto oa = a.advance().levels.odometry;
    const auto ob = b.advance().levels.odometry;
    const auto oc = c.advance().levels.odometry;
    ASSERT_EQ(oa.nominal, ob.nominal);
    ASSERT_EQ(oa.V_est, ob.V_est);
    other_differs = other_differs || oa.nominal != oc.nominal;
    port::Inputs inputs;
    inputs.odometry = oa;
    a.observe(in_SN(inputs));
    b.observe(in_SN(inputs));
    c.observe(in_SN(inputs));
  }
  EXPECT_TRUE(other_differs);
}

TEST(World, AStandingTrainEndsTheRun) {
  const Line line = plain_line();
  const train::TrainData train;
  World world(line, train, Dynamics{}, {});
  int cycles = 0;
  while (!world.finished() && ++cycles < 5000) {
    world.advance();
    port::Outputs o;
    o.mode = Mode::SB;
    o.eb = true;
    world.observe(o);
  }
  EXPECT_LT(cycles, 1000);
  EXPECT_EQ(world.front_m(), line.start_front_m);
}

TEST(Motion, BrakesWithinTheDistanceOfItsTables) {
  const Heights level({});
  Dynamics dynamics;
  dynamics.emergency_brake = {{0, 1.0}};
  dynamics.build_up_s = 2.0;
  dynamics.davis = {0, 0, 0};
  Motion motion(dynamics, 200, 0, level, 0, 1.5);
  Handle handle;
  handle.traction = 1.0;
  while (motion.speed() < 20.0) motion.move(handle, 0.01);
  const double v = motion.speed();
  const double from = motion.front();
  handle = {};
  handle.emergency = true;
  while (motion.speed() > 0.0) motion.move(handle, 0.01);
  // Linear build-up over 2 s: 1 s of the speed is lost, less b T^2 / 24.
  EXPECT_NEAR(motion.front() - from, v * 1.0 + v * v / 2.0 - 1.0 * 4.0 / 24.0, 0.5);
  for (int i = 0; i < 1000; ++i) motion.move(handle, 0.01);
  EXPECT_EQ(motion.speed(), 0.0);
}

TEST(Motion, GradientAlongTheTrain) {
  const Heights heights({{0, 100, 10}, {100, 300, -10}});
  EXPECT_DOUBLE_EQ(heights.at(100), 1.0);
  EXPECT_DOUBLE_EQ(heights.at(200), 0.0);
  EXPECT_DOUBLE_EQ(heights.at(-50), 0.0);
  EXPECT_DOUBLE_EQ(heights.at(400), -1.0);
  Dynamics dynamics;
  dynamics.davis = {0, 0, 0};
  // Half of the train on each slope: the forces cancel.
  EXPECT_NEAR(Motion(dynamics, 200, 0, heights, 200, 1.5).coasting(), 0.0, 1e-12);
  EXPECT_NEAR(Motion(dynamics, 100, 0, heights, 300, 1.5).coasting(), 0.0981, 1e-12);
}

TEST(Motion, RollsBackOnlyWhereNothingHoldsIt) {
  const Heights heights({{-1000, 1000, 20}});
  Dynamics dynamics;
  Motion motion(dynamics, 100, 6, heights, 0, 1.5);
  Handle braked;
  braked.brake = 1.0;
  for (int i = 0; i < 500; ++i) motion.move(braked, 0.01);
  EXPECT_EQ(motion.front(), 0.0);
  for (int i = 0; i < 1000; ++i) motion.move({}, 0.01);
  EXPECT_LT(motion.speed(), 0.0);
}

TEST(Odometer, BoundsHoldOverAnyStretch) {
  Random random(3);
  Odometer odometer({}, random);
  std::vector<std::array<double, 4>> readings;
  double truth = 0.0;
  for (int i = 0; i < 4000; ++i) {
    const double way = random.between(-0.2, 0.6);
    truth += way;
    odometer.move(way, 0.01);
    if (i % 50 == 0) {
      const auto o = odometer.read(0.0);
      readings.push_back({truth, o.min.from_origin.si, o.nominal.from_origin.si, o.max.from_origin.si});
    }
  }
  for (std::size_t i = 0; i < readings.size(); ++i)
    for (std::size_t j = i + 1; j < readings.size(); ++j) {
      const double way = readings[j][0] - readings[i][0];
      EXPECT_LE(readings[j][1] - readings[i][1], way + 3e-3);
      EXPECT_GE(readings[j][3] - readings[i][3], way - 3e-3);
    }
}

TEST(Odometer, AtItsLimitsTheTrueDistanceIsAtTheBound) {
  for (const bool over : {true, false}) {
    Random random(3);
    Odometer odometer(over ? Odometer::Errors::over() : Odometer::Errors::under(), random);
    for (int i = 0; i < 10'000; ++i) odometer.move(0.5, 0.01);
    const auto o = odometer.read(0.0);
    EXPECT_NEAR((over ? o.min : o.max).from_origin.si, 5000.0, 2e-3);
    EXPECT_GE((over ? o.nominal.from_origin.si - 5000.0 : 5000.0 - o.nominal.from_origin.si), 49.0);
    EXPECT_LE(o.min.from_origin.si, 5000.0);
    EXPECT_GE(o.max.from_origin.si, 5000.0);
  }
}

port::Outputs saying(std::initializer_list<std::uint8_t> first_bytes) {
  port::Outputs o;
  port::OutgoingMessage m;
  for (const std::uint8_t b : first_bytes) (void)m.bytes.push_back(b);
  while (m.bytes.size() < 24) (void)m.bytes.push_back(0);
  (void)o.radio_out.push_back(m);
  return o;
}

/// One RBC is simulated: a call of another one while it is called or connected is counted.
TEST(TracksideRadio, CountsCallsThatNobodyAnswers) {
  const Line line = plain_line();
  Random random(1);
  TracksideRadio radio(line, {}, random);
  const auto called = [&](std::uint16_t NID_RBC, bool infill_unit = false) {
    port::Outputs o;
    o.radio_connect = port::RbcAddress{1, NID_RBC, 3};
    o.radio_connect->infill_unit = infill_unit;
    radio.hear(o, 0);
    return radio.unanswered_calls();
  };
  EXPECT_EQ(called(2), 0u);
  EXPECT_EQ(called(2), 0u) << "again, before it has answered";
  EXPECT_EQ(called(9), 1u);
  EXPECT_EQ(called(2, true), 2u);
  port::Outputs end;
  end.radio_disconnect = port::RbcAddress{1, 2, 3};
  radio.hear(end, 0);
  EXPECT_EQ(called(9), 2u) << "now it is the only one";
}

TEST(TracksideRadio, SetsUpAnswersAndKeepsAlive) {
  Line line = plain_line();
  TracksideMessage recorded;
  recorded.seq = 5;
  recorded.position_m = 100.0;
  recorded.message = {{24, 2, 0x80, 0, 0, 0, 0, 0xFF, 0xFF, 0xFF}, 80};
  line.radio.push_back(recorded);
  recorded.seq = 6;
  recorded.message.bytes[0] = 3;
  line.radio.push_back(recorded);
  Random random(1);
  TracksideRadio radio(line, 5, random);
  CycleInputs inputs;
  const auto cycle = [&](std::int64_t t_ms, const port::Outputs& o) {
    radio.hear(o, t_ms);
    inputs.clear();
    radio.deliver(t_ms + 100, 200.0, inputs);
  };
  cycle(0, {});
  EXPECT_EQ(radio.withheld(), 1u);
  EXPECT_EQ(radio.undelivered(), 1u);
  EXPECT_EQ(radio.waiting(), 0u);
  port::Outputs call;
  call.radio_connect = port::RbcAddress{1, 2, 3};
  cycle(100, call);
  std::int64_t t = 200;
  while (inputs.levels.radio_link != RadioLink::connected && t < 10000) cycle(t += 100, {});
  EXPECT_LT(t, 6000);
  cycle(t += 100, saying({155}));
  std::vector<std::uint8_t> heard;
  const auto listen = [&](std::int64_t until) {
    while (t < until) {
      cycle(t += 100, {});
      for (const Bits& b : inputs.radio) heard.push_back(b.bytes[0]);
    }
  };
  listen(t + 1000);
  EXPECT_EQ(heard, (std::vector<std::uint8_t>{32}));
  heard.clear();
  cycle(t += 100, saying({159}));
  for (const Bits& b : inputs.radio) heard.push_back(b.bytes[0]);
  EXPECT_EQ(heard, (std::vector<std::uint8_t>{24}));  // the recorded one
  EXPECT_EQ(radio.deliveries().back().seq, 5);
  const std::uint32_t stamp = inputs.radio[0].number(18, 32);
  EXPECT_EQ(stamp, static_cast<std::uint32_t>((t + 100) / 10));
  EXPECT_EQ(inputs.radio[0].number(0, 18), 24u << 10 | 10u);  // the rest is unchanged
  EXPECT_EQ(inputs.radio[0].number(50, 30), 0x00FFFFFFu);
  heard.clear();
  listen(t + 19500);
  EXPECT_TRUE(heard.empty());
  listen(t + 1000);
  EXPECT_EQ(heard, (std::vector<std::uint8_t>{24}));
  EXPECT_EQ(radio.deliveries().back().seq, -1);
  heard.clear();
  cycle(t += 100, saying({129}));
  listen(t + 1000);
  EXPECT_EQ(heard, (std::vector<std::uint8_t>{8}));
  heard.clear();
  cycle(t += 100, saying({156}));
  listen(t + 30000);
  EXPECT_EQ(heard, (std::vector<std::uint8_t>{39}));
}

/// A session of the simulated RBC at `front_m`, from the call on.
class Session {
 public:
  Session(const Line& line, std::optional<int> last_ma, double front_m)
      : random_(1), radio_(line, last_ma, random_), front_m_(front_m) {
    cycle({});
    port::Outputs call;
    call.radio_connect = port::RbcAddress{1, 2, 3};
    cycle(call);
    while (inputs_.levels.radio_link != RadioLink::connected && t_ms_ < 10000) cycle({});
  }
  /// What the RBC sends within a second after it heard the message.
  std::vector<Bits> answers(const port::Outputs& said) {
    std::vector<Bits> heard;
    for (int n = 0; n < 10; ++n) {
      cycle(n == 0 ? said : port::Outputs{});
      heard.insert(heard.end(), inputs_.radio.begin(), inputs_.radio.end());
    }
    return heard;
  }
  TracksideRadio& radio() { return radio_; }

 private:
  void cycle(const port::Outputs& outputs) {
    radio_.hear(outputs, t_ms_);
    inputs_.clear();
    t_ms_ += 100;
    radio_.deliver(t_ms_, front_m_, inputs_);
  }
  Random random_;
  TracksideRadio radio_;
  CycleInputs inputs_;
  double front_m_;
  std::int64_t t_ms_ = 0;
};

/// An MA request for this reason (8.6.2): header, Q_MARQSTREASON.
port::Outputs requesting(std::uint8_t Q_MARQSTREASON) {
  // The 74 bits of the header end in byte 9.
  return saying({132, 5, 0, 0, 0, 0, 0, 0, 0, static_cast<std::uint8_t>(Q_MARQSTREASON << 1)});
}

/// To 132 the latest authority whose place is reached, else an SR authorisation (docs/line.md, rbc).
TEST(TracksideRadio, AnswersARequestBecauseStartWasSelected) {
  Line line = plain_line();
  const auto authority = [](int seq, double at) {
    TracksideMessage m;
    m.seq = seq;
    m.position_m = at;
    m.message = {{3, 2, 0x80, 0, 0, 0, 0, 0xFF, 0xFF, static_cast<std::uint8_t>(seq)}, 80};
    return m;
  };
  line.radio = {authority(1, -60.0), authority(2, 10.0), authority(3, 500.0)};
  constexpr std::uint8_t start = 1, before_perturbation = 2;
  {
    Session none(line, std::nullopt, -100.0);
    (void)none.answers(saying({159}));
    const auto heard = none.answers(requesting(start));
    ASSERT_EQ(heard.size(), 1u);
    EXPECT_EQ(heard[0].number(0, 8), 2u);
    EXPECT_EQ(heard[0].number(51, 24), 0u);      // NID_LRBG as reported
    EXPECT_EQ(heard[0].number(77, 15), 32767u);  // D_SR: no limit
    EXPECT_EQ(none.radio().deliveries().back().seq, -1);
  }
  {
    // Delivered when the session was there, and again because of the request; that one is not counted.
    Session second(line, std::nullopt, 100.0);
    EXPECT_EQ(second.answers(saying({159})).size(), 2u);
    const auto heard = second.answers(requesting(start));
    ASSERT_EQ(heard.size(), 1u);
    EXPECT_EQ(heard[0].number(0, 8), 3u);
    EXPECT_EQ(heard[0].number(72, 8), 2u);
    EXPECT_EQ(second.radio().deliveries().back().seq, -1);
    // There is nothing new for a train that has it.
    EXPECT_TRUE(second.answers(requesting(before_perturbation)).empty());
  }
  {
    Session withheld(line, 1, 100.0);
    (void)withheld.answers(saying({159}));
    const auto heard = withheld.answers(requesting(start));
    ASSERT_EQ(heard.size(), 1u);
    EXPECT_EQ(heard[0].number(72, 8), 1u);
  }
}

/// An authority refers to a group (3.6.2.2.2): none for a train that has reported an unknown position.
TEST(TracksideRadio, ATrainWithoutAGroupGetsNoAuthority) {
  Line line = plain_line();
  TracksideMessage authority;
  authority.position_m = -60.0;
  authority.message = {{3, 2, 0x80, 0, 0, 0, 0, 0xFF, 0xFF, 0xFF}, 80};
  line.radio.push_back(authority);
  Session session(line, std::nullopt, 0.0);
  // Q_STATUS 2, packet 0 with NID_LRBG unknown: bits 74 and 99 to 122.
  const auto reporting = [](std::uint8_t NID_MESSAGE, std::size_t NID_LRBG_at, std::uint32_t NID_LRBG) {
    port::Outputs o = saying({NID_MESSAGE});
    auto& bytes = o.radio_out[0].bytes;
    for (std::size_t i = 0; i < 24; ++i)
      if ((NID_LRBG >> (23 - i)) & 1u)
        bytes[(NID_LRBG_at + i) / 8] =
            static_cast<std::uint8_t>(bytes[(NID_LRBG_at + i) / 8] | (0x80u >> ((NID_LRBG_at + i) % 8)));
    return o;
  };
  (void)session.answers(reporting(157, 74 + 2 + 23, 0xFFFFFF));
  EXPECT_TRUE(session.answers(saying({159})).empty());
  EXPECT_EQ(session.radio().undelivered(), 1u);
  EXPECT_EQ(session.radio().waiting(), 0u) << "it does not come by itself";
  port::Outputs request = reporting(132, 74 + 5 + 23, 0xFFFFFF);
  request.radio_out[0].bytes[9] = 1 << 1;
  const auto heard = session.answers(request);
  ASSERT_EQ(heard.size(), 1u);
  EXPECT_EQ(heard[0].number(0, 8), 2u);
  const auto then = session.answers(reporting(136, 74 + 23, 1));
  ASSERT_EQ(then.size(), 1u);
  EXPECT_EQ(then[0].number(0, 8), 3u);
}

TEST(TracksideRadio, GrantsShuntingWhereTheLineSaysSo) {
  for (const bool granted : {false, true}) {
    Line line = plain_line();
    line.rbc.grants_shunting = granted;
    Session session(line, std::nullopt, 0.0);
    (void)session.answers(saying({159}));
    const auto heard = session.answers(saying({130}));
    ASSERT_EQ(heard.size(), 1u);
    EXPECT_EQ(heard[0].number(0, 8), granted ? 28u : 27u);
  }
}

/// A message whose place is reached does not keep a standing train waiting for a session that nobody sets up.
TEST(World, AStandingTrainWithoutASessionEndsTheRun) {
  Line line = plain_line();
  TracksideMessage message;
  message.position_m = line.start_front_m;
  message.message = {{24, 2, 0x80, 0, 0, 0, 0, 0xFF, 0xFF, 0xFF}, 80};
  line.radio.push_back(message);
  const train::TrainData train;
  World world(line, train, Dynamics{}, {});
  std::size_t cycles = 0;
  while (!world.finished() && ++cycles < 100000) {
    (void)world.advance();
    port::Outputs stands;
    stands.mode = Mode::SB;
    world.observe(stands);
  }
  EXPECT_LT(cycles, 1000u);
  EXPECT_EQ(world.radio().undelivered(), 1u);
}

}  // namespace
}  // namespace evc::sim
