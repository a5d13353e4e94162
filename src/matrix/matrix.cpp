#include "matrix/matrix.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/here.h"
#include "kernel/train_category.h"

namespace evc::matrix {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

void lower(std::optional<Speed>& v, Speed other) {
  if (!v || other < *v) v = other;
}
void lower(std::optional<Speed>& v, track::SpeedCode code) {
  if (code != track::kNoSpeed) lower(v, track::speed_of(code));
}

/// What the rows are computed from.
struct Source {
  const kernel::State& state;
  const kernel::Derived::Curves& curves;
  track::TrainCategory category;
};

/// The elements of the static speed profile, without delay (3.11.3); the lowest one gives Q_FRONT.
void take_ssp(Row& row, const Source& s) {
  const auto& steps = s.state.track.ssp.steps;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool ends_before = i + 1 < steps.size() && steps[i + 1].from <= row.from;
    if (steps[i].from >= row.to || ends_before || !steps[i].value.known()) continue;
    const Speed v = track::speed_of(steps[i].value.speed_for(s.category));
    if (row.SSP && *row.SSP <= v) continue;
    row.SSP = v;
    row.QF = steps[i].value.Q_FRONT;
  }
}

void take_areas(Row& row, const Source& s) {
  const auto in_row = [&](const auto& area) { return area.from < row.to && area.to > row.from; };
  for (const track::AxleLoadRestriction& a : s.state.track.asp)
    if (in_row(a)) lower(row.ASP, a.speed_for(s.category));
  for (const track::TemporarySpeedRestriction& t : s.state.track.tsr)
    if (in_row(t)) lower(row.TSR, t.V_TSR);
}

void take_mrsp(Row& row, const Source& s) {
  const sdm::Mrsp& mrsp = s.curves.inputs.mrsp;
  row.MRSP = mrsp.at(row.from);
  for (const auto& step : mrsp.steps)
    if (step.from > row.from && step.from < row.to) row.MRSP = std::min(row.MRSP, step.value);
}

/// The lowest value of the bands that reach into the speed step (over, upto].
template <class ValueOf>
Acceleration lowest(const sdm::Bands& bands, double over, double upto, ValueOf value_of) {
  Acceleration least{kInfinite};
  double below = -1.0;  // upper limit of the band before, m2/s2; standstill belongs to the first band
  for (const sdm::Band& band : bands) {
    if (below < upto && band.w_upto.si > over) least = std::min(least, value_of(band));
    below = band.w_upto.si;
  }
  return least;
}

void take_brakes(Row& row, const Source& s, const Matrix& m) {
  const sdm::Decelerations& d = s.curves.sdm.decelerations;
  row.Grd = kInfinite;
  row.Aeb.fill({kInfinite});
  row.Asafe.fill({kInfinite});
  for (std::size_t i = 0; i < d.segments.size(); ++i) {
    const sdm::Segment& segment = d.segments[i];
    // The first segment holds before its start, too.
    const bool before = i + 1 < d.segments.size() && d.segments[i + 1].from <= row.from;
    if (before || (i > 0 && segment.from >= row.to)) continue;
    row.Grd = std::min(row.Grd, segment.grad);
    row.Adh = row.Adh || segment.reduced_adhesion;
    const sdm::Bands& bands = d.bands(sdm::CurveKind::EBD, segment);
    double over = -1.0;
    for (std::size_t k = 0; k < kSteps; ++k) {
      const bool last = k + 1 == kSteps || !m.steps[k];
      const double upto = last ? kInfinite : m.steps[k]->si * m.steps[k]->si;
      row.Aeb[k] = std::min(row.Aeb[k], lowest(bands, over, upto, [&](const sdm::Band& band) {
                              return band.A[segment.reduced_adhesion ? 1 : 0];
                            }));
      row.Asafe[k] =
          std::min(row.Asafe[k],
                   lowest(bands, over, upto, [&](const sdm::Band& band) { return sdm::deceleration(band, segment); }));
      if (!last) over = upto;
    }
  }
}

void take_groups(Matrix& m, const Source& s) {
  if (const position::Reference* lrbg = position::lrbg(s.state.position)) m.rows.front().group = lrbg->id;
  for (const balise::Link& link : s.state.balise.linking.links)
    for (Row& row : m.rows)
      if (!link.identity_unknown() && link.place >= row.from && link.place < row.to && !row.group) row.group = link.id;
}

/// Where what is stored ends: the EOA or LOA, else the end of the static speed profile.
std::optional<Place> end_of(const kernel::State& state) {
  if (const auto end = state.basis.authority.EOA_or_LOA()) return end;
  const auto& steps = state.track.ssp.steps;
  if (steps.empty()) return {};
  return steps.back().from;
}

/// The limits of the first speed steps of the emergency brake. Above the third one the rows have the lowest value.
void take_steps(Matrix& m, const sdm::Decelerations& d) {
  const sdm::Bands& bands = d.bands(sdm::CurveKind::EBD, d.segments.front());
  for (std::size_t k = 0; k < m.steps.size() && k + 1 < bands.size(); ++k)
    m.steps[k] = Speed{std::sqrt(bands[k].w_upto.si)};
}

Row row_of(const Source& s, const Matrix& m, Place from, Place to) {
  Row row;
  row.from = from;
  row.to = to;
  take_ssp(row, s);
  take_areas(row, s);
  take_mrsp(row, s);
  take_brakes(row, s, m);
  return row;
}

}  // namespace

Matrix matrix_of(const kernel::State& state, const kernel::Derived& derived, std::optional<Distance> quantum) {
  Matrix m;
  m.front = kernel::here(state).est_front;
  m.target = state.basis.authority.EOA_or_LOA();
  const std::optional<Place> end = end_of(state);
  const Distance way = end ? *end - m.front : Distance{};
  m.quantum = quantum.value_or(quantum_for(way));
  const bool supervised = derived.built != 0 && !derived.in_force.inputs.mrsp.empty();
  if (!supervised || way <= Distance{}) return m;
  const Source source{state, derived.in_force, kernel::category_of(state.train)};
  take_steps(m, derived.in_force.sdm.decelerations);
  const double count = std::ceil(way.si / m.quantum.si);
  m.cut = count > static_cast<double>(kMostRows);
  const std::size_t rows = m.cut ? kMostRows : static_cast<std::size_t>(count);
  for (std::size_t i = 0; i < rows; ++i) {
    const Place from = m.front + static_cast<double>(i) * m.quantum;
    const Place to = !m.cut && i + 1 == rows ? *end : m.front + static_cast<double>(i + 1) * m.quantum;
    m.rows.push_back(row_of(source, m, from, to));
  }
  if (m.target && !m.cut)
    m.rows.back().V_LOA = state.basis.authority.ends_with_LOA() ? state.basis.authority.V_LOA : Speed{};
  take_groups(m, source);
  return m;
}

}  // namespace evc::matrix
