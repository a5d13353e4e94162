#pragma once
#include <cstdint>
#include <optional>

#include "base/inplace_vector.h"
#include "base/location.h"
#include "kernel/log.h"
#include "lang/telegram.h"
#include "modes/acceptance.h"
#include "terms/medium.h"
#include "terms/srs_version.h"

// One consistent message, from a balise group or by radio.
namespace evc::kernel {

/// What a balise group or a loop says about the version to operate (3.17.2.3, 3.17.2.6).
struct SenderVersion {
  std::uint8_t X = 0;          // the highest of the telegrams of a group
  bool other_country = false;  // than those of the national values that were applicable when it was passed
};

/// A message whose bits are correct, with the reference of its distances.
struct Information {
  Medium medium = Medium::balise;
  SessionRole sender = SessionRole::supervising;  // by radio
  GroupId group;                                  // passed, or the LRBG of the radio message; of a loop the country
  Place reference{};                              // of it, D_REF included
  Anchor anchor{};                                // what it hangs on, and how its places move because of that
  Relocation widening;
  // False: the LRBG of the message is unknown or not remembered, or it is a loop's. Only infill has a place then.
  bool located = true;
  Direction orientation = Direction::unknown;  // of the train relative to it (in SL, PS, SH: crossing direction)
  Place min_safe_front{};
  Duration time{};                       // time stamp, or passage of the group's first balise
  bool marked_unlinked = false;          // by a group (Q_LINK)
  bool repositioning = false;            // sent by the group that linking announced with unknown identity (3.8.5.2.2)
  std::uint8_t M_VERSION = 0;            // of its session
  std::optional<SenderVersion> version;  // absent: by radio, or from the transition buffer
  InplaceVector<lang::PacketView, lang::kPacketsMax> packets;
  const lang::MessageToTrainView* message = nullptr;  // by radio
  // The packets to judge: all, or the buffered ones of a set released from the transition buffer.
  std::uint64_t judge_packets = ~std::uint64_t{0};
  bool judge_message = true;
};

/// The part of a message that is buffered (4.8.5).
struct Waiting {
  std::uint64_t packets = 0;
  bool message = false;
  bool any() const { return packets != 0 || message; }
};

/// The version of an RBC with this M_VERSION, as a unit of this SRS knows it; 2.1 before it sent its own (0).
lang::SystemVersion session_version(std::uint8_t M_VERSION, SrsVersion srs);

/// Adds the packets that count for the train's direction, in the order of reading; their bytes must outlive them. False
/// when there are more than fit. `log`: of what is ignored; none when the message was logged before (the transition
/// buffer).
bool gather(Information& information, const lang::PacketViews& packets, const Log* log);
/// Packets of version 1.0 that others of the same message replace are ignored (6.6.3.2.3 [9], [11], [13]).
void drop_superseded(Information& information, const Log* log);

}  // namespace evc::kernel
