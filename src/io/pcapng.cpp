#include "io/pcapng.h"

#include <array>

#include "lang/encode.h"
#include "lang/messages.h"

namespace evc::io {
namespace {

/// Little endian: the blocks of the file.
void put(std::string& out, std::uint64_t value, unsigned bytes) {
  for (unsigned i = 0; i < bytes; ++i) out += static_cast<char>((value >> (8 * i)) & 0xFF);
}
/// Big endian: as on a network.
void put_network(std::string& out, std::uint64_t value, unsigned bytes) {
  for (unsigned i = bytes; i > 0; --i) out += static_cast<char>((value >> (8 * (i - 1))) & 0xFF);
}
void pad(std::string& out, std::size_t length) { out.append((4 - length % 4) % 4, '\0'); }

/// RFC 791 3.1: ones' complement sum of the header's halfwords.
std::uint16_t checksum(std::string_view header) {
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i + 1 < header.size(); i += 2)
    sum += static_cast<std::uint32_t>(static_cast<unsigned char>(header[i]) << 8) |
           static_cast<unsigned char>(header[i + 1]);
  while (sum >> 16 != 0) sum = (sum & 0xFFFF) + (sum >> 16);
  return static_cast<std::uint16_t>(~sum);
}

constexpr std::uint32_t kTrack = 0x0A1A0001;
constexpr std::uint32_t kTrain = 0x0A1A0002;

std::string datagram(std::uint16_t port, lang::Direction direction, std::uint16_t number,
                     std::span<const std::uint8_t> bytes) {
  const bool to_train = direction == lang::Direction::to_train;
  std::string ip;
  put_network(ip, 0x4500, 2);  // version 4, five words, no service class
  put_network(ip, 20 + 8 + bytes.size(), 2);
  put_network(ip, number, 2);
  put_network(ip, 0x4000, 2);  // not in fragments
  put_network(ip, 0x4011, 2);  // time to live 64, UDP
  put_network(ip, 0, 2);
  put_network(ip, to_train ? kTrack : kTrain, 4);
  put_network(ip, to_train ? kTrain : kTrack, 4);
  const std::uint16_t sum = checksum(ip);
  ip[10] = static_cast<char>(sum >> 8);
  ip[11] = static_cast<char>(sum & 0xFF);
  put_network(ip, port, 2);
  put_network(ip, port, 2);
  put_network(ip, 8 + bytes.size(), 2);
  put_network(ip, 0, 2);  // no checksum
  for (const std::uint8_t b : bytes) ip += static_cast<char>(b);
  return ip;
}

}  // namespace

Pcapng::Pcapng(std::string& out) {
  // Section header: type, length, byte order, version 1.0, length of the section unknown.
  put(out, 0x0A0D0D0A, 4);
  put(out, 28, 4);
  put(out, 0x1A2B3C4D, 4);
  put(out, 1, 2);
  put(out, 0, 2);
  put(out, ~std::uint64_t{0}, 8);
  put(out, 28, 4);
  // Interface: LINKTYPE_IPV4, no limit of length; times in microseconds.
  put(out, 1, 4);
  put(out, 20, 4);
  put(out, 228, 2);
  put(out, 0, 2);
  put(out, 0, 4);
  put(out, 20, 4);
}

void Pcapng::append(std::string& out, Port port, lang::Direction direction, std::span<const std::uint8_t> bytes,
                    std::string_view comment) {
  const std::string packet =
      datagram(static_cast<std::uint16_t>(port), direction, static_cast<std::uint16_t>(frames_), bytes);
  const std::uint64_t time = 1000 * frames_++;
  std::string block;
  put(block, 0, 4);  // interface
  put(block, time >> 32, 4);
  put(block, time & 0xFFFFFFFF, 4);
  put(block, packet.size(), 4);
  put(block, packet.size(), 4);
  block += packet;
  pad(block, packet.size());
  if (!comment.empty()) {
    put(block, 1, 2);
    put(block, comment.size(), 2);
    block += comment;
    pad(block, comment.size());
    put(block, 0, 4);
  }
  const std::uint64_t length = block.size() + 12;
  put(out, 6, 4);
  put(out, length, 4);
  out += block;
  put(out, length, 4);
}

void Pcapng::append_version(std::string& out, lang::SystemVersion sv) {
  lang::Message32 message;
  message.T_TRAIN.raw = 0xFFFFFFFF;
  message.NID_LRBG.raw = 0xFFFFFF;
  message.M_VERSION.raw = static_cast<std::uint8_t>(sv.x << 4 | sv.y);
  std::array<std::uint8_t, 16> room{};
  BitWriter bits(room);
  lang::encode_message(bits, message);
  append(out, Port::radio, lang::Direction::to_train, bits.bytes(),
         "added: the system version of the following messages");
}

}  // namespace evc::io
