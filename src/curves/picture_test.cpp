#include "curves/picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "curves/curves_test.h"

// The charts' lines: each has a point exactly where it ends and where it begins, whatever the grid of the chart.
namespace evc::curves {
namespace {

using nlohmann::json;

const PictureCurve& curve_of(const Picture& p, const std::string& key) {
  for (const PictureCurve& c : p.curves)
    if (c.key == key) return c;
  ADD_FAILURE() << "no " << key;
  return p.curves.front();
}

struct Point {
  double x = std::nan(""), v = std::nan("");
};
Point last_of(const Picture& p, const std::string& key) {
  const PictureCurve& c = curve_of(p, key);
  Point last;
  for (std::size_t i = 0; i < p.x_m.size(); ++i)
    if (!std::isnan(c.v[i])) last = {p.x_m[i], c.v[i]};
  return last;
}
Point first_of(const Picture& p, const std::string& key) {
  const PictureCurve& c = curve_of(p, key);
  for (std::size_t i = 0; i < p.x_m.size(); ++i)
    if (!std::isnan(c.v[i])) return {p.x_m[i], c.v[i]};
  return {};
}

/// An EOA at a place that no grid has, 60 m in rear of the SvL.
json stop_in_rear_of_SvL() {
  json document = passenger();
  document["target"] = {{"type", "EOA_SvL"}, {"location_m", 6876.543}, {"svl_location_m", 6936.789}};
  return document;
}

TEST(Picture, TheLinesOfAStopEndAtTheirTargets) {
  const Picture p = picture_of(approached(stop_in_rear_of_SvL()));
  for (const char* key : {"SBD", "P", "W", "SBI", "I"}) {
    EXPECT_EQ(last_of(p, key).x, 6876.543) << key;
    EXPECT_EQ(last_of(p, key).v, 0.0) << key;
  }
  for (const char* key : {"EBD", "EBI"}) {
    EXPECT_EQ(last_of(p, key).x, 6936.789) << key;
    EXPECT_EQ(last_of(p, key).v, 0.0) << key;
  }
}

TEST(Picture, WithAReleaseSpeedLimitsEndWhereItsMonitoringBegins) {
  json document = stop_in_rear_of_SvL();
  document["target"]["release_speed_kmh"] = 30;
  const Picture p = picture_of(approached(document));
  ASSERT_TRUE(p.start_of_RSM_m);
  for (const char* key : {"EBI", "SBI", "W", "I"}) EXPECT_EQ(last_of(p, key).x, *p.start_of_RSM_m) << key;
  EXPECT_GE(last_of(p, "SBI").v, 30.0);  // 3.13.9.4.9
  EXPECT_LE(last_of(p, "SBI").v, 32.0);
  EXPECT_EQ(last_of(p, "P").x, 6876.543);
  EXPECT_EQ(last_of(p, "SBD").x, 6876.543);
}

TEST(Picture, TheEBDOfARestrictionEndsAtItsTargetAboveTheTargetSpeed) {
  json document = passenger();
  document["target"] = {{"type", "MRSP"}, {"location_m", 5432.1}, {"speed_kmh", 67}};
  const Picture p = picture_of(approached(document));
  // 3.13.8.3.1: V_target + dV_ebi at the target; the curve goes on beyond it to V_target.
  EXPECT_NEAR(last_of(p, "EBD").v, 67.0, 1e-9);
  EXPECT_GT(last_of(p, "EBD").x, 5432.1);
  EXPECT_EQ(last_of(p, "I").x, 5432.1);
  EXPECT_NEAR(last_of(p, "I").v, 67.0, 1e-9);
}

TEST(Picture, TheIndicationBeginsOnTheCeiling) {
  for (const char* srs : {"3.4.0", "3.6.0", "4.0.0"}) {
    json document = stop_in_rear_of_SvL();
    document["srs"] = srs;
    const Approached a = approached(document);
    const Picture p = picture_of(a);
    EXPECT_NEAR(first_of(p, "I").v, 160.0, 1e-6) << srs;
    EXPECT_NEAR(first_of(p, "I").x, a.explain(Speed{160.0 / kKmh}).d_I.from_origin.si, 1e-6) << srs;
  }
}

/// Where a line has no value any more, or has one again, the two points are a millimetre or two apart: nothing of it is
/// lost between points of the grid.
TEST(Picture, NoLineEndsOrBeginsBetweenPoints) {
  std::mt19937 draw(5);
  const auto uniform = [&](double from, double to) { return std::uniform_real_distribution<>(from, to)(draw); };
  std::size_t ends = 0;
  for (int n = 0; n < 60; ++n) {
    json document = stop_in_rear_of_SvL();
    document["srs"] = n % 3 == 0 ? "3.4.0" : n % 3 == 1 ? "3.6.0" : "4.0.0";
    const double EOA = uniform(5000.0, 9000.0);
    document["target"]["location_m"] = EOA;
    document["target"]["svl_location_m"] = EOA + (n % 4 == 0 ? 0.0 : uniform(0.0, 200.0));
    if (n % 2 == 0) document["target"]["release_speed_kmh"] = uniform(10.0, 40.0);
    json mrsp = {{0, 160}};
    for (double at = uniform(500.0, 4000.0); at < EOA; at += uniform(300.0, 3000.0))
      mrsp.push_back({at, std::round(uniform(4.0, 32.0)) * 5.0});
    document["track"]["mrsp"] = mrsp;
    if (n % 5 == 0) {
      document["target"] = {{"type", "LOA"}, {"location_m", EOA}, {"speed_kmh", std::round(uniform(4.0, 12.0)) * 5.0}};
    }
    const Approached a = approached(document);
    const Picture p = picture_of(a);
    for (const PictureCurve& c : p.curves) {
      ASSERT_EQ(c.v.size(), p.x_m.size());
      for (std::size_t i = 1; i < p.x_m.size(); ++i) {
        EXPECT_LT(p.x_m[i - 1], p.x_m[i]);
        if (std::isnan(c.v[i - 1]) == std::isnan(c.v[i])) continue;
        // Braking curves go on above the frame.
        const double v = std::isnan(c.v[i]) ? c.v[i - 1] : c.v[i];
        if (v > p.top_kmh) continue;
        ++ends;
        const bool meets_ceiling = std::isnan(c.v[i - 1]) &&
                                   std::abs(v - sdm::ceiling_at(a.derived(), Place{{p.x_m[i]}}).si * kKmh) < 1e-6 &&
                                   c.key == "I";
        const Speed M = sdm::ceiling_at(a.derived(), Place{{p.x_m[i]}});
        const bool on_EBI_ceiling =
            std::isnan(c.v[i - 1]) && std::abs(v - (M + sdm::dV_ebi(M, a.derived().fixed)).si * kKmh) < 1e-6;
        EXPECT_TRUE(p.x_m[i] - p.x_m[i - 1] < 2.5e-3 || meets_ceiling || on_EBI_ceiling)
            << "case " << n << ", " << c.key << " at " << p.x_m[i - 1] << " to " << p.x_m[i] << " m, " << v << " km/h";
      }
    }
  }
  EXPECT_GT(ends, 500u);
}

/// The grid may be coarse: two curves with the same target are the same line.
TEST(Picture, ALineOfManyTargetsHasNoSlantedJoint) {
  json document = passenger();
  document["track"]["mrsp"] = {{0, 160}, {3000, 80}, {3400, 160}};
  document["target"] = {{"type", "EOA_SvL"}, {"location_m", 9000.25}};
  const Picture p = picture_of(approached(document));
  const PictureCurve& I = curve_of(p, "I");
  for (std::size_t i = 1; i < p.x_m.size(); ++i) {
    if (std::isnan(I.v[i - 1]) || std::isnan(I.v[i]) || p.x_m[i] > 8000.0) continue;
    EXPECT_LT(std::abs(I.v[i] - I.v[i - 1]), 2.0) << p.x_m[i];
  }
}

TEST(Picture, TheUsualSpeedsHaveTheEndsOfTheCurves) {
  json document = passenger();
  document.erase("query");
  document["track"]["mrsp"] = {{0, 155}};
  document["target"] = {{"type", "LOA"}, {"location_m", 7000}, {"speed_kmh", 45}};
  std::vector<double> speeds;
  for (const SpeedRow& row : curves_result(approached(document)).by_speed) speeds.push_back(row.v_kmh);
  const std::vector<double> expected{0, 10, 20, 30, 40, 45, 50, 60, 70, 80, 90, 100, 110, 120, 130, 140, 150, 155};
  EXPECT_EQ(speeds, expected);
  document["target"]["speed_kmh"] = 40;
  document["track"]["mrsp"] = {{0, 160}};
  const auto rows = curves_result(approached(document)).by_speed;
  EXPECT_EQ(rows.size(), 17u);
  EXPECT_EQ(rows.back().v_kmh, 160.0);
}

}  // namespace
}  // namespace evc::curves
