#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 132, Danger for shunting (7.4.2.28), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet132 {
  static constexpr PacketInfo info{132,
                                   "Danger for shunting",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise,
                                   "7.4.2.28",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_ASPECT Q_ASPECT;
  friend constexpr bool operator==(const Packet132&, const Packet132&) = default;
};

template <>
inline constexpr auto layout_of<Packet132> = layout(&Packet132::Q_DIR, &Packet132::Q_ASPECT);

}  // namespace evc::lang
