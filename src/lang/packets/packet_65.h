#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 65, Temporary speed restriction (7.4.2.17), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet65 {
  static constexpr PacketInfo info{65,
                                   "Temporary speed restriction",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "7.4.2.17",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::NID_TSR NID_TSR;
  var::D_TSR D_TSR;
  var::L_TSR L_TSR;
  var::Q_FRONT Q_FRONT;
  var::V_TSR V_TSR;
  friend constexpr bool operator==(const Packet65&, const Packet65&) = default;
};

template <>
inline constexpr auto layout_of<Packet65> = layout(&Packet65::Q_DIR, &Packet65::Q_SCALE, &Packet65::NID_TSR,
                                                   &Packet65::D_TSR, &Packet65::L_TSR, &Packet65::Q_FRONT,
                                                   &Packet65::V_TSR);

}  // namespace evc::lang
