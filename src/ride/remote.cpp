#include "ride/remote.h"

#include <utility>

#include "io/display_reader.h"

namespace evc::ride {
namespace {

io::Configuration standard() {
  io::Configuration configuration;
  configuration.document = io::configuration_document(configuration);
  return configuration;
}

}  // namespace

Remote::Remote() : configuration_(standard()), writer_(configuration_) {}

std::string Remote::begin() const {
  return "{\"t_ms\":0,\"config\":" + configuration_.document +
         "}\n{\"t_ms\":0,\"odometer\":{\"nominal_m\":0,\"min_m\":0,\"max_m\":0,\"speed_mps\":0,\"speed_min_mps\":0,"
         "\"speed_max_mps\":0,\"accel_mps2\":0}}\n";
}

bool Remote::show(std::string_view record) {
  port::Display display;
  if (!io::read_display(record, display)) return false;
  panel_.show(display);
  return true;
}

void Remote::set_desk(port::DirectionController direction, bool open) {
  inputs_.levels.train.direction_controller = direction;
  inputs_.levels.train.desk_open = open;
}

std::string Remote::acts(std::int64_t t_ms) {
  const dmi::Commands commands = panel_.take();
  inputs_.t_ms = t_ms;
  inputs_.levels.driver = commands.actions;
  inputs_.levels.windows = commands.windows;
  inputs_.train_data.reset();
  if (commands.train_data) inputs_.train_data = dmi::with_entered(configuration_.train.data, *commands.train_data);
  std::string lines;
  writer_.append_cab(lines, inputs_);
  return lines;
}

}  // namespace evc::ride
