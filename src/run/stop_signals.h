#pragma once

namespace evc::run {

/// While it lives, SIGINT and SIGTERM ask for an end of the drive instead of ending the program; one that the caller
/// ignores stays ignored. Afterwards they do what they did before. One at a time.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;
  bool seen() const;
};

}  // namespace evc::run
