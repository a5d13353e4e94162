#pragma once
#include <pybind11/pybind11.h>

#include <string>
#include <string_view>

#include "io/json.h"
#include "io/telegram_json.h"

// Values of Python as the JSON that the readers of io take, and what they give as values of Python.
namespace evc::python {

namespace py = pybind11;

/// A value of Python as JSON: None, numbers, texts, lists, tuples, dictionaries and other mappings, arrays and numbers
/// of NumPy, names of files. `file` and the place in it are named by the error where it has something that JSON does
/// not have. Throws io::ReadError.
io::Json json_of(py::handle value, const std::string& file);
/// One of several values that make one document: `key` is its member. `place`: where in the file the document is.
io::Json json_of(py::handle value, const std::string& file, std::string_view key, const std::string& place = "");

/// An argument of a function, read as a member of a document is, so that what is of another type is refused with
/// "sweep: /threads: found 2.5, expected an integer from 0 to 1024". Of Python or of NumPy.
class Argument {
 public:
  /// `from`: the function, or what else the error names. Throws io::ReadError.
  Argument(py::handle value, std::string from, std::string name);
  io::JsonPlace place() const { return io::JsonPlace(document_, from_)[name_]; }

 private:
  io::Json document_;
  std::string from_, name_;
};

/// The text of JSON as dictionaries and lists, in the order of the text.
py::object object_of(const std::string& json);

/// The value of a result; its error becomes an InputError.
template <class T>
T value_of(io::Result<T> result) {
  if (!result) throw io::ReadError{std::move(result.error())};
  return *std::move(result);
}

/// An error of the ETCS language: what `evc decode` and `evc encode` print.
struct LanguageError {
  io::TelegramError error;
};

/// From now on the errors of readers are exceptions of Python: openevc.InputError.
void translate_errors();

}  // namespace evc::python
