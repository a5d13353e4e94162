#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "lang/schema.h"

namespace evc::io {

/// A capture file (PCAPNG) of telegrams and messages for the public dissector `etcs-wireshark`: IPv4 and UDP, one
/// datagram each, to port 50020 (ETCS-LOOP), 50030 (ETCS-BALISE) or 50040 (ETCS-RADIO). The addresses are arbitrary:
/// track 10.26.0.1, train 10.26.0.2. Frames are a millisecond apart.
class Pcapng {
 public:
  enum class Port : std::uint16_t { loop = 50020, balise = 50030, radio = 50040 };

  /// Appends the header of the file to `out`.
  explicit Pcapng(std::string& out);
  /// Appends one frame; bits beyond the last byte's end are zeros.
  void append(std::string& out, Port port, lang::Direction direction, std::span<const std::uint8_t> bytes,
              std::string_view comment = "");
  /// Radio messages do not contain a version: a message 32 gives the dissector the version of the following ones. It is
  /// not part of the decoded input; its comment says so.
  void append_version(std::string& out, lang::SystemVersion sv);

 private:
  std::uint64_t frames_ = 0;
};

}  // namespace evc::io
