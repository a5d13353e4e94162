// Every value of the kernels has the bits of sdm::explain, with each set of instructions that the machine has.
#include "batch/limits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "batch/kernel.h"
#include "sdm/test_cases.h"

namespace {

using namespace evc;
using namespace evc::batch;
using sdm::test::Dice;
using sdm::test::kmh;

constexpr const char* kNames[kOutputs] = {"EBD", "SBD", "GUI",   "EBI",   "SBI1",  "SBI2",  "FLOI",  "W",
                                          "P",   "I",   "W_EOA", "P_EOA", "I_EOA", "W_SvL", "P_SvL", "I_SvL"};
constexpr unsigned kAllColumns = (1u << kOutputs) - 1;
using Columns = std::array<std::vector<double>, kOutputs>;

LimitsOut out_of(Columns& c) {
  return {c[kEBD], c[kSBD], c[kGUI],   c[kEBI],   c[kSBI1],  c[kSBI2],  c[kFLOI],  c[kW],
          c[kP],   c[kI],   c[kW_EOA], c[kP_EOA], c[kI_EOA], c[kW_SvL], c[kP_SvL], c[kI_SvL]};
}

batch::Target of(const sdm::Target& t) {
  batch::Target target;
  target.kind = t.kind;
  target.location = t.kind == sdm::TargetKind::EOA_SvL ? t.d_EOA : t.d_target;
  target.SvL = t.d_target;
  target.V_target = t.V_target;
  target.due_to_TSR = t.due_to_TSR;
  return target;
}

/// What the issue has and the random cases of src/sdm have not: guidance, TSR targets, the end of SR, special brakes
/// that do not count on a part of the track, tracks of many steps.
sdm::test::RandomCase varied_case(std::uint64_t seed) {
  Dice dice(seed ^ 0xba7c4ull);
  sdm::test::RandomCase c = sdm::test::random_case(seed, static_cast<SrsVersion>(seed % 3));
  sdm::Inputs& in = c.in;
  if (dice.chance(0.3)) {
    in.national_values.Q_NVGUIPERM = true;
    for (auto& model : in.train.normal_service.A_brake_normal_service) {
      (void)model.append(kmh(0.0), {dice.real(0.3, 0.9)});
      if (dice.chance(0.5)) (void)model.append(kmh(60.0), {dice.real(0.3, 0.9)});
    }
    in.train.normal_service.A_SB01 = {0.5};
    in.train.normal_service.A_SB12 = {0.8};
    if (dice.chance(0.5)) {
      (void)in.train.Kn_plus.append(kmh(0.0), {dice.real(0.0, 9.0)});
      (void)in.train.Kn_minus.append(kmh(0.0), {dice.real(0.0, 9.0)});
      (void)in.train.Kn_minus.append(kmh(90.0), {dice.real(0.0, 9.0)});
    }
  }
  if (dice.chance(0.3)) {
    in.gradient.default_for_TSR = static_cast<double>(dice.integer(-10, 10));
    for (bool& TSR : in.mrsp_due_to_TSR) TSR = dice.chance(0.5);
  }
  if (in.authority.kind == sdm::Authority::Kind::LOA && dice.chance(0.5)) in.SR_end = in.authority.EOA + Distance{77.0};
  if (dice.chance(0.05)) {
    in.train.regenerative = train::SpecialBrakeInterface::both;
    in.conditions.regenerative_off = Place{{1200.0}};
  }
  if (dice.chance(0.1)) {  // 90 steps, some of them short
    in.gradient.permille = {};
    double x = -800.0;
    for (int i = 0; i < 90; ++i) {
      (void)in.gradient.permille.append({{x}}, static_cast<double>(dice.integer(-9, 9)));
      x += dice.chance(0.5) ? 3.0 : 120.0;
    }
  }
  // Targets that lie exactly on a step of the gradient.
  if (dice.chance(0.2) && in.authority.kind == sdm::Authority::Kind::EOA_SvL)
    in.authority.SvL = in.authority.EOA = in.gradient.permille.steps.back().from;
  return c;
}

/// Cases with the limits that sdm::explain gives.
struct Expected {
  Trains trains;
  std::vector<batch::Target> targets;
  std::vector<std::uint32_t> train, target;
  std::vector<double> speed;
  Columns limits;
  std::size_t vectorised = 0;
  std::size_t vectorised_of_400 = 0;

