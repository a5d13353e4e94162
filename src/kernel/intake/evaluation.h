#pragma once
#include <cstddef>
#include <cstdint>

#include "kernel/intake/message.h"
#include "kernel/intake/reception.h"
#include "modes/acceptance.h"
#include "track/from_packets.h"

namespace evc::kernel {

/// One message on its way through the filters of 4.8 into the stores.
struct Evaluation {
  Reception& r;
  const Information& information;
  modes::AcceptanceContext context;  ///< what the exceptions of the tables ask for
  track::Contents& contents;         ///< what is accepted and will be stored
  track::Reference reference;        ///< of the part that is judged: the message, or what stands behind packet 136
  std::uint64_t judge = 0;           ///< bit n: the n-th packet belongs to that part
  Waiting waiting;
  std::uint8_t refused = 0;
  Clause refused_because;  ///< of the last one; none for want of room
};

constexpr bool judged(const Evaluation& e, std::size_t i) { return ((e.judge >> i) & 1u) != 0; }

/// Something of the message was refused because of the clause.
constexpr void refuse(Evaluation& e, Clause clause) {
  ++e.refused;
  e.refused_because = clause;
}

}  // namespace evc::kernel
