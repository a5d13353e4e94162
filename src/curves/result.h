#pragma once
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "curves/tables.h"
#include "io/curves_file.h"
#include "openevc/curves.h"
#include "sdm/evaluate.h"

namespace evc::curves {

/// A curves input with everything computed from it, and the curves of its target.
class Approached {
 public:
  explicit Approached(io::CurvesInput input);
  /// In memory of an earlier one: new memory of this size costs more than the curves.
  Approached(io::CurvesInput input, std::unique_ptr<sdm::Derived> memory);
  /// The memory for the next one; this one cannot be used any more.
  std::unique_ptr<sdm::Derived> release() && { return std::move(derived_); }

  const io::CurvesInput& input() const { return input_; }
  const sdm::Derived& derived() const { return *derived_; }
  const sdm::Target& target() const { return *target_; }
  sdm::Explanation explain(Speed V) const { return explain(V, *target_); }
  sdm::Explanation explain(Speed V, const sdm::Target& target) const;
  /// Metres before the target location.
  double before_target(Place place) const { return (input_.target_location - place).si; }
  /// The speed under-reading amount at a speed: as given, or f41.
  Speed V_ura_at(Speed V) const { return input_.assumed.V_ura_of_041 ? train::f41(V) : input_.V_ura; }
  /// The times of both curves, as in `e`.
  sdm::TargetTimes times_of(const sdm::Explanation& e) const;
  /// Start of release speed monitoring (3.13.9.4.9).
  std::optional<Place> start_of_RSM() const;
  /// The same for a max safe front end this far in advance of the estimated one.
  std::optional<Place> start_of_RSM_at(Distance over_reading) const;
  /// Notes on cases that the standard does not cover and on data that did not fit.
  std::vector<std::string> notes() const;

 private:
  io::CurvesInput input_;
  std::unique_ptr<sdm::Derived> derived_;
  const sdm::Target* target_ = nullptr;
};

using Value = std::optional<double>;

/// Metres of a place of the input's frame.
constexpr double m(Place place) { return place.from_origin.si; }
/// In km/h, without the rounding noise of the conversion from km/h to m/s and back.
inline double rounded_kmh(Speed V) { return std::nearbyint(V.si * kKmh * 1e9) / 1e9; }

/// For a speed that is allowed nowhere (A <= 0), curves return a place a million kilometres away.
constexpr bool is_somewhere(Place place) { return place.from_origin.si > -1e8; }

/// Curves and limits at one speed: metres before the target location, decelerations in m/s2.
struct SpeedRow {
  double v_kmh = 0.0;
  Value A_safe, A_expected, A_brake_emergency, A_brake_service;
  Value EBD, SBD, GUI, EBI, SBI1, SBI2, FLOI, W, P, I;
  Value W_EOA, P_EOA, I_EOA, W_SvL, P_SvL, I_SvL;
};
/// Speeds in km/h of curves and limits at one place of the line.
struct PositionRow {
  double position_m = 0.0;
  Value EBD, SBD, EBI, SBI, W, P, I;
};
/// The answer to a query other than speeds and places: names and values.
using QueryRow = std::vector<std::pair<const char*, Value>>;
struct Scalars {
  Value T_be_s, T_bs_s, V_release_kmh, d_start_RSM_m, d_preindication_m, d_perturbation_m;
};
struct CurvesResult {
  Scalars scalars;
  std::vector<SpeedRow> by_speed;
  std::vector<PositionRow> by_position;
  std::vector<QueryRow> PBD, LX;
  std::vector<ResultTable> details;
  std::vector<std::string> notes;
  bool separate_EOA = false;  // EOA and SvL differ: the rows have the limits of both
};

/// A member of a row with its name in outputs.
template <class Row>
struct Column {
  const char* name;
  Value Row::*value;
};
const std::vector<Column<SpeedRow>>& speed_columns(bool separate_EOA);
const std::vector<Column<PositionRow>>& position_columns();
const std::vector<Column<Scalars>>& scalar_columns();
/// Curves and limits only, for charts and comparison.
const std::vector<Column<SpeedRow>>& curve_columns();

SpeedRow speed_row(const Approached& approached, double v_kmh);
/// The same towards any of the targets, in metres before `location`.
SpeedRow speed_row(const Approached& approached, double v_kmh, const sdm::Target& target, Place location);
/// At a place of the line; with the confidence interval of the train, if it has one, or with an exactly known position.
PositionRow position_row(const Approached& approached, double x_m, bool with_interval);
Scalars scalars_of(const Approached& approached);
CurvesResult curves_result(const Approached& approached);

/// Speed restrictions of the permitted braking distances (3.11.11), km/h.
std::vector<QueryRow> PBD_rows(const Approached& approached);
/// Metres before each level crossing where its speed replaces the stop (3.13.9.3.5.11-12); `from_EOA`: 1 where the SBD
/// decides (against the estimated front end), 0 where the EBD does.
std::vector<QueryRow> LX_rows(const Approached& approached);
void append_queries_json(std::string& out, const char* key, const std::vector<QueryRow>& rows);
void append_queries_csv(std::string& out, const std::vector<QueryRow>& rows);
void append_queries_table(std::string& out, const char* title, const std::vector<QueryRow>& rows);

enum class Format { json, csv, table };
/// All tables of the result, with the scalars first and the notes last: a sheet for each.
std::vector<ResultTable> tables_of(const CurvesResult& result);
/// The result as `evc-curves-result/1`, CSV or a table.
std::string curves_text(const CurvesResult& result, Format format);

/// Right-aligned columns; "-" where a value does not exist.
class TextTable {
 public:
  explicit TextTable(std::vector<std::string> names) : rows_{std::move(names)} {}
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};
/// With `digits` decimals; "-" for none.
std::string fixed(const Value& value, int digits);
/// Shortest decimal that reads back to the same double; `none` for none.
std::string shortest(const Value& value, const char* none);

}  // namespace evc::curves
