#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 45, Radio network registration (7.4.2.11.1), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3.
struct Packet45 {
  static constexpr PacketInfo info{45,
                                   "Radio network registration",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3,
                                   media::balise | media::RBC | media::RIU,
                                   "7.4.2.11.1",
                                   ""};
  var::Q_DIR Q_DIR;
  var::NID_MN NID_MN;
  friend constexpr bool operator==(const Packet45&, const Packet45&) = default;
};

template <>
inline constexpr auto layout_of<Packet45> = layout(&Packet45::Q_DIR, &Packet45::NID_MN);

/// Packet 45, Radio network transition (7.4.2.11.1), system version 3.0.
struct Packet45_v3_0 {
  static constexpr PacketInfo info{
      45, "Radio network transition", Direction::to_train, v3_0, media::balise | media::RBC | media::RIU, "7.4.2.11.1",
      ""};
  var::Q_DIR Q_DIR;
  var::Q_NETWORKTYPE Q_NETWORKTYPE;
  var::NID_MN NID_MN;  ///< only if Q_NETWORKTYPE != 0
  friend constexpr bool operator==(const Packet45_v3_0&, const Packet45_v3_0&) = default;
};

template <>
inline constexpr auto layout_of<Packet45_v3_0> = layout(&Packet45_v3_0::Q_DIR, &Packet45_v3_0::Q_NETWORKTYPE,
                                                        when(&Packet45_v3_0::Q_NETWORKTYPE, is_not(0),
                                                             &Packet45_v3_0::NID_MN));

}  // namespace evc::lang
