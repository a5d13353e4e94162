#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 181, Generic LS function marker (7.4.2.37.4), system version 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet181 {
  static constexpr PacketInfo info{181,
                                   "Generic LS function marker",
                                   Direction::to_train,
                                   v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise,
                                   "7.4.2.37.4",
                                   "header only; absent from SRS 3.3.0, in 3.6.0"};
  var::Q_DIR Q_DIR;
  friend constexpr bool operator==(const Packet181&, const Packet181&) = default;
};

template <>
inline constexpr auto layout_of<Packet181> = layout(&Packet181::Q_DIR);

}  // namespace evc::lang
