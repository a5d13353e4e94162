#pragma once
#include "openevc/terms/row.h"

namespace evc {

/// A step of a procedure of chapter 5 in which it waits for the driver, the RBC or the train. The order within a
/// procedure is that of its own enumeration (procedures/).
enum class Dialogue : std::uint8_t {
  start_S0,
  start_S1,
  start_S2,
  start_S3,
  start_S4,
  start_D31,
  start_D33,
  start_A40,
  start_S10,
  start_S12,
  start_S13,
  start_S11,
  start_S20,
  start_S21,
  start_S22,
  start_S23,
  start_S24,
  start_S25,
  trip_S050,
  trip_S060,
  trip_S120,
  trip_S121,
  trip_S130,
  trip_S140,
  trip_S150,
  trip_S160,
  trip_S170,
  train_data_S2,
  train_data_S3,
  train_data_S4,
  train_data_S5,
  train_data_S6,
  shunting_S050,
  OS_ahead,
  OS_entered,
  LS_ahead,
  LS_entered,
  SH_ahead,
  SH_entered,
  reversing,
  level_transition,
  manoeuvre_S050,
  count
};

/// `waits_for`: "ack" where it is an acknowledgement of the driver, which ShownDialogue names.
struct DialogueRow {
  Dialogue value;
  const char* procedure;
  const char* step;
  const char* waits_for;
};

inline constexpr auto kDialogueRows = std::to_array<DialogueRow>({
    // 5.4.3.2
    {Dialogue::start_S0, "start_of_mission", "S0", "end_of_session"},
    {Dialogue::start_S1, "start_of_mission", "S1", "driver_id"},
    {Dialogue::start_S2, "start_of_mission", "S2", "level"},
    {Dialogue::start_S3, "start_of_mission", "S3", "rbc"},
    {Dialogue::start_S4, "start_of_mission", "S4", "registration"},
    {Dialogue::start_D31, "start_of_mission", "D31", "session"},
    {Dialogue::start_D33, "start_of_mission", "D33", "position_confirmed_or_train_accepted"},
    {Dialogue::start_A40, "start_of_mission", "A40", "end_of_session"},
    {Dialogue::start_S10, "start_of_mission", "S10", "train_data"},
    {Dialogue::start_S12, "start_of_mission", "S12", "train_data"},
    {Dialogue::start_S13, "start_of_mission", "S13", "train_running_number"},
    {Dialogue::start_S11, "start_of_mission", "S11", "train_data_acknowledged_by_rbc"},
    {Dialogue::start_S20, "start_of_mission", "S20", "start"},
    {Dialogue::start_S21, "start_of_mission", "S21", "answer_to_ma_request"},
    {Dialogue::start_S22, "start_of_mission", "S22", "ack"},
    {Dialogue::start_S23, "start_of_mission", "S23", "ack"},
    {Dialogue::start_S24, "start_of_mission", "S24", "ack"},
    {Dialogue::start_S25, "start_of_mission", "S25", "ack"},
    // 5.11.2.2
    {Dialogue::trip_S050, "train_trip", "S050", "standstill"},
    {Dialogue::trip_S060, "train_trip", "S060", "ack"},
    {Dialogue::trip_S120, "train_trip", "S120", "exit_from_trip_recognised"},
    {Dialogue::trip_S121, "train_trip", "S120", "override"},
    {Dialogue::trip_S130, "train_trip", "S130", "emergency_stops_revoked"},
    {Dialogue::trip_S140, "train_trip", "S140", "start"},
    {Dialogue::trip_S150, "train_trip", "S150", "answer_to_ma_request"},
    {Dialogue::trip_S160, "train_trip", "S160", "ack"},
    {Dialogue::trip_S170, "train_trip", "S170", "ack"},
    // 5.17.2.2; S1 waits for the end of the trip, whose step is shown
    {Dialogue::train_data_S2, "train_data_change_external", "S2", "standstill"},
    {Dialogue::train_data_S3, "train_data_change_external", "S3", "ack"},
    {Dialogue::train_data_S4, "train_data_change_external", "S4", "standstill"},
    {Dialogue::train_data_S5, "train_data_change_external", "S5", "ack"},
    {Dialogue::train_data_S6, "train_data_change_external", "S6", "train_data"},
    // 5.6.2.2
    {Dialogue::shunting_S050, "shunting_by_driver", "S050", "answer_to_sh_request"},
    // 5.9, 5.19, 5.7
    {Dialogue::OS_ahead, "on_sight", "ack_shown", "ack"},
    {Dialogue::OS_entered, "on_sight", "enter_now", "ack"},
    {Dialogue::LS_ahead, "limited_supervision", "ack_shown", "ack"},
    {Dialogue::LS_entered, "limited_supervision", "enter_now", "ack"},
    {Dialogue::SH_ahead, "shunting_by_trackside", "ack_shown", "ack"},
    {Dialogue::SH_entered, "shunting_by_trackside", "enter_now", "ack"},
    // 5.13, 5.10.4
    {Dialogue::reversing, "reversing", "R2", "ack"},
    {Dialogue::level_transition, "level_transitions", "ack", "ack"},
    // 5.21.2.2
    {Dialogue::manoeuvre_S050, "supervised_manoeuvre", "S050", "answer_to_sm_request"},
});
static_assert(terms::in_order(kDialogueRows) && kDialogueRows.size() == terms::index(Dialogue::count));

}  // namespace evc
