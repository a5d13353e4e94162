#pragma once
#include <string>

#include "deceleration/guaranteed.h"

namespace evc::deceleration {

/// What is printed: nominal decelerations, factors by level with their largest error, the steps of the train file,
/// build-up times, and the comparison with the plain run.
std::string table(const Spec& spec, const Guaranteed& result);
/// All of it, with the bounds of every estimate: `evc-brakes-result/1`.
std::string json(const Spec& spec, const Guaranteed& result);

}  // namespace evc::deceleration
