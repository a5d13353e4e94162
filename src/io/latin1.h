#pragma once
#include <string>
#include <string_view>

// ISO 8859-1, in which texts are on the wire and on the display, and UTF-8, in which files are.
namespace evc::io {

void append_utf8(std::string& out, std::string_view latin1);
/// A character that ISO 8859-1 does not have becomes a question mark. The text is UTF-8 without faults, as the reader
/// of JSON gives it.
std::string latin1_of(std::string_view utf8);

}  // namespace evc::io
