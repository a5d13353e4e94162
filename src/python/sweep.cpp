#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include "io/file.h"
#include "python/bind.h"
#include "python/interruption.h"
#include "python/values.h"
#include "sweep/plan.h"
#include "sweep/queue.h"

// `openevc.sweep`: the cases of a description, as those of `evc sweep`.
namespace evc::python {
namespace {

constexpr std::uint64_t kMostRows = 100'000'000;

py::object object_of_cell(const sweep::Value& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return py::int_(*whole);
  if (const auto* number = std::get_if<double>(&value)) return py::float_(*number);
  if (const auto* text = std::get_if<std::string>(&value)) return py::str(*text);
  return py::none();
}

/// Columns by name in the order of the table, each a list; the rows are in the order of their numbers.
py::dict columns_of(const sweep::Plan& plan, std::vector<sweep::Row> rows) {
  std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.number < b.number; });
  py::dict columns;
  const auto column = [&](const std::string& name, auto cell) {
    py::list list(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) list[i] = cell(rows[i]);
    columns[py::str(name)] = list;
  };
  column("number", [](const sweep::Row& row) { return py::int_(row.number); });
  for (std::size_t i = 0; i < plan.spec().vary.size(); ++i)
    column(plan.spec().vary[i].at, [i](const sweep::Row& row) { return object_of_cell(row.values[i]); });
  column("status", [](const sweep::Row& row) { return py::str(row.outcome.error.empty() ? "done" : "failed"); });
  column("error", [](const sweep::Row& row) {
    return row.outcome.error.empty() ? py::object(py::none()) : py::str(row.outcome.error);
  });
  for (std::size_t i = 0; i < plan.measures().size(); ++i)
    column(plan.measures()[i], [i](const sweep::Row& row) { return object_of_cell(row.outcome.measures[i]); });
  return columns;
}

py::dict run_sweep(const py::object& spec, const py::object& wanted_threads) {
  std::string file = "spec";
  const io::Json document = json_of(spec, file);
  std::string text;
  if (document.is_string()) {
    file = document.get<std::string>();
    text = value_of(io::read_text(file));
  } else {
    text = document.dump(-1, ' ', false, io::Json::error_handler_t::replace);
  }
  const std::int64_t threads = Argument(wanted_threads, "sweep", "threads").place().integer(0, 1024);
  const auto plan = value_of(sweep::Plan::make(text, file));
  const std::uint64_t cases = plan->spec().cases;
  if (cases > kMostRows)
    throw io::ReadError{{file, "", std::to_string(cases) + " cases",
                         "at most " + std::to_string(kMostRows) + "; `evc sweep` stores more in a file"}};
  const auto wanted = threads > 0 ? static_cast<unsigned>(threads) : std::max(1u, std::thread::hardware_concurrency());
  Interruption interruption;
  std::vector<sweep::Row> all;
  {
    Unlocked unlocked;
    sweep::Todo todo({{0, cases}});
    const auto most = static_cast<unsigned>(std::min<std::uint64_t>(cases, wanted));
    sweep::compute(*plan, todo, std::max(1u, most), [&](std::vector<sweep::Row>&& rows) {
      for (sweep::Row& row : rows) all.push_back(std::move(row));
      return !interruption.seen(unlocked);
    });
  }
  return py::dict(py::arg("columns") = columns_of(*plan, std::move(all)), py::arg("cases") = cases,
                  py::arg("interruption") = interruption.error());
}

}  // namespace

void bind_sweep(py::module_& module) { module.def("sweep", run_sweep); }

}  // namespace evc::python
