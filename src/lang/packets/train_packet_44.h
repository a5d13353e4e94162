#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 44, External application data (7.4.3.6), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct TrainPacket44 {
  static constexpr PacketInfo info{44,
                                   "External application data",
                                   Direction::to_track,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::RBC | media::RIU,
                                   "7.4.3.6",
                                   "no NID_NTC here, unlike the track-to-train packet"};
  var::NID_XUSER NID_XUSER;
  Opaque OTHER_DATA;
  friend constexpr bool operator==(const TrainPacket44&, const TrainPacket44&) = default;
};

template <>
inline constexpr auto layout_of<TrainPacket44> = layout(&TrainPacket44::NID_XUSER,
                                                        rest_of_packet("OTHER_DATA", &TrainPacket44::OTHER_DATA));

}  // namespace evc::lang
