#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 10, Safe consist length for SM (7.4.3.4.3), system version 2.3, 3.0.
struct TrainPacket10 {
  static constexpr PacketInfo info{
      10, "Safe consist length for SM", Direction::to_track, v2_3 | v3_0, media::RBC, "7.4.3.4.3", ""};
  var::Q_SAFECONSISTLENGTH Q_SAFECONSISTLENGTH;
  var::L_CONSISTFRONTENGINENOM L_CONSISTFRONTENGINENOM;  ///< only if Q_SAFECONSISTLENGTH == 1
  var::L_CONSISTFRONTENGINEMIN L_CONSISTFRONTENGINEMIN;  ///< only if Q_SAFECONSISTLENGTH == 1
  var::L_CONSISTFRONTENGINEMAX L_CONSISTFRONTENGINEMAX;  ///< only if Q_SAFECONSISTLENGTH == 1
  var::L_CONSISTREARENGINENOM L_CONSISTREARENGINENOM;    ///< only if Q_SAFECONSISTLENGTH == 1
  var::L_CONSISTREARENGINEMIN L_CONSISTREARENGINEMIN;    ///< only if Q_SAFECONSISTLENGTH == 1
  var::L_CONSISTREARENGINEMAX L_CONSISTREARENGINEMAX;    ///< only if Q_SAFECONSISTLENGTH == 1
  friend constexpr bool operator==(const TrainPacket10&, const TrainPacket10&) = default;
};

template <>
inline constexpr auto layout_of<TrainPacket10> =
    layout(&TrainPacket10::Q_SAFECONSISTLENGTH,
           when(&TrainPacket10::Q_SAFECONSISTLENGTH, is(1), &TrainPacket10::L_CONSISTFRONTENGINENOM,
                &TrainPacket10::L_CONSISTFRONTENGINEMIN, &TrainPacket10::L_CONSISTFRONTENGINEMAX,
                &TrainPacket10::L_CONSISTREARENGINENOM, &TrainPacket10::L_CONSISTREARENGINEMIN,
                &TrainPacket10::L_CONSISTREARENGINEMAX));

}  // namespace evc::lang
