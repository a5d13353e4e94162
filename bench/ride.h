#pragma once
// A train driven by the test through a level 1 line whose groups send as much as a busy line: an authority of 10 km, 20
// gradient steps, 10 steps of the static speed profile and two temporary restrictions, which make 8 targets.
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "kernel/evc.h"
#include "kernel/state.h"
#include "lang/encode.h"
#include "lang/packets/packet_12.h"
#include "lang/packets/packet_21.h"
#include "lang/packets/packet_27.h"
#include "lang/packets/packet_65.h"

namespace evc::bench {

struct Telegram {
  std::array<std::uint8_t, 104> bytes{};
  static constexpr std::size_t bits = 830;
};

template <class... P>
Telegram telegram(std::uint16_t NID_BG, std::uint8_t N_PIG, std::uint8_t N_TOTAL, const P&... packets) {
  Telegram t;
  BitWriter out(t.bytes);
  lang::TelegramHeader header;
  header.N_PIG.raw = N_PIG;
  header.N_TOTAL.raw = N_TOTAL;
  header.NID_C.raw = 1;
  header.NID_BG.raw = NID_BG;
  lang::begin_telegram(out, header);
  (lang::encode(out, packets), ...);
  lang::end_telegram(out, Telegram::bits);
  return t;
}

inline lang::Packet12 authority() {
  lang::Packet12 p;
  p.Q_DIR.raw = 1;
  p.Q_SCALE.raw = 1;
  p.V_MAIN.raw = 36;  // 180 km/h
  p.T_EMA.raw = 1023;
  for (int i = 0; i < 3; ++i) {
    lang::Packet12_sections section;
    section.L_SECTION.raw = 2500;
    (void)p.sections.push_back(section);
  }
  p.L_ENDSECTION.raw = 2500;
  p.Q_DANGERPOINT.raw = 1;
  p.D_DP.raw = 100;
  p.V_RELEASEDP.raw = 4;
  return p;
}

/// 20 steps, with falls of up to 10 per mille, to beyond the end of the authority.
inline lang::Packet21 gradients() {
  constexpr std::array<int, 20> permille{0, 3, -2, 5, -8, 0, 10, -10, 4, -4, 6, -6, 2, -1, 8, -5, 0, 7, -7, 1};
  lang::Packet21 p;
  p.Q_DIR.raw = 1;
  p.Q_SCALE.raw = 1;
  p.Q_GDIR.raw = 1;
  for (std::size_t i = 1; i < permille.size(); ++i) {
    lang::Packet21_steps step;
    step.D_GRADIENT.raw = 550;
    step.Q_GDIR.raw = permille[i] >= 0 ? 1 : 0;
    step.G_A.raw = static_cast<std::uint8_t>(permille[i] >= 0 ? permille[i] : -permille[i]);
    (void)p.steps.push_back(step);
  }
  return p;
}

/// 10 steps, five of them down.
inline lang::Packet27 speeds() {
  constexpr std::array<int, 10> kmh{160, 140, 150, 120, 130, 100, 120, 80, 100, 60};
  lang::Packet27 p;
  p.Q_DIR.raw = 1;
  p.Q_SCALE.raw = 1;
  p.V_STATIC.raw = static_cast<std::uint8_t>(kmh[0] / 5);
  for (std::size_t i = 1; i < kmh.size(); ++i) {
    lang::Packet27_steps step;
    step.D_STATIC.raw = i == 1 ? 4000 : 700;
    step.V_STATIC.raw = static_cast<std::uint8_t>(kmh[i] / 5);
    (void)p.steps.push_back(step);
  }
  return p;
}

inline lang::Packet65 restriction(std::uint8_t NID_TSR, unsigned D_TSR, unsigned kmh) {
  lang::Packet65 p;
  p.Q_DIR.raw = 1;
  p.Q_SCALE.raw = 1;
  p.NID_TSR.raw = NID_TSR;
  p.D_TSR.raw = static_cast<std::uint16_t>(D_TSR);
  p.L_TSR.raw = 300;
  p.V_TSR.raw = static_cast<std::uint8_t>(kmh / 5);
  return p;
}

/// The telegrams of a group that sends all data again.
using Group = std::array<Telegram, 3>;
inline Group group(std::uint16_t NID_BG) {
  return {telegram(NID_BG, 0, 2, authority(), restriction(1, 4300, 90), restriction(2, 6000, 70)),
          telegram(NID_BG, 1, 2, gradients()), telegram(NID_BG, 2, 2, speeds())};
}

class Ride {
 public:
  explicit Ride(const kernel::Config& config = {}) : config_(config) { kernel::power_up(*state_, *derived_, config_); }

