#include <algorithm>
#include <charconv>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "curves/result.h"
#include "io/curves_file.h"
#include "io/file.h"
#include "io/named_document.h"
#include "io/number.h"
#include "sweep/document.h"
#include "sweep/kinds.h"

namespace evc::sweep {
namespace {

using curves::Approached;
using curves::CurvesResult;
using curves::PositionRow;
using curves::SpeedRow;
using io::Json;
using io::JsonPlace;

using Measure = std::function<Value(const CurvesResult&)>;

Value or_none(const curves::Value& value) { return value ? Value(*value) : Value(); }

template <class Row>
using Cell = std::function<curves::Value(const Row&)>;

/// A column of all rows as a list.
template <class Row>
Value column_of(const std::vector<Row>& rows, const Cell<Row>& cell) {
  std::string list = "[";
  for (const Row& row : rows) list += (list.size() > 1 ? "," : "") + curves::shortest(cell(row), "null");
  return list + "]";
}

/// `list.NAME`: the column of all rows; `list.N.NAME`: of row N, from 0.
template <class Row>
std::optional<Measure> measure_of_rows(const std::string& rest, std::vector<Row> CurvesResult::*rows,
                                       const std::vector<std::pair<std::string, Cell<Row>>>& cells) {
  const std::size_t dot = rest.find('.');
  const std::string name = dot == std::string::npos ? rest : rest.substr(dot + 1);
  const auto cell = std::find_if(cells.begin(), cells.end(), [&](const auto& c) { return c.first == name; });
  if (cell == cells.end()) return std::nullopt;
  if (dot == std::string::npos)
    return [rows, of = cell->second](const CurvesResult& r) { return column_of(r.*rows, of); };
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + dot, index);
  if (error != std::errc{} || end != rest.data() + dot) return std::nullopt;
  return [rows, index, of = cell->second](const CurvesResult& r) {
    return index < (r.*rows).size() ? or_none(of((r.*rows)[index])) : Value();
  };
}

template <class Row>
std::vector<std::pair<std::string, Cell<Row>>> cells_of(const char* first, double Row::*at,
                                                        const std::vector<curves::Column<Row>>& columns) {
  std::vector<std::pair<std::string, Cell<Row>>> cells{{first, [at](const Row& row) { return row.*at; }}};
  for (const auto& c : columns) cells.emplace_back(c.name, [member = c.value](const Row& row) { return row.*member; });
  return cells;
}

std::optional<Measure> measure_of(const std::string& name) {
  const std::size_t dot = name.find('.');
  const std::string first = name.substr(0, dot);
  const std::string rest = dot == std::string::npos ? "" : name.substr(dot + 1);
  if (first == "scalars")
    for (const auto& c : curves::scalar_columns())
      if (rest == c.name) return [member = c.value](const CurvesResult& r) { return or_none(r.scalars.*member); };
  if (first == "by_speed")
    return measure_of_rows<SpeedRow>(rest, &CurvesResult::by_speed,
                                     cells_of("v_kmh", &SpeedRow::v_kmh, curves::speed_columns(true)));
  if (first == "by_position")
    return measure_of_rows<PositionRow>(rest, &CurvesResult::by_position,
                                        cells_of("position_m", &PositionRow::position_m, curves::position_columns()));
  if (name == "notes")
    return [](const CurvesResult& r) -> Value {
      std::string list = "[";
      for (const std::string& note : r.notes) {
        if (list.size() > 1) list += ',';
        io::append_string(list, note);
      }
      return list + "]";
    };
  return std::nullopt;
}

std::vector<std::string> all_measures() {
  std::vector<std::string> all;
  for (const auto& c : curves::scalar_columns()) all.push_back(std::string("scalars.") + c.name);
  all.emplace_back("by_speed.v_kmh");
  for (const auto& c : curves::speed_columns(true)) all.push_back(std::string("by_speed.") + c.name);
  all.emplace_back("by_position.position_m");
  for (const auto& c : curves::position_columns()) all.push_back(std::string("by_position.") + c.name);
  all.emplace_back("notes");
  return all;
}

/// Members of a query: /query/train/... of `base` leads to the member train of the document.
bool is_member_of_document(const std::string& token) {
  constexpr const char* kMembers[] = {"train", "national_values", "fixed_values", "track", "target",
                                      "state", "query",           "srs",          "name"};
  return std::find(std::begin(kMembers), std::end(kMembers), token) != std::end(kMembers);
}

constexpr File kFilesOfQuery[] = {{"train", "trains"}, {"national_values", "national_values"}};

struct Memory final : Scratch {
  std::unique_ptr<sdm::Derived> derived = std::make_unique<sdm::Derived>();
};

class CurvesWork final : public Work {
 public:
  explicit CurvesWork(const Spec& spec) {
    load(spec);
    places_ =
        places_of(spec, [](const auto& tokens) { return tokens[0] == "query" && is_member_of_document(tokens[1]); });
    named_ = named_documents(spec, places_, kFilesOfQuery);
    const auto read = [](const JsonPlace& root) {
      if (const auto query = io::curves_of(root.value(), root.file()); !query) throw io::ReadError{query.error()};
    };
    require_places(spec, places_, document_, read, {});
    require_values(
        spec, places_, document_, named_, [&](const std::string&, const JsonPlace& root) { read(root); },
        [](const std::string&) { return Judged::form; });
    measures_ = chosen(spec, all_measures(), [](const std::string& name) { return measure_of(name).has_value(); });
    for (const std::string& name : measures_) {
      asked_.push_back(*measure_of(name));
      speeds_ = speeds_ || name.rfind("by_speed.", 0) == 0;
      positions_ = positions_ || name.rfind("by_position.", 0) == 0;
    }
  }

