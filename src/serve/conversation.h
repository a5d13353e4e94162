#pragma once
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "realtime/clock.h"

namespace evc::serve {

/// What one conversation may hold, in bytes.
struct Room {
  std::size_t inputs = std::size_t{1} << 20;   ///< lines not read by the unit yet; one more may be beyond it
  std::size_t outputs = std::size_t{4} << 20;  ///< lines not taken by the partner yet
  /// How long a unit that need not keep time waits for a partner who takes nothing, with the outputs full.
  std::chrono::milliseconds patience{10000};
};

/// The hand-over between the thread of the network and that of one unit: lines in both directions, neither without
/// bound. The network never waits; the unit waits for lines, and for room unless its cycles come by the clock.
class Conversation {
 public:
  struct Line {
    std::string text;
    realtime::Nanoseconds arrived{0};
    bool too_long = false;  ///< instead of a line: one beyond io::kLongestLine came
  };
  /// `changed` is called, from any thread, when the network has something to do: outputs to be sent, room for inputs
  /// again, the end. Once until `seen` is called.
  Conversation(const Room& room, std::function<void()> changed) : room_(room), changed_(std::move(changed)) {}

  // The network.
  /// The next calls of `changed` are about what happens from now on.
  void seen() { told_ = false; }
  void put(Line line);
  /// No more lines come; those that came are still answered.
  void end_inputs();
  /// The partner has gone or is not to be answered any more: the unit finds an end everywhere.
  void drop();
  /// Whether further inputs are welcome.
  bool has_room() const;
  /// Outputs in order, whole lines of about `bytes` together, at least one if there is any.
  std::vector<std::string> take(std::size_t bytes);
  /// The unit has said its last word, which may not be taken yet.
  bool finished() const;
  bool dropped() const;

  // The unit.
  /// Waits for the next line; false at the end.
  bool wait_for_line(Line& line);
  /// The next line if there is one.
  bool next_line(Line& line);
  /// No line will come any more, and none is left.
  bool inputs_ended() const;
  /// A line for the partner, with its end. Waits for room. False when the partner has gone or takes nothing.
  bool give(std::string line);
  /// The same without waiting: false when there is no room.
  bool give_now(std::string line);
  void finish();

 private:
  void tell();

  const Room room_;
  const std::function<void()> changed_;
  std::atomic<bool> told_ = false;
  mutable std::mutex mutex_;
  std::condition_variable for_unit_;
  std::deque<Line> inputs_;
  std::deque<std::string> outputs_;
  std::size_t input_bytes_ = 0, output_bytes_ = 0;
  std::size_t taken_ = 0;  // outputs so far: whether the partner takes any
  bool ended_ = false, dropped_ = false, finished_ = false;
};

}  // namespace evc::serve
