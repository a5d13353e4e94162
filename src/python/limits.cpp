#include <pybind11/numpy.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "batch/limits.h"
#include "curves/batch_queries.h"
#include "io/curves_file.h"
#include "io/named_document.h"
#include "python/bind.h"
#include "python/interruption.h"
#include "python/values.h"

// `openevc.limits`: limits of many trains, speeds and targets, with the broadcasting of NumPy.
namespace evc::python {
namespace {

constexpr double kHighest_kmh = 600.0;
/// Cases computed without looking for a signal: few enough for the cache, and to be done within a few milliseconds.
constexpr std::size_t kLargestBlock = 8192;

struct Column {
  const char* name;
  std::span<double> batch::LimitsOut::*out;
};
using Out = batch::LimitsOut;
constexpr std::array<Column, 16> kColumns{{{"EBD", &Out::EBD},
                                           {"SBD", &Out::SBD},
                                           {"GUI", &Out::GUI},
                                           {"EBI", &Out::EBI},
                                           {"SBI1", &Out::SBI1},
                                           {"SBI2", &Out::SBI2},
                                           {"FLOI", &Out::FLOI},
                                           {"W", &Out::W},
                                           {"P", &Out::P},
                                           {"I", &Out::I},
                                           {"W_EOA", &Out::W_EOA},
                                           {"P_EOA", &Out::P_EOA},
                                           {"I_EOA", &Out::I_EOA},
                                           {"W_SvL", &Out::W_SvL},
                                           {"P_SvL", &Out::P_SvL},
                                           {"I_SvL", &Out::I_SvL}}};

/// An array of the broadcast, read element by element: its strides are 0 where it is repeated.
template <class T>
class Element {
 public:
  explicit Element(const py::array_t<T>& array)
      : at_(reinterpret_cast<const char*>(array.data())), strides_(array.strides(), array.strides() + array.ndim()) {}
  /// Calls `f(i, value)` with the `count` values from here on in the last dimension, and stays where it is.
  template <class F>
  void row(std::size_t count, F f) const {
    const char* at = at_;
    const py::ssize_t stride = strides_.empty() ? 0 : strides_.back();
    for (std::size_t i = 0; i < count; ++i, at += stride) {
      T value;
      std::memcpy(&value, at, sizeof value);
      f(i, value);
    }
  }
  void step(std::size_t dimension, py::ssize_t count) { at_ += strides_[dimension] * count; }

 private:
  const char* at_;
  std::vector<py::ssize_t> strides_;
};

/// The cases in the order of the memory of the results.
class Cursor {
 public:
  Cursor(const py::array_t<std::uint32_t>& train, const py::array_t<double>& speed,
         const py::array_t<std::uint32_t>& target)
      : train_(train),
        target_(target),
        speed_(speed),
        shape_(speed.shape(), speed.shape() + speed.ndim()),
        index_(shape_.size(), 0) {}

  void take(std::span<std::uint32_t> train, std::span<std::uint32_t> target, std::span<double> V) {
    for (std::size_t first = 0; first < V.size();) {
      const std::size_t left = shape_.empty() ? 1 : static_cast<std::size_t>(shape_.back() - index_.back());
      const std::size_t row = std::min(V.size() - first, left);
      train_.row(row, [&](std::size_t i, std::uint32_t number) { train[first + i] = number; });
      target_.row(row, [&](std::size_t i, std::uint32_t number) { target[first + i] = number; });
      speed_.row(row, [&](std::size_t i, double V_kmh) { V[first + i] = V_kmh / kKmh; });
      advance(static_cast<py::ssize_t>(row));
      first += row;
    }
  }

 private:
  void step(std::size_t dimension, py::ssize_t count) {
    train_.step(dimension, count);
    target_.step(dimension, count);
    speed_.step(dimension, count);
  }
  /// By so many cases of the last dimension, at most to its end.
  void advance(py::ssize_t count) {
    for (std::size_t d = shape_.size(); d-- > 0; count = 1) {
      step(d, count);
      if ((index_[d] += count) < shape_[d]) return;
      step(d, -shape_[d]);
      index_[d] = 0;
    }
  }

