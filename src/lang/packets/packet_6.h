#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 6, Virtual balise cover order (7.4.2.2.1), system version 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet6 {
  static constexpr PacketInfo info{6,
                                   "Virtual balise cover order",
                                   Direction::to_train,
                                   v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise,
                                   "7.4.2.2.1",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_VBCO Q_VBCO;
  var::NID_VBCMK NID_VBCMK;
  var::NID_C NID_C;
  var::T_VBC T_VBC;  ///< only if Q_VBCO == 1
  friend constexpr bool operator==(const Packet6&, const Packet6&) = default;
};

template <>
inline constexpr auto layout_of<Packet6> = layout(&Packet6::Q_DIR, &Packet6::Q_VBCO, &Packet6::NID_VBCMK,
                                                  &Packet6::NID_C, when(&Packet6::Q_VBCO, is(1), &Packet6::T_VBC));

}  // namespace evc::lang
