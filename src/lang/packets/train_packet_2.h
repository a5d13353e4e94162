#pragma once
#include "lang/variables.h"

namespace evc::lang {

struct TrainPacket2_versions {
  var::M_VERSION M_VERSION;
  friend constexpr bool operator==(const TrainPacket2_versions&, const TrainPacket2_versions&) = default;
};

/// Packet 2, Supported system versions (7.4.3.3), system version 2.1, 2.2, 2.3, 3.0.
struct TrainPacket2 {
  static constexpr PacketInfo info{2,
                                   "Supported system versions",
                                   Direction::to_track,
                                   v2_1 | v2_2 | v2_3 | v3_0,
                                   media::RBC | media::RIU,
                                   "7.4.3.3",
                                   ""};
  var::M_VERSION M_VERSION;
  InplaceVector<TrainPacket2_versions, 31> versions;
  /// The element before the counter, in the form of the others.
  constexpr TrainPacket2_versions first_versions() const { return {M_VERSION}; }
  friend constexpr bool operator==(const TrainPacket2&, const TrainPacket2&) = default;
};

template <>
inline constexpr auto layout_of<TrainPacket2_versions> = layout(&TrainPacket2_versions::M_VERSION);

template <>
inline constexpr auto layout_of<TrainPacket2> = layout(&TrainPacket2::M_VERSION,
                                                       repeat<var::N_ITER>("versions", &TrainPacket2::versions));

}  // namespace evc::lang
