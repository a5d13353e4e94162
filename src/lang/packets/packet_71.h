#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 71, Adhesion factor (7.4.2.22), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet71 {
  static constexpr PacketInfo info{71,
                                   "Adhesion factor",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "7.4.2.22",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::D_ADHESION D_ADHESION;
  var::L_ADHESION L_ADHESION;
  var::M_ADHESION M_ADHESION;
  friend constexpr bool operator==(const Packet71&, const Packet71&) = default;
};

template <>
inline constexpr auto layout_of<Packet71> = layout(&Packet71::Q_DIR, &Packet71::Q_SCALE, &Packet71::D_ADHESION,
                                                   &Packet71::L_ADHESION, &Packet71::M_ADHESION);

}  // namespace evc::lang
