#pragma once
#include "kernel/log.h"
#include "kernel/state.h"
#include "radio/radio.h"
#include "track/services.h"

// Radio infill: the areas and the sessions with radio infill units (3.9.3).
namespace evc::kernel {

/// Packet 143 from a radio infill unit: a session with its neighbour is ordered (3.9.3.6) or ends.
void order_neighbour(State& state, const radio::Rbc& unit, bool establish, radio::Outbox& outbox, Log log);
/// The balise group was read, or linking found that it was missed: it may end the area (3.9.3.10 b).
void note_signal_of_radio_infill(State& state, GroupId group);
/// Each cycle, before the sessions: the order of packet 133 whose place the estimated front end has reached, message
/// 153, the end of all sessions with level 1 or the mission.
void run_radio_infill(State& state, const track::Here& here, bool mission_ended, radio::Outbox& outbox, Log log);
/// All sessions with radio infill units and their set-ups end, and no other unit is called; the area stays.
void end_infill_sessions(State& state, radio::Outbox& outbox);
/// The session with the unit of the present area; null without one (3.5.7.7).
const radio::Session* session_of_infill_area(const State& state);

}  // namespace evc::kernel
