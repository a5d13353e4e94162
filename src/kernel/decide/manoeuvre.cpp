#include "kernel/manoeuvre.h"

#include "kernel/decide/mission.h"
#include "kernel/here.h"

namespace evc::kernel {

void run_manoeuvre(State& s, bool desk_open, const Received& received, procedures::Facts& facts,
                   procedures::Effects& effects) {
  if (s.srs != SrsVersion::v4_0_0) return;
  if (!desk_open) s.manoeuvre.request = {};  // who asked has gone, and no answer is accepted (4.8.4 [2])
  procedures::supervised_manoeuvre::Inputs in;
  in.now = s.now;
  in.mode = s.mode;
  in.level = s.level.level;
  in.session_open = s.radio.supervising.session.established();
  in.selects = received.selected.has(Select::sm) || received.selected.has(Select::continue_sm);
  in.authorised = received.SM_authorised;
  in.refused = received.SM_refused;
  const auto r = procedures::supervised_manoeuvre::step(s.manoeuvre.request, in);
  effects |= r.effects;
  facts.SM_authorised = r.granted;
  if (r.requested) s.manoeuvre.informs = true;
  if (received.SM_refused && !s.manoeuvre.active) s.manoeuvre.informs = false;
}

void finish_manoeuvre(State& s, const Received& received, Decided& out, Log log) {
  if (s.srs != SrsVersion::v4_0_0) return;
  Manoeuvre& m = s.manoeuvre;
  // 3.6.1.5.1: until the mission ends, or goes on in NL.
  const bool over = out.mission_ended || s.mode == Mode::NL || s.mode == Mode::NP || s.mode == Mode::SL;
  if (over) m.informs = false;
  if (m.active && over && end_manoeuvre(s)) log.note({.what = What::train_turned, .clause = "3.6.1.5"_srs});
  // 4.4.21.1.12: at standstill what is ahead is shortened at once, else with the brake.
  if (received.consist_lost && s.mode == Mode::SM) {
    out.effects.inform.add(Inform::consist_length_lost);
    out.asked.add(brakes::Cause::consist_length, !out.here.standstill);
    s.shorten_at_standstill = true;
  }
  if (consist_in_front(s)) invalidate(s.data.train_data_status);  // 3.18.3.5
  place_front_end(s);
  out.here = here(s);
}

}  // namespace evc::kernel
