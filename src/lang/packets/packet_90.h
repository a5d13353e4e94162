#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 90, Track ahead free up to L2/3 border (7.4.2.26.2), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet90 {
  static constexpr PacketInfo info{90,
                                   "Track ahead free up to L2/3 border",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise,
                                   "7.4.2.26.2",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_NEWCOUNTRY Q_NEWCOUNTRY;
  var::NID_C NID_C;  ///< only if Q_NEWCOUNTRY == 1
  var::NID_BG NID_BG;
  friend constexpr bool operator==(const Packet90&, const Packet90&) = default;
};

template <>
inline constexpr auto layout_of<Packet90> = layout(&Packet90::Q_DIR, &Packet90::Q_NEWCOUNTRY,
                                                   when(&Packet90::Q_NEWCOUNTRY, is(1), &Packet90::NID_C),
                                                   &Packet90::NID_BG);

}  // namespace evc::lang
