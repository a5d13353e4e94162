#include <gtest/gtest.h>

#include <initializer_list>
#include <iterator>
#include <string>
#include <utility>

#include "terms/data_status.h"
#include "terms/information.h"
#include "terms/level.h"
#include "terms/mode.h"
#include "terms/monitoring.h"
#include "terms/radio_link.h"
#include "terms/reaction.h"
#include "terms/requests.h"
#include "terms/srs_version.h"
#include "terms/stored.h"
#include "terms/track_condition.h"
#include "terms/train_integrity.h"

namespace evc {
namespace {

// 7.5.1.72 of 4.0.0, transcribed in the order of the codes.
constexpr const char* kByCode[] = {"FS", "OS", "SR", "SH", "UN", "SL", "SB", "TR", "PT",
                                   "SF", "IS", "NL", "LS", "SN", "RV", "PS", "AD", "SM"};

TEST(Terms, ModesHaveTheCodesOfMMode) {
  static_assert(std::size(kByCode) == kModes - 1, "all but NP");
  for (std::uint8_t code = 0; code < std::size(kByCode); ++code) {
    EXPECT_STREQ(name(mode_of(code)), kByCode[code]);
    EXPECT_EQ(M_MODE(mode_of(code), 2, 3), code);
    EXPECT_EQ(M_MODE(mode_of(code), 3, 0), code);
  }
  EXPECT_EQ(M_MODE(Mode::NP, 3, 0), M_MODE(Mode::SB, 3, 0)) << "NP is never reported";
  EXPECT_EQ(mode_of(18), Mode::NP) << "a code that names no mode";
}

// 6.6.3.4.5 [1a], 6.6.5.3.7 [1a]: the code of 3.0, and what an older version has instead. SM is not reported to it.
TEST(Terms, ModesHaveOtherCodesInOlderVersions) {
  for (std::size_t m = 0; m < kModes; ++m) {
    const Mode mode = static_cast<Mode>(m);
    const std::uint8_t newest = M_MODE(mode, 3, 0);
    if (mode == Mode::SM) continue;
    EXPECT_EQ(M_MODE(mode, 2, 2), newest) << name(mode);
    for (const std::uint8_t Y : {std::uint8_t{0}, std::uint8_t{1}}) {
      EXPECT_EQ(M_MODE(mode, 2, Y), newest == 16 ? 0 : newest) << name(mode);
      EXPECT_EQ(M_MODE(mode, 1, Y), newest == 16 ? 0 : newest == 15 ? 3 : newest) << name(mode);
    }
  }
  for (const auto& [X, Y] : std::initializer_list<std::pair<std::uint8_t, std::uint8_t>>{{1, 0}, {2, 1}, {2, 2}})
    EXPECT_EQ(M_MODE(Mode::SM, X, Y), M_MODE(Mode::SH, X, Y)) << "6.6.4.3.1: it cannot authorise SM";
}

TEST(Terms, ModesOfAreas) {  // 7.5.1.70
  EXPECT_EQ(mode_of_area(0), Mode::OS);
  EXPECT_EQ(mode_of_area(1), Mode::SH);
  EXPECT_EQ(mode_of_area(2), Mode::LS);
}

TEST(Terms, ModesThatSuperviseAnAuthority) {
  std::string modes;
  for (const auto& row : kModeRows)
    if (supervises_authority(row.value)) modes += row.name;
  EXPECT_EQ(modes, "FSLSOSSMAD");
}

TEST(Terms, Levels) {  // 7.5.1.65, 7.5.1.67
  const char* names[] = {"0", "NTC", "1", "2", "3"};
  for (std::uint8_t code = 0; code < 5; ++code) {
    ASSERT_TRUE(level_of(code));
    EXPECT_STREQ(name(*level_of(code)), names[code]);
    EXPECT_EQ(M_LEVEL(*level_of(code)), code);
    EXPECT_EQ(level_2_or_3(*level_of(code)), code >= 3);
    EXPECT_EQ(level_1_2_3(*level_of(code)), code >= 2);
  }
  EXPECT_FALSE(level_of(5));
  EXPECT_FALSE(level_of(255));
  EXPECT_FALSE(level_2_or_3(std::optional<Level>{}));
}

TEST(Terms, Reactions) {  // 7.5.1.117
  EXPECT_EQ(reaction_of(0), Reaction::trip);
  EXPECT_EQ(reaction_of(1), Reaction::service_brake);
  EXPECT_EQ(reaction_of(2), Reaction::none);
  EXPECT_FALSE(reaction_of(3));
  EXPECT_TRUE(stronger(Reaction::trip, Reaction::service_brake));
  EXPECT_TRUE(stronger(Reaction::service_brake, Reaction::none));
  EXPECT_FALSE(stronger(Reaction::none, Reaction::none));
}

TEST(Terms, StatusOfData) {  // 7.5.1.134
  EXPECT_EQ(Q_STATUS(DataStatus::invalid), 0);
  EXPECT_EQ(Q_STATUS(DataStatus::valid), 1);
  EXPECT_EQ(Q_STATUS(DataStatus::unknown), 2);
}

TEST(Terms, TrackConditions) {  // 7.5.1.77, 7.5.1.135
  EXPECT_EQ(track_condition_of(3), TrackConditionKind::powerless_lower_pantograph);
  EXPECT_EQ(track_condition_of(10), TrackConditionKind::switch_off_eddy_current_emergency_brake);
  EXPECT_FALSE(track_condition_of(11));
  EXPECT_EQ(suitability_of(2), Suitability::traction);
  EXPECT_FALSE(suitability_of(3));
  for (const auto& row : kTrackConditionRows) EXPECT_EQ(horn_or_stopping(row.value), row.code <= 2) << row.name;
}

template <class Rows>
void expect_distinct_names(const Rows& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) EXPECT_STRNE(rows[i].name, rows[k].name);
}

TEST(Terms, NoNameTwice) {
  expect_distinct_names(kModeRows);
  expect_distinct_names(kLevelRows);
  expect_distinct_names(kSrsVersionRows);
  expect_distinct_names(kDataStatusRows);
  expect_distinct_names(kReactionRows);
  expect_distinct_names(kRadioLinkRows);
  expect_distinct_names(kTrainIntegrityRows);
  expect_distinct_names(kMonitoringRows);
  expect_distinct_names(kStatusRows);
  expect_distinct_names(kAckRows);
  expect_distinct_names(kEntryRows);
  expect_distinct_names(kTrackConditionRows);
  expect_distinct_names(kSuitabilityRows);
  expect_distinct_names(kStoredRows);
  expect_distinct_names(kInformationRows);
}

}  // namespace
}  // namespace evc
