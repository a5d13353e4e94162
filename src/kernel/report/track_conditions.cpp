#include "kernel/report/track_conditions.h"

#include "driver/driver.h"
#include "modes/active_functions.h"

namespace evc::kernel {
namespace {

using track::Progress;
using enum TrackConditionKind;

bool told(const Progress& p) { return p.phase != ConditionPhase::ahead && p.phase != ConditionPhase::over; }

/// Each with its number from its appearance on (015560 8.2.3.5: it keeps its place on the screen).
void show_to_driver(State& s, Outputs& out) {
  const auto show = [&](Progress& progress, driver::Output row, const std::optional<Symbol>& symbol,
                        std::optional<TrackConditionKind> kind, Place from, Place to) {
    if (!symbol || !driver::allowed(row, s.mode, s.srs)) {
      progress.shown_as = 0;
      return;
    }
    if (progress.shown_as == 0) progress.shown_as = s.displayed.next_condition();
    // As many as are stored.
    (void)out.track_conditions.push_back(
        {*symbol, kind, position::counter_of(s.position, from), position::counter_of(s.position, to), progress.phase});
  };
  for (track::TrackCondition& c : s.track.conditions)
    show(c.progress, driver::output_of(c.kind), driver::symbol(c.kind, c.progress.phase, s.by_train), c.kind, c.from,
         c.to);
  if (auto& t = s.track.traction)
    show(t->progress, driver::Output::track_cond_general,
         driver::symbol_of_traction(t->M_VOLTAGE, t->progress.phase, s.by_train), std::nullopt, t->at, t->at);
  s.displayed.conditions = !out.track_conditions.empty();
}

/// None is shown any more.
void take_from_driver(State& s) {
  if (!s.displayed.conditions) return;
  for (track::TrackCondition& c : s.track.conditions) c.progress.shown_as = 0;
  if (s.track.traction) s.track.traction->progress.shown_as = 0;
  s.displayed.conditions = false;
}

/// The horn, stopping areas and the radio hole concern the unit itself (3.12.1.5 b).
bool for_train(TrackConditionKind kind) { return !horn_or_stopping(kind) && kind != radio_hole; }

/// 5.20.2 to 5.20.5: a powerless section is given by the front end, and its start until the rear end has passed it;
/// the end of an air tightness or inhibition area by the rear end, its start until the front end has passed it.
void order_area(const track::TrackCondition& c, const track::Here& here, Outputs& out) {
  if (!for_train(c.kind) || !told(c.progress) || c.progress.rear_left) return;
  const bool powerless = c.kind == powerless_lower_pantograph || c.kind == powerless_main_switch_off;
  OrderedArea area;
  area.kind = c.kind;
  if (powerless ? here.min_safe_rear < c.from : here.max_safe_front < c.from)
    area.to_start = c.from - here.max_safe_front;
  area.to_end = c.to - (powerless ? here.min_safe_front : here.min_safe_rear);
  (void)out.ordered_areas.push_back(area);  // as many as are stored
}

/// 5.20.8
void order_platform(const track::Platform& p, const track::Here& here, Outputs& out) {
  if (!told(p.progress)) return;
  OrderedPlatform platform{std::nullopt, p.to - here.min_safe_front, p.M_PLATFORM, p.Q_PLATFORM};
  if (here.min_safe_rear < p.from) platform.to_start = p.from - here.max_safe_front;
  (void)out.ordered_platforms.push_back(platform);  // as many as are stored
}

void order_train(const State& s, const track::Here& here, Outputs& out) {
  for (const track::TrackCondition& c : s.track.conditions) order_area(c, here, out);
  for (const track::Platform& p : s.track.platforms) order_platform(p, here, out);
  const auto& traction = s.track.traction;
  if (traction && told(traction->progress) && !traction->progress.rear_left)
    out.ordered_traction = {traction->at - here.max_safe_front, traction->M_VOLTAGE, traction->NID_CTRACTION};
  const auto& current = s.track.current;
  if (current && told(current->progress)) out.ordered_current = {current->at - here.max_safe_front, current->amperes};
}

}  // namespace

void show_track_conditions(State& s, bool desk_open, const track::Here& here, Outputs& out) {
  // 4.4.21.1.13: the orders give distances ahead of the train, behind the engine if that is the other way round.
  out.remote_shunting = s.mode == Mode::SH || s.mode == Mode::SM;
  if (s.mode == Mode::SM)
    out.engine_orientation = s.manoeuvre.opposite ? EngineOrientation::opposite : EngineOrientation::same;
  if (!s.track.watch.shown || !desk_open) take_from_driver(s);
  if (!s.track.watch.shown) return;
  if (desk_open) show_to_driver(s, out);
  for (const ShownCondition& shown : out.track_conditions) out.sound_horn = out.sound_horn || shown.kind == sound_horn;
  if (modes::active(modes::Function::track_cond_general, s.mode)) order_train(s, here, out);
}

}  // namespace evc::kernel
