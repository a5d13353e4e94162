#pragma once
#include "lang/variables.h"

namespace evc::lang {

struct Packet58_locations {
  var::D_LOC D_LOC;
  var::Q_LGTLOC Q_LGTLOC;
  friend constexpr bool operator==(const Packet58_locations&, const Packet58_locations&) = default;
};

/// Packet 58, Position report parameters (7.4.2.15), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet58 {
  static constexpr PacketInfo info{58,
                                   "Position report parameters",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::RBC,
                                   "7.4.2.15",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::T_CYCLOC T_CYCLOC;
  var::D_CYCLOC D_CYCLOC;
  var::M_LOC M_LOC;
  InplaceVector<Packet58_locations, 31> locations;
  friend constexpr bool operator==(const Packet58&, const Packet58&) = default;
};

template <>
inline constexpr auto layout_of<Packet58_locations> = layout(&Packet58_locations::D_LOC, &Packet58_locations::Q_LGTLOC);

template <>
inline constexpr auto layout_of<Packet58> = layout(&Packet58::Q_DIR, &Packet58::Q_SCALE, &Packet58::T_CYCLOC,
                                                   &Packet58::D_CYCLOC, &Packet58::M_LOC,
                                                   repeat<var::N_ITER>("locations", &Packet58::locations));

}  // namespace evc::lang
