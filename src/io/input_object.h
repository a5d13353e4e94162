#pragma once
#include <cstdint>
#include <optional>

#include "io/input_stream.h"

// One object of a stream of inputs, for whoever has it without a stream around it.
namespace evc::io {

/// Makes the inputs of an object, which came at `t_ms`, inputs of the cycle; those of the radio are appended to
/// `radio`. `entered`: where a train that the driver enters is read to. Throws ReadError; the cycle is then not to be
/// used.
void read_inputs(const JsonPlace& object, std::int64_t t_ms, const Configuration& configuration,
                 InputStream::Radio& radio, std::optional<Train>& entered, sim::CycleInputs& cycle);

/// Moves into the cycle what it has room for: one report of the bearer. A second one, and radio messages after it, are
/// left for the next cycle.
void deliver_radio(sim::CycleInputs& cycle, InputStream::Radio& radio);

}  // namespace evc::io
