#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 64, Inhibit revocable balise TSRs (7.4.2.16.1), system version 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet64 {
  static constexpr PacketInfo info{64,
                                   "Inhibit revocable balise TSRs",
                                   Direction::to_train,
                                   v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::RBC,
                                   "7.4.2.16.1",
                                   "header only"};
  var::Q_DIR Q_DIR;
  friend constexpr bool operator==(const Packet64&, const Packet64&) = default;
};

template <>
inline constexpr auto layout_of<Packet64> = layout(&Packet64::Q_DIR);

}  // namespace evc::lang
