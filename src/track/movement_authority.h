#pragma once
#include <cstdint>
#include <optional>

#include "base/inplace_vector.h"
#include "base/location.h"
#include "base/units.h"
#include "terms/release_speed.h"

namespace evc::track {

/// A release speed as ordered (7.5.1.160): given, the national one, or computed on board.
struct Release {
  ReleaseSpeedChoice kind = ReleaseSpeedChoice::none;
  Speed V{};
  friend constexpr bool operator==(const Release&, const Release&) = default;
};

/// A timer of the movement authority. `limit` absent: infinite.
struct Timer {
  std::optional<Duration> limit;
  Duration started{};
  bool running = false;
  bool expired_at(Duration now) const { return running && limit && now - started > *limit; }
  /// With any limit: it has run out before `now`.
  void run_out(Duration now) { *this = {Duration{}, now - Duration{1.0}, true}; }
  friend constexpr bool operator==(const Timer&, const Timer&) = default;
};

struct Section {
  Place begin{}, end{};
  bool timed = false;
  bool ran_back_behind_stop = false;  ///< the train, after the timer was stopped: timed out at standstill (3.8.4.2.4)
  Timer timer{};  ///< counts from the MA's time stamp; stops when the min safe front end passes `stop` (3.8.4.2)
  Place stop{};
  friend constexpr bool operator==(const Section&, const Section&) = default;
};
struct EndSectionTimer {
  Place start{};
  Timer timer{};
  friend constexpr bool operator==(const EndSectionTimer&, const EndSectionTimer&) = default;
};
struct DangerPoint {
  Place at{};
  Release release{};
  friend constexpr bool operator==(const DangerPoint&, const DangerPoint&) = default;
};
struct Overlap {
  Place start{};  ///< of the timer
  Place end{};
  Timer timer{};
  Release release{};
  friend constexpr bool operator==(const Overlap&, const Overlap&) = default;
};

/// A movement authority (packets 12 and 15; 3.8). Sections are contiguous; the last one's end is the EOA, or
/// the LOA when `V_LOA` is not zero.
struct MovementAuthority {
  InplaceVector<Section, 32> sections;
  Speed V_LOA{};
  Timer loa_timer{};
  std::optional<EndSectionTimer> end_section;
  std::optional<DangerPoint> danger_point;
  std::optional<Overlap> overlap;
  std::optional<Place> fixed_SvL;        ///< set when the MA was shortened (3.8.4.1.2, 3.10.2.2, 3.7.2.3, A.3.4 [11])
  std::optional<Release> fixed_release;  ///< set when the MA was shortened: V_NVREL or none
  bool level_1 = false;
  bool ended_at_train = false;  ///< A.3.4 [11]: a section that times out changes nothing any more (3.8.4.2.2)
  Anchor anchor{};

  bool limited() const { return V_LOA > Speed{}; }        ///< ends with an LOA
  Place start() const { return sections.front().begin; }  ///< needs a section
  Place end() const { return sections.back().end; }       ///< EOA or LOA; requires a section
  /// The supervised location (3.8.4.5); absent while an LOA is supervised.
  std::optional<Place> SvL() const;
  /// The same if the LOA were an EOA; needs a section.
  Place SvL_without_LOA() const;
  /// The place up to which SSP and gradient are required (3.7.2.3): the SvL, or the LOA of a limited authority;
  /// requires a section.
  Place far_end() const;
  /// The release speed of the EOA (3.13.9.4.4).
  Release release() const;
  friend constexpr bool operator==(const MovementAuthority&, const MovementAuthority&) = default;
};

/// What is supervised at the end of the authority: an LOA, or an EOA with its SvL; nothing without an authority. A
/// temporary EOA (area of a mode profile, unsuitable route, level crossing; 3.12) replaces an EOA or LOA in advance of
/// it; in 4.0.0 an LOA stays beside it (3.13.1.5).
struct Authority {
  std::optional<Place> EOA, SvL;
  std::optional<Place> LOA;  ///< with an EOA too: a temporary one of 4.0.0
  Speed V_LOA{};
  Release release{};
  /// Whether the LOA is the nearer end.
  constexpr bool ends_with_LOA() const { return LOA && (!EOA || *LOA < *EOA); }
  constexpr std::optional<Place> EOA_or_LOA() const { return ends_with_LOA() ? LOA : EOA; }
  friend constexpr bool operator==(const Authority&, const Authority&) = default;
};

}  // namespace evc::track
