#pragma once
#include <cstdint>
#include <optional>

#include "track/description.h"

// Passing the end of the authority, SR distance and lists, override (3.13.10.2.6-7, 4.4.11, 5.8).
namespace evc::protection {

/// Condition [12]: the min safe antenna position beyond EOA or LOA, level 1.
bool passes_end_level_1(const track::Authority& authority, const track::Here& here);
/// Condition [16]: the min safe front end beyond EOA or LOA, level 2 and 3.
bool passes_end_level_2(const track::Authority& authority, const track::Here& here);
/// Condition [69].
bool before_track_description(const track::Description& d, const track::Here& here);

/// Override (5.8). Active from the driver's selection until one of its ends; meanwhile no trip for stop information.
struct Override {
  bool active = false;
  Duration since{};
  OdometerPlace from{};
  /// EOA or LOA of the MA that was left, or the front end when there was none; condition [43] supervises it once
  /// override is over. Passed under override, or "stop if in SR" read, or SR left: absent.
  std::optional<Place> former_end;
};
struct OverrideInputs {
  Duration now{};
  OdometerPlace nominal{};
  std::optional<Distance> D_NVOVTRP;
  std::optional<Duration> T_NVOVTRP;
  Place min_safe_antenna{}, est_front{};
  std::optional<Place> sr_distance_end;  ///< that was supervised before
  bool stop_information = false;         ///< a group with stop if in SR or SH, or one that is not in the list
  bool proceed_information = false;      ///< a group with an MA and a speed above 0, or an MA from the RBC
  std::uint8_t M_MODE = 0;               ///< mode in force
  bool mode_entered = false;             ///< in this cycle
};
/// The driver selects override: granted when the speed allows (5.8.2.1); again: time and distance start anew. `end`:
/// the EOA or LOA, else the estimated front end; in SR a later selection keeps the former one.
bool select(Override& state, const OverrideInputs& in, Speed V_est, Speed V_NVALLOWOVTRP, std::optional<Place> end);
/// Every cycle: what ends it (5.8.4): time, distance, former EOA passed, stop or proceed information, the SR distance
/// passed, or a mode TR, LS, OS, SH entered. In UN and SN only time and distance count.
void supervise(Override& state, const OverrideInputs& in);
/// Condition [43].
bool passes_former_end(const Override& state, const track::Here& here);

/// Distance that may be run in SR (4.4.11).
struct StaffResponsible {
  std::optional<Place> distance_end;
  std::optional<Speed> V_by_driver;
};
/// Condition [42].
bool passes_distance_end(const StaffResponsible& sr, const track::Here& here, bool override_active);
/// Condition [36], [52]: a group that is not in the list (an absent list lets all pass).
bool outside_list(const std::optional<track::GroupList>& list, GroupId group);
/// Condition [54]: "stop if in SR", unless the group is in a list that was received; with system version 1 in any case.
bool stopped_in_sr(bool stop_if_in_sr, const std::optional<track::GroupList>& list, GroupId group,
                   bool system_version_1);

/// Track ahead free request (message 34; 3.15.5).
struct TrackAheadFree {
  std::optional<Place> from, to;
  bool asking = false;
};
void request(TrackAheadFree& state, Place from, Place to);
/// Whether the driver is asked now; an acknowledgement ends it: true in `granted`, message 149 is due.
struct TafResult {
  bool asking = false, granted = false;
};
TafResult ask(TrackAheadFree& state, Place est_front, bool acknowledged);

}  // namespace evc::protection
