#include "curves/result.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "curves/details.h"
#include "io/number.h"

namespace evc::curves {
namespace {

/// The lower of two values, where they exist.
Value least(const std::optional<Place>& a, const std::optional<Place>& b, const Approached& approached) {
  if (!a && !b) return std::nullopt;
  const Place least = !a ? *b : !b ? *a : std::min(*a, *b);
  return is_somewhere(least) ? Value(approached.before_target(least)) : std::nullopt;
}

/// The official tool of 3.4.0 replaces P and I above the MRSP by the MRSP, and ends the EBI where release speed
/// monitoring begins.
void draw_as_the_tool(SpeedRow& row, const Approached& a) {
  double ceiling = 0.0;  // the highest speed on the way to the target
  for (const auto& step : a.input().inputs.mrsp.steps)
    if (step.from < a.input().target_location) ceiling = std::max(ceiling, step.value.si * kKmh);
  if (row.v_kmh > ceiling) {
    const SpeedRow at_ceiling = speed_row(a, ceiling);
    row.P = at_ceiling.P;
    row.I = at_ceiling.I;
    row.P_EOA = at_ceiling.P_EOA;
    row.I_EOA = at_ceiling.I_EOA;
    row.P_SvL = at_ceiling.P_SvL;
    row.I_SvL = at_ceiling.I_SvL;
  }
  if (const auto start = a.start_of_RSM(); start && is_somewhere(*start) && row.EBI)
    row.EBI = std::max(*row.EBI, a.before_target(*start));
}

template <class Row>
void append_members(std::string& out, const Row& row, const std::vector<Column<Row>>& columns) {
  for (const auto& c : columns) {
    if (out.back() != '{') out += ", ";
    out += fmt::format("\"{}\": {}", c.name, shortest(row.*c.value, "null"));
  }
}

template <class Row>
void append_rows(std::string& out, const char* key, const char* first, double Row::*at, const std::vector<Row>& rows,
                 const std::vector<Column<Row>>& columns) {
  out += fmt::format("  \"{}\": [", key);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    out += i == 0 ? "\n" : ",\n";
    out += fmt::format("    {{\"{}\": {}", first, shortest(rows[i].*at, "null"));
    append_members(out, rows[i], columns);
    out += '}';
  }
  out += rows.empty() ? "]" : "\n  ]";
}

std::string as_json(const CurvesResult& r) {
  std::string out = "{\n  \"schema\": \"evc-curves-result/1\",\n  \"scalars\": {";
  append_members(out, r.scalars, scalar_columns());
  out += "},\n";
  append_rows(out, "by_speed", "v_kmh", &SpeedRow::v_kmh, r.by_speed, speed_columns(r.separate_EOA));
  out += ",\n";
  append_rows(out, "by_position", "position_m", &PositionRow::position_m, r.by_position, position_columns());
  append_queries_json(out, "PBD", r.PBD);
  append_queries_json(out, "LX", r.LX);
  for (const ResultTable& table : r.details) append_json(out, table);
  if (!r.notes.empty()) {
    out += ",\n  \"notes\": [";
    for (std::size_t i = 0; i < r.notes.size(); ++i) {
      if (i > 0) out += ", ";
      io::append_string(out, r.notes[i]);
    }
    out += "]";
  }
  return out + "\n}\n";
}

template <class Row>
void append_csv(std::string& out, const char* first, double Row::*at, const std::vector<Row>& rows,
                const std::vector<Column<Row>>& columns) {
  out += first;
  for (const auto& c : columns) out += std::string(",") + c.name;
  out += '\n';
  for (const Row& row : rows) {
    out += shortest(row.*at, "");
    for (const auto& c : columns) out += "," + shortest(row.*c.value, "");
    out += '\n';
  }
}

std::string as_csv(const CurvesResult& r) {
  std::string out;
  if (!r.by_speed.empty() || r.by_position.empty())
    append_csv(out, "v_kmh", &SpeedRow::v_kmh, r.by_speed, speed_columns(r.separate_EOA));
  if (!r.by_position.empty()) {
    if (!out.empty()) out += '\n';
    append_csv(out, "position_m", &PositionRow::position_m, r.by_position, position_columns());
  }
  append_queries_csv(out, r.PBD);
  append_queries_csv(out, r.LX);
  for (const ResultTable& table : r.details) append_csv(out, table);
  return out;
}

template <class Row>
std::string table_of(const char* first, double Row::*at, const std::vector<Row>& rows,
                     const std::vector<Column<Row>>& columns) {
  std::vector<Column<Row>> used;
  for (const auto& c : columns)
    if (std::any_of(rows.begin(), rows.end(), [&](const Row& row) { return (row.*c.value).has_value(); }))
      used.push_back(c);
  std::vector<std::string> names{first};
  for (const auto& c : used) names.emplace_back(c.name);
  TextTable table(names);
  for (const Row& row : rows) {
    std::vector<std::string> cells{shortest(row.*at, "-")};
    for (const auto& c : used) cells.push_back(fixed(row.*c.value, c.name[1] == '_' && c.name[0] == 'A' ? 3 : 1));
    table.add(cells);
  }
  return table.text();
}

std::string as_table(const CurvesResult& r) {
  std::string out;
  for (const auto& c : scalar_columns())
    if ((r.scalars.*c.value).has_value()) out += fmt::format("{:<18} {:>10}\n", c.name, fixed(r.scalars.*c.value, 2));
  if (!r.by_speed.empty()) {
    out += "\nmetres before the target location, by speed (decelerations in m/s2)\n";
    out += table_of("km/h", &SpeedRow::v_kmh, r.by_speed, speed_columns(r.separate_EOA));
  }
  if (!r.by_position.empty()) {
    out += "\nspeeds in km/h, by place\n";
    out += table_of("m", &PositionRow::position_m, r.by_position, position_columns());
  }
  append_queries_table(out, "permitted braking distances", r.PBD);
  append_queries_table(out, "level crossings: metres before them where their speed replaces the stop", r.LX);
  for (const ResultTable& table : r.details) append_text(out, table);
  for (const std::string& note : r.notes) out += "note: " + note + "\n";
  return out;
}

}  // namespace

