#pragma once
#include "lang/variables.h"

namespace evc::lang {

struct Packet51_categories {
  var::M_AXLELOADCAT M_AXLELOADCAT;
  var::V_AXLELOAD V_AXLELOAD;
  friend constexpr bool operator==(const Packet51_categories&, const Packet51_categories&) = default;
};

struct Packet51_restrictions {
  var::D_AXLELOAD D_AXLELOAD;
  var::L_AXLELOAD L_AXLELOAD;
  var::Q_FRONT Q_FRONT;
  InplaceVector<Packet51_categories, 31> categories;
  friend constexpr bool operator==(const Packet51_restrictions&, const Packet51_restrictions&) = default;
};

/// Packet 51, Axle load speed profile (7.4.2.13), system version 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet51 {
  static constexpr PacketInfo info{51,
                                   "Axle load speed profile",
                                   Direction::to_train,
                                   v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "7.4.2.13",
                                   "X=3: for the very category; before: for it and those above (6.6.2.1.4)"};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::Q_TRACKINIT Q_TRACKINIT;
  var::D_TRACKINIT D_TRACKINIT;                           ///< only if Q_TRACKINIT == 1
  var::D_AXLELOAD D_AXLELOAD;                             ///< only if Q_TRACKINIT == 0
  var::L_AXLELOAD L_AXLELOAD;                             ///< only if Q_TRACKINIT == 0
  var::Q_FRONT Q_FRONT;                                   ///< only if Q_TRACKINIT == 0
  InplaceVector<Packet51_categories, 31> categories;      ///< only if Q_TRACKINIT == 0
  InplaceVector<Packet51_restrictions, 31> restrictions;  ///< only if Q_TRACKINIT == 0
  /// The element before the counter, in the form of the others.
  constexpr Packet51_restrictions first_restrictions() const { return {D_AXLELOAD, L_AXLELOAD, Q_FRONT, categories}; }
  friend constexpr bool operator==(const Packet51&, const Packet51&) = default;
};

template <>
inline constexpr auto layout_of<Packet51_categories> = layout(&Packet51_categories::M_AXLELOADCAT,
                                                              &Packet51_categories::V_AXLELOAD);

template <>
inline constexpr auto layout_of<Packet51_restrictions> =
    layout(&Packet51_restrictions::D_AXLELOAD, &Packet51_restrictions::L_AXLELOAD, &Packet51_restrictions::Q_FRONT,
           repeat<var::N_ITER>("N_ITER_CAT", "categories", &Packet51_restrictions::categories));

template <>
inline constexpr auto layout_of<Packet51> =
    layout(&Packet51::Q_DIR, &Packet51::Q_SCALE, &Packet51::Q_TRACKINIT,
           when(&Packet51::Q_TRACKINIT, is(1), &Packet51::D_TRACKINIT),
           when(&Packet51::Q_TRACKINIT, is(0), &Packet51::D_AXLELOAD, &Packet51::L_AXLELOAD, &Packet51::Q_FRONT,
                repeat<var::N_ITER>("N_ITER_CAT", "categories", &Packet51::categories),
                repeat<var::N_ITER>("restrictions", &Packet51::restrictions)));

struct Packet51_v1_0_categories {
  var::M_AXLELOAD M_AXLELOAD;
  var::V_AXLELOAD V_AXLELOAD;
  friend constexpr bool operator==(const Packet51_v1_0_categories&, const Packet51_v1_0_categories&) = default;
};

struct Packet51_v1_0_restrictions {
  var::D_AXLELOAD D_AXLELOAD;
  var::L_AXLELOAD L_AXLELOAD;
  var::Q_FRONT Q_FRONT;
  InplaceVector<Packet51_v1_0_categories, 31> categories;
  friend constexpr bool operator==(const Packet51_v1_0_restrictions&, const Packet51_v1_0_restrictions&) = default;
};

/// Packet 51, Axle load speed profile (6.5.1.5.10), system version 1.0, 1.1.
struct Packet51_v1_0 {
  static constexpr PacketInfo info{51,
                                   "Axle load speed profile",
                                   Direction::to_train,
                                   v1_0 | v1_1,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "6.5.1.5.10",
                                   "X=1 has no D_TRACKINIT: Q_TRACKINIT = 1 ends the packet"};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::Q_TRACKINIT Q_TRACKINIT;
  var::D_AXLELOAD D_AXLELOAD;                                  ///< only if Q_TRACKINIT == 0
  var::L_AXLELOAD L_AXLELOAD;                                  ///< only if Q_TRACKINIT == 0
  var::Q_FRONT Q_FRONT;                                        ///< only if Q_TRACKINIT == 0
  InplaceVector<Packet51_v1_0_categories, 31> categories;      ///< only if Q_TRACKINIT == 0
  InplaceVector<Packet51_v1_0_restrictions, 31> restrictions;  ///< only if Q_TRACKINIT == 0
  /// The element before the counter, in the form of the others.
  constexpr Packet51_v1_0_restrictions first_restrictions() const {
    return {D_AXLELOAD, L_AXLELOAD, Q_FRONT, categories};
  }
  friend constexpr bool operator==(const Packet51_v1_0&, const Packet51_v1_0&) = default;
};

template <>
inline constexpr auto layout_of<Packet51_v1_0_categories> = layout(&Packet51_v1_0_categories::M_AXLELOAD,
                                                                   &Packet51_v1_0_categories::V_AXLELOAD);

template <>
inline constexpr auto layout_of<Packet51_v1_0_restrictions> =
    layout(&Packet51_v1_0_restrictions::D_AXLELOAD, &Packet51_v1_0_restrictions::L_AXLELOAD,
           &Packet51_v1_0_restrictions::Q_FRONT,
           repeat<var::N_ITER>("N_ITER_CAT", "categories", &Packet51_v1_0_restrictions::categories));

template <>
inline constexpr auto layout_of<Packet51_v1_0> =
    layout(&Packet51_v1_0::Q_DIR, &Packet51_v1_0::Q_SCALE, &Packet51_v1_0::Q_TRACKINIT,
           when(&Packet51_v1_0::Q_TRACKINIT, is(0), &Packet51_v1_0::D_AXLELOAD, &Packet51_v1_0::L_AXLELOAD,
                &Packet51_v1_0::Q_FRONT, repeat<var::N_ITER>("N_ITER_CAT", "categories", &Packet51_v1_0::categories),
                repeat<var::N_ITER>("restrictions", &Packet51_v1_0::restrictions)));

}  // namespace evc::lang
