#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 255, End of information (7.4.2.39), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet255 {
  static constexpr PacketInfo info{255,
                                   "End of information",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::loop,
                                   "7.4.2.39",
                                   "8 bits, all ones; never in radio messages"};
  friend constexpr bool operator==(const Packet255&, const Packet255&) = default;
};

template <>
inline constexpr auto layout_of<Packet255> = layout();

}  // namespace evc::lang
