#pragma once
#include <cstdint>
#include <optional>

#include "base/inplace_vector.h"
#include "base/units.h"
#include "kernel/intake/reception.h"
#include "lang/packets/packet_3.h"
#include "train/national_values.h"

namespace evc::kernel {

/// National values of packet 3 (3.18.2): the values, their areas, and the place from which they are
/// valid, D_VALIDNV after the reference; absent: at once.
struct ReceivedNationalValues {
  train::NationalValues values;
  InplaceVector<std::uint16_t, 32> areas;  // NID_C
  std::optional<Distance> D_VALIDNV;
};

/// Packet 3 in SI. Correction factors that it does not contain (Q_NVKINT = 0, or no set for the train's brakes) have
/// the defaults of A.3.2.
ReceivedNationalValues read(const lang::Packet3& packet);

/// National values come into force (3.18.2.4).
void use_national_values(State& state, const train::NationalValues& values,
                         const InplaceVector<std::uint16_t, 32>& areas);
/// Each cycle: pending values come into force where the estimated front end passes their place (3.18.2.3); values that
/// are not valid in the country of the group just passed are replaced by the defaults (3.18.2.9 c).
void advance_national_values(Reception& r);
void leave_area(Reception& r, std::uint16_t NID_C);

}  // namespace evc::kernel
