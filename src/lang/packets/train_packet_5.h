#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 5, Train running number (7.4.3.4.1), system version 2.0, 2.1, 2.2, 2.3, 3.0.
struct TrainPacket5 {
  static constexpr PacketInfo info{
      5, "Train running number", Direction::to_track, v2_0 | v2_1 | v2_2 | v2_3 | v3_0, media::RBC, "7.4.3.4.1", ""};
  var::NID_OPERATIONAL NID_OPERATIONAL;
  friend constexpr bool operator==(const TrainPacket5&, const TrainPacket5&) = default;
};

template <>
inline constexpr auto layout_of<TrainPacket5> = layout(&TrainPacket5::NID_OPERATIONAL);

}  // namespace evc::lang
