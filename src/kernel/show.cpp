#include "kernel/show.h"
#include "driver/driver.h"
#include "kernel/evc.h"
#include "kernel/here.h"
#include "kernel/reset.h"
#include "track/indication.h"
#include "train/fixed_values.h"

// The record of the display (ERA_ERTMS_015560) from what a cycle has put out.
namespace evc::kernel {
namespace {

using enum DriverOutput;

/// Brakes that the acknowledgement of a level, mode or text releases (3.14.1): it is not asked for a second time.
constexpr Set<Cause> kMissingAcknowledgement{
    Cause::text_service,      Cause::text_emergency,           Cause::OS_unacknowledged,     Cause::LS_unacknowledged,
    Cause::SH_unacknowledged, Cause::level_NTC_unacknowledged, Cause::level_0_unacknowledged};

void clear(Planning& planning) {
  planning.speeds.clear();
  planning.gradients.clear();
  planning.conditions.clear();
  planning.EOA = planning.LOA = std::nullopt;
  planning.V_LOA = {};
}

/// All but the configuration.
void clear_display(Display& display) {
  // All members by name: a new member that is not named here does not compile.
  auto& [config, now, second_of_day, mode, level, level_valid, nid_ntc, standstill, language, v, monitoring, status,
         V_P, V_SBI, V_target, V_release, target_information, MRDT, d_target, TTI, LSSMA, set_speed, slippery_rail, sm,
         override_active, reversing_permitted, bmm_inhibited, brake, brake_for_missing_ack, announced_level, radio, geo,
         conditions, tunnel, track_ahead_free, planning, orders, indication_marker, indication_target, texts, acks,
         data, buttons, enabled, step, start_of_mission, waiting, ato] = display;
  static_cast<void>(config);
  clear(planning);
  reset_all(now, second_of_day, mode, level, level_valid, nid_ntc, standstill, language, v, monitoring, status, V_P,
            V_SBI, V_target, V_release, target_information, MRDT, d_target, TTI, LSSMA, set_speed, slippery_rail, sm,
            override_active, reversing_permitted, bmm_inhibited, brake, brake_for_missing_ack, announced_level, radio,
            geo, conditions, tunnel, track_ahead_free, orders, indication_marker, indication_target, texts, acks, data,
            buttons, enabled, step, start_of_mission, waiting, ato);
}

port::Dial dial_of(Speed highest) {
  const double kmh = highest.si * 3.6;
  if (kmh < 160.0) return port::Dial::to_140;
  if (kmh < 215.0) return port::Dial::to_180;
  return kmh < 325.0 ? port::Dial::to_250 : port::Dial::to_400;
}

class Shower {
 public:
  Shower(const State& state, const Derived& derived, const Outputs& outputs, Display& to)
      : s_(state),
        d_(derived),
        out_(outputs),
        to_(to),
        here_(here(state)),
        // The driver toggles on the display; what is given does not depend on it.
        may_(driver::shown(Set<DriverOutput>::of_bits(~std::uint64_t{0}), state.mode, state.srs, state.desk_was_open,
                           true)) {}

  void show() {
    clear_display(to_);
    show_configuration();
    to_.now = out_.now;
    to_.mode = has(DriverOutput::mode) ? out_.mode : Mode::NP;
    to_.language = out_.language;
    if (out_.clock && has(local_time)) to_.second_of_day = second_of_day(*out_.clock, Duration{});
    if (!has(DriverOutput::mode)) return;
    to_.standstill = here_.standstill;
    show_level();
    show_speeds();
    show_symbols();
    show_conditions();
    show_planning();
    show_to_driver(s_, out_, may_, here_, to_);
  }

 private:
  bool has(DriverOutput output) const { return may_.has(output); }
  /// The value where the mode shows it.
  template <class T>
  std::optional<T> of(DriverOutput output, const std::optional<T>& value) const {
    return has(output) ? value : std::nullopt;
  }

  void show_configuration() {
    port::DisplayConfig& config = to_.config;
    config.srs = s_.srs;
    config.dial = dial_of(s_.dial);
    config.ntc_names = s_.displayed.ntc_names;
    config.gsmr_fitted = true;
    config.frmcs_fitted = false;
    config.asks_brake_percentage = s_.train.brake_model == train::BrakeModel::lambda;
    config.T_dispTTI = train::FixedValues{}.T_dispTTI;
  }

  void show_level() {
    to_.level_valid = out_.level_valid && has(DriverOutput::level);
    to_.level = out_.level;
    to_.nid_ntc = out_.nid_ntc;
    const bool asked = out_.requests.has(Ack::level);
    const auto& pending = s_.level_transition.pending;
    if (!asked && !has(level_announcement)) return;
    if (pending && modes::announced_to_driver(*pending, s_.level))
      to_.announced_level = port::AnnouncedLevel{pending->to.level, pending->to.nid_ntc};
    else if (asked)  // after the transition
      to_.announced_level = port::AnnouncedLevel{out_.level, out_.nid_ntc};
  }

