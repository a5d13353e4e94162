#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "ways.h"

// Every packet and message to the train in a state of the on-board in which it is accepted. In each of its fields every
// code with a meaning is accepted, with the event that shows it, and every spare code makes the telegram or message
// refused (3.16.1.1, 3.16.3.1.1).
namespace evc::through_step {
namespace {

bool is_length_or_number(const std::string& name) {
  return name == "L_PACKET" || name == "L_MESSAGE" || name == "NID_PACKET" || name == "NID_MESSAGE";
}

/// Codes of packets that are longer than a telegram with them.
const std::set<std::string> kTooLong{"P206 N_ITER 31",     "P207 N_ITER 31", "P21 N_ITER 31", "P27 N_ITER 31",
                                     "P3 N_ITER_KVSET 31", "P5 N_ITER 31",   "P51 N_ITER 31", "P52 N_ITER 31",
                                     "P67 N_ITER 31",      "P68 N_ITER 31",  "P69 N_ITER 31", "P70 N_ITER 31",
                                     "P72 L_TEXT 255",     "P79 N_ITER 31",  "P80 N_ITER 31"};

/// `ignored`: the packet is not read (6.6.3.1.1.1).
void check_field(char of, unsigned number, const Field& f, bool ignored, const std::string& sv,
                 const std::function<std::optional<Answer>(std::uint64_t)>& send) {
  SCOPED_TRACE(std::string(1, of) + std::to_string(number) + " " + f.path);
  const Json& v = variable(f.variable);
  const auto key = [&](std::uint64_t code) {
    return std::string(1, of) + std::to_string(number) + " " + f.path + " " + std::to_string(code);
  };
  const Way way = of == 'P' ? way_of_packet(number) : way_of_message(number);
  const std::string accepted = ignored ? "packet " + std::to_string(number) + " not used"
                               : !way.says.empty()
                                   ? way.says
                                   : (of == 'P' ? "packet " : "message ") + std::to_string(number) + " accepted";
  for (const std::uint64_t code : codes_of(v)) {
    const auto answer = send(code);
    EXPECT_EQ(answer.has_value(), !kTooLong.contains(key(code))) << key(code);
    if (!answer) continue;
    const std::string instead = said_instead(of, number, f.path, code, sv);
    EXPECT_NE(answer->event({instead.empty() ? accepted : instead}), "")
        << code << " is a code with a meaning" << answer->text();
    EXPECT_EQ(answer->event({"not decoded"}), "") << code << answer->text();
  }
  for (const std::uint64_t code : spare_codes_of(v)) {
    const auto answer = send(code);
    EXPECT_EQ(answer.has_value(), !kTooLong.contains(key(code))) << key(code);
    if (!answer) continue;
    if (ignored) {
      if (f.path == "Q_DIR") continue;
      EXPECT_NE(answer->event({accepted}), "") << code << " is spare, and not read" << answer->text();
      continue;
    }
    const bool refused = !answer->event({"telegram not decoded [3.16.1.1]"}).empty() ||
                         !answer->event({"rejected [3.16.3.1.1]"}).empty() ||
                         !answer->event({"loop", "refused [3.16"}).empty();
    EXPECT_TRUE(refused) << code << " is spare" << answer->text();
    EXPECT_EQ(answer->event({accepted}), "") << code << " is spare" << answer->text();
  }
}

/// All fields of packets and messages to the train whose variable's name begins so.
void check_fields(const std::string& prefix, const std::string& sv = "2.1") {
  const auto begins = [&](const Field& f) {
    return f.variable.substr(0, prefix.size()) == prefix && !is_length_or_number(f.variable);
  };
  const auto has_version = [&](const Json& row) {
    return std::find(row.at("sv").begin(), row.at("sv").end(), sv) != row.at("sv").end();
  };
  std::size_t fields = 0;
  for (const Json& p : reference("packets_to_train").at("packets")) {
    const unsigned id = p.at("id");
    if (!has_version(p)) continue;
    for (const Field& f : fields_of(p.at("elements"))) {
      if (!begins(f)) continue;
      ++fields;
      check_field('P', id, f, id == 76 && sv[0] == '1', sv, [&](std::uint64_t code) {
        Codes codes = f.needs;
        codes[f.path] = code;
        return send_packet(id, sv, codes);
      });
    }
  }
  EXPECT_GT(fields, 0u);
  for (const Json& m : reference("messages_to_train").at("messages")) {
    const unsigned id = m.at("id");
    if (!has_version(m)) continue;
    for (const Field& f : fields_of(m.at("elements"))) {
      if (!begins(f)) continue;
      ++fields;
      check_field('M', id, f, false, sv, [&](std::uint64_t code) {
        return std::optional(send_message(id, {{f.path, code}}, 0, sv));
      });
    }
  }
}

constexpr const char* kPrefixes[] = {"A_", "D_", "G_", "L_", "M_", "N_", "NC_", "NID_", "Q_", "T_", "V_", "X_"};

/// The tests of codes below, those of headers and lengths, and those of messages to the track are all.
TEST(LanguageThroughStep, EveryVariableIsInAMessage) {
  std::set<std::string> named{"Q_UPDOWN", "M_VERSION", "Q_MEDIA", "N_PIG",  "N_TOTAL", "M_DUP",
                              "M_MCOUNT", "NID_C",     "NID_BG",  "Q_LINK", "NID_LOOP"};  // 8.4.2.1, 8.4.3
  for (const char* file : {"packets_to_train", "packets_to_track", "messages_to_train", "messages_to_track"})
    for (const char* list : {"packets", "messages"})
      if (reference(file).contains(list))
        for (const Json& row : reference(file).at(list))
          for (const Field& f : fields_of(row.at("elements"))) named.insert(f.variable);
  for (const auto& [key, row] : reference("variables").at("variables").items()) {
    EXPECT_TRUE(named.contains(key)) << key;
    int groups = 0;
    for (const char* prefix : kPrefixes) groups += key.rfind(prefix, 0) == 0 ? 1 : 0;
    EXPECT_EQ(groups, 1) << key;
  }
}

TEST(LanguageThroughStep, CodesOfAccelerations) { check_fields("A_"); }
TEST(LanguageThroughStep, CodesOfDistances) { check_fields("D_"); }
TEST(LanguageThroughStep, CodesOfGradients) { check_fields("G_"); }
TEST(LanguageThroughStep, CodesOfLengths) { check_fields("L_"); }
TEST(LanguageThroughStep, CodesOfM) { check_fields("M_"); }
TEST(LanguageThroughStep, CodesOfNumbers) { check_fields("N_"); }
TEST(LanguageThroughStep, CodesOfCategories) { check_fields("NC_"); }
TEST(LanguageThroughStep, CodesOfIdentities) { check_fields("NID_"); }
TEST(LanguageThroughStep, CodesOfQualifiers) { check_fields("Q_"); }
TEST(LanguageThroughStep, CodesOfTimes) { check_fields("T_"); }
TEST(LanguageThroughStep, CodesOfSpeeds) { check_fields("V_"); }
TEST(LanguageThroughStep, CodesOfCharacters) { check_fields("X_"); }

TEST(LanguageThroughStep, OlderVersions) {
  for (const char* sv : {"1.0", "1.1", "2.0"}) {
    SCOPED_TRACE(sv);
    check_fields("", sv);
  }
}

}  // namespace
}  // namespace evc::through_step
