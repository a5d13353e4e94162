#pragma once
#include <optional>
#include <type_traits>

#include "base/units.h"
#include "lang/variables.h"

// Raw codes as quantities. Each is one correctly rounded operation on the raw number. Where a
// variable has special codes (infinite, unknown, "national value"), the result is optional and
// empty for those; otherwise it is the quantity itself.
namespace evc::lang {

namespace detail {
template <class V>
inline constexpr bool always = V::max == all_ones(V::bits);
template <class V, class Q>
using Value = std::conditional_t<always<V>, Q, std::optional<Q>>;
}  // namespace detail

/// A distance or length in the scale of its packet: 10 cm, 1 m or 10 m (7.5.1.80). Needs a Q_SCALE of
/// 0 to 2, which decode() has checked.
template <class V>
constexpr detail::Value<V, Distance> metres(var::Q_SCALE Q_SCALE, V d) {
  static_assert(V::bits == 15, "lengths in metres and times have their own functions");
  if (!detail::always<V> && d.raw > V::max) return {};
  const double raw = d.raw;
  return Distance{Q_SCALE.raw == 0 ? raw / 10.0 : Q_SCALE.raw == 1 ? raw : raw * 10.0};
}
/// D_REF is signed (messages 15, 33, 34).
constexpr Distance metres(var::Q_SCALE Q_SCALE, var::D_REF d) {
  const double raw = static_cast<std::int16_t>(d.raw);
  return Distance{Q_SCALE.raw == 0 ? raw / 10.0 : Q_SCALE.raw == 1 ? raw : raw * 10.0};
}
/// L_TRAIN, L_TRAININT, Q_LOCACC, Q_NVLOCACC: whole metres.
template <class V>
constexpr Distance metres(V l) {
  static_assert(std::is_same_v<V, var::L_TRAIN> || std::is_same_v<V, var::L_TRAININT> ||
                std::is_same_v<V, var::Q_LOCACC> || std::is_same_v<V, var::Q_NVLOCACC>);
  return Distance{static_cast<double>(l.raw)};
}

/// V_...: steps of 5 km/h; empty for special and spare codes (V_STATIC 127, V_MAMODE 127, V_RELEASEDP 126 and 127).
template <class V>
constexpr std::optional<Speed> speed(V v) {
  static_assert(V::bits == 7 && V::max == 120, "a speed");
  if (v.raw > V::max) return {};
  return Speed{static_cast<double>(v.raw * 5u) / 3.6};
}

/// T_... in whole seconds; T_TRAIN in 10 ms.
template <class V>
constexpr detail::Value<V, Duration> seconds(V t) {
  static_assert(V::bits == 8 || V::bits == 10, "a time in seconds");
  if (!detail::always<V> && t.raw > V::max) return {};
  return Duration{static_cast<double>(t.raw)};
}
constexpr std::optional<Duration> seconds(var::T_TRAIN t) {
  if (t.raw > var::T_TRAIN::max) return {};
  return Duration{static_cast<double>(t.raw) / 100.0};
}

/// A_...: steps of 0.05 m/s2.
template <class V>
constexpr detail::Value<V, Acceleration> acceleration(V a) {
  static_assert(V::bits == 6);
  if (!detail::always<V> && a.raw > V::max) return {};
  return Acceleration{static_cast<double>(a.raw) / 20.0};
}

/// G_A with Q_GDIR as a slope, uphill positive (0.001 = 1 per mille); empty at the end of the profile.
constexpr std::optional<double> slope(var::Q_GDIR Q_GDIR, var::G_A G_A) {
  if (G_A.raw > var::G_A::max) return {};
  const double permille = G_A.raw;
  return (Q_GDIR.raw == 1 ? permille : -permille) / 1000.0;
}
constexpr double slope(var::Q_GDIR Q_GDIR, var::G_TSR G) { return (Q_GDIR.raw == 1 ? 1.0 : -1.0) * G.raw / 1000.0; }

/// M_NVKVINT steps of 0.02; M_NVKRINT, M_NVKTINT, M_NVAVADH steps of 0.05.
constexpr double factor(var::M_NVKVINT k) { return k.raw / 50.0; }
constexpr double factor(var::M_NVKRINT k) { return k.raw / 20.0; }
constexpr double factor(var::M_NVKTINT k) { return k.raw / 20.0; }
constexpr double factor(var::M_NVAVADH k) { return k.raw / 20.0; }
/// L_NVKRINT: train length from which a correction factor applies (7.5.1.54.1).
constexpr Distance metres(var::L_NVKRINT l) {
  if (l.raw <= 4) return Distance{25.0 * l.raw};
  if (l.raw <= 6) return Distance{150.0 + 50.0 * (l.raw - 5)};
  return Distance{300.0 + 100.0 * (l.raw - 7)};
}

/// NID_LRBG, NID_PRVLRBG, NID_LTRBG: NID_C in the upper 10 bits, NID_BG in the lower 14.
struct GroupIdentity {
  std::uint16_t NID_C = 0;
  std::uint16_t NID_BG = 0;
  friend constexpr bool operator==(const GroupIdentity&, const GroupIdentity&) = default;
};
template <class V>
constexpr std::optional<GroupIdentity> group(V nid) {
  static_assert(V::bits == 24);
  if (nid.raw == 0xFFFFFF) return {};
  return GroupIdentity{static_cast<std::uint16_t>(nid.raw >> 14), static_cast<std::uint16_t>(nid.raw & 0x3FFF)};
}
constexpr std::uint32_t nid_lrbg(GroupIdentity g) { return (std::uint32_t{g.NID_C} << 14) | g.NID_BG; }

}  // namespace evc::lang
