#pragma once
#include <string>

#include "base/test_units.h"
#include "dmi/dmi.h"

// Displays and touches of tests.
namespace evc::dmi::test {

/// A neutral display: 4.0.0, standstill, nothing supervised.
inline port::Display neutral(Mode mode = Mode::SB) {
  port::Display display;
  display.mode = mode;
  display.now = Duration{100.0};
  return display;
}

/// All buttons of the menus.
inline Set<Button> all_buttons() { return Set<Button>::of_bits(~std::uint64_t{0}); }

inline Screen drawn(const State& state, Duration now) {
  Screen screen;
  draw(state, now, screen);
  return screen;
}
inline Screen drawn(const State& state) { return drawn(state, state.display.now); }

inline Cell middle(const Rect& r) { return {r.x + r.w / 2, r.y + r.h / 2}; }

/// The place with this name; traps the test when there is none.
inline const Touch* find_touch(const Screen& screen, const std::string& name) {
  for (const Touch& touch : screen.touch)
    if (touch.name.view() == name) return &touch;
  return nullptr;
}

/// Touches the place with this name for `seconds`, as long as a delay button needs if not said. False: it is not there
/// or disabled.
inline bool tap(State& state, const std::string& name, double& at, double seconds = 0.1) {
  const Screen screen = drawn(state, Duration{at});
  const Touch* touch = find_touch(screen, name);
  if (touch == nullptr || !press(state, middle(touch->abs), Duration{at})) return false;
  at += touch->type == ButtonType::delay && seconds < 2.0 ? 2.1 : seconds;
  release(state, Duration{at});
  return true;
}

inline const Item* find_item(const Screen& screen, Kind kind, const std::string& name) {
  for (const Item& item : screen.items)
    if (item.kind == kind && item.name.view() == name) return &item;
  return nullptr;
}
inline const Item* find_symbol(const Screen& screen, Picture picture) {
  for (const Item& item : screen.items)
    if (item.kind == Kind::symbol && item.picture == picture) return &item;
  return nullptr;
}

}  // namespace evc::dmi::test
