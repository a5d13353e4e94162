#include "io/train_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <vector>

#include "base/test_paths.h"

namespace evc::io {
namespace {

std::string train_error(const char* text) {
  const auto train = read_train(text, "t.json");
  return train ? "" : train.error().text();
}

TEST(TrainFile, AnEmptyOneIsTheStandardTrain) {
  const auto train = read_train(R"({"schema":"etcs-train/1"})", "t.json");
  ASSERT_TRUE(train) << train.error().text();
  EXPECT_EQ(train->data, train::TrainData{});
  EXPECT_EQ(train->name, "passenger, 135 %");
  EXPECT_EQ(train->dynamics.mass_t, 200.0);
}

TEST(TrainFile, AReactionTimeThatIsNotGivenIsTheWholeBuildUpTime) {
  const auto train = read_train(R"({"schema":"etcs-train/1","brake_model":"gamma","A_brake_emergency":[[0,1]],
    "A_brake_service":[[0,0.8]],"T_brake_emergency_s":4,"T_brake_service_s":6,"T_brake_service_react_s":2})",
                                "t.json");
  ASSERT_TRUE(train) << train.error().text();
  EXPECT_EQ(train->data.T_emergency[0].T_brake_react, 4_s);
  EXPECT_EQ(train->data.T_service[0].T_brake_react, 2_s);
}

TEST(TrainFile, EveryPlainKeyArrives) {
  const auto train = read_train(R"({"schema":"etcs-train/1","name":"x","brake_model":"lambda",
    "brake_position":"FreightG","brake_percentage":65,"length_m":600,"max_speed_kmh":100,"L_antenna_front_m":3,
    "M_rotating_nom_pct":8,"T_traction_cut_off_s":6,"traction_cut_off_interface":false,
    "service_brake_interface":false,"service_brake_feedback":true,
    "category":{"cant_deficiency_mm":80,"other":["FreightG"],"axle_load":"D4","loading_gauge":"GC",
                "traction_systems":[1,{"M_VOLTAGE":3,"NID_CTRACTION":7}],"airtight":true},
    "dynamics":{"mass_t":1600,"davis":[1,2,3],"tractive_effort":[[0,300],[100,100]],
                "brake":{"emergency":[[0,0.8]],"service":[[0,0.7]],"build_up_s":12}}})",
                                "t.json");
  ASSERT_TRUE(train) << train.error().text();
  const auto& d = train->data;
  EXPECT_EQ(d.brake_position, train::BrakePosition::FreightG);
  EXPECT_EQ(d.brake_percentage, 65.0);
  EXPECT_EQ(d.L_TRAIN, 600_m);
  EXPECT_EQ(d.V_MAXTRAIN, 100_km_h);
  EXPECT_EQ(d.L_antenna_front, 3_m);
  EXPECT_EQ(d.M_rotating_nom, 8.0);
  EXPECT_EQ(d.T_traction_cut_off, 6_s);
  EXPECT_FALSE(d.traction_cut_off_interface);
  EXPECT_FALSE(d.service_brake_interface);
  EXPECT_TRUE(d.service_brake_feedback);
  EXPECT_EQ(d.cant_deficiency_mm, 80);
  EXPECT_EQ(d.other_categories, train::kFreightG);
  EXPECT_EQ(d.axle_load, train::AxleLoad::D4);
  EXPECT_EQ(d.loading_gauge, train::LoadingGauge::GC);
  ASSERT_EQ(d.traction_systems.size(), 2u);
  EXPECT_EQ(d.traction_systems[1], (train::TractionSystem{7, 3}));
  EXPECT_TRUE(d.airtight);
  EXPECT_EQ(train->dynamics.mass_t, 1600.0);
  EXPECT_EQ(train->dynamics.build_up_s, 12.0);
  EXPECT_EQ(sim::at(train->dynamics.tractive_effort, 50.0), 200.0);
}

