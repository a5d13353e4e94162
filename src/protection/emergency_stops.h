#pragma once
#include <cstdint>

#include "base/inplace_vector.h"
#include "terms/clause.h"
#include "track/description.h"

// Emergency messages (3.10).
namespace evc::protection {

struct EmergencyStop {
  std::uint8_t NID_EM = 0;
  bool conditional = false;
  Place at{};
  friend constexpr bool operator==(const EmergencyStop&, const EmergencyStop&) = default;
};
/// The accepted stops that are not revoked, keyed by NID_EM (4 bits).
struct EmergencyStops {
  InplaceVector<EmergencyStop, 16> pending;
  bool any() const { return !pending.empty(); }
  bool unconditional_pending() const;
};

/// The answer for message 147: Q_EMERGENCYSTOP 0 conditional accepted, EOA or LOA changed; 1 accepted, not changed;
/// 2 unconditional accepted; 3 conditional refused, the place is passed (7.5.1.107).
struct Answer {
  bool accepted = false;
  std::uint8_t Q_EMERGENCYSTOP = 3;
  Clause clause;
};

/// A conditional emergency stop (message 15). `min_front_at_reception`: the test uses the position at reception of the
/// message, even if it was buffered (4.8.5.7). An accepted one shortens the MA (3.10.2.2).
Answer accept_conditional(EmergencyStops& stops, track::Description& d, std::uint8_t NID_EM, Place stop,
                          Place min_front_at_reception, const track::Here& here);
/// An unconditional emergency stop (message 16): the train trips (3.10.2.3).
Answer accept_unconditional(EmergencyStops& stops, std::uint8_t NID_EM);
/// Message 18: revokes only the stop with its identity (3.10.3.3). False: no such stop, the message
/// is ignored.
bool revoke(EmergencyStops& stops, std::uint8_t NID_EM);
/// The value for an RBC of system version 1 (6.6.3.4.5).
std::uint8_t Q_EMERGENCYSTOP_for_version_1(std::uint8_t Q_EMERGENCYSTOP);

}  // namespace evc::protection
