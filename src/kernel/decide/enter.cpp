#include "kernel/decide/enter.h"

#include "kernel/stored.h"

namespace evc::kernel {

void enter_mode(State& s, Mode to, int number, const track::Here& here, Log log) {
  const Mode from = s.mode;
  log.note(Event::mode_changed(from, to, number));
  // The start of the entered area is no longer an end of authority; before 4.10 deletes the profile (SH).
  if (to == Mode::OS || to == Mode::LS || to == Mode::SH) track::accept_area(s.track, to, here);
  // By the driver's selection in levels 0, NTC and 1 there is no list; that of an area ahead is another one's.
  if (to == Mode::SH && number == 5) s.track.sh_list.reset();
  keep_for_mode(s, to, from);
  if (to == Mode::LS) s.lssma.on = false;  // 4.4.19.1.4.6; an order of this cycle has its own time
  if (to != Mode::FS && to != Mode::LS && to != Mode::OS) s.ma_with_trip_order = false;
  // A group that is only partly read is not continued after power off, nor a change of deleted train data.
  if (to == Mode::NP) {
    balise::abandon(s.balise);
    s.train_data_change.pending.reset();
    s.train_data_change.procedure = {};
  }
  s.mode = to;
  ++s.revision;
  procedures::level_transition::on_mode_change(s.level_transition, from, to, s.srs);
  procedures::mode_profile::on_mode_change(s.mode_profile, to, number, s.now);
  procedures::override_::on_mode_change(s.override_, from, to);
  if (!s.level_transition.pending) clear_level_buffer(s);
  if (to != Mode::FS && to != Mode::LS && to != Mode::OS) s.shorten_at_standstill = false;
  brakes::on_mode_entry(s.brakes, to, from);
  if (to == Mode::TR) driver::enter_trip(s.status_texts, number);
  protection::enter_mode(s.guards, protection::guards_of(to), position::forward_counter(s.position));
  // 4.4.11.1.3.1: unless the RBC gave a distance with its authorisation.
  if (to == Mode::SR && !s.staff_responsible.by_rbc) limit_SR_distance(s, here);
}

}  // namespace evc::kernel
