#pragma once
#include "base/test_units.h"
#include "track/description.h"
#include "track/services.h"
#include "track/store.h"

// Short notation of track data for tests.
namespace evc::track::testing {

using evc::test::at;
/// A front end in rear of everything.
inline constexpr Place kInRear = at(-1e6);

inline Here front_at(double est, double doubt = 5.0, double length = 200.0, double antenna = 5.0) {
  Here here;
  here.est_front = at(est);
  here.min_safe_front = at(est - doubt);
  here.max_safe_front = at(est + doubt);
  here.min_safe_rear = at(est - doubt - length);
  here.min_safe_antenna = at(est - doubt - antenna);
  here.hole_front = here.max_safe_front;
  here.hole_rear = here.est_front;
  return here;
}

struct SpeedAt {
  double from, kmh;
  bool no_delay = false;
};
/// A speed of 127 * 5 km/h ends the profile.
inline NewStaticSpeedProfile ssp(std::initializer_list<SpeedAt> steps) {
  NewStaticSpeedProfile profile;
  for (const SpeedAt& s : steps) {
    StaticSpeed element;
    element.V_STATIC = static_cast<SpeedCode>(s.kmh / 5.0);
    element.Q_FRONT = s.no_delay;
    profile.append(at(s.from), element);
  }
  return profile;
}
inline constexpr double kEnd = 635.0;

struct GradientAt {
  double from;
  int permille;
};
inline NewGradientProfile slopes(std::initializer_list<GradientAt> steps) {
  NewGradientProfile profile;
  for (const GradientAt& s : steps) profile.append(at(s.from), Gradient{static_cast<std::int16_t>(s.permille)});
  return profile;
}

/// An MA of one section from 0.
inline MovementAuthority authority_to(double end, double begin = 0.0) {
  MovementAuthority ma;
  Section section;
  section.begin = at(begin);
  section.end = at(end);
  if (!ma.sections.push_back(section)) __builtin_trap();
  return ma;
}

/// An MA with SSP and gradient that cover it.
inline Contents whole(double end, double kmh = 100.0) {
  Contents c;
  c.medium = Medium::rbc;
  c.ma = authority_to(end);
  c.ssp = ssp({{0.0, kmh}, {end, kEnd}});
  c.gradient = slopes({{0.0, 0}, {end, Gradient::kUnknown}});
  return c;
}

inline Mrsp mrsp(const Description& d, const MrspQuery& query) {
  Mrsp f;
  mrsp(f, d, query);
  return f;
}
inline GradientFunction gradient(const Description& d, Place from, double unknown = 0.0) {
  GradientFunction f;
  gradient(f, d, from, unknown);
  return f;
}

/// The clause that the note on a packet names.
inline Clause clause_of(const Stored& s, std::uint8_t packet) {
  for (const Note& n : s.notes)
    if (n.packet == packet && n.clause) return n.clause;
  return {};
}
inline TemporarySpeedRestriction tsr_of(std::uint8_t id, double from, double to, SpeedCode v, bool rbc = false) {
  TemporarySpeedRestriction t;
  t.NID_TSR = id;
  t.from = at(from);
  t.to = at(to);
  t.V_TSR = v;
  t.from_rbc = rbc;
  return t;
}

}  // namespace evc::track::testing
