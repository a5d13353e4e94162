#include "io/diagnostic.h"

namespace evc::io {
namespace {

/// One line for any input: control characters become spaces, long texts are cut.
std::string one_line(const std::string& text) {
  constexpr std::size_t longest = 200;
  std::string line;
  for (const char c : text) {
    if (line.size() >= longest) return line + "...";
    const auto u = static_cast<unsigned char>(c);
    line += u < 0x20 || u == 0x7f ? ' ' : c;
  }
  return line;
}

}  // namespace

std::string Diagnostic::text() const {
  std::string line = one_line(file);
  if (!where.empty()) line += ": " + one_line(where);
  if (!found.empty()) line += ": found " + one_line(found);
  if (!expected.empty()) line += (found.empty() ? ": expected " : ", expected ") + one_line(expected);
  return line;
}

}  // namespace evc::io
