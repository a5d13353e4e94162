#pragma once
#include "lang/variables.h"

namespace evc::lang {

struct Packet49_groups {
  var::Q_NEWCOUNTRY Q_NEWCOUNTRY;
  var::NID_C NID_C;  ///< only if Q_NEWCOUNTRY == 1
  var::NID_BG NID_BG;
  friend constexpr bool operator==(const Packet49_groups&, const Packet49_groups&) = default;
};

/// Packet 49, Balise groups for SH area (7.4.2.12), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet49 {
  static constexpr PacketInfo info{49,
                                   "Balise groups for SH area",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "7.4.2.12",
                                   ""};
  var::Q_DIR Q_DIR;
  InplaceVector<Packet49_groups, 31> groups;
  friend constexpr bool operator==(const Packet49&, const Packet49&) = default;
};

template <>
inline constexpr auto layout_of<Packet49_groups> = layout(&Packet49_groups::Q_NEWCOUNTRY,
                                                          when(&Packet49_groups::Q_NEWCOUNTRY, is(1),
                                                               &Packet49_groups::NID_C),
                                                          &Packet49_groups::NID_BG);

template <>
inline constexpr auto layout_of<Packet49> = layout(&Packet49::Q_DIR, repeat<var::N_ITER>("groups", &Packet49::groups));

}  // namespace evc::lang
