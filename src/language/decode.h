#pragma once
#include <string>

#include "language/kind.h"

namespace evc::language {

struct DecodeOptions {
  What what = What::balise;
  std::string input;  ///< hexadecimal digits, a file with one telegram a line, or "-"
  std::string output = "-";
  std::string sv = "2.1";  ///< system version of the session, for messages and packets
  std::string pcapng;      ///< a capture for Wireshark in addition; empty: none
  bool explain = false;
  bool to_train = false, to_track = false;  ///< messages and packets need one of them
  bool strict = false, tolerant = false;
  bool loop = false;  ///< the user bits are a Euroloop message
};
/// `evc decode` (docs/decode.md). Exit status: 0 everything accepted, 1 something rejected, 2 the input cannot be read.
int decode(const DecodeOptions& options);

}  // namespace evc::language