  void add(std::uint64_t seed, std::size_t speeds) {
    const sdm::test::RandomCase c = varied_case(seed);
    const auto d = sdm::test::built(c.in);
    Dice dice(seed ^ 0x5eedull);
    batch::State state;
    state.V_ura = c.motion.V_ura;
    state.A_est = c.motion.A_est;
    if (dice.chance(0.5)) state.motion = c.motion;
    const std::uint32_t number = trains.add(c.in, state);
    for (const sdm::Target& t : d->targets) {
      targets.push_back(of(t));
      for (std::size_t i = 0; i < speeds; ++i) {
        double V = dice.real(0.0, 75.0);
        if (dice.chance(0.05)) V = t.V_target.si;
        if (dice.chance(0.02)) V = 0.0;
        if (dice.chance(0.02)) V = 160.0;  // the curves end below it
        train.push_back(number);
        target.push_back(static_cast<std::uint32_t>(targets.size() - 1));
        speed.push_back(V);
        explain(c, *d, t, V, state.motion ? &*state.motion : nullptr);
      }
      if (!trains.vectorised(number)) continue;
      vectorised += speeds;
      if (c.in.srs == SrsVersion::v4_0_0) vectorised_of_400 += speeds;
    }
  }

  /// In a random order, so that the lanes of a vector differ; some runs stay together.
  void shuffle(std::uint64_t seed) {
    Dice dice(seed);
    for (std::size_t i = speed.size(); i > 1; --i) {
      const auto k = static_cast<std::size_t>(dice.integer(0, static_cast<int>(i) - 1));
      std::swap(train[i - 1], train[k]);
      std::swap(target[i - 1], target[k]);
      std::swap(speed[i - 1], speed[k]);
      for (auto& column : limits) std::swap(column[i - 1], column[k]);
    }
  }

