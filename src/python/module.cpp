#include <pybind11/pybind11.h>

#include "python/bind.h"
#include "python/interruption.h"
#include "python/values.h"

PYBIND11_MODULE(_native, module) {
  module.doc() = "What openevc computes, for the package openevc alone.";
  evc::python::translate_errors();
  evc::python::bind_on_board(module);
  evc::python::bind_journeys(module);
  evc::python::bind_curves(module);
  evc::python::bind_limits(module);
  evc::python::bind_language(module);
  evc::python::bind_sweep(module);
  module.attr("version") = EVC_VERSION;
  pybind11::module_::import("atexit").attr("register")(pybind11::cpp_function(&evc::python::ProcessEnd::come));
}
