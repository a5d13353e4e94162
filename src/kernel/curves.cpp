#include "kernel/curves.h"

#include <iterator>

#include "kernel/basis.h"
#include "kernel/here.h"
#include "kernel/manoeuvre.h"
#include "kernel/train_category.h"
#include "modes/active_functions.h"
#include "sdm/locations.h"

namespace evc::kernel {
namespace {

sdm::Authority authority_of(const SupervisionBasis& basis) {
  const track::Authority& a = basis.authority;
  sdm::Authority out;
  if (a.LOA && !a.EOA) {
    out.kind = sdm::Authority::Kind::LOA;
    out.EOA = *a.LOA;
    out.V_LOA = a.V_LOA;
    return out;
  }
  if (!a.EOA) return out;
  out.kind = sdm::Authority::Kind::EOA_SvL;
  out.EOA = *a.EOA;
  out.SvL = a.SvL ? *a.SvL : *a.EOA;
  out.release_speed = a.release.kind;
  out.V_release = a.release.V;
  out.level_1_at_EOA = basis.key.level_1_at_EOA;
  if (basis.reference) {
    out.Q_LOCACC_reference = basis.Q_LOCACC;
    out.reference = *basis.reference;
  }
  out.confidence_interval = basis.confidence_interval;
  out.V_ura = basis.V_ura;
  out.L_train_doubt = basis.L_train_doubt;
  out.LOA_besides = a.LOA;
  out.V_LOA = a.V_LOA;
  return out;
}

/// 3.13.8.2.1 d: the curves are compared with the max safe front end of the position, in 4.0.0 not with that of this
/// distance (3.6.7.3 b).
std::optional<Place> SR_end(const StaffResponsible& sr) { return sr.end_of_curves ? sr.end_of_curves : sr.end; }

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

/// Steps of the MRSP limited by a TSR: their targets use the default gradient (3.13.4.1.3).
void mark_TSR_steps(const State& s, sdm::Inputs& in) {
  in.mrsp_due_to_TSR = {};
  for (std::size_t i = 0; i < in.mrsp.steps.size(); ++i)
    for (const track::TemporarySpeedRestriction& t : s.track.tsr) {
      const Place end = t.Q_FRONT ? t.to : t.to + supervised_train(s).L_TRAIN;
      const Place at = in.mrsp.steps[i].from;
      if (t.from <= at && at < end && track::speed_of(t.V_TSR) == in.mrsp.steps[i].value) in.mrsp_due_to_TSR[i] = true;
    }
}

/// Whether it counts for the MRSP in the mode (4.5.2).
bool counts_in(Mode mode, MrspSource source) {
  using modes::Function;
  // In the order of MrspSource.
  constexpr Function kOf[] = {Function::mrsp_ssp,   Function::mrsp_asp,  Function::mrsp_tsr,
                              Function::mrsp_pbd,   Function::mrsp_lx,   Function::mrsp_signalling,
                              Function::mrsp_train, Function::mrsp_mode, Function::mrsp_override};
  static_assert(std::size(kOf) == terms::index(MrspSource::count));
  return modes::active(kOf[terms::index(source)], mode);
}

/// Where the stored speed profile begins, in the modes where it counts (3.13.11.3).
std::optional<Place> begin_of_ssp(const State& s) {
  if (!counts_in(s.mode, MrspSource::SSP)) return std::nullopt;
  for (const auto& step : s.track.ssp.steps)
    if (step.value.known()) return step.from;
  return std::nullopt;
}

/// The gradient from the train's rear end on, and the part where it is known (3.13.4.1.2). A gap in between counts as
/// level.
void take_gradient(sdm::GradientProfile& g, const track::Description& d, Place from) {
  g.permille.steps.clear();
  g.known_from = g.known_to = std::nullopt;
  const auto& steps = d.gradient.steps;
  std::size_t first = 0;
  while (first < steps.size() && !steps[first].value.known()) ++first;
  std::size_t end = steps.size();
  while (end > first && !steps[end - 1].value.known()) --end;
  if (first < end) {
    track::gradient(g.permille, d, from);
    if (steps[first].from > from) g.known_from = steps[first].from;
    if (end < steps.size()) g.known_to = steps[end].from;
  }
  g.default_for_TSR = d.default_gradient;
}

void add_limit(track::MrspQuery& query, Speed v) {
  // At most three limits; eight fit.
  (void)query.limits.push_back({std::nullopt, std::nullopt, v});
}

/// Of the sources that count in the mode, those that are `wanted`.
track::MrspQuery query_of(const State& s, const Derived::Curves& curves, const SupervisionBasis& basis,
                          Set<MrspSource> wanted) {
  const auto counts = [&](MrspSource source) { return wanted.has(source) && counts_in(s.mode, source); };
  track::MrspQuery query;
  query.from = basis.min_safe_rear;
  query.train_length = supervised_train(s).L_TRAIN;
  query.category = category_of(supervised_train(s));
  query.category.own_axle_load_only = s.operated_X >= 3;
  query.elements = {.ssp = counts(MrspSource::SSP),
                    .asp = counts(MrspSource::ASP),
                    .tsr = counts(MrspSource::TSR),
                    .pbd = counts(MrspSource::PBD),
                    .lx = counts(MrspSource::LX),
                    .signalling = counts(MrspSource::signalling)};
  query.pbd_speeds = {curves.pbd_speeds.begin(), curves.pbd_speeds.size()};
  if (counts(MrspSource::train)) add_limit(query, supervised_train(s).V_MAXTRAIN);
  if (counts(MrspSource::mode) && basis.key.mode_limit) add_limit(query, *basis.key.mode_limit);
  if (counts(MrspSource::override_) && s.override_.active) add_limit(query, s.national_values.V_NVSUPOVTRP);
  return query;
}

/// Speeds of the permitted braking distances (3.11.11), with the current brakes.
void compute_PBD(const track::Description& d, Derived::Curves& curves) {
  curves.pbd_speeds.clear();
  for (const track::PermittedBrakingDistance& p : d.pbd) {
    const Speed v = sdm::permitted_braking_distance_speed(
        curves.inputs, p.D_PBD, static_cast<double>(p.gradient_permille), !p.service_brake, curves.sdm);
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

}  // namespace

void build(Derived::Curves& curves, const State& s, const TrainSignals& train, const SupervisionBasis& basis) {
  sdm::Inputs& in = curves.inputs;
  in.revision = basis.number;
  in.srs = s.srs;
  in.train = supervised_train(s);
  in.train.L_antenna_front = L_antenna_of_train(s);
  in.national_values = s.national_values;
  in.brakes = brake_status(train);
  in.conditions = conditions_of(s, basis.min_safe_rear);
  compute_PBD(s.track, curves);  // with the current rail condition (3.11.11.4)
  track::mrsp(in.mrsp, s.track, query_of(s, curves, basis, Set<MrspSource>::of_bits(~std::uint64_t{0})));
  mark_TSR_steps(s, in);
  in.track_description_from = begin_of_ssp(s);
  in.supervise_targets = !supervises(s, modes::Supervision::ceiling);
  in.authority = supervises(s, modes::Supervision::full) ? authority_of(basis) : sdm::Authority{};
  in.SR_end = supervises(s, modes::Supervision::mrsp_and_sr_distance) ? SR_end(s.staff_responsible) : std::nullopt;
  take_gradient(in.gradient, s.track, basis.min_safe_rear);
  curves.sdm.valid = false;
  (void)sdm::rebuild(curves.sdm, in);
}

void mrsp_of(MrspSource source, track::Mrsp& out, const State& s, const Derived::Curves& curves,
             const SupervisionBasis& basis) {
  track::mrsp(out, s.track, query_of(s, curves, basis, {source}));
}

sdm::Motion motion_of(const State& s, const track::Here& here, const TrainSignals& train) {
  sdm::Motion m;
  m.est_front = here.est_front;
  m.min_safe_front = here.min_safe_front;
  m.max_safe_front = here.max_safe_front;
  const Run run = run_of(s.position.now);
  m.V_est = run.V;
  m.V_ura = run.V_ura;
  m.A_est = run.A;
  m.standstill = here.standstill;
  m.automatic = s.mode == Mode::AD;
  m.now = s.now;
  m.brake_pressure_kpa = train.brake_pressure_kpa;
  if (s.radio.ma_request) m.T_MAR = s.radio.ma_request->T_MAR;
  return m;
}

}  // namespace evc::kernel
