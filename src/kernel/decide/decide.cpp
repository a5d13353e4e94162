#include "kernel/decide/decide.h"

#include "kernel/basis.h"
#include "kernel/decide/enter.h"
#include "kernel/decide/mission.h"
#include "kernel/examine.h"
#include "kernel/here.h"
#include "kernel/stored.h"
#include "modes/next_mode.h"
#include "procedures/staff_responsible.h"
#include "protection/authority.h"
#include "track/store.h"

namespace evc::kernel {
namespace {

/// Automatic driving (4.4.16) and supervised manoeuvre (4.4.21).
void add_facts_of_4_0_0(const State& s, const Inputs& in, const Received& r, procedures::Facts& f) {
  f.level_crossing_approach_shown = s.level_crossing_shown;
  f.brake_commanded = brakes::brakes_now(s.brakes);
  f.AD_requested = in.automatic_operation.requests_AD;
  f.described_for_whole_train = f.ma_ssp_gradient_stored && track::described_under_train(s.track, r.here);
  f.selects_ATO_engage = r.selected.has(Select::ato_engage);
  f.ATO_disengaged = r.selected.has(Select::ato_disengage) || !in.automatic_operation.active;
  f.odometer_beyond_threshold = s.odometer_accuracy.beyond_safety_threshold;
  f.selects_exit_SM = r.selected.has(Select::exit_sm);
  f.consist_in_front = r.consist_in_front;
}

/// Facts of 4.6.3 from the inputs, the train interface, the position and the track description.
procedures::Facts facts_of(const State& s, const Inputs& in, const Received& r) {
  procedures::Facts f;
  f.isolated = in.train.isolated || r.selected.has(Select::isolate);
  f.powered = in.train.powered;
  f.desk_open = in.train.desk_open;
  f.standstill = r.here.standstill;
  f.sleeping = in.train.sleeping;
  f.non_leading = in.train.non_leading;
  f.passive_shunting = in.train.passive_shunting;
  f.safety_fault = r.safety_fault;
  f.level = s.level.level;
  f.level_switched_to = r.level_switched_to;
  f.level_order_changed_national_system_only = r.national_system_only;
  f.acknowledged = r.acknowledged;
  f.requested = s.requested;
  f.selects_exit_SH = r.selected.has(Select::exit_shunting);
  f.selects_NL = r.selected.has(Select::non_leading);
  f.train_data_valid = valid(s.data.train_data_status);
  // The authority of a supervised manoeuvre is another information: it leads to SM alone (4.6.3 [10], [81]; 4.10).
  f.ma_accepted = s.track.ma.has_value() && !s.manoeuvre.authority;
  f.ma_ssp_gradient_stored = f.ma_accepted && track::complete(s.track, r.here);
  f.ma_with_trip_order = s.ma_with_trip_order;
  f.mode_is_OS = s.mode == Mode::OS;
  f.mode_is_LS = s.mode == Mode::LS;
  f.group_at_eoa_in_RSM = r.group_at_EOA_in_RSM;
  f.linking_reaction_trip = r.linking_reaction_trip;
  f.linked_group_wrong_direction = r.linked_group_wrong_direction;
  f.telegram_version_too_high = r.telegram_version_too_high;
  f.trip_order = r.trip_order;
  f.stop_if_in_SH = r.stop_if_in_SH;
  f.stop_if_in_SR = r.stop_if_in_SR;
  f.group_passed_not_in_SH_list = r.group_passed_not_in_SH_list;
  f.group_passed_not_in_SR_list = r.group_passed_not_in_SR_list;
  f.group_passed_in_SR_list = r.group_passed_in_SR_list && s.operated_X != 1;  // 6.6.2.2.2: not with X = 1
  f.ues_accepted = r.ues_accepted;
  f.ues_received = r.ues_received || s.emergency_stops.unconditional_pending();
  f.T_NVCONTACT_trip = s.contact_trip;
  f.stop_shunting_stored = s.track.stop_shunting_on_desk_opening;
  f.national_trip = in.national_system.trip_active;
  if (s.srs == SrsVersion::v4_0_0) add_facts_of_4_0_0(s, in, r, f);
  f.SR_distance_passed =
      s.mode == Mode::SR && procedures::staff_responsible::distance_passed(s.staff_responsible.end, r.here.est_front);
  return f;
}

/// [12], [16], [69]: with the authority in force after all inputs of this cycle.
void observe_authority(const State& s, const track::Here& here, procedures::Facts& f) {
  const track::Authority& a = s.basis.authority;
  f.min_safe_antenna_beyond_eoa = protection::passes_end_level_1(a, here);
  f.min_safe_front_beyond_eoa = protection::passes_end_level_2(a, here);
  f.front_in_rear_of_track_description = track::before_track_description(s.track, here);
}

/// 4.6.3: an acknowledgement answers what is displayed. What trackside has made groundless in this cycle, a mode area
/// that it took back or an offer that ended with its session, is not displayed any more. An area that the train enters
/// now was displayed, and so was one ahead that was asked for in the cycle in which the mode changed (5.9.3.4); in SB
/// and PT the driver is asked for that at the train alone, and for no answer of an RBC whose session has ended (5.4.3.2
/// S24, S25, 5.11.2.2 S160, S170).
void withdraw_requests(const State& s, Set<Ack> asked, procedures::Facts& f) {
  const bool at_train_alone = s.mode == Mode::SB || s.mode == Mode::PT;
  const bool mode_changed = s.mode != s.previous_mode;
  const bool without_answer =
      s.mode == Mode::PT && level_2_or_3(s.level.level) && !s.radio.supervising.session.established();
  const auto ahead = [&](Mode mode) {
    for (const track::ModeArea& area : s.track.mode_profile)
      if (area.mode == mode) return true;
    return false;
  };
  const auto keep = [&](Ack ack, Mode mode, bool at_train) {
    const bool displayed = !at_train_alone && (asked.has(ack) || (mode_changed && ahead(mode)));
    const bool offered = s.mode == Mode::SB ? asked.has(ack) : !without_answer;
    if (!(at_train && offered) && !displayed) f.requested.remove(ack);
  };
  keep(Ack::OS, Mode::OS, f.profile_demands_OS);
  keep(Ack::LS, Mode::LS, f.profile_demands_LS);
  keep(Ack::SH, Mode::SH, f.profile_demands_SH);
  if (f.standstill && !asked.has(Ack::RV)) f.requested.remove(Ack::RV);  // [59] itself asks for standstill
  if (without_answer || (s.mode == Mode::SB && !asked.has(Ack::SR))) f.requested.remove(Ack::SR);
}

void change_mode(State& s, const Inputs& in, const procedures::Facts& facts, Decided& out, Log log) {
  s.previous_mode = s.mode;
  const auto transition = modes::next_mode(s.mode, procedures::observe(facts, s.srs), s.srs);
  if (!transition) return;
  enter_mode(s, transition->to, transition->number, out.here, log);
  if (s.previous_mode == Mode::NP) revalidate_after_power_off(s, in.moved);
  out.mode_changed = true;
  out.basis_renewed = renew_basis(s, in.train, out.here) || out.basis_renewed;
}

constexpr std::uint16_t kEndOfNL = kFirstStatusId + terms::index(StatusText::NL_no_longer_permitted);

/// Id of the text that the driver acknowledges: the one named, or the oldest that waits; 0: none.
std::uint16_t acknowledged_text(const State& s, std::uint16_t named, Log log) {
  for (const std::uint8_t waiting : s.texts_to_acknowledge)
    if (named == 0 || waiting == named) return waiting;
  if (s.status_texts.shown.has(StatusText::NL_no_longer_permitted) && (named == 0 || named == kEndOfNL))
    return kEndOfNL;
  if (named != 0)
    log.note(
        {.what = What::acknowledgement_not_enabled, .id = static_cast<std::int32_t>(Ack::text), .clause = "4.7.2"_srs});
  return 0;
}

/// The engine may not be non leading any more: the driver is informed and acknowledges that (4.4.15.1.1.3 of 4.0.0).
void end_non_leading(State& s, bool permitted, std::uint16_t acknowledged, Decided& out) {
  const bool in_NL = s.srs == SrsVersion::v4_0_0 && s.mode == Mode::NL;
  const bool ends = in_NL && s.NL_was_permitted && !permitted;
  s.NL_was_permitted = permitted;
  out.status_acknowledged = acknowledged == kEndOfNL;
  const bool waits = s.status_texts.shown.has(StatusText::NL_no_longer_permitted) && !out.status_acknowledged;
  out.effects.inform.add(Inform::NL_no_longer_permitted, ends);
  out.effects.requests.add(Ack::text, ends || (in_NL && waits));
}

/// Texts of packets 72 and 76 (3.12.3), and the one of the unit that is acknowledged.
void run_texts(State& s, const Inputs& in, bool acknowledges, Decided& out, Log log) {
  const std::uint16_t acknowledged = acknowledges ? acknowledged_text(s, in.driver.acknowledged_text, log) : 0;
  end_non_leading(s, in.train.non_leading, acknowledged, out);
  const std::uint8_t of_trackside = acknowledged < kFirstStatusId ? static_cast<std::uint8_t>(acknowledged) : 0;
  const track::TextAcknowledgement acknowledgement{of_trackside, s.operated_X == 1};
  out.texts = track::show_texts(s.track, out.here, s.mode, s.level.level, s.level.nid_ntc, acknowledgement,
                                out.texts_to_report);
  s.texts_to_acknowledge = out.texts.to_acknowledge;
  out.effects.requests.add(Ack::text, !out.texts.to_acknowledge.empty());
  out.asked.add(brakes::Cause::text_service, out.texts.service_brake);
  out.asked.add(brakes::Cause::text_emergency, out.texts.emergency_brake);
}

}  // namespace

namespace {

/// 5.22: the driver inhibits the reaction to the alarm of the balise antenna, or revokes it.
void inhibit_antenna_alarm(State& s, Set<Select> selected) {
  if (selected.has(Select::bmm_inhibit)) s.antenna_alarm.inhibited = s.position.now.counter;
  if (selected.has(Select::bmm_revoke)) s.antenna_alarm.inhibited.reset();
}

}  // namespace

Decided decide(State& s, const Inputs& in, const Received& received, Log log, Examined* seen) {
  Decided out;
  out.here = received.here;
  out.effects = received.level;
  procedures::Facts facts = facts_of(s, in, received);
  std::optional<Mode> profile_at_front = run_mode_profile(s, received, facts, out);
  if (!facts.ma_ssp_gradient_stored) profile_at_front.reset();
  run_start_of_mission(s, in.train.desk_open, received, profile_at_front, out);
  out.basis_renewed = renew_basis(s, in.train, out.here);
  run_override(s, received, out.here, facts, log);
  run_shunting(s, received, out.here, facts, out.effects);
  run_manoeuvre(s, in.train.desk_open, received, facts, out.effects);
  run_reversing(s, in.train.direction_controller, out);
  withdraw_requests(s, out.effects.requests, facts);
  observe_authority(s, out.here, facts);
  inhibit_antenna_alarm(s, received.selected);
  if (seen != nullptr) {
    seen->facts = facts;
    seen->deciding = s;
  }
  change_mode(s, in, facts, out, log);
  if (out.mode_changed) out.effects.requests.remove(received.acknowledged);  // they asked for what has happened
  run_train_trip(s, in.train.desk_open, received, profile_at_front, out);
  run_start_in_SR(s, received, out);
  run_train_data_change(s, received, out, log);
  run_end_of_mission(s, in.train.desk_open, received, out);
  finish_manoeuvre(s, received, out, log);
  run_texts(s, in, received.acknowledged.has(Ack::text), out, log);
  out.track_ahead_free_granted =
      protection::ask(s.track_ahead_free, out.here.est_front, received.selected.has(Select::track_ahead_free));
  return out;
}

}  // namespace evc::kernel
