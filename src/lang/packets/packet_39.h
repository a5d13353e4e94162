#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 39, Traction system change (7.4.2.8), system version 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet39 {
  static constexpr PacketInfo info{39,
                                   "Traction system change",
                                   Direction::to_train,
                                   v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "7.4.2.8",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::D_TRACTION D_TRACTION;
  var::M_VOLTAGE M_VOLTAGE;
  var::NID_CTRACTION NID_CTRACTION;  ///< only if M_VOLTAGE != 0
  friend constexpr bool operator==(const Packet39&, const Packet39&) = default;
};

template <>
inline constexpr auto layout_of<Packet39> = layout(&Packet39::Q_DIR, &Packet39::Q_SCALE, &Packet39::D_TRACTION,
                                                   &Packet39::M_VOLTAGE,
                                                   when(&Packet39::M_VOLTAGE, is_not(0), &Packet39::NID_CTRACTION));

/// Packet 39, Traction system change (6.5.1.5.7), system version 1.0, 1.1.
struct Packet39_v1_0 {
  static constexpr PacketInfo info{39,
                                   "Traction system change",
                                   Direction::to_train,
                                   v1_0 | v1_1,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "6.5.1.5.7",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::D_TRACTION D_TRACTION;
  var::M_TRACTION M_TRACTION;
  friend constexpr bool operator==(const Packet39_v1_0&, const Packet39_v1_0&) = default;
};

template <>
inline constexpr auto layout_of<Packet39_v1_0> = layout(&Packet39_v1_0::Q_DIR, &Packet39_v1_0::Q_SCALE,
                                                        &Packet39_v1_0::D_TRACTION, &Packet39_v1_0::M_TRACTION);

}  // namespace evc::lang
