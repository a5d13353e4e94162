#pragma once
#include <cstdint>

namespace evc {

/// What transmits information from the trackside: a balise group, a loop, a radio infill unit, an
/// RBC.
enum class Medium : std::uint8_t { balise, loop, riu, rbc };

}  // namespace evc
