#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 134, EOLM (loop announcement) (7.4.2.30), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet134 {
  static constexpr PacketInfo info{134,
                                   "EOLM (loop announcement)",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise,
                                   "7.4.2.30",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::NID_LOOP NID_LOOP;
  var::D_LOOP D_LOOP;
  var::L_LOOP L_LOOP;
  var::Q_LOOPDIR Q_LOOPDIR;
  var::Q_SSCODE Q_SSCODE;
  friend constexpr bool operator==(const Packet134&, const Packet134&) = default;
};

template <>
inline constexpr auto layout_of<Packet134> = layout(&Packet134::Q_DIR, &Packet134::Q_SCALE, &Packet134::NID_LOOP,
                                                    &Packet134::D_LOOP, &Packet134::L_LOOP, &Packet134::Q_LOOPDIR,
                                                    &Packet134::Q_SSCODE);

}  // namespace evc::lang
