#pragma once
#include <optional>

#include "kernel/state.h"

// Supervised manoeuvre and safe consist length of 4.0.0 (3.18.3.2, 4.4.21).
namespace evc::kernel {

/// The shunting consist as the train orientation has it.
struct ConsistOfTrain {
  ConsistEnd ahead;   ///< of the front end of the engine on the side of the active cab
  ConsistEnd behind;  ///< of the same place
};
/// Where the safe consist length gives the ends of the train: in a manoeuvre, and in SB without valid train data
/// (3.6.1.3.4, 3.18.3.2.4). None: elsewhere.
std::optional<ConsistOfTrain> consist_of_train(const State& state);

/// The length with which train integrity is reported: of valid train data, else of the safe consist length, as far as
/// that counts (3.6.1.7, Table 2c, 4.4.7.1.6). None: neither is known.
std::optional<Distance> length_to_confirm(const State& state);
/// Without valid train data a loss of integrity is reported if the safe consist length is captured from the train, even
/// while it is not available (Table 2c [4]); in SB only while it is (4.4.7.1.6 b).
bool reports_loss_of_consist(const State& state);

/// The front end of the train counts from now on as 3.6.1.3.4 has it.
void place_front_end(State& state);
/// The front end that a request for a manoeuvre reports, in every mode (5.21.2.2 A045).
position::Ahead ahead_in_request(const State& state);

/// Vehicles are in front of the engine: no train data are valid then (3.18.3.5).
bool consist_in_front(const State& state);

/// 3.18.3.10: the RBC is informed of changes: in SB of level 2, and from the first request for a manoeuvre on.
bool informs_of_consist(const State& state);

/// The train that speed and distance monitoring counts with: in a manoeuvre the configured one with the length of the
/// consist (3.18.3.9).
const train::TrainData& supervised_train(const State& state);

/// What an authorisation changes, apart from the authority: to be restored if it is refused after all.
struct ManoeuvreBefore {
  bool active = false, opposite = false;
  track::SpeedCode V_SM = 0;
};
/// 4.4.21.1.7: an authorisation is used, in the direction of the train or in the opposite one, in which the train
/// turns.
ManoeuvreBefore begin_manoeuvre(State& state, bool opposite, track::SpeedCode V_SM);
/// Its contents were refused.
void restore_manoeuvre(State& state, const ManoeuvreBefore& before);
/// The mission ended or goes on in NL: the active cab gives the orientation again (3.6.1.5.1). Returns whether the
/// train turned.
bool end_manoeuvre(State& state);

}  // namespace evc::kernel
