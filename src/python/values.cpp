#include "python/values.h"

#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace evc::python {
namespace {

using io::Json;

/// The way from the document to a value in it.
struct Way {
  const Way* up = nullptr;
  std::string_view key;
  std::size_t index = 0;
  bool is_index = false;

  std::string pointer() const {
    const std::string before = up != nullptr ? up->pointer() : "";
    if (up == nullptr && key.empty() && !is_index) return before;
    return before + "/" + (is_index ? std::to_string(index) : io::reference_token(key));
  }
};

std::string type_of(py::handle value) { return "a value of type " + std::string(Py_TYPE(value.ptr())->tp_name); }

class Converter {
 public:
  Converter(const std::string& file, const std::string& place) : file_(file), place_(place) {}

  Json of(py::handle value, const Way& way, std::size_t depth) const {
    if (depth > io::kDeepestJson)
      fail(way, "more than " + std::to_string(io::kDeepestJson) + " values in one another", "fewer");
    PyObject* const p = value.ptr();
    if (value.is_none()) return nullptr;
    if (PyBool_Check(p)) return value.ptr() == Py_True;
    if (PyLong_Check(p)) return whole(value, way);
    if (PyFloat_Check(p)) return number(PyFloat_AS_DOUBLE(p), way);
    if (PyUnicode_Check(p)) return std::string(text(value, way));
    if (PyDict_Check(p)) return members(py::reinterpret_borrow<py::dict>(value), way, depth);
    if (PyList_Check(p) || PyTuple_Check(p)) return elements(value, way, depth);
    return of_another(value, way, depth);
  }

 private:
  [[noreturn]] void fail(const Way& way, std::string found, std::string expected) const {
    std::string where = way.pointer();
    if (where.empty()) where = "/";
    if (!place_.empty()) where = place_ + " " + where;
    throw io::ReadError{{file_, where, std::move(found), std::move(expected)}};
  }

  Json whole(py::handle value, const Way& way) const {
    int overflow = 0;
    const long long small = PyLong_AsLongLongAndOverflow(value.ptr(), &overflow);
    // As the parser of JSON has them: what is not negative has no sign.
    if (overflow == 0 && small >= 0) return static_cast<std::uint64_t>(small);
    if (overflow == 0) return static_cast<std::int64_t>(small);
    if (overflow > 0) {
      const unsigned long long large = PyLong_AsUnsignedLongLong(value.ptr());
      if (PyErr_Occurred() == nullptr) return static_cast<std::uint64_t>(large);
      PyErr_Clear();
    }
    fail(way, "an integer beyond 64 bits", "a smaller one");
  }

