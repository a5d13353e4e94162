#pragma once
#include "openevc/terms/row.h"

namespace evc {

/// The train categories that the driver may choose (ERA_ERTMS_015560 11.3.9, SUBSET-026 A.3.11).
enum class TrainCategory : std::uint8_t {
  PASS1,
  PASS2,
  PASS3,
  TILT1,
  TILT2,
  TILT3,
  TILT4,
  TILT5,
  TILT6,
  TILT7,
  FP1,
  FP2,
  FP3,
  FP4,
  FG1,
  FG2,
  FG3,
  FG4,
  count
};

/// The "other international" category that a train category stands for (3.11.3.2.2).
enum class TrainCategoryBrake : std::uint8_t { passenger, freight_P, freight_G };

/// A label with the cant deficiency in millimetres.
struct TrainCategoryRow {
  TrainCategory value;
  const char* name;
  std::uint16_t cant_deficiency_mm;
  TrainCategoryBrake brake;
};

inline constexpr auto kTrainCategoryRows = std::to_array<TrainCategoryRow>({
    {TrainCategory::PASS1, "PASS 1", 80, TrainCategoryBrake::passenger},
    {TrainCategory::PASS2, "PASS 2", 130, TrainCategoryBrake::passenger},
    {TrainCategory::PASS3, "PASS 3", 150, TrainCategoryBrake::passenger},
    {TrainCategory::TILT1, "TILT 1", 165, TrainCategoryBrake::passenger},
    {TrainCategory::TILT2, "TILT 2", 180, TrainCategoryBrake::passenger},
    {TrainCategory::TILT3, "TILT 3", 210, TrainCategoryBrake::passenger},
    {TrainCategory::TILT4, "TILT 4", 225, TrainCategoryBrake::passenger},
    {TrainCategory::TILT5, "TILT 5", 245, TrainCategoryBrake::passenger},
    {TrainCategory::TILT6, "TILT 6", 275, TrainCategoryBrake::passenger},
    {TrainCategory::TILT7, "TILT 7", 300, TrainCategoryBrake::passenger},
    {TrainCategory::FP1, "FP 1", 80, TrainCategoryBrake::freight_P},
    {TrainCategory::FP2, "FP 2", 100, TrainCategoryBrake::freight_P},
    {TrainCategory::FP3, "FP 3", 130, TrainCategoryBrake::freight_P},
    {TrainCategory::FP4, "FP 4", 150, TrainCategoryBrake::freight_P},
    {TrainCategory::FG1, "FG 1", 80, TrainCategoryBrake::freight_G},
    {TrainCategory::FG2, "FG 2", 100, TrainCategoryBrake::freight_G},
    {TrainCategory::FG3, "FG 3", 130, TrainCategoryBrake::freight_G},
    {TrainCategory::FG4, "FG 4", 150, TrainCategoryBrake::freight_G},
});
static_assert(terms::in_order(kTrainCategoryRows) && kTrainCategoryRows.size() == terms::index(TrainCategory::count));

/// "PASS 1".
constexpr const char* name(TrainCategory category) { return terms::kNames<kTrainCategoryRows>[terms::index(category)]; }

}  // namespace evc
