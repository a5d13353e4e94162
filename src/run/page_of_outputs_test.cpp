#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>

#include "base/test_paths.h"
#include "io/program_test.h"
#include "terms/cause.h"
#include "terms/monitoring.h"
#include "terms/requests.h"

// docs/replay.md has every output: what a partner of the unit reads is on its page.
namespace evc::run {
namespace {

using nlohmann::json;
using Names = std::set<std::string>;

std::string page_of(const char* name) { return text_of(evc::test::source_folder() + "/docs/" + name); }

/// What is in backquotes, and what is in quotation marks there.
Names names_in(const std::string& page) {
  Names names;
  const std::regex code("`([^`]*)`"), word("\"([^\"]*)\"");
  for (std::sregex_iterator at(page.begin(), page.end(), code), end; at != end; ++at) {
    const std::string text = (*at)[1];
    names.insert(text);
    for (std::sregex_iterator in(text.begin(), text.end(), word); in != end; ++in) names.insert((*in)[1]);
  }
  return names;
}

/// The keys of all objects in a value. `ato` is what the unit does not have.
void add_keys(Names& keys, const json& value) {
  if (value.is_array())
    for (const json& item : value) add_keys(keys, item);
  if (!value.is_object()) return;
  for (const auto& [key, member] : value.items()) {
    keys.insert(key);
    if (key != "ato") add_keys(keys, member);
  }
}

TEST(PageOfOutputs, HasEveryKeyOfALine) {
  const Folder folder("page_of_outputs");
  ASSERT_EQ(ended("run -o '" + folder.path() + "'").exit_code, 0);
  const std::string outputs = ended("replay '" + (folder / "inputs.jsonl") + "' --planning --dmi --every 200").output;
  Names keys;
  for (std::size_t at = 0, end = 0; (end = outputs.find('\n', at)) != std::string::npos; at = end + 1)
    add_keys(keys, json::parse(outputs.substr(at, end - at)));
  ASSERT_GT(keys.size(), 150u);
  Names known = names_in(page_of("replay.md"));
  known.merge(names_in(page_of("train.md")));  // the keys of train data
  for (const std::string& key : keys) EXPECT_TRUE(known.count(key) == 1) << key;
}

TEST(PageOfOutputs, HasTheNamesOfWhatIsAskedForAndCommanded) {
  const Names known = names_in(page_of("replay.md"));
  const auto has = [&](const auto& rows, std::size_t first) {
    for (std::size_t n = first; n < rows.size(); ++n) EXPECT_TRUE(known.count(rows[n].name) == 1) << rows[n].name;
  };
  has(kAckRows, 0);
  has(kEntryRows, 0);
  has(kCauseRows, 0);
  has(kMonitoringRows, 1);  // the first one is null
  has(kStatusRows, 1);
  has(kMemoStatusRows, 0);
}

}  // namespace
}  // namespace evc::run
