#pragma once
#include "balise/balise.h"

// The message of a complete group: duplicates, counters, orientation, and the matrix of 3.16.2.4-5.
namespace evc::balise {

/// Judges the group and returns it in the outcome. `open` is not used afterwards.
void judge_message(LinkingState& linking, OpenGroup& open, const Situation& situation, Outcome& outcome);

/// Whether linking that was stored after the reference balise of the group was read announces it: a group that was not
/// found yet is judged again when it is complete.
bool announced_since(const LinkingState& linking, const OpenGroup& open);

}  // namespace evc::balise
