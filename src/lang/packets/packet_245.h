#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 245, Radio network type (6.5.2.3.16.2), system version 2.3.
struct Packet245 {
  static constexpr PacketInfo info{245,
                                   "Radio network type",
                                   Direction::to_train,
                                   v2_3,
                                   media::balise | media::RBC | media::RIU,
                                   "6.5.2.3.16.2",
                                   "with packet 45 in the same message if the type is 1 or 2 (6.5.2.4.4)"};
  var::Q_DIR Q_DIR;
  var::Q_NETWORKTYPE Q_NETWORKTYPE;
  friend constexpr bool operator==(const Packet245&, const Packet245&) = default;
};

template <>
inline constexpr auto layout_of<Packet245> = layout(&Packet245::Q_DIR, &Packet245::Q_NETWORKTYPE);

}  // namespace evc::lang
