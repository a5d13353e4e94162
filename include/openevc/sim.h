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
    double adhesion_mps2 = 1.5;  ///< maximum deceleration that adhesion allows
  };
  /// `line`: an etcs-line/1 document; `train`: an etcs-train/1 document, empty for the standard train. Empty, with the
  /// reason in `why`, if one of them is not valid.
  static std::optional<Simulation> load(std::string_view line, std::string_view train, const Settings& settings,
                                        std::string& why);
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;
  ~Simulation();

  /// The configuration of the unit.
  const kernel::Config& config() const;
  /// The inputs of the next cycle; the first one is for time 0, before anything moves. Valid until the next call.
  const kernel::Inputs& advance();
  /// Takes the outputs of the unit: applies the brakes and shows them to the driver.
  void observe(const kernel::Outputs& outputs);
  /// The rear end has passed the last balise group, the front end has passed the end of the line, or the train has
  /// stopped and will not move again.
  bool finished() const;

  /// The true place of the front end along the line, and the true speed.
  Distance front() const;
  Speed speed() const;

 private:
  struct World;
  explicit Simulation(std::unique_ptr<World> world);
  std::unique_ptr<World> world_;
};

}  // namespace evc::sim
