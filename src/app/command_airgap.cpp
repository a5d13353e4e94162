#include "app/command_airgap.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "airgap/bits.h"

namespace evc::app {
namespace {

using airgap::Fault;
using airgap::Format;

/// The received telegram from b(n-1), as its encoder made it.
template <std::size_t N>
Fault examine_received(std::span<const std::uint8_t> bytes, const airgap::Received& received) {
  airgap::Bits<N> bits = airgap::rotate(airgap::load<N>(bytes, received.start), received.rotation);
  if (received.inverted) bits = bits.inverted();
  std::array<std::uint8_t, airgap::bytes_for(N)> aligned{};
  airgap::store(bits, aligned);
  return airgap::examine(aligned, received.format);
}

bool is_one_period(Format format, std::size_t bits) {
  // Whole digits or whole bytes.
  return bits >= airgap::coded_bits(format) && bits <= 8 * airgap::bytes_for(airgap::coded_bits(format));
}

AirgapTelegram telegram_of(std::span<const std::uint8_t> bytes, const airgap::Received& received, bool stream) {
  AirgapTelegram telegram{received, stream, Fault::none};
  telegram.fails = received.format == Format::long_ ? examine_received<1023>(bytes, received)
                                                    : examine_received<341>(bytes, received);
  return telegram;
}

const char* format_name(Format format) { return format == Format::long_ ? "long" : "short"; }

}  // namespace

tl::expected<AirgapTelegram, AirgapError> read_airgap(std::span<const std::uint8_t> bytes, std::size_t bits) {
  // One period; or, in as many bits as a long one, the short telegram three times.
  std::optional<Fault> as_period;
  for (const Format format : {Format::long_, Format::short_}) {
    if (!is_one_period(format, bits)) continue;
    const airgap::Outcome<airgap::Received> one = airgap::read(bytes, format);
    if (one) return telegram_of(bytes, *one, false);
    as_period = one.fault;
  }
  const airgap::Outcome<airgap::Received> found = airgap::receive(bytes, bits);
  if (found) return telegram_of(bytes, *found, true);
  if (as_period) return tl::unexpected(AirgapError{0, std::string(airgap::name(*as_period))});
  std::string why(airgap::name(found.fault));
  if (found.fault == Fault::too_few_bits) why += ": a period has 1023 or 341, a stream at least 462";
  return tl::unexpected(AirgapError{found->start, why});
}

std::string airgap_json(const AirgapTelegram& telegram) {
  const airgap::Received& r = telegram.received;
  std::string json = fmt::format(R"({{"format":"{}","sb":{},"esb":{},"rotation":{},"inverted":{})",
                                 format_name(r.format), r.shaping.sb, r.shaping.esb, r.rotation, r.inverted);
  if (telegram.stream) json += fmt::format(R"(,"start":{},"end":{})", r.start, r.end);
  if (telegram.fails != Fault::none) json += fmt::format(R"(,"fails":"{}")", airgap::name(telegram.fails));
  return json + "}";
}

std::string explain_airgap(const AirgapTelegram& telegram) {
  const airgap::Received& r = telegram.received;
  std::string text = fmt::format("air gap    {} format, {} bits for {} user bits\n", format_name(r.format),
                                 airgap::coded_bits(r.format), airgap::user_bits(r.format));
  text += fmt::format("           begins {} bits after b{}{}\n", r.rotation, airgap::coded_bits(r.format) - 1,
                      r.inverted ? ", all bits inverted (b109 = 1)" : "");
  text += fmt::format("           scrambling bits sb {}, extra shaping bits esb {}\n", r.shaping.sb, r.shaping.esb);
  if (telegram.stream) text += fmt::format("           found in bits {} to {} of the stream\n", r.start, r.end - 1);
  if (telegram.fails != Fault::none)
    text += fmt::format("           fails the encoder's test: {} (SUBSET-036 4.3.2.5)\n", airgap::name(telegram.fails));
  return text;
}

tl::expected<AirgapWish, std::string> airgap_wish(const nlohmann::json& airgap) {
  AirgapWish wish;
  if (!airgap.is_object()) return tl::unexpected<std::string>("airgap: expected an object");
  std::string wrong;
  const auto number = [&](const char* member, std::int64_t end) -> std::int64_t {
    const auto it = airgap.find(member);
    if (it == airgap.end()) return 0;
    if (it->is_number_unsigned() && it->get<std::uint64_t>() < static_cast<std::uint64_t>(end))
      return it->get<std::int64_t>();
    wrong = fmt::format("airgap/{}: expected a number from 0 to {}", member, end - 1);
    return 0;
  };
  const auto format = airgap.find("format");
  if (format != airgap.end()) {
    if (*format != "long" && *format != "short")
      return tl::unexpected<std::string>("airgap/format: expected long or short");
    wish.long_format = *format == "long";
  }
  wish.from = {static_cast<std::uint16_t>(number("sb", 4096)), static_cast<std::uint16_t>(number("esb", 1024))};
  wish.rotation = static_cast<std::size_t>(number("rotation", wish.long_format || format == airgap.end() ? 1023 : 341));
  const auto inverted = airgap.find("inverted");
  if (inverted != airgap.end()) {
    if (inverted->is_boolean())
      wish.inverted = inverted->get<bool>();
    else
      wrong = "airgap/inverted: expected true or false";
  }
  if (!wrong.empty()) return tl::unexpected(wrong);
  return wish;
}

tl::expected<std::string, std::string> encode_airgap(std::span<const std::uint8_t> user, std::size_t bits,
                                                     const AirgapWish& wish) {
  if (bits > airgap::user_bits(Format::long_))
    return tl::unexpected(fmt::format("{} user bits: a telegram holds 830", bits));
  const Format format = wish.long_format || bits > airgap::user_bits(Format::short_) ? Format::long_ : Format::short_;
  std::vector<std::uint8_t> filled(airgap::bytes_for(airgap::user_bits(format)), 0xFF);
  for (std::size_t i = 0; i < bits; ++i)
    if (!airgap::bit(user, i)) filled[i / 8] &= static_cast<std::uint8_t>(~(0x80u >> i % 8));

  airgap::Outcome<airgap::Coded> coded = airgap::encode(filled, format, wish.from);
  if (!coded) coded = airgap::encode(filled, format);  // none from there on: any other is as right
  if (!coded) return tl::unexpected(std::string(airgap::name(coded.fault)));
  const std::size_t n = airgap::coded_bits(format);
  std::string hex;
  for (std::size_t at = 0; at < n; at += 4) {
    unsigned digit = 0;
    for (std::size_t i = at; i < at + 4; ++i) {
      const bool sent = i < n && airgap::bit(coded->bytes, (i + wish.rotation) % n) != wish.inverted;
      digit = digit << 1 | static_cast<unsigned>(sent);
    }
    hex += "0123456789ABCDEF"[digit];
  }
  return hex;
}

}  // namespace evc::app