TEST(TrainFile, GammaStepsAndFactorsGetCommonSteps) {
  const auto train = read_train(R"({"schema":"etcs-train/1","brake_model":"gamma",
    "A_brake_emergency":[[0,1.2],[100,1.0]],"Kdry_rst":[[0,0.8],[150,0.7]],"Kwet_rst":[[0,0.9]],
    "A_brake_service":[[0,0.9]],"A_brake_normal_service":[[0,0.6]],"Kn_plus":[[0,5]],"Kn_minus":[[0,4]],
    "T_brake_emergency_s":2.5,"T_brake_service_s":3.5})",
                                "t.json");
  ASSERT_TRUE(train) << train.error().text();
  const auto& e = train->data.emergency[0].steps;
  ASSERT_EQ(e.size(), 3u);
  EXPECT_EQ(e.steps[1].from, 100_km_h);
  EXPECT_EQ(e.steps[1].value.A_brake_emergency, 1.0_m_s2);
  EXPECT_EQ(e.steps[1].value.Kdry_rst[9].value(), 0.8);
  EXPECT_EQ(e.steps[2].from, 150_km_h);
  EXPECT_EQ(e.steps[2].value.Kdry_rst[0].value(), 0.7);
  EXPECT_EQ(e.steps[2].value.Kwet_rst.value(), 0.9);
  EXPECT_EQ(train->data.T_emergency[0].T_brake, 2.5_s);
  EXPECT_EQ(train->data.normal_service.A_brake_normal_service[2].at({}), 0.6_m_s2);
  EXPECT_EQ(train->data.Kn_minus.at({}), 4_m_s2);
}

TEST(TrainFile, NormalServiceOfTheBrakePositionG) {
  const auto train = read_train(R"({"schema":"etcs-train/1","A_brake_normal_service":[[0,0.6]],
    "A_brake_normal_service_G":{"A_SB01":0.4,"A_SB12":0.7,"models":[[[0,0.1]],[[0,0.2],[50,0.15]],[[0,0.3]]]}})",
                                "t.json");
  ASSERT_TRUE(train) << train.error().text();
  EXPECT_EQ(train->data.normal_service.A_brake_normal_service[1].at({}), 0.6_m_s2);
  ASSERT_TRUE(train->data.normal_service_G);
  EXPECT_EQ(train->data.normal_service_G->A_SB12, 0.7_m_s2);
  EXPECT_EQ(train->data.normal_service_G->A_brake_normal_service[1].size(), 2u);
  EXPECT_EQ(train_error(R"({"schema":"etcs-train/1","A_brake_normal_service_G":[[0,11]]})"),
            "t.json: /A_brake_normal_service_G/0/1: found 11, expected a number from 0.0 to 10.0 (SUBSET-026 "
            "3.13.2.2.3.1.9)");
  EXPECT_EQ(
      train_error(R"({"schema":"etcs-train/1","A_brake_normal_service_G":{"A_SB01":0.4,"A_SB12":0.3,"models":[]}})"),
      "t.json: /A_brake_normal_service_G/A_SB12: found 0.3, expected a number from 0.4 to 10.0 (SUBSET-026 "
      "3.13.2.2.3.1.9)");
}

TEST(TrainFile, SpecialBrakes) {
  const auto train = read_train(R"({"schema":"etcs-train/1","brake_model":"gamma",
    "A_brake_emergency":[[0,1.2]],"A_brake_service":[[0,0.9]],"T_brake_emergency_s":2.5,"T_brake_service_s":3.5,
    "special_brakes":{"regenerative":"affects both","magnetic shoe":"status affects EB only",
      "models":[{"with":["regenerative","magnetic shoe"],"A_brake_emergency":[[0,1.5]],"T_brake_emergency_s":2}]}})",
                                "t.json");
  ASSERT_TRUE(train) << train.error().text();
  EXPECT_EQ(train->data.regenerative, train::SpecialBrakeInterface::both);
  ASSERT_EQ(train->data.emergency.size(), 2u);
  EXPECT_EQ(train->data.emergency[1].with, train::kRegenerative | train::kMagneticShoe);
}