Approached::Approached(io::CurvesInput input) : Approached(std::move(input), std::make_unique<sdm::Derived>()) {}

Approached::Approached(io::CurvesInput input, std::unique_ptr<sdm::Derived> memory)
    : input_(std::move(input)), derived_(std::move(memory)) {
  derived_->valid = false;  // of other inputs, whose revision may be the same
  sdm::rebuild(*derived_, input_.inputs);
  target_ = io::target_of(input_, *derived_);
}

sdm::Explanation Approached::explain(Speed V, const sdm::Target& target) const {
  return sdm::explain(*derived_, input_.inputs, target, V, input_.V_ura, input_.A_est,
                      input_.motion ? &*input_.motion : nullptr, input_.assumed);
}

sdm::TargetTimes Approached::times_of(const sdm::Explanation& e) const {
  sdm::TimesAsked asked;
  asked.feedback = sdm::assumed_feedback(*derived_, *target_, input_.assumed);
  if (derived_->rules.reduced_build_up) asked.reduced_from = sdm::Fronts{e.est_front, e.min_safe_front};
  return sdm::times_of(*derived_, *target_, e.approach, asked);
}

std::optional<Place> Approached::start_of_RSM() const {
  return start_of_RSM_at(input_.motion ? input_.motion->max_safe_front - input_.motion->est_front : Distance{0.0});
}

std::optional<Place> Approached::start_of_RSM_at(Distance over_reading) const {
  const sdm::ReleaseSpeed& r = derived_->release_speed;
  if (!r.exists || input_.target != sdm::TargetKind::EOA_SvL) return std::nullopt;
  sdm::RsmStart start{r.d_SBI1, r.d_SBI2};
  if (const auto times = sdm::assumed_feedback(*derived_, *target_, input_.assumed)) {
    // Between trip location and SvL there may be targets with a speed above 0.
    sdm::Feedback feedback{times, times};
    for (const sdm::Target& t : derived_->targets)
      (t.zero ? feedback.cm0 : feedback.cmt) = sdm::assumed_feedback(*derived_, t, input_.assumed);
    start = sdm::rsm_start(*derived_, *target_, r.V_release, r.d_trip, r.on_board, feedback);
  }
  return start.d_SBI2 - start.d_SBI1 >= over_reading ? start.d_SBI1 : start.d_SBI2;
}

