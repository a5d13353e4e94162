#pragma once
#include <cstdint>
#include <optional>

#include "base/units.h"
#include "modes/levels.h"
#include "procedures/effects.h"
#include "terms/mode.h"

// The course of level transitions, SUBSET-026-5 5.10, with the tables of modes/levels.h.
namespace evc::procedures::level_transition {

/// An order that passed the filters of 4.8.
struct Order {
  modes::OrderKind kind = modes::OrderKind::immediate;
  Place border{};  // of an announcement, or of another order where it is known
  modes::LevelTable table;
  Anchor anchor{};      // of the border
  bool placed = false;  // of another order: the border is known
};

/// An order and what to do with it (modes::judge).
struct JudgedOrder {
  Order order;
  modes::OrderDecision decision;
};

/// The table of an announcement, also of one that will not change the level: it applies from the place on (5.10.2.9 a).
struct AnnouncedTable {
  Place border{};
  modes::LevelTable table;
  Anchor anchor{};  // of the border
};

struct State {
  std::optional<modes::PendingTransition> pending;
  std::optional<AnnouncedTable> announced_table;
  bool shown = false;           // the acknowledgement is asked for
  bool acknowledged = false;    // the pending transition is acknowledged already
  bool asked_ahead = false;     // its acknowledgement was asked for ahead of it
  bool unacknowledged = false;  // a transition was executed and is not acknowledged yet
  Level unacknowledged_level = Level::L0;
  Duration deadline{};              // T_ACK after the transition
  bool kept = false;                // an order waits until SH or PS is left (4.4.8.1.5), or PT or RV
  bool kept_without_power = false;  // and No Power was entered meanwhile (4.11.1.4 of 4.0.0)
  Order kept_order;
};

struct Inputs {
  Duration now{};
  Mode mode = Mode::SB;
  modes::OrderedLevel current;
  Place est_front{}, max_safe_front{};
  const JudgedOrder* order = nullptr;               // accepted in this cycle
  std::optional<modes::OrderedLevel> driver_level;  // chosen by the driver in this cycle, driver_may_select() holds
  modes::AvailableLevels available;                 // for an order that was kept until SH or PS is left
  bool acknowledged = false;                        // Ack::level in this cycle
  SrsVersion srs = SrsVersion::v3_6_0;
};

struct Result {
  Effects effects;                               // request Ack::level, service brake
  std::optional<modes::OrderedLevel> switch_to;  // execute a transition in this cycle
  bool by_driver = false;
  bool after_no_power = false;             // an order was judged that had waited in No Power (4.11.1.4)
  std::optional<Place> border;             // of the transition that is executed, where it is known
  std::optional<modes::LevelTable> table;  // becomes applicable in this cycle (5.10.2.9)
  std::optional<Level>
      overdue;  // the transition to this level was not acknowledged within T_ACK: the cause of the service brake
  bool announced =
      false;  // a transition that will change the level is pending: information is buffered by 4.8.3 [1], [2], [6]
  bool cancelled = false;  // a pending transition was deleted or replaced: the transition buffer is deleted (4.8.5)
};

/// One cycle, before the mode transition.
Result step(State& state, const Inputs& inputs);

/// An announcement received after an order that was executed in the same cycle; judged from the level that was entered.
void announce(State& state, const JudgedOrder& announcement);

/// The order that waits is deleted (4.10, A.3.4 k).
void forget_order(State& state);
/// The other cab is active: what is announced lies behind the train; an order that waits for the end of SH or PS
/// stays, its border is not known any more.
void turn(State& state);

/// To be called at every mode transition; the level order is handled by 4.10: it is deleted, or an order stored in SH
/// or PS is judged in the next cycle.
void on_mode_change(State& state, Mode from, Mode to, SrsVersion srs);

}  // namespace evc::procedures::level_transition
