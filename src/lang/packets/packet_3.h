#pragma once
#include "lang/variables.h"

namespace evc::lang {

struct Packet3_areas {
  var::NID_C NID_C;
  friend constexpr bool operator==(const Packet3_areas&, const Packet3_areas&) = default;
};

struct Packet3_kv_steps {
  var::V_NVKVINT V_NVKVINT;
  var::M_NVKVINT M_NVKVINT_A;
  var::M_NVKVINT M_NVKVINT_B;  ///< only if Q_NVKVINTSET == 1
  friend constexpr bool operator==(const Packet3_kv_steps&, const Packet3_kv_steps&) = default;
};

struct Packet3_kv_sets {
  var::Q_NVKVINTSET Q_NVKVINTSET;
  var::A_NVP12 A_NVP12;  ///< only if Q_NVKVINTSET == 1
  var::A_NVP23 A_NVP23;  ///< only if Q_NVKVINTSET == 1
  var::V_NVKVINT V_NVKVINT;
  var::M_NVKVINT M_NVKVINT_A;
  var::M_NVKVINT M_NVKVINT_B;  ///< only if Q_NVKVINTSET == 1
  InplaceVector<Packet3_kv_steps, 31> kv_steps;
  /// The element before the counter, in the form of the others.
  constexpr Packet3_kv_steps first_kv_steps() const { return {V_NVKVINT, M_NVKVINT_A, M_NVKVINT_B}; }
  friend constexpr bool operator==(const Packet3_kv_sets&, const Packet3_kv_sets&) = default;
};

struct Packet3_kr_steps {
  var::L_NVKRINT L_NVKRINT;
  var::M_NVKRINT M_NVKRINT;
  friend constexpr bool operator==(const Packet3_kr_steps&, const Packet3_kr_steps&) = default;
};

/// Packet 3, National values (7.4.2.1.1), system version 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet3 {
  static constexpr PacketInfo info{3,
                                   "National values",
                                   Direction::to_train,
                                   v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::RBC,
                                   "7.4.2.1.1",
                                   "Q_NVKINT = 1 guards everything from Q_NVKVINTSET to M_NVKTINT; first V_NVKVINT and "
                                   "first L_NVKRINT are 0 by rule"};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::D_VALIDNV D_VALIDNV;
  var::NID_C NID_C;
  InplaceVector<Packet3_areas, 31> areas;
  var::V_NVSHUNT V_NVSHUNT;
  var::V_NVSTFF V_NVSTFF;
  var::V_NVONSIGHT V_NVONSIGHT;
  var::V_NVLIMSUPERV V_NVLIMSUPERV;
  var::V_NVUNFIT V_NVUNFIT;
  var::V_NVREL V_NVREL;
  var::D_NVROLL D_NVROLL;
  var::Q_NVSBTSMPERM Q_NVSBTSMPERM;
  var::Q_NVEMRRLS Q_NVEMRRLS;
  var::Q_NVGUIPERM Q_NVGUIPERM;
  var::Q_NVSBFBPERM Q_NVSBFBPERM;
  var::Q_NVINHSMICPERM Q_NVINHSMICPERM;
  var::V_NVALLOWOVTRP V_NVALLOWOVTRP;
  var::V_NVSUPOVTRP V_NVSUPOVTRP;
  var::D_NVOVTRP D_NVOVTRP;
  var::T_NVOVTRP T_NVOVTRP;
  var::D_NVPOTRP D_NVPOTRP;
  var::M_NVCONTACT M_NVCONTACT;
  var::T_NVCONTACT T_NVCONTACT;
  var::M_NVDERUN M_NVDERUN;
  var::D_NVSTFF D_NVSTFF;
  var::Q_NVDRIVER_ADHES Q_NVDRIVER_ADHES;
  var::A_NVMAXREDADH1 A_NVMAXREDADH1;
  var::A_NVMAXREDADH2 A_NVMAXREDADH2;
  var::A_NVMAXREDADH3 A_NVMAXREDADH3;
  var::Q_NVLOCACC Q_NVLOCACC;
  var::M_NVAVADH M_NVAVADH;
  var::M_NVEBCL M_NVEBCL;
  var::Q_NVKINT Q_NVKINT;
  var::Q_NVKVINTSET Q_NVKVINTSET;                ///< only if Q_NVKINT == 1
  var::A_NVP12 A_NVP12;                          ///< only if Q_NVKINT == 1 && Q_NVKVINTSET == 1
  var::A_NVP23 A_NVP23;                          ///< only if Q_NVKINT == 1 && Q_NVKVINTSET == 1
  var::V_NVKVINT V_NVKVINT;                      ///< only if Q_NVKINT == 1
  var::M_NVKVINT M_NVKVINT_A;                    ///< only if Q_NVKINT == 1
  var::M_NVKVINT M_NVKVINT_B;                    ///< only if Q_NVKINT == 1 && Q_NVKVINTSET == 1
  InplaceVector<Packet3_kv_steps, 31> kv_steps;  ///< only if Q_NVKINT == 1
  InplaceVector<Packet3_kv_sets, 31> kv_sets;    ///< only if Q_NVKINT == 1
  var::L_NVKRINT L_NVKRINT;                      ///< only if Q_NVKINT == 1
  var::M_NVKRINT M_NVKRINT;                      ///< only if Q_NVKINT == 1
  InplaceVector<Packet3_kr_steps, 31> kr_steps;  ///< only if Q_NVKINT == 1
  var::M_NVKTINT M_NVKTINT;                      ///< only if Q_NVKINT == 1
  /// The element before the counter, in the form of the others.
  constexpr Packet3_areas first_areas() const { return {NID_C}; }
  /// The element before the counter, in the form of the others.
  constexpr Packet3_kv_steps first_kv_steps() const { return {V_NVKVINT, M_NVKVINT_A, M_NVKVINT_B}; }
  /// The element before the counter, in the form of the others.
  constexpr Packet3_kv_sets first_kv_sets() const {
    return {Q_NVKVINTSET, A_NVP12, A_NVP23, V_NVKVINT, M_NVKVINT_A, M_NVKVINT_B, kv_steps};
  }
  /// The element before the counter, in the form of the others.
  constexpr Packet3_kr_steps first_kr_steps() const { return {L_NVKRINT, M_NVKRINT}; }
  friend constexpr bool operator==(const Packet3&, const Packet3&) = default;
};

