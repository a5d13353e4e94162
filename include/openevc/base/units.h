#pragma once
#include <compare>

namespace evc {

/// A number in coherent SI units: `Quantity<L, T>` is metres^L * seconds^T. The representation is a
/// double and only correctly rounded operations (+ - * / sqrt) are used on it, so every conforming
/// build of the kernel produces the same bits.
template <int L, int T>
struct Quantity {
  double si = 0.0;

  friend constexpr auto operator<=>(Quantity, Quantity) = default;
  constexpr Quantity operator-() const { return {-si}; }
  constexpr Quantity& operator+=(Quantity b) { return *this = *this + b; }
  constexpr Quantity& operator-=(Quantity b) { return *this = *this - b; }
  friend constexpr Quantity operator+(Quantity a, Quantity b) { return {a.si + b.si}; }
  friend constexpr Quantity operator-(Quantity a, Quantity b) { return {a.si - b.si}; }
  friend constexpr Quantity operator*(double k, Quantity a) { return {k * a.si}; }
  friend constexpr Quantity operator/(Quantity a, double k) { return {a.si / k}; }
};

template <int L1, int T1, int L2, int T2>
constexpr Quantity<L1 + L2, T1 + T2> operator*(Quantity<L1, T1> a, Quantity<L2, T2> b) {
  return {a.si * b.si};
}
template <int L1, int T1, int L2, int T2>
constexpr Quantity<L1 - L2, T1 - T2> operator/(Quantity<L1, T1> a, Quantity<L2, T2> b) {
  return {a.si / b.si};
}

using Ratio = Quantity<0, 0>;
using Duration = Quantity<0, 1>;
using Distance = Quantity<1, 0>;
using Speed = Quantity<1, -1>;
using SpeedSquared = Quantity<2, -2>;
using Acceleration = Quantity<1, -2>;

/// 1 m/s in km/h.
inline constexpr double kKmh = 3.6;

/// A place, as opposed to a length. Places of two frames do not mix, and two places cannot be added.
template <class Frame>
struct Position {
  Distance from_origin{};

  friend constexpr auto operator<=>(Position, Position) = default;
  friend constexpr Position operator+(Position p, Distance d) { return {p.from_origin + d}; }
  friend constexpr Position operator-(Position p, Distance d) { return {p.from_origin - d}; }
  friend constexpr Distance operator-(Position a, Position b) { return a.from_origin - b.from_origin; }
};

/// The frame in which track data are stored: metres along the line, increasing in the running
/// direction of the active cab. It is fixed to the balise groups: on a relocation to a new LRBG
/// (SUBSET-026-3 3.6.4) stored places do not change and the train moves in the frame.
struct TrackFrame;
using Place = Position<TrackFrame>;

/// The frame of the odometer's nominal counter since power-up; the counter is the place of the
/// train's front end. It never jumps.
struct OdometerFrame;
using OdometerPlace = Position<OdometerFrame>;

inline namespace literals {
constexpr Distance operator""_m(long double v) { return {static_cast<double>(v)}; }
constexpr Distance operator""_m(unsigned long long v) { return {static_cast<double>(v)}; }
constexpr Duration operator""_s(long double v) { return {static_cast<double>(v)}; }
constexpr Duration operator""_s(unsigned long long v) { return {static_cast<double>(v)}; }
constexpr Speed operator""_km_h(long double v) { return {static_cast<double>(v) / 3.6}; }
constexpr Speed operator""_km_h(unsigned long long v) { return {static_cast<double>(v) / 3.6}; }
constexpr Acceleration operator""_m_s2(long double v) { return {static_cast<double>(v)}; }
constexpr Acceleration operator""_m_s2(unsigned long long v) { return {static_cast<double>(v)}; }
}  // namespace literals

}  // namespace evc
