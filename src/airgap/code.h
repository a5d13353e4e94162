#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "airgap/airgap.h"
#include "airgap/bits.h"

// The two cyclic codes of SUBSET-036 4.3 and arithmetic modulo f*g, 64 bits a step.
namespace evc::airgap {

/// A polynomial of degree below 128: `low` holds x^63..x^0.
struct Residue {
  std::uint64_t high = 0;
  std::uint64_t low = 0;
  friend constexpr Residue operator^(Residue a, Residue b) { return {a.high ^ b.high, a.low ^ b.low}; }
  friend constexpr bool operator==(Residue, Residue) = default;
  constexpr Residue times_x() const { return {high << 1 | low >> 63, low << 1}; }
  /// This, or nothing when the lowest bit of `condition` is 0.
  constexpr Residue if_set(std::uint64_t condition) const {
    const std::uint64_t mask = std::uint64_t{0} - (condition & 1);
    return {high & mask, low & mask};
  }
  constexpr bool has(std::size_t i) const { return ((i < 64 ? low >> i : high >> (i - 64)) & 1) != 0; }
};

/// The polynomial with these exponents.
template <class... Exponents>
constexpr Residue polynomial(Exponents... exponents) {
  Residue sum;
  for (const int e : {exponents...})
    sum = sum ^ (e < 64 ? Residue{0, std::uint64_t{1} << e} : Residue{std::uint64_t{1} << (e - 64), 0});
  return sum;
}
constexpr Residue product(Residue a, Residue b) {
  Residue sum;
  for (std::size_t i = 0; i < 128; ++i) {
    if (b.has(i)) sum = sum ^ a;
    a = a.times_x();
  }
  return sum;
}

// clang-format off
struct LongCode {
  static constexpr Format format = Format::long_;
  static constexpr std::size_t n = 1023, r = 77, m = 830;
  static constexpr Residue f = polynomial(10, 9, 7, 6, 4, 3, 2, 1, 0);
  static constexpr Residue g = polynomial(75, 73, 72, 71, 67, 62, 61, 60, 57, 56, 55, 52, 51, 49, 46, 45, 44, 43, 41, 37,
                                          35, 34, 33, 31, 30, 28, 26, 24, 21, 17, 16, 15, 13, 12, 11, 9, 4, 1, 0);
};
struct ShortCode {
  static constexpr Format format = Format::short_;
  static constexpr std::size_t n = 341, r = 121, m = 210;
  static constexpr Residue f = polynomial(10, 8, 7, 5, 3, 1, 0);
  static constexpr Residue g = polynomial(75, 72, 71, 70, 69, 68, 66, 65, 64, 63, 60, 55, 54, 49, 47, 46, 45, 44, 43, 42,
                                          41, 39, 38, 37, 36, 34, 33, 32, 31, 30, 27, 25, 22, 19, 17, 13, 12, 11, 10, 6,
                                          3, 1, 0);
};
// clang-format on

constexpr std::size_t kCheckBits = 85;     ///< b84..b0: 75 parity and 10 synchronisation bits
constexpr std::size_t kEsbAt = 85;         ///< b94..b85
constexpr std::size_t kSbAt = 95;          ///< b106..b95
constexpr std::size_t kControlAt = 107;    ///< b109 (inversion), b108, b107 (format)
constexpr std::size_t kShapedAt = 110;     ///< b(n-1)..b110
constexpr std::uint64_t kControlBits = 1;  ///< 0 0 1
constexpr std::size_t kBlockBits = 10, kWordBits = 11;

/// S of the scrambler from sb (4.3.2.2).
constexpr std::uint32_t scrambler_seed(std::uint16_t sb) { return 2801775573u * sb; }

/// Arithmetic of one code.
template <class Code>
struct Arithmetic {
  static constexpr Residue fg = product(Code::f, Code::g);
  static_assert(fg.high >> 21 == 1, "f*g has degree 85");

  static constexpr Residue step(Residue v) {  // x * v mod f*g
    v = v.times_x();
    return v.has(kCheckBits) ? v ^ fg : v;
  }
  /// x^e mod f*g.
  static constexpr Residue power(std::size_t e) {
    Residue v{0, 1};
    for (std::size_t i = 0; i < e; ++i) v = step(v);
    return v;
  }
  static_assert(power(Code::n) == Residue{0, 1}, "f*g divides x^n + 1");

  /// carry[j][d] = d * x^(85 + 4j) mod f*g: what the 64 bits above x^84 leave, in 16 digits of 4 bits.
  static constexpr auto carry = [] {
    std::array<std::array<Residue, 16>, 16> table{};
    Residue x = power(kCheckBits);
    for (std::size_t j = 0; j < 16; ++j)
      for (std::size_t b = 1; b < 16; b *= 2) {
        for (std::size_t d = 0; d < b; ++d) table[j][b + d] = table[j][d] ^ x;
        x = step(x);
      }
    return table;
  }();

  /// v * x^64 + word, mod f*g.
  static constexpr Residue append(Residue v, std::uint64_t word) {
    const std::uint64_t over = v.high << 43 | v.low >> 21;
    Residue sum{v.low & 0x1FFFFF, word};
    for (std::size_t j = 0; j < 16; ++j) sum = sum ^ carry[j][over >> (4 * j) & 15];
    return sum;
  }
  static constexpr Residue of(const Bits<Code::n>& bits) {
    Residue v;
    for (std::size_t k = Bits<Code::n>::kWords; k-- > 0;) v = append(v, bits.w[k]);
    return v;
  }

  /// multiple[i]: the multiple of g of degree below 85 whose bits 84..75 are bit i of ten alone.
  static constexpr auto multiple = [] {
    std::array<Residue, 10> basis{};
    for (std::size_t i = 0; i < 10; ++i) {
      Residue v = polynomial(static_cast<int>(75 + i));
      Residue divisor = Code::g;
      for (std::size_t k = 0; k < i; ++k) divisor = divisor.times_x();
      for (std::size_t k = i + 1; k-- > 0;) {
        if (v.has(75 + k)) v = v ^ divisor;
        divisor = {divisor.high >> 1, divisor.low >> 1 | divisor.high << 63};
      }
      basis[i] = v ^ polynomial(static_cast<int>(75 + i));
    }
    return basis;
  }();
  /// Bits 84..75 of a residue: they alone identify the multiple of g, if it is one.
  static constexpr std::size_t leading(Residue v) { return static_cast<std::size_t>(v.high >> 11 & 1023); }
  /// v mod g, of v mod f*g.
  static constexpr Residue modulo_g(Residue v) {
    const std::size_t top = leading(v);
    for (std::size_t i = 0; i < 10; ++i) v = v ^ multiple[i].if_set(top >> i);
    return v;
  }

  /// By how many bits a window that is a multiple of g starts after b(n-1): a telegram is g modulo f*g (4.3.2.6), so
  /// the window is x^s * g. Indexed by `leading`; -1: the start of no telegram.
  static constexpr auto start = [] {
    std::array<std::int16_t, 1024> table{};
    table.fill(-1);
    Residue v = Code::g;
    for (std::size_t s = 0; s < Code::n; ++s) {
      table[leading(v)] = static_cast<std::int16_t>(s);
      v = step(v);
    }
    return table;
  }();
  static_assert(start[0] == -1, "a short telegram repeated is no long one");
};

}  // namespace evc::airgap
