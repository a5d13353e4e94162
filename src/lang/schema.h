#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <type_traits>
#include <utility>

#include "base/inplace_vector.h"

// The notation of the ETCS language. A packet is declared once: a plain struct, its PacketInfo, and one `layout_of<>`
// that lists its fields in the order of SUBSET-026-7. The reader, the writer, the JSON form, the tables of `evc
// describe` and the pages in docs/packets derive from it.
namespace evc::lang {

/// X.Y of the system version (SUBSET-026-6 6.5, M_VERSION).
struct SystemVersion {
  std::uint8_t x = 2;
  std::uint8_t y = 1;
  friend constexpr auto operator<=>(const SystemVersion&, const SystemVersion&) = default;
};
/// Of the 7 bits of M_VERSION: X in the upper three, Y in the lower four.
constexpr SystemVersion system_version(std::uint64_t M_VERSION) {
  return {static_cast<std::uint8_t>(M_VERSION >> 4), static_cast<std::uint8_t>(M_VERSION & 15u)};
}

/// A set of the seven system versions whose layouts are known.
using Versions = std::uint8_t;
inline constexpr Versions v1_0 = 1, v1_1 = 2, v2_0 = 4, v2_1 = 8, v2_2 = 16, v2_3 = 32, v3_0 = 64;
inline constexpr unsigned kVersions = 7;
/// The place of one version in tables of all of them: 0 for v1_0.
constexpr unsigned index_of(Versions one) { return static_cast<unsigned>(std::countr_zero(one)); }

/// The newest version of units of Baseline 3 and of SRS 4.0.0 (SUBSET-026-6 6.4.2.1).
inline constexpr SystemVersion kNewest_of_baseline_3{2, 1}, kNewest{3, 0};
/// Stands for every Y that a unit does not know (3.17.3.11).
inline constexpr std::uint8_t kLater_Y = 15;
/// `sv` as it is to a unit whose newest version is `newest`: a Y that it does not know is kLater_Y; 0.0 if it does not
/// know X (3.17.3.5).
constexpr SystemVersion as_known(SystemVersion sv, SystemVersion newest) {
  if (sv.x > newest.x) return {0, 0};
  return sv.x == newest.x && sv.y > newest.y ? SystemVersion{sv.x, kLater_Y} : sv;
}

/// NID_RADIO of an RBC that is interfaced to FRMCS only: no number consists of digits that are not used (7.5.1.95).
inline constexpr std::uint64_t kNo_number = 0xEEEE'EEEE'EEEE'EEEEu;

/// The known version to read `sv` with: itself, or the newest supported one with the same X (3.17.3.11); 0 if X is
/// unknown. A later Y of X = 2 occurs in units of Baseline 3 only, which read it as 2.1: no more follow 2.3 (7.5.1.79).
constexpr Versions known_version(SystemVersion sv) {
  if (sv.x == 1) return sv.y == 0 ? v1_0 : v1_1;
  if (sv.x == 2) return sv.y == 0 ? v2_0 : sv.y == 2 ? v2_2 : sv.y == 3 ? v2_3 : v2_1;
  return sv.x == 3 ? v3_0 : Versions{0};
}

/// A version Y later than the supported ones, of a known X (3.17.3.11).
constexpr bool is_later(SystemVersion sv) {
  return (sv.x == 1 && sv.y > 1) || (sv.x == 2 && sv.y > 3) || (sv.x == 3 && sv.y > 0);
}

/// A set of transmission media.
using Media = std::uint8_t;
namespace media {
inline constexpr Media balise = 1, loop = 2, RBC = 4, RIU = 8;
}

enum class Direction : std::uint8_t { to_train, to_track };

/// The heading of the table of a packet in chapter 7.
struct PacketInfo {
  std::uint8_t NID_PACKET;
  const char* name;
  Direction direction;
  Versions versions;
  Media media;
  const char* ref;
  const char* note;
};

/// The heading of the table of a message in chapter 8.
struct MessageInfo {
  std::uint8_t NID_MESSAGE;
  const char* name;
  Direction direction;
  Versions versions;
  const char* ref;
};

template <std::size_t N>
struct Name {
  char text[N]{};
  // NOLINTNEXTLINE(google-explicit-constructor): a literal is the name
  constexpr Name(const char (&s)[N]) {
    for (std::size_t i = 0; i < N; ++i) text[i] = s[i];
  }
};

/// Codes `first` to `last`.
struct Range {
  std::uint64_t first, last;
};

/// Instead of a range of spare codes: those with a decimal digit A to E (7.5.1.91.1, 7.5.1.92).
inline constexpr Range decimal_digits{1, 0};
constexpr bool is_in(Range range, std::uint64_t code) {
  if (range.first <= range.last) return code >= range.first && code <= range.last;
  for (; code != 0; code >>= 4)
    if ((code & 15u) >= 10 && (code & 15u) <= 14) return true;
  return false;
}

constexpr std::uint64_t all_ones(unsigned bits) {
  return bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
}

/// One variable of the ETCS language (SUBSET-026-7 7.5): name and width are its type, `raw` is the
/// number on the wire. Codes above `max` are special or spare.
template <Name N, unsigned Bits, std::uint64_t Max = all_ones(Bits), Range... Spare>
struct Variable {
  static_assert(Bits >= 1 && Bits <= 64);
  using Raw = std::conditional_t<
      (Bits <= 8), std::uint8_t,
      std::conditional_t<(Bits <= 16), std::uint16_t, std::conditional_t<(Bits <= 32), std::uint32_t, std::uint64_t>>>;
  static constexpr const char* name = N.text;
  static constexpr unsigned bits = Bits;
  static constexpr std::uint64_t max = Max;
  /// A code without a meaning in the versions of its layout (7.3.2, 3.16.1.1).
  static constexpr bool is_spare([[maybe_unused]] std::uint64_t code) { return (is_in(Spare, code) || ...); }
  static constexpr bool has_spare = sizeof...(Spare) > 0;
  Raw raw = 0;
  friend constexpr bool operator==(Variable, Variable) = default;
};

/// Bits without a structure in ETCS, up to the end given by L_PACKET (packet 44).
struct Opaque {
  std::uint16_t bits = 0;
  InplaceVector<std::uint8_t, 1024> bytes;  // left aligned
  friend constexpr bool operator==(const Opaque&, const Opaque&) = default;
};

/// The layout of a structure: specialised once per packet, message and repeated group.
template <class T>
inline constexpr bool layout_of = false;
template <class T>
concept HasLayout = !std::is_same_v<std::remove_cvref_t<decltype(layout_of<T>)>, bool>;

/// The codes of another variable under which items are present.
struct Test {
  bool negated = false;
  std::uint8_t count = 0;
  std::uint16_t codes[2]{};
  constexpr bool operator()(std::uint64_t code) const {
    bool found = false;
    for (std::uint8_t i = 0; i < count; ++i) found = found || codes[i] == code;
    return found != negated;
  }
};
constexpr Test is(std::uint16_t a) { return {false, 1, {a, 0}}; }
constexpr Test is(std::uint16_t a, std::uint16_t b) { return {false, 2, {a, b}}; }
constexpr Test is_not(std::uint16_t a) { return {true, 1, {a, 0}}; }

/// Items of a layout in their order: a tuple that compiles fast. Each file that includes a packet builds its layout;
/// with std::tuple, recursion and constructors would take most of that time.
template <std::size_t K, class I>
struct ItemAt {
  I item;
};
template <class Indices, class... I>
struct ItemsAt;
template <std::size_t... K, class... I>
struct ItemsAt<std::index_sequence<K...>, I...> : ItemAt<K, I>... {};
template <class... I>
struct Items : ItemsAt<std::index_sequence_for<I...>, I...> {};
/// Item `K` of the list.
template <std::size_t K, class I>
[[gnu::always_inline]] constexpr const I& at(const ItemAt<K, I>& items) {
  return items.item;
}
/// Calls `f` with each item in turn, from item `From` on.
template <std::size_t From = 0, class... I, class F>
[[gnu::always_inline]] constexpr void each(const Items<I...>& items, F f) {
  [&]<std::size_t... K>(std::index_sequence<K...>) { (f(at<From + K>(items)), ...); }
  (std::make_index_sequence<sizeof...(I) - From>{});
}

template <class S, class V>
struct Field {
  const char* name;
  V S::*member;
};
/// Items that are present only if `test` holds for `condition`.
template <class S, class V, class... I>
struct When {
  V S::*condition;
  Test test;
  Items<I...> items;
};
/// The same for a condition on the nearest variable V of the structures around this one.
template <class V, class... I>
struct WhenAround {
  Test test;
  Items<I...> items;
};
/// A counter (N_ITER, L_TEXT), not stored because it is the number of elements, and the elements.
template <class S, class Count, class E, std::size_t N>
struct Repeat {
  using Counter = Count;
  using Element = E;
  static constexpr std::size_t capacity = N;
  const char* count_name;
  const char* name;
  InplaceVector<E, N> S::*elements;
};
template <class S>
struct RestOfPacket {
  const char* name;
  Opaque S::*member;
};

template <class S, class V>
constexpr Field<S, V> item(V S::*member) {
  return {V::name, member};
}
template <class I>
constexpr I item(I i) {
  return i;
}
/// A field whose name in the structure differs from the variable's.
template <class S, class V>
constexpr Field<S, V> named(const char* name, V S::*member) {
  return {name, member};
}
template <class... I>
constexpr auto layout(I... items) {
  return Items<decltype(item(items))...>{{{item(items)}...}};
}
template <class S, class V, class... I>
constexpr auto when(V S::*condition, Test test, I... items) {
  return When<S, V, decltype(item(items))...>{condition, test, layout(items...)};
}
template <class V, class... I>
constexpr auto when_around(Test test, I... items) {
  return WhenAround<V, decltype(item(items))...>{test, layout(items...)};
}
template <class Count, class S, class E, std::size_t N>
constexpr Repeat<S, Count, E, N> repeat(const char* name, InplaceVector<E, N> S::*elements) {
  return {Count::name, name, elements};
}
template <class Count, class S, class E, std::size_t N>
constexpr Repeat<S, Count, E, N> repeat(const char* count_name, const char* name, InplaceVector<E, N> S::*elements) {
  return {count_name, name, elements};
}
template <class S>
constexpr RestOfPacket<S> rest_of_packet(const char* name, Opaque S::*member) {
  return {name, member};
}

}  // namespace evc::lang
