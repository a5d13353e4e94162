#include "dmi/acks.h"

#include "dmi/windows.h"
#include "openevc/terms/mode_symbol.h"

namespace evc::dmi {
namespace {

constexpr Duration kGap{1.0};         // between two acknowledgements
constexpr Duration kAnswerLost{5.0};  // an answer that the on-board did not take by then is asked for again

/// The order of requests of the same moment (015560 5.4.1.9.1): level, mode, fixed text, plain text, system status,
/// brake, NTC text.
int rank_of(const port::Display& display, const port::AskedAck& ack) {
  switch (ack.what) {
    case Ack::level:
      return 0;
    case Ack::text:
      for (const port::DisplayedText& text : display.texts)
        if (text.id == ack.id) {
          constexpr std::array<int, 4> kByKind{2, 3, 4, 6};
          return kByKind[static_cast<std::size_t>(text.kind) & 3u];
        }
      return 3;
    case Ack::train_data:
      return 4;
    case Ack::brake:
      return 5;
    default:
      return 1;
  }
}

bool is_asked(const port::Display& display, const port::AskedAck& ack) {
  for (const port::AskedAck& asked : display.acks)
    if (asked == ack) return true;
  return false;
}

/// The next request to offer; null: none.
const port::AskedAck* next_ack(const State& state) {
  const port::AskedAck* next = nullptr;
  for (const port::AskedAck& asked : state.display.acks) {
    if (is_answered(state, asked)) continue;
    const bool sooner = next != nullptr &&
                        (asked.since < next->since ||
                         (asked.since == next->since && rank_of(state.display, asked) < rank_of(state.display, *next)));
    if (next == nullptr || sooner) next = &asked;
  }
  return next;
}

}  // namespace

AckPlace place_of(Ack what) {
  if (for_text(what)) return {Area::E5_E9, Area::E5_E9, ButtonType::up};
  if (what == Ack::brake) return {Area::C9, Area::C8_C9_E1, ButtonType::up};
  return {Area::C1, Area::C1, what == Ack::SR ? ButtonType::delay : ButtonType::up};
}

std::optional<Picture> ack_picture(const port::Display& display, Ack what) {
  if (what == Ack::brake) return Picture::ST01;
  if (what == Ack::level)
    return picture_of(
        announcement_symbol(display.announced_level ? display.announced_level->level : display.level, true));
  const std::optional<Symbol> of_mode = symbol(what);
  return of_mode ? std::optional(picture_of(*of_mode)) : std::nullopt;
}

bool is_answered(const State& state, const port::AskedAck& ack) {
  for (const Answered& answered : state.answered)
    if (answered.ack == ack) return true;
  return false;
}

bool text_ack_waits(const State& state) {
  for (const port::AskedAck& asked : state.display.acks)
    if (for_text(asked.what) && !is_answered(state, asked)) return true;
  return false;
}

/// In the start-up dialogue acknowledgements wait (015560 11.7.1.9).
bool held_back(const port::Display& display) { return display.start_of_mission; }

bool ack_pending(const State& state) {
  if (state.offered) return true;
  return !held_back(state.display) && next_ack(state) != nullptr;
}

void order_sound(State& state, Sound sound, SoundDo what) {
  const SoundOrder order{sound, what};
  for (const SoundOrder& ordered : state.commands.sounds)
    if (ordered == order && sound != Sound::click) return;
  if (!state.commands.sounds.push_back(order)) return;  // nobody hears more at a time
}

void offer_acks(State& state, const port::Display& before) {
  const port::Display& display = state.display;
  const Duration now = display.now;
  state.answered.erase_if(
      [&](const Answered& answered) { return !is_asked(display, answered.ack) || now - answered.at > kAnswerLost; });
  if (state.offered && !is_asked(display, state.offered->ack)) {
    state.offered.reset();
    state.next_offer = now + kGap;
  }
  if (held_back(before) && !held_back(display)) state.next_offer = now + kGap;
  if (held_back(display) || state.offered) return;
  const port::AskedAck* next = next_ack(state);
  if (next == nullptr) return;
  if (is_entry(state.window) && !display.start_of_mission) {
    abort_entry(state);
    state.next_offer = now + kGap;
  }
  if (now < state.next_offer) return;
  state.offered = Offered{*next, now};
  order_sound(state, Sound::Sinfo);
}

void acknowledge(State& state, Duration now) {
  if (!state.offered) return;
  const port::AskedAck ack = state.offered->ack;
  state.offered.reset();
  state.next_offer = now + kGap;
  if (state.answered.full()) state.answered.erase(0);
  if (!state.answered.push_back({ack, now})) return;
  if (ack.what < Ack::count) state.commands.actions.acknowledged |= 1u << static_cast<unsigned>(ack.what);
  if (ack.what == Ack::text) state.commands.actions.acknowledged_text = ack.id;
  if (ack.what == Ack::brake) state.brake_acknowledged = true;
}

}  // namespace evc::dmi
