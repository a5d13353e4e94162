#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "io/input_stream.h"
#include "io/input_writer.h"
#include "port/inputs.h"
#include "ride/panel.h"
#include "sim/cycle_inputs.h"

namespace evc::ride {

/// The driver's place at an on-board that runs elsewhere: its display, shown by the records that the on-board gives
/// out, and the lines for it of what the driver does. There is no world: how the train moves and what trackside sends,
/// the on-board gets from others.
class Remote {
 public:
  Remote();

  /// The first lines of a session: the configuration, with the standard train, and a train that stands.
  std::string begin() const;
  /// The record `dmi` of an output line. False: it is none, and the display stays as it was.
  bool show(std::string_view record);
  void set_desk(port::DirectionController direction, bool open);
  /// The input lines of the cycle at `t_ms` for what the driver did since the last call; empty when nothing.
  std::string acts(std::int64_t t_ms);

  Panel& panel() { return panel_; }

 private:
  io::Configuration configuration_;
  io::InputWriter writer_;
  sim::CycleInputs inputs_;
  Panel panel_;
};

}  // namespace evc::ride
