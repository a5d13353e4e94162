#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 44, External application data (7.4.2.11), system version 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet44 {
  static constexpr PacketInfo info{44,
                                   "External application data",
                                   Direction::to_train,
                                   v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "7.4.2.11",
                                   "opaque bits up to L_PACKET"};
  var::Q_DIR Q_DIR;
  var::NID_XUSER NID_XUSER;
  var::NID_NTC NID_NTC;  ///< only if NID_XUSER == 102
  Opaque OTHER_DATA;
  friend constexpr bool operator==(const Packet44&, const Packet44&) = default;
};

template <>
inline constexpr auto layout_of<Packet44> = layout(&Packet44::Q_DIR, &Packet44::NID_XUSER,
                                                   when(&Packet44::NID_XUSER, is(102), &Packet44::NID_NTC),
                                                   rest_of_packet("OTHER_DATA", &Packet44::OTHER_DATA));

/// Packet 44, External application data (6.5.1.5.9), system version 1.0, 1.1.
struct Packet44_v1_0 {
  static constexpr PacketInfo info{44,
                                   "External application data",
                                   Direction::to_train,
                                   v1_0 | v1_1,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "6.5.1.5.9",
                                   ""};
  var::Q_DIR Q_DIR;
  var::NID_XUSER NID_XUSER;
  Opaque OTHER_DATA;
  friend constexpr bool operator==(const Packet44_v1_0&, const Packet44_v1_0&) = default;
};

template <>
inline constexpr auto layout_of<Packet44_v1_0> = layout(&Packet44_v1_0::Q_DIR, &Packet44_v1_0::NID_XUSER,
                                                        rest_of_packet("OTHER_DATA", &Packet44_v1_0::OTHER_DATA));

}  // namespace evc::lang
