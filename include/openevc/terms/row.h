#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

// The vocabulary of the standard, declared once for all rooms. Next to each enumeration is its table: one row per
// enumerator with its name and, where chapter 7 gives one, its code on the wire. Codes and names are extracted from the
// tables at compile time, so that a room that uses the codes does not link the names.
namespace evc::terms {

template <class E>
constexpr std::size_t index(E value) {
  return static_cast<std::size_t>(value);
}

/// A term that is never sent over the air.
template <class E>
struct Row {
  E value;
  const char* name;
};

/// A term with its code of chapter 7.
template <class E>
struct WireRow {
  E value;
  std::uint8_t code;
  const char* name;
};

/// Whether there is one row for each enumerator, in the order of the enumeration.
template <class Rows>
constexpr bool in_order(const Rows& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (index(rows[i].value) != i) return false;
  return true;
}

/// Whether the values of the enumerators are the codes of the wire.
template <class Rows>
constexpr bool value_is_code(const Rows& rows) {
  for (const auto& row : rows)
    if (index(row.value) != row.code) return false;
  return true;
}

template <const auto& kRows>
inline constexpr auto kCodes = [] {
  std::array<std::uint8_t, kRows.size()> codes{};
  for (std::size_t i = 0; i < kRows.size(); ++i) codes[i] = kRows[i].code;
  return codes;
}();

template <const auto& kRows>
inline constexpr auto kNames = [] {
  std::array<const char*, kRows.size()> names{};
  for (std::size_t i = 0; i < kRows.size(); ++i) names[i] = kRows[i].name;
  return names;
}();

/// The enumerator with a code of the wire, of a table without gaps that begins with code 0; none for a spare code.
template <class E, const auto& kRows>
constexpr std::optional<E> of_code(std::uint64_t code) {
  static_assert(value_is_code(kRows) && in_order(kRows));
  if (code >= kRows.size()) return std::nullopt;
  return static_cast<E>(code);
}

}  // namespace evc::terms
