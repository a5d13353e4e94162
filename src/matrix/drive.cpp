#include "matrix/drive.h"

#include <utility>

#include "io/input_stream.h"
#include "kernel/evc.h"

namespace evc::matrix {

DrivenTrain::DrivenTrain(const sim::Line& line, io::Train its_train)
    : train(std::move(its_train)), world(line, train.data, train.dynamics, sim::World::Settings{}) {
  io::Configuration configuration;
  configuration.train = train;
  kernel::power_up(state, derived, configuration.for_kernel());
}

bool DrivenTrain::drive_to(double at_m) {
  do {
    kernel::step(state, derived, world.advance().view(), outputs);
    world.observe(outputs);
    if (world.front_m() >= at_m) return true;
  } while (!world.finished());
  return false;
}

}  // namespace evc::matrix