 private:
  void explain(const sdm::test::RandomCase& c, const sdm::Derived& d, const sdm::Target& t, double V,
               const sdm::Motion* motion) {
    const sdm::Explanation e = sdm::explain(d, c.in, t, Speed{V}, c.motion.V_ura, c.motion.A_est, motion);
    const Place location = t.kind == sdm::TargetKind::EOA_SvL ? t.d_EOA : t.d_target;
    const auto put = [&](Output which, std::optional<Place> place) {
      const bool exists = place.has_value() && place->from_origin.si > -1e8;
      limits[which].push_back(exists ? (location - *place).si : std::numeric_limits<double>::quiet_NaN());
    };
    const auto of_SBD = [&](Place sdm::Limits::*limit) -> std::optional<Place> {
      return e.SBD ? std::optional(*e.SBD.*limit) : std::nullopt;
    };
    put(kEBD, e.d_EBD);
    put(kSBD, e.d_SBD);
    put(kGUI, e.d_GUI);
    put(kEBI, e.EBD.d_EBI);
    put(kSBI1, of_SBD(&sdm::Limits::d_SBI));
    put(kSBI2, e.EBD.d_SBI);
    put(kFLOI, e.d_FLOI);
    put(kW, e.d_W);
    put(kP, e.d_P);
    put(kI, e.d_I);
    put(kW_EOA, of_SBD(&sdm::Limits::d_W));
    put(kP_EOA, of_SBD(&sdm::Limits::d_P));
    put(kI_EOA, of_SBD(&sdm::Limits::d_I));
    put(kW_SvL, e.EBD.d_W);
    put(kP_SvL, e.EBD.d_P);
    put(kI_SvL, e.EBD.d_I);
  }
};

/// The instructions of the machine one after the other; the widest ones again afterwards.
std::vector<Instructions> sets_of_instructions() {
  std::array<Instructions, 8> found{};
  const std::size_t n = instructions(found);
  return {found.begin(), found.begin() + static_cast<std::ptrdiff_t>(n)};
}

/// Of the limits whose bits are set in `columns`: a kernel computes only what they need.
void expect_equal(const Expected& expected, const char* set, unsigned columns) {
  Columns limits;
  for (std::size_t k = 0; k < kOutputs; ++k)
    if ((columns >> k & 1u) != 0) limits[k].assign(expected.speed.size(), -777.0);
  batch::limits(expected.trains, expected.targets, {expected.train, expected.target, expected.speed}, out_of(limits));
  for (std::size_t k = 0; k < kOutputs; ++k) {
    const std::vector<double>& a = expected.limits[k];
    const std::vector<double>& b = limits[k];
    if (b.empty()) continue;
    if (std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0) continue;
    std::size_t i = 0;
    while (std::bit_cast<std::uint64_t>(a[i]) == std::bit_cast<std::uint64_t>(b[i])) ++i;
    const batch::Target& t = expected.targets[expected.target[i]];
    FAIL() << set << ", " << kNames[k] << " of case " << i << ": " << b[i] << ", expected " << a[i] << "; speed "
           << expected.speed[i] << ", target kind " << static_cast<int>(t.kind) << " at " << t.location.from_origin.si
           << " V " << t.V_target.si << ", train " << expected.train[i]
           << (expected.trains.vectorised(expected.train[i]) ? " vectorised" : " alone");
  }
}

TEST(Batch, LimitsHaveTheBitsOfSdmWithEverySetOfInstructions) {
  // EVC_CASES asks for another number of trains (campaigns).
  const int trains = sdm::test::cases(3600);
  constexpr int kTogether = 40;
  const std::vector<Instructions> sets = sets_of_instructions();
  Dice some(7);
  std::size_t compared = 0;
  std::size_t vectorised = 0;
  std::size_t vectorised_of_400 = 0;
  for (int first = 0; first < trains && !::testing::Test::HasFatalFailure(); first += kTogether) {
    Expected expected;
    for (int i = first; i < std::min(first + kTogether, trains); ++i) expected.add(static_cast<std::uint64_t>(i), 110);
    if (first % (2 * kTogether) == 0) expected.shuffle(static_cast<std::uint64_t>(first));
    for (const Instructions& set : sets) {
      use_only(set.target);
      expect_equal(expected, set.name, kAllColumns);
      // Each one alone in turn, and some of them.
      expect_equal(expected, set.name, 1u << static_cast<unsigned>(first / kTogether) % unsigned{kOutputs});
      expect_equal(expected, set.name, static_cast<unsigned>(some.integer(1, static_cast<int>(kAllColumns) - 1)));
    }
    compared += expected.speed.size();
    vectorised += expected.vectorised;
    vectorised_of_400 += expected.vectorised_of_400;
  }
  use_only(0);
  std::string names;
  for (const Instructions& set : sets) names += std::string(names.empty() ? "" : " ") + set.name;
  RecordProperty("instructions", names);
  RecordProperty("cases", std::to_string(compared));
#if defined(__x86_64__)
  // Every such machine has SSE2, and SSE4 since 2008.
  EXPECT_GE(sets.size(), 2u);
#else
  EXPECT_GE(sets.size(), 1u);
#endif
  EXPECT_GE(compared, trains >= 3600 ? 1000000u : 1u);
  EXPECT_GE(static_cast<double>(vectorised), 0.7 * static_cast<double>(compared));
  EXPECT_GE(static_cast<double>(vectorised_of_400), 0.2 * static_cast<double>(compared));
}

TEST(Batch, ASpeedThatIsNotANumberHasNoLimits) {
  Trains trains;
  sdm::Inputs in = sdm::test::simple_inputs();
  (void)trains.add(in);
  in.national_values.Q_NVGUIPERM = true;
  for (auto& model : in.train.normal_service.A_brake_normal_service) (void)model.append(kmh(0.0), {0.5});
  in.train.normal_service.A_SB01 = {0.4};
  in.train.normal_service.A_SB12 = {0.6};
  (void)trains.add(in);
  in.train.regenerative = train::SpecialBrakeInterface::both;
  in.conditions.regenerative_off = Place{{1200.0}};
  (void)trains.add(in);
  ASSERT_TRUE(trains.vectorised(1));
  ASSERT_FALSE(trains.vectorised(2));
  std::vector<batch::Target> targets(2);
  targets[0].location = targets[0].SvL = {{2000.0}};
  targets[1].kind = sdm::TargetKind::MRSP;
  targets[1].location = {{1500.0}};
  targets[1].V_target = kmh(40.0);
  std::vector<std::uint32_t> train, target;
  std::vector<double> speed;
  for (std::uint32_t i = 0; i < 192; ++i) {  // whole vectors of them too
    train.push_back(i % 3);
    target.push_back(i / 3 % 2);
    speed.push_back(i < 64 || i % 5 == 0 ? std::numeric_limits<double>::quiet_NaN() : 20.0);
  }
  for (const Instructions& set : sets_of_instructions()) {
    use_only(set.target);
    Columns limits;
    for (auto& column : limits) column.assign(speed.size(), -777.0);
    batch::limits(trains, targets, {train, target, speed}, out_of(limits));
    for (std::size_t k = 0; k < kOutputs; ++k)
      for (std::size_t i = 0; i < speed.size(); ++i) {
        const bool of_EOA = k == kSBD || k == kSBI1 || k == kW_EOA || k == kP_EOA || k == kI_EOA;
        const bool none = std::isnan(speed[i]) || (of_EOA && target[i] != 0) || (k == kGUI && train[i] == 0);
        ASSERT_EQ(std::isnan(limits[k][i]), none) << set.name << ", " << kNames[k] << " of case " << i;
      }
  }
  use_only(0);
}

/// More arcs between the target and the foot of its curve than sdm keeps: such a curve begins at the target, and those
/// of the kernels are computed by sdm.
TEST(Batch, ACurveWithTooManyArcsBeyondItsTargetIsThatOfSdm) {
  sdm::Inputs in = sdm::test::simple_inputs();
  in.gradient.permille = {};
  for (int i = 0; i < 96; ++i) (void)in.gradient.permille.append({{1000.0 + 1.5 * i}}, i % 2 == 0 ? 0.0 : 1.0);
  in.train.L_TRAIN = {1.0};  // the lowest gradient under it changes as often
  in.authority.kind = sdm::Authority::Kind::LOA;
  in.authority.EOA = {{1000.0}};
  in.authority.V_LOA = kmh(80.0);
  const auto d = sdm::test::built(in);
  ASSERT_TRUE(d->targets.back().warnings.no_deceleration) << "more arcs fit now";
  Trains trains;
  (void)trains.add(in);
  ASSERT_TRUE(trains.vectorised(0));
  std::vector<double> speed;
  for (double v = 60.0; v < 100.0; v += 0.5) speed.push_back(kmh(v).si);
  const std::vector<batch::Target> targets{of(d->targets.back())};
  for (const Instructions& set : sets_of_instructions()) {
    use_only(set.target);
    std::vector<double> EBD(speed.size());
    std::vector<double> I(speed.size());
    batch::LimitsOut out;
    out.EBD = EBD;
    out.I = I;
    batch::limits(trains, targets, {{}, {}, speed}, out);
    for (std::size_t i = 0; i < speed.size(); ++i) {
      const sdm::Explanation e = sdm::explain(*d, in, d->targets.back(), Speed{speed[i]}, {}, {});
      ASSERT_EQ(EBD[i], (targets[0].location - e.d_EBD).si) << set.name << " " << speed[i];
      ASSERT_EQ(I[i], (targets[0].location - e.d_I).si) << set.name << " " << speed[i];
    }
  }
  use_only(0);
}

/// At both ends of the range of places, also of curves with their foot beyond the target.
TEST(Batch, PlacesAtTheEndsOfTheirRangeHaveTheBitsOfSdm) {
  for (const double at : {-0.999 * kFarthest.si, kFarthest.si}) {
    sdm::Inputs in = sdm::test::simple_inputs();
    in.gradient.permille = {};
    (void)in.gradient.permille.append({{-2e9}}, 0.0);
    for (int i = 0; i < 6; ++i) (void)in.gradient.permille.append({{at - 1500.0 + 300.0 * i}}, i % 2 == 0 ? 7.0 : -9.0);
    in.mrsp = {};
    (void)in.mrsp.append({{-2e9}}, kmh(160.0));
    in.authority.kind = sdm::Authority::Kind::LOA;
    in.authority.EOA = {{at}};
    in.authority.V_LOA = kmh(80.0);
    const auto d = sdm::test::built(in);
    Trains trains;
    (void)trains.add(in);
    ASSERT_TRUE(trains.vectorised(0));
    const std::vector<batch::Target> targets{of(d->targets.back())};
    ASSERT_TRUE(in_range(targets[0]));
    std::vector<double> speed;
    for (double v = 75.0; v < 130.0; v += 0.5) speed.push_back(kmh(v).si);
    for (const Instructions& set : sets_of_instructions()) {
      use_only(set.target);
      Columns limits;
      for (auto& column : limits) column.assign(speed.size(), -777.0);
      batch::limits(trains, targets, {{}, {}, speed}, out_of(limits));
      for (std::size_t i = 0; i < speed.size(); ++i) {
        const sdm::Explanation e = sdm::explain(*d, in, d->targets.back(), Speed{speed[i]}, {}, {});
        ASSERT_EQ(limits[kEBD][i], (targets[0].location - e.d_EBD).si) << set.name << " " << at << " " << speed[i];
        ASSERT_EQ(limits[kI][i], (targets[0].location - e.d_I).si) << set.name << " " << at << " " << speed[i];
      }
    }
    use_only(0);
  }
}

TEST(Batch, ATargetBeyondTheRangeOfPlacesIsADefectOfTheCaller) {
  Trains trains;
  (void)trains.add(sdm::test::simple_inputs());
  const std::vector<double> speed{20.0};
  std::vector<double> EBI(1);
  batch::LimitsOut out;
  out.EBI = EBI;
  for (const double wrong : {1.001e8, -1.001e8, 1e9, 2e9, 1e300, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()}) {
    batch::Target beyond;
    beyond.kind = sdm::TargetKind::LOA;
    beyond.location = {{wrong}};
    beyond.V_target = kmh(40.0);
    EXPECT_FALSE(in_range(beyond)) << wrong;
    beyond.kind = sdm::TargetKind::EOA_SvL;
    beyond.location = {{1000.0}};
    beyond.SvL = {{wrong}};
    EXPECT_FALSE(in_range(beyond)) << wrong;
    const std::vector<batch::Target> targets{beyond};
    EXPECT_DEATH(batch::limits(trains, targets, {{}, {}, speed}, out), "");
  }
}

}  // namespace