  Json number(double value, const Way& way) const {
    if (!std::isfinite(value)) fail(way, std::isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf", "a finite number");
    return value;
  }

  std::string_view text(py::handle value, const Way& way) const {
    Py_ssize_t size = 0;
    const char* const bytes = PyUnicode_AsUTF8AndSize(value.ptr(), &size);
    if (bytes == nullptr) {
      PyErr_Clear();
      fail(way, "a text with half a character", "Unicode");
    }
    return {bytes, static_cast<std::size_t>(size)};
  }

  Json members(const py::dict& dict, const Way& way, std::size_t depth) const {
    Json object = Json::object();
    // A copy of the references: converting a value may run code that changes the dictionary.
    const py::list items = dict.attr("items")().cast<py::list>();
    for (const py::handle item : items) {
      const py::tuple pair = py::reinterpret_borrow<py::tuple>(item);
      const py::object key = pair[0];
      if (!PyUnicode_Check(key.ptr())) fail(way, "a key that is " + type_of(key), "a text");
      const std::string_view name = text(key, way);
      object[std::string(name)] = of(pair[1], {&way, name}, depth + 1);
    }
    return object;
  }

  Json elements(py::handle list, const Way& way, std::size_t depth) const {
    Json array = Json::array();
    const py::sequence sequence = py::reinterpret_borrow<py::sequence>(list);
    for (std::size_t i = 0; i < sequence.size(); ++i) {
      const py::object element = sequence[i];
      array.push_back(of(element, {&way, {}, i, true}, depth + 1));
    }
    return array;
  }

  /// The letter of NumPy for what an array holds; empty for what is no array.
  static std::string kind_of(py::handle value) {
    if (!py::hasattr(value, "dtype") || !py::hasattr(value.attr("dtype"), "kind")) return "";
    return py::str(value.attr("dtype").attr("kind"));
  }
  static bool is_masked(py::handle value) {
    const py::module_ masked_arrays = py::module_::import("numpy.ma");
    if (!py::isinstance(value, masked_arrays.attr("MaskedArray"))) return false;
    // With fields the mask has fields too, as bytes of 0 and 1.
    const auto bits = masked_arrays.attr("getmaskarray")(value).attr("tobytes")().cast<std::string>();
    return bits.find('\1') != std::string::npos;
  }

  /// Arrays and numbers of NumPy, mappings, names of files.
  Json of_another(py::handle value, const Way& way, std::size_t depth) const {
    if (py::hasattr(value, "tolist")) {
      const std::string kind = kind_of(value);
      // As plain values a masked one would be None, and a time a number of its units.
      if (is_masked(value)) fail(way, "masked values", "values without a mask");
      if (kind == "m" || kind == "M") fail(way, type_of(value) + " with times", "numbers");
      const py::object plain = value.attr("tolist")();
      if (Py_TYPE(plain.ptr()) != Py_TYPE(value.ptr())) return of(plain, way, depth + 1);
      // A number with more digits than a double stays what it is.
      if (kind == "f") return number(py::float_(py::reinterpret_borrow<py::object>(value)), way);
    }
    if (py::hasattr(value, "__fspath__")) return of(value.attr("__fspath__")(), way, depth + 1);
    if (py::hasattr(value, "keys") && py::hasattr(value, "__getitem__"))
      return members(py::dict(py::reinterpret_borrow<py::object>(value)), way, depth);
    fail(way, type_of(value), "None, a number, a text, a list or a dictionary");
  }

  const std::string& file_;
  const std::string& place_;
};

/// An instance of openevc.InputError with what the error is about, as the exception that is set.
void raise(const std::string& sentence, const py::dict& members) {
  const py::object error = py::module_::import("openevc._errors").attr("InputError")(sentence);
  for (const auto& [name, value] : members) py::setattr(error, name, value);
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(error.ptr())), error.ptr());
}

void raise(const io::Diagnostic& d) {
  raise(d.text(), py::dict(py::arg("file") = io::printable(d.file), py::arg("where") = io::printable(d.where),
                           py::arg("found") = io::printable(d.found), py::arg("expected") = io::printable(d.expected)));
}

void raise(const io::TelegramError& e) {
  const auto or_none = [](const auto& value, bool given) { return given ? py::object(py::cast(value)) : py::none(); };
  raise(io::error_json(e), py::dict(py::arg("bit") = e.bit, py::arg("packet") = or_none(e.packet, e.packet >= 0),
                                    py::arg("variable") = or_none(io::printable(e.variable), !e.variable.empty()),
                                    py::arg("value") = or_none(e.value.value_or(0), e.value.has_value()),
                                    py::arg("found") = io::printable(e.why)));
}

}  // namespace

Json json_of(py::handle value, const std::string& file) {
  const std::string nowhere;
  return Converter(file, nowhere).of(value, {}, 0);
}

Json json_of(py::handle value, const std::string& file, std::string_view key, const std::string& place) {
  const Way root;
  return Converter(file, place).of(value, {&root, key}, 1);
}

Argument::Argument(py::handle value, std::string from, std::string name)
    : document_{{name, json_of(value, from, name)}}, from_(std::move(from)), name_(std::move(name)) {}

py::object object_of(const std::string& json) { return py::module_::import("json").attr("loads")(json); }

void translate_errors() {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(std::move(thrown));
    } catch (const io::ReadError& e) {
      raise(e.diagnostic);
    } catch (const LanguageError& e) {
      raise(e.error);
    }
  });
}

}  // namespace evc::python
