#include "openevc/sim.h"

#include <utility>

#include "io/input_stream.h"
#include "io/line_file.h"
#include "io/train_file.h"
#include "sim/world.h"

namespace evc::sim {
namespace {

World::Settings of(const Simulation::Settings& settings) {
  World::Settings world;
  world.driver = settings.driver;
  world.seed = settings.seed;
  world.adhesion_mps2 = settings.adhesion_mps2;
  return world;
}

kernel::Config config_of(const io::Train& train) {
  io::Configuration configuration;
  configuration.train = train;
  return configuration.for_kernel();
}

}  // namespace

/// The simulated world with what it refers to.
struct Simulation::World {
  Line line;
  io::Train train;
  kernel::Config config;
  sim::World world;

  World(Line line_, io::Train train_, const Settings& settings)
      : line(std::move(line_)),
        train(std::move(train_)),
        config(config_of(train)),
        world(line, train.data, train.dynamics, of(settings)) {}
};

std::optional<Simulation> Simulation::load(std::string_view line, std::string_view train, const Settings& settings,
                                           std::string& why) {
  auto read_line = io::read_line(line, "line");
  if (!read_line) {
    why = read_line.error().text();
    return {};
  }
  io::Result<io::Train> read_train = io::Train{};
  if (!train.empty()) read_train = io::read_train(train, "train");
  if (!read_train) {
    why = read_train.error().text();
    return {};
  }
  return Simulation(std::make_unique<World>(std::move(*read_line), std::move(*read_train), settings));
}

Simulation::Simulation(std::unique_ptr<World> world) : world_(std::move(world)) {}
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

const kernel::Config& Simulation::config() const { return world_->config; }
const kernel::Inputs& Simulation::advance() { return world_->world.advance().view(); }
void Simulation::observe(const kernel::Outputs& outputs) { world_->world.observe(outputs); }
bool Simulation::finished() const { return world_->world.finished(); }
Distance Simulation::front() const { return {world_->world.front_m()}; }
Speed Simulation::speed() const { return {world_->world.motion().speed()}; }

}  // namespace evc::sim
