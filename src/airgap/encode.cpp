#include "airgap/candidate.h"

namespace evc::airgap {
namespace {

/// Division by h = x^32+x^31+x^30+x^29+x^27+x^25+1, a byte of the quotient a step (4.3.2.2).
struct ScramblerStep {
  std::uint32_t state = 0;  // the register after the feedback of the byte
  std::uint8_t out = 0;
};
constexpr std::uint32_t kScramblerTaps = 0xEA000001;
constexpr auto scrambler_steps = [] {
  std::array<ScramblerStep, 256> table{};
  for (std::uint32_t in = 0; in < 256; ++in) {
    std::uint32_t state = in << 24;
    for (int i = 0; i < 8; ++i) {
      const bool s = state >> 31 != 0;
      table[in].out = static_cast<std::uint8_t>(table[in].out << 1 | static_cast<int>(s));
      state = state << 1 ^ (s ? kScramblerTaps : 0);
    }
    table[in].state = state;
  }
  return table;
}();

/// The user bits with the first block replaced by the sum of all blocks, modulo 1024 (4.3.2.1).
template <class Code>
std::array<std::uint8_t, bytes_for(Code::m)> with_first_block_summed(std::span<const std::uint8_t> user) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < Code::m; i += kBlockBits) sum += take(user, i, kBlockBits);
  const Bits<Code::m> bits = load<Code::m>(user, 0);
  Bits<Code::m> first;
  first.put(Code::m - kBlockBits, kBlockBits, take(user, 0, kBlockBits) ^ (sum & 1023));
  std::array<std::uint8_t, bytes_for(Code::m)> bytes{};
  store(bits ^ first, bytes);
  return bytes;
}

/// The shaped data, control and scrambling bits for one sb; b94..b0 are zero.
template <class Code>
Bits<Code::n> shape(std::span<const std::uint8_t, bytes_for(Code::m)> summed, std::uint16_t sb) {
  std::array<std::uint8_t, bytes_for(Code::m)> scrambled{};
  std::uint32_t state = scrambler_seed(sb);
  for (std::size_t i = 0; i < summed.size(); ++i) {
    const ScramblerStep& step = scrambler_steps[(state >> 24) ^ summed[i]];
    scrambled[i] = step.out;
    state = state << 8 ^ step.state;
  }
  Bits<Code::n> bits;
  std::size_t place = Code::n;
  for (std::size_t i = 0; i < Code::m; i += kBlockBits) {
    place -= kWordBits;
    bits.put(place, kWordBits, words[take(scrambled, i, kBlockBits)]);
  }
  bits.put(kControlAt, 3, kControlBits);
  bits.put(kSbAt, 12, sb);
  return bits;
}

/// b94..b0 that esb = i alone contributes: its own bits and their check bits.
template <class Code>
constexpr auto esb_tails = [] {
  std::array<Residue, 1024> tails{};
  Residue x = Arithmetic<Code>::power(kEsbAt);
  for (std::size_t b = 1; b < 1024; b *= 2) {
    for (std::size_t i = 0; i < b; ++i) {
      tails[b + i] = tails[i] ^ x;
      tails[b + i].high ^= static_cast<std::uint64_t>(b) << (kEsbAt - 64);
    }
    x = Arithmetic<Code>::step(x);
  }
  return tails;
}();

/// Words at places 88, 77, ... 0 of b98..b0, all valid?
constexpr bool tail_is_of_words(Residue tail) {
  if (!is_word(tail.high >> 24 & 2047)) return false;
  if (!is_word(tail.high >> 13 & 2047)) return false;
  if (!is_word(tail.high >> 2 & 2047)) return false;
  if (!is_word((tail.high << 9 | tail.low >> 55) & 2047)) return false;
  for (int at = 44; at >= 0; at -= 11)
    if (!is_word(tail.low >> at & 2047)) return false;
  return true;
}

template <class Code>
Outcome<Coded> encode_as(std::span<const std::uint8_t> user, Shaping from) {
  Outcome<Coded> coded{Fault::no_candidate, {Code::format, {}, {}}};
  if (user.size() < bytes_for(Code::m)) return {Fault::size, coded.value};
  const auto summed = with_first_block_summed<Code>(user);
  std::uint16_t esb = from.esb;
  for (std::uint16_t sb = from.sb; sb < 4096; ++sb, esb = 0) {
    if (!is_word(kControlBits << 8 | sb >> 4)) continue;
    Bits<Code::n> bits = shape<Code>(summed, sb);
    Residue fixed = Arithmetic<Code>::of(bits) ^ Code::g;
    fixed.high |= static_cast<std::uint64_t>(sb & 15) << (kSbAt - 64);  // begins the word at place 88
    for (; esb < 1024; ++esb) {
      const Residue tail = fixed ^ esb_tails<Code>[esb];
      if (!tail_is_of_words(tail)) continue;
      Bits<Code::n> candidate = bits;
      candidate.w[0] |= tail.low;
      candidate.w[1] |= tail.high;  // already holds the last bits of sb
      if (examine_shape<Code>(candidate) != Fault::none) continue;
      coded = {Fault::none, {Code::format, {sb, esb}, {}}};
      store(candidate, coded.value.bytes);
      return coded;
    }
  }
  return coded;
}

}  // namespace

Outcome<Coded> encode(std::span<const std::uint8_t> user, Format format, Shaping from) {
  return format == Format::long_ ? encode_as<LongCode>(user, from) : encode_as<ShortCode>(user, from);
}

}  // namespace evc::airgap
