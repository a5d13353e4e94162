#include <pybind11/numpy.h>

#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "curves/explain.h"
#include "curves/picture.h"
#include "curves/result.h"
#include "io/curves_file.h"
#include "io/file.h"
#include "io/named_document.h"
#include "python/bind.h"
#include "python/blank.h"
#include "python/interruption.h"
#include "python/values.h"

// `openevc.curves`: the answer of `evc curves` as arrays.
namespace evc::python {
namespace {

using curves::Approached;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// The vector becomes the memory of the array: it is not copied.
py::array_t<double> array_of(std::vector<double> values) {
  auto owned = std::make_unique<std::vector<double>>(std::move(values));
  const std::vector<double>& vector = *owned;
  const py::capsule owner(owned.get(), [](void* p) { delete static_cast<std::vector<double>*>(p); });
  (void)owned.release();
  return py::array_t<double>(static_cast<py::ssize_t>(vector.size()), vector.data(), owner);
}

/// Columns by name; where a value does not exist it is not a number.
template <class Row>
py::dict columns_of(const char* first, double Row::*at, const std::vector<Row>& rows,
                    const std::vector<curves::Column<Row>>& columns) {
  const auto column = [&rows](auto value) {
    std::vector<double> values;
    values.reserve(rows.size());
    for (const Row& row : rows) values.push_back(value(row));
    return array_of(std::move(values));
  };
  py::dict arrays;
  arrays[first] = column([at](const Row& row) { return row.*at; });
  for (const auto& c : columns)
    arrays[c.name] = column([&c](const Row& row) { return (row.*c.value).value_or(kNone); });
  return arrays;
}

py::list rows_of(const std::vector<curves::QueryRow>& rows) {
  py::list list;
  for (const curves::QueryRow& row : rows) {
    py::dict members;
    for (const auto& [name, value] : row) members[name] = value ? py::object(py::float_(*value)) : py::none();
    list.append(members);
  }
  return list;
}

/// The document `evc-curves/1` with the members that are given beside it.
io::Json document_of(const py::object& given, const py::dict& members) {
  std::string file = "curves";
  io::Json document = given.is_none() ? io::Json::object() : json_of(given, file);
  if (document.is_string()) {
    io::Json named{{"query", document}};
    file = io::put_named(named, "query", "curves", {named, file});
    document = value_of(io::curves_document(named["query"].dump(), file));
  }
  const io::Json more = json_of(members, file);
  if (document.is_object()) {
    if (!document.contains("schema")) document["schema"] = "evc-curves/1";
    document.update(more);
    io::put_named(document, "train", "trains", {document, file});
    io::put_named(document, "national_values", "national_values", {document, file});
  }
  return document;
}

class Curves : public Blank {
 public:
  Curves(const py::object& given, const py::dict& members)
      : Curves(value_of(io::curves_of(document_of(given, members), "curves"))) {}

  const curves::CurvesResult& result() const {
    require(approached_ != nullptr);
    return result_;
  }
  std::string json() const { return curves::curves_text(result(), curves::Format::json); }
  std::string explain(const py::object& v_kmh) const {
    require(approached_ != nullptr);
    const io::Json argument{{"v_kmh", json_of(v_kmh, "explain", "v_kmh")}};
    return curves::explain_text(*approached_, io::JsonPlace(argument, "explain")["v_kmh"].number(0.0, 600.0));
  }
  curves::Picture picture() const {
    require(approached_ != nullptr);
    return curves::picture_of(*approached_);
  }

 private:
  explicit Curves(io::CurvesInput input) {
    const Unlocked unlocked;
    approached_ = std::make_unique<Approached>(std::move(input));
    result_ = curves::curves_result(*approached_);
  }

  std::unique_ptr<Approached> approached_;
  curves::CurvesResult result_;
};

py::list steps_of(const std::vector<curves::Picture::Step>& steps) {
  py::list list;
  for (const auto& step : steps) list.append(py::make_tuple(step.from_m, step.value));
  return list;
}

/// What `evc curves --plot` draws.
py::dict dict_of(const curves::Picture& p) {
  py::list lines, marks;
  for (const curves::PictureCurve& c : p.curves)
    lines.append(py::dict(py::arg("key") = c.key, py::arg("name") = c.name, py::arg("colour") = c.stroke.colour,
                          py::arg("width") = c.stroke.width, py::arg("dash") = c.stroke.dash,
                          py::arg("v_kmh") = array_of(c.v)));
  for (const auto& mark : p.marks) marks.append(py::make_tuple(mark.x_m, mark.name));
  const auto or_none = [](const curves::Value& v) { return v ? py::object(py::float_(*v)) : py::none(); };
  return py::dict(py::arg("from_m") = p.from_m, py::arg("to_m") = p.to_m, py::arg("top_kmh") = p.top_kmh,
                  py::arg("x_m") = array_of(p.x_m), py::arg("curves") = lines, py::arg("marks") = marks,
                  py::arg("gradient") = steps_of(p.gradient), py::arg("V_release_kmh") = or_none(p.V_release_kmh),
                  py::arg("start_of_RSM_m") = or_none(p.start_of_RSM_m));
}

}  // namespace

void bind_curves(py::module_& module) {
  py::class_<Curves>(module, "Curves")
      .def(py::init<const py::object&, const py::dict&>())
      .def("by_speed",
           [](const Curves& c) {
             const curves::CurvesResult& r = c.result();
             return columns_of("v_kmh", &curves::SpeedRow::v_kmh, r.by_speed, curves::speed_columns(r.separate_EOA));
           })
      .def("by_position",
           [](const Curves& c) {
             return columns_of("position_m", &curves::PositionRow::position_m, c.result().by_position,
                               curves::position_columns());
           })
      .def("scalars",
           [](const Curves& c) {
             py::dict scalars;
             for (const auto& column : curves::scalar_columns()) {
               const curves::Value value = c.result().scalars.*column.value;
               scalars[column.name] = value ? py::object(py::float_(*value)) : py::none();
             }
             return scalars;
           })
      .def("PBD", [](const Curves& c) { return rows_of(c.result().PBD); })
      .def("LX", [](const Curves& c) { return rows_of(c.result().LX); })
      .def("notes",
           [](const Curves& c) {
             py::list notes;
             for (const std::string& note : c.result().notes) notes.append(note);
             return notes;
           })
      .def("json", &Curves::json)
      .def("explain", &Curves::explain)
      .def("picture", [](const Curves& c) { return dict_of(c.picture()); });
}

}  // namespace evc::python
