#pragma once
#include <string>
#include <tl/expected.hpp>

namespace evc::io {

/// An error of an input and its place, for one line on standard error (exit status 2).
struct Diagnostic {
  std::string file;      // file name; "-" for standard input
  std::string where;     // JSON pointer, "line 7", "line 7 /odometer/nominal_m", "bit 12"; may be empty
  std::string found;     // the text found there
  std::string expected;  // what the format expects there

  /// `FILE: WHERE: found X, expected Y`.
  std::string text() const;
};

template <class T>
using Result = tl::expected<T, Diagnostic>;

}  // namespace evc::io
