#pragma once
/// The ETCS language (SUBSET-026-7 and -8) as JSON: converts what a balise, a loop or the radio sends, bit by bit, to
/// text and back (docs/decode.md, data/schema/evc-telegram.json). Link openevc::language.
///
///     const auto telegram = evc::language::bits_of_hex("...");
///     const auto text = evc::language::decode(telegram.bytes, telegram.size, {});
///     if (text.error)
///       refuse(text.error->bit, text.error->why);
///     else
///       use(text.json);
///
/// Values are raw codes, members are in the order of SUBSET-026-7, counters of repeated groups are left out. Bits that
/// are decoded and encoded again are the same bits. No state: every function may be called from any thread. Throws
/// std::bad_alloc and nothing else.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace evc::language {

/// Which kind of data the bits are.
enum class Form : std::uint8_t {
  balise,  ///< user bits of a balise telegram: 830, 210, or fewer up to packet 255 (8.4.2)
  loop,    ///< a Euroloop message (8.4.3)
  radio,   ///< a radio message (8.4.4)
  packet,  ///< one packet (7.4)
};
enum class Direction : std::uint8_t { to_train, to_track };

/// System version X.Y (3.17).
struct Version {
  std::uint8_t X = 2;
  std::uint8_t Y = 1;
};

struct Reading {
  Form form = Form::balise;
  Direction direction = Direction::to_train;  ///< of a message or packet
  Version version{};                          ///< of the session, for a message or packet; a telegram contains its own
  /// Also accept spare codes, wrong media and packets that occur twice: only what is needed to read the bits is
  /// checked. A packet alone is always read in this way.
  bool tolerant = false;
};

struct Error {
  std::size_t bit = 0;                   ///< where reading stopped; 0 for a JSON text
  int packet = -1;                       ///< NID_PACKET, -1 outside of packets
  std::string variable;                  ///< "V_STATIC"; empty if the error is not in a variable
  std::optional<std::uint64_t> value{};  ///< its code
  std::string why;                       ///< "spare value"
};

struct Text {
  std::string json;  ///< one object, without a line end; empty after an error
  std::optional<Error> error{};
};
/// `bytes` hold the bits left aligned; the first `bits` of them are read.
Text decode(std::span<const std::uint8_t> bytes, std::size_t bits, const Reading& reading);

struct Bits {
  std::vector<std::uint8_t> bytes;  ///< left aligned, filled with zeros; empty after an error
  std::size_t size = 0;             ///< in bits
  std::optional<Error> error{};
};

/// What the JSON text does not contain. Absent: deduced from its members; the newest version that has exactly these.
struct Writing {
  Form form = Form::balise;
  std::optional<Direction> direction{};
  std::optional<Version> version{};
};
/// The text of one object, as `decode` makes it. Lengths and counters are computed; given ones are checked.
Bits encode(std::string_view json, const Writing& writing);

/// Hexadecimal digits, upper or lower case, blanks between them allowed. The error names the bit of the digit.
Bits bits_of_hex(std::string_view hex);
/// As many digits as `bits` need, upper case.
std::string hex_of_bits(std::span<const std::uint8_t> bytes, std::size_t bits);

}  // namespace evc::language