TEST(TrainFile, ErrorsNameThePlace) {
  EXPECT_EQ(train_error(R"({"schema":"etcs-train/1","lenght_m":200})").substr(0, 41),
            "t.json: /lenght_m: found an unknown key, ");
  EXPECT_EQ(train_error(R"({"schema":"etcs-train/1","length_m":"long"})"),
            "t.json: /length_m: found \"long\", expected a number");
  EXPECT_NE(train_error(R"({"schema":"etcs-train/1","brake_model":"gamma"})").find("A_brake_emergency"),
            std::string::npos);
  EXPECT_NE(train_error(R"({"schema":"etcs-line/1"})").find("/schema"), std::string::npos);
  EXPECT_NE(train_error(R"({"schema":"etcs-train/1","A_brake_service":[[0,1],[0,2]]})").find("/A_brake_service/1/0"),
            std::string::npos);
  EXPECT_EQ(train_error("{\n \"schema\": }"), "t.json: line 2 column 12: found \"}\", expected JSON");
  EXPECT_NE(train_error(R"({"schema":"etcs-train/1","brake_percentage":1e999})"), "");
}

/// Data that the kernel would reject are rejected by the reader.
TEST(TrainFile, WhatTheConversionModelDoesNotCover) {
  EXPECT_EQ(train_error(R"({"schema":"etcs-train/1","brake_percentage":20})"),
            "t.json: /brake_percentage: found 20, expected 30 to 250 % (SUBSET-026 3.13.3.2.1 b)");
  EXPECT_EQ(train_error(R"({"schema":"etcs-train/1","max_speed_kmh":250})"),
            "t.json: /max_speed_kmh: found 250, expected at most 200 km/h with a brake percentage (SUBSET-026 "
            "3.13.3.2.1 a)");
  EXPECT_EQ(train_error(R"({"schema":"etcs-train/1","length_m":901})").substr(0, 29), "t.json: /length_m: found 901,");
  EXPECT_EQ(train_error(R"({"schema":"etcs-train/1","length_m":901,"brake_position":"FreightP"})"), "");
  EXPECT_EQ(train_error(R"({"schema":"etcs-train/1","length_m":2000,"brake_position":"FreightP"})").substr(0, 30),
            "t.json: /length_m: found 2000,");
  // The default antenna does not fit a train of 3 m.
  EXPECT_NE(train_error(R"({"schema":"etcs-train/1","length_m":3})").find("L_antenna_front_m"), std::string::npos);
}

TEST(TrainFile, FactorsAndTimesThatCannotBe) {
  const auto gamma = [](const std::string& more) {
    return train_error((R"({"schema":"etcs-train/1","brake_model":"gamma","A_brake_emergency":[[0,1.2]],
      "A_brake_service":[[0,0.9]],"T_brake_emergency_s":2.5,"T_brake_service_s":3.5,)" +
                        more + "}")
                           .c_str());
  };
  EXPECT_EQ(gamma(R"("max_speed_kmh":250,"length_m":2000)"), "");
  EXPECT_EQ(gamma(R"("Kdry_rst":[[0,0.9],[100,1.1]])").substr(0, 35), "t.json: /Kdry_rst/1/1: found 1.1, e");
  EXPECT_NE(gamma(R"("Kwet_rst":[[0,1.01]])").find("3.13.2.2.9.1"), std::string::npos);
  EXPECT_EQ(gamma(R"("T_brake_service_react_s":3.6)").substr(0, 47), "t.json: /T_brake_service_react_s: found 3.6, ex");
}

TEST(TrainFile, WhatTheDriverEntersIsForTheOnBoardToRefuse) {
  const Json json = Json::parse(R"({"brake_percentage":20})");
  EXPECT_EQ(read_entered_train(JsonPlace(json, "t.json")).data.brake_percentage, 20.0);
  EXPECT_THROW(read_train(JsonPlace(json, "t.json")), ReadError);
}

TEST(NationalValues, WhatTheKernelWouldRefuse) {
  const auto error_in = [](const char* text) -> std::string {
    const Json json = Json::parse(text);
    try {
      (void)read_national_values(JsonPlace(json, "n.json"));
    } catch (const ReadError& error) {
      return error.diagnostic.text();
    }
    return "";
  };
  EXPECT_EQ(error_in(R"({"Kt_int":1.7})"), "n.json: /Kt_int: found 1.7, expected 0 to 1.55 (SUBSET-026 3.13.2.3.7.14)");
  EXPECT_EQ(error_in(R"({"Kr_int":[[0,0.9],[300,1.6]]})"),
            "n.json: /Kr_int/1/1: found 1.6, expected 0 to 1.55 (SUBSET-026 3.13.2.3.7.12)");
  EXPECT_EQ(error_in(R"({"A_NVP12":0.9})"),
            "n.json: /A_NVP12: found 0.9, expected A_NVP12 not above A_NVP23 (SUBSET-026 3.13.2.3.7.11.5)");
  EXPECT_NE(error_in(R"({"A_NVMAXREDADH2":4})").find("n.json: /A_NVMAXREDADH2: found 4, expected"), std::string::npos);
  EXPECT_EQ(error_in(R"({"A_NVP12":0.9,"A_NVP23":1.1,"A_NVMAXREDADH2":3.15,"Kt_int":1.55})"), "");
}

