#pragma once
#include <string>

#include "io/input_stream.h"
#include "kernel/port.h"

// The stream of inputs that `evc replay` and `evc explain` read, and what the unit kept before it.
namespace evc::run {

/// Opens it, with the configuration of a file of its own where one is named.
io::Result<io::InputStream> open_stream(const std::string& input, const std::string& config);

/// The error of a stream without any input.
io::Diagnostic no_input(const std::string& input);

/// What a unit kept, from the file of --persistent.
io::Result<kernel::Retained> load_retained(const std::string& file);

/// The error of a stream, or that the file is of another kind and what it is for.
io::Diagnostic of_stream(const io::Diagnostic& error, const std::string& input);

}  // namespace evc::run
