#pragma once
#include <string>

#include "io/diagnostic.h"
#include "sweep/store.h"

namespace evc::sweep {

/// The self-contained page of a sweep. `results`: the name of its file, for the commands on it.
io::Result<std::string> report_page(const Store& store, const std::string& results);

}  // namespace evc::sweep
