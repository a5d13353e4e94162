#include "run/drive.h"

#include <chrono>
#include <memory>
#include <thread>
#include <utility>

#include "realtime/executor.h"

namespace evc::run {
namespace {

using realtime::Nanoseconds;

/// Brake orders have to come within 1 s (SUBSET-041 5.2.1.1, 5.2.1.6, 5.2.1.13). A unit that begins a cycle later than
/// that does not supervise any more: it has failed (4.4.5).
constexpr Nanoseconds kLatest = std::chrono::seconds(1);

/// The on-board's side of the exchange: one call is one cycle.
class Unit {
 public:
  Unit(OnBoard& on_board, Exchange& exchange, realtime::Clock& clock, std::int64_t cycle_ms)
      : on_board_(on_board), exchange_(exchange), clock_(clock), cycle_ms_(cycle_ms) {}

  void cycle(const realtime::Cycle& cycle) {
    const auto offered_at = exchange_.take(cycle.number, inputs_);
    if (!offered_at) hold();
    if (offered_at) age_.add(clock_.now() - *offered_at);
    inputs_.t_ms = cycle.number * cycle_ms_;
    if (cycle.late > kLatest) inputs_.levels.safety_fault = true;
    const kernel::Outputs& outputs = on_board_.step(inputs_.view());
    exchange_.publish([&](Exchange::Result& result) {
      result.cycle = cycle.number;
      result.fresh = offered_at.has_value();
      result.in = inputs_;
      result.out = outputs;
    });
  }

  const realtime::Times& age() const { return age_; }  // when the thread has ended

 private:
  /// A cycle without inputs of its own: signals keep their value, the odometer's reading grows old.
  void hold() {
    auto& odometry = inputs_.levels.odometry;
    if (!odometry.measured) odometry.measured = {static_cast<double>(inputs_.t_ms) / 1000.0};
    inputs_.clear();
  }

  OnBoard& on_board_;
  Exchange& exchange_;
  realtime::Clock& clock_;
  std::int64_t cycle_ms_;
  sim::CycleInputs inputs_;
  realtime::Times age_;
};

/// Makes the inputs of the next cycle, and while the unit begins that without them, those of the cycles behind it.
std::int64_t offer(sim::World& world, Exchange& exchange, sim::CycleInputs& mine, std::int64_t cycle_ms,
                   realtime::Clock& clock) {
  const sim::CycleInputs* made = &world.advance();
  for (;;) {
    mine = *made;
    const std::int64_t cycle = made->t_ms / cycle_ms;
    const std::int64_t taken_for = exchange.offer(cycle, mine, clock.now());
    if (taken_for == cycle) return cycle;
    while (made->t_ms < taken_for * cycle_ms) made = &world.advance_further();
  }
}

}  // namespace

void Recorder::add(const sim::CycleInputs& inputs, const kernel::Outputs& outputs) {
  writer_.append(records_.inputs, inputs);
  journey_.record(inputs, outputs);
  io::append_output(records_.outputs, inputs.t_ms, outputs);
  io::append_trace(records_.trace, inputs.t_ms, outputs);
  progress_.show((world_.front_m() - world_.start_m()) / (world_.end_m() - world_.start_m()), inputs.t_ms,
                 world_.motion().speed() * 3.6);
}

void drive(sim::World& world, OnBoard& on_board, Recorder& recorder) {
  do {
    sim::CycleInputs& inputs = world.advance();
    const kernel::Outputs& outputs = on_board.step(inputs.view());
    world.observe(outputs);
    recorder.add(inputs, outputs);
  } while (!world.finished());
}

RealTime drive_in_real_time(sim::World& world, OnBoard& on_board, Recorder& recorder, std::int64_t cycle_ms,
                            realtime::Clock& clock, Exchange& exchange, const std::function<bool()>& stopped) {
  realtime::Executor executor(clock, std::chrono::milliseconds(cycle_ms));
  Unit unit(on_board, exchange, clock, cycle_ms);
  sim::CycleInputs mine;
  std::int64_t offered = offer(world, exchange, mine, cycle_ms, clock);
  std::jthread thread([&](const std::stop_token& stop) {
    executor.run(clock.now(), stop, [&](const realtime::Cycle& cycle) { unit.cycle(cycle); });
    exchange.close();
  });
  Exchange::Result result;
  std::uint64_t without_inputs = 0;
  while (exchange.next(result)) {
    world.observe(result.out);
    recorder.add(result.in, result.out);
    without_inputs += result.fresh ? 0 : 1;
    if (stopped() || world.finished()) break;
    if (result.cycle < offered) continue;  // of a cycle without inputs: those offered are of a later one
    offered = offer(world, exchange, mine, cycle_ms, clock);
  }
  thread.request_stop();
  thread.join();
  return {cycle_ms, executor.timing(), unit.age(), without_inputs, exchange.lost()};
}

}  // namespace evc::run
