#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 131, RBC transition order (7.4.2.27), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet131 {
  static constexpr PacketInfo info{131,
                                   "RBC transition order",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::RBC,
                                   "7.4.2.27",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::D_RBCTR D_RBCTR;
  var::NID_C NID_C;
  var::NID_RBC NID_RBC;
  var::NID_RADIO NID_RADIO;
  var::Q_SLEEPSESSION Q_SLEEPSESSION;
  friend constexpr bool operator==(const Packet131&, const Packet131&) = default;
};

template <>
inline constexpr auto layout_of<Packet131> = layout(&Packet131::Q_DIR, &Packet131::Q_SCALE, &Packet131::D_RBCTR,
                                                    &Packet131::NID_C, &Packet131::NID_RBC, &Packet131::NID_RADIO,
                                                    &Packet131::Q_SLEEPSESSION);

}  // namespace evc::lang
