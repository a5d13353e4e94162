#include "kernel/report/report.h"

#include "driver/driver.h"
#include "kernel/here.h"
#include "kernel/manoeuvre.h"
#include "kernel/radio_address.h"
#include "kernel/report/asked.h"
#include "kernel/report/data.h"
#include "kernel/report/dialogue.h"
#include "kernel/report/handover.h"
#include "kernel/report/outgoing.h"
#include "kernel/report/radio.h"
#include "kernel/report/shown.h"
#include "kernel/report/texts.h"
#include "kernel/report/track_conditions.h"
#include "kernel/reset.h"
#include "track/services.h"
#include "train/brake_model.h"

namespace evc::kernel {
namespace {

/// Brakes ordered by the national system: it has access to them in SN alone (SUBSET-035 5.3.1.1); of what it still
/// orders when another mode is entered nothing is left (4.12, 3.14.1.7.7).
void ask_for_national_system(Mode mode, const NationalSystem& national_system, brakes::CauseSet& asked) {
  if (mode != Mode::SN) return;
  asked.add(brakes::Cause::national_system_service, national_system.service_brake);
  asked.add(brakes::Cause::national_system_emergency, national_system.emergency_brake);
}

/// Of a train that reports on its service brake: the signal, and the pressure (3.14.1.2).
void take_feedback(const State& s, const TrainSignals& train, brakes::Context& context) {
  if (!supervised_train(s).service_brake_feedback) return;
  context.feedback = {train.service_brake_feedback, train.brake_pressure_kpa};
  // Without special brakes: not shorter than with them.
  const train::BrakeStatus none{false, false, false, false, false};
  if (!s.brakes.active.empty())
    context.T_bs = train::build_up_times(supervised_train(s), s.national_values, none, true).T_bs;
}

/// Brake commands from all causes of this cycle (3.14.1). Returns whether a release waits for the driver.
bool command_brakes(State& s, const TrainSignals& train, const Received& received, const Decided& decided,
                    brakes::CauseSet asked, Log log, Outputs& out) {
  asked.add(brakes::Cause::trip, s.mode == Mode::TR);
  asked.add(brakes::Cause::no_power_or_failure, s.mode == Mode::NP || s.mode == Mode::SF || received.safety_fault);
  brakes::Context context;
  context.standstill = decided.here.standstill;
  context.driver_acknowledges = received.acknowledged.has(Ack::brake);
  context.srs = s.srs;
  context.new_consistent_message = received.new_radio_message;
  context.service_brake_fitted = supervised_train(s).service_brake_interface;
  context.traction_cut_off_fitted = supervised_train(s).traction_cut_off_interface;
  context.now = s.now;
  take_feedback(s, train, context);
  brakes::Command command = brakes::command(s.brakes, asked, context);
  if (command.service_brake_fails) log.note({.what = What::service_brake_failed, .clause = "3.14.1.2"_srs});
  if (s.mode == Mode::IS) command = {};  // 4.4.3: isolated from the brakes
  out.tco = command.tco;
  out.sb = command.sb;
  out.eb = command.eb;
  out.brake_reasons = command.reasons;
  return command.acknowledgement_wanted;
}

void show_limits(State& s, const Supervised& supervised, Outputs& out) {
  const sdm::Result& r = *supervised.limits;
  s.displayed.indication = r.first_indication_of;
  if (r.MRDT_changed) ++s.displayed.MRDT;
  out.monitoring = r.monitoring;
  out.status = r.status;
  out.V_P = r.V_P;
  out.V_W = r.V_W;
  out.V_SBI = r.V_SBI;
  out.V_EBI = r.V_EBI;
  out.V_MRSP = r.V_MRSP;
  out.V_target = r.V_target;
  out.d_target = r.d_target;
  out.V_release = r.V_release;
  out.V_I = r.V_I;
  out.TTI = r.TTI;
  out.LSSMA = supervised.LSSMA;
  out.MRDT_changed = r.MRDT_changed;
  out.d_indication = r.first_indication;
  out.memo_status = sdm::memo_status(r, run_of(s.position.now).V, s.mode == Mode::TR);
}

/// The symbols of the track conditions, each once.
void take_symbols(driver::ShowContext& c, const Outputs& out) {
  for (const ShownCondition& shown : out.track_conditions) {
    bool again = false;
    for (const Symbol s : c.track_conditions) again = again || s == shown.symbol;
    if (!again) (void)c.track_conditions.push_back(shown.symbol);  // further ones are in `track_conditions` only
  }
}

/// 5.8.3.7.2 of 4.0.0: selected in level 0, 1 or 2 it is not shown in level NTC.
bool override_shown(const State& s) {
  const bool hidden = s.srs == SrsVersion::v4_0_0 && s.level.level == Level::NTC && s.override_.selected_outside_NTC;
  return s.override_.active && !hidden;
}

driver::ShowContext show_context(const State& s, bool desk_open, const Decided& decided, Set<Ack> requests,
                                 bool brake_commanded, bool LSSMA) {
  const track::Here& here = decided.here;
  driver::ShowContext c;
  c.srs = s.srs;
  c.mode = s.mode;
  c.desk_open = desk_open;
  if (valid(s.data.level_status)) c.level = s.level.level;
  if (s.level_transition.pending && !s.level_transition.pending->to.same_level(s.level))
    c.announced = s.level_transition.pending->to.level;
  c.requests = requests;
  c.override_active = override_shown(s);
  c.brake_commanded = brake_commanded;
  c.radio = indicated_session(s).indication;
  c.lssma = LSSMA;
  c.slippery_rail = s.slippery_rail || track::slippery(s.track, here.est_front, supervised_train(s).L_TRAIN);
  c.reversing_possible = decided.reversing_possible;
  c.track_ahead_free_asked = s.track_ahead_free.asking;
  for (const track::LevelCrossing& lx : s.track.lx)
    if (lx.informed && here.min_safe_front < lx.to) c.lx_not_protected = true;  // 5.16.1.5
  return c;
}

/// Position, authority, symbols, requests and texts (4.7).
void show(State& s, bool desk_open, const Decided& decided, const procedures::Effects& effects, Outputs& out) {
  const track::Here& here = decided.here;
  out.now = s.now;
  out.mode = s.mode;
  out.level = s.level.level;
  out.nid_ntc = s.level.nid_ntc;
  if (s.level.level == Level::NTC) s.national_system = s.level.nid_ntc;
  out.national_system = s.national_system;
  out.language = s.language;
  if (const position::Reference* lrbg = position::lrbg(s.position)) out.lrbg = NidLrbg{lrbg->id.NID_C, lrbg->id.NID_BG};
  out.est_front = position::counter_of(s.position, here.est_front);
  out.min_safe_front = position::counter_of(s.position, here.min_safe_front);
  out.max_safe_front = position::counter_of(s.position, here.max_safe_front);
  out.v = s.position.sense > 0 ? s.position.now.V_est : Speed{} - s.position.now.V_est;
  out.M_VERSION = operated_M_VERSION(s.operated_X, s.srs);
  const track::Authority& a = s.basis.authority;
  if (const auto end = a.EOA_or_LOA()) out.EOA = position::counter_of(s.position, *end);
  if (a.SvL) out.SvL = position::counter_of(s.position, *a.SvL);
  show_track_conditions(s, desk_open, here, out);
  driver::ShowContext context =
      show_context(s, desk_open, decided, effects.requests, out.sb || out.eb, out.LSSMA.has_value());
  const bool LX01 =
      desk_open && context.lx_not_protected && driver::allowed(driver::Output::lx_not_protected, s.mode, s.srs);
  if (!LX01)
    s.displayed.level_crossing = 0;
  else if (s.displayed.level_crossing == 0)
    s.displayed.level_crossing = s.displayed.next_condition();
  take_symbols(context, out);
  out.symbols = driver::show(context).symbols;
  out.requests = effects.requests;
  out.entries = effects.entries;
  out.start_offered = effects.offers.has(Offer::start);
  out.dialogue = dialogue_of(s, desk_open, effects.requests);
}

/// What the driver may answer in the next cycle.
void remember(State& s, const procedures::Effects& effects) {
  s.requested = effects.requests;
  s.offers = effects.offers;
  s.entries = effects.entries;
}

}  // namespace

void reset(Outputs& out) {
  // All members by name: a new member that is not named here does not compile.
  auto& [now, mode, level, nid_ntc, lrbg, est_front, min_safe_front, max_safe_front, v, monitoring, status, V_P, V_W,
         V_SBI, V_EBI, V_MRSP, V_target, V_release, d_target, EOA, SvL, tco, sb, eb, brake_reasons, requests, entries,
         start_offered, texts, symbols, radio_out, radio_connect, radio_disconnect, events, V_I, TTI, LSSMA,
         MRDT_changed, d_indication, memo_status, level_valid, levels_allowed, trip_reason, geo, rv_left, M_VERSION,
         radio_register, enabled, status_texts, sessions, track_conditions, ordered_areas, ordered_platforms,
         ordered_traction, ordered_current, infill_sessions, sound_horn, remote_shunting, engine_orientation, data,
         covers, clock, forwarded, dialogue, shown, set_speed, national_system, language] = out;
  reset_all(now, mode, level, nid_ntc, lrbg, est_front, min_safe_front, max_safe_front, v, monitoring, status, V_P, V_W,
            V_SBI, V_EBI, V_MRSP, V_target, V_release, d_target, EOA, SvL, tco, sb, eb, brake_reasons, requests,
            entries, start_offered, texts, symbols, radio_out, radio_connect, radio_disconnect, events, V_I, TTI, LSSMA,
            MRDT_changed, d_indication, memo_status, level_valid, levels_allowed, trip_reason, geo, rv_left, M_VERSION,
            radio_register, enabled, status_texts, sessions, track_conditions, ordered_areas, ordered_platforms,
            ordered_traction, ordered_current, infill_sessions, sound_horn, remote_shunting, engine_orientation, data,
            covers, clock, forwarded, dialogue, shown, set_speed, national_system, language);
}

void report(State& s, const Inputs& in, const Received& received, const Decided& decided, const Supervised& supervised,
            radio::Outbox& outbox, Log log, Outputs& out) {
  if (supervised.limits) show_limits(s, supervised, out);
  const bool before_perturbation = supervised.limits && supervised.limits->MA_request;
  RadioResult radio = run_radio(s, in, received, decided, before_perturbation, outbox, log);
  compose_messages(s, in.national_system, outbox, log, out);
  if (outbox.connect) out.radio_connect = address_of(*outbox.connect);
  if (outbox.disconnect) out.radio_disconnect = address_of(*outbox.disconnect);
  out.radio_register = radio.network;
  brakes::CauseSet asked = received.asked;
  asked |= decided.asked;
  asked |= supervised.asked;
  asked |= radio.asked;
  ask_for_national_system(s.mode, in.national_system, asked);
  radio.effects.requests.add(Ack::brake, command_brakes(s, in.train, received, decided, asked, log, out));
  if (!in.train.desk_open) {  // 4.7.2: nobody is there to answer
    radio.effects.requests = {};
    radio.effects.entries = {};
  }
  radio.effects.requests = driver::answerable(radio.effects.requests, s.mode, s.srs);
  show(s, in.train.desk_open, decided, radio.effects, out);
  remember(s, radio.effects);
  Set<Inform> inform = radio.effects.inform;
  inform.add(Inform::trackside_malfunction, received.default_information);
  inform.add(Inform::trackside_not_compatible, outbox.inform_no_version);
  inform.add(Inform::national_system_not_available,
             s.level.level == Level::NTC &&
                 (s.level.nid_ntc > 63 || ((in.national_system.available >> s.level.nid_ntc) & 1u) == 0));
  inform.add(Inform::odometer_impaired, s.odometer_accuracy.impaired);
  show_texts(s, in.train.desk_open, received, decided, inform, out);
  queue_acknowledgements(s, radio.effects.requests, out);
  s.displayed.passive_shunting = in.train.passive_shunting;
  s.displayed.national_systems = in.national_system.available;
  s.displayed.ato_active = in.automatic_operation.active;
  show_enabled(s, in, decided.here, out);
  show_data(s, decided.here, out);
  show_clock(s, out);
  show_by_mode(s, in.train.desk_open, supervised, out);
}

}  // namespace evc::kernel
