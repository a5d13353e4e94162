#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 0, Position report (7.4.3.1), system version 2.0, 2.1.
struct TrainPacket0 {
  static constexpr PacketInfo info{
      0, "Position report", Direction::to_track, v2_0 | v2_1, media::RBC | media::RIU, "7.4.3.1", ""};
  var::Q_SCALE Q_SCALE;
  var::NID_LRBG NID_LRBG;
  var::D_LRBG D_LRBG;
  var::Q_DIRLRBG Q_DIRLRBG;
  var::Q_DLRBG Q_DLRBG;
  var::L_DOUBTOVER L_DOUBTOVER;
  var::L_DOUBTUNDER L_DOUBTUNDER;
  var::Q_LENGTH Q_LENGTH;
  var::L_TRAININT L_TRAININT;  ///< only if Q_LENGTH == 1 || Q_LENGTH == 2
  var::V_TRAIN V_TRAIN;
  var::Q_DIRTRAIN Q_DIRTRAIN;
  var::M_MODE M_MODE;
  var::M_LEVEL M_LEVEL;
  var::NID_NTC NID_NTC;  ///< only if M_LEVEL == 1
  friend constexpr bool operator==(const TrainPacket0&, const TrainPacket0&) = default;
};

template <>
inline constexpr auto layout_of<TrainPacket0> =
    layout(&TrainPacket0::Q_SCALE, &TrainPacket0::NID_LRBG, &TrainPacket0::D_LRBG, &TrainPacket0::Q_DIRLRBG,
           &TrainPacket0::Q_DLRBG, &TrainPacket0::L_DOUBTOVER, &TrainPacket0::L_DOUBTUNDER, &TrainPacket0::Q_LENGTH,
           when(&TrainPacket0::Q_LENGTH, is(1, 2), &TrainPacket0::L_TRAININT), &TrainPacket0::V_TRAIN,
           &TrainPacket0::Q_DIRTRAIN, &TrainPacket0::M_MODE, &TrainPacket0::M_LEVEL,
           when(&TrainPacket0::M_LEVEL, is(1), &TrainPacket0::NID_NTC));

/// Packet 0, Position report (7.4.3.1), system version 3.0.
struct TrainPacket0_v3_0 {
  static constexpr PacketInfo info{0, "Position report", Direction::to_track, v3_0, media::RBC | media::RIU, "7.4.3.1",
                                   ""};
  var::Q_SCALE Q_SCALE;
  var::NID_LRBG NID_LRBG;
  var::D_LRBG D_LRBG;
  var::Q_DIRLRBG Q_DIRLRBG;
  var::Q_DLRBG Q_DLRBG;
  var::L_DOUBTOVER L_DOUBTOVER;
  var::L_DOUBTUNDER L_DOUBTUNDER;
  var::Q_INTEGRITY Q_INTEGRITY;
  var::L_TRAININT L_TRAININT;  ///< only if Q_INTEGRITY == 1 || Q_INTEGRITY == 2
  var::V_TRAIN_V2_3 V_TRAIN;
  var::Q_DIRTRAIN Q_DIRTRAIN;
  var::M_MODE_V2_3 M_MODE;
  var::M_LEVEL_V3 M_LEVEL;
  var::NID_NTC NID_NTC;  ///< only if M_LEVEL == 1
  friend constexpr bool operator==(const TrainPacket0_v3_0&, const TrainPacket0_v3_0&) = default;
};

