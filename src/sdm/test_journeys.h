#pragma once
// For tests: random trains on random journeys, with many cycles exactly at a limit.
#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "sdm/test_cases.h"
#include "sdm/test_reference_supervision.h"

namespace evc::sdm::test {

// ---- Trains, tracks and authorities that reach every feature -----------------------------------------

inline void vary_brakes(train::TrainData& t, Dice& dice) {
  for (auto& time : t.T_service) {
    time.T_brake = {dice.real(1.0, 10.0)};
    time.T_brake_react = {time.T_brake.si * dice.real(0.2, 1.0)};
  }
  for (auto& time : t.T_emergency) time.T_brake_react = {time.T_brake.si * dice.real(0.2, 1.0)};
}

inline void guidance(Inputs& in, Dice& dice) {
  in.national_values.Q_NVGUIPERM = true;
  train::NormalServiceModels& n = in.train.normal_service;
  n.A_SB01 = {0.5};
  n.A_SB12 = {0.8};
  for (auto& model : n.A_brake_normal_service) {
    (void)model.append({0.0}, {dice.real(0.3, 0.6)});
    (void)model.append({dice.real(5.0, 30.0)}, {dice.real(0.2, 0.6)});
  }
}

/// Speeds that fall at nearly every step: every second element is a target.
inline void dense_mrsp(Inputs& in, Dice& dice) {
  in.mrsp = {};
  double x = -500.0;
  int speed = 60;
  // Sometimes more of them than fit.
  for (int n = dice.chance(0.1) ? 128 : dice.integer(20, 40); n > 0; --n) {
    if (n > 40) speed = dice.integer(10, 60);
    (void)in.mrsp.append({{x}}, kmh(5.0 * speed));
    x += dice.integer(1, 30) * 10.0;
    speed = std::max(1, speed - dice.integer(-1, 4));
  }
}

inline void new_mrsp(Inputs& in, Dice& dice) {
  in.mrsp = {};
  in.mrsp_due_to_TSR = {};
  if (dice.chance(0.1)) return dense_mrsp(in, dice);
  double x = dice.integer(-20, -1) * 100.0;
  for (int n = dice.integer(1, 8); n > 0; --n) {
    (void)in.mrsp.append({{x}}, kmh(5.0 * dice.integer(2, 40)));
    x += dice.integer(1, 25) * 50.0;
  }
  for (bool& due_to_TSR : in.mrsp_due_to_TSR) due_to_TSR = dice.chance(0.2);
}

inline void new_authority(Inputs& in, Dice& dice) {
  Authority& a = in.authority;
  const double end = dice.integer(6, 60) * 100.0;
  a = {};
  in.SR_end.reset();
  if (dice.chance(0.1)) {
    in.SR_end = Place{{end}};
    return;
  }
  a.EOA = {{end}};
  if (dice.chance(0.15)) {
    a.kind = Authority::Kind::LOA;
    a.V_LOA = kmh(5.0 * dice.integer(0, 30));
    if (dice.chance(0.3) && a.EOA > in.mrsp.steps.back().from) (void)in.mrsp.append(a.EOA, a.V_LOA);  // alike
    return;
  }
  a.kind = Authority::Kind::EOA_SvL;
  a.SvL = a.EOA + Distance{dice.chance(0.3) ? 0.0 : dice.integer(1, 400) * 1.0};
  a.release_speed = static_cast<ReleaseSpeedChoice>(dice.integer(0, 3));
  a.V_release = dice.chance(0.1) ? Speed{0.7} : kmh(5.0 * dice.integer(1, 12));
  a.temporary = dice.chance(0.05);
  a.level_1_at_EOA = dice.chance(0.5);
  a.Q_LOCACC_reference = {5.0};
  a.reference = {{end - dice.integer(0, 800)}};
  a.confidence_interval = {dice.chance(0.5) ? 0.0 : dice.real(0.0, 100.0)};
  if (dice.chance(0.1)) in.SR_end = a.SvL;  // two ends alike
  // Slower elements about the EOA: targets between trip location and SvL, and beyond it.
  if (dice.chance(0.3)) {
    const Speed before = in.mrsp.steps.front().value;
    in.mrsp = {};
    (void)in.mrsp.append({{-2000.0}}, before);
    double x = end + dice.integer(-50, 100);
    int speed = dice.integer(4, 12);
    for (int n = 0; n < 3 && speed > 0; ++n) {
      (void)in.mrsp.append({{x}}, kmh(5.0 * speed));
      x += dice.integer(10, 200);
      speed -= dice.integer(1, 4);
    }
  }
}

inline Inputs random_inputs(std::uint64_t seed, SrsVersion srs, Dice& dice) {
  Inputs in = random_case(seed, srs).in;
  vary_brakes(in.train, dice);
  train::NationalValues& nv = in.national_values;
  nv.Q_NVEMRRLS = dice.chance(0.5);
  nv.V_NVREL = kmh(5.0 * dice.integer(1, 9));
  const auto shown = static_cast<train::MaxReducedAdhesion::Display>(dice.integer(0, 2));
  nv.A_NVMAXREDADH2 = nv.A_NVMAXREDADH3 = train::MaxReducedAdhesion::without_maximum(shown);
  if (dice.chance(0.25)) guidance(in, dice);
  if (dice.chance(0.4)) {
    nv.Q_NVSBFBPERM = in.train.service_brake_feedback = true;
    in.train.service_brake_interface = nv.Q_NVSBTSMPERM = dice.chance(0.9);
  }
  new_mrsp(in, dice);
  new_authority(in, dice);
  return in;
}

// ---- Journeys ---------------------------------------------------------------------------------------

class Journey {
 public:
  Journey(std::uint64_t seed, SrsVersion srs, bool dense = false)
      : dice_(seed * 3 + 7), in_(random_inputs(seed, srs, dice_)) {
    if (dense) dense_mrsp(in_, dice_);
    build();
    m_.now = {100.0};
    m_.est_front = m_.max_safe_front = m_.min_safe_front = {{dice_.real(-300.0, 3000.0)}};
    has_pressure_ = in_.train.service_brake_feedback && dice_.chance(0.9);
    if (dice_.chance(0.3)) m_.T_MAR = Duration{dice_.integer(0, 40) * 1.0};
    if (dice_.chance(0.7)) {
      reference.s.feedback.p0_known = true;
      reference.s.feedback.p0 = 500.0;
      reference.s.feedback.last = m_.now;
    }
    s = reference.s;
  }

