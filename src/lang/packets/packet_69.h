#pragma once
#include "lang/variables.h"

namespace evc::lang {

struct Packet69_platforms {
  var::D_TRACKCOND D_TRACKCOND;
  var::L_TRACKCOND L_TRACKCOND;
  var::M_PLATFORM M_PLATFORM;
  var::Q_PLATFORM Q_PLATFORM;
  friend constexpr bool operator==(const Packet69_platforms&, const Packet69_platforms&) = default;
};

/// Packet 69, Station platforms (7.4.2.20.1), system version 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet69 {
  static constexpr PacketInfo info{69,
                                   "Station platforms",
                                   Direction::to_train,
                                   v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "7.4.2.20.1",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::Q_TRACKINIT Q_TRACKINIT;
  var::D_TRACKINIT D_TRACKINIT;                     ///< only if Q_TRACKINIT == 1
  var::D_TRACKCOND D_TRACKCOND;                     ///< only if Q_TRACKINIT == 0
  var::L_TRACKCOND L_TRACKCOND;                     ///< only if Q_TRACKINIT == 0
  var::M_PLATFORM M_PLATFORM;                       ///< only if Q_TRACKINIT == 0
  var::Q_PLATFORM Q_PLATFORM;                       ///< only if Q_TRACKINIT == 0
  InplaceVector<Packet69_platforms, 31> platforms;  ///< only if Q_TRACKINIT == 0
  /// The element before the counter, in the form of the others.
  constexpr Packet69_platforms first_platforms() const { return {D_TRACKCOND, L_TRACKCOND, M_PLATFORM, Q_PLATFORM}; }
  friend constexpr bool operator==(const Packet69&, const Packet69&) = default;
};

template <>
inline constexpr auto layout_of<Packet69_platforms> = layout(&Packet69_platforms::D_TRACKCOND,
                                                             &Packet69_platforms::L_TRACKCOND,
                                                             &Packet69_platforms::M_PLATFORM,
                                                             &Packet69_platforms::Q_PLATFORM);

template <>
inline constexpr auto layout_of<Packet69> = layout(&Packet69::Q_DIR, &Packet69::Q_SCALE, &Packet69::Q_TRACKINIT,
                                                   when(&Packet69::Q_TRACKINIT, is(1), &Packet69::D_TRACKINIT),
                                                   when(&Packet69::Q_TRACKINIT, is(0), &Packet69::D_TRACKCOND,
                                                        &Packet69::L_TRACKCOND, &Packet69::M_PLATFORM,
                                                        &Packet69::Q_PLATFORM,
                                                        repeat<var::N_ITER>("platforms", &Packet69::platforms)));

}  // namespace evc::lang
