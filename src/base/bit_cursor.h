#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace evc {

// window() swaps eight bytes in one step.
static_assert(std::endian::native == std::endian::little);

/// Reads unsigned numbers of 1 to 64 bits from a bit string, most significant bit first and without
/// alignment (SUBSET-026-8 8.4.1). A read beyond the end gives 0 and makes the reader faulty; so does
/// every read after that (the fault is sticky), and the position stays where the first one failed.
class BitReader {
 public:
  /// Reads the first `bits` bits of `bytes`; a count larger than the bytes hold is reduced to what they hold.
  constexpr BitReader(std::span<const std::uint8_t> bytes, std::size_t bits, std::size_t position = 0)
      : data_(bytes.data()),
        size_(bytes.size()),
        at_(position),
        end_(bits < bytes.size() * 8 ? bits : bytes.size() * 8) {}
  constexpr explicit BitReader(std::span<const std::uint8_t> bytes) : BitReader(bytes, bytes.size() * 8) {}

  constexpr std::size_t position() const { return at_; }
  constexpr std::size_t end() const { return end_; }
  constexpr std::size_t left() const { return faulty_ || at_ > end_ ? 0 : end_ - at_; }
  constexpr bool faulty() const { return faulty_; }
  /// What was being read when the reader became faulty; null before that.
  constexpr const char* failed_on() const { return failed_on_; }
  constexpr void fail(const char* what) {
    if (!faulty_) failed_on_ = what;
    faulty_ = true;
    end_ = 0;  // so that one comparison per read is enough
  }

  /// The next `bits` bits (1 to 64); `what` names them for failed_on().
  [[gnu::always_inline]] std::uint64_t read(unsigned bits, const char* what = nullptr) {
    if (at_ + bits > end_) [[unlikely]] {
      fail(what);
      return 0;
    }
    if (bits <= kWindow) [[likely]] {
      const std::uint64_t value = window() >> (64 - bits);
      at_ += bits;
      return value;
    }
    const std::uint64_t high = window() >> 32;
    at_ += 32;
    const std::uint64_t low = window() >> (96 - bits);
    at_ += bits - 32;
    return (high << (bits - 32)) | low;
  }
  /// Bits that window() holds at least.
  static constexpr unsigned kWindow = 57;
  /// The bits from position() on, the first one most significant; zeros after the end of the bytes.
  [[gnu::always_inline]] std::uint64_t window() const {
    const std::size_t byte = at_ / 8;
    std::uint64_t word = 0;
    if (byte + 8 <= size_) [[likely]] {
      std::memcpy(&word, data_ + byte, 8);
      word = __builtin_bswap64(word);
    } else {
      word = window_at_end(byte);
    }
    return word << (at_ % 8);
  }
  /// True if at least `bits` bits are left.
  constexpr bool has(std::size_t bits) const { return at_ + bits <= end_; }
  /// Skips `bits` bits. Requires has(bits).
  constexpr void advance(std::size_t bits) { at_ += bits; }
  /// The same, one bit at a time: the reference for the tests of read().
  constexpr std::uint64_t read_bit_by_bit(unsigned bits, const char* what = nullptr) {
    if (at_ + bits > end_) {
      fail(what);
      return 0;
    }
    std::uint64_t value = 0;
    for (unsigned i = 0; i < bits; ++i, ++at_) value = (value << 1) | ((data_[at_ / 8] >> (7 - at_ % 8)) & 1u);
    return value;
  }
  /// Continues at bit `position`; beyond the end the reader becomes faulty.
  constexpr void seek(std::size_t position, const char* what = nullptr) {
    if (position > end_)
      fail(what);
    else
      at_ = position;
  }

 private:
  /// The bytes from `byte` on where fewer than eight are left.
  [[gnu::noinline]] std::uint64_t window_at_end(std::size_t byte) const {
    if (byte >= size_) return 0;
    std::uint64_t word = 0;
    if (size_ >= 8) {
      std::memcpy(&word, data_ + size_ - 8, 8);
      return __builtin_bswap64(word) << (8 * (byte + 8 - size_));
    }
    for (std::size_t i = byte; i < byte + 8; ++i) word = (word << 8) | (i < size_ ? data_[i] : 0u);
    return word;
  }

  const std::uint8_t* data_;
  std::size_t size_;
  std::size_t at_;
  std::size_t end_;
  const char* failed_on_ = nullptr;
  bool faulty_ = false;
};

/// Writes unsigned numbers of 1 to 64 bits, most significant bit first. A write beyond the end, or
/// of a value that needs more bits, changes nothing and makes the writer faulty for good.
class BitWriter {
 public:
  constexpr explicit BitWriter(std::span<std::uint8_t> bytes) : data_(bytes.data()), end_(bytes.size() * 8) {}

  constexpr std::size_t position() const { return at_; }
  constexpr bool faulty() const { return faulty_; }
  constexpr void fail() { faulty_ = true; }
  /// The bytes written so far; the last one may be incomplete.
  constexpr std::span<const std::uint8_t> bytes() const { return {data_, (at_ + 7) / 8}; }

  /// Appends the low `bits` bits (1 to 64) of `value`.
  constexpr void write(std::uint64_t value, unsigned bits) {
    if (faulty_ || at_ + bits > end_ || (bits < 64 && (value >> bits) != 0)) {
      faulty_ = true;
      return;
    }
    put(at_, value, bits);
    at_ += bits;
  }
  /// Overwrites `bits` bits at `position`, which must have been written before.
  constexpr void patch(std::size_t position, std::uint64_t value, unsigned bits) {
    if (faulty_ || position + bits > at_ || (bits < 64 && (value >> bits) != 0)) {
      faulty_ = true;
      return;
    }
    put(position, value, bits);
  }

 private:
  constexpr void put(std::size_t at, std::uint64_t value, unsigned bits) {
    while (bits > 0) {
      const unsigned in_byte = static_cast<unsigned>(8 - at % 8);
      const unsigned take = bits < in_byte ? bits : in_byte;
      const unsigned mask = ((1u << take) - 1u) << (in_byte - take);
      const unsigned chunk = static_cast<unsigned>(value >> (bits - take)) << (in_byte - take);
      data_[at / 8] = static_cast<std::uint8_t>((data_[at / 8] & ~mask) | (chunk & mask));
      at += take;
      bits -= take;
    }
  }

  std::uint8_t* data_;
  std::size_t end_;
  std::size_t at_ = 0;
  bool faulty_ = false;
};

}  // namespace evc
