#pragma once
#include <string>
#include <string_view>

namespace evc::io {

/// The text as content or attribute of XML. Control characters, which a document may not contain, become spaces.
std::string escaped_xml(std::string_view text);

/// JSON as the content of <script>, where "</" would end the element and "<!--" begin a comment: the same document
/// without a "<".
std::string json_in_script(std::string json);

}  // namespace evc::io
