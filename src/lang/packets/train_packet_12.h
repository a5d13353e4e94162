#pragma once
#include "lang/packets/train_packet_11.h"

namespace evc::lang {

/// Packet 12, Default train data for SM (7.4.3.5.1), system version 2.3, 3.0.
struct TrainPacket12 {
  static constexpr PacketInfo info{
      12, "Default train data for SM", Direction::to_track, v2_3 | v3_0, media::RBC, "7.4.3.5.1", ""};
  var::NC_CDTRAIN NC_CDTRAIN;
  var::NC_TRAIN NC_TRAIN;
  var::V_MAXTRAIN V_MAXTRAIN;
  var::M_LOADINGGAUGE M_LOADINGGAUGE;
  var::M_AXLELOADCAT M_AXLELOADCAT;
  var::M_AIRTIGHT M_AIRTIGHT;
  var::N_AXLE N_AXLE;
  InplaceVector<TrainPacket11_tractions, 31> tractions;
  friend constexpr bool operator==(const TrainPacket12&, const TrainPacket12&) = default;
};

template <>
inline constexpr auto layout_of<TrainPacket12> = layout(&TrainPacket12::NC_CDTRAIN, &TrainPacket12::NC_TRAIN,
                                                        &TrainPacket12::V_MAXTRAIN, &TrainPacket12::M_LOADINGGAUGE,
                                                        &TrainPacket12::M_AXLELOADCAT, &TrainPacket12::M_AIRTIGHT,
                                                        &TrainPacket12::N_AXLE,
                                                        repeat<var::N_ITER>("tractions", &TrainPacket12::tractions));

}  // namespace evc::lang
