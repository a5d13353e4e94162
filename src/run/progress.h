#pragma once
#include <cstdint>

#include "io/terminal_line.h"

namespace evc::run {

/// A progress bar on standard error when that is a terminal; nothing otherwise.
class Progress {
 public:
  explicit Progress(const char* what) : what_(what) {}
  /// `share` 0..1 done; redrawn after a visible change.
  void show(double share, std::int64_t t_ms, double speed_kmh);
  void clear();

 private:
  const char* what_;
  io::TerminalLine line_;
  int drawn_ = -1;
};

}  // namespace evc::run