std::vector<std::string> Approached::notes() const {
  std::vector<std::string> notes;
  if (input_.target == sdm::TargetKind::EOA_SvL && derived_->release_speed.on_board && !derived_->release_speed.exists)
    notes.emplace_back(
        "no release speed can be calculated on board: from the trip location the train would not stop "
        "in rear of the SvL (3.13.9.4.8)");
  if (target_->warnings.no_deceleration)
    notes.emplace_back("the train does not decelerate everywhere (A <= 0): the curve is level there, on the safe side");
  if (input_.assumed.brake_pressure && !sdm::assumed_feedback(*derived_, *target_, input_.assumed))
    notes.emplace_back(
        "the service brake feedback has no effect: it needs service_brake_feedback and service_brake_interface of the "
        "train, Q_NVSBFBPERM and Q_NVSBTSMPERM (3.13.10.4.9)");
  if (derived_->truncated) notes.emplace_back("more elements than fit: handled on the safe side");
  return notes;
}

const std::vector<Column<SpeedRow>>& speed_columns(bool separate_EOA) {
  using R = SpeedRow;
  static const std::vector<Column<R>> all = {
      {"A_safe", &R::A_safe},
      {"A_expected", &R::A_expected},
      {"A_brake_emergency", &R::A_brake_emergency},
      {"A_brake_service", &R::A_brake_service},
      {"EBD", &R::EBD},
      {"SBD", &R::SBD},
      {"GUI", &R::GUI},
      {"EBI", &R::EBI},
      {"SBI1", &R::SBI1},
      {"SBI2", &R::SBI2},
      {"FLOI", &R::FLOI},
      {"W", &R::W},
      {"P", &R::P},
      {"I", &R::I},
      {"W_EOA", &R::W_EOA},
      {"P_EOA", &R::P_EOA},
      {"I_EOA", &R::I_EOA},
      {"W_SvL", &R::W_SvL},
      {"P_SvL", &R::P_SvL},
      {"I_SvL", &R::I_SvL},
  };
  static const std::vector<Column<R>> common(all.begin(), all.end() - 6);
  return separate_EOA ? all : common;
}

const std::vector<Column<SpeedRow>>& curve_columns() {
  static const std::vector<Column<SpeedRow>> curves(speed_columns(false).begin() + 4, speed_columns(false).end());
  return curves;
}

const std::vector<Column<PositionRow>>& position_columns() {
  using R = PositionRow;
  static const std::vector<Column<R>> columns = {
      {"EBD", &R::EBD}, {"SBD", &R::SBD}, {"EBI", &R::EBI}, {"SBI", &R::SBI}, {"W", &R::W}, {"P", &R::P}, {"I", &R::I},
  };
  return columns;
}

const std::vector<Column<Scalars>>& scalar_columns() {
  using R = Scalars;
  static const std::vector<Column<R>> columns = {
      {"T_be_s", &R::T_be_s},
      {"T_bs_s", &R::T_bs_s},
      {"V_release_kmh", &R::V_release_kmh},
      {"d_start_RSM_m", &R::d_start_RSM_m},
      {"d_preindication_m", &R::d_preindication_m},
      {"d_perturbation_m", &R::d_perturbation_m},
  };
  return columns;
}