  std::unique_ptr<Derived> derived = std::make_unique<Derived>();
  Supervision s;
  ReferenceSupervision reference;

  const Motion& next() {
    if (dice_.chance(0.12)) change_inputs();
    move();
    if (has_pressure_) m_.brake_pressure_kpa = pressure();
    return m_;
  }

 private:
  /// With a release speed, sometimes with targets exactly at trip location and SvL.
  void build() {
    ++in_.revision;
    rebuild(*derived, in_);
    if (!derived->release_speed.exists || !dice_.chance(0.2)) return;
    const Place trip = derived->release_speed.d_trip;
    Mrsp shorter;
    for (const auto& step : in_.mrsp.steps)
      if (step.from < trip) (void)shorter.append(step.from, step.value);
    in_.mrsp = shorter;
    (void)in_.mrsp.append(trip, kmh(5.0 * dice_.integer(2, 6)));
    if (dice_.chance(0.5)) (void)in_.mrsp.append(in_.authority.SvL, kmh(5.0));
    ++in_.revision;
    rebuild(*derived, in_);
  }

  void change_inputs() {
    const int what = dice_.integer(0, 5);
    if (what == 0) new_mrsp(in_, dice_);
    if (what == 1) new_authority(in_, dice_);
    if (what == 2) in_.authority = {};
    if (what == 3) in_.authority.release_speed = static_cast<ReleaseSpeedChoice>(dice_.integer(0, 3));
    if (what == 4) vary_brakes(in_.train, dice_);
    if (what == 5) {
      in_.authority.EOA = in_.authority.EOA + Distance{dice_.integer(-5, 10) * 50.0};
      in_.authority.SvL = in_.authority.EOA + Distance{50.0};
    }
    build();
  }

