#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 145, Inhibit group consistency reaction (7.4.2.37.2), system version 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet145 {
  static constexpr PacketInfo info{145,
                                   "Inhibit group consistency reaction",
                                   Direction::to_train,
                                   v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise,
                                   "7.4.2.37.2",
                                   "header only"};
  var::Q_DIR Q_DIR;
  friend constexpr bool operator==(const Packet145&, const Packet145&) = default;
};

template <>
inline constexpr auto layout_of<Packet145> = layout(&Packet145::Q_DIR);

}  // namespace evc::lang
