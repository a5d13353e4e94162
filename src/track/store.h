#pragma once
#include <cstdint>

#include "terms/clause.h"
#include "track/description.h"

namespace evc::track {

/// What happened to a packet: stored (no clause), or refused or deleted because of the clause; refused without a
/// clause: no room.
struct Note {
  std::uint8_t packet = 0;
  enum class What : std::uint8_t { stored, refused, shortened, full } what = What::stored;
  Clause clause;
};
struct Stored {
  bool ma_accepted = false, ma_refused = false;
  Clause ma_refused_by;     ///< what does not permit it; none: no room
  bool shortened = false;   ///< the new MA was a shortening: data beyond the new SvL were deleted (3.8.5.1.3)
  bool trip_order = false;  ///< V_MAIN = 0, not infill (3.11.6.2)
  /// Restrictive data from this place on did not fit: the authority was ended there.
  std::optional<Place> lost_from;
  bool track_description_deleted = false;  ///< at the train: a reason to ask for an authority (3.8.2.7.3)
  InplaceVector<Note, 40> notes;
};

/// Whether SSP and gradient, stored or in the same message, reach without a hole from the estimated front end (or the
/// infill reference) to the SvL of the MA, for an LOA to the LOA (3.7.2.3). `ma` need not be that of `c`; it has a
/// section.
bool complete(const Description& d, const Contents& c, const MovementAuthority& ma, const Here& here);
/// The same with what is stored alone.
bool complete(const Description& d, const MovementAuthority& ma, const Here& here);
/// Whether the MA that is stored is still covered; true without one.
bool complete(const Description& d, const Here& here);

/// Where SSP or gradient end in rear of the end of the MA that is stored. The trackside must not let that happen
/// (3.7.2.2), but new profiles that end nearer replace the old ones (3.7.3.1), and packet 16 moves the end.
std::optional<Place> undescribed_from(const Description& d, const Here& here);

/// Of a new mode profile: areas that were entered by the stored one are accepted still (5.9.2.7).
void carry_acceptance(ModeProfile& fresh, const Description& stored, const Here& here);

/// An area whose begin the train has not reached is accepted while the train is in its mode only; in another one its
/// begin is a temporary EOA again (3.12.4.7). True: one was accepted before.
bool forget_acceptance_ahead(ModeProfile& profile, Mode mode, const Here& here);
/// The same of the profile that is stored.
void forget_acceptance_ahead(Description& d, Mode mode, const Here& here);

/// Stores the contents of a message: shortening first, then the MA if it is complete, then each packet by its rule of
/// 3.7.3. `refuse_ma`: the clause because of which an MA cannot be accepted now (3.10.2.4 pending emergency stop, 4.8.3
/// [3] train data not acknowledged), or none. Data that do not fit are noted; if they restrict the train, authority and
/// track description end there (Stored::lost_from).
Stored store(Description& d, const Contents& c, const Here& here, Clause refuse_ma = {});
/// The same for an authority alone: the one that a request to shorten brings (3.8.6); the marker of limited supervision
/// stays (4.4.19.1.4.8).
Stored store(Description& d, const AuthorityContents& c, const Here& here);

}  // namespace evc::track
