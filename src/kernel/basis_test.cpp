#include "kernel/basis.h"

#include <gtest/gtest.h>

#include <memory>
#include <set>

#include "base/test_units.h"

// When the curves are built again, and with what (3.13.2, 3.13.9.4.8).
namespace evc::kernel {
namespace {

using evc::test::at;
using evc::test::kmh;

class Basis : public ::testing::Test {
 protected:
  Basis() {
    state.mode = Mode::FS;
    state.level.level = Level::L2;
    here.est_front = at(1000.0);
    here.min_safe_front = at(990.0);
    here.max_safe_front = at(1010.0);
    here.min_safe_rear = at(790.0);
    track::MovementAuthority ma;
    EXPECT_TRUE(ma.sections.push_back({at(0.0), at(3000.0)}));
    state.track.ma = ma;
    settle();
  }
  bool renew() { return renew_basis(state, train, here); }
  /// Until nothing changes any more: the key is taken with the authority before.
  void settle() {
    while (renew()) {
    }
  }
  /// Whether the curves are built again, once.
  bool renewed() {
    const bool first = renew();
    settle();
    return first;
  }
  std::optional<Speed> limit(Mode mode) {
    state.mode = mode;
    settle();
    return state.basis.key.mode_limit;
  }
  void release_on_board() {
    state.track.ma->fixed_release = track::Release{ReleaseSpeedChoice::on_board, {}};
    ++state.track.revision;
    settle();
    ASSERT_EQ(state.basis.authority.release.kind, ReleaseSpeedChoice::on_board);
  }
  void area(Mode mode, track::SpeedCode V) {
    state.track.mode_profile.clear();
    track::ModeArea a;
    a.mode = mode;
    a.from = at(900.0);
    a.to = at(2000.0);
    a.V_MAMODE = V;
    EXPECT_TRUE(state.track.mode_profile.push_back(a));
  }

