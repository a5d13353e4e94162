#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 0, Virtual balise cover marker (7.4.2.0), system version 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet0 {
  static constexpr PacketInfo info{0,
                                   "Virtual balise cover marker",
                                   Direction::to_train,
                                   v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise,
                                   "7.4.2.0",
                                   "no Q_DIR, no L_PACKET; 14 bits; must be first packet of telegram"};
  var::NID_VBCMK NID_VBCMK;
  friend constexpr bool operator==(const Packet0&, const Packet0&) = default;
};

template <>
inline constexpr auto layout_of<Packet0> = layout(&Packet0::NID_VBCMK);

}  // namespace evc::lang
