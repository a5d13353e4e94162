#pragma once
#include "airgap/bits.h"
#include "airgap/code.h"
#include "airgap/words.h"

// The tests that a telegram must pass before a balise may send it (SUBSET-036 4.3.2.5). All of them are cyclic. They
// work on sets of bit places: one bit per place, 64 places a step.
namespace evc::airgap {

/// The places p where b(p+10)..b(p) is a valid word.
template <std::size_t N>
constexpr Bits<N> word_places(const Bits<N>& bits) {
  const Bits<2 * N> ring = twice(bits);
  Bits<N> places;
  for (std::size_t k = 0; k < Bits<N>::kWords; ++k) {
    const std::uint64_t here = ring.w[k], above = ring.w[k + 1];
    std::uint64_t set = 0;
    for (std::size_t j = 0; j < 64; ++j)
      set |= std::uint64_t{is_word((here >> j | above << 1 << (63 - j)) & 2047)} << j;
    places.w[k] = set;
  }
  places.w[Bits<N>::kWords - 1] &= Bits<N>::kTopMask;
  return places;
}

/// The places where `count` valid words in a row begin, going up.
template <std::size_t N>
constexpr Bits<N> runs(const Bits<N>& word_places, std::size_t count) {
  Bits<N> all = word_places;
  std::size_t have = 1;
  while (2 * have <= count) {
    all = all & rotate(all, have * kWordBits);
    have *= 2;
  }
  return have == count ? all : all & rotate(all, (count - have) * kWordBits);
}

/// The places p with p mod 11 = `phase`.
template <std::size_t N>
constexpr Bits<N> phase_places(std::size_t phase) {
  Bits<N> places;
  for (std::size_t p = phase; p < N; p += kWordBits) places.w[p / 64] |= std::uint64_t{1} << p % 64;
  return places;
}
template <std::size_t N>
inline constexpr Bits<N> kInSynch = phase_places<N>(0);
template <std::size_t N>
inline constexpr Bits<N> kOneBitOff = phase_places<N>(1) ^ phase_places<N>(10);

/// At most 2 valid words in a row one bit off the right parsing, 10 (long) or 6 (short) in the other eight.
template <class Code>
constexpr bool passes_off_synch(const Bits<Code::n>& word_places) {
  constexpr std::size_t longest = Code::format == Format::long_ ? 10 : 6;
  const Bits<Code::n> off = word_places & kInSynch<Code::n>.inverted();
  return (runs(off, 3) & kOneBitOff<Code::n>).none() && runs(off, longest + 1).none();
}

/// At least 2 of these bits are set; at least 3. (A population count would be a call into the compiler's library.)
constexpr bool two_or_more(std::uint64_t bits) { return (bits & (bits - 1)) != 0; }
constexpr bool three_or_more(std::uint64_t bits) { return bits != 0 && two_or_more(bits & (bits - 1)); }

/// Two neighbouring words differ in at least 3 bits from those 341 bits on, and in at least 2 from those 338..344 on.
inline bool passes_aperiodicity(const Bits<LongCode::n>& bits) {
  constexpr std::size_t n = LongCode::n, third = 341;
  for (std::size_t shift = third - 3; shift <= third + 3; ++shift) {
    const Bits<2 * n> differing = twice(bits ^ rotate(bits, n - shift));
    for (std::size_t p = 0; p < n; p += kWordBits) {
      const std::uint64_t both = differing.get(p, 2 * kWordBits);
      if (shift == third ? !three_or_more(both) : !two_or_more(both)) return false;
    }
  }
  return true;
}

/// v(j) = b(2j mod N): the even bits, then the odd ones.
template <std::size_t N>
constexpr Bits<N> every_second_bit(const Bits<N>& bits) {
  static_assert(N % 2 == 1);
  Bits<N> out;
  for (std::size_t k = 0; k < Bits<N>::kWords; ++k) {
    const std::size_t inside = k + 1 == Bits<N>::kWords ? N - 64 * k : 64;
    for (std::size_t odd = 0; odd < 2; ++odd) {
      std::uint64_t x = bits.w[k] >> odd & 0x5555555555555555;
      x = (x | x >> 1) & 0x3333333333333333;
      x = (x | x >> 2) & 0x0F0F0F0F0F0F0F0F;
      x = (x | x >> 4) & 0x00FF00FF00FF00FF;
      x = (x | x >> 8) & 0x0000FFFF0000FFFF;
      x = (x | x >> 16) & 0x00000000FFFFFFFF;
      const std::size_t length = (inside + 1 - odd) / 2;
      if (length != 0) out.put((odd != 0 ? (N + 1) / 2 : 0) + 32 * k, length, x);
    }
  }
  return out;
}

/// At most 30 valid words in a row when every 2nd, 4th, 8th or 16th bit is read, from any place.
template <class Code>
constexpr bool passes_under_sampling(Bits<Code::n> bits) {
  for (int k = 1; k <= 4; ++k) {
    bits = every_second_bit(bits);
    if (!runs(word_places(bits), 31).none()) return false;
  }
  return true;
}

/// The tests of 4.3.2.5 beyond the check and control bits: the first that fails, or none.
template <class Code>
Fault examine_shape(const Bits<Code::n>& bits) {
  const Bits<Code::n> places = word_places(bits);
  if ((places & kInSynch<Code::n>) != kInSynch<Code::n>) return Fault::alphabet;
  if (!passes_off_synch<Code>(places)) return Fault::off_synch;
  if constexpr (Code::format == Format::long_)
    if (!passes_aperiodicity(bits)) return Fault::aperiodicity;
  if (!passes_under_sampling<Code>(bits)) return Fault::under_sampling;
  return Fault::none;
}

}  // namespace evc::airgap
