#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 2, System version order (7.4.2.1), system version 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet2 {
  static constexpr PacketInfo info{
      2, "System version order", Direction::to_train, v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, media::balise, "7.4.2.1",
      ""};
  var::Q_DIR Q_DIR;
  var::M_VERSION M_VERSION;
  friend constexpr bool operator==(const Packet2&, const Packet2&) = default;
};

template <>
inline constexpr auto layout_of<Packet2> = layout(&Packet2::Q_DIR, &Packet2::M_VERSION);

}  // namespace evc::lang
