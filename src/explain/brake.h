#pragma once
#include "explain/origins.h"

// Why the brake was commanded: from the first cause to the command.
namespace evc::explain {

/// A command with its first cycle.
struct Command {
  Cause cause{};
  const Braking* braking = nullptr;
};
/// Up to the command that began at `onset`, the last step.
Steps chain_of(Cause cause, const Journal& journal, const Moment& onset);
/// The same of the limits that a speed exceeded one after the other: their commands follow what set the limits.
Steps overspeed_chain(const Journal& journal, const std::vector<Command>& commands);
/// Why the mode was entered: what made its condition true, then the transition.
Steps entry_steps(const Journal& journal, const Moment& entry);

// The first causes of each kind of command (brake_track.cpp, brake_train.cpp).

/// Of the trip: by the condition that led to TR.
Steps trip_steps(const Journal& journal, const Moment& entry, int condition);
Steps linking_steps(const Journal& journal, const Moment& onset);
Steps contact_steps(const Journal& journal, const Moment& onset);
Steps movement_steps(Cause cause, const Journal& journal, const Moment& onset);
Steps text_steps(Cause cause, const Journal& journal, const Moment& onset);
Steps unacknowledged_steps(Cause cause, const Journal& journal, const Moment& onset);
Steps train_data_steps(const Journal& journal, const Moment& onset);

}  // namespace evc::explain
