#include "run/drive.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "base/test_paths.h"
#include "realtime/test_clock.h"
#include "run/load.h"

namespace evc::run {
namespace {

using realtime::Nanoseconds;
using realtime::TestClock;

/// A journey on the shipped line, ready to be driven.
struct Drive {
  explicit Drive(std::int64_t cycle_ms = 100) {
    settings.cycle_ms = configuration.cycle_ms = cycle_ms;
    configuration.document = io::configuration_document(configuration);
    world = std::make_unique<sim::World>(line, configuration.train.data, configuration.train.dynamics, settings);
    on_board = std::make_unique<OnBoard>(configuration.for_kernel());
    journey = std::make_unique<Journey>(*world);
    recorder = std::make_unique<Recorder>(*world, *journey, configuration);
  }
  RealTime in_real_time(
      realtime::Clock& clock, const std::function<bool()>& stopped = [] { return false; }) {
    OnBoard twin(configuration.for_kernel());
    return drive_in_real_time(*world, *on_board, *recorder, configuration.cycle_ms, clock, exchange, stopped, &twin);
  }
  void keep_displays() {
    displays = std::make_unique<DisplayLists>();
    recorder = std::make_unique<Recorder>(*world, *journey, configuration, displays.get());
  }
  std::int64_t cycle_of(Nanoseconds due) const { return due / std::chrono::milliseconds(configuration.cycle_ms); }
  /// What a replay of the recorded inputs gives.
  std::string replayed() {
    auto stream = io::InputStream::open("inputs", io::lines_of(recorder->records().inputs));
    if (!stream) return stream.error().text();
    OnBoard other(stream->configuration().for_kernel());
    sim::CycleInputs inputs;
    std::string outputs;
    for (auto more = stream->next(inputs); more && *more; more = stream->next(inputs))
      io::append_output(outputs, inputs.t_ms, other.step(inputs.view()));
    return outputs;
  }

