#pragma once
#include "lang/variables.h"

namespace evc::lang {

struct Packet41_levels {
  var::M_LEVELTR M_LEVELTR;
  var::NID_NTC NID_NTC;  ///< only if M_LEVELTR == 1
  var::L_ACKLEVELTR L_ACKLEVELTR;
  friend constexpr bool operator==(const Packet41_levels&, const Packet41_levels&) = default;
};

/// Packet 41, Level transition order (7.4.2.9), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3.
struct Packet41 {
  static constexpr PacketInfo info{41,
                                   "Level transition order",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "7.4.2.9",
                                   "priority order, highest first"};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::D_LEVELTR D_LEVELTR;
  var::M_LEVELTR M_LEVELTR;
  var::NID_NTC NID_NTC;  ///< only if M_LEVELTR == 1
  var::L_ACKLEVELTR L_ACKLEVELTR;
  InplaceVector<Packet41_levels, 31> levels;
  /// The element before the counter, in the form of the others.
  constexpr Packet41_levels first_levels() const { return {M_LEVELTR, NID_NTC, L_ACKLEVELTR}; }
  friend constexpr bool operator==(const Packet41&, const Packet41&) = default;
};

template <>
inline constexpr auto layout_of<Packet41_levels> = layout(&Packet41_levels::M_LEVELTR,
                                                          when(&Packet41_levels::M_LEVELTR, is(1),
                                                               &Packet41_levels::NID_NTC),
                                                          &Packet41_levels::L_ACKLEVELTR);

template <>
inline constexpr auto layout_of<Packet41> = layout(&Packet41::Q_DIR, &Packet41::Q_SCALE, &Packet41::D_LEVELTR,
                                                   &Packet41::M_LEVELTR,
                                                   when(&Packet41::M_LEVELTR, is(1), &Packet41::NID_NTC),
                                                   &Packet41::L_ACKLEVELTR,
                                                   repeat<var::N_ITER>("levels", &Packet41::levels));

struct Packet41_v3_0_levels {
  var::M_LEVELTR_V3 M_LEVELTR;
  var::NID_NTC NID_NTC;  ///< only if M_LEVELTR == 1
  var::L_ACKLEVELTR L_ACKLEVELTR;
  friend constexpr bool operator==(const Packet41_v3_0_levels&, const Packet41_v3_0_levels&) = default;
};

/// Packet 41, Level transition order (7.4.2.9), system version 3.0.
struct Packet41_v3_0 {
  static constexpr PacketInfo info{41,
                                   "Level transition order",
                                   Direction::to_train,
                                   v3_0,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "7.4.2.9",
                                   "priority order, highest first"};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::D_LEVELTR D_LEVELTR;
  var::M_LEVELTR_V3 M_LEVELTR;
  var::NID_NTC NID_NTC;  ///< only if M_LEVELTR == 1
  var::L_ACKLEVELTR L_ACKLEVELTR;
  InplaceVector<Packet41_v3_0_levels, 31> levels;
  /// The element before the counter, in the form of the others.
  constexpr Packet41_v3_0_levels first_levels() const { return {M_LEVELTR, NID_NTC, L_ACKLEVELTR}; }
  friend constexpr bool operator==(const Packet41_v3_0&, const Packet41_v3_0&) = default;
};

template <>
inline constexpr auto layout_of<Packet41_v3_0_levels> = layout(named("M_LEVELTR", &Packet41_v3_0_levels::M_LEVELTR),
                                                               when(&Packet41_v3_0_levels::M_LEVELTR, is(1),
                                                                    &Packet41_v3_0_levels::NID_NTC),
                                                               &Packet41_v3_0_levels::L_ACKLEVELTR);

template <>
inline constexpr auto layout_of<Packet41_v3_0> = layout(&Packet41_v3_0::Q_DIR, &Packet41_v3_0::Q_SCALE,
                                                        &Packet41_v3_0::D_LEVELTR,
                                                        named("M_LEVELTR", &Packet41_v3_0::M_LEVELTR),
                                                        when(&Packet41_v3_0::M_LEVELTR, is(1), &Packet41_v3_0::NID_NTC),
                                                        &Packet41_v3_0::L_ACKLEVELTR,
                                                        repeat<var::N_ITER>("levels", &Packet41_v3_0::levels));

}  // namespace evc::lang
