#pragma once
#include "lang/variables.h"

namespace evc::lang {

struct TrainPacket3_numbers {
  var::NID_RADIO NID_RADIO;
  friend constexpr bool operator==(const TrainPacket3_numbers&, const TrainPacket3_numbers&) = default;
};

/// Packet 3, On-board telephone numbers (6.5.1.5.25.1), system version 1.0, 1.1, 2.0, 2.1.
struct TrainPacket3 {
  static constexpr PacketInfo info{
      3,
      "On-board telephone numbers",
      Direction::to_track,
      v1_0 | v1_1 | v2_0 | v2_1,
      media::RBC | media::RIU,
      "6.5.1.5.25.1",
      "in SV 2.1 only from on-boards whose highest version is 2.0 (SRS 3.6.0 6.5.2.3.3); 2.1 on-boards send packet 2"};
  InplaceVector<TrainPacket3_numbers, 31> numbers;
  friend constexpr bool operator==(const TrainPacket3&, const TrainPacket3&) = default;
};

template <>
inline constexpr auto layout_of<TrainPacket3_numbers> = layout(&TrainPacket3_numbers::NID_RADIO);

template <>
inline constexpr auto layout_of<TrainPacket3> = layout(repeat<var::N_ITER>("numbers", &TrainPacket3::numbers));

}  // namespace evc::lang
