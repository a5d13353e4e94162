#include "kernel/supervise.h"

#include "modes/active_functions.h"
#include "modes/mode_properties.h"
#include "sdm/locations.h"
#include "track/services.h"

namespace evc::kernel {
namespace {

/// NC_CDTRAIN (7.5.1.82.1): the cant deficiencies in mm by code.
constexpr std::array<std::uint16_t, 11> kCantDeficiency{80, 100, 130, 150, 165, 180, 210, 225, 245, 275, 300};

/// The speed limit of the mode (3.11.7); absent: the mode has none.
std::optional<Speed> mode_speed(const State& s, const track::Here& here) {
  const train::NationalValues& nv = s.national_values;
  const auto of_area = [&](Mode mode, Speed national) {
    const auto area = track::area_due(s.track, here);
    return area && area->mode == mode && area->V_MAMODE != track::kNoSpeed ? track::speed_of(area->V_MAMODE) : national;
  };
  switch (modes::properties(s.mode).speed_limit) {
    case modes::SpeedLimit::V_NVSHUNT:
      return of_area(Mode::SH, nv.V_NVSHUNT);
    case modes::SpeedLimit::V_NVSTFF:
      return s.staff_responsible.V ? *s.staff_responsible.V : nv.V_NVSTFF;
    case modes::SpeedLimit::V_NVONSIGHT:
      return of_area(Mode::OS, nv.V_NVONSIGHT);
    case modes::SpeedLimit::V_NVLIMSUPERV:
      return of_area(Mode::LS, nv.V_NVLIMSUPERV);
    case modes::SpeedLimit::V_NVUNFIT:
      return nv.V_NVUNFIT;
    case modes::SpeedLimit::V_REVERSE:
      return s.track.reversing_supervision ? track::speed_of(s.track.reversing_supervision->V_REVERSE) : Speed{};
    case modes::SpeedLimit::no_limit:
    case modes::SpeedLimit::standstill:
    case modes::SpeedLimit::profile_only:
    case modes::SpeedLimit::national:
      return std::nullopt;
  }
  return std::nullopt;
}

bool within(const State& s, modes::Supervision kind) { return modes::properties(s.mode).supervision == kind; }

sdm::Authority authority_of(const SupervisionBasis& basis) {
  const track::Authority& a = basis.authority;
  sdm::Authority out;
  // A temporary EOA (area of a mode profile, unsuitable route, level crossing) up to the LOA takes its place
  // (3.13.1.5).
  if (a.LOA && (!a.EOA || *a.EOA > *a.LOA)) {
    out.kind = sdm::Authority::Kind::LOA;
    out.EOA = *a.LOA;
    out.V_LOA = a.V_LOA;
    return out;
  }
  if (!a.EOA) return out;
  out.kind = sdm::Authority::Kind::EOA_SvL;
  out.EOA = *a.EOA;
  out.SvL = a.SvL ? *a.SvL : *a.EOA;
  using Kind = track::Release::Kind;
  out.release_speed = a.release.kind == Kind::given      ? sdm::ReleaseSpeedChoice::value
                      : a.release.kind == Kind::national ? sdm::ReleaseSpeedChoice::national
                      : a.release.kind == Kind::on_board ? sdm::ReleaseSpeedChoice::on_board
                                                         : sdm::ReleaseSpeedChoice::none;
  out.V_release = a.release.V;
  out.level_1_at_EOA = basis.key.level_1_at_EOA;
  if (basis.reference) {
    out.Q_LOCACC_reference = basis.Q_LOCACC;
    out.reference = *basis.reference;
  }
  out.confidence_interval = basis.confidence_interval;
  out.V_ura = basis.V_ura;
  return out;
}

void earliest(std::optional<Place>& at, Place from) {
  if (!at || from < *at) at = from;
}

sdm::TrackConditions conditions_of(const State& s, Place min_safe_rear) {
  sdm::TrackConditions c;
  for (const track::AdhesionArea& area : s.track.adhesion)
    if (area.slippery && !c.reduced_adhesion.push_back({area.from, area.to})) c.slippery_rail = true;
  c.slippery_rail = c.slippery_rail || s.slippery_rail;
  for (const track::TrackCondition& t : s.track.conditions) {
    if (t.to < min_safe_rear) continue;  // passed by the whole train
    using enum TrackConditionKind;
    if (t.kind == switch_off_regenerative_brake) earliest(c.regenerative_off, t.from);
    if (t.kind == switch_off_eddy_current_emergency_brake) earliest(c.eddy_current_emergency_off, t.from);
    if (t.kind == switch_off_eddy_current_service_brake) earliest(c.eddy_current_service_off, t.from);
    if (t.kind == switch_off_magnetic_shoe_brake) earliest(c.magnetic_shoe_off, t.from);
    if (t.kind == powerless_lower_pantograph || t.kind == powerless_main_switch_off) earliest(c.powerless, t.from);
  }
  return c;
}

/// Steps of the MRSP that a TSR holds down: their targets use the default gradient (3.13.4.1.3).
void mark_TSR_steps(const State& s, sdm::Inputs& in) {
  in.mrsp_due_to_TSR = {};
  for (std::size_t i = 0; i < in.mrsp.steps.size(); ++i)
    for (const track::TemporarySpeedRestriction& t : s.track.tsr) {
      const Place end = t.Q_FRONT ? t.to : t.to + s.train.L_TRAIN;
      const Place at = in.mrsp.steps[i].from;
      if (t.from <= at && at < end && track::speed_of(t.V_TSR) == in.mrsp.steps[i].value) in.mrsp_due_to_TSR[i] = true;
    }
}

/// The gradient from the train's rear on, and where it is known (3.13.4.1.2). A hole between known parts counts as
/// level.
sdm::GradientProfile gradient_of(const track::Description& d, Place from) {
  sdm::GradientProfile g;
  const auto& steps = d.gradient.steps;
  std::size_t first = 0;
  while (first < steps.size() && !steps[first].value.known()) ++first;
  std::size_t end = steps.size();
  while (end > first && !steps[end - 1].value.known()) --end;
  if (first < end) {
    g.permille = track::gradient(d, from);
    if (steps[first].from > from) g.known_from = steps[first].from;
    if (end < steps.size()) g.known_to = steps[end].from;
  }
  if (d.default_gradient) g.default_for_TSR = static_cast<double>(*d.default_gradient);
  return g;
}

/// What the MRSP is made of in the mode in force (4.5.2).
track::MrspElements elements_in(Mode mode) {
  using modes::Function;
  return {.ssp = modes::active(Function::mrsp_ssp, mode),
          .asp = modes::active(Function::mrsp_asp, mode),
          .tsr = modes::active(Function::mrsp_tsr, mode),
          .pbd = modes::active(Function::mrsp_pbd, mode),
          .lx = modes::active(Function::mrsp_lx, mode),
          .signalling = modes::active(Function::mrsp_signalling, mode)};
}

void add_limit(track::MrspQuery& query, Speed v) {
  // Three limits at the most: there is room for eight.
  (void)query.limits.push_back({std::nullopt, std::nullopt, v});
}

/// Speeds of the permitted braking distances (3.11.11): with the brakes of now.
void compute_PBD(const track::Description& d, Derived::Curves& curves) {
  curves.pbd_speeds.clear();
  for (const track::PermittedBrakingDistance& p : d.pbd) {
    const Speed v = sdm::permitted_braking_distance_speed(curves.inputs, p.D_PBD,
                                                          static_cast<double>(p.gradient_permille), !p.service_brake);
    // Steps of 5 km/h; sdm has rounded down. As many as are stored.
    (void)curves.pbd_speeds.push_back(static_cast<track::SpeedCode>(v.si * 3.6 / 5.0 + 0.5));
  }
}

train::BrakeStatus brake_status(const TrainSignals& t) {
  train::BrakeStatus b;
  b.regenerative = t.regenerative_brake_active;
  b.eddy_current = t.eddy_current_brake_active;
  b.magnetic_shoe = t.magnetic_shoe_brake_active;
  b.electro_pneumatic = t.ep_brake_active;
  b.adhesion_independent = t.additional_brake_active;
  return b;
}

/// The same as bits.
std::uint8_t brake_bits(const TrainSignals& t) {
  return static_cast<std::uint8_t>((t.regenerative_brake_active ? 1 : 0) | (t.eddy_current_brake_active ? 2 : 0) |
                                   (t.magnetic_shoe_brake_active ? 4 : 0) | (t.ep_brake_active ? 8 : 0) |
                                   (t.additional_brake_active ? 16 : 0));
}

/// Curves and limits, from the stored data and `basis`; of the train interface only the special brakes are asked for.
void build(Derived::Curves& curves, const State& s, const TrainSignals& train, const SupervisionBasis& basis) {
  sdm::Inputs& in = curves.inputs;
  in.revision = basis.number;
  in.srs = s.srs;
  in.train = s.train;
  in.national_values = s.national_values;
  in.brakes = brake_status(train);
  in.conditions = conditions_of(s, basis.min_safe_rear);
  compute_PBD(s.track, curves);  // with the rail as it is now (3.11.11.4)
  track::MrspQuery query;
  query.from = basis.min_safe_rear;
  query.train_length = s.train.L_TRAIN;
  query.category = category_of(s.train);
  query.elements = elements_in(s.mode);
  query.pbd_speeds = {curves.pbd_speeds.begin(), curves.pbd_speeds.size()};
  const auto counts = [&](modes::Function f) { return modes::active(f, s.mode); };
  if (counts(modes::Function::mrsp_train)) add_limit(query, s.train.V_MAXTRAIN);
  if (counts(modes::Function::mrsp_mode) && basis.key.mode_limit) add_limit(query, *basis.key.mode_limit);
  if (counts(modes::Function::mrsp_override) && s.override_.active) add_limit(query, s.national_values.V_NVSUPOVTRP);
  in.mrsp = track::mrsp(s.track, query);
  mark_TSR_steps(s, in);
  in.supervise_targets = !within(s, modes::Supervision::ceiling);
  in.authority = within(s, modes::Supervision::full) ? authority_of(basis) : sdm::Authority{};
  in.SR_end = within(s, modes::Supervision::mrsp_and_sr_distance) ? s.staff_responsible.end : std::nullopt;
  in.gradient = gradient_of(s.track, basis.min_safe_rear);
  curves.sdm.valid = false;
  (void)sdm::rebuild(curves.sdm, in);
}

/// The basis of curves that are built now.
SupervisionBasis basis_of(const Cycle& cycle, const SupervisionBasis::Key& key, const track::Authority& authority) {
  const State& s = cycle.state;
  SupervisionBasis basis;
  basis.key = key;
  basis.number = s.basis.number + 1;
  if (basis.number == 0) basis.number = 1;
  basis.min_safe_rear = cycle.here.min_safe_rear;
  basis.confidence_interval = cycle.here.max_safe_front - cycle.here.min_safe_front;
  basis.V_ura = run_of(s.position.now).V_ura;
  if (const position::Reference* lrbg = position::lrbg(s.position)) {
    basis.reference = lrbg->place;
    basis.Q_LOCACC = lrbg->Q_LOCACC;
  }
  basis.authority = authority;
  return basis;
}

sdm::Motion motion_of(const Cycle& cycle) {
  const position::Odometry& now = cycle.state.position.now;
  sdm::Motion m;
  m.est_front = cycle.here.est_front;
  m.min_safe_front = cycle.here.min_safe_front;
  m.max_safe_front = cycle.here.max_safe_front;
  const Run run = run_of(now);
  m.V_est = run.V;
  m.V_ura = run.V_ura;
  m.A_est = run.A;
  m.standstill = cycle.here.standstill;
  m.now = cycle.state.now;
  m.brake_pressure_kpa = cycle.in.train.brake_pressure_kpa;
  if (cycle.state.radio.ma_request) m.T_MAR = cycle.state.radio.ma_request->T_MAR;
  return m;
}

void show_limits(Cycle& cycle, const sdm::Result& r) {
  Outputs& out = cycle.out;
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
}

protection::Way way_of(DirectionController controller) {
  return controller == DirectionController::forward    ? protection::Way::forward
         : controller == DirectionController::backward ? protection::Way::backward
                                                       : protection::Way::none;
}

/// 5.16.2: the stop in rear of an unprotected level crossing gives way to the LX speed: with an order to stop once the
/// train stands in its stopping area, else once it has passed the place that 3.13.9.3.5.11 defines.
void pass_level_crossings(Cycle& cycle, const sdm::Motion& motion) {
  State& s = cycle.state;
  for (const track::LevelCrossing& lx : s.track.lx) {
    if (!lx.unprotected || lx.substituted || cycle.here.est_front > lx.from) continue;
    const bool over = lx.stop_required ? cycle.here.standstill && cycle.here.est_front >= lx.from - lx.L_STOPLX
                                       : sdm::lx_substitution(cycle.derived.in_force.inputs, cycle.derived.in_force.sdm,
                                                              lx.from, track::speed_of(lx.V_LX), motion)
                                             .passed;
    if (!over) continue;
    track::substitute_level_crossing(s.track, lx.NID_LX, cycle.here.est_front);
    note(cycle, {.what = What::level_crossing_speed, .id = lx.NID_LX, .clause = "5.16.2"_srs});
    return;  // the others are looked at with the curves built anew
  }
}

}  // namespace

bool supervises_speed(Mode mode) {
  return modes::properties(mode).supervision != modes::Supervision::unsupervised && mode != Mode::SN;
}

track::TrainCategory category_of(const train::TrainData& train) {
  track::TrainCategory c;
  for (std::size_t i = 0; i < kCantDeficiency.size(); ++i)
    if (kCantDeficiency[i] <= train.cant_deficiency_mm) c.NC_CDTRAIN = static_cast<std::uint8_t>(i);
  c.NC_TRAIN = train.other_categories;
  c.M_AXLELOADCAT = static_cast<std::uint8_t>(train.axle_load);
  return c;
}

track::TrainInterfaces interfaces_of(const train::TrainData& train) {
  track::TrainInterfaces i;
  i.M_LOADINGGAUGE = static_cast<std::uint8_t>(train.loading_gauge);
  i.M_AXLELOADCAT = static_cast<std::uint8_t>(train.axle_load);
  for (const train::TractionSystem& t : train.traction_systems)
    (void)i.tractions.push_back({t.M_VOLTAGE, t.NID_CTRACTION});  // both hold eight
  return i;
}

namespace {

/// Level 1 at the end of the authority: now, or by an order that is executed in rear of it (3.13.9.4.8.2).
bool level_1_at(const State& s, const std::optional<Place>& EOA) {
  const auto& pending = s.level_transition.pending;
  if (pending && EOA && pending->border <= *EOA) return pending->to.level == Level::L1;
  return s.level.level == Level::L1;
}

/// What the release speed calculated on board depends on beside the data, in steps of 5 m and 0.5 m/s: curves are not
/// built anew for every millimetre (3.13.9.4.8.2).
std::uint32_t inaccuracy(const Cycle& cycle) {
  const State& s = cycle.state;
  if (s.basis.authority.release.kind != track::Release::Kind::on_board) return 0;
  const double interval = (cycle.here.max_safe_front - cycle.here.min_safe_front).si / 5.0;
  const double speed = run_of(s.position.now).V_ura.si / 0.5;
  const auto steps = [](double v) { return v < 30000.0 ? static_cast<std::uint32_t>(v) : 30000u; };
  return steps(interval) << 16 | steps(speed);
}

}  // namespace

void refresh(Cycle& cycle) {
  State& s = cycle.state;
  Derived& d = cycle.derived;
  const SupervisionBasis::Key key{.mode = s.mode,
                                  .track = s.track.revision,
                                  .revision = s.revision,
                                  .brakes = brake_bits(cycle.in.train),
                                  .level_1_at_EOA = level_1_at(s, s.basis.authority.EOA),
                                  .inaccuracy = inaccuracy(cycle),
                                  .mode_limit = mode_speed(s, cycle.here)};
  const bool changed = s.basis.number == 0 || s.basis.key != key;
  if (changed)
    s.basis = basis_of(cycle, key,
                       within(s, modes::Supervision::full) ? track::authority(s.track, interfaces_of(s.train), s.mode)
                                                           : track::Authority{});
  if (d.built == s.basis.number || !supervises_speed(s.mode)) return;
  d.built = s.basis.number;
  build(d.in_force, s, cycle.in.train, s.basis);
  if (!changed) return;  // logged when it was built first
  if (d.in_force.sdm.truncated) note(cycle, {.what = What::targets_lost});
  if (d.in_force.sdm.no_deceleration) note(cycle, {.what = What::no_deceleration, .clause = "3.13.6.2"_srs});
}

void supervise_speed(Cycle& cycle) {
  State& s = cycle.state;
  if (!supervises_speed(s.mode)) {
    s.supervision = {};
    return;
  }
  const sdm::Motion motion = motion_of(cycle);
  pass_level_crossings(cycle, motion);
  const sdm::Result r = sdm::supervise(s.supervision, cycle.derived.in_force.sdm, motion);
  show_limits(cycle, r);
  cycle.asked.add(brakes::Cause::overspeed_traction, r.tco);
  cycle.asked.add(brakes::Cause::overspeed_service, r.sb);
  cycle.asked.add(brakes::Cause::overspeed_emergency, r.eb);
  cycle.MA_request_before_perturbation = r.MA_request;
}

void guard_movement(Cycle& cycle) {
  State& s = cycle.state;
  protection::Movement m;
  m.nominal = s.position.now.counter.nominal;
  m.standstill = cycle.here.standstill;
  m.controller = way_of(cycle.in.train.direction_controller);
  m.permitted = s.mode == Mode::PT || s.mode == Mode::RV ? protection::Way::backward : protection::Way::forward;
  m.D_NVROLL = s.national_values.D_NVROLL;
  m.D_NVPOTRP = s.national_values.D_NVPOTRP;
  if (s.mode == Mode::RV && s.track.reversing_reference && s.track.reversing_supervision &&
      s.track.reversing_supervision->D_REVERSE)
    m.reversing_left =
        cycle.here.est_front - (*s.track.reversing_reference - *s.track.reversing_supervision->D_REVERSE);
  m.acknowledged = cycle.facts.acknowledged.has(Ack::brake);
  const protection::Commands c = protection::guard(s.guards, protection::guards_of(s.mode), m);
  cycle.asked.add(brakes::Cause::roll_away, c.roll_away);
  cycle.asked.add(brakes::Cause::reverse_movement, c.reverse_movement);
  cycle.asked.add(brakes::Cause::standstill, c.standstill);
  cycle.asked.add(brakes::Cause::post_trip_distance, c.post_trip);
  cycle.asked.add(brakes::Cause::reversing_distance, c.reversing);
}

bool can_stop_before(const Cycle& cycle, Derived& derived, const track::Contents& proposal) {
  const State& s = cycle.state;
  if (!within(s, modes::Supervision::full) || !proposal.ma) return false;
  const track::MovementAuthority& proposed = *proposal.ma;
  track::Authority a;
  if (proposed.limited()) {
    a.LOA = proposed.end();
    a.V_LOA = proposed.V_LOA;
  } else {
    a.EOA = proposed.end();
    a.SvL = proposed.SvL();
  }
  // The start of an area of its mode profile would be an end as well (3.12.4), on the safe side with the SvL there.
  if (proposal.mode_profile)
    for (const track::ModeArea& area : *proposal.mode_profile) {
      if (a.EOA && area.from >= *a.EOA) continue;
      a.EOA = area.from;
      a.SvL = area.from;
    }
  build(derived.proposed, s, cycle.in.train, basis_of(cycle, s.basis.key, a));
  sdm::Supervision fresh;
  const sdm::Result r = sdm::supervise(fresh, derived.proposed.sdm, motion_of(cycle));
  return r.monitoring == Monitoring::CSM && r.status == Status::Normal;
}

}  // namespace evc::kernel
