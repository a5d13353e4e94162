#pragma once
#include <string>

#include "kernel/evc.h"

namespace evc::io {

/// Appends the data view (3.18.6) as an object: each datum with its value, null where it is unknown, and its status.
void append_data(std::string& out, const kernel::Outputs& outputs);

}  // namespace evc::io
