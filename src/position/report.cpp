#include "position/report.h"

namespace evc::position {
namespace {

/// The largest code of a length.
constexpr double kLargest = 32766.0;
/// Speeds and lengths that are whole multiples of their step must not be rounded up by the last bit of a double.
constexpr double kWhole = 1e-6;

/// x rounded up to a whole number, 0 for a negative x.
std::uint32_t up(double x) {
  if (x <= kWhole) return 0;
  const auto whole = static_cast<std::uint32_t>(x);
  return x - static_cast<double>(whole) > kWhole ? whole + 1 : whole;
}

std::uint16_t length_code(double steps) {
  if (steps > kLargest) return kUnknownLength;
  return static_cast<std::uint16_t>(up(steps));
}

std::uint32_t wire(GroupId id) { return (static_cast<std::uint32_t>(id.NID_C) << 14) | id.NID_BG; }

/// The step of Q_SCALE, as a divisor of metres.
constexpr double in_steps(Distance d, std::uint8_t Q_SCALE) {
  return Q_SCALE == 0 ? d.si * 10.0 : Q_SCALE == 1 ? d.si : d.si / 10.0;
}
constexpr Distance from_steps(double steps, std::uint8_t Q_SCALE) {
  return {Q_SCALE == 0 ? steps / 10.0 : Q_SCALE == 1 ? steps : steps * 10.0};
}

std::uint8_t finest_scale(Distance longest) {
  for (std::uint8_t scale = 0; scale < 2; ++scale)
    if (in_steps(longest, scale) <= kLargest - 1.0) return scale;
  return 2;
}

/// The estimated front end as it is reported: D_LRBG from the reference.
Place put_place(Report& out, const PlaceInterval& at, const Reference& reference) {
  const Distance ahead = at.est - reference.place;
  const Distance away = ahead.si < 0 ? -ahead : ahead;
  Distance longest = away;
  if (at.est - at.min > longest) longest = at.est - at.min;
  if (at.max - at.est > longest) longest = at.max - at.est;
  out.Q_SCALE = finest_scale(longest);
  const double steps = in_steps(away, out.Q_SCALE);
  if (steps > kLargest) return at.est;  // too far to be reported: D_LRBG and the doubts stay unknown
  const auto nearest = static_cast<std::uint16_t>(steps + 0.5);
  out.D_LRBG = nearest;
  const Distance reported = from_steps(nearest, out.Q_SCALE);
  const Place est = reference.place + (ahead.si < 0 ? -reported : reported);
  out.L_DOUBTOVER = length_code(in_steps(est - at.min, out.Q_SCALE));
  out.L_DOUBTUNDER = length_code(in_steps(at.max - est, out.Q_SCALE));
  return est;
}

void put_directions(Report& out, const State& state, Place est_front, const Reference& reference) {
  Direction cab = reference.orientation;
  if (cab == Direction::unknown) {  // 3.4.2.3.3: packet 1
    out.NID_PRVLRBG = reference.previous ? wire(*reference.previous) : kUnknownGroup;
    if (reference.previous) cab = reference.pair_orientation;
  }
  const bool ahead = est_front >= reference.place;
  const bool forward = state.last_motion == Motion::forward;
  out.Q_DIRLRBG = static_cast<std::uint8_t>(cab);
  out.Q_DLRBG = static_cast<std::uint8_t>(ahead ? cab : opposite(cab));
  out.Q_DIRTRAIN = static_cast<std::uint8_t>(forward ? cab : opposite(cab));
}

}  // namespace

Report report(const State& state, const IntegrityStatus& integrity, const Ahead& ahead) {
  Report out;
  const PlaceInterval engine = engine_front(state);
  const PlaceInterval at{engine.min + ahead.min, engine.est + ahead.est, engine.max + ahead.max};
  const double five_km_h = state.now.V_est.si * 3.6 / 5.0;
  const std::uint32_t V = up(five_km_h < 0 ? -five_km_h : five_km_h);
  out.V_TRAIN = static_cast<std::uint8_t>(V > 120 ? 120 : V);
  out.Q_LENGTH = static_cast<std::uint8_t>(integrity.integrity);
  Place est = at.est;
  // 3.6.2.2.2.1; an invalid position is reported with its values during start of mission.
  const Reference* reference = state.status == DataStatus::unknown ? nullptr : lrbg(state);
  if (reference != nullptr) {
    out.NID_LRBG = wire(reference->id);
    put_directions(out, state, at.est, *reference);
    est = put_place(out, at, *reference);
  }
  // Counted from the front end that is reported (7.5.1.57): its rounding, up to 5 m, must not shorten the train.
  if (integrity.integrity == Integrity::by_device || integrity.integrity == Integrity::by_driver)
    out.L_TRAININT = length_code((est - integrity.min_safe_rear).si);
  return out;
}

void note_reported(State& state, const Report& sent) {
  for (Reference& reference : state.references) {
    if (wire(reference.id) != sent.NID_LRBG) continue;
    reference.reported = true;
    if (!sent.NID_PRVLRBG || *sent.NID_PRVLRBG == kUnknownGroup) continue;
    const GroupId with{static_cast<std::uint16_t>(*sent.NID_PRVLRBG >> 14),
                       static_cast<std::uint16_t>(*sent.NID_PRVLRBG & 0x3FFFu)};
    if (reference.reported_with && !(*reference.reported_with == with)) reference.reported_ambiguously = true;
    if (reference.reported_with) continue;
    reference.reported_with = with;
    reference.reported_orientation = reference.pair_orientation;
  }
}

void set_parameters(ReportState& reports, const State& state, const ReportParameters& parameters) {
  reports.parameters = parameters;
  reports.sent_at = state.time;
  reports.sent_counter = state.now.counter.nominal;
  reports.now_pending = parameters.M_LOC == 0;
}

void clear_parameters(ReportState& reports) {
  reports.parameters.reset();
  reports.now_pending = false;
}

namespace {

/// Whether the end of the train to which the place applies has passed it.
bool passed(const State& state, const ReportParameters::At& at, Distance L_TRAIN) {
  const PlaceInterval end = front(state);
  return at.front ? end.max >= at.place : end.min - L_TRAIN >= at.place;
}

std::uint16_t due_by_parameters(ReportState& reports, const State& state, bool new_lrbg, Distance L_TRAIN) {
  std::uint16_t why = 0;
  const auto add = [&why](Due d) { why = static_cast<std::uint16_t>(why | static_cast<std::uint16_t>(d)); };
  ReportParameters& parameters = *reports.parameters;
  if (reports.now_pending) add(Due::now);
  reports.now_pending = false;
  if (new_lrbg && parameters.M_LOC == 1) add(Due::lrbg);
  const Distance run = state.now.counter.nominal - reports.sent_counter;
  const bool time_up = parameters.T_CYCLOC && state.time - reports.sent_at >= *parameters.T_CYCLOC;
  const bool far = parameters.D_CYCLOC && (run >= *parameters.D_CYCLOC || -run >= *parameters.D_CYCLOC);
  if (time_up) reports.sent_at = state.time;
  if (far) reports.sent_counter = state.now.counter.nominal;
  if (time_up || far) add(Due::cycle);
  const std::size_t before = parameters.at.size();
  parameters.at.erase_if([&](const ReportParameters::At& at) { return passed(state, at, L_TRAIN); });
  if (parameters.at.size() != before) add(Due::place);
  return why;
}

bool due_at_border(ReportState& reports, const State& state, Distance L_TRAIN) {
  const bool rear = reports.rear_border && passed(state, {*reports.rear_border, false}, L_TRAIN);
  const bool ahead = reports.front_border && passed(state, {*reports.front_border, true}, L_TRAIN);
  if (rear) reports.rear_border.reset();
  if (ahead) reports.front_border.reset();
  return rear || ahead;
}

}  // namespace

std::uint16_t due(ReportState& reports, const State& state, const ReportEvents& events, Distance L_TRAIN) {
  std::uint16_t why = 0;
  const auto add = [&why](Due d) { why = static_cast<std::uint16_t>(why | static_cast<std::uint16_t>(d)); };
  const bool stands = at_standstill(state);
  if (stands && !reports.stood && events.standstill_active) add(Due::standstill);
  if (!stands && reports.stood && events.leaving_active) add(Due::standstill);
  reports.stood = stands;
  if (events.mode_change || events.integrity_confirmed || events.integrity_lost || events.level_change ||
      events.session_established || events.error_to_report)
    add(Due::event);
  if (events.borders_active && due_at_border(reports, state, L_TRAIN)) add(Due::border);
  if (!reports.parameters && events.new_lrbg && events.groups_active) add(Due::lrbg);  // 3.6.5.1.4 j
  if (reports.parameters && events.parameters_active)
    why = static_cast<std::uint16_t>(why | due_by_parameters(reports, state, events.new_lrbg, L_TRAIN));
  return why;
}

}  // namespace evc::position
