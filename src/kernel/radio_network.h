#pragma once
#include <cstdint>
#include <optional>

#include "base/inplace_vector.h"
#include "base/units.h"

namespace evc::kernel {

/// The radio network of the mobile terminals (3.5.6).
struct RadioNetwork {
  InplaceVector<std::uint32_t, 16> offered;  // to the driver, NID_MN; the first is the default
  std::optional<std::uint32_t> NID_MN;       // the last one of trackside or driver
  bool frmcs_only = false;                   // the type of trackside: it has no GSM-R (3.5.6.5 of 4.0.0)
  bool changed = false;                      // in this cycle: a registration is due
  bool registered = true;                    // a terminal is, say the terminals
  bool awaited = false;                      // a call waits for the terminal that has to register
  bool by_driver = false;                    // the driver changes it: list or registration is awaited (3.18.4.3.6)
  std::optional<Duration> ordered;           // when the last registration was
};

/// A.3.1 of 4.0.0: a registration that takes longer has failed.
inline constexpr Duration kRegistrationTime{40.0};
constexpr bool registration_failed(const RadioNetwork& network, Duration now) {
  return !network.registered && (!network.ordered || now - *network.ordered >= kRegistrationTime);
}

/// Whether a session with an RBC can be set up: a terminal is registered, and trackside has GSM-R (3.5.6.7).
constexpr bool callable(const RadioNetwork& network) { return network.registered && !network.frmcs_only; }

}  // namespace evc::kernel