template <>
inline constexpr auto layout_of<TrainPacket0_v3_0> =
    layout(&TrainPacket0_v3_0::Q_SCALE, &TrainPacket0_v3_0::NID_LRBG, &TrainPacket0_v3_0::D_LRBG,
           &TrainPacket0_v3_0::Q_DIRLRBG, &TrainPacket0_v3_0::Q_DLRBG, &TrainPacket0_v3_0::L_DOUBTOVER,
           &TrainPacket0_v3_0::L_DOUBTUNDER, &TrainPacket0_v3_0::Q_INTEGRITY,
           when(&TrainPacket0_v3_0::Q_INTEGRITY, is(1, 2), &TrainPacket0_v3_0::L_TRAININT),
           named("V_TRAIN", &TrainPacket0_v3_0::V_TRAIN), &TrainPacket0_v3_0::Q_DIRTRAIN,
           named("M_MODE", &TrainPacket0_v3_0::M_MODE), named("M_LEVEL", &TrainPacket0_v3_0::M_LEVEL),
           when(&TrainPacket0_v3_0::M_LEVEL, is(1), &TrainPacket0_v3_0::NID_NTC));

/// Packet 0, Position report (6.6.5.6.3 [1]), system version 2.3.
struct TrainPacket0_v2_3 {
  static constexpr PacketInfo info{
      0, "Position report", Direction::to_track, v2_3, media::RBC | media::RIU, "6.6.5.6.3 [1]", ""};
  var::Q_SCALE Q_SCALE;
  var::NID_LRBG NID_LRBG;
  var::D_LRBG D_LRBG;
  var::Q_DIRLRBG Q_DIRLRBG;
  var::Q_DLRBG Q_DLRBG;
  var::L_DOUBTOVER L_DOUBTOVER;
  var::L_DOUBTUNDER L_DOUBTUNDER;
  var::Q_INTEGRITY Q_INTEGRITY;
  var::L_TRAININT L_TRAININT;  ///< only if Q_INTEGRITY == 1 || Q_INTEGRITY == 2
  var::V_TRAIN_V2_3 V_TRAIN;
  var::Q_DIRTRAIN Q_DIRTRAIN;
  var::M_MODE_V2_3 M_MODE;
  var::M_LEVEL M_LEVEL;
  var::NID_NTC NID_NTC;  ///< only if M_LEVEL == 1
  friend constexpr bool operator==(const TrainPacket0_v2_3&, const TrainPacket0_v2_3&) = default;
};

template <>
inline constexpr auto layout_of<TrainPacket0_v2_3> =
    layout(&TrainPacket0_v2_3::Q_SCALE, &TrainPacket0_v2_3::NID_LRBG, &TrainPacket0_v2_3::D_LRBG,
           &TrainPacket0_v2_3::Q_DIRLRBG, &TrainPacket0_v2_3::Q_DLRBG, &TrainPacket0_v2_3::L_DOUBTOVER,
           &TrainPacket0_v2_3::L_DOUBTUNDER, &TrainPacket0_v2_3::Q_INTEGRITY,
           when(&TrainPacket0_v2_3::Q_INTEGRITY, is(1, 2), &TrainPacket0_v2_3::L_TRAININT),
           named("V_TRAIN", &TrainPacket0_v2_3::V_TRAIN), &TrainPacket0_v2_3::Q_DIRTRAIN,
           named("M_MODE", &TrainPacket0_v2_3::M_MODE), &TrainPacket0_v2_3::M_LEVEL,
           when(&TrainPacket0_v2_3::M_LEVEL, is(1), &TrainPacket0_v2_3::NID_NTC));

/// Packet 0, Position report (6.6.5.5.6 [1]), system version 2.2.
struct TrainPacket0_v2_2 {
  static constexpr PacketInfo info{
      0, "Position report", Direction::to_track, v2_2, media::RBC | media::RIU, "6.6.5.5.6 [1]", ""};
  var::Q_SCALE Q_SCALE;
  var::NID_LRBG NID_LRBG;
  var::D_LRBG D_LRBG;
  var::Q_DIRLRBG Q_DIRLRBG;
  var::Q_DLRBG Q_DLRBG;
  var::L_DOUBTOVER L_DOUBTOVER;
  var::L_DOUBTUNDER L_DOUBTUNDER;
  var::Q_INTEGRITY Q_INTEGRITY;
  var::L_TRAININT L_TRAININT;  ///< only if Q_INTEGRITY == 1 || Q_INTEGRITY == 2
  var::V_TRAIN V_TRAIN;
  var::Q_DIRTRAIN Q_DIRTRAIN;
  var::M_MODE_V2_2 M_MODE;
  var::M_LEVEL M_LEVEL;
  var::NID_NTC NID_NTC;  ///< only if M_LEVEL == 1
  friend constexpr bool operator==(const TrainPacket0_v2_2&, const TrainPacket0_v2_2&) = default;
};

