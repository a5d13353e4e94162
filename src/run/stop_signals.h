#pragma once

namespace evc::run {

/// While it lives, the first SIGINT or SIGTERM asks for an end of the drive instead of ending the program; one that the
/// caller ignores stays ignored. A second signal, and one afterwards, does what it did before. One at a time.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;
  bool seen() const;
};

}  // namespace evc::run
