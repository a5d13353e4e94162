// Air-gap coding: no bytes make the receiver crash, hang or read past them; accepted telegrams pass the encoder's tests
// and agree with `read`; and telegrams of the encoder are received.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "airgap/airgap.h"

namespace {

using namespace evc::airgap;

void require(bool holds) {
  if (!holds) std::abort();
}

void round_trip(std::span<const std::uint8_t> user, Format format, std::size_t shift, bool inverted) {
  const Outcome<Coded> coded = encode(user, format);
  require(static_cast<bool>(coded) && examine(coded->bits(), format) == Fault::none);
  const std::size_t n = coded_bits(format), least = n + (format == Format::long_ ? 77 : 121);
  std::vector<std::uint8_t> stream(bytes_for(least));
  for (std::size_t i = 0; i < least; ++i)
    if (bit(coded->bytes, (i + shift) % n) != inverted) stream[i / 8] |= static_cast<std::uint8_t>(0x80u >> i % 8);
  const Outcome<Received> received = receive(stream, least);
  require(received && received->format == format && received->inverted == inverted && received->rotation == shift % n);
  for (std::size_t i = 0; i < user_bits(format); ++i) require(bit(received->user, i) == bit(user, i));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 4) return 0;
  const std::uint8_t kind = data[0];
  const std::size_t shift = static_cast<std::size_t>(data[1]) << 8 | data[2];
  const std::span<const std::uint8_t> bytes(data + 3, size - 3);
  const Format format = (kind & 1) != 0 ? Format::long_ : Format::short_;
  // Coding is slow under the sanitizers: one input in 1024, selected by a hash of its bytes.
  std::uint32_t hash = 2166136261;
  for (const std::uint8_t byte : bytes) hash = (hash ^ byte) * 16777619;
  if (hash >> 22 == 0) {
    std::vector<std::uint8_t> user(bytes.begin(), bytes.end());
    user.resize(bytes_for(user_bits(format)));
    round_trip(user, format, shift, (kind & 4) != 0);
    return 0;
  }
  const Outcome<Received> one = read(bytes, format);
  examine(bytes, format);
  if (one) require(one->format == format);
  const std::size_t count = bytes.size() * 8 - (kind >> 5) % 8;
  std::size_t from = 0;
  for (Outcome<Received> found = receive(bytes, count); found; found = receive(bytes, count, from)) {
    require(found->end <= count && found->end > from && found->start >= from);
    from = found->end;
  }
  return 0;
}