  std::optional<double> pressure() {
    if (dice_.chance(0.05)) return std::nullopt;
    const FeedbackState& f = reference.s.feedback;
    const double p0 = f.p0_known ? f.p0 : f.p_search;
    if (dice_.chance(0.5)) return p0;
    const std::array<double, 16> p{p0 - 30.0, p0 - 29.0, p0 - 31.0, p0 - 59.5, p0 - 60.0, p0 - 61.0,
                                   p0 - 45.0, p0 + 20.0, p0 - 20.0, p0 + 20.5, p0 - 20.5, 400.0,
                                   399.0,     550.0,     560.0,     p0 + 1.0};
    return p[static_cast<std::size_t>(dice_.integer(0, 15))];
  }

  Speed ceiling() const { return V_MRSP(derived->mrsp, m_.min_safe_front, m_.max_safe_front); }

  /// V_est of the next cycle; `t`: the target under test.
  Speed speed(const Target* t) {
    const Speed M = ceiling();
    const train::FixedValues& f = derived->fixed;
    const Speed Vt = t != nullptr ? t->V_target : Speed{0.0};
    const ReleaseSpeed& r = derived->release_speed;
    switch (dice_.integer(0, 19)) {
      case 0:
        return {0.0};
      case 1:
        return M;
      case 2:
        return M + dV_warning(M, f);
      case 3:
        return M + dV_sbi(M, f);
      case 4:
        return M + dV_ebi(M, f);
      case 5:
        return Vt;
      case 6:
        return Vt + dV_warning(Vt, f);
      case 7:
        return Vt + dV_sbi(Vt, f);
      case 8:
        return Vt + dV_ebi(Vt, f);
      case 9:
      case 10:
        return r.exists ? r.V_release : M;
      case 11:
        return {dice_.real(0.0, r.exists ? r.V_release.si : M.si)};
      case 12:
        return m_.V_est;
      case 13:
        return M + Speed{dice_.real(0.0, 5.0)};
      case 14:
        return {dice_.real(0.0, 3.0)};
      default:
        return Vt + Speed{dice_.real(0.0, 1.0) * std::max(M.si - Vt.si, 2.0)};
    }
  }

  /// Sets the front ends: the max safe or the estimated one exactly at `x`.
  void place(Place x, bool estimated, Distance over, Distance under) {
    m_.max_safe_front = estimated ? x + over : x;
    m_.est_front = estimated ? x : x - over;
    m_.min_safe_front = m_.est_front - under;
  }

  TargetLimits limits(const Target& t) const {
    const Speed V_delta0 = derived->Q_NVINHSMICPERM ? Speed{0.0} : m_.V_ura;
    TimesAsked q;
    if (derived->time_config.feedback_available) q.feedback = reference.feedback.towards(t);
    if (derived->rules.reduced_build_up) q.reduced_from = Fronts{m_.est_front, m_.min_safe_front};
    return limits_of(*derived, t, approach(m_.V_est, V_delta0, m_.A_est, derived->fixed), q);
  }

