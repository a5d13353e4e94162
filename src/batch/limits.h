#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "openevc/curves.h"

// Limits of many trains, targets and speeds at once, several cases in each instruction. Every value has the bits that
// `sdm::explain` gives: the same operations in the same order.
namespace evc::batch {

/// Places of targets are from -kFarthest to kFarthest; a curve at or beyond -kFarthest is nowhere (no line is as long,
/// and src/sdm takes 1e9 m for the end of every track).
inline constexpr Distance kFarthest{1e8};

/// One target on the track of a train (3.13.8.2). Its places are in range (kFarthest).
struct Target {
  sdm::TargetKind kind = sdm::TargetKind::EOA_SvL;
  Place location{};         ///< EOA, LOA, start of the restriction, end of the SR distance: distances count from here
  Place SvL{};              ///< EOA_SvL only: the supervised location, not in rear of the EOA
  Speed V_target{};         ///< LOA and MRSP only, >= 0; for the others 0
  bool due_to_TSR = false;  ///< MRSP only: the default gradient holds (3.13.4.1.3)
};

/// What is known of the movement of a train for which limits are asked.
struct State {
  Speed V_ura{};         ///< speed under-reading amount, >= 0; not used where Q_NVINHSMICPERM is set
  Acceleration A_est{};  ///< estimated acceleration
  /// Where the train is: the reduced build-up times of 4.0.0 depend on it, and only they.
  std::optional<sdm::Motion> motion;
};

/// Trains on their tracks: of each, everything that its curves and limits depend on and no target changes, laid out for
/// the kernels. Adding trains is not safe from several threads at once; reading is.
class Trains {
 public:
  Trains();
  ~Trains();
  Trains(Trains&&) noexcept;
  Trains& operator=(Trains&&) noexcept;

  /// Adds a train and returns its number: 0, 1, 2, ... Of `in` are used the train, the national and fixed values, the
  /// gradient, the track conditions, the issue of the standard and `V_top`; where `V_top` is absent, curves end 100
  /// km/h above the maximum speeds of train and `in.mrsp`. The targets of `in` are not used. Train data and national
  /// values must be in range (`train::check`).
  std::uint32_t add(const sdm::Inputs& in, const State& state = {});
  std::size_t size() const;
  void clear();

  /// Whether the kernels compute limits of this train; else `sdm::explain` does, with the same result: for special
  /// brakes inhibited on a part of the track, a deceleration <= 0 somewhere, guidance curves of 4.0.0. Of other trains
  /// of 4.0.0 it computes the cases near the target speed, whose build-up times may be reduced (A.3.12).
  bool vectorised(std::uint32_t train) const;

  struct Tables;
  const Tables& tables() const { return *tables_; }

 private:
  std::unique_ptr<Tables> tables_;
};

/// Cases: number `i` is train `train[i]`, target `target[i]` and `speed[i]` in m/s, >= 0. The three have the same size;
/// each number is less than the size of what it refers to. An empty `train` or `target`: 0 for every case. A speed that
/// is not a number has no limits.
struct Cases {
  std::span<const std::uint32_t> train, target;
  std::span<const double> speed;
};

/// Where the limits go: for case `i` element `i`, metres before the target's location (negative beyond it); NaN where
/// there is none: an SBD, SBI1 and limits of the EOA for other targets, a guidance curve where none is in use, and
/// everything that a speed depends on that is allowed nowhere. An empty span: not wanted, and not computed where only
/// it needs the computation; the others have the size of the cases. Names as in the output of `evc curves`.
struct LimitsOut {
  std::span<double> EBD, SBD, GUI;        ///< the curves at the speed
  std::span<double> EBI;                  ///< against the max safe front end
  std::span<double> SBI1;                 ///< of the SBD, against the estimated front end
  std::span<double> SBI2;                 ///< of the EBD, against the max safe front end
  std::span<double> FLOI, W, P, I;        ///< the nearer ones of EBD and SBD
  std::span<double> W_EOA, P_EOA, I_EOA;  ///< of the SBD
  std::span<double> W_SvL, P_SvL, I_SvL;  ///< of the EBD, for every kind of target
};

/// Whether the places of a target are in the range that curves and limits have.
bool in_range(const Target& target);

/// Computes the limits of all cases on this thread, with the widest instructions that the processor has. Any number of
/// threads may do so with the same trains at once. Targets out of range are a defect of the caller (EVC_REQUIRE).
void limits(const Trains& trains, std::span<const Target> targets, const Cases& cases, const LimitsOut& out);

}  // namespace evc::batch
