#pragma once
#include <chrono>
#include <cstdint>

#include "cluster/messenger.h"
#include "sweep/computers.h"

// A sweep by the ranks of a cluster. Rank 0 has the command line, the file of results and the numbers that are still to
// be computed; it computes too. The others compute what it grants them.
namespace evc::cluster {

/// Rank 0.
class Leader final : public sweep::Computers {
 public:
  explicit Leader(Messenger& messenger) : messenger_(messenger) {}

  /// Every rank makes the plan from the text of the spec and the files that it names; they must be the same everywhere.
  io::Result<bool> prepare(const sweep::Plan& plan) override;
  /// Without a number each rank computes with one thread.
  void compute(const sweep::Plan& plan, sweep::Todo& todo, unsigned threads, const sweep::Take& take) override;
  /// All ranks end with this status.
  void finish(int exit_code);
  /// The others expect messages, not `finish`: an exception came out of `compute`.
  bool computing() const { return computing_; }

 private:
  class Work;
  Messenger& messenger_;
  bool computing_ = false;
};

/// Any other rank, to the end. Returns its exit status.
int follow(Messenger& messenger);

/// How many cases a rank has at hand: as many as take a tenth of a second at the rate at which the last ones were
/// finished, so that its threads do not wait for an answer; but two for each thread.
class Supply {
 public:
  using Clock = std::chrono::steady_clock;
  Supply(unsigned threads, Clock::time_point now) : least_(2 * std::uint64_t{threads}), wanted_(least_), since_(now) {}
  void granted(std::uint64_t cases) { held_ += cases; }
  void finished(std::uint64_t cases);
  /// How many to ask for now; 0: there are enough.
  std::uint64_t missing(Clock::time_point now);

 private:
  std::uint64_t least_, wanted_, held_ = 0;
  std::uint64_t finished_ = 0;  // since the last time that something was missing
  Clock::time_point since_;
};

/// What rank 0 grants of `left` cases to one who asks for `asked`, with so many threads in all ranks: towards the end
/// less, so that all end together.
std::uint64_t granted_of(std::uint64_t left, std::uint64_t asked, std::uint64_t threads);

}  // namespace evc::cluster
