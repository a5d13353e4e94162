#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 138, Reversing area (7.4.2.34), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet138 {
  static constexpr PacketInfo info{138,
                                   "Reversing area",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "7.4.2.34",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::D_STARTREVERSE D_STARTREVERSE;
  var::L_REVERSEAREA L_REVERSEAREA;
  friend constexpr bool operator==(const Packet138&, const Packet138&) = default;
};

template <>
inline constexpr auto layout_of<Packet138> = layout(&Packet138::Q_DIR, &Packet138::Q_SCALE, &Packet138::D_STARTREVERSE,
                                                    &Packet138::L_REVERSEAREA);

}  // namespace evc::lang
