#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 42, Session management (7.4.2.10), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet42 {
  static constexpr PacketInfo info{42,
                                   "Session management",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::RBC,
                                   "7.4.2.10",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_RBC Q_RBC;
  var::NID_C NID_C;
  var::NID_RBC NID_RBC;
  var::NID_RADIO NID_RADIO;
  var::Q_SLEEPSESSION Q_SLEEPSESSION;
  friend constexpr bool operator==(const Packet42&, const Packet42&) = default;
};

template <>
inline constexpr auto layout_of<Packet42> = layout(&Packet42::Q_DIR, &Packet42::Q_RBC, &Packet42::NID_C,
                                                   &Packet42::NID_RBC, &Packet42::NID_RADIO, &Packet42::Q_SLEEPSESSION);

}  // namespace evc::lang
