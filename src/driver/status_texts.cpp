#include "driver/status_texts.h"

#include "driver/driver.h"

namespace evc::driver {
namespace {

constexpr Duration kShownFor{30.0};

/// Whether the reason of the row holds, or what starts it happened, in this cycle.
bool holds(const StatusRow& row, const StatusFacts& facts) {
  if (row.inform.has_value()) return facts.inform.has(*row.inform);
  if (row.unsuitable.has_value()) return facts.unsuitable.has(*row.unsuitable);
  if (row.entering.has_value()) return facts.mode == *row.entering && !facts.described_under_train;
  return !(facts.brakes & row.brakes).empty();
}

bool over(const StatusTexts::Row& state, const StatusRow& row, bool reason, const StatusFacts& facts) {
  switch (row.end) {
    case TextEnd::with_its_reason:
      return !reason;
    case TextEnd::main_window:
      return facts.main_window_selection && !reason;
    case TextEnd::acknowledged:
      return facts.acknowledged;
    case TextEnd::s30_after_its_reason:
    case TextEnd::s30_and_its_reason:
    case TextEnd::s30:
    case TextEnd::s30_of_movement:
      return !reason && facts.now >= state.until;
  }
  return true;
}

void run(StatusTexts::Row& state, const StatusRow& row, const StatusFacts& facts) {
  // 15.1.1.2: a mode that does not show it ends it; while its reason holds, the next mode that shows it starts it anew.
  if (!allowed(row.output, facts.mode, facts.srs)) {
    state.on = false;
    return;
  }
  const bool reason = holds(row, facts);
  if (!(facts.revoked & row.brakes).empty() && row.end != TextEnd::s30_and_its_reason) state.on = false;
  const bool waits_for_movement = state.on && row.end == TextEnd::s30_of_movement && !state.moved;
  if ((reason && (!state.on || row.end != TextEnd::s30_and_its_reason)) || waits_for_movement)
    state.until = facts.now + kShownFor;
  state.moved = facts.moving || (state.moved && !reason);
  state.on = reason || (state.on && !over(state, row, reason, facts));
}

}  // namespace

void enter_trip(StatusTexts& texts, int condition) { texts.trip_reason = trip_reason(condition); }

void step(StatusTexts& texts, const StatusFacts& facts) {
  if (texts.idle() && facts.brakes.empty() && facts.inform.empty() && facts.unsuitable.empty() &&
      facts.described_under_train)
    return;
  if (!allowed(Output::trip_reason, facts.mode, facts.srs)) texts.trip_reason.reset();
  Set<StatusText> shown;
  if (texts.trip_reason.has_value()) shown.add(*texts.trip_reason);
  for (std::size_t i = 0; i < srs_status_texts.size(); ++i) {
    run(texts.rows[i], srs_status_texts[i], facts);
    shown.add(srs_status_texts[i].text, texts.rows[i].on);
  }
  for (std::size_t i = 0; i < texts.since.size(); ++i) {
    const StatusText text = static_cast<StatusText>(i);
    if (shown.has(text) && !texts.shown.has(text)) texts.since[i] = facts.now;
  }
  texts.shown = shown;
}

}  // namespace evc::driver
