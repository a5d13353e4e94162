#include "serve/session.h"

#include <gtest/gtest.h>

#include <random>
#include <thread>

#include "io/file.h"
#include "io/input_stream.h"
#include "io/json.h"
#include "realtime/test_clock.h"
#include "run/answers.h"
#include "serve/access.h"
#include "serve/lines.h"

namespace evc::serve {
namespace {

std::vector<std::string> cut(const std::vector<std::string>& blocks, bool& taken) {
  LineCutter cutter;
  std::vector<std::string> lines;
  for (const std::string& block : blocks)
    taken = cutter.take(block, [&](std::string&& line) { lines.push_back(std::move(line)); });
  if (std::string rest = cutter.rest(); !rest.empty()) lines.push_back(rest);
  return lines;
}

TEST(Lines, AreTheSameHoweverTheirBytesCome) {
  std::mt19937 random(1);
  for (int n = 0; n < 300; ++n) {
    std::string text;
    std::vector<std::string> lines;
    for (unsigned line = 0; line < random() % 6; ++line) {
      lines.emplace_back(random() % 5, static_cast<char>('a' + random() % 26));
      text += lines.back() + "\n";
    }
    if (random() % 2 == 0) {
      lines.emplace_back("z");
      text += "z";
    }
    std::vector<std::string> blocks;
    for (std::size_t at = 0; at < text.size();) {
      blocks.push_back(text.substr(at, 1 + random() % 4));
      at += blocks.back().size();
    }
    bool taken = true;
    EXPECT_EQ(cut(blocks, taken), lines) << text;
    EXPECT_TRUE(taken);
  }
}

TEST(Lines, OneMayHaveAMebibyteAndNoMore) {
  const std::string longest(io::kLongestLine, 'x');
  bool taken = false;
  EXPECT_EQ(cut({longest, "\n", "y\n"}, taken), (std::vector<std::string>{longest, "y"}));
  EXPECT_TRUE(taken);
  EXPECT_EQ(cut({"a\n", longest, "x", "\ny\n"}, taken), std::vector<std::string>{"a"});
  EXPECT_FALSE(taken);
  EXPECT_EQ(cut({"a\n" + longest + "x\ny\n"}, taken), std::vector<std::string>{"a"});
  EXPECT_FALSE(taken);
}

using Arrival = std::pair<std::int64_t, std::string>;  // ms, line

/// What a session without a network says to these lines.
std::string said(const std::vector<Arrival>& lines, const Manner& manner = {}, const Room& room = {},
                 std::int64_t begin_ms = 0) {
  Conversation partner(room, [] {});
  for (const auto& [ms, text] : lines) partner.put({text, std::chrono::milliseconds(begin_ms + ms)});
  partner.end_inputs();
  realtime::TestClock clock;
  std::stop_source nobody;
  answer(partner, manner, clock, nobody.get_token());
  EXPECT_TRUE(partner.finished());
  std::string all;
  for (const std::string& line : partner.take(std::size_t{1} << 30)) all += line;
  return all;
}
std::string said_at_once(const std::vector<std::string>& lines) {
  std::vector<Arrival> arrivals;
  for (const std::string& line : lines) arrivals.emplace_back(0, line);
  return said(arrivals);
}

/// What `evc replay` prints of the same text, and its error.
std::string replayed(const std::string& text) {
  auto stream = io::InputStream::open("in", io::lines_of(text));
  if (!stream) return stream.error().text();
  run::OnBoard on_board(stream->configuration().for_kernel());
  run::Answers answers(on_board, stream->configuration().ntc_names);
  sim::CycleInputs cycle;
  std::string all;
  for (;;) {
    const auto more = stream->next(cycle);
    if (!more) return all + more.error().text();
    if (!*more) return all;
    answers.append(all, cycle);
  }
}

TEST(Session, AnswersAsAReplay) {
  const std::string config = R"({"config":{"cycle_ms":200,"ntc_names":{"1":"PZB"}}})";
  const std::string desk = R"({"t_ms":0,"train":{"desk_open":true}})";
  const std::string driver = R"({"t_ms":1000,"driver":{"enter":{"driver_id":"4711"}}})";
  EXPECT_EQ(said_at_once({config, desk, driver}), replayed(config + "\n" + desk + "\n" + driver));
  EXPECT_EQ(said_at_once({desk, "", driver + "\r"}), replayed(desk + "\n\n" + driver + "\r\n"));
}

TEST(Session, AnErrorIsItsLastLineAndNamesTheLine) {
  const auto last = [](const std::string& said) {
    const std::size_t before = said.rfind('\n', said.size() - 2);
    return said.substr(before == std::string::npos ? 0 : before + 1);
  };
  const std::string first = R"({"t_ms":0})";
  const std::string next = R"({"t_ms":500})";
  EXPECT_EQ(last(said_at_once({first, next, R"({"t_ms":400})"})),
            R"({"error":"line 3 /t_ms: found 400, expected a time not before 500"})"
            "\n");
  EXPECT_EQ(said_at_once({first, next, R"({"t_ms":400})", first}),
            replayed(first + "\n" + R"({"t_ms":400})") +
                R"({"error":"line 3 /t_ms: found 400, expected a time not before 500"})"
                "\n");
  EXPECT_EQ(said_at_once({R"({"t_ms":"\"x"})"}),
            R"({"error":"line 1 /t_ms: found \"\\\"x\", expected an integer from 0 to 2305843009213693951"})"
            "\n");
  for (const char* wrong : {"", "x", "[1]", "{\"t_ms\":0", R"({"t_ms":0,"speed":1})", R"({"config":{"cycle":1}})",
                            "\xff\xfe", R"({"t_ms":0,"t_ms":1})"}) {
    const std::string line = said_at_once({wrong});
    const io::Json error = io::Json::parse(line);
    EXPECT_TRUE(error.at("error").is_string()) << wrong;
    EXPECT_EQ(error.size(), 1u);
    EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 1);
  }
  EXPECT_EQ(said_at_once({}),
            "{\"error\":\"session: found no input, expected a line with t_ms, as {\\\"t_ms\\\":0}\"}\n");
}

