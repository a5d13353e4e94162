#include "lang/layouts.h"

#include <array>

#include "lang/messages.h"
#include "lang/packets.h"
#include "terms/packet_numbers.h"

namespace evc::lang {
namespace {

template <class T>
constexpr auto steps_of_structure();
template <class T>
inline constexpr auto steps_of = steps_of_structure<T>();

template <class I>
inline constexpr std::size_t steps_in = 1;
template <class S, class V, class... I>
inline constexpr std::size_t steps_in<When<S, V, I...>> = 1 + (steps_in<I> + ... + 0);
template <class V, class... I>
inline constexpr std::size_t steps_in<WhenAround<V, I...>> = 1 + (steps_in<I> + ... + 0);
template <class... I>
inline constexpr std::size_t steps_in<Items<I...>> = (steps_in<I> + ... + 0);

/// Finds the step that reads `member`; `at` counts the steps passed.
template <class S, class W, class M>
constexpr void seek(const Field<S, W>& f, M member, std::size_t& at, std::size_t& found) {
  if constexpr (std::is_same_v<M, W S::*>)
    if (f.member == member) found = at;
  ++at;
}
template <class I, class M>
constexpr void seek(const I&, M, std::size_t& at, std::size_t&) {
  ++at;
}
template <class... I, class M>
constexpr void seek(const Items<I...>& items, M member, std::size_t& at, std::size_t& found) {
  each(items, [&](const auto& item) {
    if constexpr (requires { item.items; }) {
      ++at;
      seek(item.items, member, at, found);
    } else {
      seek(item, member, at, found);
    }
  });
}

template <class S, std::size_t N>
struct Writer {
  std::array<Step, N> steps{};
  std::size_t n = 0;

  template <class V>
  constexpr void add(const Field<S, V>& f) {
    Step& s = steps[n++];
    s.bits = static_cast<std::uint8_t>(V::bits);
    s.name = f.name;
    s.variable = V::name;
    if constexpr (V::has_spare) s.is_spare = &V::is_spare;
  }
  template <class V, class... I>
  constexpr void add(const When<S, V, I...>& w) {
    std::size_t at = 0;
    std::size_t found = 255;
    seek(layout_of<S>, w.condition, at, found);
    Step& s = steps[n++];
    s.kind = Step::Kind::when;
    s.variable = V::name;
    s.condition = static_cast<std::uint8_t>(found);
    s.count = static_cast<std::uint8_t>(steps_in<Items<I...>>);
    s.test = w.test;
    add_all(w.items);
  }
  template <class V, class... I>
  constexpr void add(const WhenAround<V, I...>& w) {
    Step& s = steps[n++];
    s.kind = Step::Kind::when_around;
    s.variable = V::name;
    s.count = static_cast<std::uint8_t>(steps_in<Items<I...>>);
    s.test = w.test;
    add_all(w.items);
  }
  template <class Count, class E, std::size_t Capacity>
  constexpr void add(const Repeat<S, Count, E, Capacity>& r) {
    Step& s = steps[n++];
    s.kind = Step::Kind::repeat;
    s.bits = static_cast<std::uint8_t>(Count::bits);
    s.capacity = static_cast<std::uint16_t>(Capacity);
    s.name = r.name;
    s.variable = Count::name;
    s.counter = r.count_name;
    s.body = steps_of<E>.data();
    s.body_size = static_cast<std::uint8_t>(steps_of<E>.size());
  }
  constexpr void add(const RestOfPacket<S>& r) {
    Step& s = steps[n++];
    s.kind = Step::Kind::rest;
    s.name = r.name;
  }
  template <class... I>
  constexpr void add_all(const Items<I...>& items) {
    each(items, [&](const auto& i) { add(i); });
  }
};

template <class T>
constexpr auto steps_of_structure() {
  Writer<T, steps_in<std::remove_cvref_t<decltype(layout_of<T>)>>> writer;
  writer.add_all(layout_of<T>);
  return writer.steps;
}

template <class P>
constexpr PacketLayout packet_layout(const char* type) {
  const bool to_track = P::info.direction == Direction::to_track;
  const bool has_length = to_track || (P::info.NID_PACKET != packet::virtual_balise_cover_marker &&
                                       P::info.NID_PACKET != packet::end_of_information);
  return {&P::info, type, has_length, has_length && !to_track, steps_of<P>};
}

#define EVC_ROW(P) packet_layout<P>(#P),
constexpr PacketLayout all_packets[]{EVC_PACKETS_TO_TRAIN(EVC_ROW) EVC_PACKETS_TO_TRACK(EVC_ROW)};
#undef EVC_ROW
#define EVC_ROW(M) MessageLayout{&M::info, #M, steps_of<M>},
constexpr MessageLayout all_messages[]{EVC_MESSAGES_TO_TRAIN(EVC_ROW) EVC_MESSAGES_TO_TRACK(EVC_ROW)};
#undef EVC_ROW

/// One more than the index of each number in `all_packets`, per direction and version.
using LayoutIndex = std::array<std::array<std::uint8_t, 256>, 2 * kVersions>;
constexpr LayoutIndex make_index() {
  LayoutIndex index{};
  for (std::size_t i = 0; i < std::size(all_packets); ++i)
    for (unsigned v = 0; v < kVersions; ++v)
      if ((all_packets[i].info->versions & (1u << v)) != 0)
        index[(all_packets[i].info->direction == Direction::to_track ? kVersions : 0u) + v]
             [all_packets[i].info->NID_PACKET] = static_cast<std::uint8_t>(i + 1);
  return index;
}
constexpr LayoutIndex packet_index = make_index();

}  // namespace

std::span<const PacketLayout> packet_layouts() { return all_packets; }
std::span<const MessageLayout> message_layouts() { return all_messages; }

const PacketLayout* find_packet_layout(Direction direction, Versions version, std::uint8_t nid) {
  if (version == 0) return nullptr;
  const unsigned v = index_of(version);
  const std::uint8_t i = packet_index[(direction == Direction::to_track ? kVersions : 0u) + v][nid];
  return i == 0 ? nullptr : &all_packets[i - 1u];
}

const MessageLayout* find_message_layout(Direction direction, SystemVersion sv, std::uint8_t nid) {
  const Versions version = known_version(sv);
  for (const MessageLayout& m : all_messages)
    if (m.info->direction == direction && m.info->NID_MESSAGE == nid &&
        (version == 0 || (m.info->versions & version) != 0))
      return &m;
  return nullptr;
}

}  // namespace evc::lang
