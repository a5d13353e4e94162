#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "base/inplace_vector.h"
#include "base/set.h"
#include "base/units.h"
#include "driver/srs_4_7_2.h"
#include "terms/cause.h"
#include "terms/mode.h"
#include "terms/requests.h"
#include "terms/status_text.h"
#include "terms/track_condition.h"

// The system status messages of the driver interface, from their start to their end condition (ERA_ERTMS_015560 15).
namespace evc::driver {

/// What the texts depend on, in this cycle.
struct StatusFacts {
  Duration now{};
  Mode mode = Mode::NP;
  SrsVersion srs = SrsVersion::v3_6_0;
  Set<Cause> brakes;                   ///< that command a brake
  Set<Cause> revoked;                  ///< by the entry of a mode in this cycle (4.12)
  Set<Inform> inform;                  ///< what happened in this cycle
  Set<Suitability> unsuitable;         ///< in what the route ahead does not suit the train (3.12.2.3)
  bool described_under_train = true;   ///< SSP and gradient are known for the whole length of the train (4.4.9.1.4)
  bool main_window_selection = false;  ///< a button of the main window was selected
  bool moving = false;                 ///< a train movement is detected
  bool acknowledged = false;           ///< the text that asks for it was acknowledged
};

/// How a text ends, beside a mode in which 4.7.2 does not show it (15.1.1.2) and one whose entry revokes the brake
/// command of the text (15.1.1.6). Table 68 has its own rule for "Communication error", s30_and_its_reason: after a
/// revocation too it is shown for 30 s.
enum class TextEnd : std::uint8_t {
  with_its_reason,       ///< it is shown as long as its reason holds
  s30_after_its_reason,  ///< 30 s after its reason held last
  s30_and_its_reason,    ///< after 30 s, and not before its reason has ended
  s30,                   ///< after 30 s
  s30_of_movement,       ///< 30 s after the train moved first
  main_window,           ///< with the next selection in the main window
  acknowledged           ///< with its acknowledgement
};

/// One row of Table 68 without the trip reasons: what starts the text, and its row of 4.7.2.
struct StatusRow {
  StatusText text{};
  Output output{};
  TextEnd end{};
  Set<Cause> brakes{};             ///< starts with one of these
  std::optional<Inform> inform{};  ///< starts with this
  std::optional<Suitability> unsuitable{};
  std::optional<Mode> entering{};  ///< in this mode, while the track under the train is not described
};

// clang-format off
inline constexpr auto srs_status_texts = [] {
  using enum StatusText;
  using enum TextEnd;
  return std::to_array<StatusRow>({
      {balise_read_error,           Output::brake_reason,                s30_after_its_reason, {Cause::linking, Cause::balise_group_consistency, Cause::two_groups_missed}},
      {trackside_malfunction,       Output::trackside_malfunction,       s30,                  {}, Inform::trackside_malfunction},
      {communication_error,         Output::brake_reason,                s30_and_its_reason,   {Cause::T_NVCONTACT}},
      {entering_FS,                 Output::entry_fs,                    with_its_reason,      {}, {}, {}, Mode::FS},
      {entering_OS,                 Output::entry_os,                    with_its_reason,      {}, {}, {}, Mode::OS},
      {runaway_movement,            Output::brake_reason,                with_its_reason,      {Cause::roll_away, Cause::reverse_movement, Cause::standstill, Cause::movement_while_entering_train_data, Cause::movement_while_entering_SR_data}},
      {SH_refused,                  Output::sh_refused,                  main_window,          {}, Inform::SH_refused},
      {SH_request_failed,           Output::sh_no_answer,                main_window,          {}, Inform::SH_request_failed},
      {trackside_not_compatible,    Output::trackside_incompatible,      s30,                  {}, Inform::trackside_not_compatible},
      {train_is_rejected,           Output::train_rejected,              main_window,          {}, Inform::train_rejected},
      {RV_distance_exceeded,        Output::brake_reason,                with_its_reason,      {Cause::reversing_distance}},
      {PT_distance_exceeded,        Output::brake_reason,                with_its_reason,      {Cause::post_trip_distance}},
      {route_unsuitable_gauge,      Output::route_unsuitability,         with_its_reason,      {}, {}, Suitability::gauge},
      {route_unsuitable_traction,   Output::route_unsuitability,         with_its_reason,      {}, {}, Suitability::traction},
      {route_unsuitable_axle_load,  Output::route_unsuitability,         with_its_reason,      {}, {}, Suitability::axle_load},
      {StatusText::train_data_changed, Output::train_data_changed,       s30_of_movement,      {}, Inform::train_data_changed},
      {StatusText::train_data_changed, Output::brake_reason,             with_its_reason,      {Cause::train_data_changed}},
      {network_registration_failed, Output::network_registration_failed, main_window,          {}, Inform::network_registration_failed},
      {national_system_not_available, Output::ntc_not_available,       with_its_reason,      {}, Inform::national_system_not_available},
      {NL_no_longer_permitted,      Output::nl_no_longer_permitted,      acknowledged,         {}, Inform::NL_no_longer_permitted},
      {StatusText::odometer_impaired, Output::odometer_impaired,       with_its_reason,      {}, Inform::odometer_impaired},
      {entering_SM,                 Output::entry_sm,                    with_its_reason,      {}, {}, {}, Mode::SM},
      {SM_refused,                  Output::sm_refused,                  main_window,          {}, Inform::SM_refused},
      {SM_request_failed,           Output::sm_no_answer,                main_window,          {}, Inform::SM_request_failed},
      {consist_length_lost,         Output::brake_reason,                s30,                  {}, Inform::consist_length_lost},
      {consist_length_lost,         Output::brake_reason,                with_its_reason,      {Cause::consist_length}},
  });
}();
// clang-format on

/// What is remembered of the texts.
struct StatusTexts {
  /// One row of the table.
  struct Row {
    bool on = false;
    Duration until{};    ///< it ends then at the earliest
    bool moved = false;  ///< the train has moved since its reason
  };
  std::array<Row, srs_status_texts.size()> rows{};
  std::optional<StatusText> trip_reason;  ///< in TR and PT
  Set<StatusText> shown;
  std::array<Duration, static_cast<std::size_t>(StatusText::count)> since{};  ///< of those shown

  constexpr bool idle() const { return shown.empty() && !trip_reason.has_value(); }
};

/// TR was entered by this condition of 4.6.3: the reason is shown until TR and PT are left (4.4.13.1.3, 4.4.14.1.2.1).
void enter_trip(StatusTexts& texts, int condition);

/// One cycle: `texts.shown` and since when. One text stands for all its rows until the last of them ends (15.1.1.7).
void step(StatusTexts& texts, const StatusFacts& facts);

}  // namespace evc::driver
