#include "run/on_board.h"

#include <chrono>

#include "kernel/state.h"

namespace evc::run {

struct OnBoard::Memory {
  kernel::State state;
  kernel::Derived derived;
  kernel::Outputs outputs;
  kernel::Planning planning;
  kernel::Display display;
};

OnBoard::OnBoard(const kernel::Config& config, Costs costs) : memory_(std::make_unique<Memory>()), keep_(costs) {
  kernel::power_up(memory_->state, memory_->derived, config);
  if (keep_ == Costs::kept) costs_.reserve(1 << 16);
}

OnBoard::OnBoard(const kernel::Config& config, const kernel::Retained& retained)
    : memory_(std::make_unique<Memory>()), keep_(Costs::dropped) {
  (void)kernel::power_up(memory_->state, memory_->derived, config, retained);
}

OnBoard::~OnBoard() = default;

kernel::Retained OnBoard::retained() const { return kernel::retained(memory_->state); }

const kernel::Outputs& OnBoard::step(const kernel::Inputs& inputs) {
  const std::size_t allocations_before = allocations();
  const auto before = std::chrono::steady_clock::now();
  kernel::step(memory_->state, memory_->derived, inputs, memory_->outputs);
  const auto after = std::chrono::steady_clock::now();
  allocations_ += allocations() - allocations_before;
  if (keep_ == Costs::kept) costs_.push_back(std::chrono::duration<float>(after - before).count());
  return memory_->outputs;
}

const kernel::Planning* OnBoard::plan() {
  return kernel::plan(memory_->state, memory_->derived, memory_->planning) ? &memory_->planning : nullptr;
}

const kernel::Display& OnBoard::show() {
  kernel::show(memory_->state, memory_->derived, memory_->outputs, memory_->display);
  return memory_->display;
}

std::size_t OnBoard::state_bytes() { return sizeof(kernel::State); }

}  // namespace evc::run
