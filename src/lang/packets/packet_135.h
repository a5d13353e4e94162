#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 135, Stop shunting on desk opening (7.4.2.31), system version 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet135 {
  static constexpr PacketInfo info{135,
                                   "Stop shunting on desk opening",
                                   Direction::to_train,
                                   v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise,
                                   "7.4.2.31",
                                   "header only"};
  var::Q_DIR Q_DIR;
  friend constexpr bool operator==(const Packet135&, const Packet135&) = default;
};

template <>
inline constexpr auto layout_of<Packet135> = layout(&Packet135::Q_DIR);

}  // namespace evc::lang
