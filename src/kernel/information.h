#pragma once
#include <cstdint>
#include <optional>

#include "kernel/cycle.h"
#include "lang/telegram.h"
#include "modes/acceptance.h"
#include "modes/information.h"
#include "track/from_packets.h"

// One consistent message, from a balise group or by radio, through the filters of 4.8 into the stores.
namespace evc::kernel {

/// A message whose bits were found right, with what its distances count from.
struct Information {
  Medium medium = Medium::balise;
  GroupId group;                               // the group passed, or the LRBG of the radio message
  Place reference{};                           // of it, D_REF included
  Direction orientation = Direction::unknown;  // of the train against it (in SL, PS, SH: crossing direction)
  Place min_safe_front{};
  Duration time{};  // time stamp, or passage of the group's first balise
  lang::SystemVersion sv;
  InplaceVector<lang::PacketView, lang::kPacketsMax> packets;
  const lang::MessageToTrainView* message = nullptr;  // by radio
  // The packets to judge: all, or of a set released from the transition buffer those that were buffered.
  std::uint64_t judge_packets = ~std::uint64_t{0};
  bool judge_message = true;
  bool released = false;
};

/// What the filters left to wait in the transition buffer.
struct Waiting {
  std::uint64_t packets = 0;
  bool message = false;
  bool any() const { return packets != 0 || message; }
};

/// Evaluates a message (4.8): level orders first, then linking, then the rest together; stores what is accepted and
/// acts on what is not stored. Events name everything that was accepted, refused or left to wait.
Waiting evaluate(Cycle& cycle, const Information& information);

}  // namespace evc::kernel