  Element<std::uint32_t> train_, target_;
  Element<double> speed_;
  std::vector<py::ssize_t> shape_, index_;
};

/// Different objects of an array of objects, and for each element the number of its one.
py::tuple table_of(const py::array& objects) {
  if (objects.dtype().kind() != 'O' || (objects.flags() & py::array::c_style) == 0)
    throw py::type_error("a contiguous array of objects");
  const auto count = static_cast<std::size_t>(objects.size());
  py::array_t<std::uint32_t> numbers(objects.size());
  std::uint32_t* const number = numbers.mutable_data();
  std::unordered_map<PyObject*, std::uint32_t> known;
  // Of the last object with each hash.
  struct Seen {
    PyObject* object;
    std::uint32_t number;
  };
  std::array<Seen, 1024> seen;
  seen.fill({reinterpret_cast<PyObject*>(&seen), 0});
  py::list different;
  PyObject* const* const object = static_cast<PyObject* const*>(objects.data());
  for (std::size_t i = 0; i < count; ++i) {
    const auto bits = static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(object[i]));
    Seen& last = seen[bits * 0x9e3779b97f4a7c15u >> 54];
    if (last.object == object[i]) {
      number[i] = last.number;
      continue;
    }
    const auto [entry, is_new] = known.try_emplace(object[i], static_cast<std::uint32_t>(known.size()));
    if (is_new) different.append(py::reinterpret_borrow<py::object>(object[i] != nullptr ? object[i] : Py_None));
    number[i] = entry->second;
    last = {object[i], entry->second};
  }
  return py::make_tuple(different, numbers);
}

/// One query for each train and each target: what is common to all, and the train or target.
io::CurvesInput read_query(io::Json document, const std::string& file) {
  document["schema"] = "evc-curves/1";
  const std::string train_file = io::put_named(document, "train", "trains", {document, file});
  io::put_named(document, "national_values", "national_values", {document, file});
  return value_of(io::curves_of(document, train_file.empty() ? file : train_file));
}

std::string place_of(const char* what, std::size_t number) {
  return std::string(what) + "[" + std::to_string(number) + "]";
}

batch::Trains trains_of(const py::list& trains, const io::Json& common, double highest_kmh) {
  batch::Trains table;
  for (std::size_t i = 0; i < trains.size(); ++i) {
    const std::string name = place_of("trains", i);
    io::Json document = common;
    const io::Json train = json_of(trains[i], "limits", "train", name);
    document["train"] = train;
    document["target"] = {{"type", "EOA_SvL"}, {"location_m", 0}};
    document["query"] = {{"speeds_kmh", {highest_kmh}}};
    const io::CurvesInput input = read_query(std::move(document), "limits: " + name);
    if (input.assumed.V_ura_of_041)
      throw io::ReadError{{"limits", "/state/V_ura_kmh", "\"f41\"", "a number: f41 is for curves"}};
    if (input.assumed.brake_pressure)
      throw io::ReadError{{"limits", "/state/service_brake_feedback", "a state", "none: it is for curves"}};
    (void)table.add(input.inputs, {input.V_ura, input.A_est, input.motion});
  }
  return table;
}

std::vector<batch::Target> targets_of(const py::list& targets) {
  std::vector<batch::Target> table;
  table.reserve(targets.size());
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const std::string name = place_of("targets", i);
    // Where every restriction is lower than the speed before it: the target alone is read.
    table.push_back(curves::batch_target(read_query({{"train", io::Json::object()},
                                                     {"track", {{"mrsp", {{-1e7, kHighest_kmh}}}}},
                                                     {"target", json_of(targets[i], "limits", "target", name)},
                                                     {"query", {{"speeds_kmh", {0.0}}}}},
                                                    "limits: " + name)));
  }
  return table;
}

