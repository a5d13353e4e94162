#pragma once
#include "io/train_file.h"
#include "kernel/state.h"
#include "sim/world.h"

namespace evc::matrix {

/// A train with its unit on a line, driven at the permitted speed.
struct DrivenTrain {
  /// `line` must outlive the driven train: a temporary one is refused.
  DrivenTrain(const sim::Line& line, io::Train its_train);
  DrivenTrain(const sim::Line&&, io::Train) = delete;
  /// Cycle by cycle until the true front end is at `at_m`. False when the run ended before.
  bool drive_to(double at_m);

  io::Train train;  // what the world refers to
  sim::World world;
  kernel::State state;
  kernel::Derived derived;
  kernel::Outputs outputs;
};

}  // namespace evc::matrix
