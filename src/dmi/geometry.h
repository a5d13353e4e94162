#pragma once
#include <array>
#include <cmath>
#include <cstdint>

#include "dmi/screen.h"
#include "openevc/base/units.h"
#include "openevc/port/display.h"

// Where values stand on the screen: dial (015560 8.2.1.1), target distance bar (8.2.2.1), planning area (8.3.3).
namespace evc::dmi {

/// The nearest whole number within the bounds, halves upwards; `least` for what is no number.
constexpr std::int32_t whole(double value, std::int32_t least, std::int32_t most) {
  if (!(value > least)) return least;
  if (value >= most) return most;
  const double shifted = value + 0.5;
  const auto cut = static_cast<std::int32_t>(shifted);
  return cut > shifted ? cut - 1 : cut;
}
constexpr std::int16_t cells(double value) { return static_cast<std::int16_t>(whole(value, -2000, 2000)); }
/// km/h as the driver reads them.
constexpr std::int32_t whole_kmh(Speed v) { return whole(v.si * kKmh, 0, 999); }

/// Natural logarithm of a positive number, by the series of artanh: the same bits everywhere.
constexpr double natural_logarithm(double x) {
  constexpr double kLn2 = 0.69314718055994530942;
  if (!(x > 0.0)) return 0.0;
  int halvings = 0;
  while (x > 1.5 && halvings < 1100) x /= 2.0, ++halvings;
  while (x < 0.75 && halvings > -1100) x *= 2.0, --halvings;
  const double z = (x - 1.0) / (x + 1.0), z2 = z * z;
  double term = z, sum = 0.0;
  for (int n = 1; n < 40; n += 2) {
    sum += term / n;
    term *= z2;
  }
  return 2.0 * sum + halvings * kLn2;
}

struct DialRow {
  std::int16_t most;       ///< km/h
  std::int16_t long_step;  ///< km/h between long lines
  bool two_parts;          ///< half the scale beyond 200 km/h, and every second number there
};
inline constexpr std::array<DialRow, 4> kDials{DialRow{140, 20, false}, DialRow{180, 20, false},
                                               DialRow{250, 20, false}, DialRow{400, 50, true}};
constexpr const DialRow& dial_row(port::Dial dial) { return kDials[static_cast<std::size_t>(dial) & 3u]; }

/// The angle of a speed in km/h; beyond the ends of the dial that of the end.
constexpr double dial_deg(port::Dial dial, double kmh) {
  const DialRow& row = dial_row(dial);
  if (!(kmh > 0.0)) return -144.0;
  if (kmh >= row.most) return 144.0;
  if (!row.two_parts) return -144.0 + kmh * 288.0 / row.most;
  return kmh <= 200.0 ? -144.0 + kmh * 0.96 : 48.0 + (kmh - 200.0) * 0.48;
}

/// The row in A3 of the upper end of the bar for a distance in metres.
constexpr double bar_row(double d) {
  if (!(d > 0.0)) return 185.0;
  if (d <= 100.0) return 185.0 - 33.0 * d / 100.0;
  if (d >= 1000.0) return -1.0;
  return 152.0 - 153.0 * natural_logarithm(d / 100.0) / natural_logarithm(10.0);
}

/// The ranges of the planning area in metres.
inline constexpr std::array<std::int32_t, 6> kRanges{1000, 2000, 4000, 8000, 16000, 32000};

/// The row in D of a distance in metres, of a range; 283 at the front end, 21 at the range.
constexpr double planning_row(double d, double range) {
  const double linear = range / 40.0;
  if (!(d > 0.0)) return 283.0;
  if (d <= linear) return 283.0 - 33.0 * d / linear;
  return 250.0 - 229.0 * natural_logarithm(d / linear) / natural_logarithm(40.0);
}

}  // namespace evc::dmi
