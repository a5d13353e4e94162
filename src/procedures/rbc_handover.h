#pragma once
#include "procedures/effects.h"

// The handover from one RBC to the next, on board: SUBSET-026-3 3.15.1.3, SUBSET-026-5 5.15.
namespace evc::procedures::rbc_handover {

enum class Step : std::uint8_t {
  none,
  announced,   // the border is ahead
  at_border,   // the max safe front end has passed it; the accepting RBC does not supervise yet
  handed_over  // the accepting RBC supervises, or (one session) is called
};

struct State {
  Step step = Step::none;
  bool contact_changed = false;  // the stored contact is that of the accepting RBC (3.15.1.3.7)
  bool rear_passed = false;
  Repetition repetition;  // of the report that the rear end has passed (3.15.1.3.9)
};

struct Inputs {
  Duration now{};
  bool ordered = false;  // a new order, in this cycle
  bool stored = false;   // the order is still stored
  bool alone = false;    // there is no session with the second RBC, and none is being set up
  // The border is passed by
  bool est_front = false, max_safe_front = false, min_safe_rear = false;
  bool one_session = false;          // the unit handles one session at a time (3.15.1.3.2)
  bool reports = false;              // the mode reports a border (3.6.5.1.4 e, k, 4.5.2)
  bool accepting_connected = false;  // the session with the accepting RBC is established and its connection not lost
  // The session with the handing over RBC:
  bool established = false;  // it is established
  bool ended = false;        // there is none, and none is being set up
};

struct Result {
  bool change_contact = false;   // in this cycle
  bool report = false;           // a position report is due
  bool rear_passed_now = false;  // a set-up with the handing over RBC ends (3.5.3.8 f)
  bool terminate = false;        // the session with the handing over RBC
  bool call_accepting = false;   // one session: after it has ended
  bool over = false;             // the handover is complete: the order has been executed
};

/// One cycle, before the position reports of the cycle are sent. An order that is deleted while the border is ahead, or
/// without a second session, ends the handover; the session with the accepting RBC is that RBC's to end (3.15.1.4.4).
Result step(State& state, const Inputs& inputs);

/// A position report was sent to the accepting RBC in this cycle. Returns whether it supervises from now on: its max
/// safe front end had passed the border (3.15.1.3.5).
bool reported_to_accepting(State& state);

}  // namespace evc::procedures::rbc_handover
