#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/diagnostic.h"

namespace evc::io {

/// A value that differs between two lines: its JSON pointer and both values ("nothing" where absent).
struct FieldDifference {
  std::string pointer;
  std::string a, b;
};

/// How two streams of JSON Lines differ.
struct StreamDifference {
  std::size_t line = 0;                 ///< the first line that differs, from 1
  std::optional<std::string> t_ms;      ///< the time of this line
  std::vector<FieldDifference> fields;  ///< of this line; empty when one stream ended or only the notation differs
  std::size_t lines_a = 0, lines_b = 0;
  std::size_t differing = 0;  ///< number of lines that differ, including those that only one stream has
};

/// Compares byte for byte; nothing when both are the same. An error when a differing line is not JSON.
Result<std::optional<StreamDifference>> difference(std::string_view a, const std::string& name_a, std::string_view b,
                                                   const std::string& name_b);

/// The difference as text, one line for each field.
std::string text_of(const StreamDifference& difference, const std::string& name_a, const std::string& name_b);

}  // namespace evc::io
