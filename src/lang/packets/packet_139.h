#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 139, Reversing supervision (7.4.2.35), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet139 {
  static constexpr PacketInfo info{139,
                                   "Reversing supervision",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "7.4.2.35",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::D_REVERSE D_REVERSE;
  var::V_REVERSE V_REVERSE;
  friend constexpr bool operator==(const Packet139&, const Packet139&) = default;
};

template <>
inline constexpr auto layout_of<Packet139> = layout(&Packet139::Q_DIR, &Packet139::Q_SCALE, &Packet139::D_REVERSE,
                                                    &Packet139::V_REVERSE);

}  // namespace evc::lang
