#pragma once
#include "lang/variables.h"

namespace evc::lang {

struct Packet206_conditions {
  var::D_TRACKCOND D_TRACKCOND;
  var::L_TRACKCOND L_TRACKCOND;
  var::M_TRACKCONDBC M_TRACKCONDBC;
  friend constexpr bool operator==(const Packet206_conditions&, const Packet206_conditions&) = default;
};

/// Packet 206, Track condition (6.5.1.5.23), system version 1.1.
struct Packet206 {
  static constexpr PacketInfo info{206,
                                   "Track condition",
                                   Direction::to_train,
                                   v1_1,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "6.5.1.5.23",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::Q_TRACKINIT Q_TRACKINIT;
  var::D_TRACKINIT D_TRACKINIT;                        ///< only if Q_TRACKINIT == 1
  var::D_TRACKCOND D_TRACKCOND;                        ///< only if Q_TRACKINIT == 0
  var::L_TRACKCOND L_TRACKCOND;                        ///< only if Q_TRACKINIT == 0
  var::M_TRACKCONDBC M_TRACKCONDBC;                    ///< only if Q_TRACKINIT == 0
  InplaceVector<Packet206_conditions, 31> conditions;  ///< only if Q_TRACKINIT == 0
  /// The element before the counter, in the form of the others.
  constexpr Packet206_conditions first_conditions() const { return {D_TRACKCOND, L_TRACKCOND, M_TRACKCONDBC}; }
  friend constexpr bool operator==(const Packet206&, const Packet206&) = default;
};

template <>
inline constexpr auto layout_of<Packet206_conditions> = layout(&Packet206_conditions::D_TRACKCOND,
                                                               &Packet206_conditions::L_TRACKCOND,
                                                               &Packet206_conditions::M_TRACKCONDBC);

template <>
inline constexpr auto layout_of<Packet206> = layout(&Packet206::Q_DIR, &Packet206::Q_SCALE, &Packet206::Q_TRACKINIT,
                                                    when(&Packet206::Q_TRACKINIT, is(1), &Packet206::D_TRACKINIT),
                                                    when(&Packet206::Q_TRACKINIT, is(0), &Packet206::D_TRACKCOND,
                                                         &Packet206::L_TRACKCOND, &Packet206::M_TRACKCONDBC,
                                                         repeat<var::N_ITER>("conditions", &Packet206::conditions)));

}  // namespace evc::lang
