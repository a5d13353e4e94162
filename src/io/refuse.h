#pragma once
#include "io/json.h"
#include "train/brake_model.h"

namespace evc::io {

/// Rejects a train or national values at `place` for a fault of `train::check`: names the key, the expected value and
/// the clause. No effect for `Fault::none`. Throws ReadError.
void refuse(const JsonPlace& place, train::Fault fault);

/// The number at `place` from `least` to `most`; a number outside is this fault. Throws ReadError.
double number_or(const JsonPlace& place, double least, double most, train::Fault fault);

}  // namespace evc::io
