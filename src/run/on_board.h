#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "kernel/evc.h"

namespace evc::run {

/// Heap allocations of this thread so far.
std::size_t allocations();

/// The kernel with its state, and the cost of its steps.
class OnBoard {
 public:
  /// A live stream has no end: the costs of its steps are not kept.
  enum class Costs : std::uint8_t { dropped, kept };
  explicit OnBoard(const kernel::Config& config, Costs costs = Costs::dropped);
  /// With what a unit kept without power, as it is read from its file: it is plausible.
  OnBoard(const kernel::Config& config, const kernel::Retained& retained);
  ~OnBoard();
  OnBoard(const OnBoard&) = delete;
  OnBoard& operator=(const OnBoard&) = delete;

  /// One cycle. The outputs stay valid until the next one.
  const kernel::Outputs& step(const kernel::Inputs& inputs);

  kernel::Retained retained() const;
  /// The advance display after that cycle; null where there is none. It stays valid until the next call.
  const kernel::Planning* plan();
  /// The record of the display after that cycle. It stays valid until the next call.
  const kernel::Display& show();

  static std::size_t state_bytes();
  std::size_t allocations_in_step() const { return allocations_; }
  /// Seconds of every step so far; empty when they are not kept.
  const std::vector<float>& costs() const { return costs_; }

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
  Costs keep_;
  std::size_t allocations_ = 0;
  std::vector<float> costs_;
};

}  // namespace evc::run
