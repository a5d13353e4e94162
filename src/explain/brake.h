#pragma once
#include "explain/origins.h"

// Why the brake was commanded: from the first cause to the command.
namespace evc::explain {

/// A command with its first cycle.
struct Command {
  Cause cause{};
  const Braking* braking = nullptr;
};
/// What is commanded: "service brake", or what takes its place.
std::string brake_words(const Command& command);
/// "at standstill": what will end the command; nothing: it is permanent. Of `now`: the rules may have changed.
std::optional<std::string> release_words(const Command& command, const Moment& now);
/// The clause of a command in that cycle, in the edition of the unit.
std::string clause_of(Cause cause, const Moment& m);
/// Up to the command that began at `onset`, the last step.
Steps chain_of(const Command& command, const Journal& journal);
/// The same of the limits that a speed exceeded one after the other: their commands follow what set the limits.
Steps overspeed_chain(const Journal& journal, const std::vector<Command>& commands);
/// What else moved the braking curve of a moment: without it the EBI limit would be higher.
Steps curve_steps(const Journal& journal, const Moment& m);
/// The emergency brake because the service brake fails.
Step failed_step(std::int64_t t_ms);
/// Why the mode was entered: what made its condition true, then the transition.
Steps entry_steps(const Journal& journal, const Moment& entry);

// The first causes of each kind of command (brake_track.cpp, brake_train.cpp).

/// Of the trip: by the condition that led to TR.
Steps trip_steps(const Journal& journal, const Moment& entry, int condition);
/// The error of a group, and what announced the group.
Steps linking_steps(const Journal& journal, const Moment& onset);
Steps two_groups_steps(const Journal& journal, const Moment& onset);
/// The group of the cycle that is not in the list, which begins with what brought it.
Steps list_steps(const Journal& journal, const Moment& onset, const std::optional<track::GroupList>& list);
Steps contact_steps(const Journal& journal, const Moment& onset);
Steps movement_steps(Cause cause, const Journal& journal, const Moment& onset);
Steps text_steps(Cause cause, const Journal& journal, const Moment& onset);
Steps unacknowledged_steps(Cause cause, const Journal& journal, const Moment& onset);
/// Of SF: the fault.
Steps fault_steps(const Journal& journal, const Moment& entry);
Steps train_data_steps(const Journal& journal, const Moment& onset);

}  // namespace evc::explain
