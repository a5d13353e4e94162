#pragma once
#include <cstdint>
#include <optional>
#include <span>

#include "base/set.h"
#include "terms/srs_version.h"
#include "track/description.h"

// Queries and updates of the track description by other rooms.
namespace evc::track {

inline constexpr std::size_t kMrspSteps = 128;
using Mrsp = StepFunction<Place, Speed, kMrspSteps>;
/// Per mille, positive uphill.
using GradientFunction = StepFunction<Place, double, 96>;

/// A speed limit from outside the track description: mode, train, override, STM. An absent end is
/// open.
struct Limit {
  std::optional<Place> from, to;
  Speed V{};
};
/// Which stored restrictions count (4.5.2, for each mode).
struct MrspElements {
  bool ssp = true, asp = true, tsr = true, pbd = true, lx = true, signalling = true;
};
struct MrspQuery {
  Place from{};  ///< start of the function, behind the train's rear end
  Distance train_length{};
  TrainCategory category{};
  InplaceVector<Limit, 8> limits;  ///< of mode, train, override
  MrspElements elements{};
  /// V_PBD of each permitted braking distance stored, in their order; one without a speed is not counted (3.11.11).
  std::span<const SpeedCode> pbd_speeds{};
};
/// The highest speed of the language (7.5.1.173): the value where there is no limit.
inline constexpr Speed kNoLimit = speed_of(120);

/// The most restrictive speed profile (3.13.7): the lowest of SSP, ASP, TSR, PBD, LX, signalling speed and `limits`,
/// with the train length delay of SSP, ASP and TSR. The speed in force is the lowest between min and max safe front
/// end. If there are more changes than fit, the lower neighbour is kept: the profile is never too high. Written into
/// `out`: it is large.
void mrsp(Mrsp& out, const Description& d, const MrspQuery& query);

/// The stored gradient, not compensated for the train length. Where it is unknown: `unknown` per mille (0, or for
/// targets of a TSR the default gradient; 3.13.4.1.2-3). Never empty: it starts at or before `from`.
/// Written into `out`: it is large.
void gradient(GradientFunction& out, const Description& d, Place from, double unknown = 0.0);

/// EOA, SvL, LOA and release speed to supervise now. `mode` is the current one: the start of an area of this mode is no
/// longer a stop, nor is one that the estimated front end has passed: such an area is entered at once (5.7.2, 5.9.2,
/// 5.19.2). In SH, SR and other modes there is no authority.
Authority authority(const Description& d, const TrainInterfaces& train, Mode mode, Place est_front,
                    SrsVersion srs = SrsVersion::v3_6_0);
/// The same of an authority with its mode profile alone, wherever the train is: the one that a request to shorten
/// brings (3.8.6.1).
Authority authority(const MovementAuthority& ma, std::span<const ModeArea> profile, Mode mode,
                    SrsVersion srs = SrsVersion::v3_6_0);

/// The driver acknowledged, or the area was entered: its start is no longer a temporary EOA.
void accept_area(Description& d, Mode mode, const Here& here);

/// Whether reduced adhesion applies at a place: between an area's start and its end plus the train length (3.13.5.3).
bool slippery(const Description& d, Place at, Distance train_length);

/// Estimated front end in rear of the first SSP or gradient stored (4.6.3 [69]).
bool before_track_description(const Description& d, const Here& here);

/// The nearest place from which the route does not suit the train (3.12.2.7).
std::optional<Place> unsuitable_from(const Description& d, const TrainInterfaces& train);

/// In what the route ahead does not suit the train (3.12.2.3).
Set<Suitability> unsuitability(const Description& d, const TrainInterfaces& train);

/// Whether SSP and gradient are known for the whole length of the train (4.4.9.1.4).
bool described_under_train(const Description& d, const Here& here);

/// What is left of the distance that may be run in RV, below 0 beyond it (3.15.4); absent: it is infinite or unknown.
std::optional<Distance> reversing_left(const Description& d, const Here& here);

/// Marks the level crossing as substituted: V_LX instead of the stop, from `from` on (5.16).
void substitute_level_crossing(Description& d, std::uint8_t NID_LX, Place from);

/// The shortest time until a section timer or the LOA speed timer of the stored MA expires, for the MA request (3.8.2.3
/// c; end section and overlap timers do not count). Absent: no such timer runs.
std::optional<Duration> time_to_timeout(const Description& d, Duration now);

/// Geographical position of the estimated front end in metres (3.6.6); absent when none applies.
std::optional<std::uint32_t> geographical_position(const Description& d, const Here& here);
/// The group of the reference is at `at`: it becomes applicable after its offset. `orientation`: of the train against
/// the group; unknown: the reference is not used (3.6.6.7).
void place(GeoReference& reference, Place at, Direction orientation, Anchor anchor = {});
/// The same for the references to a group that is passed.
void note_group(Description& d, GroupId group, Place at, Direction orientation, Anchor anchor = {});
/// Once a cycle: references become applicable; those that are not any more are deleted (3.6.6.4.2, 3.6.6.9).
void advance_geographical_position(Description& d, const Here& here);

/// Text display (3.12.3): the brake members are true while a text waits for its acknowledgement
/// beyond its end.
struct TextDisplay {
  InplaceVector<std::uint8_t, 6> shown;  ///< ids
  InplaceVector<std::uint8_t, 6> to_acknowledge;
  bool service_brake = false, emergency_brake = false;
};
/// The acknowledgement of a text is to be reported (message 158) to the RBC that it names (3.12.3.5).
struct TextReport {
  std::uint8_t NID_TEXTMESSAGE = 0;
  std::uint16_t NID_C = 0, NID_RBC = 0;
};
using TextReports = InplaceVector<TextReport, 6>;
/// What the driver acknowledged now, and what an acknowledgement does.
struct TextAcknowledgement {
  std::uint8_t id = 0;       ///< of the text, 0 none
  bool always_ends = false;  ///< whatever the text says: X = 1 is operated (6.6.2.1.1)
};
/// Whether its end was reached: beyond it a text that waits for an acknowledgement stays (3.12.3.4.7).
bool at_end(const Text& text);
/// Updates the texts, once per cycle. `NID_NTC` is used in level NTC. `reports`: those that are due now are added.
TextDisplay show_texts(Description& d, const Here& here, Mode mode, Level level, std::uint8_t NID_NTC,
                       TextAcknowledgement acknowledgement, TextReports& reports);

}  // namespace evc::track
