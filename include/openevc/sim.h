#pragma once
/// The world around an on-board unit: a train that moves along a line, its antenna and odometer, the radio, a driver.
/// Link openevc::sim.
///
///     std::string why;
///     auto world = evc::sim::Simulation::load(line, train, {}, why);   // texts of docs/line.md and docs/train.md
///     evc::kernel::power_up(*unit, world->config());
///     while (!world->finished()) {
///       evc::kernel::step(*unit, world->advance(), outputs);
///       world->observe(outputs);
///     }
///
/// Reproducible: equal texts and settings give equal inputs. A Simulation is used by one thread at a time; different
/// ones by any threads.
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "openevc/evc.h"
#include "openevc/sim/driver_kind.h"

namespace evc::sim {

class Simulation {
 public:
  struct Settings {
    DriverKind driver = DriverKind::perfect;
    std::uint64_t seed = 1;      ///< of odometer errors and delays
    double adhesion_mps2 = 1.5;  ///< the most deceleration that the rail gives
  };
  /// `line`: an etcs-line/1 document; `train`: an etcs-train/1 document, empty for the standard train. Empty, and `why`
  /// filled, where one of them is not as it has to be.
  static std::optional<Simulation> load(std::string_view line, std::string_view train, const Settings& settings,
                                        std::string& why);
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;
  ~Simulation();

  /// The configuration of the unit.
  const kernel::Config& config() const;
  /// The inputs of the next cycle; the first one is of time 0, before anything moves. Valid until the next call.
  const kernel::Inputs& advance();
  /// What the unit answered: moves the brakes, and the driver sees it.
  void observe(const kernel::Outputs& outputs);
  /// The rear has passed the last balise group, or the front the end of the line; or the train stands for good.
  bool finished() const;

  /// Where the front end truly is, along the line, and how fast the train truly is.
  Distance front() const;
  Speed speed() const;

 private:
  struct World;
  explicit Simulation(std::unique_ptr<World> world);
  std::unique_ptr<World> world_;
};

}  // namespace evc::sim
