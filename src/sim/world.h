#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/cycle_inputs.h"
#include "sim/desk.h"
#include "sim/driver.h"
#include "sim/line.h"
#include "sim/motion.h"
#include "sim/odometer.h"
#include "sim/trackside_radio.h"

namespace evc::sim {

/// A balise group as passed: it relates the counter of the on-board to the track.
struct Passing {
  std::uint16_t NID_C = 0, NID_BG = 0;
  double position_m = 0.0;  // of its balise N_PIG 0
  double nominal_m = 0.0;   // nominal counter when the antenna was there
  std::size_t group = 0;
};

/// The world outside the on-board: the train moves along the line, its antenna reads balises, the radio delivers
/// messages, the driver drives. One call of `advance` is one cycle; `observe` passes it the outputs of the on-board.
/// Reproducible from the seed.
class World {
 public:
  struct Settings {
    DriverKind driver = DriverKind::perfect;
    std::optional<int> last_ma;
    std::uint64_t seed = 1;
    std::int64_t cycle_ms = 100;
    double adhesion_mps2 = 1.5;  // maximum deceleration that adhesion allows
    Odometer::Errors odometer;
    bool by_hand = false;  // driven at the desk from outside, not by the simulated driver
    std::optional<std::int64_t> utc =
        {};  // the on-board's clock at t = 0, in seconds since 1970; none: it has no clock
  };
  /// `line` and `train` must outlive the world: temporaries are refused.
  World(const Line& line, const train::TrainData& train, const Dynamics& dynamics, const Settings& settings);
  World(const Line&&, const train::TrainData&, const Dynamics&, const Settings&) = delete;
  World(const Line&, const train::TrainData&&, const Dynamics&, const Settings&) = delete;
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// The inputs of the next cycle; the first one is for t = 0, before anything moves.
  CycleInputs& advance();
  /// The same for an on-board that did not take the inputs of the last cycle: what belonged to it comes with this one.
  CycleInputs& advance_further();
  void observe(const port::Outputs& outputs);
  /// Where the controls of the desk are from the next cycle on; it counts in a world that is driven by hand. What is
  /// entered and acknowledged goes into the inputs that `advance` returns.
  void set_desk(const Desk& desk) { desk_ = desk; }
  /// The rear end has passed the last group, the front end has passed the end of the line, or the
  /// train has stopped and will not move again, which is not said of one that is driven by hand.
  bool finished() const { return ending().has_value(); }
  /// How the run has ended, absent while it goes on.
  enum class Ending : std::uint8_t { end_of_line, stands_for_good, too_long };
  std::optional<Ending> ending() const;
  /// The train has left its start.
  bool has_moved() const { return moved_at_ms_ > 0; }

  std::int64_t t_ms() const { return inputs_.t_ms; }
  double front_m() const { return motion_.front(); }
  double start_m() const { return start_m_; }
  double end_m() const { return end_m_; }
  const Motion& motion() const { return motion_; }
  const TracksideRadio& radio() const { return radio_; }
  /// Groups in the order they were passed, the last balise N_PIG 0 of each.
  const std::vector<Passing>& passings() const { return passings_; }
  std::size_t telegrams_read() const { return telegrams_read_; }
  /// True distance of the front end beyond the reference group `lrbg` since it was last passed, and the nominal counter
  /// when the front end was at that reference; absent if it was never passed.
  struct Reference {
    double position_m, nominal_m;
  };
  std::optional<Reference> reference(const port::NidLrbg& lrbg) const;

 private:
  void move_one_cycle();
  void read_balises(double antenna_before, double antenna_after, double nominal_before, double nominal_after);

  const Line& line_;
  const train::TrainData& train_;
  Settings settings_;
  Random random_;
  Heights heights_;
  Motion motion_;
  Odometer odometer_;
  TracksideRadio radio_;
  Driver driver_;
  Desk desk_;
  CycleInputs inputs_;
  Seen seen_;
  bool first_ = true;
  double start_m_, end_m_;
  std::int64_t moved_at_ms_ = 0;  // last time when the train was a metre away from its place of rest
  double stood_at_m_ = 0.0;
  std::size_t telegrams_read_ = 0;
  std::vector<Passing> passings_;
};

}  // namespace evc::sim
