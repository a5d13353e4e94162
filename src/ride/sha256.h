#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace evc::ride {

/// SHA-256 (FIPS 180-4) of a text that comes in pieces. The browser has no library for it that works without waiting.
class Sha256 {
 public:
  void add(std::string_view text);
  /// Of everything added so far, in lower-case hexadecimal digits; more may be added behind it.
  std::string digest() const;

 private:
  void add_block(const std::uint8_t* block);

  std::array<std::uint32_t, 8> hash_{0x6A09E667, 0xBB67AE85, 0x3C6EF372, 0xA54FF53A,
                                     0x510E527F, 0x9B05688C, 0x1F83D9AB, 0x5BE0CD19};
  std::array<std::uint8_t, 64> block_{};
  std::uint64_t bytes_ = 0;
};

}  // namespace evc::ride
