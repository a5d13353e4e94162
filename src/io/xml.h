#pragma once
#include <string>
#include <string_view>

namespace evc::io {

/// The text as content or attribute of XML. Control characters, which a document may not contain, become spaces.
std::string escaped_xml(std::string_view text);

}  // namespace evc::io
