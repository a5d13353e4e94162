#pragma once
#include <string>

#include "deceleration/guaranteed.h"

namespace evc::deceleration {

/// A chart of A_brake_emergency and of what is guaranteed of it at each level, over the speed, with the joint steps of
/// the train file; beside it the factors by level, with their bounds.
std::string chart(const Spec& spec, const Guaranteed& result);

}  // namespace evc::deceleration
