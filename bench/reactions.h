#pragma once
// The reactions of the on-board to which SUBSET-041 gives a time: for each a unit that has been driven to the moment
// before, an event, and what has to come of it. From outside alone: Inputs and Outputs.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/file.h"
#include "io/input_stream.h"
#include "io/line_file.h"
#include "lang/messages.h"
#include "lang/packets/packet_137.h"
#include "lang/packets/packet_15.h"
#include "ride.h"
#include "sim/world.h"

namespace evc::bench {

/// A unit at a moment. Afterwards the train runs on at its speed, whatever the unit commands.
struct Scene {
  std::unique_ptr<kernel::State> state = std::make_unique<kernel::State>();
  std::unique_ptr<kernel::Derived> derived = std::make_unique<kernel::Derived>();
  kernel::Outputs outputs;
  sim::CycleInputs inputs;
  double t0 = 0.0;

  Scene() = default;
  explicit Scene(Ride& ride) : outputs(ride.outputs()) {
    *state = ride.state();
    *derived = ride.derived();
    inputs.levels = ride.inputs();
    t0 = inputs.levels.now.si;
    inputs.clear();
  }
  /// The reading of the odometer at `u` seconds after the moment.
  kernel::Odometry odometry(double u) const {
    kernel::Odometry o = inputs.levels.odometry;
    const double way = o.V_est.si * u;
    o.nominal.from_origin.si += way;
    o.min.from_origin.si += 0.99 * way;
    o.max.from_origin.si += 1.01 * way;
    o.A_est = {0.0};
    o.measured = {t0 + u};
    return o;
  }
};

struct Reaction {
  std::string what, clause;
  double limit_s = 0.0;
  Scene scene;
  double event_s = 0.0;  ///< when it happens, after the moment of the scene
  /// Puts the event into the inputs of the next cycle.
  std::function<void(sim::CycleInputs&)> happen = [](sim::CycleInputs&) {};
  std::function<bool(const kernel::Outputs&)> seen;
};

inline constexpr double kEvent_s = 0.35;

inline sim::Bits bits_of(const Telegram& t) { return {{t.bytes.begin(), t.bytes.end()}, Telegram::bits}; }

template <class M, class... P>
sim::CycleInputs::RadioMessage radio_message(const M& message, const P&... packets) {
  std::array<std::uint8_t, 256> bytes{};
  BitWriter out(bytes);
  lang::encode_message(out, message, packets...);
  const auto used = out.bytes();
  sim::CycleInputs::RadioMessage made;
  made.bytes = {used.begin(), used.end()};
  made.size = 8 * used.size();
  return made;
}

/// Emergency brake that the scene did not have.
inline bool braked(const kernel::Outputs& o) { return o.eb; }

/// A balise that stops a train in SR (3.5, packet 137) is read.
inline Reaction balise_to_brake() {
  Ride ride;
  ride.start();
  double v = 0.0;
  for (; v < 8.0; v += 0.05) ride.cycle(v);
  ride.cycle(v);
  Reaction r{"balise to emergency brake order", "5.2.1.1", 1.0, Scene(ride), kEvent_s, {}, braked};
  lang::Packet137 stop;
  stop.Q_DIR.raw = 1;
  stop.Q_SRSTOP.raw = 0;
  // Two balises: a group of one has no orientation (3.4.2).
  const auto last = r.scene.odometry(kEvent_s).nominal;
  const OdometerPlace first{{last.from_origin.si - 3.0}};
  r.happen = [=, a = bits_of(telegram(77, 0, 1)), b = bits_of(telegram(77, 1, 1, stop))](sim::CycleInputs& in) {
    in.balises.push_back({a, first});
    in.balises.push_back({b, last});
  };
  return r;
}

inline std::function<bool(const kernel::Outputs&)> another_authority(const Scene& scene) {
  return [EOA = scene.outputs.EOA](const kernel::Outputs& o) {
    return o.EOA && EOA && std::abs(o.EOA->from_origin.si - EOA->from_origin.si) > 50.0;
  };
}

/// A group of three balises replaces all track data in FS; the display shows the new end of authority.
inline Reaction balise_to_display() {
  Ride ride;
  ride.into_full_supervision(35.0);
  for (int i = 0; i < 100; ++i) ride.cycle(35.0);
  Reaction r{"balise authority to display", "5.2.1.3", 1.5, Scene(ride), kEvent_s, {}, {}};
  r.seen = another_authority(r.scene);
  const Group telegrams = group(2);
  const auto last = r.scene.odometry(kEvent_s).nominal;
  r.happen = [=](sim::CycleInputs& in) {
    for (std::size_t i = 0; i < telegrams.size(); ++i) {
      OdometerPlace at = last;
      at.from_origin.si -= 3.0 * static_cast<double>(telegrams.size() - 1 - i);
      in.balises.push_back({bits_of(telegrams[i]), at});
    }
  };
  return r;
}

/// The shipped line until the train has run in FS in level 2 with an end of authority far ahead.
inline Scene in_level_2(const std::string& file, std::uint32_t& NID_LRBG, std::uint32_t& L_END) {
  const auto text = io::read_text(file);
  if (!text) throw std::runtime_error(text.error().text());
  const auto line = io::read_line(*text, file);
  if (!line) throw std::runtime_error(line.error().text());
  const io::Train train;
  io::Configuration configuration;
  sim::World world(*line, train.data, train.dynamics, {});
  Scene scene;
  kernel::power_up(*scene.state, *scene.derived, configuration.for_kernel());
  while (!world.finished()) {
    sim::CycleInputs& inputs = world.advance();
    kernel::step(*scene.state, *scene.derived, inputs.view(), scene.outputs);
    world.observe(scene.outputs);
    const kernel::Outputs& o = scene.outputs;
    if (o.mode != Mode::FS || o.level != Level::L2 || !o.EOA || !o.lrbg || o.v.si < 20.0) continue;
    const auto reference = world.reference(*o.lrbg);
    if (!reference || o.EOA->from_origin.si - o.est_front.from_origin.si < 2500.0) continue;
    NID_LRBG = static_cast<std::uint32_t>(o.lrbg->NID_C) << 14 | o.lrbg->NID_BG;
    L_END = static_cast<std::uint32_t>(o.EOA->from_origin.si - reference->nominal_m - 500.0);
    scene.inputs = inputs;
    scene.t0 = static_cast<double>(inputs.t_ms) / 1000.0;
    scene.inputs.clear();
    return scene;
  }
  throw std::runtime_error("the shipped line has no place for the scene");
}

/// Time stamp behind all of the scene, 10 ms each (7.5.1.155).
inline std::uint32_t stamp_after(const Scene& scene) {
  return static_cast<std::uint32_t>((scene.t0 + kEvent_s) * 100.0);
}

inline Reaction message_to_brake(const std::string& line) {
  lang::Message16 stop;
  std::uint32_t NID_LRBG = 0, L_END = 0;
  Reaction r{
      "emergency message to brake order", "5.2.1.6", 1.0, in_level_2(line, NID_LRBG, L_END), kEvent_s, {}, braked};
  stop.NID_LRBG.raw = NID_LRBG;
  stop.NID_EM.raw = 1;
  stop.T_TRAIN.raw = stamp_after(r.scene);
  r.happen = [message = radio_message(stop)](sim::CycleInputs& in) { in.radio.push_back(message); };
  return r;
}

inline Reaction message_to_display(const std::string& line) {
  lang::Message3 shorter;
  std::uint32_t NID_LRBG = 0;
  lang::Packet15 p;
  std::uint32_t L_END = 0;
  Reaction r{"radio authority to display", "5.2.1.4", 1.5, in_level_2(line, NID_LRBG, L_END), kEvent_s, {}, {}};
  r.seen = another_authority(r.scene);
  shorter.NID_LRBG.raw = NID_LRBG;
  shorter.T_TRAIN.raw = stamp_after(r.scene);
  p.Q_DIR.raw = 1;
  p.Q_SCALE.raw = 1;
  p.T_EMA.raw = 1023;
  p.L_ENDSECTION.raw = static_cast<std::uint16_t>(L_END);
  r.happen = [message = radio_message(shorter, p)](sim::CycleInputs& in) { in.radio.push_back(message); };
  return r;
}

/// In level 1 below the release speed the min safe antenna position passes the end of authority: trip.
inline Reaction end_passed_to_brake() {
  Ride ride;
  ride.into_full_supervision(35.0);
  double v = 35.0;
  const auto left = [&] {
    const kernel::Outputs& o = ride.outputs();
    if (!o.EOA) throw std::runtime_error("the scene has no end of authority");
    return o.EOA->from_origin.si - o.min_safe_front.from_origin.si + kernel::Config{}.train.L_antenna_front.si;
  };
  constexpr double slow = 4.0;
  while (left() > 2.0) {
    const double comfortable = std::sqrt(std::max(0.0, 2.0 * 0.25 * (left() - 400.0)));
    v = std::max(slow, std::min(v, comfortable));
    ride.cycle(v);
  }
  Reaction r{"end of authority passed to brake", "5.2.1.13", 1.0, Scene(ride), 0.0, {}, {}};
  r.event_s = left() / (0.99 * slow);
  r.happen = [](sim::CycleInputs&) {};
  r.seen = [](const kernel::Outputs& o) { return o.eb && o.mode == Mode::TR; };
  return r;
}

/// `line`: the file of the shipped line.
inline std::vector<Reaction> reactions(const std::string& line) {
  std::vector<Reaction> all;
  all.push_back(balise_to_brake());
  all.push_back(message_to_brake(line));
  all.push_back(message_to_display(line));
  all.push_back(balise_to_display());
  all.push_back(end_passed_to_brake());
  for (const Reaction& r : all)
    if (r.seen(r.scene.outputs)) throw std::runtime_error(r.what + ": seen before the event");
  return all;
}

/// The unit of a scene, as it was at its moment.
class Unit {
 public:
  explicit Unit(const Scene& scene)
      : state_(std::make_unique<kernel::State>(*scene.state)),
        derived_(std::make_unique<kernel::Derived>(*scene.derived)) {}
  const kernel::Outputs& step(sim::CycleInputs& inputs, double now) {
    (void)inputs.view();
    inputs.levels.now = {now};
    kernel::step(*state_, *derived_, inputs.levels, outputs_);
    return outputs_;
  }

