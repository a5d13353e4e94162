// The three published examples of the official braking curve tool (SRS 3.4.0 formulas).
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/test_paths.h"
#include "base/test_units.h"
#include "openevc/curves.h"

namespace {

using evc::Acceleration;
using evc::Distance;
using evc::Duration;
using evc::Place;
using evc::Speed;
using nlohmann::json;
namespace train = evc::train;
namespace sdm = evc::sdm;

using evc::test::kmh;

json examples() {
  std::ifstream file(evc::test::source_folder() + "/tests/reference/era_examples.json");
  return json::parse(file);
}

train::BrakePosition position(const std::string& s) {
  if (s == "FreightP") return train::BrakePosition::FreightP;
  if (s == "FreightG") return train::BrakePosition::FreightG;
  return train::BrakePosition::PassengerP;
}

train::TrainData train_of(const json& t) {
  train::TrainData d;
  d.brake_position = position(t["brake_position"]);
  d.L_TRAIN = {t["length_m"]};
  d.V_MAXTRAIN = kmh(t["max_speed_kmh"]);
  d.T_traction_cut_off = {t["T_traction_cut_off_s"]};
  d.traction_cut_off_interface = t["traction_cut_off_interface"];
  d.service_brake_interface = t["service_brake_command"];
  d.service_brake_feedback = t["service_brake_feedback"];
  if (t["model"] == "lambda") {
    d.brake_percentage = t["brake_percentage"];
    return d;
  }
  d.brake_model = train::BrakeModel::gamma;
  train::EmergencyModel e;
  for (std::size_t i = 0; i < t["A_brake_emergency"].size(); ++i) {
    train::EmergencyStep s;
    s.A_brake_emergency = {t["A_brake_emergency"][i][1]};
    s.Kwet_rst = train::Factor::of(t["Kwet_rst"][i][1]);
    s.Kdry_rst.fill(train::Factor::of(t["Kdry_rst"][i][1]));
    EXPECT_TRUE(e.steps.append(kmh(t["A_brake_emergency"][i][0]), s));
  }
  EXPECT_TRUE(d.emergency.push_back(e));
  train::ServiceModel s;
  for (const auto& step : t["A_brake_service"]) EXPECT_TRUE(s.A_brake_service.append(kmh(step[0]), {step[1]}));
  EXPECT_TRUE(d.service.push_back(s));
  EXPECT_TRUE(d.T_emergency.push_back({{t["T_brake_emergency_s"]}, {}, 0}));
  EXPECT_TRUE(d.T_service.push_back({{t["T_brake_service_s"]}, {}, 0}));
  return d;
}

train::NationalValues national(const json& n) {
  train::NationalValues v;
  v.Q_NVSBTSMPERM = n["Q_NVSBTSMPERM"];
  v.Q_NVINHSMICPERM = n["Q_NVINHSMICPERM"];
  v.M_NVAVADH = n["M_NVAVADH"];
  if (n.contains("Kt_int")) v.Kt_int = n["Kt_int"];
  if (n.contains("A_NVP12")) v.A_NVP12 = {n["A_NVP12"]};
  if (n.contains("A_NVP23")) v.A_NVP23 = {n["A_NVP23"]};
  if (n.contains("Kr_int")) {
    v.Kr_int = {};
    for (const auto& s : n["Kr_int"]) EXPECT_TRUE(v.Kr_int.append(Distance{s[0]}, double{s[1]}));
  }
  if (n.contains("Kv_int_freight") && !n["Kv_int_freight"].is_null()) {
    v.Kv_int_freight = {};
    for (const auto& s : n["Kv_int_freight"]) EXPECT_TRUE(v.Kv_int_freight.append(kmh(s[0]), double{s[1]}));
  }
  if (n.contains("Kv_int_passenger") && !n["Kv_int_passenger"].is_null()) {
    v.Kv_int_passenger = {};
    for (const auto& s : n["Kv_int_passenger"])
      EXPECT_TRUE(v.Kv_int_passenger.append(kmh(s[0]), train::KvPair{s[1], s[2]}));
  }
  return v;
}

sdm::Inputs inputs_of(const json& c) {
  sdm::Inputs in;
  in.revision = 1;
  in.srs = evc::SrsVersion::v3_4_0;
  in.train = train_of(c["train"]);
  in.national_values = national(c["national_values"]);
  for (const auto& g : c["track"]["gradient"]) EXPECT_TRUE(in.gradient.permille.append(Place{{g[0]}}, double{g[1]}));
  if (c["track"].contains("gradient_end_m")) in.gradient.known_to = Place{{c["track"]["gradient_end_m"]}};
  EXPECT_TRUE(in.mrsp.append(Place{}, kmh(c["V_MRSP_kmh"])));
  const json& t = c["target"];
  in.authority.EOA = Place{{t["location_m"]}};
  in.authority.SvL = in.authority.EOA;
  if (t["type"] == "EOA_SvL") {
    in.authority.kind = sdm::Authority::Kind::EOA_SvL;
    if (!t["release_speed_kmh"].is_null()) {
      in.authority.release_speed = evc::ReleaseSpeedChoice::value;
      in.authority.V_release = kmh(t["release_speed_kmh"]);
    }
  } else {
    in.authority.kind = sdm::Authority::Kind::LOA;
    in.authority.V_LOA = kmh(t["speed_kmh"]);
  }
  return in;
}

class EraExamples : public ::testing::TestWithParam<int> {};

TEST_P(EraExamples, AgreeWithinTheToolsRounding) {
  const json all = examples();
  const json& c = all["cases"][static_cast<std::size_t>(GetParam())];
  const sdm::Inputs in = inputs_of(c);
  ASSERT_EQ(train::check(in.train), train::Fault::none);
  auto derived = std::make_unique<sdm::Derived>();
  ASSERT_TRUE(sdm::rebuild(*derived, in));
  const sdm::Target& target = derived->targets.back();
  const double location = c["target"]["location_m"];
  const Speed V_MRSP = kmh(c["V_MRSP_kmh"]);
  int checked = 0;
  for (const json& e : c["expected"]) {
    if (e.contains("skip")) continue;
    const std::string q = e["q"];
    Speed V = kmh(e["v_kmh"]);
    // The tool's convention: P and I above the MRSP are those of the MRSP.
    if ((q == "P" || q == "I") && V > V_MRSP) V = V_MRSP;
    const sdm::Explanation x = sdm::explain(*derived, in, target, V, {}, {});
    const auto distance = [location](Place p) { return location - p.from_origin.si; };
    double value = NAN;
    if (q == "EBD") value = distance(x.d_EBD);
    if (q == "SBD") value = distance(*x.d_SBD);
    if (q == "EBI") {
      value = distance(*x.EBD.d_EBI);
      // The tool ends the EBI at the start of release speed monitoring.
      if (derived->release_speed.exists)
        value = std::max(value, distance(std::min(derived->release_speed.d_SBI1, derived->release_speed.d_SBI2)));
    }
    if (q == "SBI1") value = distance(x.SBD->d_SBI);
    if (q == "SBI2") value = distance(x.EBD.d_SBI);
    if (q == "FLOI") value = distance(x.d_FLOI);
    if (q == "W") value = distance(x.d_W);
    if (q == "P") value = distance(x.d_P);
    if (q == "I") value = distance(x.d_I);
    if (q == "A_brake_emergency") value = x.A_brake_emergency.si;
    if (q == "A_brake_service") value = x.A_brake_service.si;
    if (q == "A_safe") value = x.A_safe.si;
    if (q == "A_expected") value = x.A_expected.si;
    if (e.contains("at_distance_m")) {
      const Place at{{location - e["at_distance_m"].get<double>()}};
      value =
          derived->decelerations.at(q == "A_safe" ? sdm::CurveKind::EBD : sdm::CurveKind::SBD, V, at - Distance{1e-6})
              .si;
    }
    const bool deceleration = e["kind"] == "accel";
    EXPECT_NEAR(value, e["value"].get<double>(), deceleration ? 2e-4 : 0.25)
        << c["id"] << " " << q << " at " << e["v_kmh"];
    ++checked;
  }
  EXPECT_GT(checked, 200);
}

TEST_P(EraExamples, ScalarsAgree) {
  const json all = examples();
  const json& c = all["cases"][static_cast<std::size_t>(GetParam())];
  const sdm::Inputs in = inputs_of(c);
  auto derived = std::make_unique<sdm::Derived>();
  ASSERT_TRUE(sdm::rebuild(*derived, in));
  const sdm::Target& target = derived->targets.back();
  const double location = c["target"]["location_m"];
  for (const json& s : c["scalars"]) {
    const std::string name = s[0];
    SCOPED_TRACE(name);
    const double start = std::min(derived->release_speed.d_SBI1, derived->release_speed.d_SBI2).from_origin.si;
    if (name == "conversion_model_used") {
      EXPECT_EQ(train::conversion_model_applies(in.train), s[1].get<bool>());
    }
    if (name == "T_be") {
      EXPECT_NEAR(derived->cm0.T_be.si, s[1].get<double>(), 1e-9);
    }
    if (name == "T_bs") {
      EXPECT_NEAR(derived->cm0.T_bs.si, s[1].get<double>(), 1e-9);
    }
    if (name == "V_lim_eb") {
      EXPECT_NEAR(train::V_lim(in.train.brake_percentage).si * 3.6, s[1].get<double>(), 1e-8);
    }
    if (name == "kto") {
      EXPECT_NEAR(derived->cmt.T_bs.si / derived->cm0.T_bs.si, s[1].get<double>(), 1e-12);
    }
    if (name == "d_startRSM") {
      EXPECT_NEAR(location - start, s[1].get<double>(), 0.25);
    }
    if (name == "d_preindication") {
      ASSERT_TRUE(target.d_preindication_EBD.has_value());
      EXPECT_NEAR(location - std::min(*target.d_preindication_EBD, *target.d_preindication_SBD).from_origin.si,
                  s[1].get<double>(), 0.25);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, EraExamples, ::testing::Range(0, 3));

}  // namespace
