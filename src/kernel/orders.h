#pragma once
#include "kernel/cycle.h"
#include "kernel/information.h"
#include "lang/telegram.h"
#include "modes/levels.h"

// What messages order that is not stored with the track description.
namespace evc::kernel {

/// The levels that this unit can run in now (5.10.2.4).
modes::AvailableLevels available_levels(const Cycle& cycle);

/// A level transition order passed the filters: stores its table and remembers it for the level transition of this
/// cycle. Returns the decision, so that the rest of the message can be judged for the new level (4.8.1.3).
modes::OrderDecision give_order(Cycle& cycle, const procedures::level_transition::Order& order);

/// National values come into force (3.18.2.4).
void use_national_values(State& state, const train::NationalValues& values,
                         const InplaceVector<std::uint16_t, 32>& areas);
/// Each cycle: pending values come into force where the estimated front end passes their place (3.18.2.3); values
/// received for other areas than the country of the group just passed give way to the defaults (3.18.2.9 c).
void advance_national_values(Cycle& cycle);
void leave_area(Cycle& cycle, std::uint16_t NID_C);

/// Message 9: the authority that it proposes, and whether SSP and gradient cover it (4.8.3 [4]).
track::Contents proposal(const Information& information, const track::Reference& reference);
bool proposal_is_described(const Cycle& cycle, const Information& information, const track::Reference& reference);

/// Linking and pending national values beyond a place are deleted (A.3.4).
void cut_other(State& state, Place beyond);

/// Carries out the information of a radio message itself (not its packets). The clause when it is refused, none when it
/// is not.
Clause take_message(Cycle& cycle, const Information& information, const lang::MessageToTrainView& message,
                    const track::Reference& reference);

}  // namespace evc::kernel
