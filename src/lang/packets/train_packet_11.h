#pragma once
#include "lang/variables.h"

namespace evc::lang {

struct TrainPacket11_tractions {
  var::M_VOLTAGE M_VOLTAGE;
  var::NID_CTRACTION NID_CTRACTION;  ///< only if M_VOLTAGE != 0
  friend constexpr bool operator==(const TrainPacket11_tractions&, const TrainPacket11_tractions&) = default;
};

struct TrainPacket11_ntcs {
  var::NID_NTC NID_NTC;
  friend constexpr bool operator==(const TrainPacket11_ntcs&, const TrainPacket11_ntcs&) = default;
};

/// Packet 11, Validated train data (7.4.3.5), system version 2.0, 2.1, 2.2, 2.3, 3.0.
struct TrainPacket11 {
  static constexpr PacketInfo info{
      11, "Validated train data", Direction::to_track, v2_0 | v2_1 | v2_2 | v2_3 | v3_0, media::RBC, "7.4.3.5", ""};
  var::NC_CDTRAIN NC_CDTRAIN;
  var::NC_TRAIN NC_TRAIN;
  var::L_TRAIN L_TRAIN;
  var::V_MAXTRAIN V_MAXTRAIN;
  var::M_LOADINGGAUGE M_LOADINGGAUGE;
  var::M_AXLELOADCAT M_AXLELOADCAT;
  var::M_AIRTIGHT M_AIRTIGHT;
  var::N_AXLE N_AXLE;
  InplaceVector<TrainPacket11_tractions, 31> tractions;
  InplaceVector<TrainPacket11_ntcs, 31> ntcs;
  friend constexpr bool operator==(const TrainPacket11&, const TrainPacket11&) = default;
};

template <>
inline constexpr auto layout_of<TrainPacket11_tractions> = layout(&TrainPacket11_tractions::M_VOLTAGE,
                                                                  when(&TrainPacket11_tractions::M_VOLTAGE, is_not(0),
                                                                       &TrainPacket11_tractions::NID_CTRACTION));

template <>
inline constexpr auto layout_of<TrainPacket11_ntcs> = layout(&TrainPacket11_ntcs::NID_NTC);

template <>
inline constexpr auto layout_of<TrainPacket11> =
    layout(&TrainPacket11::NC_CDTRAIN, &TrainPacket11::NC_TRAIN, &TrainPacket11::L_TRAIN, &TrainPacket11::V_MAXTRAIN,
           &TrainPacket11::M_LOADINGGAUGE, &TrainPacket11::M_AXLELOADCAT, &TrainPacket11::M_AIRTIGHT,
           &TrainPacket11::N_AXLE, repeat<var::N_ITER>("N_ITER_TRACTION", "tractions", &TrainPacket11::tractions),
           repeat<var::N_ITER>("N_ITER_NTC", "ntcs", &TrainPacket11::ntcs));

struct TrainPacket11_v1_0_tractions {
  var::M_TRACTION M_TRACTION;
  friend constexpr bool operator==(const TrainPacket11_v1_0_tractions&, const TrainPacket11_v1_0_tractions&) = default;
};

/// Packet 11, Validated train data (6.5.1.5.25.2), system version 1.0, 1.1.
struct TrainPacket11_v1_0 {
  static constexpr PacketInfo info{
      11, "Validated train data", Direction::to_track, v1_0 | v1_1, media::RBC, "6.5.1.5.25.2", ""};
  var::NID_OPERATIONAL_V1 NID_OPERATIONAL;
  var::NC_TRAIN_V1 NC_TRAIN;
  var::L_TRAIN L_TRAIN;
  var::V_MAXTRAIN V_MAXTRAIN;
  var::M_LOADINGGAUGE_V1 M_LOADINGGAUGE;
  var::M_AXLELOAD M_AXLELOAD;
  var::M_AIRTIGHT M_AIRTIGHT;
  InplaceVector<TrainPacket11_v1_0_tractions, 31> tractions;
  InplaceVector<TrainPacket11_ntcs, 31> ntcs;
  friend constexpr bool operator==(const TrainPacket11_v1_0&, const TrainPacket11_v1_0&) = default;
};

template <>
inline constexpr auto layout_of<TrainPacket11_v1_0_tractions> = layout(&TrainPacket11_v1_0_tractions::M_TRACTION);

template <>
inline constexpr auto layout_of<TrainPacket11_v1_0> =
    layout(named("NID_OPERATIONAL", &TrainPacket11_v1_0::NID_OPERATIONAL),
           named("NC_TRAIN", &TrainPacket11_v1_0::NC_TRAIN), &TrainPacket11_v1_0::L_TRAIN,
           &TrainPacket11_v1_0::V_MAXTRAIN, named("M_LOADINGGAUGE", &TrainPacket11_v1_0::M_LOADINGGAUGE),
           &TrainPacket11_v1_0::M_AXLELOAD, &TrainPacket11_v1_0::M_AIRTIGHT,
           repeat<var::N_ITER>("N_ITER_TRACTION", "tractions", &TrainPacket11_v1_0::tractions),
           repeat<var::N_ITER>("N_ITER_NTC", "ntcs", &TrainPacket11_v1_0::ntcs));

}  // namespace evc::lang
