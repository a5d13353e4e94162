#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "dmi/screen.h"

namespace evc::screen {

/// JSON with the members in the order in which they were added.
using OrderedJson = nlohmann::ordered_json;

/// The items of a display list in drawing order (docs/dmi.md). Behind each button, key, field and title are its
/// rectangles, and at the end the places of touch that show nothing.
OrderedJson items_of(const dmi::Screen& screen);
/// The places that react to touch, the topmost first.
OrderedJson touch_of(const dmi::Screen& screen);
/// One item.
OrderedJson json_of(const dmi::Item& item);
/// The sound with what it does: {"id": "Sinfo", "times": 1}, {"id": "S2", "do": "loop"}.
OrderedJson json_of(const dmi::SoundOrder& order);

/// A complete document, `evc-screen/1`, with a line for each item.
std::string screen_json(const dmi::Screen& screen);

}  // namespace evc::screen