SpeedRow speed_row(const Approached& a, double v_kmh, const sdm::Target& t, Place location) {
  const sdm::Explanation e = a.explain(Speed{v_kmh / kKmh}, t);
  const auto distance = [&](Place place) { return is_somewhere(place) ? Value((location - place).si) : std::nullopt; };
  SpeedRow row;
  row.v_kmh = v_kmh;
  row.A_safe = e.A_safe.si;
  row.A_expected = e.A_expected.si;
  row.A_brake_emergency = e.A_brake_emergency.si;
  row.A_brake_service = e.A_brake_service.si;
  row.EBD = distance(e.d_EBD);
  if (e.d_SBD) row.SBD = distance(*e.d_SBD);
  if (e.d_GUI) row.GUI = distance(*e.d_GUI);
  row.EBI = distance(*e.EBD.d_EBI);  // null, like all values that depend on it, for a speed that is allowed nowhere
  row.SBI2 = distance(e.EBD.d_SBI);
  row.FLOI = distance(e.d_FLOI);
  row.W = distance(e.d_W);
  row.P = distance(e.d_P);
  row.I = distance(e.d_I);
  row.W_SvL = distance(e.EBD.d_W);
  row.P_SvL = distance(e.EBD.d_P);
  row.I_SvL = distance(e.EBD.d_I);
  if (e.SBD) {
    row.SBI1 = distance(e.SBD->d_SBI);
    row.W_EOA = distance(e.SBD->d_W);
    row.P_EOA = distance(e.SBD->d_P);
    row.I_EOA = distance(e.SBD->d_I);
  }
  return row;
}

SpeedRow speed_row(const Approached& a, double v_kmh) {
  SpeedRow row = speed_row(a, v_kmh, a.target(), a.input().target_location);
  if (a.derived().rules.pre_indication) draw_as_the_tool(row, a);
  return row;
}

PositionRow position_row(const Approached& a, double x_m, bool with_interval) {
  const io::CurvesInput& input = a.input();
  const bool interval = with_interval && input.motion;
  const Distance under_reading = interval ? input.motion->est_front - input.motion->min_safe_front : Distance{0.0};
  const Distance over_reading = interval ? input.motion->max_safe_front - input.motion->est_front : Distance{0.0};
  const sdm::PositionRow p = sdm::supervised_speeds_at(a.derived(), input.inputs, a.target(), Place{{x_m}}, input.V_ura,
                                                       input.A_est, under_reading, over_reading, input.assumed);
  PositionRow row;
  row.position_m = x_m;
  row.EBD = p.EBD.si * kKmh;
  if (a.target().kind == sdm::TargetKind::EOA_SvL) row.SBD = p.SBD.si * kKmh;
  row.EBI = p.EBI.si * kKmh;
  row.SBI = p.SBI.si * kKmh;
  row.W = p.W.si * kKmh;
  row.P = p.P.si * kKmh;
  row.I = p.I.si * kKmh;
  return row;
}

Scalars scalars_of(const Approached& a) {
  const sdm::Derived& d = a.derived();
  const sdm::Target& t = a.target();
  Scalars s;
  const sdm::Explanation e = a.explain(Speed{0.0});
  s.T_be_s = e.build_up.T_be.si;
  s.T_bs_s = e.build_up.T_bs.si;
  if (t.kind == sdm::TargetKind::EOA_SvL && d.release_speed.exists)
    s.V_release_kmh = rounded_kmh(d.release_speed.V_release);
  if (const auto start = a.start_of_RSM(); start && is_somewhere(*start)) s.d_start_RSM_m = a.before_target(*start);
  s.d_preindication_m = least(t.d_preindication_EBD, t.d_preindication_SBD, a);
  if (a.input().target != sdm::TargetKind::MRSP && !d.rules.pre_indication)
    s.d_perturbation_m = least(d.perturbation.from_EBD, d.perturbation.from_SBD, a);
  return s;
}

CurvesResult curves_result(const Approached& a) {
  const io::CurvesInput& input = a.input();
  const sdm::Target& t = a.target();
  CurvesResult r;
  r.scalars = scalars_of(a);
  for (const double v : input.speeds_kmh) r.by_speed.push_back(speed_row(a, v));
  for (const double x : input.positions_m) r.by_position.push_back(position_row(a, x, true));
  r.PBD = PBD_rows(a);
  r.LX = LX_rows(a);
  r.details = detail_tables(a);
  r.separate_EOA = t.kind == sdm::TargetKind::EOA_SvL && t.d_EOA != t.d_target;
  r.notes = a.notes();
  return r;
}

