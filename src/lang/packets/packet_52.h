#pragma once
#include "lang/variables.h"

namespace evc::lang {

struct Packet52_restrictions {
  var::D_PBD D_PBD;
  var::Q_GDIR Q_GDIR;
  var::G_PBDSR G_PBDSR;
  var::Q_PBDSR Q_PBDSR;
  var::D_PBDSR D_PBDSR;
  var::L_PBDSR L_PBDSR;
  friend constexpr bool operator==(const Packet52_restrictions&, const Packet52_restrictions&) = default;
};

/// Packet 52, Permitted braking distance (7.4.2.13.1), system version 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet52 {
  static constexpr PacketInfo info{52,
                                   "Permitted braking distance",
                                   Direction::to_train,
                                   v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "7.4.2.13.1",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::Q_TRACKINIT Q_TRACKINIT;
  var::D_TRACKINIT D_TRACKINIT;                           ///< only if Q_TRACKINIT == 1
  var::D_PBD D_PBD;                                       ///< only if Q_TRACKINIT == 0
  var::Q_GDIR Q_GDIR;                                     ///< only if Q_TRACKINIT == 0
  var::G_PBDSR G_PBDSR;                                   ///< only if Q_TRACKINIT == 0
  var::Q_PBDSR Q_PBDSR;                                   ///< only if Q_TRACKINIT == 0
  var::D_PBDSR D_PBDSR;                                   ///< only if Q_TRACKINIT == 0
  var::L_PBDSR L_PBDSR;                                   ///< only if Q_TRACKINIT == 0
  InplaceVector<Packet52_restrictions, 31> restrictions;  ///< only if Q_TRACKINIT == 0
  /// The element before the counter, in the form of the others.
  constexpr Packet52_restrictions first_restrictions() const {
    return {D_PBD, Q_GDIR, G_PBDSR, Q_PBDSR, D_PBDSR, L_PBDSR};
  }
  friend constexpr bool operator==(const Packet52&, const Packet52&) = default;
};

template <>
inline constexpr auto layout_of<Packet52_restrictions> =
    layout(&Packet52_restrictions::D_PBD, &Packet52_restrictions::Q_GDIR, &Packet52_restrictions::G_PBDSR,
           &Packet52_restrictions::Q_PBDSR, &Packet52_restrictions::D_PBDSR, &Packet52_restrictions::L_PBDSR);

template <>
inline constexpr auto layout_of<Packet52> = layout(&Packet52::Q_DIR, &Packet52::Q_SCALE, &Packet52::Q_TRACKINIT,
                                                   when(&Packet52::Q_TRACKINIT, is(1), &Packet52::D_TRACKINIT),
                                                   when(&Packet52::Q_TRACKINIT, is(0), &Packet52::D_PBD,
                                                        &Packet52::Q_GDIR, &Packet52::G_PBDSR, &Packet52::Q_PBDSR,
                                                        &Packet52::D_PBDSR, &Packet52::L_PBDSR,
                                                        repeat<var::N_ITER>("restrictions", &Packet52::restrictions)));

}  // namespace evc::lang
