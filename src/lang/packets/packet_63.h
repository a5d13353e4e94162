#pragma once
#include "lang/variables.h"

namespace evc::lang {

struct Packet63_groups {
  var::Q_NEWCOUNTRY Q_NEWCOUNTRY;
  var::NID_C NID_C;  ///< only if Q_NEWCOUNTRY == 1
  var::NID_BG NID_BG;
  friend constexpr bool operator==(const Packet63_groups&, const Packet63_groups&) = default;
};

/// Packet 63, Balise groups in SR authority (7.4.2.16), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet63 {
  static constexpr PacketInfo info{63,
                                   "Balise groups in SR authority",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::RBC,
                                   "7.4.2.16",
                                   ""};
  var::Q_DIR Q_DIR;
  InplaceVector<Packet63_groups, 31> groups;
  friend constexpr bool operator==(const Packet63&, const Packet63&) = default;
};

template <>
inline constexpr auto layout_of<Packet63_groups> = layout(&Packet63_groups::Q_NEWCOUNTRY,
                                                          when(&Packet63_groups::Q_NEWCOUNTRY, is(1),
                                                               &Packet63_groups::NID_C),
                                                          &Packet63_groups::NID_BG);

template <>
inline constexpr auto layout_of<Packet63> = layout(&Packet63::Q_DIR, repeat<var::N_ITER>("groups", &Packet63::groups));

}  // namespace evc::lang
