// A minute of an on-board unit with openevc::kernel alone: the driver opens the desk, enters the data, selects level 0
// and starts; the train departs. The outputs of the unit are printed every five seconds, without the numbers of its
// events. examples/unit.c is the same in C and prints the same.
#include <openevc/evc.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <utility>
#include <vector>

using namespace evc::literals;
namespace kernel = evc::kernel;

namespace {

constexpr double kCycle_s = 0.1;

/// Actions of the driver in cycle n.
void drive(kernel::DriverActions& driver, const evc::train::TrainData& train, int n) {
  if (n == 10) driver.driver_id = evc::DriverId("1234");
  if (n == 20) driver.level = evc::Level::L0;
  if (n == 30) driver.selected = 1u << static_cast<unsigned>(kernel::Select::train_data);
  if (n == 40) driver.train_data = &train;
  if (n == 50) driver.train_running_number = 0x00004711;
  if (n == 60) driver.selected = 1u << static_cast<unsigned>(kernel::Select::start);
  if (n > 60) driver.acknowledged = 1u << static_cast<unsigned>(evc::Ack::UN);
}

/// The odometer of a train at standstill for ten seconds, then gaining 0.5 m/s every second; error at most 1 %.
kernel::Odometry odometer(int n) {
  const double t = n > 100 ? (n - 100) * kCycle_s : 0.0;
  const double v = 0.5 * t;
  const double x = 0.25 * t * t;
  return {{{x}}, {{0.99 * x}}, {{1.01 * x}}, {v}, {0.99 * v}, {1.01 * v}, {t > 0.0 ? 0.5 : 0.0}};
}

}  // namespace

int main() {
  auto unit = std::make_unique<kernel::Unit>();  // plain memory, large: not on the stack
  const auto outputs = std::make_unique<kernel::Outputs>();
  const kernel::Config config;  // SRS 3.6.0, the standard train
  kernel::power_up(*unit, config);
  std::printf("%5s %4s %5s %8s %9s %6s\n", "s", "mode", "level", "km/h", "m", "brakes");
  for (int n = 0; n <= 600; ++n) {
    kernel::Inputs inputs;
    inputs.now = {n * kCycle_s};
    inputs.odometry = odometer(n);
    inputs.train.desk_open = n > 0;
    drive(inputs.driver, config.train, n);
    kernel::step(*unit, inputs, *outputs);
    if (n % 50 == 0)
      std::printf("%5.1f %4s %5s %8.3f %9.3f %6s\n", outputs->now.si, name(outputs->mode), name(outputs->level),
                  outputs->v.si * 3.6, outputs->est_front.from_origin.si,
                  outputs->eb   ? "EB"
                  : outputs->sb ? "SB"
                                : "-");
    if (n == 300) {  // a restored unit continues from the snapshot
      std::vector<std::byte> snapshot(kernel::snapshot_size());
      if (!kernel::snapshot(*unit, snapshot)) return 1;
      auto woken = std::make_unique<kernel::Unit>();
      if (kernel::restore(*woken, snapshot) != kernel::SnapshotFault::none) return 1;
      unit = std::move(woken);
    }
  }
  return outputs->mode == evc::Mode::UN ? 0 : 1;
}
