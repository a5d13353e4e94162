#include <cmath>

#include "io/train_file.h"

namespace evc::io {
namespace {

using Out = nlohmann::ordered_json;
using train::NationalValues;

/// In a file's unit: a value with few digits where it is read back as the same number.
double in_unit(double si, double unit) {
  const double few = std::round(si * unit * 1e6) / 1e6;
  return few / unit == si ? few : si * unit;
}
double kmh(Speed v) { return in_unit(v.si, kKmh); }

Out reduced_adhesion(const train::MaxReducedAdhesion& a) {
  using Display = train::MaxReducedAdhesion::Display;
  if (!a.no_maximum) return a.A.si;
  switch (a.display) {
    case Display::none:
      break;
    case Display::target_information:
      return "no maximum, target information";
    case Display::time_to_indication:
      return "no maximum, time to indication";
  }
  return "no maximum";
}

template <class Steps, class Row>
Out table(const Steps& steps, Row row) {
  Out out = Out::array();
  for (const auto& step : steps.steps) out.push_back(row(step));
  return out;
}

void write_procedures(Out& out, const NationalValues& nv) {
  const auto distance = [](Distance d) { return d < train::kUnlimited ? Out(d.si) : Out("infinity"); };
  out["V_NVSHUNT"] = kmh(nv.V_NVSHUNT);
  out["V_NVSTFF"] = kmh(nv.V_NVSTFF);
  out["V_NVONSIGHT"] = kmh(nv.V_NVONSIGHT);
  out["V_NVLIMSUPERV"] = kmh(nv.V_NVLIMSUPERV);
  out["V_NVUNFIT"] = kmh(nv.V_NVUNFIT);
  out["V_NVREL"] = kmh(nv.V_NVREL);
  out["V_NVALLOWOVTRP"] = kmh(nv.V_NVALLOWOVTRP);
  out["V_NVSUPOVTRP"] = kmh(nv.V_NVSUPOVTRP);
  out["D_NVROLL"] = distance(nv.D_NVROLL);
  out["D_NVOVTRP"] = nv.D_NVOVTRP.si;
  out["D_NVPOTRP"] = nv.D_NVPOTRP.si;
  out["D_NVSTFF"] = nv.D_NVSTFF ? Out(nv.D_NVSTFF->si) : Out("infinity");
  out["T_NVOVTRP"] = nv.T_NVOVTRP.si;
  out["T_NVCONTACT"] = nv.T_NVCONTACT ? Out(nv.T_NVCONTACT->si) : Out("infinity");
  out["Q_NVLOCACC"] = nv.Q_NVLOCACC.si;
  out["M_NVCONTACT"] = static_cast<int>(nv.M_NVCONTACT);
  out["M_NVDERUN"] = nv.M_NVDERUN;
  out["Q_NVDRIVER_ADHES"] = nv.Q_NVDRIVER_ADHES;
  out["Q_NVSBTSMPERM"] = nv.Q_NVSBTSMPERM;
  out["Q_NVEMRRLS"] = nv.Q_NVEMRRLS;
}

void write_braking(Out& out, const NationalValues& nv) {
  out["Q_NVGUIPERM"] = nv.Q_NVGUIPERM;
  out["Q_NVSBFBPERM"] = nv.Q_NVSBFBPERM;
  out["Q_NVINHSMICPERM"] = nv.Q_NVINHSMICPERM;
  out["M_NVEBCL"] = nv.M_NVEBCL;
  out["M_NVAVADH"] = nv.M_NVAVADH;
  out["A_NVMAXREDADH1"] = reduced_adhesion(nv.A_NVMAXREDADH1);
  out["A_NVMAXREDADH2"] = reduced_adhesion(nv.A_NVMAXREDADH2);
  out["A_NVMAXREDADH3"] = reduced_adhesion(nv.A_NVMAXREDADH3);
  out["A_NVP12"] = nv.A_NVP12.si;
  out["A_NVP23"] = nv.A_NVP23.si;
  out["Kv_int_freight"] = table(nv.Kv_int_freight, [](const auto& step) {
    return Out::array({kmh(step.from), step.value});
  });
  out["Kv_int_passenger"] = table(nv.Kv_int_passenger, [](const auto& step) {
    return Out::array({kmh(step.from), step.value.a, step.value.b});
  });
  out["Kr_int"] = table(nv.Kr_int, [](const auto& step) { return Out::array({step.from.si, step.value}); });
  out["Kt_int"] = nv.Kt_int;
}

}  // namespace

nlohmann::ordered_json national_values_json(const NationalValues& values) {
  Out out;
  write_procedures(out, values);
  write_braking(out, values);
  return out;
}

}  // namespace evc::io