template <>
inline constexpr auto layout_of<Packet3_areas> = layout(&Packet3_areas::NID_C);

template <>
inline constexpr auto layout_of<Packet3_kv_steps> =
    layout(&Packet3_kv_steps::V_NVKVINT, named("M_NVKVINT_A", &Packet3_kv_steps::M_NVKVINT_A),
           when_around<var::Q_NVKVINTSET>(is(1), named("M_NVKVINT_B", &Packet3_kv_steps::M_NVKVINT_B)));

template <>
inline constexpr auto layout_of<Packet3_kv_sets> =
    layout(&Packet3_kv_sets::Q_NVKVINTSET,
           when(&Packet3_kv_sets::Q_NVKVINTSET, is(1), &Packet3_kv_sets::A_NVP12, &Packet3_kv_sets::A_NVP23),
           &Packet3_kv_sets::V_NVKVINT, named("M_NVKVINT_A", &Packet3_kv_sets::M_NVKVINT_A),
           when(&Packet3_kv_sets::Q_NVKVINTSET, is(1), named("M_NVKVINT_B", &Packet3_kv_sets::M_NVKVINT_B)),
           repeat<var::N_ITER>("N_ITER_KV", "kv_steps", &Packet3_kv_sets::kv_steps));

template <>
inline constexpr auto layout_of<Packet3_kr_steps> = layout(&Packet3_kr_steps::L_NVKRINT, &Packet3_kr_steps::M_NVKRINT);

