#pragma once
#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "port/inputs.h"
#include "port/outputs.h"
#include "sim/cycle_inputs.h"
#include "sim/driver_kind.h"
#include "sim/line.h"
#include "sim/motion.h"

namespace evc::sim {

/// What a driver reads of the display and the desk: a few of the outputs, which are much larger.
struct Seen {
  Seen() = default;
  explicit Seen(const port::Outputs& outputs);

  Mode mode = Mode::NP;
  Level level = Level::L0;
  Monitoring monitoring = Monitoring::none;
  std::optional<Speed> V_P, V_target, V_release;
  std::optional<Distance> d_target;
  bool tco = false, sb = false, eb = false;
  Set<Ack> requests;
  Set<Entry> entries;
  bool start_offered = false;
};

/// The driver: starts the mission, follows or ignores the permitted speed, acknowledges. Where the on-board gives no
/// Permitted speed, the driver uses the speeds of the line, 40 km/h where there are none, and at most 60 km/h until
/// level 2 is entered.
class Driver {
 public:
  Driver(DriverKind kind, const Line& line, const train::TrainData& train);

  /// The driver sees the outputs of the last cycle and acts in the inputs of this one.
  void act(const Seen& seen, std::int64_t t_ms, CycleInputs& inputs);
  /// The position of the handle until the next cycle.
  Handle handle(const Seen& seen, const Motion& motion, double step_s);

 private:
  void start_mission(const Seen& seen, std::int64_t t_ms, CycleInputs& inputs);
  void acknowledge(const Seen& seen, std::int64_t t_ms, CycleInputs& inputs);
  double speed_of_line(const Motion& motion) const;
  double permitted(const Seen& seen, const Motion& motion) const;
  double reckless_speed(const Seen& seen, const Motion& motion);
  bool must_stand(const Seen& seen) const;
  double margin() const;

  DriverKind kind_;
  const Line& line_;
  const train::TrainData& train_;
  bool level_2_entered_ = false;
  bool creeping_ = false;
  std::optional<double> last_wanted_;
  std::deque<double> wanted_;  // accelerations not yet acted on (late)
  std::array<std::optional<std::int64_t>, static_cast<std::size_t>(Ack::count)> asked_since_{};
  std::int64_t next_entry_ms_ = 1000;
  bool data_entered_ = false;
};

}  // namespace evc::sim
