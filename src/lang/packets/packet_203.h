#pragma once
#include "lang/packets/packet_3.h"

namespace evc::lang {

/// Packet 203, National values for braking curves (6.5.1.5.22), system version 1.1.
struct Packet203 {
  static constexpr PacketInfo info{
      203,          "National values for braking curves", Direction::to_train, v1_1, media::balise | media::RBC,
      "6.5.1.5.22", "only together with packet 3"};
  var::Q_DIR Q_DIR;
  var::Q_NVGUIPERM Q_NVGUIPERM;
  var::Q_NVSBFBPERM Q_NVSBFBPERM;
  var::Q_NVINHSMICPERM Q_NVINHSMICPERM;
  var::A_NVMAXREDADH1 A_NVMAXREDADH1;
  var::A_NVMAXREDADH2 A_NVMAXREDADH2;
  var::A_NVMAXREDADH3 A_NVMAXREDADH3;
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
  constexpr Packet3_kv_steps first_kv_steps() const { return {V_NVKVINT, M_NVKVINT_A, M_NVKVINT_B}; }
  /// The element before the counter, in the form of the others.
  constexpr Packet3_kv_sets first_kv_sets() const {
    return {Q_NVKVINTSET, A_NVP12, A_NVP23, V_NVKVINT, M_NVKVINT_A, M_NVKVINT_B, kv_steps};
  }
  /// The element before the counter, in the form of the others.
  constexpr Packet3_kr_steps first_kr_steps() const { return {L_NVKRINT, M_NVKRINT}; }
  friend constexpr bool operator==(const Packet203&, const Packet203&) = default;
};

template <>
inline constexpr auto layout_of<Packet203> =
    layout(&Packet203::Q_DIR, &Packet203::Q_NVGUIPERM, &Packet203::Q_NVSBFBPERM, &Packet203::Q_NVINHSMICPERM,
           &Packet203::A_NVMAXREDADH1, &Packet203::A_NVMAXREDADH2, &Packet203::A_NVMAXREDADH3, &Packet203::M_NVAVADH,
           &Packet203::M_NVEBCL, &Packet203::Q_NVKINT,
           when(&Packet203::Q_NVKINT, is(1), &Packet203::Q_NVKVINTSET,
                when(&Packet203::Q_NVKVINTSET, is(1), &Packet203::A_NVP12, &Packet203::A_NVP23), &Packet203::V_NVKVINT,
                named("M_NVKVINT_A", &Packet203::M_NVKVINT_A),
                when(&Packet203::Q_NVKVINTSET, is(1), named("M_NVKVINT_B", &Packet203::M_NVKVINT_B)),
                repeat<var::N_ITER>("N_ITER_KV", "kv_steps", &Packet203::kv_steps),
                repeat<var::N_ITER>("N_ITER_KVSET", "kv_sets", &Packet203::kv_sets), &Packet203::L_NVKRINT,
                &Packet203::M_NVKRINT, repeat<var::N_ITER>("N_ITER_KR", "kr_steps", &Packet203::kr_steps),
                &Packet203::M_NVKTINT));

}  // namespace evc::lang
