#pragma once
#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <tl/expected.hpp>

#include "airgap/airgap.h"
#include "io/telegram_json.h"

// The air gap of `evc decode airgap` and `evc encode airgap` (docs/airgap.md): the JSON of a balise telegram with one
// more member, "airgap", that says how its user bits were coded.
namespace evc::language {

/// What was found in coded bits.
struct AirgapTelegram {
  airgap::Received received;
  /// More bits than one period were given, and the receiver of SUBSET-036 looked for the telegram among them.
  bool stream = false;
  /// The test of SUBSET-036 4.3.2.5 that the telegram fails though every receiver takes it: its encoder was wrong.
  airgap::Fault fails = airgap::Fault::none;
};
/// Reads `bits` coded bits, left aligned. 1023 or 341 bits, filled up to whole hexadecimal digits or bytes or not, are
/// one period at any rotation; any more are a stream. The error's bit is where the window begins that came furthest.
tl::expected<AirgapTelegram, io::TelegramError> read_airgap(std::span<const std::uint8_t> bytes, std::size_t bits);

/// The value of the member "airgap" in the JSON of the telegram, on one line.
std::string airgap_json(const AirgapTelegram& telegram);
/// The same for people, a few lines, each ended by a line feed.
std::string explain_airgap(const AirgapTelegram& telegram);

/// How a telegram is to be coded.
struct AirgapWish {
  bool long_format = false;  ///< also for user bits that a short telegram could hold
  airgap::Shaping from;      ///< the first pair to try
  std::size_t rotation = 0;
  bool inverted = false;
  bool fill = true;  ///< the bit that user bits are filled up with
};
/// Reads the member "airgap" of a telegram's JSON; all members may be left out. The error names the member.
tl::expected<AirgapWish, std::string> airgap_wish(const nlohmann::json& airgap);

/// Codes `bits` user bits, at most 830, filled up to 210 or 830 (what stands behind packet 255 has no meaning). Gives
/// one period; with the wish read from the JSON of a decoded period the same bits come back.
tl::expected<io::Bits, std::string> encode_airgap(std::span<const std::uint8_t> user, std::size_t bits,
                                                  const AirgapWish& wish);

/// Appends the JSON object of the telegram in these coded bits. On error `out` is as before.
tl::expected<void, io::TelegramError> append_airgap_json(std::string& out, std::span<const std::uint8_t> bytes,
                                                         std::size_t bits, io::Spare spare = io::Spare::refuse);
/// The coded period of a telegram's JSON, with or without the member "airgap".
tl::expected<io::Bits, io::TelegramError> encode_airgap_json(const nlohmann::json& telegram);

}  // namespace evc::language