 private:
  std::unique_ptr<kernel::State> state_;
  std::unique_ptr<kernel::Derived> derived_;
  kernel::Outputs outputs_;
};

/// The time of a reaction when a step costs nothing; an event at the moment of a cycle is too late for it. Cycles at
/// `first_s`, `first_s` + `cycle_s`, ... after the moment, with a reading of the odometer that is `age_s` old. Nothing
/// within 5 s.
inline std::optional<double> simulated(const Reaction& r, double first_s, double cycle_s, double age_s) {
  Unit unit(r.scene);
  bool happened = false;
  for (int n = 0; first_s + n * cycle_s < r.event_s + 5.0; ++n) {
    const double u = first_s + n * cycle_s;
    sim::CycleInputs in = r.scene.inputs;
    in.levels.odometry = r.scene.odometry(u - age_s);
    if (!happened && u > r.event_s + 1e-9) {
      r.happen(in);
      happened = true;
    }
    if (r.seen(unit.step(in, r.scene.t0 + u))) return u - r.event_s;
  }
  return std::nullopt;
}

/// The longest of all phases of the event in a cycle, in steps of a millisecond.
inline std::optional<double> longest_simulated(const Reaction& r, int cycle_ms) {
  const double cycle_s = cycle_ms / 1000.0;
  double longest = 0.0;
  for (int phase_ms = 1; phase_ms <= cycle_ms; ++phase_ms) {
    const auto time = simulated(r, cycle_s + phase_ms / 1000.0, cycle_s, cycle_s / 2.0);
    if (!time) return std::nullopt;
    longest = std::max(longest, *time);
  }
  return longest;
}

}  // namespace evc::bench
