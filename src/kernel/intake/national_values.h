#pragma once
#include <cstdint>
#include <optional>

#include "base/inplace_vector.h"
#include "base/units.h"
#include "kernel/intake/message.h"
#include "kernel/intake/reception.h"
#include "lang/packets/packet_3.h"
#include "train/national_values.h"

namespace evc::kernel {

/// National values of packet 3 (3.18.2), and the place from which they are valid, D_VALIDNV after the reference;
/// absent: at once.
struct ReceivedNationalValues {
  NationalSet set;
  std::optional<Distance> D_VALIDNV;
};

/// Packet 3, sent in version X, in SI. Correction factors that it does not contain (Q_NVKINT = 0, or no set for the
/// train's brakes) have the defaults of A.3.2.
ReceivedNationalValues read(const lang::Packet3& packet, std::uint8_t X);
/// D_VALIDNV of packet 3, sent in version X; absent: the values are valid at once. In X = 1 every code is a distance
/// (6.5.1.5.26).
std::optional<Distance> start_of_validity(const lang::Packet3& packet, std::uint8_t X);
/// The values for braking curves of packet 203 in the message of a packet 3 of X = 1 (6.6.3.2.3 [16]); false: it
/// has none ([2]).
bool join_braking_curves(const Information& information, train::NationalValues& values);

/// National values come into force (3.18.2.4, 3.18.2.8.1); those that the set does not contain stay.
void use_national_values(State& state, const NationalSet& set);
/// Each cycle: pending values come into force where the estimated front end passes their place (3.18.2.3); values that
/// are not valid in the country of the group just passed are replaced by the defaults (3.18.2.9 c).
void advance_national_values(Reception& r);
void leave_area(Reception& r, std::uint16_t NID_C);
/// Whether the country or region of a balise group differs from those of the national values (3.17.2.6, 3.18.2.5).
/// Values of the configuration and defaults have none to differ from.
bool in_another_country(const State& state, std::uint16_t NID_C);

}  // namespace evc::kernel
