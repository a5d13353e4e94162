#pragma once
// Telegrams and streams for the tests of this folder.
#include <cstdint>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "airgap/airgap.h"

namespace evc::airgap::samples {

using Bytes = std::vector<std::uint8_t>;
using Generator = std::mt19937_64;

inline Bytes bytes_of(const std::string& hex) {
  Bytes bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(hex.substr(i, 2), nullptr, 16)));
  return bytes;
}
inline Bytes bytes_of(std::span<const std::uint8_t> span) { return {span.begin(), span.end()}; }
inline Format format_of(const nlohmann::json& vector) {
  return vector.at("format") == 1023 ? Format::long_ : Format::short_;
}

inline Bytes random_user(Generator& random, Format format) {
  Bytes user(bytes_for(user_bits(format)));
  for (auto& byte : user) byte = static_cast<std::uint8_t>(random());
  user.back() &= static_cast<std::uint8_t>(0xFFu << (8 * user.size() - user_bits(format)));
  return user;
}

/// A stream of single bits, in the form the receivers read.
struct Stream {
  std::vector<int> bits;
  void add(const Coded& coded, std::size_t from, std::size_t count, bool inverted = false) {
    for (std::size_t i = 0; i < count; ++i)
      bits.push_back((bit(coded.bytes, (from + i) % coded_bits(coded.format)) != inverted) ? 1 : 0);
  }
  void add_equal(int value, std::size_t count) { bits.insert(bits.end(), count, value); }
  void add_noise(Generator& random, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) bits.push_back(static_cast<int>(random() >> 63));
  }
  Bytes bytes() const {
    Bytes out(bytes_for(bits.size()));
    for (std::size_t i = 0; i < bits.size(); ++i)
      if (bits[i] != 0) out[i / 8] |= static_cast<std::uint8_t>(0x80u >> i % 8);
    return out;
  }
  Outcome<Received> receive(std::size_t from = 0) const { return airgap::receive(bytes(), bits.size(), from); }
};

}  // namespace evc::airgap::samples
