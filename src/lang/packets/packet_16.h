#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 16, Repositioning information (7.4.2.5), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet16 {
  static constexpr PacketInfo info{16,
                                   "Repositioning information",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise,
                                   "7.4.2.5",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::L_SECTION L_SECTION;
  friend constexpr bool operator==(const Packet16&, const Packet16&) = default;
};

template <>
inline constexpr auto layout_of<Packet16> = layout(&Packet16::Q_DIR, &Packet16::Q_SCALE, &Packet16::L_SECTION);

}  // namespace evc::lang
