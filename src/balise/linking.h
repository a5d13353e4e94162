#pragma once
#include <cstdint>
#include <optional>

#include "balise/group.h"
#include "base/inplace_vector.h"
#include "lang/packets/packet_5.h"

// Linking (3.4.4, 3.16.2.3, 3.16.2.6, 3.16.2.7).
namespace evc::balise {

/// NID_BG of an announced group whose identity is not known (repositioning).
inline constexpr std::uint16_t kIdentityUnknown = 16383;
/// One packet announces up to 32 groups (1 + N_ITER 31); infill linking adds to what is stored.
inline constexpr std::size_t kLinks = 64;
/// A balise may still be detected this far behind its centre (3.16.2.3.1.1): it counts as missed only beyond this.
inline constexpr Distance kDetectionZone{1.3};

/// One announced group, placed in the track frame.
struct Link {
  Place place;  // of its reference balise: reference + sum of D_LINK
  Distance Q_LOCACC;
  GroupId id;
  Reaction reaction = Reaction::none;       // Q_LINKREACTION
  Direction crossing = Direction::unknown;  // Q_LINKORIENTATION
  bool gives_orientation = false;           // counted from a group with known orientation (3.4.2.3.2.3)
  constexpr bool identity_unknown() const { return id.NID_BG == kIdentityUnknown; }
  friend constexpr bool operator==(const Link&, const Link&) = default;
};

/// Packet 5 in SI units.
struct LinkingList {
  struct Entry {
    Distance D_LINK;
    std::optional<std::uint16_t> NID_C;  // Q_NEWCOUNTRY
    std::uint16_t NID_BG = 0;
    bool nominal = true;  // Q_LINKORIENTATION
    Reaction reaction = Reaction::none;
    Distance Q_LOCACC;
  };
  InplaceVector<Entry, 32> entries;
};

/// The packet as read, in SI. It contains no spare reaction code: decode() rejects those.
LinkingList linking_list(const lang::Packet5& packet);

/// The reference of a linking list.
struct LinkingReference {
  GroupId id;               // sender, LRBG of the message, or the infill location reference
  Place place;              // of its reference balise
  std::uint16_t NID_C = 0;  // that of the sender, for a first entry without a country (7.5.1.121)
  bool orientation_known = true;
  bool infill = false;
};

/// The verdict of linking supervision on a reference balise that was just read.
struct Judgement {
  enum class Verdict : std::uint8_t {
    unjudged,        // the reference balise has not been read yet
    unlinked,        // marked unlinked: always considered (3.4.4.4.2)
    not_used,        // linking is not used: every group is accepted (3.4.4.4.1)
    found,           // the expected one, inside its window
    repositioning,   // may be the group with unknown identity: decided when the group is complete
    outside_window,  // announced, elsewhere (3.16.2.3.1.1)
    not_announced,   // marked linked, not in the list (3.4.4.4.2)
  };
  Verdict verdict = Verdict::unjudged;
  std::optional<Link> link;  // the announced entry
};

struct LinkingState {
  InplaceVector<Link, kLinks> links;  // in running order; the first one is expected
  /// End of the window of the farthest announced group: linking is used until the antenna has passed it (3.4.4.2.1.1).
  std::optional<Place> used_until;
  std::optional<Place> previous;  // of the last linked group, where a window with unknown identity opens (3.4.4.4.4)
  /// The last group found in place, to be skipped in newer lists.
  struct Found {
    GroupId id;
    Place place;
  };
  std::optional<Found> found;
  /// Supervision against a second repositioning group (3.16.2.7.2).
  struct Repositioned {
    GroupId id;
    Place end;
    Direction crossing = Direction::unknown;
  };
  std::optional<Repositioned> repositioned;
  std::uint8_t missed_in_row = 0;  // announced groups not detected (3.16.2.7.1)
  bool detected = false;           // a balise of the expected group was read
};

/// Stores linking that passed the filters of 4.8; replaces the stored list from the reference on (3.7.3.1 m, n). Groups
/// already found and windows that have ended are left out, but not the LRBG where the train has run back behind it.
/// Returns the place of the reference: it differs from the given one if the list contains the current LRBG `current`,
/// because then the distance by linking is used (3.6.4.3); all information of the message is placed relative to it. Not
/// `complete`: the list did not fit, its farthest groups are left out.
struct Stored {
  Place reference;
  bool complete = true;
};
struct CurrentLrbg {
  GroupId id;
  Place place;
};
Stored store(LinkingState& linking, const LinkingList& list, const LinkingReference& reference,
             const PlaceInterval& antenna, const std::optional<CurrentLrbg>& current);
/// Deletes everything (4.10), or what lies beyond a place (A.3.4).
void clear(LinkingState& linking);
void clear_beyond(LinkingState& linking, Place place);

/// The reference balise of a group was read with the antenna at `antenna`: the window of the expected group
/// is tested, errors a and c of 3.16.2.3.1 react, the expectation moves on (3.4.4.4.6).
Judgement judge(LinkingState& linking, GroupId id, bool marked_linked, const PlaceInterval& antenna,
                bool linking_checked, Outcome& outcome);
/// Whether the group is in the list of announced groups.
bool announced(const LinkingState& linking, GroupId id);
/// A group whose reference balise was missed, without a duplicate, the antenna last at `antenna`: the
/// expected one counts as found with an error in its message (3.16.2.4.1 a), the expectation moves on.
Judgement judge_without_reference(LinkingState& linking, GroupId id, const PlaceInterval& antenna,
                                  bool linking_checked);
/// The repositioning group was accepted: the expectation moves on, a second one is supervised (3.16.2.7.2).
void take_repositioning(LinkingState& linking, GroupId id, const Link& link);
/// It was found with an inconsistent message: the expectation moves on (3.4.4.4.6 c).
void leave_repositioning(LinkingState& linking, const Link& link);
/// 4.0.0: a balise was detected, of any group (3.16.2.7.1.1).
void note_detection(LinkingState& linking, const PlaceInterval& antenna);
/// A group with repositioning was read, crossed in direction `crossing`: whether it is a second one
/// (3.16.2.7.2.2).
bool second_repositioning(const LinkingState& linking, GroupId id, Direction crossing);
/// Each cycle: windows that ended without their group (3.16.2.3.1 b), and two such windows in a row (3.16.2.7.1).
/// `reading`: the group that is being read and not judged yet; its window does not end before.
void end_windows(LinkingState& linking, const PlaceInterval& antenna, bool linking_checked,
                 const std::optional<GroupId>& reading, Outcome& outcome);

/// 4.0.0: linking ends when the farthest window is no longer supervised (3.4.4.2.1.1 c, 3.4.4.4.6), before its end too.
void end_with_last_window(LinkingState& linking);
/// Whether linking is used now: groups are announced, and the farthest window is not passed
/// (3.4.4.2.1.1).
bool used(const LinkingState& linking, const PlaceInterval& antenna, bool linking_checked);
/// The expected group, or null.
const Link* expected(const LinkingState& linking);
/// The first and last place where it can be found, without odometer tolerance (3.4.4.4.3, .4).
Place first_possible(const LinkingState& linking, const Link& link);
Place last_possible(const Link& link);
/// Whether the antenna may be between these places.
bool in_window(const LinkingState& linking, const Link& link, const PlaceInterval& antenna);
/// Its window for the estimated antenna place, for display: [first - under-reading, last + over-reading].
std::optional<PlaceInterval> window(const LinkingState& linking, const PlaceInterval& antenna);

}  // namespace evc::balise
