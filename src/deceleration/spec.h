#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "deceleration/distribution.h"
#include "io/json.h"

namespace evc::deceleration {

/// Brake units that are alike and fail each by itself: those of one entry of `brake_units` in the vehicles of one entry
/// of `vehicles`.
struct UnitGroup {
  std::string name;
  std::string place;  ///< in the description: a JSON pointer
  std::size_t units = 1;
  /// What one unit brakes with nominally, in m/s2 of the train, by speed: [from km/h, m/s2], the first from 0.
  std::vector<std::pair<double, double>> nominal;
  Distribution friction, pressure;         ///< factors of the nominal
  std::optional<Distribution> response_s;  ///< from the command to its force
  double failure = 0.0;                    ///< probability that it is isolated or does not brake
};

/// `evc-brakes/1`.
struct Spec {
  std::string file;
  std::string name;
  std::uint64_t seed = 1;
  std::size_t samples = 20000;     ///< for each step of speed and level of confidence
  std::size_t response_level = 9;  ///< M_NVEBCL of the T_brake_emergency of the train file
  std::vector<UnitGroup> groups;
  Distribution all_units;                  ///< a factor that all units have in common
  std::vector<double> speeds_kmh;          ///< where a step begins: the change points of all units, the first 0
  double mass_t = 0.0;                     ///< of the train
  double dynamic_mass_t = 0.0;             ///< with its rotating parts
  io::Json document = io::Json::object();  ///< the whole

  std::size_t units() const;
  bool has_response() const { return groups.front().response_s.has_value(); }
};

inline constexpr std::size_t kMostUnits = 512;
inline constexpr std::size_t kMostSpeeds = 64;
inline constexpr double kLargestFailure = 0.1;

/// Reads it; `train` is read by check_train (train_document.h).
io::Result<Spec> read_spec(std::string_view text, const std::string& file);

/// The last step that begins at or before this speed: its value. Of a table that begins at 0.
double at_speed(const std::vector<std::pair<double, double>>& table, double from_kmh);

}  // namespace evc::deceleration
