#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "dmi/dmi.h"
#include "dmi/screen.h"
#include "dmi/state.h"
#include "port/display.h"

namespace evc::screen {

inline constexpr std::int64_t kTap = 100;  ///< ms, that a finger touches a button
inline constexpr std::int64_t kDelayed =
    2100;  ///< ms, of a delay button: more than the two seconds of 015560 5.3.2.6.6

/// A display with a driver and a stand-in for the on-board: it takes acknowledgements and data, and does nothing else.
class Player {
 public:
  Player();
  Player(const Player&) = delete;
  Player& operator=(const Player&) = delete;

  /// A sound with its time.
  struct Heard {
    std::int64_t ms = 0;
    dmi::SoundOrder order;
  };

  /// What the on-board shows from the next cycle on. `now` is set by `show`.
  port::Display& display() { return *display_; }
  const dmi::State& state() const { return *state_; }
  std::int64_t now_ms() const { return now_ms_; }
  Duration now() const { return Duration{static_cast<double>(now_ms_) / 1000.0}; }

  /// A cycle at this moment.
  void show();
  /// Cycles of 100 ms up to this time, which must not be before now.
  void run_to(std::int64_t ms);
  /// What the driver's finger does; press: whether it hit something enabled.
  bool press(dmi::Cell at);
  void slide(dmi::Cell at);
  void release();
  /// Presses in the middle and releases as soon as a button of its type acts; false: nothing enabled is there.
  bool touch(const dmi::Target& target);
  /// The place with this effect; false: there is none.
  bool touch(dmi::Action action);

  /// The place with this effect; none: it is not there.
  std::optional<dmi::Target> target(dmi::Action action) const;
  std::unique_ptr<dmi::Screen> screen() const;

  const std::vector<Heard>& heard() const { return heard_; }
  /// Everything that the driver has sent, in order.
  const std::vector<dmi::Commands>& sent() const { return sent_; }
  void forget_sounds() { heard_.clear(); }

 private:
  void collect();
  void take_acknowledgements(const dmi::Commands& commands);
  void take_data(const dmi::Commands& commands);

  std::unique_ptr<port::Display> display_;
  std::unique_ptr<dmi::State> state_;
  std::int64_t now_ms_ = 0;
  std::vector<Heard> heard_;
  std::vector<dmi::Commands> sent_;
};

/// The middle of a rectangle.
dmi::Cell middle_of(const dmi::Rect& r);

}  // namespace evc::screen
