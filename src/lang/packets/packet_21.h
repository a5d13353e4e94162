#pragma once
#include "lang/variables.h"

namespace evc::lang {

struct Packet21_steps {
  var::D_GRADIENT D_GRADIENT;
  var::Q_GDIR Q_GDIR;
  var::G_A G_A;
  friend constexpr bool operator==(const Packet21_steps&, const Packet21_steps&) = default;
};

/// Packet 21, Gradient profile (7.4.2.6), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet21 {
  static constexpr PacketInfo info{21,
                                   "Gradient profile",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "7.4.2.6",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::D_GRADIENT D_GRADIENT;
  var::Q_GDIR Q_GDIR;
  var::G_A G_A;
  InplaceVector<Packet21_steps, 31> steps;
  /// The element before the counter, in the form of the others.
  constexpr Packet21_steps first_steps() const { return {D_GRADIENT, Q_GDIR, G_A}; }
  friend constexpr bool operator==(const Packet21&, const Packet21&) = default;
};

template <>
inline constexpr auto layout_of<Packet21_steps> = layout(&Packet21_steps::D_GRADIENT, &Packet21_steps::Q_GDIR,
                                                         &Packet21_steps::G_A);

template <>
inline constexpr auto layout_of<Packet21> = layout(&Packet21::Q_DIR, &Packet21::Q_SCALE, &Packet21::D_GRADIENT,
                                                   &Packet21::Q_GDIR, &Packet21::G_A,
                                                   repeat<var::N_ITER>("steps", &Packet21::steps));

}  // namespace evc::lang
