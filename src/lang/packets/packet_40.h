#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 40, Permitted current change (7.4.2.8.1), system version 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet40 {
  static constexpr PacketInfo info{40,
                                   "Permitted current change",
                                   Direction::to_train,
                                   v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "7.4.2.8.1",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::D_CURRENT D_CURRENT;
  var::M_CURRENT M_CURRENT;
  friend constexpr bool operator==(const Packet40&, const Packet40&) = default;
};

template <>
inline constexpr auto layout_of<Packet40> = layout(&Packet40::Q_DIR, &Packet40::Q_SCALE, &Packet40::D_CURRENT,
                                                   &Packet40::M_CURRENT);

}  // namespace evc::lang
