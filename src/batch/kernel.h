#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace evc::batch {

/// Where each limit of a case goes.
enum Output : std::size_t {
  kEBD,
  kSBD,
  kGUI,
  kEBI,
  kSBI1,
  kSBI2,
  kFLOI,
  kW,
  kP,
  kI,
  kW_EOA,
  kP_EOA,
  kI_EOA,
  kW_SvL,
  kP_SvL,
  kI_SvL,
  kOutputs
};

/// Cases computed together, in arrays: of each its train, target and speed as the kernels need them. Groups are filled
/// up by repeating a case.
struct Block {
  static constexpr std::size_t kMost = 256;
  static constexpr std::size_t kLeastGroup = 4;  // a divisor of every `group()`

  const double* numbers = nullptr;  // the tables of the trains
  std::size_t size = 0;
  bool at_speed = false;                        // some targets have a foot beyond them
  bool guided = false;                          // some have a guidance curve
  std::size_t bisections = 0;                   // steps of the search for a segment that always suffice
  std::array<bool, kMost / kLeastGroup> alike;  // of each group: all have the same train and class of targets

  alignas(64) std::array<std::int64_t, kMost> values;  // index of those of the train and the class of targets
  alignas(64) std::array<double, kMost> V, V_target;
  alignas(64) std::array<double, kMost> location;        // distances count from here; of an EOA and SvL the EOA
  alignas(64) std::array<double, kMost> d_target;        // of an EOA and SvL the SvL
  alignas(64) std::array<double, kMost> anchor_squared;  // of the speed of the EBD at the target
  alignas(64) std::array<double, kMost> has_SBD;         // 1 or 0
  alignas(64) std::array<double, kMost> V_foot;          // V_target + V_delta0 of d_P(V_target), where guided

  std::array<double*, kOutputs> out{};             // of kMost values; null: not wanted
  alignas(64) std::array<double, kMost> left_out;  // 1: more arcs than the curve may have; not computed
};

/// The number of cases that are computed side by side, with the widest instructions that the processor has: `size` of a
/// block is a multiple of it.
std::size_t group();

/// Computes the block with the widest instructions that the processor has.
void compute(Block& block);

/// The sets of instructions (Highway's names) that the program contains and this processor has, the widest first.
/// `use_only` forces one of them (one bit of Highway's targets) for tests; 0: the widest one again.
struct Instructions {
  std::int64_t target;
  const char* name;
};
std::size_t instructions(std::array<Instructions, 8>& found);
void use_only(std::int64_t target);

}  // namespace evc::batch
