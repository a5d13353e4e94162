#pragma once
#include <cstdint>
#include <optional>

#include "modes/conditions.h"
#include "procedures/effects.h"
#include "terms/level.h"
#include "terms/srs_version.h"

namespace evc::procedures {

/// The vocabulary of 4.6.3: every fact that its conditions ask for, in this cycle. What is an event holds in the cycle
/// only in which it happens; the kernel passes each event exactly once. Override means its status before the end
/// conditions of this cycle (5.8.4.1 d and g take effect after the group is evaluated).
struct Facts {
  // train interface, platform
  bool isolated = false;   // [1] state of the isolation device
  bool powered = true;     // [4][29]
  bool desk_open = false;  // [2][14][22][23][26][27][28][30]
  bool standstill = false;
  bool sleeping = false;
  bool non_leading = false;
  bool passive_shunting = false;
  bool safety_fault = false;  // [13]
  // level
  Level level = Level::L0;                 // after the level change of this cycle, if any
  std::optional<Level> level_switched_to;  // a transition is executed in this cycle (also NTC X to NTC Y)
  bool level_order_changed_national_system_only = false;  // NTC X to NTC Y: no [56] from SN, the mode stays
  // driver, this cycle
  Set<Ack> acknowledged;  // acknowledgements given
  Set<Ack> requested;  // acknowledgements asked for when the driver gave them (Effects::requests of the cycle before)
  bool selects_SH = false;        // [5][35]
  bool selects_exit_SH = false;   // [19]
  bool selects_NL = false;        // [46]
  bool selects_override = false;  // [37]: selected while it was enabled and V <= V_NVALLOWOVTRP (override.h)
  // data
  bool train_data_valid = false;
  bool ma_ssp_gradient_stored = false;  // SSP and gradient at least from the front end
  bool ma_accepted = false;             // an MA is in use after all steps of this cycle [39]
  bool ma_with_trip_order = false;      // attribute of the MA in use [32]
  // mode profile (mode_profile.h)
  bool profile_demands_OS = false, profile_demands_LS = false, profile_demands_SH = false;  // [34][40][71][72][51][61]
  bool profile_in_force = false;      // any mode profile is in force at the position of the train, [10][25][31][32]
  bool front_in_OS_ack_area = false;  // [74], and it keeps OS where the mode is OS
  bool front_in_LS_ack_area = false;  // [73], and it keeps LS where the mode is LS
  bool mode_is_OS = false, mode_is_LS = false;
  // authority
  bool min_safe_antenna_beyond_eoa = false;         // [12]
  bool min_safe_front_beyond_eoa = false;           // [16]
  bool group_at_eoa_in_RSM = false;                 // [11] of 4.0.0
  bool front_in_rear_of_track_description = false;  // [69]: est front in rear of a stored SSP or gradient
  // balise
  bool linking_reaction_trip = false;         // [17]
  bool linked_group_wrong_direction = false;  // [66]
  bool telegram_version_too_high = false;     // [65]
  bool trip_order = false;                    // [18][67]: accepted by the filters of 4.8, this cycle
  bool stop_if_in_SH = false;                 // [49]
  bool stop_if_in_SR = false;                 // [54]
  bool group_passed_not_in_SH_list = false;   // [52]: a group was passed, a list is stored and does not contain it
  bool group_passed_not_in_SR_list = false;   // [36]
  bool group_passed_in_SR_list = false;       // [54]: a list is stored and contains it
  // radio
  bool ues_accepted = false;      // [20]: also one released from the transition buffer in this cycle
  bool ues_received = false;      // [45]: accepted or in the buffer, not revoked
  bool T_NVCONTACT_trip = false;  // [41]: exceeded and M_NVCONTACT is trip
  bool SH_granted = false;        // [6]: message 28 answers an open request (shunting.h)
  // procedures
  bool override_active = false;       // before the end conditions of this cycle
  bool former_eoa_passed = false;     // [43]: becomes true in this cycle (override.h)
  bool SR_distance_passed = false;    // [42]
  bool continue_shunting = false;     // [26][27] (shunting.h)
  bool stop_shunting_stored = false;  // [22][23]: packet 135 stored
  bool national_trip = false;         // [35][38]: the national system reports it
  // 4.0.0 only
  bool level_crossing_approach_shown = false;  // [9]: shown since this cycle
  bool brake_commanded = false;                // [24][80]: service or emergency brake, in the cycle before
  bool AD_requested = false;                   // [33][80]: by automatic train operation
  bool described_for_whole_train = false;      // [48][80]: SSP and gradient
  bool selects_ATO_engage = false;             // [80]
  bool ATO_disengaged = false;                 // [53]: by the driver, or by its selector
  bool SM_authorised = false;                  // [81]
  bool selects_exit_SM = false;                // [82]
  bool consist_in_front = false;               // [83]: other than zero since this cycle
  bool odometer_beyond_threshold = false;      // [84]
};

/// All conditions of 4.6.3 that hold; those that only 4.0.0 has with that edition.
modes::Conditions observe(const Facts& facts, SrsVersion srs = SrsVersion::v3_6_0);

}  // namespace evc::procedures
