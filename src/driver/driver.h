#pragma once
#include <cstdint>
#include <optional>

#include "base/inplace_vector.h"
#include "base/set.h"
#include "driver/srs_4_7_2.h"
#include "terms/level.h"
#include "terms/mode.h"
#include "terms/mode_symbol.h"
#include "terms/radio_link.h"
#include "terms/requests.h"
#include "terms/srs_version.h"
#include "terms/status_text.h"
#include "terms/symbol.h"
#include "terms/track_condition.h"

// What the driver machine interface shows and what the driver may do, as data (SUBSET-026-4 4.7,
// ERA_ERTMS_015560). The symbols are named as there (MO07, LE04, ST01, ...).
namespace evc::driver {

/// What enables inputs in addition to the mode (windows Main, Override and Special).
struct ActionContext {
  SrsVersion srs = SrsVersion::v3_6_0;
  Mode mode = Mode::NP;
  std::optional<Level> level;  // none when it is not valid
  bool desk_open = false;
  bool standstill = false;
  bool driver_id_valid = false;
  bool train_data_valid = false;
  bool train_running_number_valid = false;
  bool session_open = false;
  bool train_data_acknowledged = false;  // by the RBC
  bool non_leading_signal = false;
  bool passive_shunting_signal = false;
  bool slow_enough_for_override = false;    // V_est <= V_NVALLOWOVTRP
  bool network_offered = false;             // the driver may choose a radio network
  bool driver_may_change_adhesion = false;  // Q_NVDRIVER_ADHES
  bool driver_id_while_running = false;     // M_NVDERUN
  bool track_ahead_free_asked = false;
  bool automatic_driving_asked = false;  // 4.0.0: by automatic train operation
  bool consist_in_front = false;         ///< 4.0.0: vehicles are in front of the engine: no train data (3.18.3.5)
  bool consist_acknowledged = false;     ///< 4.0.0: the RBC knows the safe consist length
  bool manoeuvre_possible = false;       ///< 4.0.0: 5.21.2.2 S0, standstill apart
  bool alarm_may_be_inhibited = false;   // 4.0.0: level 1 or 2 (5.22.2.1)
  bool alarm_inhibited = false;          // that of the balise antenna
  Set<Offer> offers;                     // choices offered by start of mission and train trip
  Set<Ack> requests;                     // acknowledgements asked for
  bool start_up = false;                 // the start of mission, before it has reached S10 (015560 11.7.2)
};

/// The inputs of 4.7.2 that are enabled now. While an acknowledgement is asked for, only acknowledgements and isolation
/// are (015560 5.4), but for the start-up dialogue, which goes on: there acknowledgements wait (11.7.1.9).
Set<Input> enabled(const ActionContext& context);

/// Of the acknowledgements asked for those that the driver can give in the mode (4.7.2): nobody is asked for another.
Set<Ack> answerable(Set<Ack> asked, Mode mode, SrsVersion srs);

struct ShowContext {
  SrsVersion srs = SrsVersion::v3_6_0;
  Mode mode = Mode::NP;
  bool desk_open = false;
  std::optional<Level> level;      // none when it is not valid
  std::optional<Level> announced;  // a transition that will change the level
  Set<Ack> requests;               // acknowledgements asked for
  bool override_active = false;
  bool brake_commanded = false;  // service or emergency brake
  RadioIndication radio = RadioIndication::none;
  bool slippery_rail = false;
  bool reversing_possible = false;
  bool lx_not_protected = false;
  bool lssma = false;  // the lowest supervised speed is shown
  bool track_ahead_free_asked = false;
  InplaceVector<Symbol, 20> track_conditions;  // each symbol once
};

struct Show {
  InplaceVector<Symbol, 32> symbols;  // in the order of the areas of the screen
};

/// What is shown now. With no desk open only the system failure is shown (4.7.2 marks the other outputs A in SB and
/// TR).
Show show(const ShowContext& context);

/// Whether the driver switches speeds and distances on and off in the mode (015560 8.2.2.4).
constexpr bool can_be_toggled(Mode mode) { return mode == Mode::OS || mode == Mode::SR || mode == Mode::SH; }
/// Of the outputs for which there is something to show (`given`) those that are shown: in the mode (4.7.2), with an
/// open desk but for the modes SF and IS, and toggled on where the driver toggles them.
Set<Output> shown(Set<Output> given, Mode mode, SrsVersion srs, bool desk_open, bool toggled_on);
/// The row of 4.7.2 of a symbol; none for those of acknowledgements and of the advance display. Track conditions:
/// output_of.
std::optional<Output> output_of(Symbol symbol);

/// The symbol of a track condition (5.18): where an action is due, the one that asks the driver for it or announces
/// what the train does (3.12.1.5.1). None in the phases ahead and over.
std::optional<Symbol> symbol(TrackConditionKind kind, ConditionPhase phase, const ByTrain& by_train);
/// The symbol of a change of traction system to M_VOLTAGE (7.5.1.78), none for a spare code.
std::optional<Symbol> symbol_of_traction(std::uint8_t M_VOLTAGE, ConditionPhase phase, const ByTrain& by_train);
/// The symbols of the advance display (3.15.10): of the start of a condition, of its end; none for those without one.
std::optional<Symbol> planning_symbol(TrackConditionKind kind, bool end, const ByTrain& by_train);
/// The same of a change of traction system.
std::optional<Symbol> planning_symbol_of_traction(std::uint8_t M_VOLTAGE, const ByTrain& by_train);
/// The row of 4.7.2 in which the condition is.
constexpr Output output_of(TrackConditionKind kind) {
  return horn_or_stopping(kind) ? Output::track_cond_horn_stopping : Output::track_cond_general;
}

/// The trip reason for the condition of 4.6.3 that led to TR, none for one that has none.
std::optional<StatusText> trip_reason(int condition);

}  // namespace evc::driver
