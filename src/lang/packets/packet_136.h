#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 136, Infill location reference (7.4.2.32), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet136 {
  static constexpr PacketInfo info{136,
                                   "Infill location reference",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::loop | media::RIU,
                                   "7.4.2.32",
                                   "following packets refer to this group"};
  var::Q_DIR Q_DIR;
  var::Q_NEWCOUNTRY Q_NEWCOUNTRY;
  var::NID_C NID_C;  ///< only if Q_NEWCOUNTRY == 1
  var::NID_BG NID_BG;
  friend constexpr bool operator==(const Packet136&, const Packet136&) = default;
};

template <>
inline constexpr auto layout_of<Packet136> = layout(&Packet136::Q_DIR, &Packet136::Q_NEWCOUNTRY,
                                                    when(&Packet136::Q_NEWCOUNTRY, is(1), &Packet136::NID_C),
                                                    &Packet136::NID_BG);

}  // namespace evc::lang
