#include "ride/ride.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "base/test_paths.h"
#include "io/file.h"
#include "io/input_stream.h"
#include "io/json.h"
#include "io/line_file.h"
#include "kernel/state.h"

namespace evc::ride {
namespace {

Given shipped(const std::string& train_file = "") {
  const std::string data = test::source_folder() + "/data/";
  Given given;
  given.line = io::read_line(io::read_text(data + "lines/brunnental.json").value(), "line").value();
  io::Train train;
  if (!train_file.empty()) train = io::read_train(io::read_text(train_file).value(), train_file).value();
  given.train_name = train.name;
  given.train = train.data;
  given.dynamics = train.dynamics;
  given.train_document = train.document;
  return given;
}

/// Drives to the end, `cycles` at a time: all outputs, and the journal.
struct Driven {
  std::string outputs, inputs;
};
Driven drive(Ride& ride, int cycles, int most = 100000) {
  Driven driven;
  for (int n = 0; n < most && !(n > 0 && ride.finished());) {
    n += ride.advance(cycles);
    driven.outputs += ride.outputs();
    driven.inputs += ride.inputs();
  }
  return driven;
}

std::string replayed(const std::string& inputs) {
  auto stream = io::InputStream::open("inputs", io::lines_of(inputs));
  if (!stream) return stream.error().text();
  const auto state = std::make_unique<kernel::State>();
  const auto derived = std::make_unique<kernel::Derived>();
  const auto answer = std::make_unique<kernel::Outputs>();
  kernel::power_up(*state, *derived, stream->configuration().for_kernel());
  sim::CycleInputs cycle;
  std::string outputs;
  for (auto more = stream->next(cycle); more && *more; more = stream->next(cycle)) {
    kernel::step(*state, *derived, cycle.view(), *answer);
    io::append_output(outputs, cycle.t_ms, *answer);
  }
  return outputs;
}

TEST(Ride, TheSizeOfAStepDoesNotMatterAndTheJournalReplaysToTheSameBytes) {
  Ride::Settings settings;
  settings.driver = sim::DriverKind::perfect;
  Ride a(shipped(), settings);
  Ride b(shipped(), settings);
  const Driven one = drive(a, 7);
  const Driven other = drive(b, 1000);
  EXPECT_TRUE(a.finished());
  EXPECT_EQ(one.outputs, other.outputs);
  EXPECT_EQ(one.inputs, other.inputs);
  EXPECT_EQ(a.summary(), b.summary());
  EXPECT_EQ(replayed(one.inputs), one.outputs);
  Sha256 hash;
  hash.add(one.outputs);
  EXPECT_NE(a.summary().find(hash.digest()), std::string::npos) << a.summary();
}

TEST(Ride, DrivenByHandTheTrainObeysTheDeskAndTheJournalReplays) {
  Ride ride(shipped(), {});
  sim::Desk desk;
  desk.open = true;
  desk.direction = port::DirectionController::forward;
  desk.lever = 1.0;
  std::string outputs, inputs;
  const auto run = [&](int cycles) {
    ride.set_desk(desk);
    EXPECT_EQ(ride.advance(cycles), cycles);
    outputs += ride.outputs();
    inputs += ride.inputs();
    return ride.points().back();
  };
  // In SB the standstill supervision holds the train after a few metres (3.14.4).
  const Point held = run(300);
  EXPECT_GT(held.x_m, -40.0);
  EXPECT_LT(held.x_m, 0.0);
  EXPECT_NE(static_cast<int>(held.brakes) & 4, 0);
  desk.lever = -1.0;
  EXPECT_EQ(run(100).v, 0.0);
  // It never ends by itself (a driver may wait).
  (void)run(1200);
  EXPECT_FALSE(ride.finished());
  EXPECT_EQ(replayed(inputs), outputs);
  // The display has a local time: 160 s after the begin.
  EXPECT_NE(outputs.find(R"("clock":{"utc":"2026-01-01T08:02:39)"), std::string::npos);
}

/// Touches the place with this name for as long as its type needs; false: it is not there or disabled.
bool tap(Ride& ride, const std::string& name, std::string& outputs, std::string& inputs) {
  for (const dmi::Touch& touch : ride.panel().screen().touch) {
    if (touch.name.view() != name) continue;
    if (!ride.panel().touch({touch.abs.x + touch.abs.w / 2, touch.abs.y + touch.abs.h / 2})) return false;
    const auto run = [&](int cycles) {
      (void)ride.advance(cycles);
      outputs += ride.outputs();
      inputs += ride.inputs();
    };
    run(touch.type == dmi::ButtonType::delay ? 21 : 1);
    ride.panel().lift();
    run(5);
    return true;
  }
  return false;
}

/// Those of the places that react now, for a message.
std::string places(Ride& ride) {
  std::string names = std::string(ride.panel().screen().window.view()) + ":";
  for (const dmi::Touch& touch : ride.panel().screen().touch)
    names += " [" + std::string(touch.name.view()) + (touch.enabled ? "]" : " -]");
  return names;
}

TEST(Ride, WhatIsEnteredAtTheDisplayIsInTheJournal) {
  Ride ride(shipped(), {});
  sim::Desk desk;
  desk.open = true;
  desk.direction = port::DirectionController::forward;
  ride.set_desk(desk);
  std::string outputs, inputs;
  (void)ride.advance(20);
  outputs += ride.outputs();
  inputs += ride.inputs();
  // The start of mission asks for the driver ID first (5.4.3.2 S1).
  EXPECT_EQ(ride.panel().screen().window.view(), "Driver ID") << places(ride);
  for (const char* name : {"key 4", "key 7", "field 1"}) EXPECT_TRUE(tap(ride, name, outputs, inputs)) << places(ride);
  EXPECT_NE(inputs.find("\"driver_id\":\"47\""), std::string::npos) << places(ride);
  EXPECT_NE(outputs.find("\"driver_id\":{\"value\":\"47\""), std::string::npos);
  EXPECT_EQ(replayed(inputs), outputs);
  const std::string drawing = ride.panel().drawing();
  EXPECT_EQ(drawing.rfind("[[\"#031122\",0,\"M0 0L640 0", 0), 0u) << drawing.substr(0, 100);
  EXPECT_NE(drawing.find("],[\"#"), std::string::npos);
}

/// SUBSET-026-3 3.5.6.3: the first of the networks is that of the terminals. Here it is not there.
TEST(Ride, TheTerminalsFindTheNetworkOfTheLine) {
  Given given = shipped();
  (void)given.networks.offered.push_back(0x26202F);
  (void)given.networks.offered.push_back(0x26201F);
  given.networks.along_line = 0x26201F;
  const auto journal_of = [&](const Ride::Settings& settings) {
    Ride ride(given, settings);
    (void)ride.advance(100);
    EXPECT_EQ(replayed(ride.inputs()), ride.outputs());
    return ride.inputs() + ride.outputs();
  };
  const std::string by_hand = journal_of({});
  EXPECT_NE(by_hand.find("\"networks\":[\"26202\",\"26201\"]"), std::string::npos) << by_hand.substr(0, 2000);
  EXPECT_NE(by_hand.find("\"radio_register\":\"26202\""), std::string::npos);
  EXPECT_NE(by_hand.find("\"radio_registered\":false"), std::string::npos);
  EXPECT_EQ(by_hand.find("\"radio_registered\":true"), std::string::npos);
  std::swap(given.networks.offered[0], given.networks.offered[1]);
  EXPECT_NE(journal_of({}).find("\"radio_registered\":true"), std::string::npos);
  // The simulated driver drives as in `evc run`.
  Ride::Settings simulated;
  simulated.driver = sim::DriverKind::perfect;
  const std::string with = journal_of(simulated);
  given.networks = {};
  EXPECT_EQ(with, journal_of(simulated));
}

// The clock is an input: a journey of the simulated driver has one where a begin is given, one by hand has it always.
TEST(Ride, HasTheLocalTimeFromItsBegin) {
  const auto local_time_of = [](const Ride::Settings& settings) {
    Ride ride(shipped(), settings);
    ride.advance(51);  // the first cycle is that of time 0
    const std::string& lines = ride.outputs();
    const io::Json last = io::Json::parse(lines.substr(lines.rfind('\n', lines.size() - 2) + 1));
    return last["clock"].is_null() ? std::string() : last["clock"]["local"].get<std::string>();
  };
  Ride::Settings settings;
  settings.driver = sim::DriverKind::perfect;
  EXPECT_EQ(local_time_of(settings), "");
  settings.utc = 1767254400 + 3600 + 57;
  EXPECT_EQ(local_time_of(settings), "2026-01-01T09:01:02");
  settings.driver.reset();
  EXPECT_EQ(local_time_of(settings), "2026-01-01T09:01:02");
  settings.utc.reset();
  EXPECT_EQ(local_time_of(settings), "2026-01-01T08:00:05");
}

// The window Main, which the start of mission has opened, closes when the simulated driver selects Start.
TEST(Ride, ShowsTheLocalTimeOfASimulatedJourney) {
  Ride::Settings settings;
  settings.driver = sim::DriverKind::perfect;
  settings.utc = 1767254400;
  Ride ride(shipped(), settings);
  ride.advance(1200);
  std::string shown;
  const io::Json screen = io::Json::parse(ride.panel().display_list());
  EXPECT_EQ(screen["window"], "default");
  for (const io::Json& item : screen["items"])
    if (item["kind"] == "text" && item["area"] == "G13") shown = item["value"].get<std::string>();
  EXPECT_EQ(shown, "08:01:59");
}

TEST(Ride, HasTheEditionThatIsChosen) {
  for (const SrsVersion srs : {SrsVersion::v3_6_0, SrsVersion::v4_0_0}) {
    Ride::Settings settings;
    settings.srs = srs;
    Ride ride(shipped(), settings);
    const Driven driven = drive(ride, 10, 10);
    EXPECT_NE(driven.inputs.find(std::string("\"srs\":\"") + name(srs) + '"'), std::string::npos);
    EXPECT_EQ(replayed(driven.inputs), driven.outputs);
  }
}

TEST(Given, IsTheSameAfterItsBytes) {
  const std::string folder = test::source_folder() + "/data/trains";
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const Given given = shipped(entry.path().string());
    const std::string bytes = bytes_of(given);
    const auto read = given_of(bytes);
    ASSERT_TRUE(read) << entry.path();
    EXPECT_EQ(read->train, given.train) << entry.path();
    EXPECT_EQ(bytes_of(*read), bytes) << entry.path();
    ++files;
  }
  EXPECT_GT(files, 0);
}

// The place in the page names the version that the bytes begin with. Other fields are another version.
TEST(Given, HasThePlaceOfItsVersion) {
  const std::string bytes = bytes_of(Given{});
  std::string digits;
  for (std::size_t i = 4; i-- > 0;) {
    const auto byte = static_cast<unsigned char>(bytes[i]);
    digits += {"0123456789abcdef"[byte >> 4U], "0123456789abcdef"[byte & 0xFU]};
  }
  EXPECT_EQ(given_place(), "@given " + digits + "@");
  EXPECT_EQ(bytes.size(), 526U) << "raise the version of given.cpp and web/index.html with the number here";
}

TEST(Given, BytesOfAnotherKindAreRefused) {
  const std::string bytes = bytes_of(shipped());
  EXPECT_FALSE(given_of(""));
  EXPECT_FALSE(given_of(std::string(100, '\0')));
  EXPECT_FALSE(given_of(bytes + '\0'));
  // Every end, coarse steps: nothing is read beyond it.
  for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 16) EXPECT_FALSE(given_of(bytes.substr(0, size)));
  // Sizes that are too large are not believed.
  for (std::size_t at = 8; at < 400; ++at) {
    std::string wrong = bytes;
    wrong[at] = '\xFF';
    (void)given_of(wrong);
  }
}

TEST(Sha256, AgreesWithTheVectorsOfTheStandard) {
  // FIPS 180-4, examples of NIST.
  const auto of = [](std::string_view text) {
    Sha256 hash;
    hash.add(text);
    return hash.digest();
  };
  EXPECT_EQ(of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(of(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
  // In pieces of every length.
  Sha256 pieces;
  std::string whole;
  for (std::size_t n = 0; n < 200; ++n) {
    pieces.add(std::string(n, static_cast<char>(n)));
    whole += std::string(n, static_cast<char>(n));
  }
  EXPECT_EQ(pieces.digest(), of(whole));
}

}  // namespace
}  // namespace evc::ride
