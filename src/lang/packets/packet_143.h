#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 143, Neighbouring RIU session (7.4.2.37.1), system version 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet143 {
  static constexpr PacketInfo info{
      143, "Neighbouring RIU session", Direction::to_train, v2_0 | v2_1 | v2_2 | v2_3 | v3_0, media::RIU, "7.4.2.37.1",
      ""};
  var::Q_DIR Q_DIR;
  var::Q_RIU Q_RIU;
  var::NID_C NID_C;
  var::NID_RIU NID_RIU;
  var::NID_RADIO NID_RADIO;
  friend constexpr bool operator==(const Packet143&, const Packet143&) = default;
};

template <>
inline constexpr auto layout_of<Packet143> = layout(&Packet143::Q_DIR, &Packet143::Q_RIU, &Packet143::NID_C,
                                                    &Packet143::NID_RIU, &Packet143::NID_RADIO);

}  // namespace evc::lang
