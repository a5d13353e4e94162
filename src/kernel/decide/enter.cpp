#include "kernel/decide/enter.h"

#include "kernel/here.h"
#include "kernel/stored.h"
#include "track/store.h"

namespace evc::kernel {
namespace {

bool antenna_in_metal(const State& s, const track::Here& here) {
  return protection::over_metal(s.track, here.min_safe_antenna, here.max_safe_antenna);
}

/// 5.22.3.1 of 4.0.0: the area in which the antenna was is reset, the metal stays. The alarm is inhibited from here on.
void inhibit_alarm_in_metal(State& s, bool was_in_metal) {
  if (s.srs == SrsVersion::v4_0_0 && was_in_metal && s.track.big_metal.empty())
    s.antenna_alarm.inhibited = s.position.now.counter;
}

/// 3.11.7.1.1: of the area whose order or acknowledgement leads to SH ([50], [51], [61]); 4.10 deletes it then.
track::SpeedCode speed_of_area(const State& s, int number, const track::Here& here) {
  if (number != 50 && number != 51 && number != 61) return track::kNoSpeed;
  for (const track::ModeArea& area : s.track.mode_profile)
    if (area.mode == Mode::SH && (area.accepted || here.max_safe_front >= area.from)) return area.V_MAMODE;
  return track::kNoSpeed;
}

}  // namespace

void enter_mode(State& s, Mode to, int number, const track::Here& here, Log log) {
  const Mode from = s.mode;
  log.note(Event::mode_changed(from, to, number));
  // The start of the entered area is no longer an end of authority; before 4.10 deletes the profile (SH).
  if (to == Mode::OS || to == Mode::LS || to == Mode::SH) track::accept_area(s.track, to, here);
  if (to == Mode::SH && from != Mode::PS) s.V_SH = speed_of_area(s, number, here);
  // By the driver's selection in levels 0, NTC and 1 there is no list; that of an area ahead is another one's.
  if (to == Mode::SH && number == 5) s.track.sh_list.reset();
  const bool in_metal = antenna_in_metal(s, here);
  keep_for_mode(s, to, from);
  if (to != Mode::NP && to != Mode::RV) inhibit_alarm_in_metal(s, in_metal);
  if (to == Mode::LS) s.lssma.on = false;  // 4.4.19.1.4.6; an order of this cycle has its own time
  if (!supervises_authority(to)) s.ma_with_trip_order = false;
  // A group that is only partly read is not continued after power off, nor a change of deleted train data.
  if (to == Mode::NP) {
    balise::abandon(s.balise);
    s.train_data_change.pending.reset();
    s.train_data_change.procedure = {};
  }
  s.mode = to;
  s.toggled_on = false;  // 015560 8.2.2.4: off at each entry
  for (track::ModeArea& area : s.track.mode_profile)
    area.asked = false;  // asked of the driver in the mode that is left
  track::forget_acceptance_ahead(s.track, to, here);
  ++s.revision;
  procedures::level_transition::on_mode_change(s.level_transition, from, to, s.srs);
  procedures::mode_profile::on_mode_change(s.mode_profile, to, number, s.now);
  procedures::override_::on_mode_change(s.override_, to);
  if (!s.level_transition.pending) clear_level_buffer(s);
  if (!supervises_authority(to)) s.shorten_at_standstill = false;
  brakes::on_mode_entry(s.brakes, to, from);
  if (to == Mode::TR) driver::enter_trip(s.status_texts, number);
  protection::enter_mode(s.guards, protection::guards_of(to), position::forward_counter(s.position));
  // 4.4.11.1.3.1: unless the RBC gave a distance with its authorisation.
  if (to == Mode::SR && !s.staff_responsible.by_rbc) limit_SR_distance(s, here);
}

void end_start_of_mission(State& s, const track::Here& here) {
  const bool in_metal = antenna_in_metal(s, here);
  keep_for_closed_desk(s);
  inhibit_alarm_in_metal(s, in_metal);
  ++s.revision;
}

}  // namespace evc::kernel
