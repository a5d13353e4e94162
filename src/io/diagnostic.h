#pragma once
#include <string>
#include <tl/expected.hpp>

namespace evc::io {

/// What is wrong with an input and where, for one line on standard error (exit status 2).
struct Diagnostic {
  std::string file;      // file name; "-" for standard input
  std::string where;     // JSON pointer, "line 7", "line 7 /odometer/nominal_m", "bit 12"; may be empty
  std::string found;     // what stands there
  std::string expected;  // what the format wants there

  /// `FILE: WHERE: found X, expected Y`.
  std::string text() const;
};

template <class T>
using Result = tl::expected<T, Diagnostic>;

}  // namespace evc::io
