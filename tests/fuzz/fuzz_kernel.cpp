// Any telegrams, messages, odometer readings and driver actions: the kernel answers every cycle, its outputs
// are well formed, and the same inputs give the same outputs.
#include <cstdlib>
#include <cstring>
#include <memory>

#include "kernel/evc.h"
#include "kernel/state.h"

namespace {

using namespace evc;

/// Reads the fuzzer's bytes; zeros when they are used up.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  bool left() const { return at_ < size_; }
  std::uint8_t next() { return at_ < size_ ? data_[at_++] : std::uint8_t{0}; }
  std::span<const std::uint8_t> take(std::size_t n) {
    n = n < size_ - at_ ? n : size_ - at_;
    const std::span<const std::uint8_t> taken{data_ + at_, n};
    at_ += n;
    return taken;
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
  std::size_t at_ = 0;
};

struct Unit {
  std::unique_ptr<kernel::State> state = std::make_unique<kernel::State>();
  std::unique_ptr<kernel::Derived> derived = std::make_unique<kernel::Derived>();
  std::unique_ptr<kernel::Outputs> out = std::make_unique<kernel::Outputs>();
};

void check(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  Unit unit;
  kernel::Config config;
  train::TrainData changed = config.train;  // by another source than the driver
  changed.axle_load = config.train.axle_load == train::AxleLoad::A ? train::AxleLoad::B1 : train::AxleLoad::A;
  kernel::power_up(*unit.state, *unit.derived, config);
  kernel::Inputs in;
  in.train.desk_open = true;
  in.national_system.available = 2;
  double place = 0.0;
  double doubt = 0.0;
  double t = 0.0;
  for (int cycle = 0; cycle < 400 && bytes.left(); ++cycle) {
    const std::uint8_t what = bytes.next();
    const double v = static_cast<double>(bytes.next()) / 4.0;
    place += ((what & 0x80) != 0 ? -v : v) * 0.1;
    doubt += v * 0.001;
    t += 0.1;
    in.now = {t};
    in.odometry = {{{place}}, {{place - doubt}}, {{place + doubt}}, {v}, {v > 0.5 ? v - 0.5 : 0.0}, {v + 0.5}, {0.0}};
    in.driver = {};
    in.external_train_data = {};
    in.radio_link = RadioLink::unchanged;
    kernel::BaliseTelegram telegram;
    kernel::RadioMessage message;
    switch (what & 7) {
      case 0:
      case 1: {
        const std::size_t n = bytes.next() % 105u;
        telegram.bytes = bytes.take(n);
        telegram.bits = telegram.bytes.size() * 8 - (bytes.next() & 7u) * (telegram.bytes.empty() ? 0u : 1u);
        telegram.at = {{place}};
        in.balise_telegrams = {&telegram, 1};
        break;
      }
      case 2:
      case 3: {
        const std::size_t n = bytes.next() * 4u + 1u;
        message.bytes = bytes.take(n);
        in.radio_messages = {&message, 1};
        break;
      }
      case 4:
        in.driver.selected = bytes.next() | (static_cast<std::uint32_t>(bytes.next()) << 8);
        break;
      case 5:
        in.driver.acknowledged = bytes.next() | (static_cast<std::uint32_t>(bytes.next()) << 8);
        break;
      case 6: {
        const std::uint8_t entry = bytes.next();
        in.driver.driver_id = evc::DriverId("1");
        if ((entry & 1) != 0) in.driver.level = static_cast<Level>((entry >> 1) % kLevels);
        in.driver.nid_ntc = 1;
        if ((entry & 16) != 0) in.driver.train_data = &config.train;
        if ((entry & 32) != 0) in.driver.train_running_number = 1;
        if ((entry & 64) != 0) in.driver.rbc_contact = kernel::DriverActions::RbcContact{1, 1, 1};
        break;
      }
      default: {
        const std::uint8_t more = bytes.next();
        in.radio_link = static_cast<RadioLink>(more % 4u);
        in.windows = Set<kernel::Window>::of_bits((more >> 2) & 3u);
        in.train.antenna_alarm = (more & 16) != 0;
        in.national_system.service_brake = (more & 32) != 0;
        in.national_system.emergency_brake = (what & 128) != 0;
        if ((more & 64) != 0) in.external_train_data = {&changed, (more & 128) != 0};
        in.train.sleeping = (what & 8) != 0;
        in.train.integrity = static_cast<TrainIntegrity>((more >> 5) % 3u);
        in.train.non_leading = (what & 16) != 0;
        in.train.desk_open = (what & 32) == 0;
        break;
      }
    }
    auto twin = std::make_unique<kernel::State>(*unit.state);
    kernel::step(*unit.state, *unit.derived, in, *unit.out);
    check(unit.out->min_safe_front <= unit.out->est_front && unit.out->est_front <= unit.out->max_safe_front);
    check(static_cast<std::size_t>(unit.out->mode) < kModes);
    if (cycle % 16 == 0) {
      // A snapshot taken before the cycle gives the same cycle, with all derived data computed again.
      Unit other;
      other.state = std::move(twin);
      kernel::step(*other.state, *other.derived, in, *other.out);
      check(other.out->mode == unit.out->mode && other.out->eb == unit.out->eb && other.out->V_P == unit.out->V_P &&
            other.out->EOA == unit.out->EOA);
    }
    in.balise_telegrams = {};
    in.radio_messages = {};
  }
  return 0;
}
