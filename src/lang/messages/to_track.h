#pragma once
#include "lang/variables.h"

// SUBSET-026-8 8.6.
namespace evc::lang {

/// Message 129, Validated train data (8.6.1), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before its
/// packets.
struct TrainMessage129 {
  static constexpr MessageInfo info{129, "Validated train data", Direction::to_track,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.6.1"};
  var::T_TRAIN T_TRAIN;
  var::NID_ENGINE NID_ENGINE;
  friend constexpr bool operator==(const TrainMessage129&, const TrainMessage129&) = default;
};

template <>
inline constexpr auto layout_of<TrainMessage129> = layout(&TrainMessage129::T_TRAIN, &TrainMessage129::NID_ENGINE);

/// Message 130, Request for shunting (8.6.2), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before its
/// packets.
struct TrainMessage130 {
  static constexpr MessageInfo info{130, "Request for shunting", Direction::to_track,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.6.2"};
  var::T_TRAIN T_TRAIN;
  var::NID_ENGINE NID_ENGINE;
  friend constexpr bool operator==(const TrainMessage130&, const TrainMessage130&) = default;
};

template <>
inline constexpr auto layout_of<TrainMessage130> = layout(&TrainMessage130::T_TRAIN, &TrainMessage130::NID_ENGINE);

/// Message 131, Request for SM (8.6.2.1), system version 2.3, 3.0: the part before its packets.
struct TrainMessage131 {
  static constexpr MessageInfo info{131, "Request for SM", Direction::to_track, v2_3 | v3_0, "8.6.2.1"};
  var::T_TRAIN T_TRAIN;
  var::NID_ENGINE NID_ENGINE;
  friend constexpr bool operator==(const TrainMessage131&, const TrainMessage131&) = default;
};

template <>
inline constexpr auto layout_of<TrainMessage131> = layout(&TrainMessage131::T_TRAIN, &TrainMessage131::NID_ENGINE);

/// Message 132, MA request (8.6.3), system version 2.0, 2.1, 2.2, 2.3, 3.0: the part before its packets.
struct TrainMessage132 {
  static constexpr MessageInfo info{132, "MA request", Direction::to_track, v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.6.3"};
  var::T_TRAIN T_TRAIN;
  var::NID_ENGINE NID_ENGINE;
  var::Q_MARQSTREASON Q_MARQSTREASON;
  friend constexpr bool operator==(const TrainMessage132&, const TrainMessage132&) = default;
};

template <>
inline constexpr auto layout_of<TrainMessage132> = layout(&TrainMessage132::T_TRAIN, &TrainMessage132::NID_ENGINE,
                                                          &TrainMessage132::Q_MARQSTREASON);

/// Message 132, MA request (6.5.1.6.6.3), system version 1.0, 1.1: the part before its packets.
struct TrainMessage132_v1_0 {
  static constexpr MessageInfo info{132, "MA request", Direction::to_track, v1_0 | v1_1, "6.5.1.6.6.3"};
  var::T_TRAIN T_TRAIN;
  var::NID_ENGINE NID_ENGINE;
  var::Q_TRACKDEL Q_TRACKDEL;
  friend constexpr bool operator==(const TrainMessage132_v1_0&, const TrainMessage132_v1_0&) = default;
};

template <>
inline constexpr auto layout_of<TrainMessage132_v1_0> = layout(&TrainMessage132_v1_0::T_TRAIN,
                                                               &TrainMessage132_v1_0::NID_ENGINE,
                                                               &TrainMessage132_v1_0::Q_TRACKDEL);

/// Message 133, Safe consist length for SM (8.6.3.1), system version 2.3, 3.0: the part before its packets.
struct TrainMessage133 {
  static constexpr MessageInfo info{133, "Safe consist length for SM", Direction::to_track, v2_3 | v3_0, "8.6.3.1"};
  var::T_TRAIN T_TRAIN;
  var::NID_ENGINE NID_ENGINE;
  friend constexpr bool operator==(const TrainMessage133&, const TrainMessage133&) = default;
};

template <>
inline constexpr auto layout_of<TrainMessage133> = layout(&TrainMessage133::T_TRAIN, &TrainMessage133::NID_ENGINE);

/// Message 136, Train position report (8.6.4), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before its
/// packets.
struct TrainMessage136 {
  static constexpr MessageInfo info{136, "Train position report", Direction::to_track,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.6.4"};
  var::T_TRAIN T_TRAIN;
  var::NID_ENGINE NID_ENGINE;
  friend constexpr bool operator==(const TrainMessage136&, const TrainMessage136&) = default;
};

template <>
inline constexpr auto layout_of<TrainMessage136> = layout(&TrainMessage136::T_TRAIN, &TrainMessage136::NID_ENGINE);

/// Message 137, MA shortening granted (8.6.5), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before its
/// packets.
struct TrainMessage137 {
  static constexpr MessageInfo info{137, "MA shortening granted", Direction::to_track,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.6.5"};
  var::T_TRAIN T_TRAIN;
  var::NID_ENGINE NID_ENGINE;
  var::T_TRAIN T_TRAIN_REF;
  friend constexpr bool operator==(const TrainMessage137&, const TrainMessage137&) = default;
};

template <>
inline constexpr auto layout_of<TrainMessage137> = layout(&TrainMessage137::T_TRAIN, &TrainMessage137::NID_ENGINE,
                                                          named("T_TRAIN_REF", &TrainMessage137::T_TRAIN_REF));

/// Message 138, MA shortening rejected (8.6.6), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before its
/// packets.
struct TrainMessage138 {
  static constexpr MessageInfo info{138, "MA shortening rejected", Direction::to_track,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.6.6"};
  var::T_TRAIN T_TRAIN;
  var::NID_ENGINE NID_ENGINE;
  var::T_TRAIN T_TRAIN_REF;
  friend constexpr bool operator==(const TrainMessage138&, const TrainMessage138&) = default;
};

template <>
inline constexpr auto layout_of<TrainMessage138> = layout(&TrainMessage138::T_TRAIN, &TrainMessage138::NID_ENGINE,
                                                          named("T_TRAIN_REF", &TrainMessage138::T_TRAIN_REF));

/// Message 146, Acknowledgement (8.6.7), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before its packets.
struct TrainMessage146 {
  static constexpr MessageInfo info{146, "Acknowledgement", Direction::to_track,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.6.7"};
  var::T_TRAIN T_TRAIN;
  var::NID_ENGINE NID_ENGINE;
  var::T_TRAIN T_TRAIN_REF;
  friend constexpr bool operator==(const TrainMessage146&, const TrainMessage146&) = default;
};

template <>
inline constexpr auto layout_of<TrainMessage146> = layout(&TrainMessage146::T_TRAIN, &TrainMessage146::NID_ENGINE,
                                                          named("T_TRAIN_REF", &TrainMessage146::T_TRAIN_REF));

/// Message 147, Acknowledgement of emergency stop (8.6.8), system version 2.0, 2.1, 2.2, 2.3, 3.0: the part before its
/// packets.
struct TrainMessage147 {
  static constexpr MessageInfo info{147, "Acknowledgement of emergency stop", Direction::to_track,
                                    v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.6.8"};
  var::T_TRAIN T_TRAIN;
  var::NID_ENGINE NID_ENGINE;
  var::NID_EM NID_EM;
  var::Q_EMERGENCYSTOP Q_EMERGENCYSTOP;
  friend constexpr bool operator==(const TrainMessage147&, const TrainMessage147&) = default;
};

template <>
inline constexpr auto layout_of<TrainMessage147> = layout(&TrainMessage147::T_TRAIN, &TrainMessage147::NID_ENGINE,
                                                          &TrainMessage147::NID_EM, &TrainMessage147::Q_EMERGENCYSTOP);

/// Message 147, Acknowledgement of emergency stop (8.6.8), system version 1.0, 1.1: the part before its packets.
struct TrainMessage147_v1_0 {
  static constexpr MessageInfo info{147, "Acknowledgement of emergency stop", Direction::to_track, v1_0 | v1_1,
                                    "8.6.8"};
  var::T_TRAIN T_TRAIN;
  var::NID_ENGINE NID_ENGINE;
  var::NID_EM NID_EM;
  var::Q_EMERGENCYSTOP_V1 Q_EMERGENCYSTOP;
  friend constexpr bool operator==(const TrainMessage147_v1_0&, const TrainMessage147_v1_0&) = default;
};

template <>
inline constexpr auto layout_of<TrainMessage147_v1_0> =
    layout(&TrainMessage147_v1_0::T_TRAIN, &TrainMessage147_v1_0::NID_ENGINE, &TrainMessage147_v1_0::NID_EM,
           named("Q_EMERGENCYSTOP", &TrainMessage147_v1_0::Q_EMERGENCYSTOP));

/// Message 149, Track ahead free granted (8.6.9), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before its
/// packets.
struct TrainMessage149 {
  static constexpr MessageInfo info{149, "Track ahead free granted", Direction::to_track,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.6.9"};
  var::T_TRAIN T_TRAIN;
  var::NID_ENGINE NID_ENGINE;
  friend constexpr bool operator==(const TrainMessage149&, const TrainMessage149&) = default;
};

template <>
inline constexpr auto layout_of<TrainMessage149> = layout(&TrainMessage149::T_TRAIN, &TrainMessage149::NID_ENGINE);

/// Message 150, End of mission (8.6.10), system version 2.3, 3.0: the part before its packets.
struct TrainMessage150_v2_3 {
  static constexpr MessageInfo info{150, "End of mission", Direction::to_track, v2_3 | v3_0, "8.6.10"};
  var::T_TRAIN T_TRAIN;
  var::NID_ENGINE NID_ENGINE;
  var::Q_DESK Q_DESK;
  friend constexpr bool operator==(const TrainMessage150_v2_3&, const TrainMessage150_v2_3&) = default;
};

template <>
inline constexpr auto layout_of<TrainMessage150_v2_3> = layout(&TrainMessage150_v2_3::T_TRAIN,
                                                               &TrainMessage150_v2_3::NID_ENGINE,
                                                               &TrainMessage150_v2_3::Q_DESK);

/// Message 150, End of mission (8.6.10), system version 1.0, 1.1, 2.0, 2.1, 2.2: the part before its packets.
struct TrainMessage150 {
  static constexpr MessageInfo info{150, "End of mission", Direction::to_track, v1_0 | v1_1 | v2_0 | v2_1 | v2_2,
                                    "8.6.10"};
  var::T_TRAIN T_TRAIN;
  var::NID_ENGINE NID_ENGINE;
  friend constexpr bool operator==(const TrainMessage150&, const TrainMessage150&) = default;
};

template <>
inline constexpr auto layout_of<TrainMessage150> = layout(&TrainMessage150::T_TRAIN, &TrainMessage150::NID_ENGINE);

/// Message 153, Radio infill request (8.6.11), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before its
/// packets.
struct TrainMessage153 {
  static constexpr MessageInfo info{153, "Radio infill request", Direction::to_track,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.6.11"};
  var::T_TRAIN T_TRAIN;
  var::NID_ENGINE NID_ENGINE;
  var::NID_C NID_C;
  var::NID_BG NID_BG;
  var::Q_INFILL Q_INFILL;
  friend constexpr bool operator==(const TrainMessage153&, const TrainMessage153&) = default;
};

template <>
inline constexpr auto layout_of<TrainMessage153> = layout(&TrainMessage153::T_TRAIN, &TrainMessage153::NID_ENGINE,
                                                          &TrainMessage153::NID_C, &TrainMessage153::NID_BG,
                                                          &TrainMessage153::Q_INFILL);

/// Message 154, No compatible version (8.6.12), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before its
/// packets.
struct TrainMessage154 {
  static constexpr MessageInfo info{154, "No compatible version", Direction::to_track,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.6.12"};
  var::T_TRAIN T_TRAIN;
  var::NID_ENGINE NID_ENGINE;
  friend constexpr bool operator==(const TrainMessage154&, const TrainMessage154&) = default;
};

template <>
inline constexpr auto layout_of<TrainMessage154> = layout(&TrainMessage154::T_TRAIN, &TrainMessage154::NID_ENGINE);

/// Message 155, Initiation of a session (8.6.13), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before its
/// packets.
struct TrainMessage155 {
  static constexpr MessageInfo info{155, "Initiation of a session", Direction::to_track,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.6.13"};
  var::T_TRAIN T_TRAIN;
  var::NID_ENGINE NID_ENGINE;
  friend constexpr bool operator==(const TrainMessage155&, const TrainMessage155&) = default;
};

template <>
inline constexpr auto layout_of<TrainMessage155> = layout(&TrainMessage155::T_TRAIN, &TrainMessage155::NID_ENGINE);

/// Message 156, Termination of a session (8.6.14), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before
/// its packets.
struct TrainMessage156 {
  static constexpr MessageInfo info{156, "Termination of a session", Direction::to_track,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.6.14"};
  var::T_TRAIN T_TRAIN;
  var::NID_ENGINE NID_ENGINE;
  friend constexpr bool operator==(const TrainMessage156&, const TrainMessage156&) = default;
};

template <>
inline constexpr auto layout_of<TrainMessage156> = layout(&TrainMessage156::T_TRAIN, &TrainMessage156::NID_ENGINE);

/// Message 157, SoM position report (8.6.15), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before its
/// packets.
struct TrainMessage157 {
  static constexpr MessageInfo info{157, "SoM position report", Direction::to_track,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.6.15"};
  var::T_TRAIN T_TRAIN;
  var::NID_ENGINE NID_ENGINE;
  var::Q_STATUS Q_STATUS;
  friend constexpr bool operator==(const TrainMessage157&, const TrainMessage157&) = default;
};

template <>
inline constexpr auto layout_of<TrainMessage157> = layout(&TrainMessage157::T_TRAIN, &TrainMessage157::NID_ENGINE,
                                                          &TrainMessage157::Q_STATUS);

/// Message 158, Text acknowledged by driver (8.6.16), system version 2.0, 2.1, 2.2, 2.3, 3.0: the part before its
/// packets.
struct TrainMessage158 {
  static constexpr MessageInfo info{158, "Text acknowledged by driver", Direction::to_track,
                                    v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.6.16"};
  var::T_TRAIN T_TRAIN;
  var::NID_ENGINE NID_ENGINE;
  var::NID_TEXTMESSAGE NID_TEXTMESSAGE;
  friend constexpr bool operator==(const TrainMessage158&, const TrainMessage158&) = default;
};

template <>
inline constexpr auto layout_of<TrainMessage158> = layout(&TrainMessage158::T_TRAIN, &TrainMessage158::NID_ENGINE,
                                                          &TrainMessage158::NID_TEXTMESSAGE);

/// Message 159, Session established (8.6.17), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before its
/// packets.
struct TrainMessage159 {
  static constexpr MessageInfo info{159, "Session established", Direction::to_track,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.6.17"};
  var::T_TRAIN T_TRAIN;
  var::NID_ENGINE NID_ENGINE;
  friend constexpr bool operator==(const TrainMessage159&, const TrainMessage159&) = default;
};

template <>
inline constexpr auto layout_of<TrainMessage159> = layout(&TrainMessage159::T_TRAIN, &TrainMessage159::NID_ENGINE);

}  // namespace evc::lang
