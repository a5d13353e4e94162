#pragma once
#include <optional>
#include <tuple>

#include "terms/packet_numbers.h"
#include "terms/stored.h"
#include "track/description.h"

// Data stored as a list of areas, replaced from a place on by a new packet (3.7.3.1 c, d, f, g; 3.7.3.2).
namespace evc::track {

/// One such list: a new packet of this kind needs its conversion (from_packets) and a row below. Storing, cutting at
/// the end of an MA, deletion of passed areas and 4.10 follow from the row.
template <class T, std::size_t N>
struct AreaList {
  std::uint8_t packet;
  std::optional<Fresh<T>> Contents::*fresh;
  InplaceVector<T, N> Description::*kept;
  /// The row of 4.10.1.3 that resets the whole list to its initial state; none: forget.cpp has a row of its own.
  std::optional<evc::Stored> row;
  /// It restricts the train: where there is no room for it, authority and track description end (3.7.2.3). A change
  /// makes speed and distance monitoring compute again.
  bool restricts;
  /// Deleting it deletes track description: an MA request reason (3.8.2.5).
  bool track_description;
};
template <class T, std::size_t N>
AreaList(std::uint8_t, std::optional<Fresh<T>> Contents::*, InplaceVector<T, N> Description::*,
         std::optional<evc::Stored>, bool, bool) -> AreaList<T, N>;

// clang-format off
/// The lists of 3.11, in the order in which they are stored.
inline constexpr std::tuple kSpeedAreas{
    AreaList{packet::axle_load_speed_profile,    &Contents::asp, &Description::asp, evc::Stored::asp, true, true},
    AreaList{packet::permitted_braking_distance, &Contents::pbd, &Description::pbd, evc::Stored::permitted_braking_distance, true, true},
};
/// The lists of 3.12.
inline constexpr std::tuple kConditionAreas{
    AreaList{packet::track_condition,   &Contents::conditions, &Description::conditions, {}, true, true},
    AreaList{packet::big_metal_masses,  &Contents::big_metal,  &Description::big_metal, evc::Stored::track_condition_bmm, false, true},
    AreaList{packet::station_platforms, &Contents::platforms,  &Description::platforms, evc::Stored::track_conditions_general, false, false},
};
// clang-format on

/// Calls `f` with each row.
template <class Lists, class F>
constexpr void each_list(const Lists& lists, F f) {
  std::apply([&](const auto&... list) { (f(list), ...); }, lists);
}
template <class F>
constexpr void each_list(F f) {
  each_list(kSpeedAreas, f);
  each_list(kConditionAreas, f);
}

}  // namespace evc::track
