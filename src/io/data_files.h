#pragma once
#include <string>

namespace evc::io {

/// The folder of what ships with the program (`lines/`, `trains/`): $OPENEVC_DATA, else beside an
/// installed program, else in the source tree it was built from.
std::string data_folder();

/// A ready-made file of that folder by its path there.
std::string data_file(const std::string& path);

}  // namespace evc::io
