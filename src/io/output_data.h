#pragma once
#include <string>

#include "kernel/evc.h"

namespace evc::io {

using ShownCovers = decltype(kernel::Outputs::covers);

/// Appends the data view (3.18.6) as an object: each datum with its value, null where it is unknown, and its status.
void append_data(std::string& out, const kernel::ShownData& data, Level level, const ShownCovers& covers);
/// Of them the train data alone, with the keys of a train file.
void append_train_data(std::string& out, const kernel::ShownTrainData& train);

}  // namespace evc::io
