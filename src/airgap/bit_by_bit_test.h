#pragma once
// A second, slow implementation of SUBSET-036 4.3 for the tests: bit by bit, as the text describes it. It shares only
// the enumeration of faults with the fast one; its words are read from tests/reference/.
#include <algorithm>
#include <cstdint>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "airgap/airgap.h"
#include "base/test_paths.h"

namespace evc::airgap::bit_by_bit {

/// b[i] is the coefficient of x^i; the last element is sent first.
using Bits = std::vector<int>;

inline nlohmann::json reference(const std::string& file) {
  std::ifstream in(evc::test::source_folder() + "/tests/reference/" + file);
  return nlohmann::json::parse(in);
}
inline const std::vector<int>& word_table() {
  static const std::vector<int> table = reference("eurobalise_words.json").at("words").get<std::vector<int>>();
  return table;
}
inline const std::vector<int>& word_index() {
  static const std::vector<int> index = [] {
    std::vector<int> all(2048, -1);
    for (std::size_t i = 0; i < word_table().size(); ++i)
      all[static_cast<std::size_t>(word_table()[i])] = static_cast<int>(i);
    return all;
  }();
  return index;
}

struct Code {
  Format format;
  std::size_t n, r, m;
  std::vector<std::size_t> f, g;
};
inline const Code& code(Format format) {
  static const Code long_code{
      Format::long_, 1023, 77, 830, {10, 9, 7, 6, 4, 3, 2, 1, 0}, {75, 73, 72, 71, 67, 62, 61, 60, 57, 56, 55, 52, 51,
                                                                   49, 46, 45, 44, 43, 41, 37, 35, 34, 33, 31, 30, 28,
                                                                   26, 24, 21, 17, 16, 15, 13, 12, 11, 9,  4,  1,  0}};
  static const Code short_code{
      Format::short_, 341, 121, 210, {10, 8, 7, 5, 3, 1, 0}, {75, 72, 71, 70, 69, 68, 66, 65, 64, 63, 60,
                                                              55, 54, 49, 47, 46, 45, 44, 43, 42, 41, 39,
                                                              38, 37, 36, 34, 33, 32, 31, 30, 27, 25, 22,
                                                              19, 17, 13, 12, 11, 10, 6,  3,  1,  0}};
  return format == Format::long_ ? long_code : short_code;
}

inline std::vector<std::size_t> times(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b) {
  std::map<std::size_t, int> sum;
  for (const std::size_t i : a)
    for (const std::size_t k : b) sum[i + k] ^= 1;
  std::vector<std::size_t> exponents;
  for (auto it = sum.rbegin(); it != sum.rend(); ++it)
    if (it->second != 0) exponents.push_back(it->first);
  return exponents;
}
/// R_c[d]: long division, one coefficient at a time.
inline Bits remainder(Bits d, const std::vector<std::size_t>& c) {
  for (std::size_t i = d.size(); i-- > c.front();)
    if (d[i] != 0)
      for (const std::size_t e : c) d[i - c.front() + e] ^= 1;
  d.resize(c.front());
  return d;
}

/// A left aligned bit string of `count` bits, as a polynomial; and back.
inline Bits from_bytes(std::span<const std::uint8_t> bytes, std::size_t count) {
  Bits bits(count);
  for (std::size_t i = 0; i < count; ++i) bits[count - 1 - i] = bit(bytes, i) ? 1 : 0;
  return bits;
}
inline std::vector<std::uint8_t> to_bytes(const Bits& bits) {
  std::vector<std::uint8_t> bytes(bytes_for(bits.size()));
  for (std::size_t i = 0; i < bits.size(); ++i)
    if (bits[bits.size() - 1 - i] != 0) bytes[i / 8] |= static_cast<std::uint8_t>(0x80u >> i % 8);
  return bytes;
}
inline int number(const Bits& bits, std::size_t low, std::size_t length) {
  int value = 0;
  for (std::size_t i = length; i-- > 0;) value = 2 * value + bits[low + i];
  return value;
}
inline void set_number(Bits& bits, std::size_t low, std::size_t length, int value) {
  for (std::size_t i = 0; i < length; ++i) bits[low + i] = value >> i & 1;
}

/// The telegram for these user bits and this pair, without tests (E1 to E5).
inline Bits telegram(Bits user, const Code& c, int sb, int esb) {
  int sum = 0;
  for (std::size_t p = 0; p < c.m; p += 10) sum += number(user, p, 10);
  set_number(user, c.m - 10, 10, sum % 1024);

  std::uint32_t state = static_cast<std::uint32_t>(2801775573ULL * static_cast<unsigned>(sb) % 4294967296ULL);
  Bits scrambled(c.m);
  for (std::size_t i = c.m; i-- > 0;) {
    scrambled[i] = static_cast<int>(state >> 31) ^ user[i];
    state <<= 1;
    if (scrambled[i] != 0)
      for (const unsigned e : {31u, 30u, 29u, 27u, 25u, 0u}) state ^= 1u << e;
  }
  Bits b(c.n);
  for (std::size_t i = 0; i < c.m / 10; ++i)
    set_number(b, 110 + 11 * i, 11, word_table()[static_cast<std::size_t>(number(scrambled, 10 * i, 10))]);
  set_number(b, 107, 3, 1);
  set_number(b, 95, 12, sb);
  set_number(b, 85, 10, esb);
  const Bits check = remainder(b, times(c.f, c.g));
  for (std::size_t i = 0; i < 85; ++i) b[i] = check[i];
  for (const std::size_t e : c.g) b[e] ^= 1;
  return b;
}

/// The word b(i-1)..b(i-11), cyclic.
inline bool valid_word(const Bits& b, std::size_t i) {
  const std::size_t n = b.size();
  int word = 0;
  for (std::size_t k = 1; k <= 11; ++k) word = 2 * word + b[(i + n - k) % n];
  return word_index()[static_cast<std::size_t>(word)] >= 0;
}
/// The longest run of valid words in the parsing that starts at i, cyclic; a full circle counts n/11 words.
inline std::size_t longest_run(const Bits& b, std::size_t i) {
  const std::size_t n = b.size(), all = n / 11;
  std::size_t run = 0, longest = 0;
  for (std::size_t k = 0; k < 2 * all; ++k) {
    run = valid_word(b, (i + 2 * n - 11 * k) % n) ? run + 1 : 0;
    longest = std::max(longest, std::min(run, all));
  }
  return longest;
}
inline int distance(const Bits& b, std::size_t i, std::size_t k) {
  const std::size_t n = b.size();
  int differing = 0;
  for (std::size_t j = 1; j <= 22; ++j) differing += b[(i + n - j) % n] ^ b[(i + 2 * n - k - j) % n];
  return differing;
}

/// All tests that this candidate fails, in the text's order.
inline std::vector<Fault> failing_tests(const Bits& b, const Code& c) {
  std::vector<Fault> failing;
  Bits g(85);
  for (const std::size_t e : c.g) g[e] = 1;
  if (remainder(b, times(c.f, c.g)) != g) failing.push_back(Fault::parity);
  if (number(b, 107, 3) != 1) failing.push_back(Fault::control_bits);
  bool alphabet = true, off_synch = true, aperiodic = true, sampled = true;
  for (std::size_t i = 0; i < c.n; i += 11) alphabet &= valid_word(b, i);
  for (std::size_t i = 1; i < 11; ++i)
    off_synch &= longest_run(b, i) <= (i == 1 || i == 10 ? 2u : c.format == Format::long_ ? 10u : 6u);
  if (c.format == Format::long_)
    for (std::size_t i = 0; i < c.n; i += 11)
      for (std::size_t k = 338; k <= 344; ++k) aperiodic &= distance(b, i, k) >= (k == 341 ? 3 : 2);
  for (std::size_t k = 1; k <= 4; ++k) {
    Bits v(c.n);
    for (std::size_t j = 0; j < c.n; ++j) v[j] = b[(j << k) % c.n];
    for (std::size_t i = 0; i < 11; ++i) sampled &= longest_run(v, i) <= 30;
  }
  if (!alphabet) failing.push_back(Fault::alphabet);
  if (!off_synch) failing.push_back(Fault::off_synch);
  if (!aperiodic) failing.push_back(Fault::aperiodicity);
  if (!sampled) failing.push_back(Fault::under_sampling);
  return failing;
}

struct Read {
  Fault fault = Fault::none;
  Bits user;
  bool inverted = false;
  std::size_t rotation = 0, start = 0, end = 0;
};

/// Steps 4 to 12 for a window that is a multiple of g.
inline Read read_window(const Bits& window, const Code& c) {
  Read out;
  const Bits syndrome = remainder(window, c.f);
  static std::map<Format, std::map<Bits, std::size_t>> tables;
  auto& table = tables[c.format];
  if (table.empty())
    for (std::size_t s = 0; s < c.n; ++s) {
      Bits v(c.n);
      for (const std::size_t e : c.g) v[(e + s) % c.n] = 1;
      table[remainder(v, c.f)] = s;
    }
  const auto found = table.find(syndrome);
  if (found == table.end()) return {Fault::synchronisation, {}, false, 0, 0, 0};
  out.rotation = found->second;
  Bits b(c.n);
  for (std::size_t i = 0; i < c.n; ++i) b[i] = window[(i + out.rotation) % c.n];
  for (std::size_t i = 0; i < c.n; i += 11)
    if (!valid_word(b, i)) return {Fault::alphabet, {}, false, 0, 0, 0};
  out.inverted = b[109] == 1;
  if (out.inverted)
    for (int& x : b) x ^= 1;
  if (b[108] == 1 || b[107] == 0) return {Fault::unknown_format, {}, false, 0, 0, 0};
  Bits user(c.m);
  for (std::size_t i = 0; i < c.m / 10; ++i)
    set_number(user, 10 * i, 10, word_index()[static_cast<std::size_t>(number(b, 110 + 11 * i, 11))]);
  std::uint32_t state = 2801775573u * static_cast<std::uint32_t>(number(b, 95, 12));
  for (std::size_t i = c.m; i-- > 0;) {
    const int s = user[i];
    user[i] = static_cast<int>(state >> 31) ^ s;
    state <<= 1;
    if (s != 0)
      for (const unsigned e : {31u, 30u, 29u, 27u, 25u, 0u}) state ^= 1u << e;
  }
  int others = 0;
  for (std::size_t p = 0; p + 10 < c.m; p += 10) others += number(user, p, 10);
  set_number(user, c.m - 10, 10, ((number(user, c.m - 10, 10) - others) % 1024 + 1024) % 1024);
  out.user = user;
  return out;
}

/// One of the two receivers. `stream[0]` is received first. Faults as in `airgap::receive`.
inline Read search(const std::vector<int>& stream, const Code& c) {
  Read best{stream.size() < c.n + c.r ? Fault::too_few_bits : Fault::parity, {}, false, 0, 0, 0};
  for (std::size_t at = 0;; ++at) {
    const std::size_t extra = at > 7500 ? c.n : c.r;
    if (at + c.n + extra > stream.size()) return best;
    Bits window(stream.begin() + static_cast<std::ptrdiff_t>(at),
                stream.begin() + static_cast<std::ptrdiff_t>(at + c.n));
    std::reverse(window.begin(), window.end());
    const Bits parity = remainder(window, c.g);
    if (std::find(parity.begin(), parity.end(), 1) != parity.end()) continue;
    Read found{Fault::repetition, {}, false, 0, 0, 0};
    bool repeated = true;
    for (std::size_t i = 0; i < extra; ++i) repeated &= stream[at + i] == stream[at + c.n + i];
    if (repeated) found = read_window(window, c);
    found.start = at;
    found.end = at + c.n + extra;
    if (found.fault == Fault::none || found.fault == Fault::unknown_format) return found;
    if (found.fault > best.fault) best = found;
  }
}

}  // namespace evc::airgap::bit_by_bit
