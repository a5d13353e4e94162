#pragma once
#include "position/position.h"

// Odometer readings of tests.
namespace evc::position::testing {

/// A counter at `c` metres that may be `under` metres too low or `over` metres too high.
inline OdometerReading spread(double c, double under = 0.0, double over = 0.0) {
  return {OdometerPlace{Distance{c}}, OdometerPlace{Distance{c - over}}, OdometerPlace{Distance{c + under}}};
}
inline Odometry moving(const OdometerReading& counter, double v = 10.0) {
  return {counter, Speed{v}, Speed{v}, Speed{v}, Acceleration{}};
}

}  // namespace evc::position::testing
