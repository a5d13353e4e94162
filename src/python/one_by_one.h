#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "openevc/curves.h"

// Limits of many trains, targets and speeds, each by `sdm::explain`.
namespace evc::python::one_by_one {

/// One target on the track of a train (3.13.8.2).
struct Target {
  sdm::TargetKind kind = sdm::TargetKind::EOA_SvL;
  Place location{};         ///< EOA, LOA, start of the restriction, end of the SR distance: distances count from here
  Place SvL{};              ///< EOA_SvL only: the supervised location, not in rear of the EOA
  Speed V_target{};         ///< LOA and MRSP only
  bool due_to_TSR = false;  ///< MRSP only: the default gradient holds (3.13.4.1.3)
};

/// What is known of the movement of a train for which limits are asked.
struct State {
  Speed V_ura{};
  Acceleration A_est{};
  std::optional<sdm::Motion> motion;
};

/// Trains on their tracks.
class Trains {
 public:
  std::uint32_t add(const sdm::Inputs& in, const State& state);
  struct Train {
    sdm::Inputs in;
    State state;
  };
  const Train& operator[](std::uint32_t number) const { return trains_[number]; }

 private:
  std::vector<Train> trains_;
};

/// Cases: number `i` is train `train[i]`, target `target[i]` and `speed[i]` in m/s.
struct Cases {
  std::span<const std::uint32_t> train, target;
  std::span<const double> speed;
};

/// Where the limits go: metres before the target's location, not a number where there is none. Empty: not wanted.
struct LimitsOut {
  std::span<double> EBD, SBD, GUI, EBI, SBI1, SBI2, FLOI, W, P, I, W_EOA, P_EOA, I_EOA, W_SvL, P_SvL, I_SvL;
};

void limits(const Trains& trains, std::span<const Target> targets, const Cases& cases, const LimitsOut& out);

}  // namespace evc::python::one_by_one
