#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "openevc/terms/srs_version.h"
#include "ride/given.h"
#include "ride/panel.h"
#include "ride/sha256.h"
#include "sim/cycle_inputs.h"
#include "sim/desk.h"
#include "sim/driver_kind.h"

namespace evc::ride {

/// The values of one cycle for the strip of the line and its chart. Speeds in km/h, places in metres along the line,
/// NaN where there are none. Numbers only: the page reads them as an array.
struct Point {
  double t_s = 0.0, x_m = 0.0, v = 0.0;
  double V_P = 0.0, V_W = 0.0, V_SBI = 0.0, V_EBI = 0.0, V_MRSP = 0.0, V_target = 0.0, V_release = 0.0;
  double target_m = 0.0;               ///< the place of the target
  double EOA_m = 0.0, SvL_m = 0.0;     ///< the ends of the movement authority
  double least_m = 0.0, most_m = 0.0;  ///< the safe front ends
  double brakes = 0.0;                 ///< bits: 1 traction cut-off, 2 service brake, 4 emergency brake
  double mode = 0.0, level = 0.0;      ///< as Mode, Level
  double status = 0.0;                 ///< of the supervision, as Status
};

/// A journey: the train, the line and the on-board, driven from outside. The same calls give the same bytes on every
/// machine and in every browser.
class Ride {
 public:
  struct Settings {
    std::optional<sim::DriverKind> driver;  ///< absent: driven by hand
    std::uint64_t seed = 1;                 ///< of odometer errors and delays
    std::int64_t cycle_ms = 100;
    SrsVersion srs = SrsVersion::v3_6_0;   ///< the edition of the on-board and its display
    std::optional<std::int64_t> utc = {};  ///< the begin in seconds since 1970; absent: by hand at 08:00, else no clock
  };
  Ride(Given given, const Settings& settings);
  ~Ride();
  Ride(const Ride&) = delete;
  Ride& operator=(const Ride&) = delete;

  /// Drives `cycles` cycles, fewer at the end of the journey: how many. What the cycles gave is in the texts below, in
  /// place of what the call before gave.
  int advance(int cycles);
  bool finished() const;

  void set_desk(const sim::Desk& desk);
  /// The display. What is touched there is done in the next cycle; with a simulated driver it changes the display
  /// alone.
  Panel& panel() { return *panel_; }

  /// The cycles of the last call: the lines of `evc replay`, those of inputs.jsonl, the points, and the events, each a
  /// line `{"t_s":..,"x_m":..,"text":".."}`.
  const std::string& outputs() const { return outputs_; }
  const std::string& inputs() const { return inputs_; }
  const std::vector<Point>& points() const { return points_; }
  const std::string& events() const { return events_; }

  /// `{"output_hash":"..","modes":[..],"cycles":N}` of the journey so far, as summary.json of `evc run`.
  std::string summary() const;
  /// What does not change in a journey: the line's name, its ends, groups, gradient, speeds, and the train's name and
  /// length, as JSON.
  std::string scene() const;

 private:
  struct World;
  void cycle();
  void obey(const dmi::Commands& commands, sim::CycleInputs& inputs);
  void note();

  Given given_;
  bool by_hand_;
  bool ato_active_ = false;  // 4.0.0: where the driver put the selector of automatic operation
  std::unique_ptr<World> world_;
  std::unique_ptr<Panel> panel_ = std::make_unique<Panel>();
  std::string outputs_, inputs_, events_;
  std::vector<Point> points_;
  std::vector<const char*> modes_;
  std::optional<int> mode_;
  std::int64_t cycles_ = 0;
  Sha256 hash_;
};

}  // namespace evc::ride
