#include "sweep/spec.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace evc::sweep {
namespace {

using io::Json;
using io::JsonPlace;

constexpr std::size_t kMostValues = 1'000'000;  // of a list or range
constexpr std::size_t kMostMeasures = 500;
constexpr double kLargest = 1e15;

bool is_pointer(const std::string& text) {
  if (text.empty() || text.front() != '/') return false;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '~' && (i + 1 == text.size() || (text[i + 1] != '0' && text[i + 1] != '1'))) return false;
  return true;
}

void read_range(Entry& entry, const JsonPlace& place) {
  if (place.size() != 3) place.fail("[from, to, step]");
  const double from = place[0].number(-kLargest, kLargest);
  const double to = place[1].number(from, kLargest);
  const double step = place[2].number(0.0, kLargest);
  if (!(step > 0.0)) place[2].fail("a step above 0");
  // Of the last step a billionth may be missing: 0.1 is no binary number.
  const double steps = std::floor((to - from) / step + 1e-9);
  if (!(steps < static_cast<double>(kMostValues)))
    place[2].fail("a step that gives at most " + std::to_string(kMostValues) + " values");
  const bool whole = place[0].value().is_number_integer() && place[2].value().is_number_integer();
  for (std::size_t i = 0; i <= static_cast<std::size_t>(steps); ++i) {
    const double value = std::min(from + static_cast<double>(i) * step, to);
    entry.list.push_back(whole ? Json(static_cast<std::int64_t>(value)) : Json(value));
  }
}

void read_values(Entry& entry, const JsonPlace& place) {
  if (const auto list = place.find("list")) {
    if (!list->is_array()) list->fail("a list of values");
    if (list->size() == 0) list->fail("an empty list", "at least one value");
    if (list->size() > kMostValues) list->fail("at most " + std::to_string(kMostValues) + " values");
    entry.list = list->value().get<std::vector<Json>>();
  } else if (const auto range = place.find("range")) {
    read_range(entry, *range);
  } else if (const auto uniform = place.find("uniform")) {
    entry.how = Entry::How::uniform;
    if (uniform->size() != 2) uniform->fail("[from, to]");
    entry.first = (*uniform)[0].number(-kLargest, kLargest);
    entry.second = (*uniform)[1].number(entry.first, kLargest);
  } else if (const auto normal = place.find("normal")) {
    entry.how = Entry::How::normal;
    if (normal->size() != 2) normal->fail("[mean, deviation]");
    entry.first = (*normal)[0].number(-kLargest, kLargest);
    entry.second = (*normal)[1].number(0.0, kLargest);
  } else if (const auto count = place.find("count")) {
    entry.how = Entry::How::count;
    entry.count = static_cast<std::uint64_t>(count->integer(1, static_cast<std::int64_t>(kMostCases)));
  } else {
    place.fail("no values", "one of list, range, uniform, normal, count");
  }
}

/// Whether one pointer leads to the other's place or below it.
bool overlap(const std::string& a, const std::string& b) {
  const std::string& shorter = a.size() < b.size() ? a : b;
  const std::string& longer = a.size() < b.size() ? b : a;
  return longer.compare(0, shorter.size(), shorter) == 0 &&
         (longer.size() == shorter.size() || longer[shorter.size()] == '/');
}

/// Names of columns are the same for SQLite when only the case of their letters differs.
std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

Entry read_entry(const JsonPlace& place, const std::vector<Entry>& before) {
  place.know_only({"at", "list", "range", "uniform", "normal", "count"});
  Entry entry;
  entry.place = before.size();
  const JsonPlace at = place["at"];
  entry.at = at.string();
  if (!is_pointer(entry.at)) at.fail("a JSON pointer, such as /train/length_m");
  // It says how the document is read: with another one no case can be.
  if ((entry.at + '/').find("/schema/") != std::string::npos) at.fail("a place other than a schema");
  // The members that are missing on the way are made: as deep as a document may be, and no deeper.
  if (static_cast<std::size_t>(std::count(entry.at.begin(), entry.at.end(), '/')) > io::kDeepestJson)
    at.fail("a place of at most " + std::to_string(io::kDeepestJson) + " levels");
  for (const Entry& other : before)
    if (overlap(lower(entry.at), lower(other.at))) at.fail("a place that no other entry replaces");
  int given = 0;
  for (const char* key : {"list", "range", "uniform", "normal", "count"}) given += place.find(key) ? 1 : 0;
  if (given > 1) place.fail(std::to_string(given) + " kinds of values", "one of list, range, uniform, normal, count");
  read_values(entry, place);
  return entry;
}

void read_measures(Spec& spec, const JsonPlace& place) {
  if (!place.is_array() || place.size() == 0) place.fail("a list of names, or no key \"measure\" for all");
  if (place.size() > kMostMeasures) place.fail("at most " + std::to_string(kMostMeasures) + " measures");
  for (std::size_t i = 0; i < place.size(); ++i) {
    const std::string& name = place[i].string();
    if (name.empty()) place[i].fail("the name of a measure");
    for (const std::string& other : spec.measure)
      if (lower(other) == lower(name)) place[i].fail("each measure once");
    spec.measure.push_back(name);
  }
}

/// All combinations.
std::uint64_t size_of_grid(const Spec& spec, const JsonPlace& root) {
  std::uint64_t cases = 1;
  for (const Entry& entry : spec.vary) {
    if (entry.choices() > kMostCases / cases)
      root["vary"].fail("more than " + std::to_string(kMostCases) + " combinations", "at most that many");
    cases *= entry.choices();
  }
  return cases;
}

Spec read(const Json& document, const std::string& file) {
  const JsonPlace root(document, file);
  root.require_schema("evc-sweep/1");
  root.know_only({"schema", "name", "kind", "base", "vary", "sample", "cases", "seed", "measure"});
  Spec spec;
  spec.file = file;
  spec.text = document.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (const auto p = root.find("name")) (void)p->string();
  spec.kind = static_cast<Kind>(root["kind"].one_of({"run", "curves", "replay"}));
  if (const auto p = root.find("base")) {
    if (!p->is_object()) p->fail("an object");
    spec.base = p->value();
  }
  const JsonPlace vary = root["vary"];
  if (!vary.is_array()) vary.fail("a list of what varies");
  if (vary.size() == 0) vary.fail("an empty list", "at least one value that varies");
  if (vary.size() > kMostEntries) vary.fail("at most " + std::to_string(kMostEntries) + " entries");
  for (std::size_t i = 0; i < vary.size(); ++i) spec.vary.push_back(read_entry(vary[i], spec.vary));
  if (const auto p = root.find("sample")) spec.sample = static_cast<Sample>(p->one_of({"grid", "random", "sobol"}));
  if (const auto p = root.find("seed")) spec.seed = static_cast<std::uint64_t>(p->integer(0, INT64_MAX));
  const auto cases = root.find("cases");
  if (spec.sample == Sample::grid) {
    if (cases) cases->fail("no \"cases\" with the sample \"grid\": it has all combinations");
    spec.cases = size_of_grid(spec, root);
  } else {
    spec.cases = static_cast<std::uint64_t>(root["cases"].integer(1, static_cast<std::int64_t>(kMostCases)));
  }
  if (const auto p = root.find("measure")) read_measures(spec, *p);
  return spec;
}

}  // namespace

std::uint64_t Entry::choices() const {
  switch (how) {
    case How::list:
      return list.size();
    case How::count:
      return count;
    default:
      return 1;
  }
}

io::Result<Spec> read_spec(std::string_view text, const std::string& file) {
  return io::guarded([&] { return read(io::parse_json(text, file), file); });
}

}  // namespace evc::sweep
