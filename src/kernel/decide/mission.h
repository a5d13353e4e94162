#pragma once
#include <optional>

#include "kernel/decide/decided.h"
#include "kernel/intake/received.h"
#include "kernel/log.h"
#include "kernel/state.h"
#include "procedures/observe.h"

// The procedures of chapter 5, one function each: from State and the inputs to the facts of 4.6.3 and their effects.
namespace evc::kernel {

/// Returns the mode of the area of the mode profile in which the max safe front end is.
std::optional<Mode> run_mode_profile(State& s, const Received& received, procedures::Facts& facts, Decided& out);
void run_start_of_mission(State& s, bool desk_open, const Received& received, std::optional<Mode> profile_at_front,
                          Decided& out);
void run_override(State& s, const Received& received, const track::Here& here, procedures::Facts& facts, Log log);
void run_shunting(State& s, const Received& received, const track::Here& here, procedures::Facts& facts,
                  procedures::Effects& effects);
/// The request for a supervised manoeuvre (5.21 of 4.0.0).
void run_manoeuvre(State& s, bool desk_open, const Received& received, procedures::Facts& facts,
                   procedures::Effects& effects);
void run_reversing(const State& s, DirectionController controller, Decided& out);
/// After the mode transition.
void run_train_trip(State& s, bool desk_open, const Received& received, std::optional<Mode> profile_at_front,
                    Decided& out);
/// Start in SR asks the RBC for an authority until it answers with one, or SR is left (4.4.11.1.6).
void run_start_in_SR(State& s, const Received& received, Decided& out);
/// 5.17, after the mode transition.
void run_train_data_change(State& s, const Received& received, Decided& out, Log log);
void run_end_of_mission(State& s, bool desk_open, const Received& received, Decided& out);
/// After the end of the mission: its supervised manoeuvre ends with it, and what the consist length changes (4.0.0).
void finish_manoeuvre(State& s, const Received& received, Decided& out, Log log);

}  // namespace evc::kernel
