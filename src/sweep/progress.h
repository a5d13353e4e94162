#pragma once
#include <chrono>
#include <cstdint>

#include "io/terminal_line.h"

namespace evc::sweep {

/// A progress bar on standard error with rate and time left, when that is a terminal; nothing otherwise.
class Progress {
 public:
  /// `done` of `all` were there before.
  Progress(std::uint64_t done, std::uint64_t all) : before_(done), all_(all) {}
  void show(std::uint64_t done, std::uint64_t failed);
  void clear() { line_.clear(); }
  /// Seconds since it was made.
  double seconds() const;

 private:
  using Clock = std::chrono::steady_clock;
  std::uint64_t before_, all_;
  io::TerminalLine line_;
  Clock::time_point begin_ = Clock::now(), last_ = begin_;
};

}  // namespace evc::sweep
