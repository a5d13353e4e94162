#pragma once
#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstring>
#include <new>

namespace evc::python {

/// Base of the classes that Python sees. `Class.__new__(Class)` gives an object without a constructor, for which
/// pybind11 takes memory when it is used: of such a class it is filled with zeros, so that its members see that they
/// are not made.
struct Blank {
  static void* operator new(std::size_t size) { return std::memset(::operator new(size), 0, size); }
  static void operator delete(void* memory) { ::operator delete(memory); }

  /// Throws TypeError unless `made`.
  static void require(bool made) {
    if (!made) throw pybind11::type_error("__init__() was not called");
  }
};

}  // namespace evc::python
