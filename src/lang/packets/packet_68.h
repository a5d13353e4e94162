#pragma once
#include "lang/variables.h"

namespace evc::lang {

struct Packet68_conditions {
  var::D_TRACKCOND D_TRACKCOND;
  var::L_TRACKCOND L_TRACKCOND;
  var::M_TRACKCOND M_TRACKCOND;
  friend constexpr bool operator==(const Packet68_conditions&, const Packet68_conditions&) = default;
};

/// Packet 68, Track condition (7.4.2.20), system version 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet68 {
  static constexpr PacketInfo info{68,
                                   "Track condition",
                                   Direction::to_train,
                                   v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "7.4.2.20",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::Q_TRACKINIT Q_TRACKINIT;
  var::D_TRACKINIT D_TRACKINIT;                       ///< only if Q_TRACKINIT == 1
  var::D_TRACKCOND D_TRACKCOND;                       ///< only if Q_TRACKINIT == 0
  var::L_TRACKCOND L_TRACKCOND;                       ///< only if Q_TRACKINIT == 0
  var::M_TRACKCOND M_TRACKCOND;                       ///< only if Q_TRACKINIT == 0
  InplaceVector<Packet68_conditions, 31> conditions;  ///< only if Q_TRACKINIT == 0
  /// The element before the counter, in the form of the others.
  constexpr Packet68_conditions first_conditions() const { return {D_TRACKCOND, L_TRACKCOND, M_TRACKCOND}; }
  friend constexpr bool operator==(const Packet68&, const Packet68&) = default;
};

template <>
inline constexpr auto layout_of<Packet68_conditions> = layout(&Packet68_conditions::D_TRACKCOND,
                                                              &Packet68_conditions::L_TRACKCOND,
                                                              &Packet68_conditions::M_TRACKCOND);

template <>
inline constexpr auto layout_of<Packet68> = layout(&Packet68::Q_DIR, &Packet68::Q_SCALE, &Packet68::Q_TRACKINIT,
                                                   when(&Packet68::Q_TRACKINIT, is(1), &Packet68::D_TRACKINIT),
                                                   when(&Packet68::Q_TRACKINIT, is(0), &Packet68::D_TRACKCOND,
                                                        &Packet68::L_TRACKCOND, &Packet68::M_TRACKCOND,
                                                        repeat<var::N_ITER>("conditions", &Packet68::conditions)));

struct Packet68_v1_0_conditions {
  var::D_TRACKCOND D_TRACKCOND;
  var::L_TRACKCOND L_TRACKCOND;
  var::M_TRACKCOND_V1 M_TRACKCOND;
  friend constexpr bool operator==(const Packet68_v1_0_conditions&, const Packet68_v1_0_conditions&) = default;
};

/// Packet 68, Track condition (7.4.2.20 with 6.5.1.5.31), system version 1.0, 1.1.
struct Packet68_v1_0 {
  static constexpr PacketInfo info{68,
                                   "Track condition",
                                   Direction::to_train,
                                   v1_0 | v1_1,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "7.4.2.20 with 6.5.1.5.31",
                                   "layout as X=2, value meanings differ"};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::Q_TRACKINIT Q_TRACKINIT;
  var::D_TRACKINIT D_TRACKINIT;                            ///< only if Q_TRACKINIT == 1
  var::D_TRACKCOND D_TRACKCOND;                            ///< only if Q_TRACKINIT == 0
  var::L_TRACKCOND L_TRACKCOND;                            ///< only if Q_TRACKINIT == 0
  var::M_TRACKCOND_V1 M_TRACKCOND;                         ///< only if Q_TRACKINIT == 0
  InplaceVector<Packet68_v1_0_conditions, 31> conditions;  ///< only if Q_TRACKINIT == 0
  /// The element before the counter, in the form of the others.
  constexpr Packet68_v1_0_conditions first_conditions() const { return {D_TRACKCOND, L_TRACKCOND, M_TRACKCOND}; }
  friend constexpr bool operator==(const Packet68_v1_0&, const Packet68_v1_0&) = default;
};

template <>
inline constexpr auto layout_of<Packet68_v1_0_conditions> = layout(&Packet68_v1_0_conditions::D_TRACKCOND,
                                                                   &Packet68_v1_0_conditions::L_TRACKCOND,
                                                                   named("M_TRACKCOND",
                                                                         &Packet68_v1_0_conditions::M_TRACKCOND));

template <>
inline constexpr auto layout_of<Packet68_v1_0> =
    layout(&Packet68_v1_0::Q_DIR, &Packet68_v1_0::Q_SCALE, &Packet68_v1_0::Q_TRACKINIT,
           when(&Packet68_v1_0::Q_TRACKINIT, is(1), &Packet68_v1_0::D_TRACKINIT),
           when(&Packet68_v1_0::Q_TRACKINIT, is(0), &Packet68_v1_0::D_TRACKCOND, &Packet68_v1_0::L_TRACKCOND,
                named("M_TRACKCOND", &Packet68_v1_0::M_TRACKCOND),
                repeat<var::N_ITER>("conditions", &Packet68_v1_0::conditions)));

}  // namespace evc::lang
