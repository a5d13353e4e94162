#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 200, Virtual balise cover marker (6.5.1.5.21), system version 1.1.
struct Packet200 {
  static constexpr PacketInfo info{200,
                                   "Virtual balise cover marker",
                                   Direction::to_train,
                                   v1_1,
                                   media::balise,
                                   "6.5.1.5.21",
                                   "29 bits; first packet of an X=1 telegram"};
  var::Q_DIR Q_DIR;
  var::NID_VBCMK NID_VBCMK;
  friend constexpr bool operator==(const Packet200&, const Packet200&) = default;
};

template <>
inline constexpr auto layout_of<Packet200> = layout(&Packet200::Q_DIR, &Packet200::NID_VBCMK);

}  // namespace evc::lang
