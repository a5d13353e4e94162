#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "lang/schema.h"

namespace evc::lang {

/// Mandatory and optional packets of a message (SUBSET-026-8 8.6, 8.7).
struct MessageRules {
  std::uint8_t NID_MESSAGE;
  const char* name;
  Direction direction;
  Versions versions;
  Media media;                                            ///< RBC, RIU or both
  const char* priority;                                   ///< "N", "E or N"
  bool version_invariant;                                 ///< the same for every X (8.4.4.1.1)
  std::array<std::span<const std::uint8_t>, 3> required;  ///< in this order, one packet of each set
  std::span<const std::uint8_t> optional;
  std::span<const std::uint8_t> optional_from_rbc;
  std::span<const std::uint8_t> optional_from_riu;
  const char* ref;
  const char* note;
};

/// One row per message and group of versions with the same lists.
std::span<const MessageRules> message_rules();
/// The row for a message in system version `sv` (or the newest known with the same X); null if unknown.
const MessageRules* find_message_rules(Direction direction, std::uint8_t NID_MESSAGE, SystemVersion sv);

}  // namespace evc::lang
