#pragma once
#include <pybind11/pybind11.h>

// The parts of the module, each of a source of its own. What is given to Python here is for the package `openevc`
// (python/openevc), which gives it names, defaults and documentation.
namespace evc::python {

void bind_on_board(pybind11::module_& module);
void bind_journeys(pybind11::module_& module);
void bind_curves(pybind11::module_& module);
void bind_limits(pybind11::module_& module);
void bind_language(pybind11::module_& module);
void bind_sweep(pybind11::module_& module);

}  // namespace evc::python
