#include <algorithm>

#include "io/refuse.h"
#include "io/steps.h"
#include "io/train_file.h"

namespace evc::io {
namespace {

using train::NationalValues;
constexpr double kKmh = 3.6;
/// Ranges of the variables.
constexpr const char* kRanges = "7.5.1";

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
  if (const auto p = place.find(key)) d = {p->number(0.0, 327660.0, kRanges)};
}
void read_flag(bool& flag, const JsonPlace& place, const char* key) {
  if (const auto p = place.find(key)) flag = p->boolean();
}
void read_acceleration(Acceleration& a, const JsonPlace& place, const char* key) {
  if (const auto p = place.find(key)) a = {p->number(0.0, 10.0, train::clause(train::Fault::A_NVP))};
}
bool is_infinity(const JsonPlace& p) { return p.is_null() || (p.is_string() && p.string() == "infinity"); }

/// A number in m/s2, or which display "no maximum" asks for.
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
  // Which subset holds is decided by two decelerations (3.13.6.2.1.8.1) without a default: the weaker one without them.
  if (!place.find("A_NVP12") || !place.find("A_NVP23"))
    for (auto& step : nv.Kv_int_passenger.steps) step.value.a = step.value.b = std::min(step.value.a, step.value.b);
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
  read_distance(nv.D_NVROLL, place, "D_NVROLL");
  read_distance(nv.D_NVOVTRP, place, "D_NVOVTRP");
  read_distance(nv.D_NVPOTRP, place, "D_NVPOTRP");
  read_distance(nv.Q_NVLOCACC, place, "Q_NVLOCACC");
  if (const auto p = place.find("D_NVSTFF"); p && !is_infinity(*p))
    nv.D_NVSTFF = Distance{p->number(0.0, 327660.0, kRanges)};
  if (const auto p = place.find("T_NVCONTACT"); p && !is_infinity(*p))
    nv.T_NVCONTACT = Duration{p->number(0.0, 254.0, kRanges)};
  if (const auto p = place.find("T_NVOVTRP")) nv.T_NVOVTRP = {p->number(0.0, 255.0, kRanges)};
  if (const auto p = place.find("M_NVCONTACT"))
    nv.M_NVCONTACT = static_cast<train::ContactReaction>(p->integer(0, 2, kRanges));
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

train::SrsVersion read_srs_version(const JsonPlace& place) {
  return static_cast<train::SrsVersion>(place.one_of({"3.4.0", "3.6.0", "4.0.0"}));
}

const char* name(train::SrsVersion version) {
  constexpr const char* names[] = {"3.4.0", "3.6.0", "4.0.0"};
  return names[static_cast<std::size_t>(version)];
}

}  // namespace evc::io
