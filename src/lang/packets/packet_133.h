#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 133, Radio infill area (7.4.2.29), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet133 {
  static constexpr PacketInfo info{133,
                                   "Radio infill area",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise,
                                   "7.4.2.29",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::Q_RIU Q_RIU;
  var::NID_C NID_C_RIU;
  var::NID_RIU NID_RIU;
  var::NID_RADIO NID_RADIO;
  var::D_INFILL D_INFILL;
  var::NID_C NID_C;
  var::NID_BG NID_BG;
  friend constexpr bool operator==(const Packet133&, const Packet133&) = default;
};

template <>
inline constexpr auto layout_of<Packet133> = layout(&Packet133::Q_DIR, &Packet133::Q_SCALE, &Packet133::Q_RIU,
                                                    named("NID_C_RIU", &Packet133::NID_C_RIU), &Packet133::NID_RIU,
                                                    &Packet133::NID_RADIO, &Packet133::D_INFILL, &Packet133::NID_C,
                                                    &Packet133::NID_BG);

}  // namespace evc::lang
