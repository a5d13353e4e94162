#pragma once
#include "lang/variables.h"

namespace evc::lang {

struct Packet70_points {
  var::D_SUITABILITY D_SUITABILITY;
  var::Q_SUITABILITY Q_SUITABILITY;
  var::M_LINEGAUGE M_LINEGAUGE;      ///< only if Q_SUITABILITY == 0
  var::M_AXLELOADCAT M_AXLELOADCAT;  ///< only if Q_SUITABILITY == 1
  var::M_VOLTAGE M_VOLTAGE;          ///< only if Q_SUITABILITY == 2
  var::NID_CTRACTION NID_CTRACTION;  ///< only if Q_SUITABILITY == 2 && M_VOLTAGE != 0
  friend constexpr bool operator==(const Packet70_points&, const Packet70_points&) = default;
};

/// Packet 70, Route suitability (7.4.2.21), system version 2.0, 2.1, 2.2, 2.3.
struct Packet70 {
  static constexpr PacketInfo info{70,
                                   "Route suitability",
                                   Direction::to_train,
                                   v2_0 | v2_1 | v2_2 | v2_3,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "7.4.2.21",
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
  friend constexpr bool operator==(const Packet70&, const Packet70&) = default;
};

template <>
inline constexpr auto layout_of<Packet70_points> =
    layout(&Packet70_points::D_SUITABILITY, &Packet70_points::Q_SUITABILITY,
           when(&Packet70_points::Q_SUITABILITY, is(0), &Packet70_points::M_LINEGAUGE),
           when(&Packet70_points::Q_SUITABILITY, is(1), &Packet70_points::M_AXLELOADCAT),
           when(&Packet70_points::Q_SUITABILITY, is(2), &Packet70_points::M_VOLTAGE,
                when(&Packet70_points::M_VOLTAGE, is_not(0), &Packet70_points::NID_CTRACTION)));

template <>
inline constexpr auto layout_of<Packet70> =
    layout(&Packet70::Q_DIR, &Packet70::Q_SCALE, &Packet70::Q_TRACKINIT,
           when(&Packet70::Q_TRACKINIT, is(1), &Packet70::D_TRACKINIT),
           when(&Packet70::Q_TRACKINIT, is(0), &Packet70::D_SUITABILITY, &Packet70::Q_SUITABILITY,
                when(&Packet70::Q_SUITABILITY, is(0), &Packet70::M_LINEGAUGE),
                when(&Packet70::Q_SUITABILITY, is(1), &Packet70::M_AXLELOADCAT),
                when(&Packet70::Q_SUITABILITY, is(2), &Packet70::M_VOLTAGE,
                     when(&Packet70::M_VOLTAGE, is_not(0), &Packet70::NID_CTRACTION)),
                repeat<var::N_ITER>("points", &Packet70::points)));

struct Packet70_v3_0_points {
  var::D_SUITABILITY D_SUITABILITY;
  var::Q_SUITABILITY Q_SUITABILITY;
  var::M_LINEGAUGE M_LINEGAUGE;              ///< only if Q_SUITABILITY == 0
  var::M_LINEAXLELOADCAT M_LINEAXLELOADCAT;  ///< only if Q_SUITABILITY == 1
  var::M_VOLTAGE M_VOLTAGE;                  ///< only if Q_SUITABILITY == 2
  var::NID_CTRACTION NID_CTRACTION;          ///< only if Q_SUITABILITY == 2 && M_VOLTAGE != 0
  friend constexpr bool operator==(const Packet70_v3_0_points&, const Packet70_v3_0_points&) = default;
};

/// Packet 70, Route suitability (7.4.2.21), system version 3.0.
struct Packet70_v3_0 {
  static constexpr PacketInfo info{70,
                                   "Route suitability",
                                   Direction::to_train,
                                   v3_0,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "7.4.2.21",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::Q_TRACKINIT Q_TRACKINIT;
  var::D_TRACKINIT D_TRACKINIT;                    ///< only if Q_TRACKINIT == 1
  var::D_SUITABILITY D_SUITABILITY;                ///< only if Q_TRACKINIT == 0
  var::Q_SUITABILITY Q_SUITABILITY;                ///< only if Q_TRACKINIT == 0
  var::M_LINEGAUGE M_LINEGAUGE;                    ///< only if Q_TRACKINIT == 0 && Q_SUITABILITY == 0
  var::M_LINEAXLELOADCAT M_LINEAXLELOADCAT;        ///< only if Q_TRACKINIT == 0 && Q_SUITABILITY == 1
  var::M_VOLTAGE M_VOLTAGE;                        ///< only if Q_TRACKINIT == 0 && Q_SUITABILITY == 2
  var::NID_CTRACTION NID_CTRACTION;                ///< only if Q_TRACKINIT == 0 && Q_SUITABILITY == 2 && M_VOLTAGE != 0
  InplaceVector<Packet70_v3_0_points, 31> points;  ///< only if Q_TRACKINIT == 0
  /// The element before the counter, in the form of the others.
  constexpr Packet70_v3_0_points first_points() const {
    return {D_SUITABILITY, Q_SUITABILITY, M_LINEGAUGE, M_LINEAXLELOADCAT, M_VOLTAGE, NID_CTRACTION};
  }
  friend constexpr bool operator==(const Packet70_v3_0&, const Packet70_v3_0&) = default;
};

template <>
inline constexpr auto layout_of<Packet70_v3_0_points> =
    layout(&Packet70_v3_0_points::D_SUITABILITY, &Packet70_v3_0_points::Q_SUITABILITY,
           when(&Packet70_v3_0_points::Q_SUITABILITY, is(0), &Packet70_v3_0_points::M_LINEGAUGE),
           when(&Packet70_v3_0_points::Q_SUITABILITY, is(1), &Packet70_v3_0_points::M_LINEAXLELOADCAT),
           when(&Packet70_v3_0_points::Q_SUITABILITY, is(2), &Packet70_v3_0_points::M_VOLTAGE,
                when(&Packet70_v3_0_points::M_VOLTAGE, is_not(0), &Packet70_v3_0_points::NID_CTRACTION)));

template <>
inline constexpr auto layout_of<Packet70_v3_0> =
    layout(&Packet70_v3_0::Q_DIR, &Packet70_v3_0::Q_SCALE, &Packet70_v3_0::Q_TRACKINIT,
           when(&Packet70_v3_0::Q_TRACKINIT, is(1), &Packet70_v3_0::D_TRACKINIT),
           when(&Packet70_v3_0::Q_TRACKINIT, is(0), &Packet70_v3_0::D_SUITABILITY, &Packet70_v3_0::Q_SUITABILITY,
                when(&Packet70_v3_0::Q_SUITABILITY, is(0), &Packet70_v3_0::M_LINEGAUGE),
                when(&Packet70_v3_0::Q_SUITABILITY, is(1), &Packet70_v3_0::M_LINEAXLELOADCAT),
                when(&Packet70_v3_0::Q_SUITABILITY, is(2), &Packet70_v3_0::M_VOLTAGE,
                     when(&Packet70_v3_0::M_VOLTAGE, is_not(0), &Packet70_v3_0::NID_CTRACTION)),
                repeat<var::N_ITER>("points", &Packet70_v3_0::points)));

struct Packet70_v1_0_points {
  var::D_SUITABILITY D_SUITABILITY;
  var::Q_SUITABILITY Q_SUITABILITY;
  var::M_LOADINGGAUGE_V1 M_LOADINGGAUGE;  ///< only if Q_SUITABILITY == 0
  var::M_AXLELOAD M_AXLELOAD;             ///< only if Q_SUITABILITY == 1
  var::M_TRACTION M_TRACTION;             ///< only if Q_SUITABILITY == 2
  friend constexpr bool operator==(const Packet70_v1_0_points&, const Packet70_v1_0_points&) = default;
};

/// Packet 70, Route suitability (6.5.1.5.14; gauge field from SRS 2.3.0), system version 1.0, 1.1.
struct Packet70_v1_0 {
  static constexpr PacketInfo info{
      70,
      "Route suitability",
      Direction::to_train,
      v1_0 | v1_1,
      media::balise | media::loop | media::RBC | media::RIU,
      "6.5.1.5.14; gauge field from SRS 2.3.0",
      "gauge branch only in SRS 2.3.0 (SV 1.0); SRS >= 3.3.0 forbids sending Q_SUITABILITY = 0 here"};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::Q_TRACKINIT Q_TRACKINIT;
  var::D_TRACKINIT D_TRACKINIT;                    ///< only if Q_TRACKINIT == 1
  var::D_SUITABILITY D_SUITABILITY;                ///< only if Q_TRACKINIT == 0
  var::Q_SUITABILITY Q_SUITABILITY;                ///< only if Q_TRACKINIT == 0
  var::M_LOADINGGAUGE_V1 M_LOADINGGAUGE;           ///< only if Q_TRACKINIT == 0 && Q_SUITABILITY == 0
  var::M_AXLELOAD M_AXLELOAD;                      ///< only if Q_TRACKINIT == 0 && Q_SUITABILITY == 1
  var::M_TRACTION M_TRACTION;                      ///< only if Q_TRACKINIT == 0 && Q_SUITABILITY == 2
  InplaceVector<Packet70_v1_0_points, 31> points;  ///< only if Q_TRACKINIT == 0
  /// The element before the counter, in the form of the others.
  constexpr Packet70_v1_0_points first_points() const {
    return {D_SUITABILITY, Q_SUITABILITY, M_LOADINGGAUGE, M_AXLELOAD, M_TRACTION};
  }
  friend constexpr bool operator==(const Packet70_v1_0&, const Packet70_v1_0&) = default;
};

template <>
inline constexpr auto layout_of<Packet70_v1_0_points> = layout(
    &Packet70_v1_0_points::D_SUITABILITY, &Packet70_v1_0_points::Q_SUITABILITY,
    when(&Packet70_v1_0_points::Q_SUITABILITY, is(0), named("M_LOADINGGAUGE", &Packet70_v1_0_points::M_LOADINGGAUGE)),
    when(&Packet70_v1_0_points::Q_SUITABILITY, is(1), &Packet70_v1_0_points::M_AXLELOAD),
    when(&Packet70_v1_0_points::Q_SUITABILITY, is(2), &Packet70_v1_0_points::M_TRACTION));

template <>
inline constexpr auto layout_of<Packet70_v1_0> =
    layout(&Packet70_v1_0::Q_DIR, &Packet70_v1_0::Q_SCALE, &Packet70_v1_0::Q_TRACKINIT,
           when(&Packet70_v1_0::Q_TRACKINIT, is(1), &Packet70_v1_0::D_TRACKINIT),
           when(&Packet70_v1_0::Q_TRACKINIT, is(0), &Packet70_v1_0::D_SUITABILITY, &Packet70_v1_0::Q_SUITABILITY,
                when(&Packet70_v1_0::Q_SUITABILITY, is(0), named("M_LOADINGGAUGE", &Packet70_v1_0::M_LOADINGGAUGE)),
                when(&Packet70_v1_0::Q_SUITABILITY, is(1), &Packet70_v1_0::M_AXLELOAD),
                when(&Packet70_v1_0::Q_SUITABILITY, is(2), &Packet70_v1_0::M_TRACTION),
                repeat<var::N_ITER>("points", &Packet70_v1_0::points)));

}  // namespace evc::lang