/// The record of what arrived and when is a stream of inputs: the clock decides when a cycle is computed, never what.
TEST(Session, ByTheClockAnswersAsAReplayOfWhatArrived) {
  const std::string config = R"({"config":{"cycle_ms":100}})";
  const std::vector<Arrival> arrivals{
      {0, config},
      {30, R"("train":{"desk_open":true})"},
      {130, R"("odometer":{"nominal_m":0,"min_m":0,"max_m":0,"speed_mps":0})"},
      {130, R"("driver":{"enter":{"driver_id":"4711"}})"},
      {1001, R"("driver":{"enter":{"level":"1"}})"},
      {1999, R"("clock":{"utc":"2026-11-22T10:15:00Z"})"},
  };
  std::vector<Arrival> by_clock{arrivals.front()};
  std::string stream = config + "\n" + R"({"t_ms":0})" + "\n";
  for (std::size_t n = 1; n < arrivals.size(); ++n) {
    by_clock.emplace_back(arrivals[n].first, "{" + arrivals[n].second + "}");
    stream += "{\"t_ms\":" + std::to_string(arrivals[n].first) + "," + arrivals[n].second + "}\n";
  }
  const std::string expected = replayed(stream);
  EXPECT_EQ(std::count(expected.begin(), expected.end(), '\n'), 21);
  EXPECT_EQ(said(by_clock, {true, {}}), expected);
  EXPECT_EQ(said(by_clock, {true, {}}, {}, 5000), expected);  // the time of the unit begins with the first line
}

TEST(Session, ByTheClockACycleThatIsMoreThanASecondLateFails) {
  Conversation partner({}, [] {});
  partner.put({R"({"config":{"cycle_ms":100}})", std::chrono::milliseconds(0)});
  partner.put({R"({"train":{"desk_open":true}})", std::chrono::milliseconds(0)});
  partner.put({R"({"train":{"sleeping":false}})", std::chrono::milliseconds(100)});
  partner.end_inputs();
  realtime::TestClock clock;
  clock.pass(std::chrono::milliseconds(1050));
  std::stop_source nobody;
  Manner manner{true, {}};
  realtime::Timing timing;
  manner.measured = [&](const realtime::Timing& measured) { timing = measured; };
  answer(partner, manner, clock, nobody.get_token());
  // How late the session was: both cycles had become due before the first one began.
  EXPECT_EQ(timing.cycles, 3u);
  EXPECT_EQ(timing.missed, 3u);
  EXPECT_EQ(timing.jitter.max(), std::chrono::milliseconds(1050));
  const auto lines = partner.take(std::size_t{1} << 30);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(io::Json::parse(lines[1])["mode"], "SF");  // from power-up through SB
}