template <>
inline constexpr auto layout_of<TrainPacket0_v2_2> =
    layout(&TrainPacket0_v2_2::Q_SCALE, &TrainPacket0_v2_2::NID_LRBG, &TrainPacket0_v2_2::D_LRBG,
           &TrainPacket0_v2_2::Q_DIRLRBG, &TrainPacket0_v2_2::Q_DLRBG, &TrainPacket0_v2_2::L_DOUBTOVER,
           &TrainPacket0_v2_2::L_DOUBTUNDER, &TrainPacket0_v2_2::Q_INTEGRITY,
           when(&TrainPacket0_v2_2::Q_INTEGRITY, is(1, 2), &TrainPacket0_v2_2::L_TRAININT), &TrainPacket0_v2_2::V_TRAIN,
           &TrainPacket0_v2_2::Q_DIRTRAIN, named("M_MODE", &TrainPacket0_v2_2::M_MODE), &TrainPacket0_v2_2::M_LEVEL,
           when(&TrainPacket0_v2_2::M_LEVEL, is(1), &TrainPacket0_v2_2::NID_NTC));

/// Packet 0, Position report (7.4.3.1), system version 1.0, 1.1.
struct TrainPacket0_v1_0 {
  static constexpr PacketInfo info{
      0, "Position report", Direction::to_track, v1_0 | v1_1, media::RBC | media::RIU, "7.4.3.1", ""};
  var::Q_SCALE Q_SCALE;
  var::NID_LRBG NID_LRBG;
  var::D_LRBG D_LRBG;
  var::Q_DIRLRBG Q_DIRLRBG;
  var::Q_DLRBG Q_DLRBG;
  var::L_DOUBTOVER L_DOUBTOVER;
  var::L_DOUBTUNDER L_DOUBTUNDER;
  var::Q_LENGTH Q_LENGTH;
  var::L_TRAININT L_TRAININT;  ///< only if Q_LENGTH == 1 || Q_LENGTH == 2
  var::V_TRAIN V_TRAIN;
  var::Q_DIRTRAIN Q_DIRTRAIN;
  var::M_MODE_V1 M_MODE;
  var::M_LEVEL M_LEVEL;
  var::NID_NTC NID_NTC;  ///< only if M_LEVEL == 1
  friend constexpr bool operator==(const TrainPacket0_v1_0&, const TrainPacket0_v1_0&) = default;
};

template <>
inline constexpr auto layout_of<TrainPacket0_v1_0> =
    layout(&TrainPacket0_v1_0::Q_SCALE, &TrainPacket0_v1_0::NID_LRBG, &TrainPacket0_v1_0::D_LRBG,
           &TrainPacket0_v1_0::Q_DIRLRBG, &TrainPacket0_v1_0::Q_DLRBG, &TrainPacket0_v1_0::L_DOUBTOVER,
           &TrainPacket0_v1_0::L_DOUBTUNDER, &TrainPacket0_v1_0::Q_LENGTH,
           when(&TrainPacket0_v1_0::Q_LENGTH, is(1, 2), &TrainPacket0_v1_0::L_TRAININT), &TrainPacket0_v1_0::V_TRAIN,
           &TrainPacket0_v1_0::Q_DIRTRAIN, named("M_MODE", &TrainPacket0_v1_0::M_MODE), &TrainPacket0_v1_0::M_LEVEL,
           when(&TrainPacket0_v1_0::M_LEVEL, is(1), &TrainPacket0_v1_0::NID_NTC));

}  // namespace evc::lang
