#pragma once
#include <cstdint>
#include <optional>

#include "track/description.h"

// Passing the end of the authority (3.13.10.2.6-7), and the track ahead free request (3.15.5).
namespace evc::protection {

/// Condition [12]: the min safe antenna position beyond EOA or LOA, level 1.
bool passes_end_level_1(const track::Authority& authority, const track::Here& here);
/// Condition [16]: the min safe front end beyond EOA or LOA, level 2 and 3.
bool passes_end_level_2(const track::Authority& authority, const track::Here& here);
/// 4.0.0, level 2, read in release speed monitoring (3.13.10.2.6 b): a group whose first possible location by linking
/// is at or beyond the EOA, or in rear of it by less than the distance from antenna to front end.
bool group_trips(const track::Authority& authority, Place first_possible, Distance L_antenna_front);
/// Track ahead free request (message 34; 3.15.5).
struct TrackAheadFree {
  std::optional<Place> from, to;
  bool asking = false;
};
void request(TrackAheadFree& state, Place from, Place to);
/// The state says whether the driver is asked now; an acknowledgement ends it: true, message 149 is due.
bool ask(TrackAheadFree& state, Place est_front, bool acknowledged);

}  // namespace evc::protection
