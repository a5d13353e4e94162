#pragma once
#include "lang/variables.h"

// SUBSET-026-8 8.7.
namespace evc::lang {

/// Message 2, SR authorisation (8.7.1), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before its packets.
struct Message2 {
  static constexpr MessageInfo info{2, "SR authorisation", Direction::to_train,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.7.1"};
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  var::NID_LRBG NID_LRBG;
  var::Q_SCALE Q_SCALE;
  var::D_SR D_SR;
  friend constexpr bool operator==(const Message2&, const Message2&) = default;
};

template <>
inline constexpr auto layout_of<Message2> = layout(&Message2::T_TRAIN, &Message2::M_ACK, &Message2::NID_LRBG,
                                                   &Message2::Q_SCALE, &Message2::D_SR);

/// Message 3, Movement authority (8.7.2), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before its
/// packets.
struct Message3 {
  static constexpr MessageInfo info{3, "Movement authority", Direction::to_train,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.7.2"};
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  var::NID_LRBG NID_LRBG;
  friend constexpr bool operator==(const Message3&, const Message3&) = default;
};

template <>
inline constexpr auto layout_of<Message3> = layout(&Message3::T_TRAIN, &Message3::M_ACK, &Message3::NID_LRBG);

/// Message 4, SM authorisation (8.7.2.1), system version 2.3, 3.0: the part before its packets.
struct Message4 {
  static constexpr MessageInfo info{4, "SM authorisation", Direction::to_train, v2_3 | v3_0, "8.7.2.1"};
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  var::NID_LRBG NID_LRBG;
  var::T_TRAIN T_TRAIN_REF;
  var::Q_SCALE Q_SCALE;
  var::D_REF D_REF;
  var::V_SM V_SM;
  friend constexpr bool operator==(const Message4&, const Message4&) = default;
};

template <>
inline constexpr auto layout_of<Message4> = layout(&Message4::T_TRAIN, &Message4::M_ACK, &Message4::NID_LRBG,
                                                   named("T_TRAIN_REF", &Message4::T_TRAIN_REF), &Message4::Q_SCALE,
                                                   &Message4::D_REF, &Message4::V_SM);

/// Message 5, SM refused (8.7.2.2), system version 2.3, 3.0: the part before its packets.
struct Message5 {
  static constexpr MessageInfo info{5, "SM refused", Direction::to_train, v2_3 | v3_0, "8.7.2.2"};
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  var::NID_LRBG NID_LRBG;
  var::T_TRAIN T_TRAIN_REF;
  friend constexpr bool operator==(const Message5&, const Message5&) = default;
};

template <>
inline constexpr auto layout_of<Message5> = layout(&Message5::T_TRAIN, &Message5::M_ACK, &Message5::NID_LRBG,
                                                   named("T_TRAIN_REF", &Message5::T_TRAIN_REF));

/// Message 6, Recognition of exit from TR (8.7.3), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before
/// its packets.
struct Message6 {
  static constexpr MessageInfo info{6, "Recognition of exit from TR", Direction::to_train,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.7.3"};
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  var::NID_LRBG NID_LRBG;
  friend constexpr bool operator==(const Message6&, const Message6&) = default;
};

template <>
inline constexpr auto layout_of<Message6> = layout(&Message6::T_TRAIN, &Message6::M_ACK, &Message6::NID_LRBG);

/// Message 7, Acknowledgement of consist length for SM (8.7.3.1), system version 2.3, 3.0: the part before its packets.
struct Message7 {
  static constexpr MessageInfo info{7, "Acknowledgement of consist length for SM", Direction::to_train, v2_3 | v3_0,
                                    "8.7.3.1"};
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  var::NID_LRBG NID_LRBG;
  var::T_TRAIN T_TRAIN_REF;
  friend constexpr bool operator==(const Message7&, const Message7&) = default;
};

template <>
inline constexpr auto layout_of<Message7> = layout(&Message7::T_TRAIN, &Message7::M_ACK, &Message7::NID_LRBG,
                                                   named("T_TRAIN_REF", &Message7::T_TRAIN_REF));

/// Message 8, Acknowledgement of train data (8.7.4), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before
/// its packets.
struct Message8 {
  static constexpr MessageInfo info{8, "Acknowledgement of train data", Direction::to_train,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.7.4"};
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  var::NID_LRBG NID_LRBG;
  var::T_TRAIN T_TRAIN_REF;
  friend constexpr bool operator==(const Message8&, const Message8&) = default;
};

template <>
inline constexpr auto layout_of<Message8> = layout(&Message8::T_TRAIN, &Message8::M_ACK, &Message8::NID_LRBG,
                                                   named("T_TRAIN_REF", &Message8::T_TRAIN_REF));

/// Message 9, Request to shorten MA (8.7.5), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before its
/// packets.
struct Message9 {
  static constexpr MessageInfo info{9, "Request to shorten MA", Direction::to_train,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.7.5"};
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  var::NID_LRBG NID_LRBG;
  friend constexpr bool operator==(const Message9&, const Message9&) = default;
};

template <>
inline constexpr auto layout_of<Message9> = layout(&Message9::T_TRAIN, &Message9::M_ACK, &Message9::NID_LRBG);

/// Message 15, Conditional emergency stop (8.7.6), system version 2.0, 2.1, 2.2, 2.3, 3.0: the part before its packets.
struct Message15 {
  static constexpr MessageInfo info{15, "Conditional emergency stop", Direction::to_train,
                                    v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.7.6"};
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  var::NID_LRBG NID_LRBG;
  var::NID_EM NID_EM;
  var::Q_SCALE Q_SCALE;
  var::D_REF D_REF;
  var::Q_DIR Q_DIR;
  var::D_EMERGENCYSTOP D_EMERGENCYSTOP;
  friend constexpr bool operator==(const Message15&, const Message15&) = default;
};

template <>
inline constexpr auto layout_of<Message15> = layout(&Message15::T_TRAIN, &Message15::M_ACK, &Message15::NID_LRBG,
                                                    &Message15::NID_EM, &Message15::Q_SCALE, &Message15::D_REF,
                                                    &Message15::Q_DIR, &Message15::D_EMERGENCYSTOP);

/// Message 15, Conditional emergency stop (6.5.1.6.7), system version 1.0, 1.1: the part before its packets.
struct Message15_v1_0 {
  static constexpr MessageInfo info{15, "Conditional emergency stop", Direction::to_train, v1_0 | v1_1, "6.5.1.6.7"};
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  var::NID_LRBG NID_LRBG;
  var::NID_EM NID_EM;
  var::Q_SCALE Q_SCALE;
  var::Q_DIR Q_DIR;
  var::D_EMERGENCYSTOP D_EMERGENCYSTOP;
  friend constexpr bool operator==(const Message15_v1_0&, const Message15_v1_0&) = default;
};

template <>
inline constexpr auto layout_of<Message15_v1_0> = layout(&Message15_v1_0::T_TRAIN, &Message15_v1_0::M_ACK,
                                                         &Message15_v1_0::NID_LRBG, &Message15_v1_0::NID_EM,
                                                         &Message15_v1_0::Q_SCALE, &Message15_v1_0::Q_DIR,
                                                         &Message15_v1_0::D_EMERGENCYSTOP);

/// Message 16, Unconditional emergency stop (8.7.7), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before
/// its packets.
struct Message16 {
  static constexpr MessageInfo info{16, "Unconditional emergency stop", Direction::to_train,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.7.7"};
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  var::NID_LRBG NID_LRBG;
  var::NID_EM NID_EM;
  friend constexpr bool operator==(const Message16&, const Message16&) = default;
};

template <>
inline constexpr auto layout_of<Message16> = layout(&Message16::T_TRAIN, &Message16::M_ACK, &Message16::NID_LRBG,
                                                    &Message16::NID_EM);

/// Message 18, Revocation of emergency stop (8.7.8), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before
/// its packets.
struct Message18 {
  static constexpr MessageInfo info{18, "Revocation of emergency stop", Direction::to_train,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.7.8"};
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  var::NID_LRBG NID_LRBG;
  var::NID_EM NID_EM;
  friend constexpr bool operator==(const Message18&, const Message18&) = default;
};

template <>
inline constexpr auto layout_of<Message18> = layout(&Message18::T_TRAIN, &Message18::M_ACK, &Message18::NID_LRBG,
                                                    &Message18::NID_EM);

/// Message 24, General message (8.7.9), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before its packets.
struct Message24 {
  static constexpr MessageInfo info{24, "General message", Direction::to_train,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.7.9"};
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  var::NID_LRBG NID_LRBG;
  friend constexpr bool operator==(const Message24&, const Message24&) = default;
};

template <>
inline constexpr auto layout_of<Message24> = layout(&Message24::T_TRAIN, &Message24::M_ACK, &Message24::NID_LRBG);

/// Message 27, SH refused (8.7.10), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before its packets.
struct Message27 {
  static constexpr MessageInfo info{27, "SH refused", Direction::to_train,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.7.10"};
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  var::NID_LRBG NID_LRBG;
  var::T_TRAIN T_TRAIN_REF;
  friend constexpr bool operator==(const Message27&, const Message27&) = default;
};

template <>
inline constexpr auto layout_of<Message27> = layout(&Message27::T_TRAIN, &Message27::M_ACK, &Message27::NID_LRBG,
                                                    named("T_TRAIN_REF", &Message27::T_TRAIN_REF));

/// Message 28, SH authorised (8.7.11), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before its packets.
struct Message28 {
  static constexpr MessageInfo info{28, "SH authorised", Direction::to_train,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.7.11"};
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  var::NID_LRBG NID_LRBG;
  var::T_TRAIN T_TRAIN_REF;
  friend constexpr bool operator==(const Message28&, const Message28&) = default;
};

template <>
inline constexpr auto layout_of<Message28> = layout(&Message28::T_TRAIN, &Message28::M_ACK, &Message28::NID_LRBG,
                                                    named("T_TRAIN_REF", &Message28::T_TRAIN_REF));

/// Message 32, RBC/RIU system version (8.7.12), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before its
/// packets.
struct Message32 {
  static constexpr MessageInfo info{32, "RBC/RIU system version", Direction::to_train,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.7.12"};
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  var::NID_LRBG NID_LRBG;
  var::M_VERSION M_VERSION;
  friend constexpr bool operator==(const Message32&, const Message32&) = default;
};

template <>
inline constexpr auto layout_of<Message32> = layout(&Message32::T_TRAIN, &Message32::M_ACK, &Message32::NID_LRBG,
                                                    &Message32::M_VERSION);

/// Message 33, MA with shifted reference (8.7.13), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before
/// its packets.
struct Message33 {
  static constexpr MessageInfo info{33, "MA with shifted reference", Direction::to_train,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.7.13"};
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  var::NID_LRBG NID_LRBG;
  var::Q_SCALE Q_SCALE;
  var::D_REF D_REF;
  friend constexpr bool operator==(const Message33&, const Message33&) = default;
};

template <>
inline constexpr auto layout_of<Message33> = layout(&Message33::T_TRAIN, &Message33::M_ACK, &Message33::NID_LRBG,
                                                    &Message33::Q_SCALE, &Message33::D_REF);

/// Message 34, Track ahead free request (8.7.14), system version 2.0, 2.1, 2.2, 2.3, 3.0: the part before its packets.
struct Message34 {
  static constexpr MessageInfo info{34, "Track ahead free request", Direction::to_train,
                                    v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.7.14"};
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  var::NID_LRBG NID_LRBG;
  var::Q_SCALE Q_SCALE;
  var::D_REF D_REF;
  var::Q_DIR Q_DIR;
  var::D_TAFDISPLAY D_TAFDISPLAY;
  var::L_TAFDISPLAY L_TAFDISPLAY;
  friend constexpr bool operator==(const Message34&, const Message34&) = default;
};

template <>
inline constexpr auto layout_of<Message34> = layout(&Message34::T_TRAIN, &Message34::M_ACK, &Message34::NID_LRBG,
                                                    &Message34::Q_SCALE, &Message34::D_REF, &Message34::Q_DIR,
                                                    &Message34::D_TAFDISPLAY, &Message34::L_TAFDISPLAY);

/// Message 34, Track ahead free request (6.5.1.6.8), system version 1.0, 1.1: the part before its packets.
struct Message34_v1_0 {
  static constexpr MessageInfo info{34, "Track ahead free request", Direction::to_train, v1_0 | v1_1, "6.5.1.6.8"};
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  var::NID_LRBG NID_LRBG;
  var::Q_SCALE Q_SCALE;
  var::Q_DIR Q_DIR;
  var::D_TAFDISPLAY D_TAFDISPLAY;
  var::L_TAFDISPLAY L_TAFDISPLAY;
  friend constexpr bool operator==(const Message34_v1_0&, const Message34_v1_0&) = default;
};

template <>
inline constexpr auto layout_of<Message34_v1_0> = layout(&Message34_v1_0::T_TRAIN, &Message34_v1_0::M_ACK,
                                                         &Message34_v1_0::NID_LRBG, &Message34_v1_0::Q_SCALE,
                                                         &Message34_v1_0::Q_DIR, &Message34_v1_0::D_TAFDISPLAY,
                                                         &Message34_v1_0::L_TAFDISPLAY);

/// Message 37, Infill MA (8.7.15), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before its packets.
struct Message37 {
  static constexpr MessageInfo info{37, "Infill MA", Direction::to_train,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.7.15"};
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  var::NID_LRBG NID_LRBG;
  friend constexpr bool operator==(const Message37&, const Message37&) = default;
};

template <>
inline constexpr auto layout_of<Message37> = layout(&Message37::T_TRAIN, &Message37::M_ACK, &Message37::NID_LRBG);

/// Message 38, Acknowledgement of session establishment (8.7.16), system version 2.3, 3.0: the part before its packets.
struct Message38 {
  static constexpr MessageInfo info{38, "Acknowledgement of session establishment", Direction::to_train, v2_3 | v3_0,
                                    "8.7.16"};
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  friend constexpr bool operator==(const Message38&, const Message38&) = default;
};

template <>
inline constexpr auto layout_of<Message38> = layout(&Message38::T_TRAIN, &Message38::M_ACK);

/// Message 38, Initiation of a session (SRS 3.3.0 8.7.16), system version 1.0, 1.1, 2.0: the part before its packets.
struct Message38_v1_0 {
  static constexpr MessageInfo info{38, "Initiation of a session", Direction::to_train, v1_0 | v1_1 | v2_0,
                                    "SRS 3.3.0 8.7.16"};
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  var::NID_LRBG NID_LRBG;
  friend constexpr bool operator==(const Message38_v1_0&, const Message38_v1_0&) = default;
};

template <>
inline constexpr auto layout_of<Message38_v1_0> = layout(&Message38_v1_0::T_TRAIN, &Message38_v1_0::M_ACK,
                                                         &Message38_v1_0::NID_LRBG);

/// Message 39, Acknowledgement of session end (8.7.17), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part
/// before its packets.
struct Message39 {
  static constexpr MessageInfo info{39, "Acknowledgement of session end", Direction::to_train,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.7.17"};
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  var::NID_LRBG NID_LRBG;
  friend constexpr bool operator==(const Message39&, const Message39&) = default;
};

template <>
inline constexpr auto layout_of<Message39> = layout(&Message39::T_TRAIN, &Message39::M_ACK, &Message39::NID_LRBG);

/// Message 40, Train rejected (8.7.18), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before its packets.
struct Message40 {
  static constexpr MessageInfo info{40, "Train rejected", Direction::to_train,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.7.18"};
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  var::NID_LRBG NID_LRBG;
  friend constexpr bool operator==(const Message40&, const Message40&) = default;
};

template <>
inline constexpr auto layout_of<Message40> = layout(&Message40::T_TRAIN, &Message40::M_ACK, &Message40::NID_LRBG);

/// Message 41, Train accepted (8.7.19), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before its packets.
struct Message41 {
  static constexpr MessageInfo info{41, "Train accepted", Direction::to_train,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.7.19"};
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  var::NID_LRBG NID_LRBG;
  friend constexpr bool operator==(const Message41&, const Message41&) = default;
};

template <>
inline constexpr auto layout_of<Message41> = layout(&Message41::T_TRAIN, &Message41::M_ACK, &Message41::NID_LRBG);

/// Message 43, SoM position confirmed by RBC (8.7.21), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part
/// before its packets.
struct Message43 {
  static constexpr MessageInfo info{43, "SoM position confirmed by RBC", Direction::to_train,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.7.21"};
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  var::NID_LRBG NID_LRBG;
  friend constexpr bool operator==(const Message43&, const Message43&) = default;
};

template <>
inline constexpr auto layout_of<Message43> = layout(&Message43::T_TRAIN, &Message43::M_ACK, &Message43::NID_LRBG);

/// Message 45, Coordinate system assignment (8.7.22), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0: the part before
/// its packets.
struct Message45 {
  static constexpr MessageInfo info{45, "Coordinate system assignment", Direction::to_train,
                                    v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0, "8.7.22"};
  var::T_TRAIN T_TRAIN;
  var::M_ACK M_ACK;
  var::NID_LRBG NID_LRBG;
  var::Q_ORIENTATION Q_ORIENTATION;
  friend constexpr bool operator==(const Message45&, const Message45&) = default;
};

template <>
inline constexpr auto layout_of<Message45> = layout(&Message45::T_TRAIN, &Message45::M_ACK, &Message45::NID_LRBG,
                                                    &Message45::Q_ORIENTATION);

}  // namespace evc::lang
