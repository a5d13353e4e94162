#include "kernel/intake/national_values.h"

#include "kernel/stored.h"
#include "lang/decode.h"
#include "lang/packets/packet_203.h"
#include "lang/packets/packet_3.h"
#include "lang/si.h"
#include "terms/packet_numbers.h"

namespace evc::kernel {
namespace {

/// V_NV...: 126 and 127 are spare; the codec has rejected them before, here they give the default.
template <class V>
void take(Speed& to, V v) {
  if (const auto speed = lang::speed(v)) to = *speed;
}

train::MaxReducedAdhesion max_reduced(std::uint8_t raw) {
  using train::MaxReducedAdhesion;
  // 7.5.1.2: 61, 62, 63 set no maximum and differ in what is displayed.
  if (raw == 61) return MaxReducedAdhesion::without_maximum(MaxReducedAdhesion::Display::target_information);
  if (raw == 62) return MaxReducedAdhesion::without_maximum(MaxReducedAdhesion::Display::time_to_indication);
  if (raw == 63) return MaxReducedAdhesion::without_maximum(MaxReducedAdhesion::Display::none);
  return MaxReducedAdhesion::at_most({static_cast<double>(raw) / 20.0});
}

Speed step_speed(lang::var::V_NVKVINT v) { return Speed{static_cast<double>(v.raw * 5u) / 3.6}; }

double lower(double a, double b) { return b < a ? b : a; }
train::KvPair lower(const train::KvPair& a, const train::KvPair& b) { return {lower(a.a, b.a), lower(a.b, b.b)}; }

/// The steps of a packet as a table. Where there are more than there is room for (3.13.2.3.7.11): the lowest of them
/// everywhere.
template <class Table, class Step, class Steps, class At, class Value>
Table table_of(const Step& first, const Steps& further, At at, Value value) {
  Table table;
  auto lowest = value(first);
  bool room = table.append(at(first), lowest);
  for (const auto& step : further) {
    const auto of_step = value(step);
    room = room && table.append(at(step), of_step);
    lowest = lower(lowest, of_step);
  }
  if (room) return table;
  table = {};
  (void)table.append({}, lowest);
  return table;
}

/// Correction factors Kv_int: sets for freight and conventional passenger trains (A.3.7).
void read_Kv(const lang::Packet3_kv_sets& set, train::NationalValues& nv) {
  const auto first = set.first_kv_steps();
  const auto at = [](const auto& s) { return step_speed(s.V_NVKVINT); };
  if (set.Q_NVKVINTSET.raw == 0) {
    nv.Kv_int_freight = table_of<train::NationalValues::KvFreight>(
        first, set.kv_steps, at, [](const auto& s) { return lang::factor(s.M_NVKVINT_A); });
    return;
  }
  nv.A_NVP12 = lang::acceleration(set.A_NVP12);
  nv.A_NVP23 = lang::acceleration(set.A_NVP23);
  nv.Kv_int_passenger = table_of<train::NationalValues::KvPassenger>(first, set.kv_steps, at, [](const auto& s) {
    return train::KvPair{lang::factor(s.M_NVKVINT_A), lang::factor(s.M_NVKVINT_B)};
  });
}

template <class P>
void read_correction_factors(const P& p, train::NationalValues& nv) {
  if (p.Q_NVKINT.raw == 0) return;
  read_Kv(p.first_kv_sets(), nv);
  for (const auto& set : p.kv_sets) read_Kv(set, nv);
  nv.Kr_int = table_of<train::NationalValues::Kr>(
      p.first_kr_steps(), p.kr_steps, [](const auto& s) { return lang::metres(s.L_NVKRINT); },
      [](const auto& s) { return lang::factor(s.M_NVKRINT); });
  nv.Kt_int = lang::factor(p.M_NVKTINT);
}

/// What packet 203 and packet 3 of X = 2 have in common.
template <class P>
void read_braking(const P& p, train::NationalValues& nv) {
  nv.Q_NVGUIPERM = p.Q_NVGUIPERM.raw != 0;
  nv.Q_NVSBFBPERM = p.Q_NVSBFBPERM.raw != 0;
  nv.Q_NVINHSMICPERM = p.Q_NVINHSMICPERM.raw != 0;
  nv.A_NVMAXREDADH1 = max_reduced(static_cast<std::uint8_t>(p.A_NVMAXREDADH1.raw));
  nv.A_NVMAXREDADH2 = max_reduced(static_cast<std::uint8_t>(p.A_NVMAXREDADH2.raw));
  nv.A_NVMAXREDADH3 = max_reduced(static_cast<std::uint8_t>(p.A_NVMAXREDADH3.raw));
  nv.M_NVAVADH = lang::factor(p.M_NVAVADH);
  nv.M_NVEBCL = static_cast<std::uint8_t>(p.M_NVEBCL.raw);
  read_correction_factors(p, nv);
}

/// Introduced with X = 2 (6.6.3.2.3 [1a], [1b]).
void copy_of_X_2(const train::NationalValues& from, train::NationalValues& to) {
  to.Q_NVLOCACC = from.Q_NVLOCACC;
  to.V_NVLIMSUPERV = from.V_NVLIMSUPERV;
}
/// Those for braking curves, introduced with version 1.1 (6.6.3.2.3 [2]).
void copy_braking(const train::NationalValues& from, train::NationalValues& to) {
  to.Q_NVGUIPERM = from.Q_NVGUIPERM;
  to.Q_NVSBFBPERM = from.Q_NVSBFBPERM;
  to.Q_NVINHSMICPERM = from.Q_NVINHSMICPERM;
  to.M_NVEBCL = from.M_NVEBCL;
  to.M_NVAVADH = from.M_NVAVADH;
  to.A_NVMAXREDADH1 = from.A_NVMAXREDADH1;
  to.A_NVMAXREDADH2 = from.A_NVMAXREDADH2;
  to.A_NVMAXREDADH3 = from.A_NVMAXREDADH3;
  to.Kv_int_freight = from.Kv_int_freight;
  to.Kv_int_passenger = from.Kv_int_passenger;
  to.A_NVP12 = from.A_NVP12;
  to.A_NVP23 = from.A_NVP23;
  to.Kr_int = from.Kr_int;
  to.Kt_int = from.Kt_int;
}

bool outside(const NationalAreas& areas, std::uint16_t NID_C) {
  for (const std::uint16_t area : areas)
    if (area == NID_C) return false;
  return !areas.empty();
}

/// The values are other ones from now on.
void put_in_force(State& state, const train::NationalValues& values) {
  state.national_values = values;
  follow_national_SR_distance(state);
  // 3.18.4.6.2.1: what the driver may not change any more is reset; adhesion profiles stay.
  if (!values.Q_NVDRIVER_ADHES) state.slippery_rail = false;
  ++state.revision;
}

}  // namespace

std::optional<Distance> start_of_validity(const lang::Packet3& p, std::uint8_t X) {
  if (X == 1) return lang::metres(p.Q_SCALE, lang::var::D_VALIDNV_V1{p.D_VALIDNV.raw});
  return lang::metres(p.Q_SCALE, p.D_VALIDNV);
}

ReceivedNationalValues read(const lang::Packet3& p, std::uint8_t X) {
  ReceivedNationalValues received;
  train::NationalValues& nv = received.set.values;
  take(nv.V_NVSHUNT, p.V_NVSHUNT);
  take(nv.V_NVSTFF, p.V_NVSTFF);
  take(nv.V_NVONSIGHT, p.V_NVONSIGHT);
  take(nv.V_NVLIMSUPERV, p.V_NVLIMSUPERV);
  take(nv.V_NVUNFIT, p.V_NVUNFIT);
  take(nv.V_NVREL, p.V_NVREL);
  take(nv.V_NVALLOWOVTRP, p.V_NVALLOWOVTRP);
  take(nv.V_NVSUPOVTRP, p.V_NVSUPOVTRP);
  // Only D_NVROLL and D_NVSTFF have a code for infinity (7.5.1.17, 7.5.1.18).
  const std::optional<Distance> D_NVROLL = lang::metres(p.Q_SCALE, p.D_NVROLL);
  nv.D_NVROLL = D_NVROLL ? *D_NVROLL : train::kUnlimited;
  nv.D_NVOVTRP = lang::metres(p.Q_SCALE, p.D_NVOVTRP);
  nv.D_NVPOTRP = lang::metres(p.Q_SCALE, p.D_NVPOTRP);
  nv.D_NVSTFF = lang::metres(p.Q_SCALE, p.D_NVSTFF);
  nv.T_NVOVTRP = lang::seconds(p.T_NVOVTRP);
  nv.T_NVCONTACT = lang::seconds(p.T_NVCONTACT);
  nv.Q_NVLOCACC = lang::metres(p.Q_NVLOCACC);
  nv.M_NVCONTACT = reaction_of(p.M_NVCONTACT.raw).value_or(Reaction::trip);
  nv.M_NVDERUN = p.M_NVDERUN.raw != 0;
  nv.Q_NVDRIVER_ADHES = p.Q_NVDRIVER_ADHES.raw != 0;
  nv.Q_NVSBTSMPERM = p.Q_NVSBTSMPERM.raw != 0;
  nv.Q_NVEMRRLS = p.Q_NVEMRRLS.raw != 0;
  read_braking(p, nv);

  received.D_VALIDNV = start_of_validity(p, X);
  bool room = received.set.areas.push_back(p.NID_C.raw);
  for (const auto& area : p.areas) room = room && received.set.areas.push_back(area.NID_C.raw);
  return received;
}

bool join_braking_curves(const Information& information, train::NationalValues& values) {
  for (const lang::PacketView& view : information.packets) {
    lang::Packet203 p;
    if (view.NID_PACKET != packet::national_values_v1 || lang::decode(view, p) != lang::Fault::none) continue;
    read_braking(p, values);
    return true;
  }
  return false;
}

void use_national_values(State& state, const NationalSet& set) {
  train::NationalValues values = set.values;
  if (!set.of_X_2) copy_of_X_2(state.national_values, values);
  if (!set.braking) copy_braking(state.national_values, values);
  put_in_force(state, values);
  state.national_areas = set.areas;
  if (set.of_X_2) state.national_areas_of_X_2 = set.areas;
  if (set.braking) state.national_areas_of_braking = set.areas;
}

void advance_national_values(Reception& r) {
  State& s = r.state;
  if (!s.pending_national_values || r.out.here.est_front < s.pending_national_values->from) return;
  use_national_values(s, s.pending_national_values->set);
  s.pending_national_values.reset();
  r.log.note({.what = What::national_values_in_force, .clause = "3.18.2.3"_srs});
}

bool in_another_country(const State& state, std::uint16_t NID_C) { return outside(state.national_areas, NID_C); }

void leave_area(Reception& r, std::uint16_t NID_C) {
  State& s = r.state;
  const bool of_X_2 = outside(s.national_areas_of_X_2, NID_C);
  const bool braking = outside(s.national_areas_of_braking, NID_C);
  const bool others = in_another_country(s, NID_C);
  if (!of_X_2 && !braking && !others) return;
  static constexpr train::NationalValues kDefaults{};
  train::NationalValues values = others ? kDefaults : s.national_values;
  copy_of_X_2(of_X_2 ? kDefaults : s.national_values, values);
  copy_braking(braking ? kDefaults : s.national_values, values);
  put_in_force(s, values);
  if (of_X_2) s.national_areas_of_X_2.clear();
  if (braking) s.national_areas_of_braking.clear();
  if (others) s.national_areas.clear();
  r.log.note({.what = What::national_values_default, .clause = "3.18.2.5"_srs});
}

}  // namespace evc::kernel