  const kernel::Outputs& outputs() const { return *outputs_; }
  kernel::Inputs& inputs() { return inputs_; }
  const kernel::State& state() const { return *state_; }
  const kernel::Derived& derived() const { return *derived_; }

  /// Moves the train 100 ms at `v` m/s and makes the inputs of that cycle; the caller measures step().
  void prepare(double v) {
    const double dx = (v + speed_) / 2.0 * 0.1;
    inputs_.odometry.A_est = {(v - speed_) / 0.1};
    speed_ = v;
    front_ += dx;
    doubt_ += dx * 0.01;
    inputs_.odometry.nominal = {{front_}};
    inputs_.odometry.min = {{front_ - doubt_}};
    inputs_.odometry.max = {{front_ + doubt_}};
    inputs_.odometry.V_est = {v};
    inputs_.odometry.V_min = {v > 0.2 ? v - 0.2 : 0.0};
    inputs_.odometry.V_max = {v > 0.0 ? v + 0.2 : 0.0};
    inputs_.now = {time_};
    time_ += 0.1;
  }
  void step() { kernel::step(*state_, *derived_, inputs_, *outputs_); }
  void finish() {
    inputs_.balise_telegrams = {};
    inputs_.driver = {};
  }
  void cycle(double v = 0.0) {
    prepare(v);
    step();
    finish();
  }
  /// The balises of a group are read in the next cycle.
  void read(std::span<const Telegram> telegrams) {
    telegrams_.assign(telegrams.begin(), telegrams.end());
    read_.clear();
    for (const Telegram& t : telegrams_)
      read_.push_back({t.bytes, Telegram::bits, {{front_ + 0.3 * static_cast<double>(read_.size())}}});
    inputs_.balise_telegrams = read_;
  }
  /// Start of mission in level 1 into SR (5.4).
  void start() {
    inputs_.train.desk_open = true;
    for (int i = 0; i < 10; ++i) cycle();
    inputs_.driver.driver_id = evc::DriverId("1234");
    cycle();
    inputs_.driver.level = Level::L1;
    cycle();
    inputs_.driver.train_data = &config_.train;
    cycle();
    inputs_.driver.train_running_number = 0x4711FFFF;
    cycle();
    cycle();
    inputs_.driver.selected = 1u << static_cast<unsigned>(kernel::Select::start);
    cycle();
    cycle();
    inputs_.driver.acknowledged = 1u << static_cast<unsigned>(Ack::SR);
    cycle();
    cycle();
  }
  /// From standstill in SR over the first group into FS, then up to `v` m/s.
  void into_full_supervision(double v) {
    start();
    double now = 0.0;
    for (; now < 8.0; now += 0.05) cycle(now);
    read(group(1));
    cycle(now);
    for (; now < v; now += 0.05) cycle(now);
  }

 private:
  kernel::Config config_;
  std::unique_ptr<kernel::State> state_ = std::make_unique<kernel::State>();
  std::unique_ptr<kernel::Derived> derived_ = std::make_unique<kernel::Derived>();
  std::unique_ptr<kernel::Outputs> outputs_ = std::make_unique<kernel::Outputs>();
  kernel::Inputs inputs_;
  std::vector<Telegram> telegrams_;
  std::vector<kernel::BaliseTelegram> read_;
  double front_ = 0.0, doubt_ = 0.0, speed_ = 0.0, time_ = 0.0;
};

}  // namespace evc::bench