  sim::Line line = load_line(test::source_folder() + "/data/lines/brunnental.json").value();
  sim::World::Settings settings;
  io::Configuration configuration;
  std::unique_ptr<sim::World> world;
  std::unique_ptr<OnBoard> on_board;
  std::unique_ptr<Journey> journey;
  std::unique_ptr<DisplayLists> displays;
  std::unique_ptr<Recorder> recorder;
  Exchange exchange;
};

/// Over so many cycles, or the whole journey.
void real_time_equals_simulated(std::int64_t cycle_ms, std::size_t cycles = 1 << 20) {
  Drive simulated(cycle_ms);
  drive(*simulated.world, *simulated.on_board, *simulated.recorder);
  Drive timed(cycle_ms);
  TestClock clock([&](Nanoseconds due) { return timed.exchange.ready(timed.cycle_of(due)); });
  const RealTime measured = timed.in_real_time(clock, [&] { return timed.journey->cycles() == cycles; });
  EXPECT_EQ(measured.without_inputs, 0u);
  EXPECT_EQ(measured.lost, 0u);
  EXPECT_EQ(timed.on_board->allocations_in_step(), 0u);
  // Not EXPECT_EQ: it would print both.
  const Records& expected = simulated.recorder->records();
  const Records& found = timed.recorder->records();
  EXPECT_TRUE(expected.inputs.starts_with(found.inputs));
  EXPECT_TRUE(expected.outputs.starts_with(found.outputs));
  EXPECT_TRUE(expected.trace.starts_with(found.trace));
  EXPECT_EQ(timed.journey->cycles(), std::min(cycles, simulated.journey->cycles()));
}

/// A world that makes its inputs in time: the same bytes as without a clock.
TEST(RealTime, GivesTheBytesOfTheSimulatedRun) { real_time_equals_simulated(100); }
TEST(RealTime, GivesThemWithAShorterCycle) { real_time_equals_simulated(40, 3000); }

/// The display is that of the run without a clock, though nobody asks the unit in its thread for it.
TEST(RealTime, KeepsTheSameDisplays) {
  Drive simulated;
  simulated.keep_displays();
  drive(*simulated.world, *simulated.on_board, *simulated.recorder);
  Drive timed;
  timed.keep_displays();
  TestClock clock([&](Nanoseconds due) { return timed.exchange.ready(timed.cycle_of(due)); });
  (void)timed.in_real_time(clock);
  EXPECT_GT(timed.displays->size(), 100u);
  EXPECT_TRUE(timed.displays->json(1 << 30) == simulated.displays->json(1 << 30));
  EXPECT_EQ(timed.on_board->allocations_in_step(), 0u);
}

/// A journey whose world hangs after cycle `after`: the unit begins the next `cycles` without it.
struct Hanging : Drive {
  Hanging(std::size_t after_cycle, std::size_t cycles) : after(after_cycle), last(after_cycle + cycles) {}
  RealTime until(std::size_t end) {
    std::atomic<std::size_t> begun = 0;
    std::atomic<bool> hangs = false;  // the world has taken the results before
    TestClock clock([&](Nanoseconds due) {
      begun = static_cast<std::size_t>(cycle_of(due));
      return (begun > after && begun <= last) ? hangs.load() : exchange.ready(cycle_of(due));
    });
    return in_real_time(clock, [&] {
      hangs = journey->cycles() == after + 1;
      while (hangs && begun <= last) std::this_thread::yield();
      return journey->cycles() > end;
    });
  }
  const std::size_t after, last;
};

/// The unit goes on with the signals and the last reading of the odometer; what the world makes meanwhile comes later;
/// a replay gives the same outputs. What a cycle did is compared with the world of that cycle, not with a later one.
TEST(RealTime, AWorldThatIsLateIsNotWaitedFor) {
  Hanging timed(500, 5);
  const RealTime measured = timed.until(3000);
  EXPECT_EQ(measured.without_inputs, 5u);
  EXPECT_EQ(measured.lost, 0u);
  const Records& records = timed.recorder->records();
  std::size_t held = 0;
  for (std::size_t at = 0; (at = records.inputs.find("\"at_ms\":", at)) != std::string::npos; ++at, ++held)
    EXPECT_EQ(records.inputs.substr(at, 14), "\"at_ms\":50000}");
  EXPECT_EQ(held, 5u);
  EXPECT_TRUE(timed.replayed() == records.outputs);
  EXPECT_EQ(timed.journey->interventions().eb, 0);
  EXPECT_EQ(timed.journey->confidence_interval_violations(), 0);
  const auto& samples = timed.journey->samples();
  for (std::size_t n = 500; n <= 506; ++n)
    EXPECT_NEAR(samples[n].x_m - samples[n - 1].x_m, samples[n].v / 36.0, 0.5) << n;
}

/// Messages that arrive while the unit has no inputs are counted with the cycle that gets them.
TEST(RealTime, MessagesOfAWorldThatIsLateAreCounted) {
  Drive simulated;
  drive(*simulated.world, *simulated.on_board, *simulated.recorder);
  const auto recorded = [](const Drive& d) {
    std::vector<std::size_t> cycles;
    for (const sim::Delivery& delivery : d.world->radio().deliveries())
      if (delivery.seq >= 0) cycles.push_back(static_cast<std::size_t>(delivery.t_ms / 100));
    return cycles;
  };
  const auto counted = [](const Drive& d) {
    const Journey::Counts& c = d.journey->counts();
    return c.messages_accepted + c.messages_refused + c.messages_rejected;
  };
  const std::size_t first = recorded(simulated).at(0);
  Hanging timed(first - 3, 5);
  (void)timed.until(first + 50);
  EXPECT_EQ(static_cast<std::size_t>(counted(timed)), recorded(timed).size());
  EXPECT_GE(counted(timed), 1);
}

/// A world that hangs for longer than the results can wait: those lost are counted, the others have their places.
TEST(RealTime, ResultsThatNobodyTakesAreLost) {
  Hanging timed(500, 200);
  const RealTime measured = timed.until(900);
  EXPECT_EQ(measured.lost, 200u - 128u);
  EXPECT_EQ(measured.without_inputs, 128u);
  const auto& samples = timed.journey->samples();
  ASSERT_EQ(samples.size(), 901u);
  EXPECT_EQ(samples[628].t_s, 62.8);
  EXPECT_EQ(samples[629].t_s, 70.1);
  for (std::size_t n = 501; n <= 628; ++n) EXPECT_NEAR(samples[n].x_m - samples[n - 1].x_m, 1.6, 1.0) << n;
  EXPECT_GT(samples[629].x_m - samples[628].x_m, 7.0 * 10.0);
}

/// The odometer's last reading is older than 1 s while it shows movement: system failure (4.4.5).
TEST(RealTime, WithoutTheWorldATrainThatMovesIsBraked) {
  Hanging timed(500, 15);
  (void)timed.until(514);
  const auto& samples = timed.journey->samples();
  ASSERT_EQ(samples.size(), 515u);
  EXPECT_NE(static_cast<Mode>(samples[510].mode), Mode::SF);  // 1 s old
  EXPECT_EQ(static_cast<Mode>(samples[511].mode), Mode::SF);
  EXPECT_EQ(samples[511].brakes & 4, 4);
}

/// A clock by which each cycle has just begun when the outside offers its inputs.
class ClockOfASlowWorld final : public realtime::Clock {
 public:
  Nanoseconds now() override {
    if (std::this_thread::get_id() != outside_ || arrived_ == 0) return {};
    ++allowed_;
    while (arrived_ <= allowed_) std::this_thread::yield();
    return {};
  }
  void wait_until(Nanoseconds, const std::stop_token& stop) override {
    ++arrived_;
    while (arrived_ > allowed_ && !stop.stop_requested()) std::this_thread::yield();
  }

