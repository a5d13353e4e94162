#include "texts/texts.h"

#include <gtest/gtest.h>

#include <set>

namespace evc::texts {
namespace {

TEST(Texts, AClauseIsPrintedAsItStandsInTheStandard) {
  EXPECT_EQ(text_of("3.8.6"_srs), "3.8.6");
  EXPECT_EQ(text_of("A.3.4"_srs), "A.3.4");
  EXPECT_EQ(text_of("5.8.4.1 h"_srs), "5.8.4.1 h");
  EXPECT_EQ(text_of("4.8.3"_srs.exception(14)), "4.8.3 [14]");
  EXPECT_EQ(text_of(Clause{}), "");
}

TEST(Texts, EveryEventSaysWhatHappened) {
  std::set<std::string> lines;
  for (std::size_t i = 0; i < static_cast<std::size_t>(What::count); ++i) {
    const EventText& row = text_of(static_cast<What>(i));
    EXPECT_STRNE(row.subject, "") << i;
    // Without a text, the numbers of the event are the whole text.
    EXPECT_TRUE(row.text != nullptr || (row.takes != Takes::nothing && row.takes != Takes::id)) << i;
    const std::string line = std::string(row.subject) + "|" + (row.text == nullptr ? "" : row.text) + "|" +
                             std::to_string(static_cast<int>(row.takes));
    EXPECT_TRUE(lines.insert(line).second) << "two events read the same: " << line;
  }
}

TEST(Texts, NamesAreDifferent) {
  std::set<std::string> faults, selects, outputs;
  for (std::size_t i = 0; i < static_cast<std::size_t>(train::Fault::count); ++i)
    EXPECT_TRUE(faults.insert(name(static_cast<train::Fault>(i))).second) << i;
  for (const char* n : kSelectNames) EXPECT_TRUE(selects.insert(n).second) << n;
  for (std::size_t i = 0; i < driver::kOutputs; ++i)
    EXPECT_TRUE(outputs.insert(name(static_cast<driver::Output>(i))).second) << i;
  // The names are in the order of the enumerators.
  EXPECT_STREQ(name(train::Fault::A_NVMAXREDADH), "A_NVMAXREDADH");
  EXPECT_STREQ(name(train::Fault::correction_factor), "correction_factor");
  EXPECT_STREQ(kSelectNames[static_cast<std::size_t>(port::Select::adhesion_normal)], "adhesion_normal");
  EXPECT_STREQ(words_of(port::Select::exit_shunting), "exit of shunting");
  EXPECT_STREQ(words_of(port::Entered::SR_speed_distance), "SR speed and distance");
}

TEST(Texts, KeysOfTheDriversInputs) {
  EXPECT_STREQ(keys_of(DriverInput::continue_shunting)[0], "maintain_shunting");
  EXPECT_STREQ(keys_of(DriverInput::adhesion)[1], "adhesion_normal");
  EXPECT_EQ(keys_of(DriverInput::ack_OS)[0], nullptr);
  // Every choice of `select` but the request to enter train data and a button of the main window is one of 4.7.2.
  std::set<std::string> keys;
  for (std::size_t i = 0; i < static_cast<std::size_t>(DriverInput::count); ++i)
    for (const char* key : keys_of(static_cast<DriverInput>(i)))
      if (key != nullptr) {
        EXPECT_TRUE(keys.insert(key).second) << key;
      }
  keys.insert("main");
  for (const char* select : kSelectNames) EXPECT_EQ(keys.count(select), 1u) << select;
}

}  // namespace
}  // namespace evc::texts
