#pragma once
#include "lang/variables.h"

namespace evc::lang {

struct Packet46_levels {
  var::M_LEVELTR M_LEVELTR;
  var::NID_NTC NID_NTC;  ///< only if M_LEVELTR == 1
  friend constexpr bool operator==(const Packet46_levels&, const Packet46_levels&) = default;
};

/// Packet 46, Conditional level transition order (7.4.2.11.2), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3.
struct Packet46 {
  static constexpr PacketInfo info{46,
                                   "Conditional level transition order",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3,
                                   media::balise,
                                   "7.4.2.11.2",
                                   ""};
  var::Q_DIR Q_DIR;
  var::M_LEVELTR M_LEVELTR;
  var::NID_NTC NID_NTC;  ///< only if M_LEVELTR == 1
  InplaceVector<Packet46_levels, 31> levels;
  /// The element before the counter, in the form of the others.
  constexpr Packet46_levels first_levels() const { return {M_LEVELTR, NID_NTC}; }
  friend constexpr bool operator==(const Packet46&, const Packet46&) = default;
};

template <>
inline constexpr auto layout_of<Packet46_levels> =
    layout(&Packet46_levels::M_LEVELTR, when(&Packet46_levels::M_LEVELTR, is(1), &Packet46_levels::NID_NTC));

template <>
inline constexpr auto layout_of<Packet46> = layout(&Packet46::Q_DIR, &Packet46::M_LEVELTR,
                                                   when(&Packet46::M_LEVELTR, is(1), &Packet46::NID_NTC),
                                                   repeat<var::N_ITER>("levels", &Packet46::levels));

struct Packet46_v3_0_levels {
  var::M_LEVELTR_V3 M_LEVELTR;
  var::NID_NTC NID_NTC;  ///< only if M_LEVELTR == 1
  friend constexpr bool operator==(const Packet46_v3_0_levels&, const Packet46_v3_0_levels&) = default;
};

/// Packet 46, Conditional level transition order (7.4.2.11.2), system version 3.0.
struct Packet46_v3_0 {
  static constexpr PacketInfo info{
      46, "Conditional level transition order", Direction::to_train, v3_0, media::balise, "7.4.2.11.2", ""};
  var::Q_DIR Q_DIR;
  var::M_LEVELTR_V3 M_LEVELTR;
  var::NID_NTC NID_NTC;  ///< only if M_LEVELTR == 1
  InplaceVector<Packet46_v3_0_levels, 31> levels;
  /// The element before the counter, in the form of the others.
  constexpr Packet46_v3_0_levels first_levels() const { return {M_LEVELTR, NID_NTC}; }
  friend constexpr bool operator==(const Packet46_v3_0&, const Packet46_v3_0&) = default;
};

template <>
inline constexpr auto layout_of<Packet46_v3_0_levels> = layout(named("M_LEVELTR", &Packet46_v3_0_levels::M_LEVELTR),
                                                               when(&Packet46_v3_0_levels::M_LEVELTR, is(1),
                                                                    &Packet46_v3_0_levels::NID_NTC));

template <>
inline constexpr auto layout_of<Packet46_v3_0> = layout(&Packet46_v3_0::Q_DIR,
                                                        named("M_LEVELTR", &Packet46_v3_0::M_LEVELTR),
                                                        when(&Packet46_v3_0::M_LEVELTR, is(1), &Packet46_v3_0::NID_NTC),
                                                        repeat<var::N_ITER>("levels", &Packet46_v3_0::levels));

}  // namespace evc::lang
