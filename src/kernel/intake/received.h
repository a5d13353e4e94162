#pragma once
#include <cstdint>
#include <optional>

#include "base/set.h"
#include "brakes/brakes.h"
#include "kernel/port.h"
#include "procedures/effects.h"
#include "track/services.h"

namespace evc::kernel {

/// Inputs of this cycle from the driver, the track and the radio that are not stored: events for the decisions, brakes
/// asked for.
struct Received {
  track::Here here;              ///< the train after relocation
  bool safety_fault = false;     ///< 4.4.5: nothing can be supervised; not in SL and NL, where it is memorised
  bool fault_to_report = false;  ///< one that is memorised: the session for it is established (4.4.6.1.10 c)
  brakes::CauseSet asked;

  // The driver
  Set<Select> selected;  ///< enabled selections (4.7.2)
  Set<Ack> acknowledged;
  Set<Entered> entered;  ///< data that the driver entered and that were accepted

  bool entry_of_train_data_open = false;

  TrainIntegrity integrity{};                ///< says an external source
  std::optional<Distance> length_confirmed;  ///< of the train that it knows to be complete
  // The safe consist length (4.0.0)
  bool consist_changed = false;   ///< or it became available or unavailable
  bool consist_lost = false;      ///< it became unavailable
  bool consist_in_front = false;  ///< it became other than zero in front of the engine
  // Balise groups
  bool new_lrbg = false;
  bool linking_reaction_trip = false;
  bool linked_group_wrong_direction = false;
  bool telegram_version_too_high = false;
  bool group_passed_in_SR_list = false, group_passed_not_in_SR_list = false;
  bool group_passed_not_in_SH_list = false;
  bool group_at_EOA_in_RSM = false;
  bool default_information = false;  ///< the trackside is at fault (3.16.2.4.9)

  // From messages
  bool new_radio_message = false;
  bool ma_from_rbc = false;
  bool balise_proceed = false;  ///< an authority by balises that is not a trip order
  bool trip_order = false;
  bool stop_if_in_SR = false, stop_if_in_SH = false;
  bool ues_accepted = false, ues_received = false;
  bool SR_authorised = false;
  bool SH_authorised = false, SH_refused = false;
  bool SM_authorised = false, SM_refused = false;
  bool train_turned = false;  ///< by the direction of the authorisation
  bool exit_from_trip = false;
  bool position_confirmed = false, train_accepted = false, train_rejected = false;
  bool termination_ordered = false;
  std::optional<std::uint32_t> NID_LTRBG;  ///< an MA is requested: track ahead free up to it (packet 90)

  // Level transition
  procedures::Effects level;               ///< its requests to the driver
  std::optional<Level> level_switched_to;  ///< executed in this cycle
  bool level_changed_by_driver = false;
  bool level_2_or_3_left = false;  ///< over a border
  bool level_2_or_3_left_by_driver = false;
  bool national_system_only = false;  ///< from one national system to another
};

}  // namespace evc::kernel
