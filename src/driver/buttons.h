#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "base/set.h"
#include "driver/driver.h"
#include "terms/button.h"

// The buttons of the menus and what enables them (ERA_ERTMS_015560 11.2, Tables 33 to 37).
namespace evc::driver {

/// What the tables ask for beside the mode and the level.
enum class Fact : std::uint8_t {
  standstill,
  driver_id_valid,
  level_valid,  ///< any one
  train_data_valid,
  train_running_number_valid,
  session,                  ///< with the supervising RBC
  train_data_acknowledged,  ///< by this RBC
  emergency_stop,           ///< one is pending
  non_leading_signal,
  passive_shunting_signal,
  driver_id_while_running,  ///< the national values permit its entry
  adhesion_by_driver,       ///< the same of the adhesion factor
  slow_enough_for_override,
  position_valid,       ///< and referred to an LRBG
  length_in_range,      ///< the train length that a position report would confirm fits into it
  cover_stored,         ///< a virtual balise cover
  covers_full,          ///< no further one can be stored
  contact_known,        ///< the RBC contact is valid or invalid
  networks_registered,  ///< those that the radio network type requires
  short_number_reachable,
  gsmr_chosen,  ///< by the radio network type, alone or with FRMCS
  // 4.0.0
  one_of_two_registered,  ///< of two radio systems fitted and chosen
  alarm_inhibited,        ///< the reaction to that of the balise antenna, in a big metal mass
  consist_known,          ///< safe consist length information
  consist_in_front,       ///< the same, and it is not zero in front of the engine
  consist_acknowledged,   ///< by the RBC
  session_above_2_2,      ///< the supervising RBC has a system version above 2.2
  second_session,         ///< with another RBC
  RBC_transition_ordered  ///< the order is stored
};
static_assert(static_cast<unsigned>(Fact::RBC_transition_ordered) < 64, "a Set has room for them");

/// The radio network type that the driver chooses (4.0.0); earlier there is GSM-R alone.
enum class NetworkType : std::uint8_t { gsmr, frmcs, both };
struct RadioSystem {
  bool fitted = false;
  bool registered = false;  ///< a mobile terminal is
};

/// What the buttons depend on: what the inputs of 4.7.2 do, and more.
struct ButtonContext {
  ActionContext action;
  Set<Input> inputs;  ///< enabled(action)
  bool emergency_stop_pending = false;
  bool position_valid = false;
  bool length_in_range = false;
  bool cover_stored = false;
  bool covers_full = false;
  bool contact_known = false;
  NetworkType network_type = NetworkType::gsmr;
  RadioSystem gsmr;
  RadioSystem frmcs;
  bool one_radio_system = false;  ///< the mission is run with one of two
  bool consist_known = false, consist_in_front = false, consist_acknowledged = false;
  bool session_above_2_2 = false;
  bool second_session = false;
  bool RBC_transition_ordered = false;
};

/// Those that hold.
Set<Fact> facts_of(const ButtonContext& context);

/// One of the alternatives that enable a button: in one of the modes, in one of the levels where some are named, with
/// all facts that it needs and without the others.
struct ButtonRow {
  Button button{};
  Set<Mode> modes;
  Set<Level> levels;
  Set<Fact> needs;
  Set<Fact> without{};
};

// clang-format off
inline constexpr auto dmi_11_2 = [] {
  using enum Button;
  using enum Fact;
  using enum Mode;
  constexpr Set<Level> kAny{};
  constexpr Set<Level> k1{Level::L1}, k2{Level::L2}, k1or2{Level::L1, Level::L2};
  constexpr Set<Level> k0or1{Level::L0, Level::NTC, Level::L1};
  constexpr Set<Level> k2or3{Level::L2, Level::L3};
  constexpr Set<Mode> kSettings{SH, FS, AD, SM, LS, SR, OS, NL, UN, TR, PT, SN, RV};
  constexpr Set<Mode> kRbc{SB, FS, AD, SM, LS, SR, OS, NL, PT};
  constexpr Set<Mode> kNetworks{SB, FS, LS, SR, OS, NL, PT, UN, SN};
  return std::to_array<ButtonRow>({
    // 11.2.1 Main, Table 33
    {start,                {SB},                                     k0or1, {standstill, driver_id_valid, train_data_valid, train_running_number_valid}},
    {start,                {SB},                                     k2or3, {standstill, driver_id_valid, train_data_valid, train_running_number_valid, session, train_data_acknowledged}},
    {start,                {SB},                                     k2or3, {standstill, driver_id_valid, train_data_valid, train_running_number_valid}, {session}},
    {start,                {PT},                                     k1,    {standstill, train_data_valid}},
    {start,                {PT},                                     k2or3, {standstill, train_data_valid, session}, {emergency_stop}},
    {start,                {SR},                                     k2or3, {session}},
    {driver_id,            {SB},                                     kAny,  {standstill, driver_id_valid, level_valid}},
    {driver_id,            {SH, FS, AD, SM, LS, SR, OS, NL, UN, SN}, kAny,  {standstill}},
    {driver_id,            {SH, FS, AD, SM, LS, SR, OS, NL, UN, SN}, kAny,  {driver_id_while_running}},
    {train_data,           {SB, FS, AD, LS, SR, OS, UN, SN},         kAny,  {standstill, driver_id_valid, level_valid}, {consist_in_front}},
    {level,                {SB, FS, AD, LS, SR, OS, NL, UN, SN},     kAny,  {standstill, driver_id_valid}},
    {train_running_number, {SB},                                     kAny,  {standstill, driver_id_valid, level_valid}},
    {train_running_number, {FS, AD, SM, LS, SR, OS, NL, UN, SN},     kAny,  {}},
    {shunting,             {SB, FS, AD, SM, LS, SR, OS, UN, SN},     k0or1, {standstill, driver_id_valid}},
    {shunting,             {SB, FS, AD, SM, LS, SR, OS, UN, SN},     k2or3, {standstill, driver_id_valid, session}},
    {shunting,             {PT},                                     k1,    {standstill}},
    {shunting,             {PT},                                     k2or3, {standstill, session}, {emergency_stop}},
    {exit_shunting,        {SH},                                     kAny,  {standstill}},
    {non_leading,          {SB, SH, FS, AD, SM, LS, SR, OS},         kAny,  {standstill, driver_id_valid, level_valid, non_leading_signal}},
    {maintain_shunting,    {SH},                                     kAny,  {passive_shunting_signal}},
    {radio_data,           {SB, FS, AD, SM, LS, SR, OS, NL, PT, UN, SN}, kAny, {standstill, driver_id_valid, level_valid}},
    {initiate_sm,          {SB},                                     k2,    {standstill, driver_id_valid, consist_known, session_above_2_2, position_valid}, {RBC_transition_ordered, second_session}},
    {initiate_sm,          {PT},                                     k2,    {standstill, train_data_valid, consist_known, session_above_2_2, position_valid}, {RBC_transition_ordered, second_session, emergency_stop}},
    {initiate_sm,          {FS, AD, LS, OS, SR},                     k2,    {standstill, consist_known, session_above_2_2}, {RBC_transition_ordered, second_session}},
    {continue_sm,          {SM},                                     kAny,  {standstill, consist_known, session_above_2_2}},
    {continue_sm,          {PT},                                     k2,    {standstill, consist_known, session_above_2_2}, {train_data_valid, emergency_stop}},
    {exit_sm,              {SM},                                     kAny,  {standstill}},
    // 11.2.2 Override, Table 34
    {eoa,                  {FS, AD, LS, SR, OS, UN, SN, SH},         kAny,  {slow_enough_for_override}},
    {eoa,                  {SB},                                     k2or3, {slow_enough_for_override, driver_id_valid, train_data_valid, train_running_number_valid}},
    {eoa,                  {PT},                                     kAny,  {slow_enough_for_override, train_data_valid, train_running_number_valid}},
    // 11.2.3 Special, Table 35
    {adhesion,             {SB},                                     kAny,  {adhesion_by_driver, standstill, driver_id_valid, train_data_valid, level_valid}},
    {adhesion,             {FS, AD, SM, LS, SR, OS, UN, SN},         kAny,  {adhesion_by_driver}},
    {sr_speed_distance,    {SR},                                     kAny,  {standstill}},
    {train_integrity,      {SB, FS, AD, LS, SR, OS, UN, PT, SN},     kAny,  {standstill, driver_id_valid, train_data_valid, session, train_data_acknowledged, level_valid, position_valid, length_in_range}},
    {train_integrity,      {SM},                                     kAny,  {standstill, session, consist_acknowledged, length_in_range}},
    {train_integrity,      {SB},                                     kAny,  {standstill, driver_id_valid, level_valid, session, consist_acknowledged, position_valid, length_in_range}, {train_data_valid}},
    {bmm_inhibit,          {SB},                                     k1or2, {standstill, driver_id_valid}, {alarm_inhibited}},
    {bmm_inhibit,          {SR, SH},                                 k1or2, {standstill}, {alarm_inhibited}},
    {bmm_revoke,           {SB},                                     k1or2, {standstill, driver_id_valid, alarm_inhibited}},
    {bmm_revoke,           {SR, SH},                                 k1or2, {standstill, alarm_inhibited}},
    // 11.2.4 Settings, Table 36
    {language,             {SB},                                     kAny,  {standstill}},
    {language,             kSettings,                                kAny,  {}},
    {volume,               {SB},                                     kAny,  {standstill}},
    {volume,               kSettings,                                kAny,  {}},
    {brightness,           {SB},                                     kAny,  {standstill}},
    {brightness,           kSettings,                                kAny,  {}},
    {system_version,       {SB},                                     kAny,  {standstill}},
    {system_version,       kSettings,                                kAny,  {}},
    {set_vbc,              {SB},                                     kAny,  {standstill}, {covers_full}},
    {remove_vbc,           {SB},                                     kAny,  {standstill, cover_stored}},
    {ato,                  {SB},                                     kAny,  {standstill}},
    {ato,                  kSettings,                                kAny,  {}},
    // 11.2.5 Radio data, Table 37
    {contact_last_rbc,     kRbc,                                     k2or3, {standstill, driver_id_valid, contact_known, networks_registered}},
    {use_short_number,     kRbc,                                     k2or3, {standstill, driver_id_valid, short_number_reachable}},
    {enter_rbc_data,       kRbc,                                     k2or3, {standstill, driver_id_valid, networks_registered}},
    {radio_network_type,   kNetworks,                                kAny,  {standstill, driver_id_valid, level_valid}},
    {gsmr_network_id,      {SB, FS, AD, SM, LS, SR, OS, NL, PT, UN, SN}, kAny, {standstill, driver_id_valid, level_valid, gsmr_chosen}},
    {one_radio_system,     kNetworks,                                k2,    {standstill, driver_id_valid, one_of_two_registered}},
  });
}();
// clang-format on

/// The input of 4.7.2 that a button gives, or its window; none for those without a row there, and for the supervised
/// manoeuvre, for which `session_above_2_2` decides alone (6.6.5.3.7).
std::optional<Input> input_of(Button button);

/// The buttons that are enabled now. One whose input 4.7.2 does not enable is not: neither are those of the menus while
/// an acknowledgement is asked for (11.2.1.4 and others).
Set<Button> buttons(const ButtonContext& context);

}  // namespace evc::driver
