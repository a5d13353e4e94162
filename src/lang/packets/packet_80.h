#pragma once
#include "lang/variables.h"

namespace evc::lang {

struct Packet80_modes {
  var::D_MAMODE D_MAMODE;
  var::M_MAMODE M_MAMODE;
  var::V_MAMODE V_MAMODE;
  var::L_MAMODE L_MAMODE;
  var::L_ACKMAMODE L_ACKMAMODE;
  var::Q_MAMODE Q_MAMODE;
  friend constexpr bool operator==(const Packet80_modes&, const Packet80_modes&) = default;
};

/// Packet 80, Mode profile (7.4.2.26), system version 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet80 {
  static constexpr PacketInfo info{80,
                                   "Mode profile",
                                   Direction::to_train,
                                   v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "7.4.2.26",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::D_MAMODE D_MAMODE;
  var::M_MAMODE M_MAMODE;
  var::V_MAMODE V_MAMODE;
  var::L_MAMODE L_MAMODE;
  var::L_ACKMAMODE L_ACKMAMODE;
  var::Q_MAMODE Q_MAMODE;
  InplaceVector<Packet80_modes, 31> modes;
  /// The element before the counter, in the form of the others.
  constexpr Packet80_modes first_modes() const {
    return {D_MAMODE, M_MAMODE, V_MAMODE, L_MAMODE, L_ACKMAMODE, Q_MAMODE};
  }
  friend constexpr bool operator==(const Packet80&, const Packet80&) = default;
};

template <>
inline constexpr auto layout_of<Packet80_modes> = layout(&Packet80_modes::D_MAMODE, &Packet80_modes::M_MAMODE,
                                                         &Packet80_modes::V_MAMODE, &Packet80_modes::L_MAMODE,
                                                         &Packet80_modes::L_ACKMAMODE, &Packet80_modes::Q_MAMODE);

template <>
inline constexpr auto layout_of<Packet80> = layout(&Packet80::Q_DIR, &Packet80::Q_SCALE, &Packet80::D_MAMODE,
                                                   &Packet80::M_MAMODE, &Packet80::V_MAMODE, &Packet80::L_MAMODE,
                                                   &Packet80::L_ACKMAMODE, &Packet80::Q_MAMODE,
                                                   repeat<var::N_ITER>("modes", &Packet80::modes));

struct Packet80_v1_0_modes {
  var::D_MAMODE D_MAMODE;
  var::M_MAMODE_V1 M_MAMODE;
  var::V_MAMODE V_MAMODE;
  var::L_MAMODE L_MAMODE;
  var::L_ACKMAMODE L_ACKMAMODE;
  friend constexpr bool operator==(const Packet80_v1_0_modes&, const Packet80_v1_0_modes&) = default;
};

/// Packet 80, Mode profile (6.5.1.5.18), system version 1.0, 1.1.
struct Packet80_v1_0 {
  static constexpr PacketInfo info{80,
                                   "Mode profile",
                                   Direction::to_train,
                                   v1_0 | v1_1,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "6.5.1.5.18",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::D_MAMODE D_MAMODE;
  var::M_MAMODE_V1 M_MAMODE;
  var::V_MAMODE V_MAMODE;
  var::L_MAMODE L_MAMODE;
  var::L_ACKMAMODE L_ACKMAMODE;
  InplaceVector<Packet80_v1_0_modes, 31> modes;
  /// The element before the counter, in the form of the others.
  constexpr Packet80_v1_0_modes first_modes() const { return {D_MAMODE, M_MAMODE, V_MAMODE, L_MAMODE, L_ACKMAMODE}; }
  friend constexpr bool operator==(const Packet80_v1_0&, const Packet80_v1_0&) = default;
};

template <>
inline constexpr auto layout_of<Packet80_v1_0_modes> = layout(&Packet80_v1_0_modes::D_MAMODE,
                                                              named("M_MAMODE", &Packet80_v1_0_modes::M_MAMODE),
                                                              &Packet80_v1_0_modes::V_MAMODE,
                                                              &Packet80_v1_0_modes::L_MAMODE,
                                                              &Packet80_v1_0_modes::L_ACKMAMODE);

template <>
inline constexpr auto layout_of<Packet80_v1_0> = layout(&Packet80_v1_0::Q_DIR, &Packet80_v1_0::Q_SCALE,
                                                        &Packet80_v1_0::D_MAMODE,
                                                        named("M_MAMODE", &Packet80_v1_0::M_MAMODE),
                                                        &Packet80_v1_0::V_MAMODE, &Packet80_v1_0::L_MAMODE,
                                                        &Packet80_v1_0::L_ACKMAMODE,
                                                        repeat<var::N_ITER>("modes", &Packet80_v1_0::modes));

}  // namespace evc::lang
