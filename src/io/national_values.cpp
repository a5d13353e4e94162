#include <algorithm>
#include <cmath>

#include "io/refuse.h"
#include "io/steps.h"
#include "io/train_file.h"
#include "lang/packets/packet_3.h"
#include "terms/srs_version.h"

namespace evc::io {
namespace {

using train::NationalValues;
/// Ranges of the variables.
constexpr Clause kRanges = "7.5.1"_srs;
constexpr double kLongestDistance = 327670.0;

constexpr std::initializer_list<const char*> kKeys = {
    "V_NVSHUNT",      "V_NVSTFF",       "V_NVONSIGHT",      "V_NVLIMSUPERV",  "V_NVUNFIT", "V_NVREL",
    "V_NVALLOWOVTRP", "V_NVSUPOVTRP",   "D_NVROLL",         "D_NVOVTRP",      "D_NVPOTRP", "D_NVSTFF",
    "T_NVOVTRP",      "T_NVCONTACT",    "Q_NVLOCACC",       "M_NVCONTACT",    "M_NVDERUN", "Q_NVDRIVER_ADHES",
    "Q_NVSBTSMPERM",  "Q_NVEMRRLS",     "Q_NVGUIPERM",      "Q_NVSBFBPERM",   "M_NVEBCL",  "Q_NVINHSMICPERM",
    "M_NVAVADH",      "A_NVMAXREDADH1", "A_NVMAXREDADH2",   "A_NVMAXREDADH3", "A_NVP12",   "A_NVP23",
    "Kv_int_freight", "Kr_int",         "Kv_int_passenger", "Kt_int",
};

void read_speed(Speed& v, const JsonPlace& place, const char* key) {
  if (const auto p = place.find(key)) v = {p->number(0.0, 600.0, kRanges) / kKmh};
}
void read_distance(Distance& d, const JsonPlace& place, const char* key) {
  if (const auto p = place.find(key)) d = {p->number(0.0, kLongestDistance, kRanges)};
}
void read_flag(bool& flag, const JsonPlace& place, const char* key) {
  if (const auto p = place.find(key)) flag = p->boolean();
}
void read_acceleration(Acceleration& a, const JsonPlace& place, const char* key) {
  if (const auto p = place.find(key)) a = {p->number(0.0, 10.0, train::clause(train::Fault::A_NVP))};
}
bool is_infinity(const JsonPlace& p) { return p.is_null() || (p.is_string() && p.string() == "infinity"); }

/// A number in m/s2, or the kind of display with "no maximum".
void read_reduced_adhesion(train::MaxReducedAdhesion& a, const JsonPlace& place, const char* key) {
  using train::MaxReducedAdhesion;
  const auto p = place.find(key);
  if (!p) return;
  if (p->is_string()) {
    const std::size_t shown =
        p->one_of({"no maximum", "no maximum, target information", "no maximum, time to indication"});
    a = MaxReducedAdhesion::without_maximum(static_cast<MaxReducedAdhesion::Display>(shown));
  } else {
    a = MaxReducedAdhesion::at_most({number_or(*p, 0.0, 3.15, train::Fault::A_NVMAXREDADH)});
  }
}

void read_brake_values(NationalValues& nv, const JsonPlace& place) {
  if (const auto p = place.find("M_NVEBCL"))
    nv.M_NVEBCL = static_cast<std::uint8_t>(p->integer(0, 9, train::clause(train::Fault::M_NVEBCL)));
  if (const auto p = place.find("M_NVAVADH")) nv.M_NVAVADH = number_or(*p, 0.0, 1.0, train::Fault::M_NVAVADH);
  read_reduced_adhesion(nv.A_NVMAXREDADH1, place, "A_NVMAXREDADH1");
  read_reduced_adhesion(nv.A_NVMAXREDADH2, place, "A_NVMAXREDADH2");
  read_reduced_adhesion(nv.A_NVMAXREDADH3, place, "A_NVMAXREDADH3");
  read_acceleration(nv.A_NVP12, place, "A_NVP12");
  read_acceleration(nv.A_NVP23, place, "A_NVP23");
  if (const auto p = place.find("Kt_int")) nv.Kt_int = number_or(*p, 0.0, 1.55, train::Fault::Kt_int);
  if (const auto p = place.find("Kr_int"))
    nv.Kr_int = read_steps<NationalValues::Kr>(*p, 1.0, train::clause(train::Fault::Kr_int), [](const JsonPlace& row) {
      require_row(row, 2);
      return number_or(row[1], 0.0, 1.55, train::Fault::Kr_int);
    });
  if (const auto p = place.find("Kv_int_freight"))
    nv.Kv_int_freight =
        read_steps<NationalValues::KvFreight>(*p, kKmh, train::clause(train::Fault::Kv_int), [](const JsonPlace& row) {
          require_row(row, 2);
          return number_or(row[1], 0.0, 2.54, train::Fault::Kv_int);
        });
  if (const auto p = place.find("Kv_int_passenger"))
    nv.Kv_int_passenger = read_steps<NationalValues::KvPassenger>(
        *p, kKmh, train::clause(train::Fault::Kv_int), [](const JsonPlace& row) {
          require_row(row, 3);
          return train::KvPair{number_or(row[1], 0.0, 2.54, train::Fault::Kv_int),
                               number_or(row[2], 0.0, 2.54, train::Fault::Kv_int)};
        });
  // Two decelerations without a default select the subset (3.13.6.2.1.8.1); without them, the weaker one is used.
  if (!place.find("A_NVP12") || !place.find("A_NVP23"))
    for (auto& step : nv.Kv_int_passenger.steps) step.value.a = step.value.b = std::min(step.value.a, step.value.b);
}

/// A_NVMAXREDADH in steps of 0.05 m/s2; 61 to 63 set no maximum (7.5.1.2).
std::uint8_t code(const train::MaxReducedAdhesion& a) {
  using Display = train::MaxReducedAdhesion::Display;
  if (!a.no_maximum) return static_cast<std::uint8_t>(std::lround(a.A.si / 0.05));
  return a.display == Display::target_information ? 61 : a.display == Display::time_to_indication ? 62 : 63;
}

}  // namespace

NationalValues read_national_values(const JsonPlace& place) {
  place.know_only(kKeys);
  NationalValues nv;
  read_speed(nv.V_NVSHUNT, place, "V_NVSHUNT");
  read_speed(nv.V_NVSTFF, place, "V_NVSTFF");
  read_speed(nv.V_NVONSIGHT, place, "V_NVONSIGHT");
  read_speed(nv.V_NVLIMSUPERV, place, "V_NVLIMSUPERV");
  read_speed(nv.V_NVUNFIT, place, "V_NVUNFIT");
  read_speed(nv.V_NVREL, place, "V_NVREL");
  read_speed(nv.V_NVALLOWOVTRP, place, "V_NVALLOWOVTRP");
  read_speed(nv.V_NVSUPOVTRP, place, "V_NVSUPOVTRP");
  if (const auto p = place.find("D_NVROLL"); p && is_infinity(*p))
    nv.D_NVROLL = train::kUnlimited;
  else
    read_distance(nv.D_NVROLL, place, "D_NVROLL");
  read_distance(nv.D_NVOVTRP, place, "D_NVOVTRP");
  read_distance(nv.D_NVPOTRP, place, "D_NVPOTRP");
  read_distance(nv.Q_NVLOCACC, place, "Q_NVLOCACC");
  if (const auto p = place.find("D_NVSTFF"); p && !is_infinity(*p))
    nv.D_NVSTFF = Distance{p->number(0.0, kLongestDistance, kRanges)};
  if (const auto p = place.find("T_NVCONTACT"); p && !is_infinity(*p))
    nv.T_NVCONTACT = Duration{p->number(0.0, 254.0, kRanges)};
  if (const auto p = place.find("T_NVOVTRP")) nv.T_NVOVTRP = {p->number(0.0, 255.0, kRanges)};
  if (const auto p = place.find("M_NVCONTACT"))
    nv.M_NVCONTACT = reaction_of(static_cast<std::uint64_t>(p->integer(0, 2, kRanges))).value();
  read_flag(nv.M_NVDERUN, place, "M_NVDERUN");
  read_flag(nv.Q_NVDRIVER_ADHES, place, "Q_NVDRIVER_ADHES");
  read_flag(nv.Q_NVSBTSMPERM, place, "Q_NVSBTSMPERM");
  read_flag(nv.Q_NVEMRRLS, place, "Q_NVEMRRLS");
  read_flag(nv.Q_NVGUIPERM, place, "Q_NVGUIPERM");
  read_flag(nv.Q_NVSBFBPERM, place, "Q_NVSBFBPERM");
  read_flag(nv.Q_NVINHSMICPERM, place, "Q_NVINHSMICPERM");
  read_brake_values(nv, place);
  refuse(place, train::check(nv));
  return nv;
}

lang::Packet3 packet_3(const NationalValues& nv, std::uint16_t NID_C) {
  lang::Packet3 packet;
  packet.Q_DIR.raw = 1;
  packet.Q_SCALE.raw = 1;
  packet.D_VALIDNV.raw = 32767;  // now
  packet.NID_C.raw = NID_C;
  const auto speed = [](Speed v) { return static_cast<std::uint8_t>(std::lround(v.si * kKmh / 5.0)); };
  const auto whole = [](double v) { return static_cast<std::uint16_t>(std::lround(v)); };
  packet.V_NVSHUNT.raw = speed(nv.V_NVSHUNT);
  packet.V_NVSTFF.raw = speed(nv.V_NVSTFF);
  packet.V_NVONSIGHT.raw = speed(nv.V_NVONSIGHT);
  packet.V_NVLIMSUPERV.raw = speed(nv.V_NVLIMSUPERV);
  packet.V_NVUNFIT.raw = speed(nv.V_NVUNFIT);
  packet.V_NVREL.raw = speed(nv.V_NVREL);
  packet.D_NVROLL.raw = whole(nv.D_NVROLL.si);
  packet.Q_NVSBTSMPERM.raw = nv.Q_NVSBTSMPERM ? 1 : 0;
  packet.Q_NVEMRRLS.raw = nv.Q_NVEMRRLS ? 1 : 0;
  packet.Q_NVGUIPERM.raw = nv.Q_NVGUIPERM ? 1 : 0;
  packet.Q_NVSBFBPERM.raw = nv.Q_NVSBFBPERM ? 1 : 0;
  packet.Q_NVINHSMICPERM.raw = nv.Q_NVINHSMICPERM ? 1 : 0;
  packet.V_NVALLOWOVTRP.raw = speed(nv.V_NVALLOWOVTRP);
  packet.V_NVSUPOVTRP.raw = speed(nv.V_NVSUPOVTRP);
  packet.D_NVOVTRP.raw = whole(nv.D_NVOVTRP.si);
  packet.T_NVOVTRP.raw = static_cast<std::uint8_t>(std::lround(nv.T_NVOVTRP.si));
  packet.D_NVPOTRP.raw = whole(nv.D_NVPOTRP.si);
  packet.M_NVCONTACT.raw = static_cast<std::uint8_t>(nv.M_NVCONTACT);
  packet.T_NVCONTACT.raw =
      nv.T_NVCONTACT ? static_cast<std::uint8_t>(std::lround(nv.T_NVCONTACT->si)) : std::uint8_t{255};
  packet.M_NVDERUN.raw = nv.M_NVDERUN ? 1 : 0;
  packet.D_NVSTFF.raw = nv.D_NVSTFF ? whole(nv.D_NVSTFF->si) : std::uint16_t{32767};
  packet.Q_NVDRIVER_ADHES.raw = nv.Q_NVDRIVER_ADHES ? 1 : 0;
  packet.A_NVMAXREDADH1.raw = code(nv.A_NVMAXREDADH1);
  packet.A_NVMAXREDADH2.raw = code(nv.A_NVMAXREDADH2);
  packet.A_NVMAXREDADH3.raw = code(nv.A_NVMAXREDADH3);
  packet.Q_NVLOCACC.raw = static_cast<std::uint8_t>(std::lround(nv.Q_NVLOCACC.si));
  packet.M_NVAVADH.raw = static_cast<std::uint8_t>(std::lround(nv.M_NVAVADH / 0.05));
  packet.M_NVEBCL.raw = nv.M_NVEBCL;
  return packet;
}

SrsVersion read_srs_version(const JsonPlace& place) { return place.term<kSrsVersionRows>(); }

}  // namespace evc::io