TEST(Session, ByTheClockEndsWhenAskedTo) {
  Conversation partner({}, [] {});
  partner.put({R"({"config":{"cycle_ms":100}})", {}});
  realtime::MonotonicClock clock;
  std::jthread unit([&](const std::stop_token& stop) { answer(partner, {true, 10}, clock, stop); });
  while (partner.take(1).empty()) std::this_thread::yield();
  unit.request_stop();
  unit.join();
  EXPECT_TRUE(partner.finished());
}

TEST(Session, APartnerWhoTakesNothingIsDropped) {
  Room room;
  room.outputs = 10'000;
  room.patience = std::chrono::milliseconds(1);
  // A day of cycles, of which a few have room.
  for (const bool by_clock : {false, true}) {
    Conversation partner(room, [] {});
    partner.put({R"({"t_ms":0})", {}});
    partner.put({R"({"t_ms":86400000})", std::chrono::hours(24)});
    partner.end_inputs();
    realtime::TestClock clock;
    std::stop_source nobody;
    answer(partner, {by_clock, {}}, clock, nobody.get_token());
    EXPECT_TRUE(partner.dropped());
    EXPECT_TRUE(partner.finished());
  }
}

TEST(Conversation, TellsTheNetworkWhenThereIsRoomAgain) {
  int told = 0;
  Room room;
  room.inputs = 300;
  Conversation partner(room, [&] { ++told; });
  while (partner.has_room()) partner.put({"{}", {}});
  EXPECT_EQ(told, 0);
  Conversation::Line line;
  ASSERT_TRUE(partner.next_line(line));
  EXPECT_TRUE(partner.has_room());
  EXPECT_EQ(told, 1);
  ASSERT_TRUE(partner.next_line(line));
  EXPECT_EQ(told, 1);
  EXPECT_TRUE(partner.give("a\n"));
  EXPECT_EQ(told, 1);  // not seen yet
  partner.seen();
  EXPECT_TRUE(partner.give("b\n"));
  EXPECT_EQ(told, 2);
  EXPECT_EQ(partner.take(1), std::vector<std::string>{"a\n"});
  EXPECT_EQ(partner.take(100), std::vector<std::string>{"b\n"});
  partner.drop();
  EXPECT_FALSE(partner.wait_for_line(line));
  EXPECT_FALSE(partner.give("c\n"));
}

TEST(Conversation, ASlowPartnerIsWaitedFor) {
  Room room;
  room.outputs = 100;
  room.patience = std::chrono::minutes(2);
  Conversation partner(room, [] {});
  std::jthread unit([&] {
    for (int n = 0; n < 1000; ++n) EXPECT_TRUE(partner.give(std::to_string(n) + "\n"));
    partner.finish();
  });
  std::string all, expected;
  for (int n = 0; n < 1000; ++n) expected += std::to_string(n) + "\n";
  while (all.size() < expected.size())
    for (const std::string& line : partner.take(1)) all += line;
  EXPECT_EQ(all, expected);
}

TEST(Access, OwnNamesOnly) {
  for (const char* host : {"127.0.0.1:8026", "localhost:8026", "LocalHost:8026", "[::1]:8026"})
    EXPECT_TRUE(is_own_host(host, 8026));
  for (const char* host : {"", "127.0.0.1", "localhost:802", "localhost:80260", "example.org:8026", "127.0.0.2:8026",
                           "localhost.example.org:8026", " localhost:8026"})
    EXPECT_FALSE(is_own_host(host, 8026)) << host;
  EXPECT_TRUE(is_own_host("localhost", 80));
  EXPECT_TRUE(is_own_origin("http://localhost:8026", "localhost:8026"));
  for (const char* origin : {"", "null", "https://localhost:8026", "http://localhost:8027", "http://127.0.0.1:8026",
                             "http://localhost:8026.example.org", "http://localhost:8026/"})
    EXPECT_FALSE(is_own_origin(origin, "localhost:8026")) << origin;
}

TEST(Session, WhatIsAskedForIsInEachLine) {
  const std::vector<Arrival> lines{{0, R"({"t_ms":0,"train":{"desk_open":true}})"}, {0, R"({"t_ms":200,"end":true})"}};
  EXPECT_NE(said(lines).find(R"("dmi":null)"), std::string::npos);
  Manner manner;
  manner.printed.dmi = manner.printed.planning = true;
  const std::string with = said(lines, manner);
  EXPECT_EQ(with.find(R"("dmi":null)"), std::string::npos);
  EXPECT_NE(with.find(R"("schema":"evc-dmi/1")"), std::string::npos);
}

}  // namespace
}  // namespace evc::serve