bool same_shape(const py::array& a, const py::array& b) {
  return std::equal(a.shape(), a.shape() + a.ndim(), b.shape(), b.shape() + b.ndim());
}

/// Columns to compute, with their arrays: of the shape of the broadcast, contiguous.
std::vector<std::pair<Column, std::span<double>>> columns_of(const py::dict& out, std::size_t count) {
  std::vector<std::pair<Column, std::span<double>>> columns;
  for (const auto& [key, value] : out) {
    const auto name = key.cast<std::string>();
    const auto column = std::find_if(kColumns.begin(), kColumns.end(), [&](const Column& c) { return c.name == name; });
    if (column == kColumns.end()) throw py::key_error(name);
    if (!py::isinstance<py::array_t<double, py::array::c_style>>(value)) throw py::type_error(name);
    auto array = py::reinterpret_borrow<py::array_t<double>>(value);
    if (static_cast<std::size_t>(array.size()) != count) throw py::value_error(name);
    columns.emplace_back(*column, std::span<double>(array.mutable_data(), count));
  }
  return columns;
}

/// Computes blocks until all cases are done or a signal ends it; returns how many are done.
std::size_t compute(const batch::Trains& trains, std::span<const batch::Target> targets, Cursor& cursor,
                    std::size_t count, const std::vector<std::pair<Column, std::span<double>>>& columns,
                    Interruption& interruption, Unlocked& unlocked) {
  using Clock = std::chrono::steady_clock;
  std::vector<std::uint32_t> train(kLargestBlock), target(kLargestBlock);
  std::vector<double> V(kLargestBlock);
  std::size_t done = 0;
  // Some trains are a hundred times slower than others: the first block is small.
  for (std::size_t size = 64; done < count && !interruption.seen(unlocked);) {
    const auto begin = Clock::now();
    const std::size_t block = std::min(size, count - done);
    cursor.take({train.data(), block}, {target.data(), block}, {V.data(), block});
    batch::LimitsOut out;
    for (const auto& [column, values] : columns) out.*column.out = values.subspan(done, block);
    batch::limits(trains, targets, {{train.data(), block}, {target.data(), block}, {V.data(), block}}, out);
    done += block;
    const bool fast = Clock::now() - begin < std::chrono::milliseconds(5);
    size = fast ? std::min(2 * size, kLargestBlock) : std::max<std::size_t>(size / 2, 1);
  }
  return done;
}

/// `speeds` (km/h, from 0 to `highest_kmh`) and the numbers of trains and targets have the shape of the broadcast; so
/// have the arrays of `out`. `common`: members of the query of each train. Returns how many cases are done, in the
/// order of the memory, and the exception of a signal.
py::tuple limits(const py::list& trains, const py::array_t<std::uint32_t>& train_numbers,
                 const py::array_t<double>& speeds, const py::list& targets,
                 const py::array_t<std::uint32_t>& target_numbers, const py::dict& common, const py::dict& out,
                 double highest_kmh) {
  if (!same_shape(train_numbers, speeds) || !same_shape(target_numbers, speeds))
    throw py::value_error("arrays of different shapes");
  const auto count = static_cast<std::size_t>(speeds.size());
  const auto columns = columns_of(out, count);
  const batch::Trains train_table = trains_of(trains, json_of(common, "limits"), highest_kmh);
  const std::vector<batch::Target> target_table = targets_of(targets);
  Cursor cursor(train_numbers, speeds, target_numbers);
  Interruption interruption;
  std::size_t done = 0;
  {
    Unlocked unlocked;
    done = compute(train_table, target_table, cursor, count, columns, interruption, unlocked);
  }
  return py::make_tuple(done, interruption.error());
}

}  // namespace

void bind_limits(py::module_& module) {
  module.def("table", table_of);
  module.def("limits", limits);
  py::list names;
  for (const Column& column : kColumns) names.append(column.name);
  module.attr("limit_names") = py::tuple(names);
}

}  // namespace evc::python
