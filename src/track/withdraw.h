#pragma once
#include <cstdint>

#include "terms/stored.h"
#include "track/description.h"

namespace evc::track {

/// Situations of A.3.4 in which stored data are shortened or deleted.
enum class Situation : std::uint8_t {
  a_conditional_emergency_stop,
  b_shortened_ma,
  c_section_timeout,
  d_overlap_timeout,
  e_end_section_timeout,
  f_shortening_granted,
  g_unlinked_group_inconsistent,
  h_linking_reaction,
  i_radio_contact_lost,
  j_train_data_changed,
  k_desk_closed_during_start,
  l_rams_supervision,
  m_linked_group_inconsistent,
  n_loa_became_eoa,
};

/// Deletes from `d` what A.3.4 deletes. a-d, f, n: beyond `cut` (the new SvL; for a the stop location); e, g-j, l, m:
/// beyond the max safe front end, the EOA becomes the estimated and the SvL the max safe front end, without release
/// speed; k: everything listed. `shunting`: the train is in SH (its list is kept). Returns whether part of the track
/// description was deleted in a situation after which an MA is requested (3.8.2.7.3).
bool shorten(Description& d, Situation situation, Place cut, const Here& here, bool shunting = false);

/// Signalling related speed restrictions end at a place: those beyond it are deleted, one across it is cut.
void end_signalling_speed(Description& d, Place at);

/// Applies a conditional emergency stop to the MA (3.10.2.2). Returns Q_EMERGENCYSTOP for message 147, 0: EOA or LOA
/// changed, 1: not changed. The caller has checked that the stop is not passed. Deletes data by A.3.4 a.
std::uint8_t stop_at(Description& d, Place stop, const Here& here);

/// Ends authority and track description at `place`, or at the train if that is nearer: beyond it data are missing
/// (3.7.2.3). Returns whether the track description was deleted there, which is a reason to ask for an authority.
[[nodiscard]] bool end_before(Description& d, Place place, const Here& here);

/// Events of the running supervision of stored data.
struct Elapsed {
  bool section_timeout = false, overlap_timeout = false, end_section_timeout = false, loa_timeout = false;
  bool track_description_deleted = false;  ///< reason 8 of the MA request
  bool any() const { return section_timeout || overlap_timeout || end_section_timeout || loa_timeout; }
};
/// D_KEEP_REAR (A.3.1): speed restrictions, gradient, adhesion and big metal masses are stored up to this distance
/// behind the min safe rear end.
inline constexpr Distance kKeptBehind{300.0};
/// Every cycle: timers of the MA (3.8.4), and deletion of data no longer needed (A.3.6): what is farther behind than
/// kKeptBehind, and areas passed.
Elapsed advance(Description& d, const Here& here);

/// The train has the other orientation: everything ahead of it is deleted, but for the list of groups that may be
/// passed in SH; the geographical position goes on (3.6.6.4.3, 3.11.5.10, 5.12), and so do texts that do not wait for a
/// place ahead, with the brake that one asks for (4.10 and 4.12, entry of SM); where they end lies in rear now.
void turn(Description& d);

/// Deletes (resets to the initial state) the data of a row of 4.10.1.3, as required by the tables of 4.9 and 4.10 in
/// modes/. False when that row is not stored in the track description.
bool forget(Description& d, evc::Stored stored);

}  // namespace evc::track
