#pragma once
#include <gtest/gtest.h>
// Random trains, tracks and targets for the property tests; seeded, so every failure can be repeated.
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <random>
#include <string>

#include "base/test_units.h"
#include "openevc/curves.h"

namespace evc::sdm::test {

using evc::test::kmh;

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  double real(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) / 9007199254740992.0);
  }
  int integer(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool chance(double p) { return real(0.0, 1.0) < p; }

 private:
  std::mt19937_64 engine_;
};

/// 2 000 in CI; EVC_CASES asks for another number (campaigns).
inline int cases(int in_ci = 2000) {
  const char* asked = std::getenv("EVC_CASES");
  return asked != nullptr ? std::atoi(asked) : in_ci;
}

/// Counts what a property compared over its cases. A loop that skips its comparisons proves nothing: at the end of the
/// test, fewer than `least` comparisons per case are a failure.
class Compared {
 public:
  Compared(int cases, double least) : cases_(cases), least_(least) {}
  Compared(const Compared&) = delete;
  Compared& operator=(const Compared&) = delete;
  ~Compared() {
    if (::testing::Test::HasFatalFailure()) return;
    const double each = static_cast<double>(number_) / cases_;
    ::testing::Test::RecordProperty("compared_in_a_case", std::to_string(each));
    EXPECT_GE(each, least_) << number_ << " comparisons in " << cases_ << " cases";
  }
  void operator++() { ++number_; }

 private:
  long number_ = 0;
  int cases_;
  double least_;
};

inline train::TrainData random_train(Dice& dice) {
  train::TrainData t;
  t.brake_position = static_cast<train::BrakePosition>(dice.integer(0, 2));
  t.L_TRAIN = {static_cast<double>(dice.integer(20, 900))};
  t.V_MAXTRAIN = kmh(5.0 * dice.integer(16, 40));
  t.T_traction_cut_off = {dice.real(0.0, 10.0)};
  t.traction_cut_off_interface = dice.chance(0.5);
  t.service_brake_interface = dice.chance(0.7);
  if (dice.chance(0.3)) t.M_rotating_nom = dice.real(2.0, 15.0);
  t.brake_percentage = dice.integer(30, 250);
  if (dice.chance(0.5)) return t;
  t.brake_model = train::BrakeModel::gamma;
  train::EmergencyModel e;
  train::ServiceModel s;
  double from = 0.0;
  const int steps = dice.integer(1, 7);
  for (int i = 0; i < steps; ++i) {
    train::EmergencyStep step;
    step.A_brake_emergency = {dice.real(0.4, 1.4)};
    step.Kwet_rst = train::Factor::of(dice.real(0.7, 1.0));
    step.Kdry_rst.fill(train::Factor::of(dice.real(0.6, 1.0)));
    (void)e.steps.append(kmh(from), step);
    (void)s.A_brake_service.append(kmh(from), {dice.real(0.3, 1.1)});
    from += 5.0 * dice.integer(2, 8);
  }
  (void)t.emergency.push_back(e);
  (void)t.service.push_back(s);
  const double T_be = dice.real(1.0, 8.0);
  const double T_bs = dice.real(1.0, 10.0);
  (void)t.T_emergency.push_back({{T_be}, {T_be * 0.4}, 0});
  (void)t.T_service.push_back({{T_bs}, {T_bs * 0.4}, 0});
  return t;
}

struct RandomCase {
  Inputs in;
  Motion motion;
};

