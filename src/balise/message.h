#pragma once
#include "balise/balise.h"

// The message of a complete group: duplicates, counters, orientation, and the matrix of 3.16.2.4-5.
namespace evc::balise {

/// Judges the group and returns it in the outcome. `open` is not used afterwards.
void judge_message(LinkingState& linking, OpenGroup& open, const Situation& situation, Outcome& outcome);

}  // namespace evc::balise
