#pragma once
#include <string>
#include <string_view>

#include "io/json.h"
#include "sim/networks.h"

namespace evc::io {

/// The radio networks of a line, `radio_networks` of `etcs-line/1`; none where the key is absent. An error names the
/// place.
Result<sim::Networks> read_networks(std::string_view line, const std::string& file);

}  // namespace evc::io
