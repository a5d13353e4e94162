#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "base/bit_cursor.h"
#include "lang/schema.h"

// Reader and writer made from the layouts. Included by the .cpp files that instantiate them only.
namespace evc::lang::codec {

/// A reader that also stores the first spare code it read.
struct Source {
  BitReader in;
  const char* spare_variable = nullptr;
  std::size_t spare_bit = 0;
  std::uint64_t spare_value = 0;
};

/// A structure and the one around it, for conditions on variables of the latter.
template <class T, class Up>
struct Scope {
  T& self;
  Up* up;
};

template <class V, class S, class W>
constexpr auto find_in(const Field<S, W>& f) {
  if constexpr (std::is_same_v<V, W>)
    return f.member;
  else
    return nullptr;
}
template <class V, class I>
constexpr std::nullptr_t find_in(const I&) {
  return nullptr;
}
template <class V, class... I>
constexpr auto find_in(const Items<I...>& items);
template <class V, class S, class W, class... I>
constexpr auto find_in(const When<S, W, I...>& w) {
  return find_in<V>(w.items);
}
template <class V, std::size_t K, class... I>
constexpr auto find_from(const Items<I...>& items) {
  if constexpr (K == sizeof...(I)) {
    return nullptr;
  } else {
    constexpr bool here = !std::is_same_v<decltype(find_in<V>(at<K>(items))), std::nullptr_t>;
    if constexpr (here)
      return find_in<V>(at<K>(items));
    else
      return find_from<V, K + 1>(items);
  }
}
template <class V, class... I>
constexpr auto find_in(const Items<I...>& items) {
  return find_from<V, 0>(items);
}

/// The code of the nearest variable V of the structures around.
template <class V, class T, class Up>
constexpr std::uint64_t around(const Scope<T, Up>& scope) {
  static_assert(!std::is_void_v<Up>, "no structure around has this variable");
  if constexpr (!std::is_void_v<Up>) {
    using Outer = std::remove_cvref_t<decltype(scope.up->self)>;
    constexpr auto member = find_in<V>(layout_of<Outer>);
    if constexpr (std::is_same_v<std::remove_cv_t<decltype(member)>, std::nullptr_t>)
      return around<V>(*scope.up);
    else
      return (scope.up->self.*member).raw;
  }
}

/// Width of an item if it is a plain field, else 0.
template <class I>
inline constexpr unsigned field_bits = 0;
template <class S, class V>
inline constexpr unsigned field_bits<Field<S, V>> = V::bits;
/// Where the run of plain fields that starts at item `from` ends: all that fit into one window of the reader.
template <class... I>
consteval std::size_t end_of_run(std::size_t from, const Items<I...>*) {
  constexpr std::array<unsigned, sizeof...(I) + 1> widths{field_bits<I>..., 0};
  std::size_t end = from;
  unsigned total = 0;
  while (end < sizeof...(I) && widths[end] != 0 && total + widths[end] <= BitReader::kWindow) total += widths[end++];
  return end;
}

// ---- reading

template <class V>
[[gnu::always_inline]] inline void note_spare(Source& from, std::uint64_t code) {
  if (!V::has_spare || !V::is_spare(code) || from.spare_variable != nullptr) [[likely]]
    return;
  from.spare_variable = V::name;
  from.spare_bit = from.in.position() - V::bits;
  from.spare_value = code;
}
template <class V>
[[gnu::always_inline]] inline void get(Source& from, V& v) {
  const std::uint64_t code = from.in.read(V::bits, V::name);
  v.raw = static_cast<typename V::Raw>(code);
  note_spare<V>(from, code);
}
/// One by one: used where a run does not fit into the remaining bits, or one of its codes is spare.
template <class S, class... V>
[[gnu::noinline]] void get_singly(Source& from, S& s, const Field<S, V>&... fields) {
  (get(from, s.*fields.member), ...);
}
/// A run of fields from one window.
template <class S, class... V>
[[gnu::always_inline]] inline void get_run(Source& from, S& s, const Field<S, V>&... fields) {
  constexpr unsigned total = (V::bits + ...);
  if (!from.in.has(total)) [[unlikely]]
    return get_singly(from, s, fields...);
  const std::uint64_t window = from.in.window();
  unsigned taken = 0;
  bool spare = false;
  const auto take = [&]<class W>(const Field<S, W>& f) __attribute__((always_inline)) {
    const std::uint64_t code = (window << taken) >> (64 - W::bits);
    taken += W::bits;
    (s.*f.member).raw = static_cast<typename W::Raw>(code);
    if constexpr (W::has_spare) spare = spare || W::is_spare(code);
  };
  (take(fields), ...);
  if (spare) [[unlikely]]
    return get_singly(from, s, fields...);
  from.in.advance(total);
}

template <class S, class V>
constexpr void clear(S& s, const Field<S, V>& f) {
  s.*f.member = V{};
}
template <class S, class Count, class E, std::size_t N>
constexpr void clear(S& s, const Repeat<S, Count, E, N>& r) {
  (s.*r.elements).clear();
}
template <class S, class V, class... I>
constexpr void clear(S& s, const WhenAround<V, I...>& w) {
  each(w.items, [&](const auto& i) { clear(s, i); });
}
template <class S, class V, class... I>
constexpr void clear(S& s, const When<S, V, I...>& w) {
  each(w.items, [&](const auto& i) { clear(s, i); });
}

template <std::size_t From, class T, class Up>
void read_structure(Source& from, Scope<T, Up> scope);

/// Items [From, end): fields in runs, the others one by one.
template <std::size_t From = 0, class S, class Up, class... I>
[[gnu::always_inline]] inline void read_items(Source& from, Scope<S, Up>& scope, const Items<I...>& items);
template <class S, class Up, class... I>
[[gnu::always_inline]] inline void read_if(bool present, Source& from, Scope<S, Up>& scope, const Items<I...>& items) {
  if (present)
    read_items(from, scope, items);
  else
    each(items, [&](const auto& i) { clear(scope.self, i); });
}
template <class S, class Up, class V, class... I>
[[gnu::always_inline]] inline void read(Source& from, Scope<S, Up>& scope, const When<S, V, I...>& w) {
  read_if(w.test((scope.self.*w.condition).raw), from, scope, w.items);
}
template <class S, class Up, class V, class... I>
[[gnu::always_inline]] inline void read(Source& from, Scope<S, Up>& scope, const WhenAround<V, I...>& w) {
  read_if(w.test(around<V>(scope)), from, scope, w.items);
}
template <class S, class Up, class Count, class E, std::size_t N>
[[gnu::always_inline]] inline void read(Source& from, Scope<S, Up>& scope, const Repeat<S, Count, E, N>& r) {
  static_assert(all_ones(Count::bits) <= N, "a counter cannot exceed the capacity");
  auto& elements = scope.self.*r.elements;
  elements.clear();
  const std::uint64_t n = from.in.read(Count::bits, Count::name);
  for (std::uint64_t i = 0; i < n && !from.in.faulty(); ++i)
    read_structure<0>(from, Scope<E, Scope<S, Up>>{*elements.grow(), &scope});
}
template <class S, class Up>
void read(Source& from, Scope<S, Up>& scope, const RestOfPacket<S>& r) {
  Opaque& rest = scope.self.*r.member;
  std::size_t left = from.in.left();
  rest.bits = static_cast<std::uint16_t>(left);
  rest.bytes.clear();
  for (; left > 0; left -= left < 8 ? left : 8) {
    const unsigned bits = left < 8 ? static_cast<unsigned>(left) : 8;
    // L_PACKET is at most 8191 bits, the capacity is 1024 bytes.
    (void)rest.bytes.push_back(static_cast<std::uint8_t>(from.in.read(bits, r.name) << (8 - bits)));
  }
}

template <class S, class Up, class V>
[[gnu::always_inline]] inline void read(Source& from, Scope<S, Up>& scope, const Field<S, V>& f) {
  get(from, scope.self.*f.member);
}
template <std::size_t From, class S, class Up, class... I>
[[gnu::always_inline]] inline void read_items(Source& from, Scope<S, Up>& scope, const Items<I...>& items) {
  if constexpr (From < sizeof...(I)) {
    constexpr std::size_t end = end_of_run(From, static_cast<const Items<I...>*>(nullptr));
    if constexpr (end > From + 1) {
      [&]<std::size_t... K>(std::index_sequence<K...>) __attribute__((always_inline)) {
        get_run(from, scope.self, at<From + K>(items)...);
      }
      (std::make_index_sequence<end - From>{});
      read_items<end>(from, scope, items);
    } else {
      read(from, scope, at<From>(items));
      read_items<From + 1>(from, scope, items);
    }
  }
}

/// Reads the items of T from item `From` on.
template <std::size_t From, class T, class Up>
[[gnu::always_inline]] inline void read_structure(Source& from, Scope<T, Up> scope) {
  read_items<From>(from, scope, layout_of<T>);
}

// ---- writing

template <std::size_t From, class T, class Up>
void write_structure(BitWriter& out, Scope<const T, Up> scope);

template <class S, class Up, class V>
void write(BitWriter& out, Scope<const S, Up>& scope, const Field<S, V>& f) {
  out.write((scope.self.*f.member).raw, V::bits);
}
template <class S, class Up, class V, class... I>
void write(BitWriter& out, Scope<const S, Up>& scope, const When<S, V, I...>& w) {
  if (w.test((scope.self.*w.condition).raw)) each(w.items, [&](const auto& i) { write(out, scope, i); });
}
template <class S, class Up, class V, class... I>
void write(BitWriter& out, Scope<const S, Up>& scope, const WhenAround<V, I...>& w) {
  if (w.test(around<V>(scope))) each(w.items, [&](const auto& i) { write(out, scope, i); });
}
template <class S, class Up, class Count, class E, std::size_t N>
void write(BitWriter& out, Scope<const S, Up>& scope, const Repeat<S, Count, E, N>& r) {
  const auto& elements = scope.self.*r.elements;
  out.write(elements.size(), Count::bits);
  for (const E& e : elements) write_structure<0>(out, Scope<const E, Scope<const S, Up>>{e, &scope});
}
template <class S, class Up>
void write(BitWriter& out, Scope<const S, Up>& scope, const RestOfPacket<S>& r) {
  const Opaque& rest = scope.self.*r.member;
  if (rest.bytes.size() * 8 < rest.bits) return out.fail();
  std::size_t left = rest.bits;
  for (std::size_t i = 0; left > 0; ++i) {
    const unsigned bits = left < 8 ? static_cast<unsigned>(left) : 8;
    out.write(static_cast<std::uint64_t>(rest.bytes[i]) >> (8 - bits), bits);
    left -= bits;
  }
}
template <std::size_t From, class T, class Up>
void write_structure(BitWriter& out, Scope<const T, Up> scope) {
  each<From>(layout_of<T>, [&](const auto& i) { write(out, scope, i); });
}

/// Packets 0 (to the train) and 255 have neither Q_DIR nor L_PACKET (7.3.3.5).
template <class P>
inline constexpr bool has_length = P::info.direction == Direction::to_track ||
                                   (P::info.NID_PACKET != 0 && P::info.NID_PACKET != 255);
template <class P>
inline constexpr bool has_direction = has_length<P>&& P::info.direction == Direction::to_train;

}  // namespace evc::lang::codec