TEST(NationalValues, NamesUnitsAndInfinity) {
  const Json json = Json::parse(R"({"V_NVREL":15,"D_NVSTFF":null,"T_NVCONTACT":35,"M_NVCONTACT":0,
    "Kv_int_passenger":[[0,0.7,0.6],[150,0.65,0.5]],"A_NVP12":0.9,"A_NVP23":1.2,"Kr_int":[[0,0.95],[400,0.9]],"A_NVMAXREDADH2":"no maximum"})");
  const auto nv = read_national_values(JsonPlace(json, "n.json"));
  EXPECT_EQ(nv.V_NVREL, 15_km_h);
  EXPECT_FALSE(nv.D_NVSTFF);
  EXPECT_EQ(nv.T_NVCONTACT, 35_s);
  EXPECT_EQ(nv.M_NVCONTACT, Reaction::trip);
  EXPECT_EQ(nv.Kv_int_passenger.steps[1].value, (train::KvPair{0.65, 0.5}));
  EXPECT_EQ(nv.Kr_int.at(400_m), 0.9);
  EXPECT_TRUE(nv.A_NVMAXREDADH2.no_maximum);
  EXPECT_EQ(nv.V_NVSTFF, train::NationalValues{}.V_NVSTFF);
  const Json wrong = Json::parse(R"({"V_NVRELL":15})");
  EXPECT_THROW(read_national_values(JsonPlace(wrong, "n.json")), ReadError);
}

// ---- Ranges -----------------------------------------------------------------------------------------

/// Every number in a document.
void numbers_in(Json& value, std::vector<Json*>& found) {
  if (value.is_number()) found.push_back(&value);
  if (value.is_structured())
    for (Json& member : value) numbers_in(member, found);
}

/// Each number of the document far outside its range, one at a time: `error_of(document)` has to name the clause.
template <class ErrorOf>
int refused_with_clause(Json document, ErrorOf error_of) {
  std::vector<Json*> numbers;
  numbers_in(document, numbers);
  for (Json* number : numbers)
    for (const double outside : {-1e7, 1e7}) {
      const Json good = *number;
      *number = outside;
      const std::string error = error_of(document);
      EXPECT_NE(error.find("(SUBSET-026 "), std::string::npos) << error << "\n" << document.dump();
      *number = good;
    }
  return static_cast<int>(numbers.size());
}

std::vector<Json> shipped(const char* folder) {
  std::vector<Json> documents;
  for (const auto& file : std::filesystem::directory_iterator(evc::test::source_folder() + "/data/" + folder))
    if (file.path().extension() == ".json") documents.push_back(Json::parse(std::ifstream(file.path())));
  return documents;
}

TEST(Ranges, WhatATrainCannotBeIsRefusedWithTheClause) {
  int numbers = 0;
  for (Json train : shipped("trains")) {
    // Braking curves do not use simulation data and categories of speed restrictions.
    train.erase("dynamics");
    train.erase("category");
    numbers += refused_with_clause(train, [](const Json& d) { return read_train(d.dump(), "t.json").error().text(); });
  }
  EXPECT_GT(numbers, 100);
}

TEST(Ranges, WhatNationalValuesCannotBeIsRefusedWithTheClause) {
  int numbers = 0;
  for (Json values : shipped("national_values")) {
    values.erase("schema");
    values.erase("name");
    numbers += refused_with_clause(values, [](const Json& d) -> std::string {
      try {
        (void)read_national_values(JsonPlace(d, "n.json"));
      } catch (const ReadError& e) {
        return e.diagnostic.text();
      }
      return "accepted";
    });
  }
  EXPECT_GT(numbers, 30);
}

}  // namespace
}  // namespace evc::io
