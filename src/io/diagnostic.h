#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>

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

/// A text from outside as one line of UTF-8 that a terminal only shows: control characters become spaces, bytes that
/// are no character are written as \xNN, and what is longer than `longest` bytes is cut.
std::string printable(std::string_view text, std::size_t longest = std::string_view::npos);

/// Prints an error on standard error, in one line. Returns the exit status, 2.
int complain(const Diagnostic& diagnostic);

template <class T>
using Result = tl::expected<T, Diagnostic>;

/// Thrown inside the readers of io only; `guarded` turns it into a Result.
struct ReadError {
  Diagnostic diagnostic;
};

#if defined(__cpp_exceptions)  // WebAssembly has the writers of this room only
/// Runs a reader; an exception becomes the error of the Result.
template <class F>
auto guarded(F&& read) -> Result<decltype(read())> {
  try {
    return read();
  } catch (ReadError& e) {
    return tl::unexpected(std::move(e.diagnostic));
  }
}
#endif

}  // namespace evc::io
