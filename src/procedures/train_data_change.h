#pragma once
#include <cstdint>

#include "procedures/effects.h"
#include "terms/mode.h"

// Change of train data by another source than the driver, SUBSET-026-5 5.17.
namespace evc::procedures::train_data_change {

enum class Step : std::uint8_t {
  S0,  // nothing, or a change in a mode without this procedure
  S1,  // waits for the end of the trip, to be validated then
  S2,  // brakes to standstill
  S3,  // at standstill: the driver acknowledges the brake
  S4,  // brakes to standstill, to be validated then
  S5,  // at standstill: the driver acknowledges the brake
  S6,  // the driver enters or revalidates the train data
};

struct State {
  Step step = Step::S0;
};

struct Inputs {
  Mode mode = Mode::SB;
  bool pending = false;           // a change has come and is not dealt with
  bool driver_validates = false;  // D0
  bool route_matters = false;     // D1: train category, axle load, loading gauge or traction system
  bool train_data_valid = false;
  bool standstill = false;
  bool authority_waits = false;   // D5: MA and track description of an RBC wait for a level transition
  bool brake_commanded = false;   // for the change, and not released
  bool driver_validated = false;  // E6: train data of the driver were accepted in this cycle, before the change came
};

/// What becomes of the changed data in this cycle; each but `kept` ends the procedure.
enum class Fate : std::uint8_t {
  kept,          ///< they wait
  in_force,      ///< A7: they are the valid train data
  to_validate,   ///< stored, and to be validated by the driver before they count
  by_the_driver  ///< the driver entered or revalidated them
};

struct Result {
  Effects effects;
  bool brake = false;  ///< service brake (S2, S4)
  Fate data = Fate::kept;
};

/// One cycle. Without valid train data, and after a trip that ended in SH (D4), the data are stored to be validated.
Result step(State& state, const Inputs& inputs);

}  // namespace evc::procedures::train_data_change
