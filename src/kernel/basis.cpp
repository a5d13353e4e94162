#include "kernel/basis.h"

#include "kernel/here.h"
#include "kernel/train_category.h"

namespace evc::kernel {
namespace {

/// When the train has moved back behind the place where the curves begin, they begin this far behind its rear end: they
/// are not built again for every step back.
constexpr Distance kBehindMovedBack{20.0};

/// The speed limit of the mode (3.11.7); absent: the mode has none.
std::optional<Speed> mode_speed(const State& s, const track::Here& here) {
  const train::NationalValues& nv = s.national_values;
  const auto of_area = [&](Speed national) {
    const auto area = area_of_mode(s, here);
    return area && area->V_MAMODE != track::kNoSpeed ? track::speed_of(area->V_MAMODE) : national;
  };
  switch (modes::properties(s.mode).speed_limit) {
    case modes::SpeedLimit::V_NVSHUNT:
      return s.V_SH == track::kNoSpeed ? nv.V_NVSHUNT : track::speed_of(s.V_SH);
    case modes::SpeedLimit::V_NVSTFF:
      return s.staff_responsible.V ? *s.staff_responsible.V : nv.V_NVSTFF;
    case modes::SpeedLimit::V_NVONSIGHT:
      return of_area(nv.V_NVONSIGHT);
    case modes::SpeedLimit::V_NVLIMSUPERV:
      return of_area(nv.V_NVLIMSUPERV);
    case modes::SpeedLimit::V_NVUNFIT:
      return nv.V_NVUNFIT;
    case modes::SpeedLimit::V_REVERSE:
      return s.track.reversing_supervision ? track::speed_of(s.track.reversing_supervision->V_REVERSE) : Speed{};
    case modes::SpeedLimit::V_SM:
      return track::speed_of(s.manoeuvre.V_SM);
    case modes::SpeedLimit::no_limit:
    case modes::SpeedLimit::standstill:
    case modes::SpeedLimit::profile_only:
    case modes::SpeedLimit::national:
      return std::nullopt;
  }
  return std::nullopt;
}

/// The special brakes reported active, as bits.
std::uint8_t brake_bits(const TrainSignals& t) {
  return static_cast<std::uint8_t>((t.regenerative_brake_active ? 1 : 0) | (t.eddy_current_brake_active ? 2 : 0) |
                                   (t.magnetic_shoe_brake_active ? 4 : 0) | (t.ep_brake_active ? 8 : 0) |
                                   (t.additional_brake_active ? 16 : 0));
}

/// Level 1 at the end of the authority: now, or by an order that will be executed in rear of it (3.13.9.4.8.2).
bool level_1_at(const State& s, const std::optional<Place>& EOA) {
  const auto& pending = s.level_transition.pending;
  if (pending && EOA && pending->border <= *EOA) return pending->to.level == Level::L1;
  return s.level.level == Level::L1;
}

/// The inputs of the release speed calculated on board other than stored data, in steps of 5 m and 0.5 m/s, so that
/// curves are not built again for every millimetre (3.13.9.4.8.2).
std::uint32_t inaccuracy(const State& s, const track::Here& here) {
  if (s.basis.authority.release.kind != ReleaseSpeedChoice::on_board) return 0;
  const double interval = (here.max_safe_front - here.min_safe_front).si / 5.0;
  const double speed = run_of(s.position.now).V_ura.si / 0.5;
  const auto steps = [](double v) { return v < 30000.0 ? static_cast<std::uint32_t>(v) : 30000u; };
  return steps(interval) << 16 | steps(speed);
}

}  // namespace

std::optional<track::ModeArea> area_of_mode(const State& s, const track::Here& here) {
  const train::NationalValues& nv = s.national_values;
  const Speed national = s.mode == Mode::OS ? nv.V_NVONSIGHT : nv.V_NVLIMSUPERV;
  const auto speed = [national](const track::ModeArea& area) {
    return area.V_MAMODE == track::kNoSpeed ? national : track::speed_of(area.V_MAMODE);
  };
  std::optional<track::ModeArea> under, ahead;
  for (const track::ModeArea& area : s.track.mode_profile) {
    if (area.mode != s.mode || (area.to && here.min_safe_front > *area.to)) continue;
    if (here.max_safe_front >= area.from) {
      if (!under || speed(area) < speed(*under)) under = area;
    } else if (area.accepted && (!ahead || area.from < ahead->from)) {
      ahead = area;
    }
  }
  return under ? under : ahead;
}

bool memorises_faults(const State& s) {
  return s.mode == Mode::SL || s.mode == Mode::NL || (s.mode == Mode::PS && s.srs == SrsVersion::v4_0_0);
}

bool supervises_speed(Mode mode) {
  return modes::properties(mode).supervision != modes::Supervision::unsupervised && mode != Mode::SN;
}

bool supervises(const State& s, modes::Supervision kind) { return modes::properties(s.mode).supervision == kind; }

SupervisionBasis basis_of(const State& s, const track::Here& here, const SupervisionBasis::Key& key,
                          const track::Authority& authority) {
  SupervisionBasis basis;
  basis.key = key;
  basis.number = s.basis.number + 1;
  if (basis.number == 0) basis.number = 1;
  basis.min_safe_rear = here.min_safe_rear;
  basis.confidence_interval = here.max_safe_front - here.min_safe_front;
  basis.V_ura = run_of(s.position.now).V_ura;
  if (s.manoeuvre.active) basis.L_train_doubt = s.position.ahead.max - s.position.ahead.min;
  if (const position::Reference* lrbg = position::lrbg(s.position)) {
    basis.reference = lrbg->place;
    basis.Q_LOCACC = lrbg->Q_LOCACC;
  }
  basis.authority = authority;
  return basis;
}

bool renew_basis(State& s, const TrainSignals& train, const track::Here& here) {
  const SupervisionBasis::Key key{.mode = s.mode,
                                  .track = s.track.revision,
                                  .revision = s.revision,
                                  .brakes = brake_bits(train),
                                  .level_1_at_EOA = level_1_at(s, s.basis.authority.EOA),
                                  .inaccuracy = inaccuracy(s, here),
                                  .mode_limit = mode_speed(s, here)};
  // What is stored of the track behind the train counts again for a train that moves back (A.3.6.2.1).
  const bool moved_back = s.basis.number != 0 && here.min_safe_rear < s.basis.min_safe_rear;
  if (s.basis.number != 0 && s.basis.key == key && !moved_back) return false;
  track::Authority authority;
  if (supervises(s, modes::Supervision::full))
    authority = track::authority(s.track, interfaces_of(s.train), s.mode, here.est_front, s.srs);
  s.basis = basis_of(s, here, key, authority);
  if (moved_back) s.basis.min_safe_rear = s.basis.min_safe_rear - kBehindMovedBack;
  return true;
}

}  // namespace evc::kernel
