#include <algorithm>

#include "dmi/acks.h"
#include "dmi/dmi.h"
#include "dmi/drawing.h"
#include "dmi/windows.h"

namespace evc::dmi {
namespace {

bool may_toggle(Mode mode) { return mode == Mode::OS || mode == Mode::SR || mode == Mode::SH; }

/// The modes in which the driver has no windows: without power, passive, isolated or failed (SUBSET-026-4 4.7.2).
bool has_no_windows(Mode mode) {
  return mode == Mode::NP || mode == Mode::PS || mode == Mode::SL || mode == Mode::SF || mode == Mode::IS;
}

/// B3 to B5 (015560 8.2.3.5.3, 8.2.3.8.3): a symbol takes the first free place and keeps it; when all are taken the
/// others wait in the order of their appearance.
void assign_slots(State& state) {
  const auto& conditions = state.display.conditions;
  const auto shown = [&](std::uint16_t id) {
    return std::any_of(conditions.begin(), conditions.end(), [&](const auto& condition) { return condition.id == id; });
  };
  for (std::uint16_t& slot : state.slots)
    if (slot != 0 && !shown(slot)) slot = 0;
  for (const port::DisplayedCondition& condition : conditions) {
    if (condition.id == 0 || std::find(state.slots.begin(), state.slots.end(), condition.id) != state.slots.end())
      continue;
    const auto free = std::find(state.slots.begin(), state.slots.end(), std::uint16_t{0});
    if (free == state.slots.end()) return;
    *free = condition.id;
  }
}

TextKey key_of(const port::DisplayedText& text) { return {text.id, text.kind, text.since}; }
bool is_among(const TextKey& key, const port::Display& display) {
  return std::any_of(display.texts.begin(), display.texts.end(),
                     [&](const port::DisplayedText& text) { return key_of(text) == key; });
}

/// Texts that are new: scrolling begins again. The important ones are heard when they are displayed for the first time
/// (015560 8.2.3.4.7 h): not while a text to be acknowledged hides them (5.4.1.10).
void take_texts(State& state, const port::Display& before, bool first) {
  state.unheard.erase_if([&](const TextKey& key) { return !is_among(key, state.display); });
  for (const port::DisplayedText& text : state.display.texts) {
    if (!first && is_among(key_of(text), before)) continue;
    state.scroll = 0;
    if (text.important && !text.acknowledge && !state.unheard.push_back(key_of(text))) break;  // as many as texts
  }
  if (!state.unheard.empty() && !text_ack_waits(state)) {
    order_sound(state, Sound::Sinfo);
    state.unheard.clear();
  }
  while (state.scroll > 0 && !can_scroll(state, false)) {
    --state.scroll;
    if (can_scroll(state, false)) {
      ++state.scroll;
      break;
    }
  }
}

/// Sounds of speed and distance monitoring (015560 7.2.3.3, 7.4, 7.5.1.1, 14.3).
void monitoring_sounds(State& state, const port::Display& before) {
  const port::Display& display = state.display;
  const bool silent = display.mode == Mode::LS || display.mode == Mode::AD;
  const bool was_CSM = before.monitoring == Monitoring::CSM,
             both_TSM = before.monitoring == Monitoring::TSM && display.monitoring == Monitoring::TSM;
  const bool entered = was_CSM && (display.monitoring == Monitoring::TSM || display.monitoring == Monitoring::RSM);
  if (!silent && (entered || (both_TSM && before.MRDT != display.MRDT))) order_sound(state, Sound::Sinfo);
  if (display.mode != Mode::AD && both_TSM && before.status < Status::Overspeed && display.status >= Status::Overspeed)
    order_sound(state, Sound::S1);
}

void warning_sound(State& state) {
  const port::Display& display = state.display;
  const bool monitored = display.monitoring == Monitoring::CSM || display.monitoring == Monitoring::TSM;
  const bool warns = (monitored && display.status == Status::Warning && display.mode != Mode::AD) ||
                     (display.ato.warning_sound && is_400(display));
  if (warns == state.warning_sounds) return;
  state.warning_sounds = warns;
  order_sound(state, Sound::S2, warns ? SoundDo::loop : SoundDo::stop);
}

bool asks(const port::Display& display, Ack what) {
  return std::any_of(display.acks.begin(), display.acks.end(),
                     [&](const port::AskedAck& asked) { return asked.what == what; });
}

void symbol_sounds(State& state, const port::Display& before) {
  const port::Display& display = state.display;
  // 015560 8.2.2.3.6: without any acknowledgement. The mode Trip is left by the driver's (SUBSET-026-4 4.4.13.1.4),
  // which releases its brake.
  const bool trip_acknowledged = before.mode == Mode::TR && display.mode != Mode::TR;
  // The driver may have acknowledged the brake elsewhere than on this display: the on-board asks no more.
  const bool brake_answered = asks(before, Ack::brake) && !asks(display, Ack::brake);
  const bool acknowledged =
      state.brake_acknowledged || brake_answered || before.brake_for_missing_ack || trip_acknowledged;
  if (before.brake && !display.brake && !acknowledged) order_sound(state, Sound::Sinfo);
  if (!display.brake) state.brake_acknowledged = false;
  if (before.sm && display.sm && *before.sm != *display.sm) order_sound(state, Sound::Sinfo);
}

}  // namespace

void show(State& state, const port::Display& display) {
  const bool first = !state.shown_once;
  const bool had_TTI = !first && shows_TTI(state);
  // The record of before is needed in parts only, but a copy is simple and has no pointers.
  const port::Display before = state.display;
  state.display = display;
  // The level and the radio data may be entered again from the Main window: that is no start-up any more.
  state.main_reached =
      display.mode == Mode::SB && (state.main_reached || (display.step && *display.step >= Dialogue::start_S10));
  if (state.main_reached) state.display.start_of_mission = false;
  if (first || before.mode != display.mode) state.toggles.speed = false;  // off at every entry (015560 8.2.2.4.5)
  if (!may_toggle(display.mode)) state.toggles.speed = false;

  if (has_no_windows(display.mode) && state.window != WindowId::default_) {
    state.awaited = Awaited{};
    state.from_driver_id = false;
    open_window(state, WindowId::default_);
  }
  assign_slots(state);
  if (!first) {
    monitoring_sounds(state, before);
    symbol_sounds(state, before);
  }
  warning_sound(state);
  if (shows_TTI(state) && !had_TTI && display.mode != Mode::AD) order_sound(state, Sound::Sinfo);

  if (!has_no_windows(display.mode)) follow_dialogue(state, first ? port::Display{} : before);
  take_texts(state, before, first);
  offer_acks(state, before);
  state.shown_once = true;
  tick(state, display.now);
}

train::TrainData with_entered(const train::TrainData& base, const port::ShownTrainData& entered) {
  train::TrainData data = base;
  data.L_TRAIN = entered.L_TRAIN;
  data.V_MAXTRAIN = entered.V_MAXTRAIN;
  if (entered.brake_percentage) data.brake_percentage = *entered.brake_percentage;
  data.cant_deficiency_mm = entered.cant_deficiency_mm;
  data.other_categories = entered.other_categories;
  data.brake_position = (entered.other_categories & train::kFreightG) != 0   ? train::BrakePosition::FreightG
                        : (entered.other_categories & train::kFreightP) != 0 ? train::BrakePosition::FreightP
                                                                             : train::BrakePosition::PassengerP;
  data.axle_load = entered.axle_load;
  data.loading_gauge = entered.loading_gauge;
  data.airtight = entered.airtight;
  return data;
}

}  // namespace evc::dmi
