#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace evc::cluster {

/// What a message between two ranks is. Those of rank 0 go to all others, theirs to rank 0.
enum class Kind : std::uint8_t {
  prepared,  ///< to rank 0: the plan is there, or why not (refusal_of)
  ask,       ///< to rank 0: at most so many cases more are wanted (count_of)
  grant,     ///< from rank 0, the answer: these cases (range_of); none: there are no more
  rows,      ///< to rank 0: finished (rows_of)
  stop,      ///< to rank 0: a signal was seen
  end,       ///< from rank 0: compute no more
  done       ///< to rank 0, the last one: no more rows follow
};

struct Message {
  int from = 0;
  Kind kind = Kind::done;
  std::string bytes;
};

/// The ranks of this job, through MPI, which is begun and ended with it. One in a program; only the thread that made it
/// may use it (MPI_THREAD_FUNNELED). An error of MPI ends the job.
class Messenger {
 public:
  Messenger(int& argc, char**& argv);
  /// Waits until everything is sent.
  ~Messenger();
  Messenger(const Messenger&) = delete;
  Messenger& operator=(const Messenger&) = delete;

  int rank() const { return rank_; }
  int ranks() const { return ranks_; }
  /// The name of the computer.
  static std::string computer();

  /// What rank 0 says to all, at every rank; the others wait for it.
  std::string broadcast(std::string bytes) const;
  /// Messages between two ranks arrive in their order. Waits only when many are on their way.
  void send(int to, Kind kind, std::string bytes);
  /// One that has arrived.
  std::optional<Message> received();
  /// Ends all ranks at once with this status.
  [[noreturn]] static void abort(int status);

 private:
  struct Sending;
  /// Waits for messages on their way until there are at most so many.
  void let_go(std::size_t most);

  int rank_ = 0, ranks_ = 1;
  std::unique_ptr<Sending> sending_;
};

}  // namespace evc::cluster
