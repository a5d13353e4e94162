#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 31, RBC transition order, FRMCS only (7.4.2.7.1), system version 2.3, 3.0.
struct Packet31 {
  static constexpr PacketInfo info{31,          "RBC transition order, FRMCS only", Direction::to_train,
                                   v2_3 | v3_0, media::balise | media::RBC,         "7.4.2.7.1",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::D_RBCTR D_RBCTR;
  var::NID_C NID_C;
  var::NID_RBC NID_RBC;
  var::Q_SLEEPSESSION Q_SLEEPSESSION;
  friend constexpr bool operator==(const Packet31&, const Packet31&) = default;
};

template <>
inline constexpr auto layout_of<Packet31> = layout(&Packet31::Q_DIR, &Packet31::Q_SCALE, &Packet31::D_RBCTR,
                                                   &Packet31::NID_C, &Packet31::NID_RBC, &Packet31::Q_SLEEPSESSION);

}  // namespace evc::lang
