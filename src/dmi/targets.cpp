#include <algorithm>

#include "dmi/acks.h"
#include "dmi/dmi.h"
#include "dmi/drawing.h"
#include "dmi/entry.h"
#include "dmi/touch.h"
#include "dmi/windows.h"

namespace evc::dmi {
namespace {

void aim(Targets& all, Rect at, ActionKind kind, std::uint8_t argument = 0, bool enabled = true,
         ButtonType type = ButtonType::up) {
  if (!all.push_back(Target{at, {kind, argument}, type, enabled})) return;  // a window has fewer than 40
}

void aim_window_buttons(Targets& all, const State& state) {
  aim(all, kClosePlace, ActionKind::close, 0, close_enabled(state));
  if (pages_of(state) < 2) return;
  aim(all, kPreviousPlace, ActionKind::previous, 0, can_turn_page(state, false));
  aim(all, kNextPlace, ActionKind::next, 0, can_turn_page(state, true));
}

void aim_fields(Targets& all, const State& state) {
  const bool full = is_full(state.window);
  const Shown shown = shown_fields(state);
  for (std::size_t i = shown.first; i < shown.last; ++i) {
    const bool selected = i == state.entry.selected;
    Rect place = full ? full_field(static_cast<int>(i - shown.first) + 1) : kHalfField;
    // [Enter] is the data part; the label selects the field, as the data part does, while another one is selected
    // (015560 10.3.1.22, 10.3.1.26).
    if (selected && layout_of(state.window) == Layout::entry_full) place = data_part(place);
    aim(all, place, ActionKind::field, static_cast<std::uint8_t>(i), !selected || enter_enabled(state),
        selected && enter_is_delayed(state) ? ButtonType::delay : ButtonType::up);
  }
}

void aim_keys(Targets& all, const State& state) {
  if (layout_of(state.window) == Layout::validation) {
    aim(all, kNoPlace, ActionKind::key, 7, true, ButtonType::down);
    aim(all, kYesPlace, ActionKind::key, 8, true, ButtonType::down);
    return;
  }
  for (std::uint8_t number = 1; number <= 12; ++number) {
    const Key key = key_at(state, number);
    if (key.label.empty() && !key.picture) continue;
    aim(all, key_place(number), ActionKind::key, number, key.enabled, key.type);
  }
}

void aim_entry(Targets& all, const State& state) {
  if (has_switch(state)) aim(all, kSwitchPlace, ActionKind::switch_entry);
  if (has_shortcuts(state)) {
    aim(all, kNumberPlace, ActionKind::open, static_cast<std::uint8_t>(WindowId::train_running_number));
    aim(all, kSettingsPlace, ActionKind::open, static_cast<std::uint8_t>(WindowId::settings));
  }
  aim_window_buttons(all, state);
  aim_fields(all, state);
  aim_keys(all, state);
  if (layout_of(state.window) == Layout::entry_full)
    aim(all, kCompletePlace, ActionKind::complete, 0, complete_enabled(state),
        complete_is_delayed(state) ? ButtonType::delay : ButtonType::up);
}

void aim_ato(Targets& all, const port::Display& display) {
  if (!is_400(display) || !display.ato.on) return;
  if (display.ato.status == port::AtoStatus::ready) aim(all, rect_of(Area::G1), ActionKind::ato_engage);
  if (display.ato.status == port::AtoStatus::engaged || display.ato.status == port::AtoStatus::disengaging)
    aim(all, rect_of(Area::G1), ActionKind::ato_disengage);
  if (display.ato.skip == port::AtoSkip::inactive || display.ato.skip == port::AtoSkip::by_driver)
    aim(all, rect_of(Area::G5), ActionKind::skip_stop, 0, true, ButtonType::delay);
}

void aim_default(Targets& all, const State& state) {
  const port::Display& display = state.display;
  for (const auto& [area, window] : {std::pair{Area::F1, WindowId::main}, std::pair{Area::F2, WindowId::override_},
                                     std::pair{Area::F3, WindowId::data_view}, std::pair{Area::F4, WindowId::special},
                                     std::pair{Area::F5, WindowId::settings}})
    aim(all, rect_of(area), ActionKind::open, static_cast<std::uint8_t>(window));
  if (display.track_ahead_free) {
    aim(all, {496, 65, 82, 50}, ActionKind::track_ahead_free);
  } else if (shows_planning(state)) {
    // The touched places are larger than the symbols by 15 cells (015560 8.3.10.4, 8.3.10.5).
    aim(all, {334, 285, 40, 30}, ActionKind::zoom_in, 0, state.zoom > 0);
    aim(all, {334, 15, 40, 30}, ActionKind::zoom_out, 0, state.zoom + 1u < kRanges.size());
  }
  if (display.tunnel) aim(all, rect_of(Area::C2_C3_C4), ActionKind::toggle_tunnel);
  if (display.geo) aim(all, rect_of(Area::G12), ActionKind::toggle_geo);
  aim_ato(all, display);
  aim(all, rect_of(Area::E10), ActionKind::scroll_up, 0, can_scroll(state, true), ButtonType::down_repeat);
  aim(all, rect_of(Area::E11), ActionKind::scroll_down, 0, can_scroll(state, false), ButtonType::down_repeat);
  if (display.mode == Mode::OS || display.mode == Mode::SR || display.mode == Mode::SH) {
    aim(all, rect_of(Area::A), ActionKind::toggle_speed);
    aim(all, rect_of(Area::B), ActionKind::toggle_speed);
  }
}

}  // namespace

bool has_switch(const State& state) {
  return state.window == WindowId::train_data &&
         state.display.config.train_data_entry == port::TrainDataEntry::switchable;
}
bool has_shortcuts(const State& state) { return state.window == WindowId::driver_id && state.display.start_of_mission; }

Targets targets(const State& state) {
  Targets all;
  const Layout layout = layout_of(state.window);
  // An acknowledgement can be touched where no window covers it.
  if (state.offered && !is_full(state.window)) {
    const AckPlace place = place_of(state.offered->ack.what);
    aim(all, rect_of(place.touch), ActionKind::ack, 0, true, place.type);
  }
  if (layout == Layout::default_) {
    aim_default(all, state);
  } else if (layout == Layout::menu) {
    for (const MenuButton& button : menu_buttons(state, state.window))
      aim(all, menu_place(button.number), ActionKind::button, static_cast<std::uint8_t>(button.button),
          button_enabled(state, button.button), button.type);
    aim_window_buttons(all, state);
  } else if (layout == Layout::view) {
    aim_window_buttons(all, state);
  } else {
    aim_entry(all, state);
  }
  return all;
}

}  // namespace evc::dmi
