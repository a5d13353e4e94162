#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 254, Default balise/loop/RIU information (7.4.2.38), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet254 {
  static constexpr PacketInfo info{254,
                                   "Default balise/loop/RIU information",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::loop | media::RIU,
                                   "7.4.2.38",
                                   "header only"};
  var::Q_DIR Q_DIR;
  friend constexpr bool operator==(const Packet254&, const Packet254&) = default;
};

template <>
inline constexpr auto layout_of<Packet254> = layout(&Packet254::Q_DIR);

}  // namespace evc::lang
