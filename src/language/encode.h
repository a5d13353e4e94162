#pragma once
#include <string>

#include "language/kind.h"

namespace evc::language {

struct EncodeOptions {
  What what = What::balise;
  std::string input;  ///< a JSON object, a file of JSON objects, or "-"
  std::string output = "-";
  std::string sv;  ///< empty: the newest version that fits the members
  bool to_train = false, to_track = false;
  bool loop = false;  ///< a Euroloop message
};
/// `evc encode`. Exit status: 0 everything accepted, 1 something rejected, 2 the input cannot be
/// read.
int encode(const EncodeOptions& options);

}  // namespace evc::language
