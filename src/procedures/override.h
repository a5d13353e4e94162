#pragma once
#include <cstdint>
#include <optional>

#include "base/location.h"
#include "base/units.h"
#include "terms/clause.h"
#include "terms/level.h"
#include "terms/mode.h"

// Override, SUBSET-026-5 5.8.
namespace evc::procedures::override_ {

struct State {
  bool active = false;
  bool selected_outside_NTC = false;  // in another level than NTC (5.8.3.7.2 of 4.0.0)
  Duration since{};                   // a: time of the selection
  OdometerPlace start{};              // b: place of the selection
  std::optional<Place> former_eoa;    // c and [43]; stored beyond the end of override, deleted when SR is left
  bool former_eoa_passed = false;
  /// 4.0.0: the counters at the selection, where there was no valid position; the former EOA is there, whatever
  /// position later groups give (3.6.7.3). The caller moves `former_eoa` accordingly.
  std::optional<OdometerReading> virtual_front;
  std::optional<Place> sr_distance_end;  // h: the SR distance supervised before the selection
};

struct Inputs {
  Duration now{};
  OdometerPlace odometer{};  // nominal
  Mode mode = Mode::SB;
  Level level = Level::L0;
  bool selected = false;  // by the driver, in this cycle; enabled by 5.8.2.1 (driver/driver.h)
  // National values; nullopt: infinite distance. T_NVOVTRP is never infinite.
  Duration T_NVOVTRP{60.0};
  std::optional<Distance> D_NVOVTRP{Distance{200.0}};
  // Position
  std::optional<OdometerReading> counter;  // 4.0.0, without a valid position: the front end counts from here
  Place est_front{};
  Place min_safe_antenna{};
  std::optional<Place> eoa_or_loa;       // in force (FS, LS, OS)
  std::optional<Place> sr_distance_end;  // in force (SR)
  // Events of this cycle
  bool stop_if_in_SR = false;
  bool stop_if_in_SH = false;
  bool balise_proceed = false;     // e: MA or signalling related speed that is not zero
  bool ma_from_rbc = false;        // f: level 2/3
  bool group_not_in_list = false;  // g: not in the SR or SH list
};

struct Result {
  bool selected = false;           // Facts::selects_override: [37]
  bool started = false;            // (re)started in this cycle: SR speed and distance return to the national values
  bool active = false;             // Facts::override_active: before the end conditions of this cycle
  bool former_eoa_passed = false;  // Facts::former_eoa_passed: becomes true in this cycle
  Clause ended_by;                 // a bullet of 5.8.4.1 when it ends in this cycle
};

/// One cycle, before the mode transition. The override distance is measured with the nominal
/// odometer.
Result step(State& state, const Inputs& inputs);

/// To be called at every mode transition: TR, LS, OS, SH end override (5.8.4.1 i); all but SR delete the former EOA.
void on_mode_change(State& state, Mode to);

}  // namespace evc::procedures::override_
