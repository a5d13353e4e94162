#include "kernel/stored.h"

#include "kernel/here.h"
#include "track/withdraw.h"

namespace evc::kernel {
namespace {

using modes::Fate;

constexpr bool clears(Fate fate) { return fate == Fate::deleted || fate == Fate::reset; }

void remove_stops(State& s, bool conditional) {
  s.emergency_stops.pending.erase_if(
      [conditional](const protection::EmergencyStop& e) { return e.conditional == conditional; });
}

/// Deletes or resets data stored outside the track description.
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
    case lssma_toggle_on_order:
      s.lssma = {};
      return;
    case unconditional_stops:
      remove_stops(s, false);
      return;
    case conditional_stops:
      remove_stops(s, true);
      return;
    case train_data:
      s.data.train_data_status = DataStatus::unknown;
      return;
    case driver_id:
      s.data.driver_id_status = DataStatus::unknown;
      return;
    case rbc_id_phone:
      s.radio.contact.reset();
      s.contact_status = DataStatus::unknown;
      return;
    case train_running_number:
      s.data.train_running_number_status = DataStatus::unknown;
      return;
    case track_ahead_free_request:
      s.track_ahead_free = {};
      return;
    case eolm:
      s.loop.reset();
      return;
    case radio_infill_area:
      s.radio_infill = {};
      return;
    default:
      return;  // position, level, its table, national values, versions, covers and language are never deleted (4.10)
  }
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
    case eolm:
      if (s.loop) invalidate(s.loop->status);
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

void keep_for_mode(State& state, Mode to, Mode from) {
  // 4.10 of 4.0.0 has a row of its own for the authority of a supervised manoeuvre.
  const bool kept = state.manoeuvre.authority && (to == Mode::SM || to == Mode::PT);
  apply_all(state, [&](Stored stored) {
    if (stored == Stored::movement_authority && state.manoeuvre.authority && from != Mode::NP)
      return kept ? Fate::unchanged : Fate::deleted;
    return modes::on_entry(to, from, stored, state.srs);
  });
  if (!kept) state.manoeuvre.authority = false;
  // [1] of 4.0.0: no procedure of SL would validate it.
  if (state.srs == SrsVersion::v4_0_0 && to == Mode::SL && state.position.status == DataStatus::invalid)
    position::forget(state.position);
}

void revalidate_after_power_off(State& state, const std::optional<bool>& moved) {
  const auto movement = moved == false ? modes::ColdMovement::none : modes::ColdMovement::moved_or_unknown;
  const auto becomes = [movement](Stored stored) { return modes::on_exit_np(movement, stored); };
  const auto revalidate = [&](Stored stored, DataStatus& status) {
    if (status == DataStatus::invalid) status = becomes(stored);
  };
  if (valid(becomes(Stored::train_position))) position::validate(state.position);
  revalidate(Stored::level, state.data.level_status);
  revalidate(Stored::rbc_id_phone, state.contact_status);
  if (state.loop) revalidate(Stored::eolm, state.loop->status);
  if (state.loop && state.loop->status == DataStatus::unknown) state.loop.reset();
  if (becomes(Stored::trackside_level_table) == DataStatus::unknown) state.level_table.reset();
}

void keep_for_level(State& state, Level to) {
  apply_all(state, [to](Stored stored) { return modes::on_level_entry(to, stored); });
}

void keep_for_closed_desk(State& state) {
  apply_all(state, [](Stored stored) { return modes::on_desk_closed_in_start_of_mission(stored); });
  procedures::level_transition::forget_order(state.level_transition);
  clear_level_buffer(state);
}

Sessions sessions_of(const State& s) {
  return {s.radio.supervising.session.ongoing(), s.radio.other.session.ongoing()};
}

void delete_with_sessions(State& s, Sessions before) {
  const Sessions now = sessions_of(s);
  if (before.supervising && !now.supervising) {
    s.buffer.erase_if([](const BufferedSet& set) { return set.medium == Medium::rbc && !set.accepting; });
    s.track.revocable_tsr_inhibited = false;
  }
  if (before.other && !now.other) s.buffer.erase_if([](const BufferedSet& set) { return set.accepting; });
}

void clear_level_buffer(State& s) {
  s.buffer.erase_if([](const BufferedSet& set) { return !set.accepting; });
}

void limit_SR_distance(State& state, const track::Here& here) {
  state.staff_responsible.national_from = here.est_front;
  state.staff_responsible.counter = virtual_front(state);
  follow_national_SR_distance(state);
}

void follow_national_SR_distance(State& state) {
  StaffResponsible& sr = state.staff_responsible;
  if (!sr.national_from) return;
  sr.end.reset();
  sr.end_of_curves.reset();
  const std::optional<Distance>& D = state.national_values.D_NVSTFF;
  if (!D) return;
  sr.end = *sr.national_from + *D;
  sr.D = *D;
  follow_virtual_front(state);
}

void set_SR_distance(State& state, const track::Here& here, const std::optional<Distance>& D) {
  set_SR_end(state, D ? std::optional(here.est_front + *D) : std::nullopt);
  if (!D) return;
  state.staff_responsible.counter = virtual_front(state);
  state.staff_responsible.D = *D;
  follow_virtual_front(state);
}

void set_SR_end(State& state, const std::optional<Place>& end) {
  StaffResponsible& sr = state.staff_responsible;
  sr.national_from.reset();
  sr.counter.reset();
  sr.end_of_curves.reset();
  sr.end = end;
}

std::optional<OdometerReading> virtual_front(const State& state) {
  if (state.srs != SrsVersion::v4_0_0) return std::nullopt;
  return state.position.now.counter;
}

void follow_virtual_front(State& state) {
  constexpr Distance kRounding{0.001};
  StaffResponsible& sr = state.staff_responsible;
  const PlaceInterval front = position::front(state.position);
  if (sr.counter && sr.end) {
    const position::Way way = position::way_since(state.position, *sr.counter);
    const Place before = sr.end_of_curves.value_or(*sr.end);
    sr.end = front.est + (sr.D - way.est);
    sr.end_of_curves = front.max + (sr.D - way.est - way.under);
    const Distance moved = *sr.end_of_curves - before;
    if (moved > kRounding || moved < -kRounding) ++state.revision;
  }
  procedures::override_::State& override_ = state.override_;
  if (override_.virtual_front && override_.former_eoa) {
    const position::Way way = position::way_since(state.position, *override_.virtual_front);
    override_.former_eoa = front.min - (way.est - way.over);
  }
}

void cut_beyond(State& state, Place beyond, Brought brought) {
  if (!brought.linking) balise::clear_beyond(state.balise.linking, beyond);
  if (!brought.national_values && state.pending_national_values && state.pending_national_values->from > beyond)
    state.pending_national_values.reset();
}

bool shorten(State& state, track::Situation situation, Place beyond, const track::Here& here) {
  const auto far_end = [&] { return state.track.ma ? std::optional(state.track.ma->far_end()) : std::nullopt; };
  const std::optional<Place> before = far_end();
  const bool described = track::shorten(state.track, situation, beyond, here, state.mode == Mode::SH);
  if (described) state.track_description_deleted = true;
  cut_beyond(state, beyond);
  return described || far_end() != before;
}

}  // namespace evc::kernel
