#pragma once
/// Eurobalise telegram coding (SUBSET-036 4.3): user bits to the bits that a balise sends, and back.
///
/// All bit strings are bytes, left aligned: the first bit is the most significant bit of byte 0 and is sent first. The
/// functions have no state and allocate nothing.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace evc::airgap {

/// The two telegram formats (4.3.1.2): 1023 bits sent for 830 user bits, 341 bits sent for 210.
enum class Format : std::uint8_t { long_, short_ };

constexpr std::size_t coded_bits(Format format) { return format == Format::long_ ? 1023 : 341; }
constexpr std::size_t user_bits(Format format) { return format == Format::long_ ? 830 : 210; }
constexpr std::size_t bytes_for(std::size_t bits) { return (bits + 7) / 8; }

/// Bit `i` of a left aligned bit string; 0 is the first one sent.
constexpr bool bit(std::span<const std::uint8_t> bytes, std::size_t i) {
  return (bytes[i / 8] >> (7 - i % 8) & 1) != 0;
}

/// Why there is no telegram. Each value is one test of the standard.
enum class Fault : std::uint8_t {
  none,
  size,             ///< fewer bytes than the format needs
  too_few_bits,     ///< the stream ended before n + r bits (4.3.4.1.2): no verdict possible
  parity,           ///< not a multiple of g (annex A1, check bits)
  repetition,       ///< the r extra bits differ from the first r bits of the window
  synchronisation,  ///< multiple of g whose syndrome is that of no telegram start
  control_bits,     ///< candidate with cb other than 001 (4.3.2.4)
  alphabet,         ///< an 11-bit word outside the table (annex B2)
  off_synch,        ///< too many valid words in a row in a shifted parsing
  aperiodicity,     ///< long format too similar to itself after a third of its length
  under_sampling,   ///< too many valid words in a row when every 2nd, 4th, 8th or 16th bit is read
  unknown_format,   ///< b108 or b107 of a future format
  no_candidate,     ///< no pair (sb, esb) passes all tests
};
/// The fault's name as the standard calls the test, for messages.
std::string_view name(Fault fault);

/// A value, or the fault instead of it.
template <class T>
struct Outcome {
  Fault fault = Fault::none;
  T value{};
  explicit operator bool() const { return fault == Fault::none; }
  const T& operator*() const { return value; }
  const T* operator->() const { return &value; }
};

/// The encoder's free choice: scrambling bits sb (12 bits) and extra shaping bits esb (10 bits).
struct Shaping {
  std::uint16_t sb = 0;
  std::uint16_t esb = 0;
  friend constexpr bool operator==(const Shaping&, const Shaping&) = default;
};

/// A telegram as a balise sends it, from b(n-1) to b0.
struct Coded {
  Format format = Format::long_;
  Shaping shaping;
  std::array<std::uint8_t, 128> bytes{};  ///< coded_bits(format) bits, then zeros
  std::span<const std::uint8_t> bits() const { return {bytes.data(), bytes_for(coded_bits(format))}; }
};

/// A telegram found in received bits.
struct Received {
  Format format = Format::long_;
  Shaping shaping;                       ///< what the encoder chose
  bool inverted = false;                 ///< inversion bit b109 was set: all bits were inverted on the way
  std::uint16_t rotation = 0;            ///< bits by which the accepted window starts after b(n-1)
  std::size_t start = 0;                 ///< index of the accepted window's first bit in the stream
  std::size_t end = 0;                   ///< index after the last bit that was needed to accept
  std::array<std::uint8_t, 104> user{};  ///< user_bits(format) bits, then zeros
  std::span<const std::uint8_t> user_bytes() const { return {user.data(), bytes_for(user_bits(format))}; }
};

/// Codes `user` (830 or 210 bits; the remaining bits of the last byte are ignored) with the first pair (sb, esb), both
/// ascending, at or after `from` whose telegram passes all tests of 4.3.2.5. The standard allows any pair that passes.
/// Faults: `size`, `no_candidate`.
Outcome<Coded> encode(std::span<const std::uint8_t> user, Format format, Shaping from = {});

/// Tests a telegram that begins with b(n-1), as an encoder must before the telegram is used in a balise: check bits,
/// control bits, alphabet, off-synch parsing, aperiodicity, under-sampling, in this order. Returns the first test that
/// fails, or `none`.
Fault examine(std::span<const std::uint8_t> coded, Format format);

/// Reads one period of a telegram from a file, in any rotation, inverted or not: exactly coded_bits(format) bits. There
/// are no extra bits to compare, so this is not for use on a train: see `receive`. Faults: `size`, `parity`,
/// `synchronisation`, `alphabet`, `unknown_format`.
Outcome<Received> read(std::span<const std::uint8_t> period, Format format);

/// The receiver of 4.3.4: looks in bits [from, count) of `stream` for the first window of either format that is safe:
/// n bits divisible by g, followed by r = 77 (long) or 121 (short) bits equal to its first ones (r = n once the window
/// has moved over 7500 bits), synchronised, of valid words only. To search for the next telegram continue from
/// `Received::end`. The fault is that of the window that passed the most tests; bits of a future format end the search.
Outcome<Received> receive(std::span<const std::uint8_t> stream, std::size_t count, std::size_t from = 0);

}  // namespace evc::airgap
