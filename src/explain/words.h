#pragma once
#include <array>
#include <cstdint>
#include <string>

#include "base/units.h"
#include "brakes/brakes.h"
#include "explain/why.h"
#include "kernel/state.h"

// Short phrases of an explanation.
namespace evc::explain {

/// "12.7 s".
std::string time_words(std::int64_t t_ms);
/// "message 3 (Movement Authority)".
std::string message_words(std::uint8_t NID_MESSAGE);
/// "40 km/h", rounded to a tenth.
std::string kmh_words(Speed v);
/// "12.5 m".
std::string metres_words(Distance d);
/// "455.6 m": the nominal counter of a front end at a place, as the outputs have it.
std::string place_words(const kernel::State& state, Place place);
std::string place_words(const position::State& position, Place place);
/// "120.00 km/h" and "119.86 km/h": with as many digits as make them differ, at most six.
std::array<std::string, 2> different_kmh_words(Speed a, Speed b);
/// "MA, SSP and gradient are stored", or what is so instead.
std::string words(const Literal& literal);
/// Its terms. Of a condition that does not hold: what has to change, alternatives joined by " / ", what has to change
/// too by "; ". Of one that holds: what all hold together joined by " and ", several that would hold alone by "; also
/// ".
std::string words(const Reason& reason);
/// "service brake", "trip", "none" of a link or of T_NVCONTACT.
const char* reaction_words(Reaction reaction);
/// "service brake".
const char* words(brakes::Kind kind);

}  // namespace evc::explain
