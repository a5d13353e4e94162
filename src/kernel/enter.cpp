#include "kernel/enter.h"

#include "modes/mode_properties.h"
#include "track/withdraw.h"

namespace evc::kernel {
namespace {

using modes::Fate;

constexpr bool clears(Fate fate) { return fate == Fate::deleted || fate == Fate::reset; }

void remove_stops(State& s, bool conditional) {
  s.emergency_stops.pending.erase_if(
      [conditional](const protection::EmergencyStop& e) { return e.conditional == conditional; });
}

/// Deletes or resets what is kept outside the track description.
void clear_other(State& s, Stored stored) {
  using enum Stored;
  switch (stored) {
    case pending_national_values:
      s.pending_national_values.reset();
      return;
    case linking:
      balise::clear(s.balise.linking);
      return;
    case ma_request_params:
      s.radio.ma_request.reset();
      return;
    case position_report_params:
      position::clear_parameters(s.reports);
      return;
    case sr_bg_list_speed_distance:
      s.staff_responsible = {};
      return;
    case adhesion_driver:
      s.slippery_rail = false;
      return;
    case unconditional_stops:
      remove_stops(s, false);
      return;
    case conditional_stops:
      remove_stops(s, true);
      return;
    case train_position:
      position::forget(s.position);
      return;
    case train_data:
      s.data.train_data_status = DataStatus::unknown;
      return;
    case level:
      s.data.level_status = DataStatus::unknown;
      return;
    case trackside_level_table:
      s.level_table.reset();
      return;
    case driver_id:
      s.data.driver_id_status = DataStatus::unknown;
      return;
    case rbc_id_phone:
      s.radio.contact.reset();
      return;
    case train_running_number:
      s.data.train_running_number_status = DataStatus::unknown;
      return;
    case track_ahead_free_request:
      s.track_ahead_free = {};
      return;
    default:
      return;  // national values, versions, covers and language are never deleted (4.10)
  }
}

void invalidate(DataStatus& status) {
  if (status == DataStatus::valid) status = DataStatus::invalid;
}

void revalidate(State& s, Stored stored) {
  using enum Stored;
  switch (stored) {
    case train_position:
      position::invalidate(s.position);
      return;
    case train_data:
      invalidate(s.data.train_data_status);
      return;
    case level:
      invalidate(s.data.level_status);
      return;
    case driver_id:
      invalidate(s.data.driver_id_status);
      return;
    case train_running_number:
      invalidate(s.data.train_running_number_status);
      return;
    case rbc_id_phone:
      invalidate(s.contact_status);
      return;
    default:
      return;
  }
}

void apply(State& s, Stored stored, Fate fate) {
  if (fate == Fate::to_be_revalidated) return revalidate(s, stored);
  if (!clears(fate)) return;
  (void)track::forget(s.track, stored);
  clear_other(s, stored);
}

template <class FateOf>
void apply_all(State& s, FateOf fate_of) {
  for (std::size_t i = 0; i < kStored; ++i) {
    const auto stored = static_cast<Stored>(i);
    apply(s, stored, fate_of(stored));
  }
}

}  // namespace

void enter_mode(Cycle& cycle, Mode to, int number) {
  State& s = cycle.state;
  const Mode from = s.mode;
  note(cycle, Event::mode_changed(from, to, number));
  // The area that was entered is no end of authority any more; before 4.10 deletes the profile (SH).
  if (to == Mode::OS || to == Mode::LS || to == Mode::SH) track::accept_area(s.track, to, cycle.here);
  apply_all(s, [&](Stored stored) { return modes::on_entry(to, from, stored, s.srs); });
  if (to != Mode::FS && to != Mode::LS && to != Mode::OS) s.ma_with_trip_order = false;
  // A group that is only partly read is not continued after the power was off.
  if (to == Mode::NP) balise::abandon(s.balise);
  s.mode = to;
  ++s.revision;
  procedures::level_transition::on_mode_change(s.level_transition, from, to);
  procedures::mode_profile::on_mode_change(s.mode_profile, to, number, s.now);
  procedures::override_::on_mode_change(s.override_, from, to);
  if (!s.level_transition.pending) s.buffer.clear();
  if (to != Mode::FS && to != Mode::LS && to != Mode::OS) s.shorten_at_standstill = false;
  brakes::on_mode_entry(s.brakes, to, from);
  protection::enter_mode(s.guards, protection::guards_of(to), s.position.now.counter.nominal);
  if (to == Mode::SR) {
    // 4.4.11.1.3.1: the national distance from the estimated front end, unless the RBC gave one with its authorisation.
    if (!s.staff_responsible.by_rbc && s.national_values.D_NVSTFF)
      s.staff_responsible.end = cycle.here.est_front + *s.national_values.D_NVSTFF;
  }
  cycle.report_events.mode_change = true;
}

void enter_level(Cycle& cycle, const modes::OrderedLevel& to, bool by_driver) {
  State& s = cycle.state;
  note(cycle, Event::level_changed(s.level.level, to.level, by_driver));
  s.level = to;
  s.data.level_status = DataStatus::valid;
  ++s.revision;
  apply_all(s, [&](Stored stored) { return modes::on_level_entry(to.level, stored); });
  cycle.report_events.level_change = true;
  cycle.level_changed_by_driver = by_driver;
}

void close_desk_in_start_of_mission(Cycle& cycle) {
  State& s = cycle.state;
  apply_all(s, [](Stored stored) { return modes::on_desk_closed_in_start_of_mission(stored); });
  ++s.revision;
}

}  // namespace evc::kernel
