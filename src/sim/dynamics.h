#pragma once
#include <array>
#include <utility>
#include <vector>

namespace evc::sim {

/// Data of a train that only the simulated world has, not the on-board (`dynamics` of etcs-train/1). The default is a
/// unit of 200 t whose real brakes are at least as good as the standard train's data.
struct Dynamics {
  using Table = std::vector<std::pair<double, double>>;  // (km/h, value), linear between, constant beyond the ends
  double mass_t = 200.0;
  std::array<double, 3> davis{2400.0, 40.0, 6.5};  // running resistance: A [N] + B [N/(m/s)] v + C [N/(m/s)2] v2
  Table tractive_effort{{0, 200}, {50, 200}, {80, 125}, {120, 83}, {160, 62}, {200, 50}};  // kN
  Table emergency_brake{{0, 1.35}, {200, 1.25}};                                           // m/s2
  Table service_brake{{0, 1.2}, {200, 1.1}};                                               // m/s2
  double build_up_s = 2.5;  // from nothing to the full deceleration
};

/// The value of a table at `kmh`.
double at(const Dynamics::Table& table, double kmh);

}  // namespace evc::sim
