#pragma once
#include "kernel/state.h"
#include "track/services.h"

// The two halves of kernel::show (evc.h).
namespace evc::kernel {

/// What the driver reads, is asked and may do: texts, acknowledgements, stored data, buttons. `may`: what
/// the mode shows (4.7.2). The local time is in `display` already.
void show_to_driver(const State& state, const Outputs& outputs, Set<DriverOutput> may, const track::Here& here,
                    Display& display);

/// Local time of day, `ago` before the moment of `clock`.
std::uint32_t second_of_day(const DateTime& clock, Duration ago);

}  // namespace evc::kernel
