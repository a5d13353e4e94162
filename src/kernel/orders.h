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
/// cycle. Tells what it means, so that the rest of the message can be judged for the new level (4.8.1.3).
modes::OrderDecision give_order(Cycle& cycle, const procedures::level_transition::Order& order);

/// National values come into force (3.18.2.4).
void use_national_values(State& state, const train::NationalValues& values,
                         const InplaceVector<std::uint16_t, 32>& areas);
/// Each cycle: pending values come into force at their place (max safe front end, 3.18.2.9 b); values received for
/// other areas than the country of the group just passed give way to the defaults (3.18.2.9 c).
void advance_national_values(Cycle& cycle);
void leave_area(Cycle& cycle, std::uint16_t NID_C);

/// Carries out the information of a radio message itself (not its packets). A literal clause when it is refused.
const char* take_message(Cycle& cycle, const Information& information, const lang::MessageToTrainView& message,
                         track::Contents& contents, const track::Reference& reference);

}  // namespace evc::kernel
