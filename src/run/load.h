#pragma once
#include <string>

#include "io/diagnostic.h"
#include "io/train_file.h"
#include "sim/line.h"

namespace evc::run {

/// The name of a line file; that of the shipped line if it is empty.
std::string line_file(const std::string& file);
io::Result<sim::Line> load_line(const std::string& file);
/// A train file; the standard train if the name is empty.
io::Result<io::Train> load_train(const std::string& file);

}  // namespace evc::run
