#pragma once
#include <optional>
#include <string>
#include <vector>

#include "kernel/port.h"

namespace evc::run {

/// What the outputs of a unit were in the course of a stream: how often it intervened, its modes and levels.
class Course {
 public:
  /// After every cycle.
  void record(const kernel::Outputs& outputs);

  struct Interventions {
    int tco = 0, sb = 0, eb = 0, trip = 0;
  };
  const Interventions& interventions() const { return interventions_; }
  /// In order, without NP.
  const std::vector<std::string>& modes() const { return modes_; }
  /// In order, from the first mission on.
  const std::vector<std::string>& levels() const { return levels_; }
  std::optional<double> min_margin_to_EBI_kmh() const { return min_margin_; }

 private:
  Interventions interventions_;
  std::vector<std::string> modes_, levels_;
  bool tco_ = false, sb_ = false, eb_ = false;
  std::optional<Mode> mode_;
  std::optional<Level> level_;
  std::optional<double> min_margin_;
};

}  // namespace evc::run
