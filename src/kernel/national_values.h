#pragma once
#include <cstdint>
#include <optional>

#include "base/inplace_vector.h"
#include "base/units.h"
#include "lang/packets/packet_3.h"
#include "train/national_values.h"

namespace evc::kernel {

/// National values as packet 3 brings them (3.18.2): the values, the areas they are for, and the
/// place from which they hold, D_VALIDNV after the reference; absent: at once.
struct ReceivedNationalValues {
  train::NationalValues values;
  InplaceVector<std::uint16_t, 32> areas;  // NID_C
  std::optional<Distance> D_VALIDNV;
};

/// Packet 3 in SI. Correction factors that it does not carry (Q_NVKINT = 0, or no set for the train's
/// brakes) take the defaults of A.3.2.
ReceivedNationalValues read(const lang::Packet3& packet);

}  // namespace evc::kernel
