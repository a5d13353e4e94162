#pragma once
#include "base/units.h"

// Places and speeds of tests.
namespace evc::test {

/// The place `metres` along the line.
constexpr Place at(double metres) { return Place{Distance{metres}}; }
/// A speed in km/h.
constexpr Speed kmh(double v) { return Speed{v / 3.6}; }

}  // namespace evc::test
