#pragma once
#include "lang/packets/packet_70.h"

namespace evc::lang {

/// Packet 207, Route suitability (6.5.1.5.24), system version 1.1.
struct Packet207 {
  static constexpr PacketInfo info{207,
                                   "Route suitability",
                                   Direction::to_train,
                                   v1_1,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "6.5.1.5.24",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::Q_TRACKINIT Q_TRACKINIT;
  var::D_TRACKINIT D_TRACKINIT;               ///< only if Q_TRACKINIT == 1
  var::D_SUITABILITY D_SUITABILITY;           ///< only if Q_TRACKINIT == 0
  var::Q_SUITABILITY Q_SUITABILITY;           ///< only if Q_TRACKINIT == 0
  var::M_LINEGAUGE M_LINEGAUGE;               ///< only if Q_TRACKINIT == 0 && Q_SUITABILITY == 0
  var::M_AXLELOADCAT M_AXLELOADCAT;           ///< only if Q_TRACKINIT == 0 && Q_SUITABILITY == 1
  var::M_VOLTAGE M_VOLTAGE;                   ///< only if Q_TRACKINIT == 0 && Q_SUITABILITY == 2
  var::NID_CTRACTION NID_CTRACTION;           ///< only if Q_TRACKINIT == 0 && Q_SUITABILITY == 2 && M_VOLTAGE != 0
  InplaceVector<Packet70_points, 31> points;  ///< only if Q_TRACKINIT == 0
  /// The element before the counter, in the form of the others.
  constexpr Packet70_points first_points() const {
    return {D_SUITABILITY, Q_SUITABILITY, M_LINEGAUGE, M_AXLELOADCAT, M_VOLTAGE, NID_CTRACTION};
  }
  friend constexpr bool operator==(const Packet207&, const Packet207&) = default;
};

template <>
inline constexpr auto layout_of<Packet207> =
    layout(&Packet207::Q_DIR, &Packet207::Q_SCALE, &Packet207::Q_TRACKINIT,
           when(&Packet207::Q_TRACKINIT, is(1), &Packet207::D_TRACKINIT),
           when(&Packet207::Q_TRACKINIT, is(0), &Packet207::D_SUITABILITY, &Packet207::Q_SUITABILITY,
                when(&Packet207::Q_SUITABILITY, is(0), &Packet207::M_LINEGAUGE),
                when(&Packet207::Q_SUITABILITY, is(1), &Packet207::M_AXLELOADCAT),
                when(&Packet207::Q_SUITABILITY, is(2), &Packet207::M_VOLTAGE,
                     when(&Packet207::M_VOLTAGE, is_not(0), &Packet207::NID_CTRACTION)),
                repeat<var::N_ITER>("points", &Packet207::points)));

}  // namespace evc::lang