template <>
inline constexpr auto layout_of<Packet3> = layout(
    &Packet3::Q_DIR, &Packet3::Q_SCALE, &Packet3::D_VALIDNV, &Packet3::NID_C,
    repeat<var::N_ITER>("N_ITER_C", "areas", &Packet3::areas), &Packet3::V_NVSHUNT, &Packet3::V_NVSTFF,
    &Packet3::V_NVONSIGHT, &Packet3::V_NVLIMSUPERV, &Packet3::V_NVUNFIT, &Packet3::V_NVREL, &Packet3::D_NVROLL,
    &Packet3::Q_NVSBTSMPERM, &Packet3::Q_NVEMRRLS, &Packet3::Q_NVGUIPERM, &Packet3::Q_NVSBFBPERM,
    &Packet3::Q_NVINHSMICPERM, &Packet3::V_NVALLOWOVTRP, &Packet3::V_NVSUPOVTRP, &Packet3::D_NVOVTRP,
    &Packet3::T_NVOVTRP, &Packet3::D_NVPOTRP, &Packet3::M_NVCONTACT, &Packet3::T_NVCONTACT, &Packet3::M_NVDERUN,
    &Packet3::D_NVSTFF, &Packet3::Q_NVDRIVER_ADHES, &Packet3::A_NVMAXREDADH1, &Packet3::A_NVMAXREDADH2,
    &Packet3::A_NVMAXREDADH3, &Packet3::Q_NVLOCACC, &Packet3::M_NVAVADH, &Packet3::M_NVEBCL, &Packet3::Q_NVKINT,
    when(&Packet3::Q_NVKINT, is(1), &Packet3::Q_NVKVINTSET,
         when(&Packet3::Q_NVKVINTSET, is(1), &Packet3::A_NVP12, &Packet3::A_NVP23), &Packet3::V_NVKVINT,
         named("M_NVKVINT_A", &Packet3::M_NVKVINT_A),
         when(&Packet3::Q_NVKVINTSET, is(1), named("M_NVKVINT_B", &Packet3::M_NVKVINT_B)),
         repeat<var::N_ITER>("N_ITER_KV", "kv_steps", &Packet3::kv_steps),
         repeat<var::N_ITER>("N_ITER_KVSET", "kv_sets", &Packet3::kv_sets), &Packet3::L_NVKRINT, &Packet3::M_NVKRINT,
         repeat<var::N_ITER>("N_ITER_KR", "kr_steps", &Packet3::kr_steps), &Packet3::M_NVKTINT));

/// Packet 3, National values (6.5.1.5.4), system version 1.0, 1.1.
struct Packet3_v1_0 {
  static constexpr PacketInfo info{
      3, "National values", Direction::to_train, v1_0 | v1_1, media::balise | media::RBC, "6.5.1.5.4", ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::D_VALIDNV_V1 D_VALIDNV;
  InplaceVector<Packet3_areas, 31> areas;
  var::V_NVSHUNT V_NVSHUNT;
  var::V_NVSTFF V_NVSTFF;
  var::V_NVONSIGHT V_NVONSIGHT;
  var::V_NVUNFIT V_NVUNFIT;
  var::V_NVREL V_NVREL;
  var::D_NVROLL D_NVROLL;
  var::Q_NVSRBKTRG Q_NVSRBKTRG;
  var::Q_NVEMRRLS Q_NVEMRRLS;
  var::V_NVALLOWOVTRP V_NVALLOWOVTRP;
  var::V_NVSUPOVTRP V_NVSUPOVTRP;
  var::D_NVOVTRP D_NVOVTRP;
  var::T_NVOVTRP T_NVOVTRP;
  var::D_NVPOTRP D_NVPOTRP;
  var::M_NVCONTACT M_NVCONTACT;
  var::T_NVCONTACT T_NVCONTACT;
  var::M_NVDERUN M_NVDERUN;
  var::D_NVSTFF D_NVSTFF;
  var::Q_NVDRIVER_ADHES Q_NVDRIVER_ADHES;
  friend constexpr bool operator==(const Packet3_v1_0&, const Packet3_v1_0&) = default;
};

template <>
inline constexpr auto layout_of<Packet3_v1_0> = layout(
    &Packet3_v1_0::Q_DIR, &Packet3_v1_0::Q_SCALE, named("D_VALIDNV", &Packet3_v1_0::D_VALIDNV),
    repeat<var::N_ITER>("N_ITER_C", "areas", &Packet3_v1_0::areas), &Packet3_v1_0::V_NVSHUNT, &Packet3_v1_0::V_NVSTFF,
    &Packet3_v1_0::V_NVONSIGHT, &Packet3_v1_0::V_NVUNFIT, &Packet3_v1_0::V_NVREL, &Packet3_v1_0::D_NVROLL,
    &Packet3_v1_0::Q_NVSRBKTRG, &Packet3_v1_0::Q_NVEMRRLS, &Packet3_v1_0::V_NVALLOWOVTRP, &Packet3_v1_0::V_NVSUPOVTRP,
    &Packet3_v1_0::D_NVOVTRP, &Packet3_v1_0::T_NVOVTRP, &Packet3_v1_0::D_NVPOTRP, &Packet3_v1_0::M_NVCONTACT,
    &Packet3_v1_0::T_NVCONTACT, &Packet3_v1_0::M_NVDERUN, &Packet3_v1_0::D_NVSTFF, &Packet3_v1_0::Q_NVDRIVER_ADHES);

}  // namespace evc::lang
