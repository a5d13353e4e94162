#pragma once
#include <optional>
#include <string>

#include "io/input_stream.h"

namespace evc::io {

/// Writes the inputs made by a simulated world as a stream for `InputStream`: replaying it gives the same outputs. Such
/// a world has no source of train data but its driver.
class InputWriter {
 public:
  explicit InputWriter(const Configuration& configuration)
      : train_(configuration.train.data), train_document_(configuration.train.document) {
    config_line_ = "{\"t_ms\":0,\"config\":" + configuration.document + "}\n";
  }
  /// Appends the lines of one cycle; the first call also the line with `config`.
  void append(std::string& out, const sim::CycleInputs& cycle);
  /// What comes from the cab alone: the signals of the train that changed, what the driver did, and the windows that
  /// opened or closed. Nothing is appended where nothing is new.
  void append_cab(std::string& out, const sim::CycleInputs& cycle);

 private:
  void append_acts(std::string& out, const sim::CycleInputs& cycle);

  std::string config_line_;
  train::TrainData train_;
  std::string train_document_;
  kernel::TrainSignals signals_;
  kernel::NationalSystem national_;
  kernel::AutomaticOperation automatic_operation_;
  std::optional<bool> moved_;
  Set<kernel::Window> windows_;
  bool safety_fault_ = false;
};

/// The configuration document made from its parts, for a run without one.
std::string configuration_document(const Configuration& configuration);

}  // namespace evc::io
