#include "language/airgap.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>

#include "airgap/bits.h"

namespace evc::language {
namespace {

using airgap::Fault;
using airgap::Format;

/// The received telegram from b(n-1), as encoded.
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

io::TelegramError refusal(std::size_t bit, std::string_view why) {
  return {bit, -1, "", {}, "air gap: " + std::string(why)};
}

const char* format_name(Format format) { return format == Format::long_ ? "long" : "short"; }

}  // namespace

tl::expected<AirgapTelegram, io::TelegramError> read_airgap(std::span<const std::uint8_t> bytes, std::size_t bits) {
  // One period; or, in as many bits as a long one has, the short telegram three times.
  std::optional<Fault> as_period;
  for (const Format format : {Format::long_, Format::short_}) {
    if (!is_one_period(format, bits)) continue;
    const airgap::Outcome<airgap::Received> one = airgap::read(bytes, format);
    if (one) return telegram_of(bytes, *one, false);
    as_period = one.fault;
  }
  const airgap::Outcome<airgap::Received> found = airgap::receive(bytes, bits);
  if (found) return telegram_of(bytes, *found, true);
  if (as_period) return tl::unexpected(refusal(0, airgap::name(*as_period)));
  std::string why(airgap::name(found.fault));
  if (found.fault == Fault::too_few_bits) why += ": a period has 1023 or 341, a stream at least 462";
  return tl::unexpected(refusal(found->start, why));
}

std::string airgap_json(const AirgapTelegram& telegram) {
  const airgap::Received& r = telegram.received;
  std::string json = fmt::format(R"({{"format":"{}","sb":{},"esb":{},"rotation":{},"inverted":{})",
                                 format_name(r.format), r.shaping.sb, r.shaping.esb, r.rotation, r.inverted);
  if (telegram.stream) json += fmt::format(R"(,"start":{},"end":{})", r.start, r.end);
  if (telegram.fails != Fault::none) json += fmt::format(R"(,"fails":"{}")", airgap::name(telegram.fails));
  return json + "}";
}

std::string user_hex(const AirgapTelegram& telegram) {
  return io::hex_of_bits(telegram.received.user_bytes(), airgap::user_bits(telegram.received.format));
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
  // The last three describe what was received: nothing is made of them, but their form is checked.
  constexpr const char* known[] = {"format", "sb", "esb", "rotation", "inverted", "fill", "start", "end", "fails"};
  for (const auto& [key, value] : airgap.items())
    if (std::none_of(std::begin(known), std::end(known), [&key = key](const char* k) { return key == k; }))
      return tl::unexpected("airgap: unknown member " + key);
  constexpr auto any_bit = std::int64_t{1} << 53;
  (void)number("start", any_bit);
  (void)number("end", any_bit);
  if (const auto fails = airgap.find("fails"); fails != airgap.end() && !fails->is_string())
    wrong = "airgap/fails: expected a text";
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
  if (airgap.contains("fill")) wish.fill = number("fill", 2) != 0;
  if (!wrong.empty()) return tl::unexpected(wrong);
  return wish;
}

tl::expected<io::Bits, std::string> encode_airgap(std::span<const std::uint8_t> user, std::size_t bits,
                                                  const AirgapWish& wish) {
  if (bits > airgap::user_bits(Format::long_))
    return tl::unexpected(fmt::format("{} user bits: a telegram holds 830", bits));
  const Format format = wish.long_format || bits > airgap::user_bits(Format::short_) ? Format::long_ : Format::short_;
  std::vector<std::uint8_t> filled(airgap::bytes_for(airgap::user_bits(format)));
  for (std::size_t i = 0; i < airgap::user_bits(format); ++i)
    if (i < bits ? airgap::bit(user, i) : wish.fill) filled[i / 8] |= static_cast<std::uint8_t>(0x80u >> i % 8);

  airgap::Outcome<airgap::Coded> coded = airgap::encode(filled, format, wish.from);
  if (!coded) coded = airgap::encode(filled, format);  // no pair from there on: any other is equally valid
  if (!coded) return tl::unexpected(std::string(airgap::name(coded.fault)));
  const std::size_t n = airgap::coded_bits(format);
  io::Bits period{std::vector<std::uint8_t>(airgap::bytes_for(n)), n};
  for (std::size_t i = 0; i < n; ++i)
    if (airgap::bit(coded->bytes, (i + wish.rotation) % n) != wish.inverted)
      period.bytes[i / 8] |= static_cast<std::uint8_t>(0x80u >> i % 8);
  return period;
}

tl::expected<void, io::TelegramError> append_airgap_json(std::string& out, std::span<const std::uint8_t> bytes,
                                                         std::size_t bits, io::Spare spare) {
  const auto telegram = read_airgap(bytes, bits);
  if (!telegram) return tl::unexpected(telegram.error());
  const std::span<const std::uint8_t> user = telegram->received.user_bytes();
  const std::size_t count = airgap::user_bits(telegram->received.format);
  const std::size_t before = out.size();
  if (const auto done = io::append_balise_json(out, user, count, spare); !done) return tl::unexpected(done.error());
  std::string json = airgap_json(*telegram);
  // Less than a byte of zeros after packet 255 is not in the JSON of the user bits.
  if (out.find("\"bits\":", before) == std::string::npos && !airgap::bit(user, count - 1)) {
    json.pop_back();
    json += ",\"fill\":0}";
  }
  out.pop_back();
  out += ",\"airgap\":" + json + "}";
  return {};
}

tl::expected<io::Bits, io::TelegramError> encode_airgap_json(const nlohmann::json& telegram) {
  const auto user = io::encode_balise_json(telegram);
  if (!user) return user;
  AirgapWish wish;
  if (const auto it = telegram.find("airgap"); it != telegram.end()) {
    const auto read = airgap_wish(*it);
    if (!read) return tl::unexpected(io::TelegramError{0, -1, "airgap", {}, read.error()});
    wish = *read;
  }
  auto coded = encode_airgap(user->bytes, user->bits, wish);
  if (!coded) return tl::unexpected(refusal(0, coded.error()));
  return *coded;
}

}  // namespace evc::language
