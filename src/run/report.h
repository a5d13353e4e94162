#pragma once
#include <cstddef>
#include <string>

#include "run/display_lists.h"
#include "run/journey.h"
#include "sim/line.h"

namespace evc::run {

/// The largest page, in bytes: the displays are thinned where they would make it larger.
inline constexpr std::size_t kLargestReport = 5'000'000;

/// The self-contained interactive page of a run. `summary` is the text of summary.json.
std::string report_page(const Journey& journey, const sim::World& world, const sim::Line& line,
                        const std::string& train_name, const std::string& driver_name, const std::string& summary,
                        const DisplayLists& displays);

}  // namespace evc::run