namespace {

/// The unit of a name that ends in it: "T_be_s".
const char* unit_of(const std::string& name) {
  const std::string end = name.substr(name.rfind('_') + 1);
  return end == "s" ? "s" : end == "m" ? "m" : end == "kmh" ? "km/h" : "";
}

template <class Row>
ResultTable table_of_rows(const char* key, TableColumn first, double Row::*at, const std::vector<Row>& rows,
                          const std::vector<Column<Row>>& columns, const char* unit) {
  ResultTable table{key, key, {std::move(first)}, {}};
  for (const auto& c : columns) table.columns.push_back({c.name, c.name[0] == 'A' ? "m/s2" : unit});
  for (const Row& row : rows) {
    std::vector<Cell> cells{Value(row.*at)};
    for (const auto& c : columns) cells.emplace_back(row.*c.value);
    table.rows.push_back(std::move(cells));
  }
  return table;
}

void add_queries(std::vector<ResultTable>& tables, const char* key, const std::vector<QueryRow>& rows) {
  if (rows.empty()) return;
  ResultTable table{key, key, {}, {}};
  for (const auto& [name, value] : rows.front()) {
    const std::string text = name;
    const char* unit = text == "G_PBDSR"                  ? "per mille"
                       : text[0] == 'V'                   ? "km/h"
                       : text[0] == 'Q' || text[0] == 'f' ? ""
                                                          : "m";
    table.columns.push_back({text, unit});
  }
  for (const QueryRow& row : rows) {
    std::vector<Cell> cells;
    for (const auto& [name, value] : row) cells.emplace_back(value);
    table.rows.push_back(std::move(cells));
  }
  tables.push_back(std::move(table));
}

}  // namespace

std::vector<ResultTable> tables_of(const CurvesResult& r) {
  ResultTable scalars{"scalars", "scalars", {{"name"}, {"value"}, {"unit"}}, {}};
  for (const auto& c : scalar_columns())
    if (const Value& value = r.scalars.*c.value) scalars.rows.push_back({c.name, value, unit_of(c.name)});
  std::vector<ResultTable> tables{std::move(scalars)};
  if (!r.by_speed.empty())
    tables.push_back(
        table_of_rows("by_speed", {"v_kmh", "km/h"}, &SpeedRow::v_kmh, r.by_speed, speed_columns(r.separate_EOA), "m"));
  if (!r.by_position.empty())
    tables.push_back(table_of_rows("by_position", {"position_m", "m"}, &PositionRow::position_m, r.by_position,
                                   position_columns(), "km/h"));
  add_queries(tables, "PBD", r.PBD);
  add_queries(tables, "LX", r.LX);
  tables.insert(tables.end(), r.details.begin(), r.details.end());
  if (!r.notes.empty()) {
    ResultTable notes{"notes", "notes", {{"note"}}, {}};
    for (const std::string& note : r.notes) notes.rows.push_back({note});
    tables.push_back(std::move(notes));
  }
  return tables;
}

std::string curves_text(const CurvesResult& result, Format format) {
  if (format == Format::csv) return as_csv(result);
  return format == Format::table ? as_table(result) : as_json(result);
}

std::string TextTable::text() const {
  std::vector<std::size_t> width;
  for (const auto& row : rows_)
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i == width.size()) width.push_back(0);
      width[i] = std::max(width[i], row[i].size());
    }
  std::string out;
  for (const auto& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) out += fmt::format("{}{:>{}}", i == 0 ? "" : "  ", row[i], width[i]);
    out += '\n';
  }
  return out;
}

std::string fixed(const Value& value, int digits) { return value ? fmt::format("{:.{}f}", *value, digits) : "-"; }

std::string shortest(const Value& value, const char* none) {
  if (!value) return none;
  std::string out;
  io::append_number(out, *value);
  return out;
}

}  // namespace evc::curves