inline RandomCase random_case(std::uint64_t seed, SrsVersion srs = SrsVersion::v3_6_0) {
  Dice dice(seed);
  RandomCase c;
  Inputs& in = c.in;
  in.revision = seed + 1;
  in.srs = srs;
  in.V_top = kmh(500.0);
  in.train = random_train(dice);
  in.national_values.Q_NVINHSMICPERM = dice.chance(0.3);
  in.national_values.Q_NVSBTSMPERM = dice.chance(0.7);
  in.national_values.M_NVAVADH = dice.chance(0.5) ? dice.real(0.0, 1.0) : 0.0;
  double x = -2000.0;
  const int gradients = dice.integer(1, 24);
  for (int i = 0; i < gradients; ++i) {
    (void)in.gradient.permille.append({{x}}, static_cast<double>(dice.integer(-18, 18)));
    x += dice.integer(1, 8) * 100.0;
  }
  if (dice.chance(0.3)) in.gradient.known_to = Place{{x}};
  const double end = dice.integer(20, 90) * 100.0;
  x = -500.0;
  int speed = dice.integer(12, 40);
  (void)in.mrsp.append({{x}}, kmh(5.0 * speed));
  const int restrictions = dice.integer(0, 8);
  for (int i = 0; i < restrictions; ++i) {
    x += dice.integer(3, 20) * 100.0;
    speed = dice.integer(6, 40);
    if (x < end) (void)in.mrsp.append({{x}}, kmh(5.0 * speed));
  }
  if (dice.chance(0.2)) in.conditions.slippery_rail = true;
  if (dice.chance(0.2)) (void)in.conditions.reduced_adhesion.push_back({{{1000.0}}, {{1600.0}}});
  Authority& a = in.authority;
  if (dice.chance(0.7)) {
    a.kind = Authority::Kind::EOA_SvL;
    a.EOA = {{end}};
    a.SvL = a.EOA + Distance{dice.chance(0.5) ? 0.0 : dice.integer(1, 200) * 1.0};
    a.release_speed = static_cast<ReleaseSpeedChoice>(dice.integer(0, 3));
    a.V_release = kmh(5.0 * dice.integer(2, 8));
    a.level_1_at_EOA = dice.chance(0.5);
    a.Q_LOCACC_reference = {5.0};
    a.reference = {{end - 800.0}};
  } else {
    a.kind = Authority::Kind::LOA;
    a.EOA = {{end}};
    a.V_LOA = kmh(5.0 * dice.integer(0, 20));
  }
  Motion& m = c.motion;
  m.est_front = {{dice.real(-400.0, end + 50.0)}};
  m.max_safe_front = m.est_front + Distance{dice.real(0.0, 60.0)};
  m.min_safe_front = m.est_front - Distance{dice.real(0.0, 60.0)};
  m.V_est = {dice.real(0.0, in.train.V_MAXTRAIN.si * 1.1)};
  m.V_ura = {dice.real(0.0, 2.0)};
  m.A_est = {dice.real(-1.0, 0.9)};
  return c;
}

/// A train for computation by hand: A_brake_safe 1.0, A_brake_service 0.8 m/s2 at any speed, T_be 8 s, T_bs 3 s,
/// traction cut-off 10 s with an interface, 100 m long; 108 km/h everywhere.
inline train::TrainData simple_train() {
  train::TrainData t;
  t.brake_model = train::BrakeModel::gamma;
  t.L_TRAIN = {100.0};
  t.V_MAXTRAIN = {30.0};
  t.T_traction_cut_off = {10.0};
  train::EmergencyModel e;
  train::EmergencyStep step;
  step.A_brake_emergency = {1.0};
  step.Kdry_rst.fill(train::Factor::of(1.0));
  (void)e.steps.append({0.0}, step);
  (void)t.emergency.push_back(e);
  train::ServiceModel s;
  (void)s.A_brake_service.append({0.0}, {0.8});
  (void)t.service.push_back(s);
  (void)t.T_emergency.push_back({{8.0}, {2.0}, 0});
  (void)t.T_service.push_back({{3.0}, {1.0}, 0});
  return t;
}

inline Inputs simple_inputs(SrsVersion srs = SrsVersion::v3_6_0) {
  Inputs in;
  in.revision = 1;
  in.srs = srs;
  in.train = simple_train();
  in.national_values.Q_NVINHSMICPERM = true;
  (void)in.gradient.permille.append({{-10000.0}}, 0.0);
  (void)in.mrsp.append({{-1000.0}}, {30.0});
  return in;
}

inline void set_EOA(Inputs& in, double EOA, double SvL) {
  in.authority.kind = Authority::Kind::EOA_SvL;
  in.authority.EOA = {{EOA}};
  in.authority.SvL = {{SvL}};
}

inline Motion at(double x, double V) {
  Motion m;
  m.est_front = m.max_safe_front = m.min_safe_front = {{x}};
  m.V_est = {V};
  m.standstill = V == 0.0;
  return m;
}

/// Everything derived from inputs that are complete.
inline std::unique_ptr<Derived> built(const Inputs& in) {
  auto d = std::make_unique<Derived>();
  EXPECT_TRUE(rebuild(*d, in));
  return d;
}
inline Decelerations determined(const Inputs& in) {
  Decelerations d;
  determine(d, in.train, in.national_values, in.fixed, in.brakes, in.gradient, in.conditions);
  return d;
}
/// Metres of a place.
inline double m(Place p) { return p.from_origin.si; }

/// Working storage of all cases: nothing that an earlier case left in it may count.
inline Derived& scratch() {
  static Derived used;
  return used;
}
inline LxSubstitution lx_substitution(const Inputs& in, const Derived& d, Place LX_start, Speed V_LX, const Motion& m) {
  return lx_substitution(in, d, LX_start, V_LX, m, scratch());
}
inline Speed permitted_braking_distance_speed(const Inputs& in, Distance permitted, double grad, bool emergency_brake) {
  return permitted_braking_distance_speed(in, permitted, grad, emergency_brake, scratch());
}

}  // namespace evc::sdm::test
