#include "airgap/bits.h"
#include "airgap/code.h"

namespace evc::airgap {
namespace {

/// A stream of repeated telegrams, long enough for two periods and the extra bits.
constexpr std::size_t kStreamBits = 2 * LongCode::n + LongCode::r;
using Stream = std::array<std::uint8_t, bytes_for(kStreamBits)>;

void flip(Stream& stream, std::size_t i) { stream[i / 8] ^= static_cast<std::uint8_t>(0x80u >> i % 8); }

/// Periods of the telegram, begun `shift` bits after its start, inverted or not.
Stream repeat(const Coded& coded, std::size_t shift, bool inverted) {
  Stream stream{};
  for (std::size_t i = 0; i < kStreamBits; ++i)
    if (bit(coded.bytes, (i + shift) % coded_bits(coded.format)) != inverted) flip(stream, i);
  return stream;
}

bool is(const Outcome<Received>& received, const std::array<std::uint8_t, 104>& user, const Coded& coded,
        bool inverted) {
  return received && received->format == coded.format && received->inverted == inverted && received->user == user &&
         received->shaping == coded.shaping;
}

bool test_format(Format format) {
  std::array<std::uint8_t, 104> user{};
  for (std::size_t i = 0; i < user_bits(format); ++i)
    if (i % 3 == 0 || i % 7 == 2) user[i / 8] |= static_cast<std::uint8_t>(0x80u >> i % 8);
  const Outcome<Coded> coded = encode(user, format);
  if (!coded || examine(coded->bits(), format) != Fault::none) return false;

  const std::size_t n = coded_bits(format);
  const std::size_t least = n + (format == Format::long_ ? LongCode::r : ShortCode::r);
  for (const std::size_t shift : {std::size_t{0}, std::size_t{1}, n / 2, n - 1})
    for (const bool inverted : {false, true}) {
      Stream stream = repeat(*coded, shift, inverted);
      const Outcome<Received> received = receive(stream, least);
      if (!is(received, user, *coded, inverted) || received->rotation != shift) return false;
      if (receive(stream, least - 1)) return false;
      // One wrong bit: refused while it is in the window, received once it has left.
      flip(stream, 40);
      if (receive(stream, least)) return false;
      const Outcome<Received> later = receive(stream, kStreamBits);
      if (!is(later, user, *coded, inverted) || later->start != 41) return false;
    }
  return true;
}

}  // namespace

bool self_test() { return test_format(Format::long_) && test_format(Format::short_); }

}  // namespace evc::airgap
