#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace evc::airgap {

/// `N` bits as a polynomial over GF(2): bit i is the coefficient of x^i, and b(N-1) is sent first. Bits past N are
/// zero.
template <std::size_t N>
struct Bits {
  static constexpr std::size_t kWords = (N + 63) / 64;
  static constexpr std::uint64_t kTopMask = N % 64 == 0 ? ~std::uint64_t{0} : (std::uint64_t{1} << N % 64) - 1;
  std::array<std::uint64_t, kWords> w{};

  constexpr bool operator[](std::size_t i) const { return (w[i / 64] >> i % 64 & 1) != 0; }

  /// The `length` (1..64) bits b(low + length - 1)..b(low), which must lie inside.
  constexpr std::uint64_t get(std::size_t low, std::size_t length) const {
    const std::size_t k = low / 64, shift = low % 64;
    std::uint64_t value = w[k] >> shift;
    if (shift + length > 64) value |= w[k + 1] << 1 << (63 - shift);
    return length == 64 ? value : value & ((std::uint64_t{1} << length) - 1);
  }
  /// Writes `length` (1..63) bits into places that are zero.
  constexpr void put(std::size_t low, std::size_t length, std::uint64_t value) {
    const std::size_t k = low / 64, shift = low % 64;
    w[k] |= value << shift;
    if (shift + length > 64) w[k + 1] |= value >> 1 >> (63 - shift);
  }
  constexpr Bits inverted() const {
    Bits out;
    for (std::size_t k = 0; k < kWords; ++k) out.w[k] = ~w[k];
    out.w[kWords - 1] &= kTopMask;
    return out;
  }
  constexpr bool none() const {
    std::uint64_t any = 0;
    for (std::uint64_t word : w) any |= word;
    return any == 0;
  }
  friend constexpr Bits operator&(const Bits& a, const Bits& b) {
    Bits out;
    for (std::size_t k = 0; k < kWords; ++k) out.w[k] = a.w[k] & b.w[k];
    return out;
  }
  friend constexpr Bits operator^(const Bits& a, const Bits& b) {
    Bits out;
    for (std::size_t k = 0; k < kWords; ++k) out.w[k] = a.w[k] ^ b.w[k];
    return out;
  }
  friend constexpr bool operator==(const Bits&, const Bits&) = default;
};

/// The bits twice in a row, so that a cyclic telegram can be read across its end.
template <std::size_t N>
constexpr Bits<2 * N> twice(const Bits<N>& bits) {
  Bits<2 * N> out;
  for (std::size_t k = 0; k < Bits<N>::kWords; ++k) out.w[k] = bits.w[k];
  constexpr std::size_t first = N / 64, shift = N % 64;
  static_assert(shift != 0);
  for (std::size_t k = 0; k < Bits<N>::kWords; ++k) {
    out.w[first + k] |= bits.w[k] << shift;
    if (first + k + 1 < Bits<2 * N>::kWords) out.w[first + k + 1] |= bits.w[k] >> (64 - shift);
  }
  return out;
}

/// b(i) := b((i + s) mod N): division by x^s modulo x^N + 1. 0 <= s < N.
template <std::size_t N>
constexpr Bits<N> rotate(const Bits<N>& bits, std::size_t s) {
  const Bits<2 * N> ring = twice(bits);
  Bits<N> out;
  for (std::size_t k = 0; k + 1 < Bits<N>::kWords; ++k) out.w[k] = ring.get(64 * k + s, 64);
  constexpr std::size_t last = Bits<N>::kWords - 1;
  out.w[last] = ring.get(64 * last + s, N - 64 * last);
  return out;
}

/// `length` (1..64) bits of a left aligned bit string from index `at`, the first one most significant.
inline std::uint64_t take(std::span<const std::uint8_t> bytes, std::size_t at, std::size_t length) {
  std::size_t next = at / 8;
  const std::size_t used = at % 8;
  std::uint64_t value = bytes[next++] & (0xFFu >> used);
  std::size_t have = 8 - used;
  while (have + 8 <= length) {
    value = value << 8 | bytes[next++];
    have += 8;
  }
  if (have >= length) return value >> (have - length);
  const std::size_t rest = length - have;  // 1..7
  return value << rest | static_cast<std::uint64_t>(bytes[next]) >> (8 - rest);
}

/// The `N` bits of the string from index `at`; the first one becomes b(N-1).
template <std::size_t N>
Bits<N> load(std::span<const std::uint8_t> bytes, std::size_t at) {
  Bits<N> out;
  constexpr std::size_t top = N - 64 * (Bits<N>::kWords - 1);
  out.w[Bits<N>::kWords - 1] = take(bytes, at, top);
  for (std::size_t k = 0; k + 1 < Bits<N>::kWords; ++k) out.w[k] = take(bytes, at + N - 64 * (k + 1), 64);
  return out;
}

/// The opposite of `load` at index 0; the bits after the last one are zero.
template <std::size_t N>
void store(const Bits<N>& bits, std::span<std::uint8_t> bytes) {
  constexpr std::size_t whole = N / 8, rest = N % 8;
  for (std::size_t i = 0; i < whole; ++i) bytes[i] = static_cast<std::uint8_t>(bits.get(N - 8 * (i + 1), 8));
  if constexpr (rest != 0) bytes[whole] = static_cast<std::uint8_t>(bits.get(0, rest) << (8 - rest));
}

}  // namespace evc::airgap
