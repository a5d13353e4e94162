#include "curves/explain_brakes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace evc::curves {
namespace {

constexpr double kOpen = 1e9;  // the last step has no upper limit

/// The step that applies at `x`, with its range in the unit of the page.
struct Held {
  std::size_t index;
  double from, upto;
};
template <class Steps, class Axis>
Held held(const Steps& f, Axis x, double unit) {
  const std::size_t i = train::step_below(f, x);
  return {i, f.steps[i].from.si * unit, i + 1 < f.size() ? f.steps[i + 1].from.si * unit : kOpen};
}
template <class Steps>
std::string range_at(const Steps& f, Speed V) {
  const Held h = held(f, V, kKmh);
  return range_of_step("V", h.from, h.upto);
}

std::string names_of(train::BrakeSet set) {
  std::string names;
  const auto add = [&](train::BrakeSet brake, const char* name) {
    if ((set & brake) != 0) names += (names.empty() ? "" : ", ") + std::string(name);
  };
  add(train::kRegenerative, "regenerative");
  add(train::kEddyCurrent, "eddy current");
  add(train::kMagneticShoe, "magnetic shoe");
  add(train::kElectroPneumatic, "ep");
  return names.empty() ? "none" : names;
}

/// A.3.7 for one lambda_0: every step of the basic deceleration that is not ignored, then the one at V.
void basic_deceleration(ExplainPage& page, double lambda0, Speed V, const char* symbol, double value) {
  const std::string l = short_number(lambda0);
  const double V_lim = train::V_lim(lambda0).si * kKmh;
  page.step("V_lim", "16.85 * lambda_0^0.428", fmt::format("16.85 * {}^0.428", l), V_lim, "km/h", "A.3.7.3");
  page.step("AD_0", "0.0075 * lambda_0 + 0.076        " + range_of_step("V", 0.0, V_lim),
            fmt::format("0.0075 * {} + 0.076", l), train::AD_0(lambda0), "m/s2", "A.3.7.4");
  std::string chosen = "AD_0";
  double from = V_lim;
  int k = 0;
  for (const train::BasicDecelerationStep& p : train::kAD) {
    ++k;
    if (from >= p.upto_kmh) continue;
    const std::string name = fmt::format("AD_{}", k);
    page.step(name,
              "a3 * lambda_0^3 + a2 * lambda_0^2 + a1 * lambda_0 + a0        " + range_of_step("V", from, p.upto_kmh),
              fmt::format("{0:g} * {4}^3 {1} * {4}^2 + {2:g} * {4} + {3:g}", p.a3,
                          (p.a2 < 0.0 ? "- " : "+ ") + fmt::format("{:g}", std::abs(p.a2)), p.a1, p.a0, l),
              p.at(lambda0), "m/s2", "A.3.7.5");
    if (V.si * kKmh > from) chosen = name;
    from = p.upto_kmh;
  }
  page.step(symbol, fmt::format("{} at V = {:.6g} km/h", chosen, V.si * kKmh), "", value, "m/s2", "A.3.7.2");
}

/// Kv_int of a train with brake position P (3.13.6.2.1.8.1-2).
void passenger_Kv_int(ExplainPage& page, const train::TrainData& t, const train::NationalValues& v, Speed V,
                      double Kv_int) {
  double A_ebmax = 0.0;
  std::string all;
  for (const auto& step : train::A_brake_emergency(t, 0).steps)
    if (step.from.si == 0.0 || step.from < t.V_MAXTRAIN) {
      A_ebmax = std::max(A_ebmax, step.value.si);
      all += (all.empty() ? "" : ", ") + n5(step.value.si);
    }
  page.step("A_ebmax", fmt::format("max of A_brake_emergency from 0 to {:.6g} km/h", t.V_MAXTRAIN.si * kKmh),
            "max(" + all + ")", A_ebmax, "m/s2", "3.13.6.2.1.8.2");
  const Held h = held(v.Kv_int_passenger, V, kKmh);
  const train::KvPair k = v.Kv_int_passenger.steps[h.index].value;
  page.step("Kv_int_a", "national value, " + range_of_step("V", h.from, h.upto), "", k.a, "", "3.13.2.3.7.11.5");
  page.step("Kv_int_b", "national value, " + range_of_step("V", h.from, h.upto), "", k.b, "", "3.13.2.3.7.11.6");
  const std::string a = short_number(k.a), b = short_number(k.b);
  const std::string P12 = short_number(v.A_NVP12.si), P23 = short_number(v.A_NVP23.si);
  if (A_ebmax <= v.A_NVP12.si)
    page.step("Kv_int(V)", fmt::format("Kv_int_a: A_ebmax <= A_NVP12 = {} m/s2", P12), "", Kv_int, "",
              "3.13.6.2.1.8.1");
  else if (A_ebmax >= v.A_NVP23.si)
    page.step("Kv_int(V)", fmt::format("Kv_int_b: A_ebmax >= A_NVP23 = {} m/s2", P23), "", Kv_int, "",
              "3.13.6.2.1.8.1");
  else
    page.step("Kv_int(V)", "Kv_int_a + (A_ebmax - A_NVP12) / (A_NVP23 - A_NVP12) * (Kv_int_b - Kv_int_a)",
              fmt::format("{0} + ({1} - {2}) / ({3} - {2}) * ({4} - {0})", a, n5(A_ebmax), P12, P23, b), Kv_int, "",
              "3.13.6.2.1.8.1");
}

void lambda_emergency(ExplainPage& page, const io::CurvesInput& c, const sdm::Explanation& e) {
  const train::TrainData& t = c.inputs.train;
  const train::NationalValues& v = c.inputs.national_values;
  const Speed V = e.approach.V;
  page.step("lambda_0", "brake percentage, emergency brake", "", t.brake_percentage, "%", "A.3.7.1");
  basic_deceleration(page, t.brake_percentage, V, "A_brake_emergency", e.A_brake_emergency.si);
  const auto kv = train::Kv_int(t, v);
  const double Kv_int = train::value_below(kv, V);
  if (t.brake_position == train::BrakePosition::PassengerP)
    passenger_Kv_int(page, t, v, V, Kv_int);
  else
    page.step("Kv_int(V)", "national value for freight trains, " + range_at(kv, V), "", Kv_int, "", "3.13.6.2.1.8");
  const Held length = held(v.Kr_int, t.L_TRAIN, 1.0);
  const double Kr_int = v.Kr_int.steps[length.index].value;
  page.step("Kr_int(L_TRAIN)",
            fmt::format("national value, L_TRAIN = {:g} m, {}", t.L_TRAIN.si,
                        range_of_step("L_TRAIN", length.from, length.upto)),
            "", Kr_int, "", "3.13.2.3.7.12");
  page.step("A_brake_safe", "Kv_int(V) * Kr_int(L_TRAIN) * A_brake_emergency",
            fmt::format("{} * {} * {}", n5(Kv_int), short_number(Kr_int), n5(e.A_brake_emergency.si)),
            e.A_brake_safe.si, "m/s2", "3.13.6.2.1.4");
}

void gamma_emergency(ExplainPage& page, const io::CurvesInput& c, const sdm::Explanation& e) {
  const train::TrainData& t = c.inputs.train;
  const train::NationalValues& v = c.inputs.national_values;
  const Speed V = e.approach.V;
  const train::BrakeSet in_use = e.in_use_emergency;
  const train::EmergencyModel* model = train::emergency_model(t, in_use);
  if (model == nullptr) return;  // such a train is rejected
  page.line("special brakes that count for the emergency brake: " + names_of(in_use) +
            (model->with == in_use ? "" : "; the train's model is that with: " + names_of(model->with)) +
            " (3.13.2.2.6)");
  const Held h = held(model->steps, V, kKmh);
  const train::EmergencyStep& step = model->steps.steps[h.index].value;
  const std::string at = range_of_step("V", h.from, h.upto);
  const std::size_t level = std::min<std::size_t>(v.M_NVEBCL, train::kConfidenceLevels - 1);
  const double Kdry = step.Kdry_rst[level].value();
  const double Kwet = step.Kwet_rst.value();
  page.step("A_brake_emergency", "step of the train's model, " + at, "", step.A_brake_emergency.si, "m/s2",
            "3.13.2.2.3.1");
  page.step("Kdry_rst", fmt::format("of the train for M_NVEBCL = {}, {}", level, at), "", Kdry, "", "3.13.6.2.1.7");
  page.step("Kwet_rst", "of the train, " + at, "", Kwet, "", "3.13.2.2.9.1");
  page.step("M_NVAVADH", "national value", "", v.M_NVAVADH, "", "3.13.2.3.7.6");
  page.step("A_brake_safe", "Kdry_rst * (Kwet_rst + M_NVAVADH * (1 - Kwet_rst)) * A_brake_emergency",
            fmt::format("{0} * ({1} + {2} * (1 - {1})) * {3}", short_number(Kdry), short_number(Kwet),
                        short_number(v.M_NVAVADH), n5(step.A_brake_emergency.si)),
            e.A_brake_safe.si, "m/s2", "3.13.6.2.1.4");
}

void service(ExplainPage& page, const io::CurvesInput& c, const sdm::Explanation& e) {
  const train::TrainData& t = c.inputs.train;
  const Speed V = e.approach.V;
  if (t.brake_model == train::BrakeModel::lambda) {
    const double lambda0 = std::min(t.brake_percentage, 135.0);
    page.step("lambda_0", "min(brake percentage, 135), service brake",
              fmt::format("min({}, 135)", short_number(t.brake_percentage)), lambda0, "%", "A.3.7.1");
    basic_deceleration(page, lambda0, V, "A_brake_service", e.A_brake_service.si);
    return;
  }
  const train::BrakeSet in_use = e.in_use_service;
  page.line("special brakes that count for the service brake: " + names_of(in_use) + " (3.13.2.2.6)");
  page.step("A_brake_service", "step of the train's model, " + range_at(train::A_brake_service(t, in_use), V), "",
            e.A_brake_service.si, "m/s2", "3.13.2.2.3.1");
}

/// T_brake_basic of A.3.8 or A.3.9, with the effect of a target speed. The brake position selects the paragraph.
Duration conversion_time(ExplainPage& page, const io::CurvesInput& c, bool emergency, bool target_is_zero) {
  const train::TrainData& t = c.inputs.train;
  const train::BasicBuildUpTime k = emergency ? train::basic_emergency_time(t.brake_position, t.L_TRAIN)
                                              : train::basic_service_time(t.brake_position, t.L_TRAIN);
  const char* annex = emergency ? "A.3.8" : "A.3.9";
  const std::string clause = fmt::format("{}.{}", annex, static_cast<int>(t.brake_position) + 1);
  const std::string brake = emergency ? "emergency" : "service";
  const double L = k.length(t.L_TRAIN);
  if (k.at_least_400_m)
    page.step("L", "max(400 m, L_TRAIN)", fmt::format("max(400, {:g})", t.L_TRAIN.si), L, "m", clause);
  else
    page.step("L", "L_TRAIN", "", L, "m", clause);
  const Duration basic = k.at(t.L_TRAIN);
  page.step(emergency ? "T_brake_basic_eb" : "T_brake_basic_sb", "a + b * (L / 100) + c * (L / 100)^2",
            fmt::format("{:.2f} + {:.2f} * {:g} + {:.2f} * {:g}^2", k.a, k.b, L / 100.0, k.c, L / 100.0), basic.si, "s",
            clause);
  if (target_is_zero) {
    page.step("T_brake_" + brake,
              emergency ? "T_brake_emergency_cm0 = T_brake_basic_eb: V_target = 0"
                        : "T_brake_service_cm0 = T_brake_basic_sb: V_target = 0",
              "", basic.si, "s", fmt::format("{}.4", annex));
    return basic;
  }
  const double kto = train::kto(t.brake_position);
  page.step("kto", "1 + Ct", fmt::format("1 + {:.2f}", kto - 1.0), kto, "", emergency ? "A.3.8.5" : "A.3.9.5");
  const Duration cmt = kto * basic;
  page.step("T_brake_" + brake,
            emergency ? "T_brake_emergency_cmt = kto * T_brake_basic_eb: V_target > 0"
                      : "T_brake_service_cmt = kto * T_brake_basic_sb: V_target > 0",
            fmt::format("{} * {}", short_number(kto), n4(basic.si)), cmt.si, "s", fmt::format("{}.4", annex));
  return cmt;
}

}  // namespace

