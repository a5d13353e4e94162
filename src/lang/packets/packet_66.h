#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 66, TSR revocation (7.4.2.18), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet66 {
  static constexpr PacketInfo info{66,
                                   "TSR revocation",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "7.4.2.18",
                                   ""};
  var::Q_DIR Q_DIR;
  var::NID_TSR NID_TSR;
  friend constexpr bool operator==(const Packet66&, const Packet66&) = default;
};

template <>
inline constexpr auto layout_of<Packet66> = layout(&Packet66::Q_DIR, &Packet66::NID_TSR);

}  // namespace evc::lang