  void show_speeds() {
    // The amount: backwards the speed of the outputs is below 0 (015560 8.2.1.2 knows none).
    if (has(train_speed)) to_.v = out_.v < Speed{} ? Speed{} - out_.v : out_.v;
    if (has(monitoring_status)) {
      to_.monitoring = out_.monitoring;
      to_.status = out_.status;
    }
    to_.V_P = of(permitted_speed, out_.V_P);
    if (out_.shown.has(sbi_speed)) to_.V_SBI = out_.V_SBI;
    to_.V_target = of(target_speed, out_.V_target);
    to_.V_release = of(release_speed, out_.V_release);
    to_.target_information = to_.monitoring == Monitoring::CSM && to_.V_target.has_value();
    to_.MRDT = s_.displayed.MRDT;
    to_.d_target = of(target_distance, out_.mode == Mode::RV ? out_.rv_left : out_.d_target);
    to_.TTI = of(time_to_indication, out_.TTI);
    to_.LSSMA = of(lssma, out_.LSSMA);
    to_.set_speed = out_.set_speed;
  }

  void show_symbols() {
    to_.slippery_rail = out_.shown.has(DriverOutput::slippery_rail);
    if (has(authorised_direction))  // 4.4.21.1.9
      to_.sm = s_.manoeuvre.opposite ? port::SmDirection::backward : port::SmDirection::forward;
    to_.override_active = out_.shown.has(override_status);
    to_.reversing_permitted = out_.shown.has(reversing_allowed);
    to_.bmm_inhibited = out_.shown.has(bmm_inhibition);
    to_.brake = out_.shown.has(brake_indication);
    Set<Cause> others = out_.brake_reasons;
    others.remove(kMissingAcknowledgement);
    to_.brake_for_missing_ack = to_.brake && others.empty();
    to_.ato.on = s_.srs == SrsVersion::v4_0_0 && s_.displayed.ato_active;
    to_.track_ahead_free = out_.shown.has(taf_request);
    to_.geo = of(geo_position, out_.geo);
    for (const Symbol symbol : out_.symbols) {
      if (symbol == Symbol::ST03) to_.radio = RadioIndication::up;
      if (symbol == Symbol::ST04) to_.radio = RadioIndication::failed;
    }
  }

  /// In the order of appearance, which is that of the numbers.
  void show_condition(std::uint16_t id, Symbol symbol, ConditionPhase phase) {
    std::size_t i = to_.conditions.size();
    while (i > 0 && appeared_before(id, to_.conditions[i - 1].id)) --i;
    (void)to_.conditions.insert(i, {id, picture_of(symbol), phase});  // as many as are stored
  }
  /// The counter may have overflowed.
  static bool appeared_before(std::uint16_t a, std::uint16_t b) {
    return static_cast<std::uint16_t>(b - a) < 0x8000 && a != b;
  }

  void show_conditions() {
    for (const track::TrackCondition& c : s_.track.conditions) {
      const auto symbol = driver::symbol(c.kind, c.progress.phase, s_.by_train);
      if (c.progress.shown_as == 0 || !symbol) continue;
      if (c.kind == TrackConditionKind::tunnel_stopping_area)
        to_.tunnel = {c.progress.phase == ConditionPhase::active, c.from - here_.est_front};
      else
        show_condition(c.progress.shown_as, *symbol, c.progress.phase);
    }
    if (const auto& t = s_.track.traction; t && t->progress.shown_as != 0)
      if (const auto symbol = driver::symbol_of_traction(t->M_VOLTAGE, t->progress.phase, s_.by_train))
        show_condition(t->progress.shown_as, *symbol, t->progress.phase);
    if (s_.displayed.level_crossing != 0)
      show_condition(s_.displayed.level_crossing, Symbol::LX01, ConditionPhase::active);
  }

  void show_planning() {
    to_.indication_marker = of(first_indication_location, out_.d_indication);
    if (to_.indication_marker && s_.displayed.indication) to_.indication_target = distance_to(*s_.displayed.indication);
    if (!has(eoa_loa) || to_.track_ahead_free || !plan(s_, d_, to_.planning)) return;
    if (!has(gradient)) to_.planning.gradients.clear();
    if (!has(mrsp)) to_.planning.speeds.clear();
    for (const PlannedCondition& c : to_.planning.conditions) show_order(c);
  }
  /// An order stands where its symbol will appear in B3 to B5 (015560 8.3.4.22), in rear of the condition by the way to
  /// it at this speed; what has appeared is no order any more, and an announcement is not taken back when the train
  /// gets slower.
  void show_order(const PlannedCondition& c) {
    const Duration lead = !c.kind ? track::lead_of_traction() : c.end ? Duration{} : track::lead_of(*c.kind);
    const Speed V = out_.v > Speed{} ? out_.v : Speed{};
    const Distance appears = c.at - V * lead;
    const bool has_appeared = !c.end && c.phase != ConditionPhase::ahead;
    if (has_appeared || !(appears > Distance{})) return;
    std::size_t i = to_.orders.size();
    while (i > 0 && appears < to_.orders[i - 1].at) --i;
    (void)to_.orders.insert(i, {picture_of(c.symbol), appears});  // as many
  }
  /// As the advance display has it: to an EOA from the estimated front end.
  Distance distance_to(const sdm::TargetId& target) const {
    const bool EOA = target.kind == sdm::TargetKind::EOA_SvL || target.kind == sdm::TargetKind::SR_end;
    return target.d_target - (EOA ? here_.est_front : here_.max_safe_front);
  }

  const State& s_;
  const Derived& d_;
  const Outputs& out_;
  Display& to_;
  track::Here here_;
  Set<DriverOutput> may_;
};

}  // namespace

void show(const State& state, const Derived& derived, const Outputs& outputs, Display& display) noexcept {
  Shower(state, derived, outputs, display).show();
}

}  // namespace evc::kernel
