#pragma once
#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "lang/schema.h"

// The ETCS language as JSON: `evc decode` and `evc encode` (docs/decode.md, data/schema/evc-telegram.json).
// Values are raw codes, members are in the order of SUBSET-026-7, counters are left out. Bits that are decoded and
// encoded again are the same bits.
namespace evc::io {

/// Why bits or a JSON text were not accepted.
struct TelegramError {
  std::size_t bit = 0;
  int packet = -1;       ///< NID_PACKET, -1 outside of packets
  std::string variable;  ///< "" if the error is not in a variable
  std::optional<std::uint64_t> value;
  std::string why;
};
/// `{"error":{"bit":218,"packet":27,"variable":"V_STATIC","value":121,"why":"spare value"}}`
/// If there is a line number of the input, counted from 1, it is before the bit.
std::string error_json(const TelegramError& error, std::uint64_t line = 0);

struct Bits {
  std::vector<std::uint8_t> bytes;  ///< left aligned, zero filled
  std::size_t bits = 0;
};
/// Hexadecimal digits, upper or lower case, blanks between them allowed. The error names the bit of the digit.
tl::expected<Bits, TelegramError> bits_of_hex(std::string_view hex);
/// As many digits as `bits` need, upper case.
std::string hex_of_bits(std::span<const std::uint8_t> bytes, std::size_t bits);

enum class Spare : std::uint8_t {
  refuse,  ///< all rules of 3.16.2, 7.3 and 8.4 are checked
  accept,  ///< only what is needed to read the bits; spare codes are returned
};

/// Appends the JSON object of a balise telegram. `bits` are the user bits: 830, 210 (two zeros may fill
/// the last digit) or fewer if packet 255 ends them. On error `out` is as before.
tl::expected<void, TelegramError> append_balise_json(std::string& out, std::span<const std::uint8_t> bytes,
                                                     std::size_t bits, Spare spare = Spare::refuse);
/// A Euroloop message.
tl::expected<void, TelegramError> append_loop_json(std::string& out, std::span<const std::uint8_t> bytes,
                                                   std::size_t bits, Spare spare = Spare::refuse);
/// A radio message; `sv` is the version of the session.
tl::expected<void, TelegramError> append_radio_json(std::string& out, std::span<const std::uint8_t> bytes,
                                                    lang::Direction direction, lang::SystemVersion sv,
                                                    Spare spare = Spare::refuse);
/// One packet.
tl::expected<void, TelegramError> append_packet_json(std::string& out, std::span<const std::uint8_t> bytes,
                                                     std::size_t bits, lang::Direction direction,
                                                     lang::SystemVersion sv, Spare spare = Spare::accept);

/// What the JSON text does not contain. Absent: deduced from its members (Q_DIR and the message number give the
/// direction; the newest layout with exactly these members and this L_PACKET is used).
struct EncodeOptions {
  std::optional<lang::Direction> direction;
  std::optional<lang::SystemVersion> sv;
};
/// The user bits: up to packet 255, or the number of the member "bits", filled with ones.
tl::expected<Bits, TelegramError> encode_balise_json(const nlohmann::json& telegram);
tl::expected<Bits, TelegramError> encode_loop_json(const nlohmann::json& message);
tl::expected<Bits, TelegramError> encode_radio_json(const nlohmann::json& message, const EncodeOptions& options = {});
tl::expected<Bits, TelegramError> encode_packet_json(const nlohmann::json& packet, const EncodeOptions& options = {});

/// "2.1" as X.Y; empty if it is not a version.
std::optional<lang::SystemVersion> parse_version(std::string_view text);

}  // namespace evc::io
