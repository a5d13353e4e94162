#pragma once
#include <memory>
#include <span>
#include <vector>

#include "dmi/dmi.h"
#include "io/display_json.h"
#include "kernel/port.h"

namespace evc::run {

/// The sounds (015560 14) that a driver-machine interface orders, cycle by cycle. Nobody touches it: the driver's
/// actions are inputs of the unit.
class Sounds {
 public:
  Sounds() : display_(std::make_unique<dmi::State>()) {}
  Sounds(const Sounds& other) : display_(std::make_unique<dmi::State>(*other.display_)) {}
  Sounds& operator=(const Sounds& other) {
    *display_ = *other.display_;
    return *this;
  }
  Sounds(Sounds&&) = default;
  Sounds& operator=(Sounds&&) = default;
  ~Sounds() = default;

  /// Appends those of the next cycle, whose record of the display this is.
  void append(std::vector<io::NamedSound>& sounds, const kernel::Display& record);

 private:
  std::unique_ptr<dmi::State> display_;
};

}  // namespace evc::run
