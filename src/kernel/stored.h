#pragma once
#include "kernel/state.h"
#include "modes/stored_information.h"
#include "track/withdraw.h"

// Changes of stored data with a mode, a level or the authority (4.9, 4.10, A.3.4).
namespace evc::kernel {

/// 4.10: mode `to` is entered from `from`.
void keep_for_mode(State& state, Mode to, Mode from);
/// No Power is left: what entering it made invalid becomes valid again where the engine was not moved (4.11.1).
/// `moved`: says cold movement detection; absent: not known.
void revalidate_after_power_off(State& state, const std::optional<bool>& moved);
/// 4.9: level `to` is entered.
void keep_for_level(State& state, Level to);
/// A.3.4 k: the desk is closed during start of mission.
void keep_for_closed_desk(State& state);

/// The sessions that have not ended.
struct Sessions {
  bool supervising = false, other = false;
};
Sessions sessions_of(const State& state);
/// What counts as long as the session with the RBC that sent it: its part of the transition buffer (4.8.5.4 c) and the
/// inhibition of revocable TSRs (3.11.5.14). `before`: the sessions before; those that have ended since are meant.
void delete_with_sessions(State& state, Sessions before);
/// 4.8.5.4 a, 4.8.5.3: what waits for a change of level.
void clear_level_buffer(State& state);

/// The national distance for SR from the estimated front end, where there is one (4.4.11.1.3.1).
void limit_SR_distance(State& state, const track::Here& here);
/// New national values: their distance counts from the same start (3.18.2.11).
void follow_national_SR_distance(State& state);
/// The distance for SR of the RBC or the driver, from the estimated front end; absent: infinite (4.4.11.1.3.2, .3).
void set_SR_distance(State& state, const track::Here& here, const std::optional<Distance>& D);

/// 3.6.7.3 of 4.0.0: the counters at which the supervision of a distance begins that refers to no group.
std::optional<OdometerReading> virtual_front(const State& state);
/// Every cycle, after the position: a group that was passed moves no such distance (3.6.7.3.2).
void follow_virtual_front(State& state);

/// The end of the distance for SR; absent: infinite.
void set_SR_end(State& state, const std::optional<Place>& end);

/// What the message that shortens the authority brings itself: it is not deleted (3.8.5.1.5).
struct Brought {
  bool linking = false, national_values = false;
};
/// Linking and pending national values beyond a place are deleted (A.3.4).
void cut_beyond(State& state, Place beyond, Brought brought = {});
/// A.3.4, a situation that shortens the track description to `beyond`: linking and pending national values as well. An
/// MA request reports this until a new MA is received (3.8.2.7.3). Returns whether there was an authority or track
/// description to shorten.
bool shorten(State& state, track::Situation situation, Place beyond, const track::Here& here);

}  // namespace evc::kernel
