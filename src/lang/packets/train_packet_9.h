#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 9, Level 2/3 transition information (7.4.3.4.2), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct TrainPacket9 {
  static constexpr PacketInfo info{9,
                                   "Level 2/3 transition information",
                                   Direction::to_track,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::RBC,
                                   "7.4.3.4.2",
                                   ""};
  var::NID_LTRBG NID_LTRBG;
  friend constexpr bool operator==(const TrainPacket9&, const TrainPacket9&) = default;
};

template <>
inline constexpr auto layout_of<TrainPacket9> = layout(&TrainPacket9::NID_LTRBG);

}  // namespace evc::lang