  std::unique_ptr<State> memory = std::make_unique<State>();
  State& state = *memory;
  TrainSignals train;
  track::Here here;
};

TEST_F(Basis, IsRenewedOnlyWhenSomethingChanged) {  // 3.13.2
  const std::uint32_t number = state.basis.number;
  EXPECT_NE(number, 0u);
  EXPECT_FALSE(renewed());
  EXPECT_EQ(state.basis.number, number);
  here.est_front = at(1100.0);
  EXPECT_FALSE(renewed());
  ++state.revision;
  EXPECT_TRUE(renewed());
  EXPECT_EQ(state.basis.number, number + 1);
  ++state.track.revision;
  EXPECT_TRUE(renewed());
  state.mode = Mode::OS;
  EXPECT_TRUE(renewed());
}

TEST_F(Basis, IsRenewedBehindATrainThatHasRunBack) {  // A.3.6.2.1.1
  const Place rear = state.basis.min_safe_rear;
  here.min_safe_rear = rear;
  EXPECT_FALSE(renewed());
  here.min_safe_rear = rear - 0.1_m;
  EXPECT_TRUE(renewed());
  EXPECT_EQ(state.basis.min_safe_rear, rear - 0.1_m - 20_m);
  here.min_safe_rear = rear - 20_m;
  EXPECT_FALSE(renewed()) << "not for every step back";
  here.min_safe_rear = rear - 20.2_m;
  EXPECT_TRUE(renewed());
  EXPECT_EQ(state.basis.min_safe_rear, rear - 20.2_m - 20_m);
}

TEST_F(Basis, NumberZeroIsForNoCurves) {
  state.basis.number = 0xFFFFFFFF;
  ++state.revision;
  EXPECT_TRUE(renewed());
  EXPECT_EQ(state.basis.number, 1u);
}

TEST_F(Basis, IsRenewedWithEachSpecialBrake) {  // 3.13.2.2.6
  using T = TrainSignals;
  bool T::*const brakes[] = {&T::regenerative_brake_active, &T::eddy_current_brake_active,
                             &T::magnetic_shoe_brake_active, &T::ep_brake_active, &T::additional_brake_active};
  const auto only = [&](bool T::*brake) {
    for (bool T::*each : brakes) train.*each = each == brake;
    settle();
    return state.basis.key.brakes;
  };
  const std::uint8_t none = only(nullptr);
  std::set<std::uint8_t> different{none};
  for (bool T::*one : brakes) different.insert(only(one));
  EXPECT_EQ(different.size(), 6u);
  // All together are another one than any of them.
  for (bool T::*each : brakes) train.*each = true;
  EXPECT_TRUE(renewed());
}

TEST_F(Basis, Has_the_speed_of_the_slowest_area_under_the_train_or_the_nearest_ahead) {  // 3.11.7.1.1, 3.12.4.5-6
  state.national_values.V_NVONSIGHT = kmh(30.0);
  const auto put = [&](double from, double to, track::SpeedCode V) {
    track::ModeArea a;
    a.mode = Mode::OS;
    a.from = at(from);
    a.to = at(to);
    a.V_MAMODE = V;
    a.accepted = true;
    EXPECT_TRUE(state.track.mode_profile.push_back(a));
  };
  put(600.0, 800.0, 4);
  put(800.0, 1000.0, 12);
  state.mode = Mode::OS;
  const auto from = [&](double est) -> std::optional<Place> {
    here.est_front = at(est);
    here.min_safe_front = at(est - 5.0);
    here.max_safe_front = at(est + 5.0);
    const auto area = area_of_mode(state, here);
    return area ? std::optional(area->from) : std::nullopt;
  };
  EXPECT_EQ(from(500.0), at(600.0)) << "accepted ahead of both";
  EXPECT_EQ(from(700.0), at(600.0));
  EXPECT_EQ(from(804.0), at(600.0)) << "not left by the min safe front end";
  EXPECT_EQ(from(806.0), at(800.0));
  EXPECT_EQ(from(1006.0), std::nullopt);
  state.track.mode_profile[0].V_MAMODE = 12;
  state.track.mode_profile[1].V_MAMODE = track::kNoSpeed;
  EXPECT_EQ(from(794.0), at(600.0)) << "not reached by the max safe front end";
  EXPECT_EQ(from(796.0), at(800.0)) << "the national speed";
  for (track::ModeArea& a : state.track.mode_profile) a.accepted = false;
  EXPECT_EQ(from(500.0), std::nullopt);
  EXPECT_EQ(from(700.0), at(600.0));
  state.mode = Mode::LS;
  EXPECT_EQ(from(700.0), std::nullopt);
}

TEST_F(Basis, HasThePositionOfTheMoment) {  // 3.13.9.4.8.2
  state.position.now.V_est = {10.0};
  state.position.now.V_min = {9.5};
  state.position.now.V_max = {11.5};
  ++state.revision;
  settle();
  EXPECT_EQ(state.basis.min_safe_rear, at(790.0));
  EXPECT_EQ(state.basis.confidence_interval, Distance{20.0});
  EXPECT_EQ(state.basis.V_ura, Speed{1.5});
  EXPECT_EQ(state.basis.reference, std::nullopt);
  position::Reference lrbg;
  lrbg.place = at(950.0);
  lrbg.Q_LOCACC = {7.0};
  ASSERT_TRUE(state.position.references.push_back(lrbg));
  ++state.revision;
  settle();
  EXPECT_EQ(state.basis.reference, at(950.0));
  EXPECT_EQ(state.basis.Q_LOCACC, Distance{7.0});
}

TEST_F(Basis, HasAnAuthorityOnlyInFullSupervision) {  // 4.5.2
  EXPECT_EQ(state.basis.authority.EOA, at(3000.0));
  state.mode = Mode::SR;
  settle();
  EXPECT_EQ(state.basis.authority, track::Authority{});
}

TEST_F(Basis, KnowsWhetherTheEndOfAuthorityIsInLevel1) {  // 3.13.9.4.8.2
  EXPECT_FALSE(state.basis.key.level_1_at_EOA);
  state.level.level = Level::L1;
  EXPECT_TRUE(renewed());
  EXPECT_TRUE(state.basis.key.level_1_at_EOA);
  // An order that is executed in rear of the end, or at it.
  auto& pending = state.level_transition.pending.emplace();
  pending.to.level = Level::L2;
  pending.border = at(3000.0);
  EXPECT_TRUE(renewed());
  EXPECT_FALSE(state.basis.key.level_1_at_EOA);
  pending.border = at(3001.0);
  EXPECT_TRUE(renewed());
  EXPECT_TRUE(state.basis.key.level_1_at_EOA);
  state.level.level = Level::L2;
  pending.to.level = Level::L1;
  EXPECT_TRUE(renewed());
  EXPECT_FALSE(state.basis.key.level_1_at_EOA);
  pending.border = at(2000.0);
  EXPECT_TRUE(renewed());
  EXPECT_TRUE(state.basis.key.level_1_at_EOA);
}

TEST_F(Basis, IsRenewedWithTheAccuracyOnlyForAReleaseSpeedCalculatedOnBoard) {  // 3.13.9.4.8.2
  const auto wider = [&] {
    here.min_safe_front = at(900.0);
    const bool first = renewed();
    here.min_safe_front = at(990.0);
    settle();
    return first;
  };
  const auto faster = [&] {
    state.position.now.V_max = {5.0};
    const bool first = renewed();
    state.position.now.V_max = {0.0};
    settle();
    return first;
  };
  EXPECT_FALSE(wider());
  EXPECT_FALSE(faster());
  release_on_board();
  EXPECT_TRUE(wider());
  EXPECT_TRUE(faster());
  // Not for every millimetre.
  here.min_safe_front = at(989.9);
  EXPECT_FALSE(renewed());
  state.position.now.V_max = {0.1};
  EXPECT_FALSE(renewed());
  // In steps of 5 m and 0.5 m/s.
  state.position.now.V_max = {0.51};
  EXPECT_TRUE(renewed());
  here.min_safe_front = here.max_safe_front - Distance{100.1};
  settle();
  here.min_safe_front = here.max_safe_front - Distance{104.9};
  EXPECT_FALSE(renewed());
  here.min_safe_front = here.max_safe_front - Distance{105.1};
  EXPECT_TRUE(renewed());
}

TEST_F(Basis, HasTheSpeedOfTheMode) {  // 3.11.7, 4.4
  train::NationalValues& nv = state.national_values;
  nv.V_NVSHUNT = kmh(11.0);
  nv.V_NVSTFF = kmh(12.0);
  nv.V_NVONSIGHT = kmh(13.0);
  nv.V_NVLIMSUPERV = kmh(14.0);
  nv.V_NVUNFIT = kmh(15.0);
  EXPECT_EQ(limit(Mode::SH), kmh(11.0));
  EXPECT_EQ(limit(Mode::SR), kmh(12.0));
  EXPECT_EQ(limit(Mode::OS), kmh(13.0));
  EXPECT_EQ(limit(Mode::LS), kmh(14.0));
  EXPECT_EQ(limit(Mode::UN), kmh(15.0));
  EXPECT_EQ(limit(Mode::RV), Speed{}) << "none was given (3.15.4)";
  state.track.reversing_supervision.emplace().V_REVERSE = 4;
  EXPECT_EQ(limit(Mode::RV), kmh(20.0));
  for (const Mode mode : {Mode::FS, Mode::SB, Mode::SN, Mode::NL, Mode::TR}) EXPECT_EQ(limit(mode), std::nullopt);
  state.staff_responsible.V = kmh(35.0);
  EXPECT_EQ(limit(Mode::SR), kmh(35.0)) << "entered by the driver (4.4.11.1.5)";
}

TEST_F(Basis, HasTheSpeedOfTheAreaOfTheMode) {  // 3.12.4.6, 3.11.7.1
  for (const Mode mode : {Mode::OS, Mode::LS}) {
    area(mode, 5);
    EXPECT_EQ(limit(mode), kmh(25.0));
    area(mode, track::kNoSpeed);
    EXPECT_NE(limit(mode), kmh(25.0));
    EXPECT_LT(*limit(mode), kmh(101.0)) << "the national value";
  }
  area(Mode::OS, 5);
  EXPECT_EQ(limit(Mode::LS), state.national_values.V_NVLIMSUPERV) << "an area of another mode";
  EXPECT_EQ(limit(Mode::SH), state.national_values.V_NVSHUNT);
  state.V_SH = 5;  // kept from the entry: the area is deleted with it
  EXPECT_EQ(limit(Mode::SH), kmh(25.0));
}

TEST(SupervisesSpeed, InTheModesOfTheTable) {  // 4.5.2
  for (const Mode mode : {Mode::FS, Mode::OS, Mode::LS, Mode::SR, Mode::SH, Mode::UN, Mode::RV})
    EXPECT_TRUE(supervises_speed(mode));
  for (const Mode mode :
       {Mode::NP, Mode::SB, Mode::PS, Mode::SL, Mode::NL, Mode::TR, Mode::PT, Mode::SF, Mode::IS, Mode::SN})
    EXPECT_FALSE(supervises_speed(mode));
}

TEST_F(Basis, EachCombinationOfSpecialBrakesHasCurvesOfItsOwn) {  // 3.13.2.2.6
  std::set<std::uint8_t> keys;
  for (unsigned bits = 0; bits < 32; ++bits) {
    train.regenerative_brake_active = (bits & 1u) != 0;
    train.eddy_current_brake_active = (bits & 2u) != 0;
    train.magnetic_shoe_brake_active = (bits & 4u) != 0;
    train.ep_brake_active = (bits & 8u) != 0;
    train.additional_brake_active = (bits & 16u) != 0;
    settle();
    keys.insert(state.basis.key.brakes);
  }
  EXPECT_EQ(keys.size(), 32u);
}

TEST_F(Basis, ItsNumberIsNeverThatOfNone) {
  state.basis.number = 0xFFFFFFFE;
  ++state.revision;
  EXPECT_TRUE(renew());
  EXPECT_EQ(state.basis.number, 0xFFFFFFFFu);
  ++state.revision;
  EXPECT_TRUE(renew());
  EXPECT_EQ(state.basis.number, 1u) << "0: never built";
}

}  // namespace
}  // namespace evc::kernel
