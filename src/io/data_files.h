#pragma once
#include <string>

namespace evc::io {

/// The folder of the shipped data (`lines/`, `trains/`): $OPENEVC_DATA, else the one of the
/// installed program or library that this code is in, else that of the source tree.
std::string data_folder();

/// The name of a file of this folder, from its path there.
std::string data_file(const std::string& path);

}  // namespace evc::io
