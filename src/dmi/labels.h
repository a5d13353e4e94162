#pragma once
#include <string_view>

#include "dmi/state.h"
#include "dmi/words.h"
#include "openevc/port/display.h"

// The words of the display that are no terms of the standard's tables elsewhere: in English, in one place.
namespace evc::dmi {

/// Whether the display has the abbreviation of a national system.
bool has_ntc_name(const port::Display&, std::uint8_t nid_ntc);
/// The abbreviation of a national system (015560 8.2.3.2.9), or its number.
Words ntc_label(const port::Display&, std::uint8_t nid_ntc);
/// A fixed text of the trackside (A.3.4 of SUBSET-026, Q_TEXT).
std::string_view fixed_text(std::uint8_t Q_TEXT);
/// Of a field; that of the radio network had another name before 4.0.0.
std::string_view label(FieldId, SrsVersion);
/// Of a button of a menu.
Words label(Button, SrsVersion);
/// A language in itself.
std::string_view language_name(Language);

}  // namespace evc::dmi
