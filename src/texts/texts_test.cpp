#include "texts/texts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <string_view>

#include "terms/edition_gap.h"

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
                             std::to_string(static_cast<int>(row.takes)) + "|" +
                             (row.after_clause == nullptr ? "" : row.after_clause);
    EXPECT_TRUE(lines.insert(line).second) << "two events read the same: " << line;
  }
}

/// With the longest numbers, words and clause that there are.
TEST(Texts, TheLineOfEveryEventIsWhole) {
  Clause longest = "3.8.6"_srs;
  for (const Clause c :
       {"5.8.4.1 h"_srs, "4.8.3"_srs.exception(99), "4.8.4 infill"_srs, "3.16.2.3.2"_srs.exception(99)})
    if (text_of(c).size() > text_of(longest).size()) longest = c;
  std::size_t longest_paragraph = 0;
  for (const std::string_view paragraph : kSrsClauses)
    longest_paragraph = std::max(longest_paragraph, paragraph.size());
  const std::size_t more = longest_paragraph + 5 - text_of(longest).size();  // " [99]"
  const auto length = [&](What what, std::int32_t id) {
    const port::Event event{what, std::uint8_t(Mode::NP), std::uint8_t(Mode::SB), id, longest};
    const ShortText text = line_of(event);
    const std::string_view line = text.view();
    EXPECT_EQ(line.back(), ']') << line;
    return line.size() + more;
  };
  for (std::size_t i = 0; i < static_cast<std::size_t>(What::count); ++i) {
    const auto what = static_cast<What>(i);
    const Takes takes = text_of(what).takes;
    const std::size_t ids = takes == Takes::select    ? static_cast<std::size_t>(port::Select::count)
                            : takes == Takes::entered ? static_cast<std::size_t>(port::Entered::count)
                            : takes == Takes::ack     ? static_cast<std::size_t>(Ack::count)
                            : takes == Takes::fault   ? static_cast<std::size_t>(train::Fault::count)
                            : takes == Takes::gap     ? static_cast<std::size_t>(EditionGap::count)
                                                      : 0;
    if (ids == 0) {
      EXPECT_LE(length(what, std::numeric_limits<std::int32_t>::min()), ShortText::kMost) << i;
    }
    for (std::size_t id = 0; id < ids; ++id)
      EXPECT_LE(length(what, static_cast<std::int32_t>(id)), ShortText::kMost) << i;
  }
}

TEST(Texts, WhatDoesNotFitIsLeftOut) {
  ShortText text;
  text.add(std::string(ShortText::kMost - 3, 'a'));
  text.add(std::int64_t{-12345});
  text.add("b");
  EXPECT_EQ(text.view(), std::string(ShortText::kMost - 3, 'a') + "-12");
}

TEST(Texts, NamesAreDifferent) {
  std::set<std::string> faults, selects;
  for (std::size_t i = 0; i < static_cast<std::size_t>(train::Fault::count); ++i)
    EXPECT_TRUE(faults.insert(name(static_cast<train::Fault>(i))).second) << i;
  for (const char* n : kSelectNames) EXPECT_TRUE(selects.insert(n).second) << n;
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
  // Every choice of `select` but a button of the main window and the toggle function is one of 4.7.2.
  std::set<std::string> keys;
  for (std::size_t i = 0; i < static_cast<std::size_t>(DriverInput::count); ++i)
    for (const char* key : keys_of(static_cast<DriverInput>(i)))
      if (key != nullptr) {
        EXPECT_TRUE(keys.insert(key).second) << key;
      }
  keys.insert({"main", "toggle"});
  for (const char* select : kSelectNames) EXPECT_EQ(keys.count(select), 1u) << select;
}

}  // namespace
}  // namespace evc::texts