 private:
  const std::thread::id outside_ = std::this_thread::get_id();
  std::atomic<std::int64_t> arrived_ = 0, allowed_ = 1;  // numbers of cycles
};

/// Whoever stops it does not wait for such a world.
TEST(RealTime, AWorldThatIsAlwaysLateCanBeStopped) {
  Drive timed;
  ClockOfASlowWorld clock;
  int asked = 0;
  const RealTime measured = timed.in_real_time(clock, [&] { return ++asked == 100; });
  EXPECT_EQ(timed.journey->cycles(), 100u);
  EXPECT_EQ(measured.without_inputs, 99u);  // those of cycle 0 are made before it begins
  EXPECT_FALSE(timed.world->finished());
}

/// It ends by itself: its train never moves.
TEST(RealTime, AWorldThatIsAlwaysLateEnds) {
  Drive timed;
  ClockOfASlowWorld clock;
  (void)timed.in_real_time(clock, [] { return false; });
  EXPECT_TRUE(timed.world->finished());
}

/// SUBSET-041 5.2.1.1: a unit that is later than the brake order has to come has failed.
TEST(RealTime, AUnitThatIsASecondLateFails) {
  for (const int late_ms : {1000, 1001}) {
    Drive timed;
    TestClock* time = nullptr;
    TestClock clock([&](Nanoseconds due) {
      if (!timed.exchange.ready(timed.cycle_of(due))) return false;
      if (timed.cycle_of(due) == 300) time->pass(std::chrono::milliseconds(100 + late_ms));
      return true;
    });
    time = &clock;
    const RealTime measured = timed.in_real_time(clock, [&] { return timed.journey->cycles() > 301; });
    EXPECT_GE(measured.timing.missed, 1u);
    EXPECT_EQ(measured.timing.jitter.max(), Nanoseconds{std::chrono::milliseconds(late_ms)});
    ASSERT_EQ(timed.journey->samples().size(), 302u);
    EXPECT_NE(static_cast<Mode>(timed.journey->samples()[299].mode), Mode::SF);
    EXPECT_EQ(static_cast<Mode>(timed.journey->samples()[300].mode) == Mode::SF, late_ms > 1000);
    EXPECT_TRUE(timed.replayed() == timed.recorder->records().outputs);
  }
}

}  // namespace
}  // namespace evc::run