  /// Moves to a location at which a condition of `t` changes.
  void to_border(const Target& t, int which, Distance over, Distance under) {
    const ReleaseSpeed& r = derived->release_speed;
    const Perturbation& p = derived->perturbation;
    // With 4.0.0 the limits depend on the place.
    for (int i = 0; i < 3; ++i) {
      const TargetLimits l = limits(t);
      const Limits& E = l.SBD.has_value() ? *l.SBD : l.EBD;
      const bool est = l.SBD.has_value();
      const Distance ahead =
          m_.T_MAR.has_value() ? (ceiling() + dV_warning(ceiling(), derived->fixed)) * *m_.T_MAR : Distance{0.0};
      switch (which) {
        case 0:
        case 1:
          place(l.EBD.d_I, false, over, under);
          break;
        case 2:
          place(l.EBD.d_P, false, over, under);
          break;
        case 3:
          place(l.EBD.d_W, false, over, under);
          break;
        case 4:
          place(l.EBD.d_SBI, false, over, under);
          break;
        case 5:
          place(*l.EBD.d_EBI, false, over, under);
          break;
        case 6:
          place(E.d_I, est, over, under);
          break;
        case 7:
          place(E.d_P, est, over, under);
          break;
        case 8:
          place(E.d_W, est, over, under);
          break;
        case 9:
          place(E.d_SBI, est, over, under);
          break;
        case 10:
          place(t.d_target, false, over, under);
          break;
        case 11:
          place(r.exists ? r.d_SBI1 : t.d_target, true, over, under);
          break;
        case 12:
          place(r.exists ? r.d_SBI2 : t.d_target, false, over, under);
          break;
        case 13:
          place(t.d_preindication_EBD.value_or(t.d_target), false, over, under);
          break;
        case 14:
          place(t.d_preindication_SBD.value_or(t.d_target), true, over, under);
          break;
        case 15:
          place(p.from_EBD.value_or(t.d_target) - ahead, false, over, under);
          break;
        case 16:
          place(p.from_SBD.value_or(t.d_target) - ahead, true, over, under);
          break;
        case 17: {
          // The end or the start of an MRSP element.
          const auto& steps = derived->mrsp.steps;
          if (steps.empty()) break;
          const Place x = steps[static_cast<std::size_t>(dice_.integer(0, static_cast<int>(steps.size()) - 1))].from;
          dice_.chance(0.5) ? place(x, false, over, under) : place(x + under, true, over, under);
          break;
        }
        case 19:
        case 20:
          place(l.EBD.d_I - Distance{dice_.real(0.0, 1000.0)}, false, over, under);
          break;
        case 21:
          place(E.d_I - m_.V_est * Duration{14.0}, est, over, under);
          break;
        case 18:
          place(r.exists ? r.d_trip : t.d_target, true, over, under);
          break;
        default:
          place(l.EBD.d_I + Distance{dice_.real(0.0, 1.0) * (t.d_target - l.EBD.d_I).si}, false, over, under);
          break;
      }
    }
  }

  void move() {
    constexpr std::array<double, 5> kSteps{0.5, 1.0, 3.0, 0.25, 2.0};
    const double dt = kSteps[static_cast<std::size_t>(dice_.integer(0, 4))];
    m_.now += Duration{dt};
    const Distance over{dice_.chance(0.3) ? 0.0 : dice_.real(0.0, 60.0)};
    const Distance under{dice_.chance(0.3) ? 0.0 : dice_.real(0.0, 60.0)};
    if (dice_.chance(0.5)) m_.A_est = {dice_.chance(0.5) ? 0.0 : dice_.real(-1.0, 0.9)};
    if (dice_.chance(0.5)) m_.V_ura = {dice_.chance(0.5) ? 0.0 : dice_.real(0.0, 2.0)};
    const auto& targets = derived->targets;
    // Usually one of the last ones: the end of the authority.
    const int n = static_cast<int>(targets.size());
    const Target* t =
        n == 0 ? nullptr : &targets[static_cast<std::size_t>(dice_.chance(0.4) ? n - 1 : dice_.integer(0, n - 1))];
    if (t == nullptr || dice_.chance(0.3)) {
      place(m_.est_front + m_.V_est * Duration{dt}, true, over, under);
      m_.V_est = speed(t);
    } else {
      m_.V_est = speed(t);
      const int which = dice_.integer(0, 25);
      to_border(*t, which, over, under);
      if (dice_.chance(0.5)) {  // the ceiling may differ there
        m_.V_est = speed(t);
        to_border(*t, which, over, under);
      }
    }
    m_.standstill = m_.V_est.si == 0.0 && dice_.chance(0.8);
  }

  Dice dice_;
  Inputs in_;
  Motion m_;
  bool has_pressure_ = false;
};

}  // namespace evc::sdm::test
