#include "kernel/report/texts.h"

#include "brakes/brakes.h"
#include "kernel/driver_inputs.h"
#include "kernel/here.h"
#include "kernel/train_category.h"
#include "modes/active_functions.h"
#include "track/services.h"

namespace evc::kernel {
namespace {

void show_trackside_texts(const State& s, const track::TextDisplay& display, Outputs& out) {
  for (const std::uint8_t id : display.shown)
    for (const track::Text& text : s.track.texts) {
      if (text.id != id) continue;
      ShownText shown;
      shown.id = id;
      shown.important = text.Q_TEXTCLASS == 1;
      for (const std::uint8_t waits : display.to_acknowledge) shown.acknowledge = shown.acknowledge || waits == id;
      shown.since = text.shown_since;
      shown.Q_TEXT = text.Q_TEXT;
      shown.length = text.length;
      shown.characters = text.characters;
      (void)out.texts.push_back(shown);  // at most six
    }
}

/// The causes whose brake commands the mode entry of this cycle revokes (4.12).
Set<Cause> revoked_causes(Mode to, Mode from) {
  Set<Cause> revoked;
  for (const brakes::CauseRow& row : brakes::srs_3_14_1)
    revoked.add(row.cause, brakes::revoked_on_mode_entry(row.cause, to, from));
  return revoked;
}

driver::StatusFacts facts_of(const State& s, const Decided& decided, Set<Inform> inform, bool main_window_selection,
                             const Outputs& out) {
  driver::StatusFacts f;
  f.now = s.now;
  f.mode = s.mode;
  f.srs = s.srs;
  f.brakes = out.brake_reasons;
  if (decided.mode_changed) f.revoked = revoked_causes(s.mode, s.previous_mode);
  f.inform = inform;
  f.main_window_selection = main_window_selection;
  f.moving = !decided.here.standstill;
  f.acknowledged = decided.status_acknowledged;
  if (!s.track.suitability.empty()) f.unsuitable = track::unsuitability(s.track, interfaces_of(s.train));
  if (s.mode == Mode::FS || s.mode == Mode::OS || s.mode == Mode::SM)
    f.described_under_train = track::described_under_train(s.track, decided.here);
  return f;
}

void show_status_texts(State& s, const driver::StatusFacts& facts, bool desk_open, Outputs& out) {
  driver::step(s.status_texts, facts);
  out.trip_reason = s.status_texts.trip_reason;
  if (s.status_texts.shown.empty() || !desk_open) return;
  for (std::size_t i = 0; i < s.status_texts.since.size(); ++i) {
    const auto text = static_cast<StatusText>(i);
    // There is room for all but some that exclude each other.
    if (s.status_texts.shown.has(text)) (void)out.status_texts.push_back({text, s.status_texts.since[i]});
  }
}

/// Whether the driver selected an enabled button of the main window in this cycle, or entered what it leads to
/// (015560 11.2.1).
bool selects_in_main_window(const Received& received) {
  for (const Select button :
       {Select::start, Select::shunting, Select::exit_shunting, Select::non_leading, Select::maintain_shunting,
        Select::train_data, Select::main, Select::sm, Select::continue_sm, Select::exit_sm})
    if (received.selected.has(button)) return true;
  return !received.entered.empty();
}

}  // namespace

void show_texts(State& s, bool desk_open, const Received& received, const Decided& decided, Set<Inform> inform,
                Outputs& out) {
  show_trackside_texts(s, decided.texts, out);
  show_status_texts(s, facts_of(s, decided, inform, selects_in_main_window(received), out), desk_open, out);
}

void show_enabled(const State& s, const Inputs& in, const track::Here& here, Outputs& out) {
  out.level_valid = valid(s.data.level_status);
  out.levels_allowed =
      modes::levels_allowed(s.level_table ? &*s.level_table : nullptr, available_levels(s, in.national_system));
  if (modes::active(modes::Function::geo_position, s.mode))
    if (const auto geo = track::geographical_position(s.track, here)) out.geo = Distance{static_cast<double>(*geo)};
  if (s.mode == Mode::RV) out.rv_left = track::reversing_left(s.track, here);
  out.enabled = driver::enabled(action_context(s, in, here));
  for (const radio::Peer peer : radio::kRbcs) {
    const radio::Session& session = s.radio.partner(peer).session;
    if (session.phase != SessionPhase::idle)
      (void)out.sessions.push_back(
          {session.rbc.NID_C, session.rbc.NID_RBC, session.phase, radio::role_of(s.radio, peer)});
  }
  for (const radio::Session& session : s.radio.infill_units)
    if (session.phase != SessionPhase::idle)
      (void)out.infill_sessions.push_back({session.rbc.NID_C, session.rbc.NID_RBC, session.phase, {}});  // two
}

}  // namespace evc::kernel
