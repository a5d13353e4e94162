#pragma once
#include <string>

#include "run/journey.h"
#include "sim/line.h"

namespace evc::run {

/// The self-contained interactive page of a run. `summary` is the text of summary.json.
std::string report_page(const Journey& journey, const sim::World& world, const sim::Line& line,
                        const std::string& train_name, const std::string& driver_name, const std::string& summary);

}  // namespace evc::run
