#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 141, Default gradient for TSR (7.4.2.37), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet141 {
  static constexpr PacketInfo info{141,
                                   "Default gradient for TSR",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise,
                                   "7.4.2.37",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_GDIR Q_GDIR;
  var::G_TSR G_TSR;
  friend constexpr bool operator==(const Packet141&, const Packet141&) = default;
};

template <>
inline constexpr auto layout_of<Packet141> = layout(&Packet141::Q_DIR, &Packet141::Q_GDIR, &Packet141::G_TSR);

}  // namespace evc::lang
