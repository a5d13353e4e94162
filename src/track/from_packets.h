#pragma once
#include <cstdint>
#include <optional>

#include "base/location.h"
#include "lang/messages.h"
#include "lang/telegram.h"
#include "track/description.h"

// Conversion of packets into the track frame (3.6.2, 3.6.3).
namespace evc::track {

/// The reference of the distances of a packet: the group that sent it, the LRBG of a radio message (shifted by D_REF),
/// or the infill location reference.
struct Reference {
  Place place{};
  /// Of the train relative to the group (in SL, PS, SH: the direction in which the group was crossed, 3.6.3.1.3).
  Direction orientation = Direction::unknown;
  /// The sender, or the LRBG of a radio message: the first group of a packet is of its country unless the packet says
  /// otherwise, in an infill too (7.5.1.121).
  GroupId group{};
  Medium medium = Medium::balise;
  Duration now{};
  std::optional<GroupId> infill;  ///< the infill location reference

  /// The group at `place`.
  constexpr GroupId origin() const { return infill ? *infill : group; }
};

/// Whether information with this Q_DIR counts for the orientation; with an unknown orientation only "both" counts
/// (3.6.3.1.3-4).
bool valid_direction(std::uint8_t Q_DIR, Direction orientation);

/// The reference of messages 15, 33 and 34: shifted by D_REF, positive in the nominal direction of the LRBG (7.5.1.22).
Reference shifted(const Reference& reference, Distance D_REF);
/// The stop location of a conditional emergency stop (message 15); absent when its direction is not the train's.
std::optional<Place> stop_location(const lang::Message15& message, const Reference& lrbg);

/// Empties `contents` for the next message, or for its infill part (3.6.2.3.1) from the place `infill` on. In place: it
/// is too large for a stack. `time`: see Contents::time.
void begin(Contents& contents, const Reference& reference, Duration time,
           const std::optional<Place>& infill = std::nullopt);

enum class Added : std::uint8_t {
  added,
  other_direction,  ///< 3.6.3.1.3
  not_stored_here,  ///< another room's packet
  faulty            ///< the packet does not decode; the message should have been rejected
};
/// Adds a packet to the contents of its message.
Added add(Contents& contents, const lang::PacketView& view, const Reference& reference);
/// The groups of packet 63, which message 2 brings (4.4.11.1.3.2 f); absent: for the other direction, or faulty.
std::optional<GroupList> sr_list(const lang::PacketView& view, const Reference& reference);
/// The same with an authority that is judged before it counts (4.8.3 [4], 3.8.6): packets 12, 15, 49 and 80 only.
/// `time`: see Contents::time.
Added add(AuthorityContents& contents, Duration time, const lang::PacketView& view, const Reference& reference);

}  // namespace evc::track
