#include <algorithm>

#include "dmi/acks.h"
#include "dmi/commit.h"
#include "dmi/dmi.h"
#include "dmi/drawing.h"
#include "dmi/entry.h"
#include "dmi/touch.h"
#include "dmi/windows.h"

namespace evc::dmi {
namespace {

constexpr Duration kBlink{0.25}, kDelay{2.0}, kFirstRepeat{1.5}, kRepeat{0.3};
/// How long a down button is seen pressed: it is enabled again immediately (015560 5.3.2.6.4).
constexpr Duration kGlimpse{0.1};

void act(State& state, Action action, Duration now);

/// When the button that is held acts for the `n`th time by itself, since it was pressed.
Duration time_of_repeat(std::uint16_t n) { return kFirstRepeat + double(n - 1) * kRepeat; }

void select_entry_kind(State& state) {
  state.fixed_train_entry = !state.fixed_train_entry;
  open_window(state, WindowId::train_data);
}

void turn_page(State& state, bool forward) {
  if (!can_turn_page(state, forward)) return;
  state.page = static_cast<std::uint8_t>(forward ? state.page + 1 : state.page - 1);
  if (is_entry(state.window)) touch_field(state, shown_fields(state).first);
}

void act_on_window(State& state, Action action, Duration now) {
  switch (action.kind) {
    case ActionKind::open: {
      const auto window = static_cast<WindowId>(action.argument);
      state.from_driver_id = state.window == WindowId::driver_id;
      return open_window(state, window);
    }
    case ActionKind::button:
      return choose(state, static_cast<Button>(action.argument), now);
    case ActionKind::close:
      if (close_enabled(state)) close_window(state);
      return;
    case ActionKind::next:
      return turn_page(state, true);
    case ActionKind::previous:
      return turn_page(state, false);
    case ActionKind::key:
      return press_key(state, action.argument, now);
    case ActionKind::field:
      if (touch_field(state, action.argument)) complete_entry(state, now);
      return;
    case ActionKind::complete:
      if (complete_enabled(state) && check_across(state)) complete_entry(state, now);
      return;
    case ActionKind::switch_entry:
      return select_entry_kind(state);
    default:
      return;
  }
}

void send(State& state, port::Select what) {
  std::uint32_t& selected = state.commands.actions.selected;
  selected = port::with_selection(selected, 1u << static_cast<unsigned>(what));
}

void act(State& state, Action action, Duration now) {
  switch (action.kind) {
    case ActionKind::none:
      return;
    case ActionKind::ack:
      return acknowledge(state, now);
    case ActionKind::toggle_speed:
      state.toggles.speed = !state.toggles.speed;
      if (shows_TTI(state)) order_sound(state, Sound::Sinfo);  // displayed from now on (015560 8.2.2.5.7)
      return send(state, port::Select::toggle);
    case ActionKind::toggle_tunnel:
      state.toggles.tunnel = !state.toggles.tunnel;
      return;
    case ActionKind::toggle_geo:
      state.toggles.geo = !state.toggles.geo;
      return;
    case ActionKind::zoom_in:
      if (state.zoom > 0) --state.zoom;
      return;
    case ActionKind::zoom_out:
      if (state.zoom + 1u < kRanges.size()) ++state.zoom;
      return;
    case ActionKind::scroll_up:
      if (can_scroll(state, true)) --state.scroll;
      return;
    case ActionKind::scroll_down:
      if (can_scroll(state, false)) ++state.scroll;
      return;
    case ActionKind::track_ahead_free:
      return send(state, port::Select::track_ahead_free);
    case ActionKind::ato_engage:
      return send(state, port::Select::ato_engage);
    case ActionKind::ato_disengage:
      return send(state, port::Select::ato_disengage);
    case ActionKind::skip_stop:
      state.commands.skip_stop = state.display.ato.skip == port::AtoSkip::inactive;
      return;
    default:
      return act_on_window(state, action, now);
  }
}

/// The target as it is now; null: it is not there any more, or disabled.
const Target* still(const Targets& all, const Target& held) {
  for (const Target& target : all)
    if (target.action == held.action && target.abs == held.abs) return target.enabled ? &target : nullptr;
  return nullptr;
}

bool down_type(ButtonType type) { return type == ButtonType::down || type == ButtonType::down_repeat; }

}  // namespace

bool press(State& state, Cell at, Duration now) {
  tick(state, now);
  if (state.pressed.held) return false;
  for (const Target& target : targets(state)) {
    if (!inside(target.abs, at.x, at.y)) continue;
    if (!target.enabled) return false;
    state.pressed = Pressed{.held = true, .target = target, .since = now};
    if (target.action.kind == ActionKind::ack && state.offered) state.pressed.ack = state.offered->ack;
    // Places without a look of a button make no sound (015560 8.2.2.4).
    if (target.action.kind != ActionKind::toggle_speed) order_sound(state, Sound::click);
    if (down_type(target.type)) act(state, target.action, now);
    return true;
  }
  return false;
}

void slide(State& state, Cell at, Duration now) {
  tick(state, now);
  Pressed& pressed = state.pressed;
  if (!pressed.held) return;
  const bool within = inside(pressed.target.abs, at.x, at.y);
  if (within && !pressed.inside) {
    pressed.since = now;
    pressed.repeats = 0;
  }
  pressed.inside = within;
}

void release(State& state, Duration now) {
  tick(state, now);
  const Pressed pressed = state.pressed;
  state.pressed = Pressed{};
  if (!pressed.held || !pressed.inside || down_type(pressed.target.type)) return;
  if (pressed.target.type == ButtonType::delay && now - pressed.since < kDelay) return;
  // A request that was revoked meanwhile is not answered, nor is the one that came instead.
  if (pressed.ack && !(state.offered && state.offered->ack == *pressed.ack)) return;
  const Targets all = targets(state);
  if (still(all, pressed.target) != nullptr) act(state, pressed.target.action, now);
}

void tick(State& state, Duration now) {
  end_tap(state, now);
  Pressed& pressed = state.pressed;
  if (!pressed.held || !pressed.inside || pressed.target.type != ButtonType::down_repeat) return;
  // A host that was away for long does not get all repeats at once.
  for (int n = 0; n < 64; ++n) {
    const auto next = static_cast<std::uint16_t>(pressed.repeats + 1);
    if (now < pressed.since + time_of_repeat(next)) return;
    pressed.repeats = next;
    const Targets all = targets(state);
    if (still(all, pressed.target) == nullptr) continue;
    order_sound(state, Sound::click);
    act(state, pressed.target.action, now);
  }
}

bool looks_pressed(const State& state, Action action, Duration now) {
  const Pressed& pressed = state.pressed;
  if (!pressed.held || !pressed.inside || !(pressed.target.action == action)) return false;
  const Duration held = now - pressed.since;
  if (down_type(pressed.target.type)) {
    const Duration acted = pressed.repeats == 0 ? Duration{} : time_of_repeat(pressed.repeats);
    return held - acted < kGlimpse;
  }
  if (pressed.target.type != ButtonType::delay || held >= kDelay) return true;
  return whole(held.si / kBlink.si - 0.5, 0, 8) % 2 == 0;
}

Commands take(State& state) {
  Commands commands = state.commands;
  state.commands = Commands{};
  commands.windows.add(port::Window::train_data,
                       state.window == WindowId::train_data || state.window == WindowId::validate_train_data);
  commands.windows.add(port::Window::SR_data, state.window == WindowId::sr_data);
  return commands;
}

}  // namespace evc::dmi
