#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 4, Error reporting (7.4.3.4), system version 2.0, 2.1.
struct TrainPacket4 {
  static constexpr PacketInfo info{4, "Error reporting", Direction::to_track, v2_0 | v2_1, media::RBC, "7.4.3.4", ""};
  var::M_ERROR M_ERROR;
  friend constexpr bool operator==(const TrainPacket4&, const TrainPacket4&) = default;
};

template <>
inline constexpr auto layout_of<TrainPacket4> = layout(&TrainPacket4::M_ERROR);

/// Packet 4, Error reporting (7.4.3.4), system version 2.2, 2.3, 3.0.
struct TrainPacket4_v2_2 {
  static constexpr PacketInfo info{4, "Error reporting", Direction::to_track, v2_2 | v2_3 | v3_0, media::RBC, "7.4.3.4",
                                   ""};
  var::M_ERROR_V2_2 M_ERROR;
  friend constexpr bool operator==(const TrainPacket4_v2_2&, const TrainPacket4_v2_2&) = default;
};

template <>
inline constexpr auto layout_of<TrainPacket4_v2_2> = layout(named("M_ERROR", &TrainPacket4_v2_2::M_ERROR));

/// Packet 4, Error reporting (7.4.3.4), system version 1.0, 1.1.
struct TrainPacket4_v1_0 {
  static constexpr PacketInfo info{4, "Error reporting", Direction::to_track, v1_0 | v1_1, media::RBC, "7.4.3.4", ""};
  var::M_ERROR_V1 M_ERROR;
  friend constexpr bool operator==(const TrainPacket4_v1_0&, const TrainPacket4_v1_0&) = default;
};

template <>
inline constexpr auto layout_of<TrainPacket4_v1_0> = layout(named("M_ERROR", &TrainPacket4_v1_0::M_ERROR));

}  // namespace evc::lang
