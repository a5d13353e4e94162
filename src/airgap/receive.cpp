#include "airgap/bits.h"
#include "airgap/code.h"
#include "airgap/words.h"

namespace evc::airgap {
namespace {

/// The inverse of the scrambler: u'(x) * x^32 = s(x) * h(x) + S * x^m + (degree < 32), so that each bit is a sum of
/// bits of s and S at fixed distances, and a word of 64 is as many exclusive-ors.
template <std::size_t M>
Bits<M> descramble(const Bits<M>& s, std::uint32_t seed) {
  Bits<M> out;
  for (std::size_t k = 0; k < Bits<M>::kWords; ++k) {
    const std::uint64_t here = s.w[k], above = k + 1 < Bits<M>::kWords ? s.w[k + 1] : 0;
    std::uint64_t sum = here;
    for (const int distance : {1, 2, 3, 5, 7, 32}) sum ^= here >> distance | above << (64 - distance);
    out.w[k] = sum;
  }
  Bits<M> key;
  key.put(M - 32, 32, seed);
  return out ^ key;
}

/// Undoes the sum in the first block (4.3.4.1.6).
template <std::size_t M>
void restore_first_block(Bits<M>& user) {
  std::uint64_t others = 0;
  for (std::size_t p = 0; p + kBlockBits < M; p += kBlockBits) others += user.get(p, kBlockBits);
  const std::uint64_t summed = user.get(M - kBlockBits, kBlockBits);
  Bits<M> change;
  change.put(M - kBlockBits, kBlockBits, summed ^ ((summed - others) & 1023));
  user = user ^ change;
}

/// Steps 4 to 12 of the receiver: a window from index `at` that is a multiple of g, with this residue modulo f*g.
template <class Code>
Outcome<Received> read_window(std::span<const std::uint8_t> stream, std::size_t at, Residue residue) {
  Outcome<Received> out;
  out.value.format = Code::format;
  const std::int16_t start = Arithmetic<Code>::start[Arithmetic<Code>::leading(residue)];
  if (start < 0) return {Fault::synchronisation, out.value};
  out.value.rotation = static_cast<std::uint16_t>(start);
  Bits<Code::n> bits = rotate(load<Code::n>(stream, at), out.value.rotation);
  out.value.inverted = bits[kControlAt + 2];
  if (out.value.inverted) bits = bits.inverted();  // the alphabet is closed under inversion

  bool valid = true;
  for (std::size_t p = 0; p < kShapedAt; p += kWordBits) valid &= is_word(bits.get(p, kWordBits));
  Bits<Code::m> scrambled;
  for (std::size_t p = kShapedAt, q = 0; p < Code::n; p += kWordBits, q += kBlockBits) {
    const std::int16_t block = block_of[bits.get(p, kWordBits)];
    valid &= block >= 0;
    scrambled.put(q, kBlockBits, static_cast<std::uint64_t>(block) & 1023);
  }
  if (!valid) return {Fault::alphabet, out.value};
  if (bits.get(kControlAt, 2) != kControlBits) return {Fault::unknown_format, out.value};

  out.value.shaping = {static_cast<std::uint16_t>(bits.get(kSbAt, 12)),
                       static_cast<std::uint16_t>(bits.get(kEsbAt, 10))};
  Bits<Code::m> user = descramble(scrambled, scrambler_seed(out.value.shaping.sb));
  restore_first_block(user);
  store(user, out.value.user);
  return out;
}

template <class Code>
Outcome<Received> read_as(std::span<const std::uint8_t> period) {
  if (period.size() < bytes_for(Code::n)) return {Fault::size, {}};
  const Residue residue = Arithmetic<Code>::of(load<Code::n>(period, 0));
  if (Arithmetic<Code>::modulo_g(residue) != Residue{}) return {Fault::parity, {}};
  Outcome<Received> out = read_window<Code>(period, 0, residue);
  out.value.end = Code::n;
  return out;
}

bool equal(std::span<const std::uint8_t> stream, std::size_t a, std::size_t b, std::size_t length) {
  for (; length > 64; length -= 64, a += 64, b += 64)
    if (take(stream, a, 64) != take(stream, b, 64)) return false;
  return take(stream, a, length) == take(stream, b, length);
}

/// Whether a window with fault `a` passed more tests than one with `b`: the order of the receiver's
/// tests.
constexpr bool further(Fault a, Fault b) { return a > b; }

/// One of the two receivers that work in parallel: the first safe window that ends at or before `count`.
template <class Code>
Outcome<Received> search(std::span<const std::uint8_t> stream, std::size_t from, std::size_t count) {
  constexpr std::size_t n = Code::n;
  constexpr std::size_t far = 7500;  // bits, after which r = n (4.3.4.1.2)
  if (count < from || count - from < n + Code::r) return {Fault::too_few_bits, {}};
  Outcome<Received> best{Fault::parity, {}};
  // The residue modulo g of the sliding window: the bit that leaves and the bit that enters both have weight x^0, as
  // x^n = 1 modulo g.
  Residue sliding = Arithmetic<Code>::modulo_g(Arithmetic<Code>::of(load<n>(stream, from)));
  // The residue modulo f*g is kept while one multiple of g follows another, as with a line of
  // constant bits.
  Residue whole;
  bool have_whole = false;
  std::uint64_t changes = 0;
  for (std::size_t at = from;; ++at) {
    const std::size_t extra = at - from > far ? n : Code::r;
    if (at + n + extra > count) return best;
    if (sliding != Residue{}) {
      have_whole = false;
    } else {
      whole = have_whole ? Arithmetic<Code>::step(whole) : Arithmetic<Code>::of(load<n>(stream, at));
      have_whole = true;
      Outcome<Received> found{Fault::repetition, {}};
      if (equal(stream, at, at + n, extra)) found = read_window<Code>(stream, at, whole);
      found.value.start = at;
      found.value.end = at + n + extra;
      if (found || found.fault == Fault::unknown_format) return found;
      if (further(found.fault, best.fault)) best = found;
    }
    if ((at - from) % 64 == 0) changes = take(stream, at, 64) ^ take(stream, at + n, 64);  // r > 64
    sliding = sliding.times_x();
    sliding = sliding ^ Code::g.if_set(sliding.high >> 11);
    sliding.low ^= changes >> 63;
    changes <<= 1;
  }
}

}  // namespace

Outcome<Received> read(std::span<const std::uint8_t> period, Format format) {
  return format == Format::long_ ? read_as<LongCode>(period) : read_as<ShortCode>(period);
}

Outcome<Received> receive(std::span<const std::uint8_t> stream, std::size_t count, std::size_t from) {
  if (stream.size() * 8 < count) return {Fault::size, {}};
  const Outcome<Received> as_short = search<ShortCode>(stream, from, count);
  const bool short_ended = as_short || as_short.fault == Fault::unknown_format;
  // In time the two receivers run side by side: the one that ends first decides.
  const Outcome<Received> as_long = search<LongCode>(stream, from, short_ended ? as_short.value.end : count);
  if (as_long || as_long.fault == Fault::unknown_format) return as_long;
  return short_ended || further(as_short.fault, as_long.fault) ? as_short : as_long;
}

}  // namespace evc::airgap
