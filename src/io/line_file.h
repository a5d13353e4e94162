#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "io/json.h"
#include "sim/line.h"
#include "terms/level.h"

namespace evc::io {

/// Reads `etcs-line/1`. Unknown keys are allowed in this schema only. A file in which no group has bits is rejected.
Result<sim::Line> read_line(std::string_view text, const std::string& file);
/// The same from a place in a larger document. Throws ReadError.
sim::Line read_line(const JsonPlace& root);

/// `start` of a line or of its description: what is given there.
struct LineStart {
  std::optional<double> front_m;
  std::optional<Level> level;
  std::optional<std::uint8_t> nid_ntc;
};
/// Throws ReadError. Unknown keys are ignored.
LineStart read_line_start(const JsonPlace& place);

/// `rbc` of a line or of its description. Throws ReadError. Unknown keys are ignored.
sim::Rbc read_rbc(const JsonPlace& place);

}  // namespace evc::io
