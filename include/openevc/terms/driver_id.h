#pragma once
#include <array>
#include <cstddef>
#include <string_view>

namespace evc {

/// The driver ID: up to 16 letters and digits (A.3.11 of 4.0.0), the rest zero.
struct DriverId {
  static constexpr std::size_t kMost = 16;
  std::array<char, kMost> characters{};

  constexpr DriverId() = default;
  constexpr explicit DriverId(std::string_view text) {
    for (std::size_t i = 0; i < text.size() && i < kMost; ++i) characters[i] = text[i];
  }
  constexpr std::string_view view() const {
    std::size_t size = 0;
    while (size < kMost && characters[size] != '\0') ++size;
    return {characters.data(), size};
  }
  /// Whether it is one that a driver may have.
  constexpr bool valid() const {
    for (const char c : view())
      if (!((c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'))) return false;
    return !view().empty();
  }
  friend constexpr bool operator==(const DriverId&, const DriverId&) = default;
};

/// A language by its two lower-case letters (ISO 639-1): "en".
struct Language {
  std::array<char, 2> letters{'e', 'n'};
  constexpr bool valid() const {
    for (const char c : letters)
      if (c < 'a' || c > 'z') return false;
    return true;
  }
  constexpr std::string_view view() const { return {letters.data(), letters.size()}; }
  friend constexpr bool operator==(const Language&, const Language&) = default;
};

}  // namespace evc
