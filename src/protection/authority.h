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

/// Override (5.8). Active from the driver's selection until one of its ends.
struct Override {
  bool active = false;
  Duration since{};
  OdometerPlace from{};
  std::optional<Place> former_end;  ///< EOA or LOA that may be passed; condition [43] supervises it in SR
  bool former_end_passed = false;
};
struct OverrideInputs {
  Duration now{};
  OdometerPlace nominal{};
  bool standstill = false;
  Speed V_est{}, V_NVALLOWOVTRP{};
  std::optional<Distance> D_NVOVTRP;
  std::optional<Duration> T_NVOVTRP;
  Place min_safe_antenna{}, min_safe_front{};
  bool level_1 = false;
  bool trip_would_occur = false;  ///< a balise group with stop information was passed, or another trip was inhibited
  bool new_authority = false;     ///< an MA or SR authorisation was accepted
  std::uint8_t M_MODE = 0;
};
/// The driver selects override: granted when the speed allows (5.8.3.1). Condition [37].
bool select(Override& state, const OverrideInputs& in, std::optional<Place> end_of_authority);
/// Every cycle: time and distance, the former EOA, a trip that was inhibited, or a mode other than SR, SH, UN, SN end
/// it (5.8.4).
void supervise(Override& state, const OverrideInputs& in);
/// Condition [43].
bool passes_former_end(const Override& state, const track::Here& here, bool balise_antenna);

/// Distance that may be run in SR (4.4.11).
struct StaffResponsible {
  std::optional<Place> distance_end;
  std::optional<Speed> V_by_driver;
};
/// Condition [42].
bool passes_distance_end(const StaffResponsible& sr, const track::Here& here, bool override_active);
/// Condition [36], [52]: a group that is not in the list (an absent list lets all pass).
bool outside_list(const std::optional<track::GroupList>& list, track::BaliseGroupId group);
/// Condition [54]: "stop if in SR", unless the group is in a list that was received; with system version 1 in any case.
bool stopped_in_sr(bool stop_if_in_sr, const std::optional<track::GroupList>& list, track::BaliseGroupId group,
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