  std::string documents() const override {
    std::string documents = document_.dump();
    for (const auto& [name, named] : named_) documents += named.document.dump();
    return documents;
  }

  std::unique_ptr<Scratch> scratch() const override { return std::make_unique<Memory>(); }

  Outcome compute(const std::vector<Json>& values, Scratch& scratch) const override {
    Outcome outcome;
    outcome.measures.resize(measures_.size());
    auto input = io::curves_of(document_of(values), "");
    if (!input) {
      outcome.error = reason_of(input.error());
      return outcome;
    }
    // What is not asked for is not computed.
    if (!speeds_) input->speeds_kmh.clear();
    if (!positions_) input->positions_m.clear();
    input->PBD.clear();
    input->LX.clear();
    input->details = {};
    auto& memory = dynamic_cast<Memory&>(scratch);
    Approached approached(*std::move(input), std::move(memory.derived));
    const CurvesResult result = curves::curves_result(approached);
    memory.derived = std::move(approached).release();
    for (std::size_t i = 0; i < asked_.size(); ++i) outcome.measures[i] = asked_[i](result);
    return outcome;
  }

  io::Result<bool> record(const std::vector<Json>& values, const std::string& folder) const override {
    const Json document = document_of(values);
    auto input = io::curves_of(document, "");
    const std::string query = document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    if (const auto written = io::write_whole(folder + "/query.json", query); !written) return written;
    if (!input) return tl::unexpected(input.error());
    const CurvesResult result = curves::curves_result(Approached(*std::move(input)));
    return io::write_whole(folder + "/result.json", curves::curves_text(result, curves::Format::json));
  }

 private:
  void load(const Spec& spec) {
    const Json given{{"base", spec.base}};
    const JsonPlace base = JsonPlace(given, spec.file)["base"];
    base.know_only({"query"});
    const io::Named named = io::read_named(base["query"], "curves");
    auto document = io::curves_document(named.text, named.file.empty() ? spec.file : named.file);
    if (!document) throw io::ReadError{document.error()};
    document_ = *std::move(document);
    if (!document_.contains("national_values")) document_["national_values"] = Json::object();
    if (!document_.contains("fixed_values")) document_["fixed_values"] = Json::object();
    if (!document_.contains("state")) document_["state"] = Json::object();
    if (!document_.contains("srs")) document_["srs"] = "3.6.0";
  }

  /// The query of a case, with its files in place.
  Json document_of(const std::vector<Json>& values) const {
    Json document = document_;
    places_.put(document, values);
    for (const File& file : kFilesOfQuery) put_document(document, file.member, named_);
    return document;
  }

  Json document_;
  NamedDocuments named_;
  Places places_;
  std::vector<Measure> asked_;
  bool speeds_ = false, positions_ = false;
};

}  // namespace

std::unique_ptr<Work> make_curves_work(const Spec& spec) { return std::make_unique<CurvesWork>(spec); }

}  // namespace evc::sweep
