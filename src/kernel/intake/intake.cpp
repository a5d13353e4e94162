#include "kernel/intake/intake.h"

#include "kernel/basis.h"
#include "kernel/cab.h"
#include "kernel/clock.h"
#include "kernel/here.h"
#include "kernel/intake/buffer.h"
#include "kernel/intake/driver.h"
#include "kernel/intake/groups.h"
#include "kernel/intake/levels.h"
#include "kernel/intake/loops.h"
#include "kernel/intake/manoeuvre.h"
#include "kernel/intake/national_values.h"
#include "kernel/intake/radio_messages.h"
#include "kernel/intake/reception.h"
#include "kernel/intake/system_version.h"
#include "kernel/manoeuvre.h"
#include "kernel/stored.h"
#include "modes/mode_properties.h"
#include "radio/radio.h"
#include "terms/edition_gap.h"
#include "track/services.h"
#include "track/withdraw.h"

namespace evc::kernel {
namespace {

position::Odometry odometry_of(const Odometry& in) {
  return {{in.nominal, in.min, in.max}, in.V_est, in.V_min, in.V_max, in.A_est};
}

/// Bounds of valid inputs: 30 years, a million kilometres, 1000 m/s. Not-a-number is never within them.
constexpr double kLongest = 1e9;
constexpr double kFastest = 1e3;
bool within(double v, double limit) { return v >= -limit && v <= limit; }

/// Readings that are older than this say nothing about a moving train.
constexpr Duration kOldestReading{1.0};
bool fresh(const Odometry& o, Duration now) {
  if (!o.measured) return true;
  const Duration age = now - *o.measured;
  return age.si >= 0.0 && (age <= kOldestReading || (o.V_est.si == 0.0 && within(age.si, kLongest)));
}

/// Whether the time and places of the cycle are valid: within bounds, in order, not earlier than before.
bool sound(const State& s, const Inputs& in) {
  const Odometry& o = in.odometry;
  for (const BaliseTelegram& t : in.balise_telegrams)
    if (!within(t.at.from_origin.si, kLongest) || (t.passed && !(*t.passed <= in.now && t.passed->si >= 0.0)))
      return false;
  return in.now >= s.now && within(in.now.si, kLongest) && within(o.min.from_origin.si, kLongest) &&
         within(o.max.from_origin.si, kLongest) && o.min <= o.nominal && o.nominal <= o.max &&
         within(o.V_min.si, kFastest) && within(o.V_max.si, kFastest) && o.V_min <= o.V_est && o.V_est <= o.V_max &&
         within(o.A_est.si, kFastest) && fresh(o, in.now);
}

/// Stores the reading of the odometer as of now.
void update_position(State& s, const Inputs& in) {
  const position::Odometry odometry = odometry_of(in.odometry);
  const Duration age = in.odometry.measured ? in.now - *in.odometry.measured : Duration{};
  const bool estimated = age.si > 0.0 && odometry.V_est.si != 0.0;
  s.now = in.now;
  position::update(s.position, estimated ? position::extrapolated(odometry, age) : odometry, in.now, estimated);
}

/// 3.15.1.3.5, 3.15.1.3.6: what the accepting RBC sent before it supervised comes into force.
void change_rbc(Reception& r) {
  State& s = r.state;
  if (!s.radio.exchange_due) return;
  radio::exchange(s.radio, s.now);
  // 3.11.5.14: what the former RBC ordered beyond the border too, where it supervised until now.
  s.track.revocable_tsr_inhibited = false;
  for (BufferedSet& set : s.buffer) set.accepting = false;
  release_buffer(r);
}

/// An event for each timer of the authority that elapsed; a standstill ends the one of the overlap too (3.8.4.4.3).
void note_timers(const track::Elapsed& elapsed, bool standstill, Log log) {
  const auto note = [&log](bool timer, Clause clause) {
    if (timer) log.note({.what = What::authority_timer_elapsed, .clause = clause});
  };
  note(elapsed.end_section_timeout, "3.8.4.1.2"_srs);
  note(elapsed.section_timeout, "3.8.4.2.2"_srs);
  note(elapsed.loa_timeout, "3.8.4.3.2"_srs);
  note(elapsed.overlap_timeout, standstill ? "3.8.4.4.3"_srs : "3.8.4.4.2"_srs);
}

/// Timers of the authority, data no longer needed, and data shortened by a reaction when the train is at standstill
/// (3.8.4, A.3.4, A.3.6).
void advance_track(Reception& r) {
  State& s = r.state;
  const track::Elapsed elapsed = track::advance(s.track, r.out.here);
  if (elapsed.any()) {
    note_timers(elapsed, r.out.here.standstill, r.log);
    const bool authority = s.track.ma && !s.track.ma->sections.empty();
    cut_beyond(s, authority ? s.track.ma->far_end() : r.out.here.max_safe_front);
  }
  if (elapsed.track_description_deleted) s.track_description_deleted = true;
  if (s.shorten_at_standstill && r.out.here.standstill) {
    s.shorten_at_standstill = false;
    if (shorten(s, track::Situation::h_linking_reaction, r.out.here.max_safe_front, r.out.here))
      r.log.note({.what = What::track_description_shortened, .clause = "A.3.4"_srs});
  }
}

/// Whether a fault that affects safety acts now. One that is memorised is reported to the RBC once, in SL and NL: also
/// one of PS, when these are entered.
bool acts(State& s, bool fault, Received& out) {
  if (s.mode == Mode::NP) s.safety_fault_memorised = s.safety_fault_reported = false;
  if (!memorises_faults(s)) return fault || s.safety_fault_memorised;
  s.safety_fault_memorised = s.safety_fault_memorised || fault;
  out.fault_to_report = s.mode != Mode::PS && s.safety_fault_memorised && !s.safety_fault_reported;
  if (!out.fault_to_report) return false;
  s.safety_fault_reported = true;
  radio::report_error(s.radio, ErrorReport::safety_critical_fault);
  return false;
}

/// 3.16.4.1, 3.16.4.2 of 4.0.0: each threshold once, in level 2, also when it was exceeded in another level.
void report_odometer(State& s) {
  position::OdometerAccuracy& a = s.odometer_accuracy;
  const bool in_level_2 = level_2_or_3(s.level.level);
  if (in_level_2 && a.impaired && !a.impairment_reported) radio::report_error(s.radio, ErrorReport::odometer_impaired);
  if (in_level_2 && a.beyond_safety_threshold && !a.safety_threshold_reported)
    radio::report_error(s.radio, ErrorReport::odometer_beyond_safety);
  if (in_level_2 || !a.impaired) a.impairment_reported = a.impaired;
  if (in_level_2 || !a.beyond_safety_threshold) a.safety_threshold_reported = a.beyond_safety_threshold;
}

/// 4.5.1.4: without power nothing is received. Each telegram and message is an event all the same.
void lose_without_power(const Reception& r) {
  const std::size_t lost = r.in.balise_telegrams.size() + r.in.loop_messages.size() + r.in.radio_messages.size();
  for (std::size_t i = 0; i < lost; ++i) r.log.note({.what = What::received_without_power, .clause = "4.5.1.4"_srs});
}

/// At power-up, an event for each.
void tell_edition(State& s, Log log) {
  if (s.srs == SrsVersion::v4_0_0 && !s.edition_told)
    for (std::size_t i = 0; i < kEditionGapClauses.size(); ++i)
      log.note({.what = What::edition_incomplete, .id = static_cast<std::int32_t>(i), .clause = kEditionGapClauses[i]});
  s.edition_told = true;
}

/// What the trackside sends. The places of telegrams may be no numbers if the odometer is not `sound`.
void receive_trackside(Reception& r, bool sound) {
  if (!r.in.train.powered) return lose_without_power(r);
  if (sound) receive_balises(r);
  receive_loops(r);
  const Sessions sessions = sessions_of(r.state);
  receive_radio(r);
  delete_with_sessions(r.state, sessions);
}

}  // namespace

Received intake(State& s, Derived::Scratch& scratch, const Inputs& in, radio::Outbox& outbox, Log log,
                Forwarded* forwarded) {
  Received out;
  Reception r{s, scratch, in, outbox, log, out, {}, {}, forwarded};
  // 4.4.5: without valid odometer data or configuration nothing can be supervised. The last position is kept.
  tell_edition(s, log);
  const bool can_go_on = sound(s, in);
  if (!can_go_on) log.note({.what = What::odometry_not_sound, .clause = "4.4.5"_srs});
  // 4.4: no change leads to such a pair, as a transition waits in PT and RV (5.10). It is a fault of the machine.
  const bool coherent = modes::possible_in(s.mode, s.level.level);
  if (!coherent) log.note({.what = What::mode_not_of_level, .clause = "4.4.5"_srs});
  out.safety_fault = acts(s, !can_go_on || !coherent || s.configuration_refused || in.safety_fault, out);
  follow_cab(s, in.train, log);
  if (can_go_on) update_position(s, in);
  read_clock(s, in.utc);
  receive_consist_length(r);
  if (can_go_on && s.srs == SrsVersion::v4_0_0)
    position::accumulate(s.odometer_accuracy, {in.odometry.nominal, in.odometry.min, in.odometry.max});
  s.network.registered = in.train.radio_registered;
  s.network.changed = false;
  out.here = here(s);
  out.integrity = in.train.integrity;
  out.length_confirmed = in.train.length_confirmed;
  operate_version_of_rbc(r, s.level.level);  // beyond the border between two RBCs
  change_rbc(r);
  receive_driver(r);
  receive_external_train_data(r);
  receive_trackside(r, can_go_on);
  follow_virtual_front(s);
  out.here = here(s);
  advance_track(r);
  run_level_transition(r);
  report_odometer(s);
  advance_national_values(r);
  return out;
}

}  // namespace evc::kernel
