#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 140, Train running number from RBC (7.4.2.36), system version 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet140 {
  static constexpr PacketInfo info{140,
                                   "Train running number from RBC",
                                   Direction::to_train,
                                   v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::RBC,
                                   "7.4.2.36",
                                   ""};
  var::Q_DIR Q_DIR;
  var::NID_OPERATIONAL NID_OPERATIONAL;
  friend constexpr bool operator==(const Packet140&, const Packet140&) = default;
};

template <>
inline constexpr auto layout_of<Packet140> = layout(&Packet140::Q_DIR, &Packet140::NID_OPERATIONAL);

/// Packet 140, Train running number from RBC (7.4.2.36), system version 1.0, 1.1.
struct Packet140_v1_0 {
  static constexpr PacketInfo info{
      140, "Train running number from RBC", Direction::to_train, v1_0 | v1_1, media::RBC, "7.4.2.36", ""};
  var::Q_DIR Q_DIR;
  var::NID_OPERATIONAL_V1 NID_OPERATIONAL;
  friend constexpr bool operator==(const Packet140_v1_0&, const Packet140_v1_0&) = default;
};

template <>
inline constexpr auto layout_of<Packet140_v1_0> = layout(&Packet140_v1_0::Q_DIR,
                                                         named("NID_OPERATIONAL", &Packet140_v1_0::NID_OPERATIONAL));

}  // namespace evc::lang
