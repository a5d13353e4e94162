#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 57, MA request parameters (7.4.2.14), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet57 {
  static constexpr PacketInfo info{57,
                                   "MA request parameters",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::RBC,
                                   "7.4.2.14",
                                   ""};
  var::Q_DIR Q_DIR;
  var::T_MAR T_MAR;
  var::T_TIMEOUTRQST T_TIMEOUTRQST;
  var::T_CYCRQST T_CYCRQST;
  friend constexpr bool operator==(const Packet57&, const Packet57&) = default;
};

template <>
inline constexpr auto layout_of<Packet57> = layout(&Packet57::Q_DIR, &Packet57::T_MAR, &Packet57::T_TIMEOUTRQST,
                                                   &Packet57::T_CYCRQST);

}  // namespace evc::lang