void explain_brakes(ExplainPage& page, const Approached& a, const sdm::Explanation& e) {
  const io::CurvesInput& c = a.input();
  const bool lambda = c.inputs.train.brake_model == train::BrakeModel::lambda;
  page.heading(lambda ? "Brakes at this speed, by the conversion model of the brake percentage"
                      : "Brakes at this speed, by the train's own models");
  lambda ? lambda_emergency(page, c, e) : gamma_emergency(page, c, e);
  if (e.d_SBD) service(page, c, e);
}

void explain_build_up_times(ExplainPage& page, const Approached& a, const sdm::Explanation& e) {
  const io::CurvesInput& c = a.input();
  const train::TrainData& t = c.inputs.train;
  const bool zero = a.target().zero;
  if (t.brake_model == train::BrakeModel::gamma) {
    page.step("T_be", "T_brake_emergency, with the special brakes in use", "", e.build_up.T_be.si, "s", "3.13.6.2.2.3");
    page.step("T_bs", "T_brake_service, with the special brakes in use", "", e.build_up.T_bs.si, "s", "3.13.6.3.2.4");
    return;
  }
  const double Kt_int = c.inputs.national_values.Kt_int;
  const Duration emergency = conversion_time(page, c, true, zero);
  page.step("T_be", "Kt_int * T_brake_emergency", fmt::format("{} * {}", short_number(Kt_int), n4(emergency.si)),
            e.build_up.T_be.si, "s", "3.13.6.2.2.3");
  const Duration service = conversion_time(page, c, false, zero);
  if (e.build_up.T_bs < service)
    page.step("T_bs", "T_brake_service of the train: shorter than the model's", "", e.build_up.T_bs.si, "s", "A.3.9.6");
  else
    page.step("T_bs", "T_brake_service", "", e.build_up.T_bs.si, "s", "3.13.6.3.2.4");
}

}  // namespace evc::curves
