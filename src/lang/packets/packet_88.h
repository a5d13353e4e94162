#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 88, Level crossing information (7.4.2.26.1), system version 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet88 {
  static constexpr PacketInfo info{88,
                                   "Level crossing information",
                                   Direction::to_train,
                                   v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "7.4.2.26.1",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::NID_LX NID_LX;
  var::D_LX D_LX;
  var::L_LX L_LX;
  var::Q_LXSTATUS Q_LXSTATUS;
  var::V_LX V_LX;          ///< only if Q_LXSTATUS == 1
  var::Q_STOPLX Q_STOPLX;  ///< only if Q_LXSTATUS == 1
  var::L_STOPLX L_STOPLX;  ///< only if Q_LXSTATUS == 1 && Q_STOPLX == 1
  friend constexpr bool operator==(const Packet88&, const Packet88&) = default;
};

template <>
inline constexpr auto layout_of<Packet88> = layout(&Packet88::Q_DIR, &Packet88::Q_SCALE, &Packet88::NID_LX,
                                                   &Packet88::D_LX, &Packet88::L_LX, &Packet88::Q_LXSTATUS,
                                                   when(&Packet88::Q_LXSTATUS, is(1), &Packet88::V_LX,
                                                        &Packet88::Q_STOPLX,
                                                        when(&Packet88::Q_STOPLX, is(1), &Packet88::L_STOPLX)));

}  // namespace evc::lang
