#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 180, LSSMA display toggle (7.4.2.37.3), system version 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet180 {
  static constexpr PacketInfo info{180,
                                   "LSSMA display toggle",
                                   Direction::to_train,
                                   v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "7.4.2.37.3",
                                   "absent from SRS 3.3.0; in 3.6.0, not excluded for SV 2.0"};
  var::Q_DIR Q_DIR;
  var::Q_LSSMA Q_LSSMA;
  var::T_LSSMA T_LSSMA;  ///< only if Q_LSSMA == 1
  friend constexpr bool operator==(const Packet180&, const Packet180&) = default;
};

template <>
inline constexpr auto layout_of<Packet180> = layout(&Packet180::Q_DIR, &Packet180::Q_LSSMA,
                                                    when(&Packet180::Q_LSSMA, is(1), &Packet180::T_LSSMA));

}  // namespace evc::lang
