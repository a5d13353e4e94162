#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 239, Traction system change (6.5.1.5.25), system version 1.1.
struct Packet239 {
  static constexpr PacketInfo info{239,
                                   "Traction system change",
                                   Direction::to_train,
                                   v1_1,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "6.5.1.5.25",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::D_TRACTION D_TRACTION;
  var::M_VOLTAGE M_VOLTAGE;
  var::NID_CTRACTION NID_CTRACTION;  ///< only if M_VOLTAGE != 0
  friend constexpr bool operator==(const Packet239&, const Packet239&) = default;
};

template <>
inline constexpr auto layout_of<Packet239> = layout(&Packet239::Q_DIR, &Packet239::Q_SCALE, &Packet239::D_TRACTION,
                                                    &Packet239::M_VOLTAGE,
                                                    when(&Packet239::M_VOLTAGE, is_not(0), &Packet239::NID_CTRACTION));

}  // namespace evc::lang
