#include "serve/server.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <thread>

#include "io/json.h"
#include "io/program_test.h"
#include "serve/test_client.h"

namespace evc::serve {
namespace {

/// The inputs and outputs of a journey on the shipped line, which `evc replay` prints of them.
class ShippedJourney {
 public:
  ShippedJourney() {
    EXPECT_EQ(ended("run -o '" + folder_.path() + "'").exit_code, 0);
    inputs = text_of(folder_ / "inputs.jsonl");
    outputs = ended("replay '" + (folder_ / "inputs.jsonl") + "'").output;
    EXPECT_GT(outputs.size(), std::size_t{1} << 20);
  }
  std::string inputs, outputs;

 private:
  Folder folder_{"served"};
};
const ShippedJourney& shipped() {
  static const ShippedJourney journey;
  return journey;
}

std::string mode_of(const std::string& line) { return io::Json::parse(line).at("mode").get<std::string>(); }
std::string error_of(const std::string& line) { return io::Json::parse(line).at("error").get<std::string>(); }

TEST(Server, APartnerGetsTheLinesOfAReplay) {
  const RunningServer server;
  Client client(server.port());
  std::jthread writer([&] {
    EXPECT_TRUE(client.try_send(shipped().inputs));
    client.end();
  });
  EXPECT_TRUE(client.rest() == shipped().outputs);
}

TEST(Server, APartnerByWebSocketGetsTheLinesOfAReplay) {
  const RunningServer server;
  WebClient client(server.port());
  ASSERT_TRUE(client.taken()) << client.answer();
  std::size_t in = 0, out = 0;
  // One line in several frames, others of several in one message: lines are what counts.
  for (int n = 0; n < 2000; ++n) {
    const std::size_t end = shipped().inputs.find('\n', in);
    const std::string line = shipped().inputs.substr(in, end - in);
    in = end + 1;
    if (n % 3 == 0) {
      client.send(line.substr(0, 5), false);
      client.send(line.substr(5), true, false);
    } else {
      client.send(n % 3 == 1 ? line : line + "\n");
    }
  }
  for (int n = 0; n < 1900; ++n) {
    const std::size_t end = shipped().outputs.find('\n', out);
    ASSERT_EQ(client.message(), shipped().outputs.substr(out, end - out)) << n;
    out = end + 1;
  }
}

TEST(Server, EndOfACycleIsAnsweredAtOnceAndEachPartnerHasAUnit) {
  const RunningServer server;
  Client a(server.port()), b(server.port());
  WebClient c(server.port());
  a.send("{\"config\":{\"cycle_ms\":500}}\n{\"t_ms\":0,\"end\":true,\"train\":{\"desk_open\":true}}\n");
  b.send("{\"t_ms\":0,\"end\":true,\"train\":{\"isolated\":true}}\n");
  c.send("{\"t_ms\":0,\"end\":true,\"train\":{\"powered\":false}}");
  EXPECT_EQ(mode_of(a.line()), "SB");
  EXPECT_EQ(mode_of(b.line()), "IS");
  EXPECT_EQ(mode_of(c.message()), "NP");
  a.send("{\"t_ms\":500,\"end\":true}\n");
  b.send("{\"t_ms\":100,\"end\":true}\n");
  EXPECT_EQ(io::Json::parse(a.line())["t_ms"], 500);
  EXPECT_EQ(io::Json::parse(b.line())["t_ms"], 100);
}

TEST(Server, AWrongLineEndsItsSessionOnly) {
  const RunningServer server;
  Client good(server.port()), wrong(server.port());
  WebClient web(server.port());
  good.send("{\"t_ms\":0,\"end\":true}\n");
  EXPECT_EQ(mode_of(good.line()), "SB");
  // What is sent behind the wrong line does not keep the partner from reading what is said about it.
  wrong.send("{\"t_ms\":0,\"end\":true}\n{\"t_ms\":100,\"sped\":1}\n" + std::string(100'000, '\n'));
  EXPECT_EQ(mode_of(wrong.line()), "SB");
  EXPECT_EQ(error_of(wrong.line()).find("line 2 /sped: found an unknown key, expected one of t_ms"), 0u);
  EXPECT_EQ(wrong.rest(), "");
  web.send("{\"t_ms\":0");
  EXPECT_EQ(error_of(web.message()).find("line 1"), 0u);
  EXPECT_EQ(web.message(), "");
  good.send("{\"t_ms\":100,\"end\":true}\n");
  EXPECT_EQ(mode_of(good.line()), "SB");
}

TEST(Server, ALineHasAMebibyteAtMost) {
  const RunningServer server;
  Client longest(server.port()), longer(server.port());
  WebClient web(server.port());
  const std::string line = "{\"t_ms\":0,\"end\":true}";
  longest.send(line + std::string(io::kLongestLine - line.size(), ' ') + "\n");
  EXPECT_EQ(mode_of(longest.line()), "SB");
  const std::string expected = "line 1: found a line of more than 1048576 bytes, expected at most 1048576";
  (void)longer.try_send(std::string(io::kLongestLine + 1, ' '));
  EXPECT_EQ(error_of(longer.line()), expected);
  web.send(std::string(io::kLongestLine + 1, ' '));
  EXPECT_EQ(error_of(web.message()), expected);
}

TEST(Server, AMessageMayHaveManyLines) {
  const RunningServer server;
  WebClient client(server.port());
  constexpr std::size_t length = 1'000'000;  // of a line; the message is longer than 16 MiB
  constexpr int lines = 20;
  std::string message;
  for (int n = 0; n < lines; ++n) {
    std::string line = "{\"t_ms\":" + std::to_string(100 * n) + ",\"end\":true}";
    line.resize(length - 1, ' ');
    message += line + "\n";
  }
  client.send(message);
  for (int n = 0; n < lines; ++n) {
    const std::string line = client.message();
    ASSERT_FALSE(line.empty()) << n;
    EXPECT_EQ(io::Json::parse(line)["t_ms"], 100 * n);
  }
}

TEST(Server, ALineWithoutItsEndIsTheLastOne) {
  const RunningServer server;
  Client whole(server.port()), part(server.port()), gone(server.port());
  whole.send("{\"t_ms\":0}");
  whole.end();
  EXPECT_EQ(mode_of(whole.line()), "SB");
  EXPECT_EQ(whole.rest(), "");
  part.send("{\"t_ms\":0,\"end\":true}\n{\"t_ms\":1");
  EXPECT_EQ(mode_of(part.line()), "SB");
  part.end();
  EXPECT_EQ(error_of(part.line()).find("line 2"), 0u);
  gone.send("{\"t_ms\":0,\"end\":true}\n{\"t_ms\":1");
  gone.reset();
  Client next(server.port());
  next.send("{\"t_ms\":0,\"end\":true}\n");
  EXPECT_EQ(mode_of(next.line()), "SB");
}

/// Tries until there is room for a session.
std::unique_ptr<Client> admitted(std::uint16_t port) {
  for (;; std::this_thread::yield()) {
    auto client = std::make_unique<Client>(port);
    client->send("{\"t_ms\":0,\"end\":true}\n");
    const std::string line = client->line();
    if (!line.empty() && io::Json::parse(line).contains("mode")) return client;
  }
}

TEST(Server, OneSessionTooManyIsTold) {
  ServerOptions options;
  options.most_sessions = 2;
  const RunningServer server(options);
  Client first(server.port());
  WebClient second(server.port());
  first.send("{\"t_ms\":0,\"end\":true}\n");
  EXPECT_EQ(mode_of(first.line()), "SB");
  second.send("{\"t_ms\":0,\"end\":true}");
  EXPECT_EQ(mode_of(second.message()), "SB");
  Client third(server.port());
  third.send("{\"t_ms\":0,\"end\":true}\n");
  EXPECT_EQ(error_of(third.line()), "session: found 2 sessions, expected a session less");
  EXPECT_EQ(third.rest(), "");
  EXPECT_NE(WebClient(server.port()).answer().find(" 503 "), std::string::npos);
  second.close();
  EXPECT_TRUE(admitted(server.port()));
  first.close();
}

TEST(Server, APartnerWhoReadsNothingStopsNobodyAndIsDropped) {
  ServerOptions options;
  options.most_sessions = 3;
  options.room.outputs = 10'000;
  options.room.patience = std::chrono::milliseconds(50);
  const RunningServer server(options);
  // A day of cycles: gigabytes.
  const std::string day = "{\"t_ms\":0}\n{\"t_ms\":86400000}\n";
  Client stuck(server.port()), other(server.port());
  WebClient stuck_web(server.port());
  stuck.send(day);
  stuck_web.send(day);
  for (int n = 0; n < 20; ++n) {
    other.send("{\"t_ms\":" + std::to_string(100 * n) + ",\"end\":true}\n");
    EXPECT_EQ(mode_of(other.line()), "SB");
  }
  // Their places become free, though they stay connected.
  const auto third = admitted(server.port()), fourth = admitted(server.port());
}

std::string status_of(std::uint16_t port, const std::string& request, const std::string& fields) {
  Client client(port);
  const std::string answer = asked(client, request, fields);
  return answer.substr(9, 3);
}

TEST(Server, OnlyThePageOfThisServerAndProgramsGetAUnit) {
  const RunningServer server;
  const std::uint16_t port = server.port();
  const std::string number = std::to_string(port);
  const auto upgrade = [&](const std::string& fields) { return status_of(port, "GET /unit", kUpgrade + fields); };
  EXPECT_EQ(upgrade(host_of(port)), "101");
  EXPECT_EQ(upgrade(host_of(port) + "Origin: http://127.0.0.1:" + number + "\r\n"), "101");
  EXPECT_EQ(upgrade("Host: localhost:" + number + "\r\nOrigin: http://localhost:" + number + "\r\n"), "101");
  for (const std::string& origin :
       {std::string("http://example.org"), std::string("null"), std::string("http://127.0.0.1"),
        "https://127.0.0.1:" + number, "http://localhost:" + number, std::string()})
    EXPECT_EQ(upgrade(host_of(port) + "Origin: " + origin + "\r\n"), "403") << origin;
  EXPECT_EQ(upgrade(host_of(port) + "Origin: http://127.0.0.1:" + number + "\r\nOrigin: http://example.org\r\n"),
            "403");
  // A name of a foreign site that was given our address.
  EXPECT_EQ(upgrade("Host: example.org:" + number + "\r\nOrigin: http://example.org:" + number + "\r\n"), "403");
  EXPECT_EQ(upgrade(""), "403");
  EXPECT_EQ(upgrade(host_of(port) + "Host: example.org\r\n"), "403");
}

TEST(Server, GivesAPage) {
  const RunningServer server;
  const std::uint16_t port = server.port();
  Client client(port);
  const std::string head = asked(client, "GET /", host_of(port));
  EXPECT_EQ(head.substr(9, 3), "200");
  EXPECT_NE(head.find("Content-Security-Policy: default-src 'none'"), std::string::npos);
  EXPECT_NE(client.rest().find("</html>"), std::string::npos);
  EXPECT_EQ(status_of(port, "HEAD /", host_of(port)), "200");
  EXPECT_EQ(status_of(port, "GET /", "Host: example.org\r\n"), "403");
  EXPECT_EQ(status_of(port, "GET /other", host_of(port)), "404");
  EXPECT_EQ(status_of(port, "POST /", host_of(port)), "405");
  EXPECT_EQ(status_of(port, "GET /unit", host_of(port)), "426");
  EXPECT_EQ(status_of(port, "GET /", host_of(port) + "X: " + std::string(10'000, 'x') + "\r\n"), "431");
}

TEST(Server, WhatIsNeitherARequestNorALineIsTold) {
  const RunningServer server;
  for (const char* wrong : {"HELLO\r\n\r\n", "T_MS\n", "GET / HTTP/9.9\r\n\r\n"}) {
    Client client(server.port());
    client.send(wrong);
    client.end();
    const std::string answer = client.rest();
    EXPECT_EQ(answer.substr(0, 12), "HTTP/1.1 400") << wrong << answer;
    EXPECT_NE(answer.find("neither a line of JSON nor a request of HTTP"), std::string::npos) << answer;
  }
  Client nothing(server.port());
  nothing.end();
  EXPECT_EQ(nothing.rest(), "");
}

/// Data of its own for the server, which `io::data_file` finds through the environment.
class Served : public ::testing::Test {
 protected:
  Served() {
    if (const char* const before = std::getenv("OPENEVC_DATA")) before_ = before;
    setenv("OPENEVC_DATA", folder_.path().c_str(), 1);
  }
  ~Served() override {
    if (before_.empty())
      unsetenv("OPENEVC_DATA");
    else
      setenv("OPENEVC_DATA", before_.c_str(), 1);
  }
  void compiled(const std::string& page) const {
    std::filesystem::create_directories(folder_ / "cab");
    std::ofstream(folder_ / "cab/page.html") << page;
  }
  static std::string page() {
    const RunningServer server;
    Client client(server.port());
    const std::string head = asked(client, "GET /", host_of(server.port()));
    EXPECT_EQ(head.substr(9, 3), "200");
    EXPECT_NE(head.find("'wasm-unsafe-eval'"), std::string::npos);
    return client.rest();
  }

 private:
  Folder folder_{"served_page"};
  std::string before_;
};

TEST_F(Served, ThePageIsThatOfTheCabWithoutALine) {
  compiled("<a>@given 12345678@</a>");
  EXPECT_EQ(page(), "<a></a>");
}

TEST_F(Served, WithoutTheCompiledPageItSaysHowToGetIt) {
  EXPECT_NE(page().find("<code>make cab</code>"), std::string::npos);
  compiled("of something else");
  EXPECT_NE(page().find("<code>make cab</code>"), std::string::npos);
}

TEST(Server, ThePageOfTheCabGetsTheRecordOfTheDisplay) {
  const RunningServer server;
  for (const char* const target : {"/unit", "/unit?dmi"}) {
    WebClient client(server.port(), "", target);
    ASSERT_TRUE(client.taken()) << client.answer();
    client.send("{\"t_ms\":0,\"end\":true}");
    EXPECT_EQ(io::Json::parse(client.message())["dmi"].is_null(), std::string(target) == "/unit") << target;
  }
  EXPECT_EQ(
      status_of(server.port(), "GET /unit?dmi", kUpgrade + host_of(server.port()) + "Origin: http://example.org\r\n"),
      "403");
  EXPECT_EQ(status_of(server.port(), "GET /unit?other", kUpgrade + host_of(server.port())), "404");
}

TEST(Server, ListensAtBothAddressesOfTheMachine) {
  const RunningServer server;
  if (!Client::has_ipv6()) GTEST_SKIP() << "this machine has no IPv6";
  Client client(server.port(), true);
  client.send("{\"t_ms\":0,\"end\":true}\n");
  EXPECT_EQ(mode_of(client.line()), "SB");
  Client browser(server.port(), true);
  EXPECT_EQ(asked(browser, "GET /", "Host: [::1]:" + std::to_string(server.port()) + "\r\n").substr(9, 3), "200");
}

TEST(Server, InRealTimeCyclesComeByThemselves) {
  ServerOptions options;
  options.manner = {true, 20};
  const RunningServer server(options);
  Client client(server.port());
  client.send("{\"config\":{\"cycle_ms\":5000}}\n");
  for (int n = 0; n < 5; ++n) EXPECT_EQ(io::Json::parse(client.line())["t_ms"], 20 * n);
  client.send("{\"train\":{\"isolated\":true}}\n");
  while (mode_of(client.line()) != "IS") {
  }
  client.send("{\"train\":{\"isolted\":true}}\n");
  std::string line, last;
  while (!(line = client.line()).empty()) last = line;
  EXPECT_EQ(error_of(last).find("line 3 /train/isolted: found an unknown key"), 0u) << last;
}

TEST(Server, InRealTimeAPartnerWhoReadsNothingLosesItsUnit) {
  ServerOptions options;
  options.most_sessions = 1;
  options.manner = {true, 1};
  options.room.outputs = 100'000;
  const RunningServer server(options);
  Client stuck(server.port());
  stuck.send("{\"config\":{}}\n");
  EXPECT_TRUE(admitted(server.port()));
}

TEST(Server, EndsWithItsSessions) {
  auto server = std::make_unique<RunningServer>();
  Client waits(server->port()), begun(server->port());
  WebClient web(server->port());
  begun.send("{\"t_ms\":0,\"end\":true}\n");
  EXPECT_EQ(mode_of(begun.line()), "SB");
  server.reset();
  EXPECT_EQ(begun.rest(), "");
  EXPECT_EQ(waits.rest(), "");
  EXPECT_EQ(web.message(), "");
}

TEST(Server, APortThatIsTakenIsAnError) {
  const RunningServer server;
  const std::string port = std::to_string(server.port());
  const Ended second = ended("serve --port " + port);
  EXPECT_EQ(second.exit_code, 2);
  EXPECT_EQ(second.output, "");
  EXPECT_EQ(second.errors,
            "evc serve: --port: found " + port + ": Address already in use, expected a port that is free\n");
}

TEST(Server, TheProgramPrintsItsAddressAndEndsWithASignal) {
  const Folder folder("serve_signal");
  for (const char* signal : {"INT", "TERM"}) {
    const std::string address = folder / signal;
    // A shell lets what it starts behind it ignore SIGINT: env undoes that.
    const std::string script = "env --default-signal=INT " + program() + " serve --port 0 >'" + address +
                               "' & while ! [ -s '" + address + "' ]; do sleep 0.05; done; kill -" + signal +
                               " $!; wait $!";
    EXPECT_EQ(std::system(script.c_str()), 0) << signal;
    const std::string text = text_of(address);
    EXPECT_EQ(text.find("http://127.0.0.1:"), 0u) << text;
    EXPECT_EQ(text.substr(text.size() - 2), "/\n");
  }
}

}  // namespace
}  // namespace evc::serve
