#pragma once
#include <cstddef>
#include <cstdint>

namespace evc::lang {

/// Why a telegram, message or packet was not accepted. The clause gives the reaction of the unit.
enum class Fault : std::uint8_t {
  none,
  truncated,                 ///< ends inside a variable: inconsistent (3.16.2.1.1, 3.16.3.1.1)
  spare_value,               ///< a variable has a code without a meaning (7.3.2, 3.16.1.1)
  length_mismatch,           ///< L_PACKET is not the length of what was read (7.3.3)
  length_too_small,          ///< L_PACKET less than the packet's header: the packet cannot be skipped
  length_beyond_end,         ///< L_PACKET reaches beyond the telegram or message
  no_end_packet,             ///< a balise telegram without packet 255 (8.4.2.1)
  too_many_packets,          ///< more than this unit can hold: treated as inconsistent
  duplicate_packet,          ///< a second instance of a packet that may occur only once per direction (8.4.1.4)
  wrong_medium,              ///< a packet that this medium must not carry (7.4.1.1)
  wrong_direction,           ///< Q_UPDOWN of the other direction (8.4.2.1)
  wrong_place,               ///< a packet that must be the first one is not (packets 0, 200)
  missing_packet,            ///< a message without one of its mandatory packets (8.4.4)
  unexpected_packet,         ///< a message with a packet that is not on its list (8.4.4)
  unknown_message,           ///< no such message in this version (8.5)
  message_length_mismatch,   ///< L_MESSAGE is not the number of bytes received (8.4.4.4)
  unknown_version,           ///< X of the system version is not supported (3.17.3.5)
  not_applicable,            ///< information of X = 1 that a unit of X = 2 ignores (6.6.3.2.3, exceptions 10 to 13)
  not_a_packet_of_this_kind  ///< decode() was called for another packet than the view's: an error of the caller
};

/// The text of the fault in error reports; a literal.
const char* text_of(Fault fault);

/// A fault and where it was found. Pointers are to literals or null.
struct FaultAt {
  Fault fault = Fault::none;
  std::size_t bit = 0;             ///< from the start of the telegram or message
  std::int32_t packet = -1;        ///< NID_PACKET, -1 outside of packets
  const char* variable = nullptr;  ///< name of its type in lang::var
  std::uint64_t value = 0;         ///< raw code, if one is the reason
  constexpr explicit operator bool() const { return fault != Fault::none; }
};

}  // namespace evc::lang
