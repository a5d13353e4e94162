#pragma once
#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <tl/expected.hpp>

#include "airgap/airgap.h"
#include "io/telegram_json.h"

// The air gap of `evc decode airgap` and `evc encode airgap` (docs/airgap.md): the JSON of a balise telegram with an
// additional member, "airgap", that describes how its user bits were coded.
namespace evc::language {

/// The result of reading coded bits.
struct AirgapTelegram {
  airgap::Received received;
  /// There were more bits than one period, and the receiver of SUBSET-036 searched them for the telegram.
  bool stream = false;
  /// The test of SUBSET-036 4.3.2.5 that the telegram fails although every receiver accepts it: an error of its
  /// encoder.
  airgap::Fault fails = airgap::Fault::none;
};
/// Reads `bits` coded bits, left aligned. 1023 or 341 bits, with or without padding to whole hexadecimal digits or
/// bytes, are one period at any rotation; more bits are a stream. The bit of an error is the start of the window that
/// passed the most tests.
tl::expected<AirgapTelegram, io::TelegramError> read_airgap(std::span<const std::uint8_t> bytes, std::size_t bits);

/// The value of the member "airgap" in the JSON of the telegram, on one line.
std::string airgap_json(const AirgapTelegram& telegram);
/// The user bits, 830 or 210, as hexadecimal digits.
std::string user_hex(const AirgapTelegram& telegram);
/// The same as readable text, a few lines, each ended by a line feed.
std::string explain_airgap(const AirgapTelegram& telegram);

/// Options for coding a telegram.
struct AirgapWish {
  bool long_format = false;  ///< even for user bits that fit into a short telegram
  airgap::Shaping from;      ///< the first pair to try
  std::size_t rotation = 0;
  bool inverted = false;
  bool fill = true;  ///< the bit used to fill up user bits
};
/// Reads the member "airgap" of a telegram's JSON; all its members are optional. The error names the member.
tl::expected<AirgapWish, std::string> airgap_wish(const nlohmann::json& airgap);

/// Codes `bits` user bits, at most 830, filled up to 210 or 830 (bits after packet 255 have no meaning). Returns one
/// period; with the options read from the JSON of a decoded period, the same bits.
tl::expected<io::Bits, std::string> encode_airgap(std::span<const std::uint8_t> user, std::size_t bits,
                                                  const AirgapWish& wish);

/// Appends the JSON object of the telegram in these coded bits. On error `out` is as before.
tl::expected<void, io::TelegramError> append_airgap_json(std::string& out, std::span<const std::uint8_t> bytes,
                                                         std::size_t bits, io::Spare spare = io::Spare::refuse);
/// The coded period of a telegram's JSON, with or without the member "airgap".
tl::expected<io::Bits, io::TelegramError> encode_airgap_json(const nlohmann::json& telegram);

}  // namespace evc::language
