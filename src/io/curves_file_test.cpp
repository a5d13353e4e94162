#include "io/curves_file.h"

#include <gtest/gtest.h>

namespace evc::io {
namespace {

std::string document(const std::string& target, const std::string& national_values = "{}") {
  return R"({"schema":"evc-curves/1","train":{},"national_values":)" + national_values + R"(,"target":)" + target + "}";
}
std::string curves_error(const std::string& text) {
  const auto read = read_curves(text, "c.json");
  return read ? "" : read.error().text();
}

TEST(CurvesFile, TheEndOfTheDistanceToRunInSRIsATarget) {
  const auto read = read_curves(document(R"({"type":"SR","location_m":1200})"), "c.json");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->target, sdm::TargetKind::SR_end);
  EXPECT_EQ(read->inputs.SR_end, Place{1200_m});
  EXPECT_EQ(read->inputs.authority.kind, sdm::Authority::Kind::none);
  EXPECT_NE(curves_error(document(R"({"type":"SR","location_m":1200,"speed_kmh":10})")).find("3.13.8.2.1 d"),
            std::string::npos);
}

/// A document names files, not the standard input of the command.
TEST(CurvesFile, TheTrainOfAQueryIsAFile) {
  for (const char* name : {"", "-", "/nonexistent"})
    EXPECT_EQ(curves_error(R"({"schema":"evc-curves/1","train":")" + std::string(name) +
                           R"(","target":{"type":"EOA_SvL","location_m":7000}})"),
              "c.json: /train: found \"" + std::string(name) + "\", expected a train, or the name of a train file");
}

TEST(CurvesFile, TheWeakerSubsetOfKvWithoutTheDecelerationsThatDecide) {
  const std::string target = R"({"type":"EOA_SvL","location_m":7000})";
  const auto Kv = [&](const char* national_values) {
    return read_curves(document(target, national_values), "c.json")->inputs.national_values.Kv_int_passenger;
  };
  const auto weaker = Kv(R"({"Kv_int_passenger":[[0,0.7,0.8],[100,0.9,0.6]]})");
  EXPECT_EQ(weaker.steps[0].value, (train::KvPair{0.7, 0.7}));
  EXPECT_EQ(weaker.steps[1].value, (train::KvPair{0.6, 0.6}));
  const auto both = Kv(R"({"Kv_int_passenger":[[0,0.7,0.8]],"A_NVP12":0.9,"A_NVP23":1.2})");
  EXPECT_EQ(both.steps[0].value, (train::KvPair{0.7, 0.8}));
  // M_NVKVINT goes up to 2.54.
  EXPECT_EQ(curves_error(document(target, R"({"Kv_int_freight":[[0,2.5]]})")), "");
  EXPECT_NE(curves_error(document(target, R"({"Kv_int_freight":[[0,2.55]]})")).find("3.13.2.3.7.11"),
            std::string::npos);
}

/// Without speeds in the query. That of the target may lie between the highest one of the MRSP and its rounding.
TEST(CurvesFile, TheUsualSpeedsEndWithThatOfTheMRSPAndHaveThatOfTheTarget) {
  const auto speeds = [](const std::string& mrsp_kmh, const std::string& target_kmh) {
    const auto read =
        read_curves(R"({"schema":"evc-curves/1","train":{},"track":{"mrsp":[[0,)" + mrsp_kmh +
                        R"(]]},"target":{"type":"LOA","location_m":7000,"speed_kmh":)" + target_kmh + "}}",
                    "c.json");
    return read ? read->speeds_kmh : std::vector<double>{};
  };
  EXPECT_EQ(speeds("35", "12"), (std::vector<double>{0.0, 10.0, 12.0, 20.0, 30.0, 35.0}));
  EXPECT_EQ(speeds("30", "10"), (std::vector<double>{0.0, 10.0, 20.0, 30.0}));
  EXPECT_EQ(speeds("20.0000000004", "20.0000000003"), (std::vector<double>{0.0, 10.0, 20.0, 20.0000000003}));
}

}  // namespace
}  // namespace evc::io
