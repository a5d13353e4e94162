#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "kernel/evc.h"
#include "run/course.h"
#include "sim/world.h"

namespace evc::run {

/// The values of one cycle for a chart: speeds in km/h, NaN where not supervised.
struct Sample {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  double t_s = 0.0, x_m = 0.0;
  double v = 0.0, mrsp = none, p = none, w = none, sbi = none, ebi = none, target = none, d_target = none,
         release = none;
  std::uint8_t mode = 0, level = 0, monitoring = 0, status = 0;
  std::uint8_t brakes = 0;  // bits: 1 traction cut-off, 2 service brake, 4 emergency brake
};

/// An event with its time and place along the run.
struct JourneyEvent {
  double t_s = 0.0, x_m = 0.0;
  std::string text;
};

/// The world at a cycle.
struct Truth {
  double front_m = 0.0;
  std::size_t deliveries = 0;  ///< messages that have come with the inputs up to this cycle
  bool reached = true;         ///< by the world; else it is late, and `front_m` is where the train was last
};

/// The measurements of a run, cycle by cycle: everything in `summary.json` and the report.
class Journey {
 public:
  /// Samples and events are for pages: a summary does not need them. Of the samples the last one is always kept.
  enum class Keep : std::uint8_t { everything, measures };
  explicit Journey(const sim::World& world, Keep keep = Keep::everything) : world_(world), keep_(keep) {}

  /// After every cycle.
  void record(const sim::CycleInputs& inputs, const kernel::Outputs& outputs, const Truth& truth);

  struct Counts {
    int groups_linked_ok = 0, groups_missed = 0, groups_rejected = 0;
    int telegrams_rejected = 0;
    int messages_accepted = 0, messages_refused = 0, messages_rejected = 0;
    int authorities_received = 0, authorities_accepted = 0;
  };
  std::size_t cycles() const { return cycles_; }
  const std::vector<Sample>& samples() const { return samples_; }
  const std::vector<JourneyEvent>& events() const { return events_; }
  const std::vector<std::string>& modes() const { return course_.modes(); }
  const std::vector<std::string>& levels() const { return course_.levels(); }
  const Course::Interventions& interventions() const { return course_.interventions(); }
  const Counts& counts() const { return counts_; }
  std::optional<double> min_margin_to_EBI_kmh() const { return course_.min_margin_to_EBI_kmh(); }
  double max_position_error_m() const { return max_position_error_; }
  int confidence_interval_violations() const { return violations_; }
  std::optional<double> svl_overrun_m() const { return svl_overrun_; }

 private:
  void note_position(const kernel::Outputs& outputs, double front_m);
  void note_events(const kernel::Outputs& outputs);
  void count(const kernel::Event& event);
  void count_messages(const kernel::Outputs& outputs, std::size_t delivered);

  const sim::World& world_;
  Keep keep_;
  std::size_t cycles_ = 0;
  std::vector<Sample> samples_;
  std::vector<JourneyEvent> events_;
  Course course_;
  Counts counts_;
  std::optional<double> svl_overrun_;
  std::optional<double> svl_m_;  // true place of the current supervised location
  double max_position_error_ = 0.0;
  int violations_ = 0;
  std::size_t next_delivery_ = 0;
  bool telegrams_in_cycle_ = false;
};

}  // namespace evc::run
