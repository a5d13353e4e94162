#include "kernel/intake/national_values.h"

#include "kernel/stored.h"
#include "lang/packets/packet_3.h"
#include "lang/si.h"

namespace evc::kernel {
namespace {

/// D_NVROLL 32767: unlimited.
constexpr Distance kInfinite{1e9};

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

void read_correction_factors(const lang::Packet3& p, train::NationalValues& nv) {
  if (p.Q_NVKINT.raw == 0) return;
  read_Kv(p.first_kv_sets(), nv);
  for (const auto& set : p.kv_sets) read_Kv(set, nv);
  nv.Kr_int = table_of<train::NationalValues::Kr>(
      p.first_kr_steps(), p.kr_steps, [](const auto& s) { return lang::metres(s.L_NVKRINT); },
      [](const auto& s) { return lang::factor(s.M_NVKRINT); });
  nv.Kt_int = lang::factor(p.M_NVKTINT);
}

}  // namespace

ReceivedNationalValues read(const lang::Packet3& p) {
  ReceivedNationalValues received;
  train::NationalValues& nv = received.values;
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
  nv.D_NVROLL = D_NVROLL ? *D_NVROLL : kInfinite;
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
  nv.Q_NVGUIPERM = p.Q_NVGUIPERM.raw != 0;
  nv.Q_NVSBFBPERM = p.Q_NVSBFBPERM.raw != 0;
  nv.Q_NVINHSMICPERM = p.Q_NVINHSMICPERM.raw != 0;
  nv.A_NVMAXREDADH1 = max_reduced(static_cast<std::uint8_t>(p.A_NVMAXREDADH1.raw));
  nv.A_NVMAXREDADH2 = max_reduced(static_cast<std::uint8_t>(p.A_NVMAXREDADH2.raw));
  nv.A_NVMAXREDADH3 = max_reduced(static_cast<std::uint8_t>(p.A_NVMAXREDADH3.raw));
  nv.M_NVAVADH = lang::factor(p.M_NVAVADH);
  nv.M_NVEBCL = static_cast<std::uint8_t>(p.M_NVEBCL.raw);
  read_correction_factors(p, nv);

  const std::optional<Distance> D_VALIDNV = lang::metres(p.Q_SCALE, p.D_VALIDNV);
  received.D_VALIDNV = D_VALIDNV;
  bool room = received.areas.push_back(p.NID_C.raw);
  for (const auto& area : p.areas) room = room && received.areas.push_back(area.NID_C.raw);
  return received;
}

void use_national_values(State& state, const train::NationalValues& values,
                         const InplaceVector<std::uint16_t, 32>& areas) {
  state.national_values = values;
  state.national_areas = areas;
  follow_national_SR_distance(state);
  ++state.revision;
}

void advance_national_values(Reception& r) {
  State& s = r.state;
  if (!s.pending_national_values || r.out.here.est_front < s.pending_national_values->from) return;
  use_national_values(s, s.pending_national_values->values, s.pending_national_values->areas);
  s.pending_national_values.reset();
  r.log.note({.what = What::national_values_in_force, .clause = "3.18.2.3"_srs});
}

void leave_area(Reception& r, std::uint16_t NID_C) {
  State& s = r.state;
  if (s.national_areas.empty()) return;
  for (const std::uint16_t area : s.national_areas)
    if (area == NID_C) return;
  use_national_values(s, train::NationalValues{}, {});
  r.log.note({.what = What::national_values_default, .clause = "3.18.2.5"_srs});
}

}  // namespace evc::kernel
