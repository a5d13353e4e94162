#include <array>

#include "dmi/commit.h"
#include "dmi/entry.h"
#include "dmi/windows.h"

namespace evc::dmi {
namespace {

using port::Select;
using port::Waiting;

/// How long a window waits for the on-board to say that it waits for an answer.
constexpr Duration kAnswerBegins{1.0};

void give(State& state, Select what) { state.commands.actions.selected |= 1u << static_cast<unsigned>(what); }

/// What a button of a menu sends, and the window that follows; `count`: it depends.
struct Effect {
  Button button;
  Select select;  ///< count: nothing is sent
  WindowId opens;
};
constexpr auto kEffects = std::to_array<Effect>({
    Effect{Button::start, Select::start, WindowId::count},
    Effect{Button::driver_id, Select::count, WindowId::driver_id},
    Effect{Button::train_data, Select::train_data, WindowId::train_data},
    Effect{Button::level, Select::count, WindowId::level},
    Effect{Button::train_running_number, Select::count, WindowId::train_running_number},
    Effect{Button::shunting, Select::shunting, WindowId::count},
    Effect{Button::exit_shunting, Select::exit_shunting, WindowId::default_},
    Effect{Button::non_leading, Select::non_leading, WindowId::default_},
    Effect{Button::maintain_shunting, Select::maintain_shunting, WindowId::default_},
    Effect{Button::radio_data, Select::count, WindowId::radio_data},
    Effect{Button::initiate_sm, Select::sm, WindowId::count},
    Effect{Button::continue_sm, Select::continue_sm, WindowId::count},
    Effect{Button::exit_sm, Select::exit_sm, WindowId::default_},
    Effect{Button::contact_last_rbc, Select::last_rbc, WindowId::count},
    Effect{Button::use_short_number, Select::short_number, WindowId::count},
    Effect{Button::enter_rbc_data, Select::count, WindowId::rbc_data},
    Effect{Button::radio_network_type, Select::count, WindowId::radio_type},
    Effect{Button::gsmr_network_id, Select::radio_network, WindowId::count},
    Effect{Button::one_radio_system, Select::count, WindowId::one_radio_system},
    Effect{Button::eoa, Select::override_, WindowId::default_},
    Effect{Button::adhesion, Select::count, WindowId::adhesion},
    Effect{Button::sr_speed_distance, Select::count, WindowId::sr_data},
    Effect{Button::train_integrity, Select::integrity_confirmed, WindowId::default_},
    Effect{Button::bmm_inhibit, Select::bmm_inhibit, WindowId::default_},
    Effect{Button::bmm_revoke, Select::bmm_revoke, WindowId::default_},
    Effect{Button::language, Select::count, WindowId::language},
    Effect{Button::volume, Select::count, WindowId::volume},
    Effect{Button::brightness, Select::count, WindowId::brightness},
    Effect{Button::system_version, Select::count, WindowId::system_version},
    Effect{Button::set_vbc, Select::vbc_set, WindowId::set_vbc},
    Effect{Button::remove_vbc, Select::vbc_remove, WindowId::remove_vbc},
    Effect{Button::ato, Select::count, WindowId::ato},
});
static_assert([] {
  for (std::size_t i = 0; i < kEffects.size(); ++i)
    if (terms::index(kEffects[i].button) != i) return false;
  return kEffects.size() == terms::index(Button::count);
}());

bool session_open(const State& state) { return state.display.radio == RadioIndication::up; }

/// The window in which the driver waits (015560 11.7).
WindowId waits_in(const State& state) {
  const bool radio_windows = state.window == WindowId::radio_data || state.window == WindowId::network_id ||
                             state.window == WindowId::radio_type;
  if (state.display.waiting == Waiting::network_list) return WindowId::radio_data;
  if (state.display.waiting == Waiting::radio_registration && radio_windows) return WindowId::radio_data;
  return WindowId::main;
}

/// The window that a step of the start of mission opens (015560 11.7.2); none: it stays.
std::optional<WindowId> opens(Dialogue step) {
  switch (step) {
    case Dialogue::start_S0:
    case Dialogue::start_S4:
    case Dialogue::start_D31:
    case Dialogue::start_D33:
    case Dialogue::start_A40:
    case Dialogue::start_S10:
      return WindowId::main;
    case Dialogue::start_S1:
      return WindowId::driver_id;
    case Dialogue::start_S2:
      return WindowId::level;
    case Dialogue::start_S3:
      return WindowId::radio_data;
    default:
      return std::nullopt;
  }
}

void follow_step(State& state, const port::Display& before, bool first) {
  const port::Display& display = state.display;
  const bool asked_before = !first && before.data.asks_one_radio_system;
  if (display.data.asks_one_radio_system && !asked_before) return open_window(state, WindowId::one_radio_system);
  if (!display.step || (!first && before.step == display.step)) return;
  if (before.start_of_mission) state.awaited = Awaited{};  // the step is the answer
  const auto window = opens(*display.step);
  if (!window || *window == state.window) return;
  // After the start-up dialogue a window that the driver has opened stays (015560 11.7.3).
  if (*display.step == Dialogue::start_S10 && !first && !before.start_of_mission && state.window != WindowId::default_)
    return;
  state.from_driver_id = false;
  open_window(state, *window);
}

/// The list of networks has come: the driver chooses (015560 11.7.2 S3-2-2). With an empty one the on-board says in the
/// start of mission what follows.
void take_list(State& state) {
  const port::Display& display = state.display;
  state.awaited = Awaited{};
  if (!display.data.networks.empty())
    open_window(state, WindowId::network_id);
  else if (!display.start_of_mission)
    open_window(state, after_failed_registration(display, display.data.radio));  // 015560 11.7.3 A5, D9
}

void follow_waiting(State& state, const port::Display& before, bool first) {
  const port::Display& display = state.display;
  const bool waits = display.waiting != Waiting::nothing;
  const bool waited = !first && before.waiting != Waiting::nothing;
  if (waits && !waited) {
    state.waiting_since = state.awaited.on ? state.awaited.since : display.now;
    const WindowId window = waits_in(state);
    const bool follows = display.start_of_mission || state.awaited.on || display.waiting == Waiting::network_list;
    if (window != state.window && follows) open_window(state, window);
  }
  const bool listed = waited && before.waiting == Waiting::network_list && display.waiting != Waiting::network_list;
  if (listed && state.window == WindowId::radio_data) take_list(state);
  Awaited& awaited = state.awaited;
  if (!awaited.on) return;
  if (waits) awaited.seen = true;
  const bool over = awaited.seen ? !waits : display.now - awaited.since > kAnswerBegins;
  if (!over) return;
  // What was asked for may have been refused: then the Main window stays (015560 11.7.3, Shunting and SM).
  const bool refused = awaited.then == WindowId::default_ && display.mode == awaited.mode && awaited.needs_mode;
  const WindowId then = refused ? WindowId::main : awaited.then;
  awaited = Awaited{};
  if (then == WindowId::network_id) return take_list(state);
  if (!display.start_of_mission) return open_window(state, then);
  // The on-board went no step further, as after data that it did not take: the window of its step is open again.
  const auto window = display.step ? opens(*display.step) : std::nullopt;
  if (window && *window != state.window) open_window(state, *window);
}

/// Level 2 from level 0 or NTC may trip the train: then the default window asks for the acknowledgement of the trip,
/// and the radio data come after it (015560 11.7.3 D5). This is so for the trip that follows the entry, not for a later
/// one: nothing is awaited any more as soon as the level was taken without a trip, or if it is not taken at all.
void follow_trip(State& state, const port::Display& before) {
  if (!state.trip_awaited_since) return;
  const port::Display& display = state.display;
  const bool taken = level_2_or_3(display.level);
  const bool trips = display.mode == Mode::TR && taken, tripped = before.mode == Mode::TR;
  if (trips && !tripped) {
    state.awaited = Awaited{};
    return open_window(state, WindowId::default_);
  }
  if (trips) return;
  const bool may_be_taken = !taken && display.now - *state.trip_awaited_since <= kAnswerBegins;
  if (!tripped && (may_be_taken || (taken && !level_2_or_3(before.level)))) return;
  state.trip_awaited_since.reset();
  if (tripped && display.mode == Mode::PT) open_window(state, WindowId::radio_data);
}

void begin_to_wait(State& state, WindowId then, Duration now, bool needs_mode) {
  state.awaited = Awaited{true, state.display.waiting != Waiting::nothing, now, then, needs_mode, state.display.mode};
  state.waiting_since = now;
}

/// Windows close when the condition of their button is lost, after the start-up dialogue (015560 11.7.1.7).
void close_lost(State& state) {
  const port::Display& display = state.display;
  const WindowRow& row = row_of(state.window);
  if (display.start_of_mission || !row.closes_on_loss || row.button >= Button::count) return;
  if (display.buttons.has(row.button)) return;
  abort_entry(state);
}

}  // namespace

void await(State& state, WindowId then, Duration now, bool needs_mode) {
  open_window(state, WindowId::main);
  begin_to_wait(state, then, now, needs_mode);
}
void await_network(State& state, WindowId then, Duration now) {
  open_window(state, WindowId::radio_data);
  begin_to_wait(state, then, now, false);
}

void choose(State& state, Button button, Duration now) {
  if (!button_enabled(state, button)) return;
  state.trip_awaited_since.reset();
  if (state.window == WindowId::main) give(state, Select::main);
  const Effect& effect = kEffects[terms::index(button)];
  if (effect.select != Select::count) give(state, effect.select);
  if (effect.opens != WindowId::count) return open_window(state, effect.opens);
  switch (button) {
    case Button::start:
      // 015560 11.7.3 D7: in level 2 with a session the RBC answers to the request of an authority.
      if (level_2_or_3(state.display.level) && session_open(state)) return await(state, WindowId::default_, now);
      return open_window(state, WindowId::default_);
    case Button::shunting:
      if (level_2_or_3(state.display.level)) return await(state, WindowId::default_, now, true);
      return open_window(state, WindowId::default_);
    case Button::gsmr_network_id:
      // 015560 11.7.3 S5-2-1: without a session, which the choice of a network ends, the list is there at once.
      return session_open(state) ? await_network(state, WindowId::network_id, now) : take_list(state);
    case Button::initiate_sm:
    case Button::continue_sm:
      return await(state, WindowId::default_, now, true);
    default:
      return await(state, WindowId::main, now);
  }
}

void follow_dialogue(State& state, const port::Display& before) {
  const bool first = !state.shown_once;
  follow_step(state, before, first);
  follow_waiting(state, before, first);
  if (!first) follow_trip(state, before);
  close_lost(state);
}

}  // namespace evc::dmi
