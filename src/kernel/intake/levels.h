#pragma once
#include <optional>

#include "kernel/intake/reception.h"
#include "lang/telegram.h"
#include "modes/levels.h"
#include "track/from_packets.h"

// Level transitions (5.10).
namespace evc::kernel {

/// The order of packet 41 or 46, not placed yet; none when it does not decode.
std::optional<procedures::level_transition::Order> order_of(const lang::PacketView& view, SrsVersion srs);

/// A level transition order passed the filters: stores its table, judges it and stores it for the level transition of
/// this cycle. Returns the decision, so that the rest of the message can be judged for the new level (4.8.1.3).
modes::OrderDecision give_order(Reception& r, const procedures::level_transition::Order& order);
/// Places the border of the order of this cycle, if it announces a transition: D_LEVELTR from the reference. `packet`
/// is the packet of that order. `anchor`: of the reference.
void place_border(Reception& r, const lang::PacketView& packet, const track::Reference& reference, Anchor anchor);

/// Whether an order of this cycle changes the level in this cycle.
bool executes_order(const Reception& r);
/// The level to which a transition is ordered, here or further on, with the orders of this cycle: one that replaces or
/// deletes the pending transition counts for all that is received after it. None if the level will not change.
std::optional<modes::OrderedLevel> ordered_level(const Reception& r);

/// The level transition of this cycle with its consequences: 4.9, and the release of the transition buffer.
void run_level_transition(Reception& r);

}  // namespace evc::kernel
