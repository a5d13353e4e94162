#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "io/json.h"

// `--set PLACE=VALUE`: members of a query that are replaced on the command line.
namespace evc::curves {

/// One `--set`: the tokens of its place and its value.
struct Override {
  std::vector<std::string> place;
  io::Json value;
};

/// Reads "train.brake_percentage=120" or "/train/brake_percentage=120" (a JSON pointer, RFC 6901). The value is JSON; a
/// text that is no JSON is a string. The error names `--set` and the text.
io::Result<Override> read_override(const std::string& text);

/// The document with the overrides in place, in their order. A file that the document names is read in place where an
/// override is inside it. A member that is missing is made: the reader of the document knows what may be there. Errors
/// name the place.
io::Result<io::Json> overridden(std::string_view document, const std::string& file,
                                const std::vector<Override>& overrides);

}  // namespace evc::curves
