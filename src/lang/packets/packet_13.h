#pragma once
#include "lang/variables.h"

namespace evc::lang {

struct Packet13_groups {
  var::Q_NEWCOUNTRY Q_NEWCOUNTRY;
  var::NID_C NID_C;  ///< only if Q_NEWCOUNTRY == 1
  var::NID_BG NID_BG;
  var::D_SR D_SR;
  friend constexpr bool operator==(const Packet13_groups&, const Packet13_groups&) = default;
};

/// Packet 13, SR distance from loop (7.4.2.3.1), system version 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet13 {
  static constexpr PacketInfo info{13,
                                   "SR distance from loop",
                                   Direction::to_train,
                                   v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::loop,
                                   "7.4.2.3.1",
                                   "first group = main signal group, then reference groups"};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::Q_NEWCOUNTRY Q_NEWCOUNTRY_MAIN;
  var::NID_C NID_C_MAIN;  ///< only if Q_NEWCOUNTRY_MAIN == 1
  var::NID_BG NID_BG_MAIN;
  var::Q_NEWCOUNTRY Q_NEWCOUNTRY;
  var::NID_C NID_C;  ///< only if Q_NEWCOUNTRY == 1
  var::NID_BG NID_BG;
  var::D_SR D_SR;
  InplaceVector<Packet13_groups, 31> groups;
  /// The element before the counter, in the form of the others.
  constexpr Packet13_groups first_groups() const { return {Q_NEWCOUNTRY, NID_C, NID_BG, D_SR}; }
  friend constexpr bool operator==(const Packet13&, const Packet13&) = default;
};

template <>
inline constexpr auto layout_of<Packet13_groups> = layout(&Packet13_groups::Q_NEWCOUNTRY,
                                                          when(&Packet13_groups::Q_NEWCOUNTRY, is(1),
                                                               &Packet13_groups::NID_C),
                                                          &Packet13_groups::NID_BG, &Packet13_groups::D_SR);

template <>
inline constexpr auto layout_of<Packet13> =
    layout(&Packet13::Q_DIR, &Packet13::Q_SCALE, named("Q_NEWCOUNTRY_MAIN", &Packet13::Q_NEWCOUNTRY_MAIN),
           when(&Packet13::Q_NEWCOUNTRY_MAIN, is(1), named("NID_C_MAIN", &Packet13::NID_C_MAIN)),
           named("NID_BG_MAIN", &Packet13::NID_BG_MAIN), &Packet13::Q_NEWCOUNTRY,
           when(&Packet13::Q_NEWCOUNTRY, is(1), &Packet13::NID_C), &Packet13::NID_BG, &Packet13::D_SR,
           repeat<var::N_ITER>("groups", &Packet13::groups));

}  // namespace evc::lang
