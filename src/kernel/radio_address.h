#pragma once
#include <optional>

#include "kernel/port.h"
#include "radio/messages.h"

// The RBC of an input or output of the bearer.
namespace evc::kernel {

inline RbcAddress address_of(const radio::Rbc& rbc) { return {rbc.NID_C, rbc.NID_RBC, rbc.NID_RADIO, rbc.infill_unit}; }

/// Without a name it is the RBC, or radio infill unit, called last (radio::peer_of).
inline std::optional<radio::Rbc> named_rbc(const std::optional<RbcIdentity>& identity, bool infill_unit = false) {
  if (!identity) return std::nullopt;
  return radio::Rbc{identity->NID_C, identity->NID_RBC, 0, infill_unit};
}

}  // namespace evc::kernel
