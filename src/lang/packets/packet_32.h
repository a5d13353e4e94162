#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 32, Session management, FRMCS only (7.4.2.7.2), system version 2.3, 3.0.
struct Packet32 {
  static constexpr PacketInfo info{32,          "Session management, FRMCS only", Direction::to_train,
                                   v2_3 | v3_0, media::balise | media::RBC,       "7.4.2.7.2",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_RBC Q_RBC;
  var::NID_C NID_C;
  var::NID_RBC NID_RBC;
  var::Q_SLEEPSESSION Q_SLEEPSESSION;
  friend constexpr bool operator==(const Packet32&, const Packet32&) = default;
};

template <>
inline constexpr auto layout_of<Packet32> = layout(&Packet32::Q_DIR, &Packet32::Q_RBC, &Packet32::NID_C,
                                                   &Packet32::NID_RBC, &Packet32::Q_SLEEPSESSION);

}  // namespace evc::lang
