#pragma once
#include <pybind11/pybind11.h>

#include <chrono>

namespace evc::python {

/// Lets Python act on signals (Ctrl-C) while a long computation runs without its lock: `seen` takes the lock from time
/// to time. What a signal's handler threw is kept until the computation has left its results whole.
class Interruption {
 public:
  /// Whether the computation is to end. To be asked often: it looks ten times a second at most. The caller does not
  /// have the lock.
  bool seen() {
    if (error_) return true;
    const auto now = Clock::now();
    if (now - looked_ < kEvery) return false;
    looked_ = now;
    const pybind11::gil_scoped_acquire locked;
    if (PyErr_CheckSignals() == 0) return false;
    PyObject *type = nullptr, *value = nullptr, *trace = nullptr;
    PyErr_Fetch(&type, &value, &trace);
    PyErr_NormalizeException(&type, &value, &trace);
    if (trace != nullptr) PyException_SetTraceback(value, trace);
    Py_XDECREF(type);
    Py_XDECREF(trace);
    error_ = pybind11::reinterpret_steal<pybind11::object>(value);
    return true;
  }
  /// The exception of the handler; None where there was no signal. With the lock.
  pybind11::object error() const { return error_ ? error_ : pybind11::object(pybind11::none()); }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kEvery{100};
  Clock::time_point looked_ = Clock::now();
  pybind11::object error_;
};

}  // namespace evc::python
