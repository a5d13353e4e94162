#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 137, Stop if in SR (7.4.2.33), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet137 {
  static constexpr PacketInfo info{137,
                                   "Stop if in SR",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise,
                                   "7.4.2.33",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SRSTOP Q_SRSTOP;
  friend constexpr bool operator==(const Packet137&, const Packet137&) = default;
};

template <>
inline constexpr auto layout_of<Packet137> = layout(&Packet137::Q_DIR, &Packet137::Q_SRSTOP);

}  // namespace evc::lang
