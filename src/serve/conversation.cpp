#include "serve/conversation.h"

#include <utility>

namespace evc::serve {
namespace {

/// A line costs more than its bytes: without this, empty lines would be without bound.
constexpr std::size_t kCostOfLine = 64;

std::size_t cost(const std::string& text) { return text.size() + kCostOfLine; }

}  // namespace

void Conversation::tell() {
  if (!told_.exchange(true)) changed_();
}

void Conversation::put(Line line) {
  {
    const std::lock_guard lock(mutex_);
    if (ended_ || dropped_) return;
    input_bytes_ += cost(line.text);
    inputs_.push_back(std::move(line));
  }
  for_unit_.notify_one();
}

void Conversation::end_inputs() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  for_unit_.notify_one();
}

void Conversation::drop() {
  {
    const std::lock_guard lock(mutex_);
    dropped_ = true;
    inputs_.clear();
    outputs_.clear();
    input_bytes_ = output_bytes_ = 0;
  }
  for_unit_.notify_one();
}

bool Conversation::has_room() const {
  const std::lock_guard lock(mutex_);
  return input_bytes_ < room_.inputs;
}

std::vector<std::string> Conversation::take(std::size_t bytes) {
  std::vector<std::string> lines;
  {
    const std::lock_guard lock(mutex_);
    for (std::size_t sum = 0; !outputs_.empty() && (lines.empty() || sum + outputs_.front().size() <= bytes);) {
      sum += outputs_.front().size();
      output_bytes_ -= cost(outputs_.front());
      lines.push_back(std::move(outputs_.front()));
      outputs_.pop_front();
    }
    taken_ += lines.size();
  }
  if (!lines.empty()) for_unit_.notify_one();
  return lines;
}

bool Conversation::finished() const {
  const std::lock_guard lock(mutex_);
  return finished_;
}

bool Conversation::dropped() const {
  const std::lock_guard lock(mutex_);
  return dropped_;
}

bool Conversation::wait_for_line(Line& line) {
  {
    std::unique_lock lock(mutex_);
    for_unit_.wait(lock, [&] { return !inputs_.empty() || ended_ || dropped_; });
  }
  return next_line(line);
}

bool Conversation::next_line(Line& line) {
  bool room_again = false;
  {
    const std::lock_guard lock(mutex_);
    if (inputs_.empty()) return false;
    line = std::move(inputs_.front());
    inputs_.pop_front();
    const bool full = input_bytes_ >= room_.inputs;
    input_bytes_ -= cost(line.text);
    room_again = full && input_bytes_ < room_.inputs;
  }
  if (room_again) tell();
  return true;
}

bool Conversation::inputs_ended() const {
  const std::lock_guard lock(mutex_);
  return dropped_ || (ended_ && inputs_.empty());
}

bool Conversation::give(std::string line) {
  {
    std::unique_lock lock(mutex_);
    const auto has_room = [&] { return dropped_ || output_bytes_ < room_.outputs; };
    // As long as the partner takes something, it is only slow.
    for (std::size_t before = taken_ + 1; !has_room() && before != taken_;) {
      before = taken_;
      for_unit_.wait_for(lock, room_.patience, has_room);
    }
    if (dropped_ || !has_room()) return false;
    output_bytes_ += cost(line);
    outputs_.push_back(std::move(line));
  }
  tell();
  return true;
}

bool Conversation::give_now(std::string line) {
  {
    const std::lock_guard lock(mutex_);
    if (dropped_ || output_bytes_ >= room_.outputs) return false;
    output_bytes_ += cost(line);
    outputs_.push_back(std::move(line));
  }
  tell();
  return true;
}

void Conversation::finish() {
  {
    const std::lock_guard lock(mutex_);
    finished_ = true;
  }
  told_ = false;  // the last word is never left untold
  tell();
}

}  // namespace evc::serve
