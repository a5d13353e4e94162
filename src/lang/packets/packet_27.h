#pragma once
#include "lang/variables.h"

namespace evc::lang {

struct Packet27_diffs {
  var::Q_DIFF Q_DIFF;
  var::NC_CDDIFF NC_CDDIFF;  ///< only if Q_DIFF == 0
  var::NC_DIFF NC_DIFF;      ///< only if Q_DIFF == 1 || Q_DIFF == 2
  var::V_DIFF V_DIFF;
  friend constexpr bool operator==(const Packet27_diffs&, const Packet27_diffs&) = default;
};

struct Packet27_steps {
  var::D_STATIC D_STATIC;
  var::V_STATIC V_STATIC;
  var::Q_FRONT Q_FRONT;
  InplaceVector<Packet27_diffs, 31> diffs;
  friend constexpr bool operator==(const Packet27_steps&, const Packet27_steps&) = default;
};

/// Packet 27, International static speed profile (7.4.2.7), system version 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet27 {
  static constexpr PacketInfo info{27,
                                   "International static speed profile",
                                   Direction::to_train,
                                   v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "7.4.2.7",
                                   "Q_DIFF = 3 is spare: neither category field"};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::D_STATIC D_STATIC;
  var::V_STATIC V_STATIC;
  var::Q_FRONT Q_FRONT;
  InplaceVector<Packet27_diffs, 31> diffs;
  InplaceVector<Packet27_steps, 31> steps;
  /// The element before the counter, in the form of the others.
  constexpr Packet27_steps first_steps() const { return {D_STATIC, V_STATIC, Q_FRONT, diffs}; }
  friend constexpr bool operator==(const Packet27&, const Packet27&) = default;
};

template <>
inline constexpr auto layout_of<Packet27_diffs> =
    layout(&Packet27_diffs::Q_DIFF, when(&Packet27_diffs::Q_DIFF, is(0), &Packet27_diffs::NC_CDDIFF),
           when(&Packet27_diffs::Q_DIFF, is(1, 2), &Packet27_diffs::NC_DIFF), &Packet27_diffs::V_DIFF);

template <>
inline constexpr auto layout_of<Packet27_steps> = layout(&Packet27_steps::D_STATIC, &Packet27_steps::V_STATIC,
                                                         &Packet27_steps::Q_FRONT,
                                                         repeat<var::N_ITER>("N_ITER_DIFF", "diffs",
                                                                             &Packet27_steps::diffs));

template <>
inline constexpr auto layout_of<Packet27> = layout(&Packet27::Q_DIR, &Packet27::Q_SCALE, &Packet27::D_STATIC,
                                                   &Packet27::V_STATIC, &Packet27::Q_FRONT,
                                                   repeat<var::N_ITER>("N_ITER_DIFF", "diffs", &Packet27::diffs),
                                                   repeat<var::N_ITER>("steps", &Packet27::steps));

struct Packet27_v1_0_diffs {
  var::NC_DIFF_V1 NC_DIFF;
  var::V_DIFF V_DIFF;
  friend constexpr bool operator==(const Packet27_v1_0_diffs&, const Packet27_v1_0_diffs&) = default;
};

struct Packet27_v1_0_steps {
  var::D_STATIC D_STATIC;
  var::V_STATIC V_STATIC;
  var::Q_FRONT Q_FRONT;
  InplaceVector<Packet27_v1_0_diffs, 31> diffs;
  friend constexpr bool operator==(const Packet27_v1_0_steps&, const Packet27_v1_0_steps&) = default;
};

/// Packet 27, International static speed profile (6.5.1.5.6), system version 1.0, 1.1.
struct Packet27_v1_0 {
  static constexpr PacketInfo info{27,
                                   "International static speed profile",
                                   Direction::to_train,
                                   v1_0 | v1_1,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "6.5.1.5.6",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::D_STATIC D_STATIC;
  var::V_STATIC V_STATIC;
  var::Q_FRONT Q_FRONT;
  InplaceVector<Packet27_v1_0_diffs, 31> diffs;
  InplaceVector<Packet27_v1_0_steps, 31> steps;
  /// The element before the counter, in the form of the others.
  constexpr Packet27_v1_0_steps first_steps() const { return {D_STATIC, V_STATIC, Q_FRONT, diffs}; }
  friend constexpr bool operator==(const Packet27_v1_0&, const Packet27_v1_0&) = default;
};

template <>
inline constexpr auto layout_of<Packet27_v1_0_diffs> = layout(named("NC_DIFF", &Packet27_v1_0_diffs::NC_DIFF),
                                                              &Packet27_v1_0_diffs::V_DIFF);

template <>
inline constexpr auto layout_of<Packet27_v1_0_steps> =
    layout(&Packet27_v1_0_steps::D_STATIC, &Packet27_v1_0_steps::V_STATIC, &Packet27_v1_0_steps::Q_FRONT,
           repeat<var::N_ITER>("N_ITER_DIFF", "diffs", &Packet27_v1_0_steps::diffs));

template <>
inline constexpr auto layout_of<Packet27_v1_0> =
    layout(&Packet27_v1_0::Q_DIR, &Packet27_v1_0::Q_SCALE, &Packet27_v1_0::D_STATIC, &Packet27_v1_0::V_STATIC,
           &Packet27_v1_0::Q_FRONT, repeat<var::N_ITER>("N_ITER_DIFF", "diffs", &Packet27_v1_0::diffs),
           repeat<var::N_ITER>("steps", &Packet27_v1_0::steps));

}  // namespace evc::lang
