#pragma once
#include "lang/variables.h"

namespace evc::lang {

struct Packet67_areas {
  var::D_TRACKCOND D_TRACKCOND;
  var::L_TRACKCOND L_TRACKCOND;
  friend constexpr bool operator==(const Packet67_areas&, const Packet67_areas&) = default;
};

/// Packet 67, Big metal masses (7.4.2.19), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet67 {
  static constexpr PacketInfo info{67,
                                   "Big metal masses",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::RBC,
                                   "7.4.2.19",
                                   "from the RBC: 3.0, and in message 4 of 2.3"};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::D_TRACKCOND D_TRACKCOND;
  var::L_TRACKCOND L_TRACKCOND;
  InplaceVector<Packet67_areas, 31> areas;
  /// The element before the counter, in the form of the others.
  constexpr Packet67_areas first_areas() const { return {D_TRACKCOND, L_TRACKCOND}; }
  friend constexpr bool operator==(const Packet67&, const Packet67&) = default;
};

template <>
inline constexpr auto layout_of<Packet67_areas> = layout(&Packet67_areas::D_TRACKCOND, &Packet67_areas::L_TRACKCOND);

template <>
inline constexpr auto layout_of<Packet67> = layout(&Packet67::Q_DIR, &Packet67::Q_SCALE, &Packet67::D_TRACKCOND,
                                                   &Packet67::L_TRACKCOND,
                                                   repeat<var::N_ITER>("areas", &Packet67::areas));

}  // namespace evc::lang
