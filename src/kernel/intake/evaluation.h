#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>

#include "kernel/intake/message.h"
#include "kernel/intake/reception.h"
#include "kernel/stored.h"
#include "modes/acceptance.h"
#include "track/from_packets.h"

namespace evc::kernel {

/// One message while it is filtered (4.8) and stored.
struct Evaluation {
  Reception& r;
  const Information& information;
  modes::AcceptanceContext context;        ///< facts for the exceptions of the tables
  track::Contents& contents;               ///< accepted contents, to be stored
  track::Reference reference;              ///< of the evaluated part: the message, or the packets after packet 136
  std::uint64_t judge = 0;                 ///< bit n: the n-th packet belongs to that part
  std::optional<std::size_t> level_order;  ///< the last packet of that part that announces a level transition
  Waiting waiting;
  std::uint8_t refused = 0;
  Clause refused_because;  ///< of the last one; none: no room
  Brought brought{};
};

constexpr bool judged(const Evaluation& e, std::size_t i) { return ((e.judge >> i) & 1u) != 0; }

/// What the places of the evaluated part hang on: linking knows an infill location reference.
constexpr Anchor anchor_of(const Evaluation& e) { return e.contents.infill ? Anchor::lrbg : e.information.anchor; }

/// Part of the message was refused because of the clause.
constexpr void refuse(Evaluation& e, Clause clause) {
  ++e.refused;
  e.refused_because = clause;
}

}  // namespace evc::kernel
