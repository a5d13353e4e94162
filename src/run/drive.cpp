#include "run/drive.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>
#include <vector>

#include "realtime/executor.h"

namespace evc::run {
namespace {

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
    if (cycle.late > kLatestCycle) inputs_.levels.safety_fault = true;
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

/// The outside's side: it makes the inputs, and knows where the train was at each cycle.
class Outside {
 public:
  Outside(sim::World& world, Exchange& exchange, realtime::Clock& clock, std::int64_t cycle_ms)
      : world_(world), exchange_(exchange), clock_(clock), cycle_ms_(cycle_ms) {}

  /// Offers the inputs of the next cycle. When that has begun without them: makes those of the cycles behind it, to be
  /// offered the next time.
  void offer() {
    if (!refused_) advance(false);
    const std::int64_t cycle = made();
    mine_ = *made_;
    const std::int64_t taken_for = exchange_.offer(cycle, mine_, clock_.now());
    refused_ = taken_for != cycle;
    while (made() < taken_for) advance(true);
  }
  /// Whether results are to be taken behind this one before the next offer: up to that of the inputs offered, or, when
  /// they were refused, those that are there.
  bool waits(const Exchange::Result& result) const { return refused_ ? exchange_.waiting() : result.cycle < made(); }

  /// Of the cycle of a result, whose inputs may be those of an earlier one and whose world may be at a later one.
  Truth truth_of(const Exchange::Result& result) {
    if (result.fresh) delivered_ = world_.radio().deliveries().size();
    const auto cycle = static_cast<std::size_t>(result.cycle);
    return {fronts_[std::min(cycle, fronts_.size() - 1)], delivered_, cycle < fronts_.size()};
  }

 private:
  void advance(bool further) {
    made_ = further ? &world_.advance_further() : &world_.advance();
    fronts_.push_back(world_.front_m());
  }
  std::int64_t made() const { return made_->t_ms / cycle_ms_; }

  sim::World& world_;
  Exchange& exchange_;
  realtime::Clock& clock_;
  std::int64_t cycle_ms_;
  sim::CycleInputs mine_;
  const sim::CycleInputs* made_ = nullptr;
  bool refused_ = false;
  std::vector<double> fronts_;  // of all cycles
  std::size_t delivered_ = 0;   // messages that came with the inputs of a result
};

}  // namespace

void Recorder::add(const sim::CycleInputs& inputs, const kernel::Outputs& outputs, const Truth& truth) {
  writer_.append(records_.inputs, inputs);
  journey_.record(inputs, outputs, truth);
  io::append_output(records_.outputs, inputs.t_ms, outputs);
  io::append_trace(records_.trace, inputs.t_ms, outputs);
  if (!progress_) return;
  progress_->show((truth.front_m - world_.start_m()) / (world_.end_m() - world_.start_m()), inputs.t_ms,
                  world_.motion().speed() * 3.6);
}

void drive(sim::World& world, OnBoard& on_board, Recorder& recorder, const std::function<bool()>& stopped) {
  do {
    sim::CycleInputs& inputs = world.advance();
    const Truth truth{world.front_m(), world.radio().deliveries().size()};
    const kernel::Outputs& outputs = on_board.step(inputs.view());
    world.observe(outputs);
    recorder.add(inputs, outputs, truth);
    if (recorder.keeps_displays()) recorder.show(inputs, on_board.show());
  } while (!world.finished() && !(stopped && stopped()));
}

RealTime drive_in_real_time(sim::World& world, OnBoard& on_board, Recorder& recorder, std::int64_t cycle_ms,
                            realtime::Clock& clock, Exchange& exchange, const std::function<bool()>& stopped,
                            OnBoard* twin) {
  realtime::Executor executor(clock, std::chrono::milliseconds(cycle_ms));
  Unit unit(on_board, exchange, clock, cycle_ms);
  Outside outside(world, exchange, clock, cycle_ms);
  outside.offer();
  std::jthread thread([&](const std::stop_token& stop) {
    executor.run(clock.now(), stop, [&](const realtime::Cycle& cycle) { unit.cycle(cycle); });
    exchange.close();
  });
  Exchange::Result result;
  std::uint64_t without_inputs = 0;
  while (exchange.next(result)) {
    world.observe(result.out);
    recorder.add(result.in, result.out, outside.truth_of(result));
    if (twin != nullptr && recorder.keeps_displays()) {
      (void)twin->step(result.in.view());
      recorder.show(result.in, twin->show());
    }
    without_inputs += result.fresh ? 0 : 1;
    if (stopped()) break;
    if (outside.waits(result)) continue;
    if (world.finished()) break;
    outside.offer();
  }
  thread.request_stop();
  thread.join();
  return {cycle_ms, executor.timing(), unit.age(), without_inputs, exchange.lost()};
}

}  // namespace evc::run
