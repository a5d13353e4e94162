#include "balise/telegram.h"

#include "balise/linking.h"
#include "lang/telegram.h"

namespace evc::balise {
namespace {

constexpr std::size_t kHeaderBits = 50;

std::uint32_t bits_at(std::span<const std::uint8_t> bytes, std::size_t first, unsigned count) {
  std::uint32_t value = 0;
  for (std::size_t i = first; i < first + count; ++i)
    value = (value << 1) | ((static_cast<std::uint32_t>(bytes[i / 8]) >> (7 - i % 8)) & 1u);
  return value;
}

/// 8.4.2.4: version 1.0 has no marker, 1.1 has packet 200 and all others, also those that are not supported, packet 0.
/// The telegram may be broken behind the marker, so the marker is read separately.
std::optional<std::uint8_t> cover_marker(std::span<const std::uint8_t> bytes, std::size_t bits, const Header& header) {
  constexpr std::size_t kNidPacket = 8, kQdirAndLength = 2 + 13, kMarker = 6;
  constexpr std::uint8_t k1_0 = 16, k1_1 = 17;  // M_VERSION (7.5.1.79)
  if (header.M_VERSION == k1_0 || bits < kHeaderBits + kNidPacket) return std::nullopt;
  const bool of_1_1 = header.M_VERSION == k1_1;
  if (bits_at(bytes, kHeaderBits, kNidPacket) != (of_1_1 ? 200u : 0u)) return std::nullopt;
  const std::size_t at = kHeaderBits + kNidPacket + (of_1_1 ? kQdirAndLength : 0);
  if (bits < at + kMarker) return std::nullopt;
  return static_cast<std::uint8_t>(bits_at(bytes, at, kMarker));
}

void look_at(const lang::PacketView& packet, Telegram& telegram) {
  constexpr std::uint16_t kRepositioning = 16, kOutsideEtcs = 44, kInhibition = 145, kDefault = 254;
  if (packet.NID_PACKET == kDefault) telegram.default_information = true;
  if (packet.NID_PACKET == kInhibition) telegram.inhibits_reaction = true;  // in any direction
  if (packet.NID_PACKET == kRepositioning)
    telegram.repositioning = static_cast<std::uint8_t>(telegram.repositioning | (1u << packet.Q_DIR));
  // 3.16.2.4.4.1 a: data for applications outside ETCS do not need the orientation.
  if (packet.Q_DIR != 2 && packet.NID_PACKET != kOutsideEtcs) telegram.one_direction = true;
}

}  // namespace

Header read_header(std::span<const std::uint8_t> bytes, std::size_t bits) {
  Header header;
  if (bits > bytes.size() * 8) bits = bytes.size() * 8;
  if (bits < kHeaderBits) return header;
  const bool from_track = bits_at(bytes, 0, 1) == 1;
  const bool balise = bits_at(bytes, 8, 1) == 0;
  header.M_VERSION = static_cast<std::uint8_t>(bits_at(bytes, 1, 7));
  header.N_PIG = static_cast<std::uint8_t>(bits_at(bytes, 9, 3));
  header.N_TOTAL = static_cast<std::uint8_t>(bits_at(bytes, 12, 3));
  header.M_DUP = static_cast<std::uint8_t>(bits_at(bytes, 15, 2));
  header.M_MCOUNT = static_cast<std::uint8_t>(bits_at(bytes, 17, 8));
  header.id.NID_C = static_cast<std::uint16_t>(bits_at(bytes, 25, 10));
  header.id.NID_BG = static_cast<std::uint16_t>(bits_at(bytes, 35, 14));
  header.Q_LINK = bits_at(bytes, 49, 1) == 1;
  header.readable = from_track && balise;
  header.NID_VBCMK = cover_marker(bytes, bits, header);
  return header;
}

void look_into(Telegram& telegram, std::span<const std::uint8_t> bytes, std::size_t bits, const Header& header,
               SrsVersion srs) {
  telegram = {};
  telegram.N_PIG = header.N_PIG;
  telegram.M_DUP = header.M_DUP;
  telegram.M_MCOUNT = header.M_MCOUNT;
  telegram.M_VERSION = header.M_VERSION;
  if (bits > bytes.size() * 8) bits = bytes.size() * 8;
  const bool too_long = bits > kTelegramBytes * 8;
  if (too_long) bits = kTelegramBytes * 8;
  telegram.bits = static_cast<std::uint16_t>(bits);
  for (std::size_t i = 0; i < (bits + 7) / 8; ++i) telegram.bytes[i] = bytes[i];

  const lang::TelegramView view =
      lang::scan_telegram(telegram.span(), bits, lang::Check::all, lang::newest_version(srs));
  const bool named = header.id.NID_BG != kIdentityUnknown;  // which only packet 5 may contain (7.5.1.85)
  telegram.faulty =
      too_long || view.fault != lang::Fault::none || header.M_DUP == 3 || header.N_PIG > header.N_TOTAL || !named;
  if (view.fault != lang::Fault::none) return;
  for (const lang::PacketView& packet : view.packets) look_at(packet, telegram);
}

}  // namespace evc::balise
