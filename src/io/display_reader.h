#pragma once
#include <string_view>

#include "port/display.h"

namespace evc::io {

/// Reads the record of the display (`evc-dmi/1`, the value of the key `dmi` of an output line): the reverse of
/// `append_display`, to a millionth of its units. False where the text is none; `display` is then not to be used. It
/// throws nothing, so that it works in the WebAssembly module of the cab too. What the record leaves out because the
/// display does not show it is as in a new record.
[[nodiscard]] bool read_display(std::string_view text, port::Display& display);

}  // namespace evc::io
