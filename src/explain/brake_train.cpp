#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "explain/brake.h"
#include "explain/words.h"
#include "kernel/here.h"
#include "position/position.h"
#include "terms/packet_numbers.h"
#include "train/national_values.h"

// Commands because of movements and of train data.
namespace evc::explain {
namespace {

/// How far the counter moved from the reference of a protection, in the direction of the active cab.
std::optional<Distance> moved(const protection::DistanceGuard& guard, const Moment& m) {
  if (!guard.reference) return std::nullopt;
  return position::forward_counter(m.after.position) - *guard.reference;
}

/// The source of the distance that a movement may not exceed.
Step distance_step(const Journal& journal, const Moment& m, const char* name, Distance limit, const char* clause) {
  return national_values_step(journal, m.t_ms, fmt::format("{} {}", name, metres_words(limit)), clause);
}
Step D_NVROLL_step(const Journal& journal, const Moment& m, const char* clause) {
  return distance_step(journal, m, "D_NVROLL", m.after.national_values.D_NVROLL, clause);
}

Step guarded(const Moment& m, const protection::DistanceGuard& guard, const char* clause) {
  const auto distance = moved(guard, m);
  const Distance limit = m.after.national_values.D_NVROLL;
  return {m.t_ms,
          distance ? fmt::format("the train has moved {:.2f} m {}, D_NVROLL is {}", std::abs(distance->si),
                                 distance->si < 0.0 ? "backwards" : "forwards", metres_words(limit))
                   : fmt::format("the train moves, D_NVROLL is {}", metres_words(limit)),
          clause};
}

/// `last` behind what came before it, in the order of time.
Steps behind(Steps steps, Step last) {
  std::stable_sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.t_ms < b.t_ms; });
  steps.push_back(std::move(last));
  return steps;
}

const char* controller_words(port::DirectionController controller) {
  return controller == port::DirectionController::forward    ? "forward"
         : controller == port::DirectionController::backward ? "backward"
                                                             : "neutral";
}

/// 3.14.2.2: against the position of the direction controller.
Steps roll_away_steps(const Journal& journal, const Moment& m) {
  Step step = guarded(m, m.before.guards.roll_away, "3.14.2");
  step.text += fmt::format("; the direction controller is {}", controller_words(m.train.direction_controller));
  Steps steps{D_NVROLL_step(journal, m, step.clause.c_str())};
  if (const Act* act = journal.last(Act::Kind::controller, m.t_ms)) steps.push_back(step_of(*act));
  return behind(std::move(steps), std::move(step));
}

/// 3.14.3.1: against the permitted direction, wherever the direction controller is.
Steps reverse_movement_steps(const Journal& journal, const Moment& m) {
  Step step = guarded(m, m.before.guards.reverse_movement, "3.14.3");
  step.text += fmt::format(", against the permitted direction of {}", name(m.after.mode));
  return {D_NVROLL_step(journal, m, step.clause.c_str()), std::move(step)};
}

Steps window_steps(const Journal& journal, const Moment& m, port::Window window, const char* clause) {
  Steps steps;
  if (const Act* act = journal.last(Act::Kind::window, m.t_ms, static_cast<std::uint8_t>(window)))
    steps.push_back(step_of(*act));
  steps.push_back({m.t_ms, fmt::format("the train moves at {} while it is open", kmh_words(m.outputs.v)), clause});
  return steps;
}

/// What is wrong with the readings of the odometer.
Step odometry_step(const Moment& m) {
  const port::Odometry& o = m.odometry;
  const auto age = o.measured ? static_cast<double>(m.t_ms) / 1000.0 - o.measured->si : 0.0;
  if (age > 1.0)
    return {m.t_ms,
            fmt::format("the odometer is silent: its last reading, of {:.1f} s, is {:.1f} s old, more than 1 s",
                        o.measured->si, age),
            "4.4.5.1.1"};
  const bool place = o.min <= o.nominal && o.nominal <= o.max;
  const bool speed = o.V_min <= o.V_est && o.V_est <= o.V_max;
  return {m.t_ms,
          !place   ? "the odometer is not sound: its place lies outside of its interval"
          : !speed ? "the odometer is not sound: its speed lies outside of its interval"
                   : "odometer or time is not sound: out of range, or earlier than before",
          "4.4.5.1.1"};
}

/// The mode and the source of the distance.
Steps with_mode(const Journal& journal, const Moment& m, Step distance, Step step) {
  Steps steps{std::move(distance)};
  if (const Note* note = journal.last(What::mode_changed, m.t_ms)) steps.push_back(step_of(*note));
  return behind(std::move(steps), std::move(step));
}

/// 3.14.4, in 4.0.0 moved to the mode.
Steps standstill_steps(const Journal& journal, const Moment& m) {
  const char* clause = m.after.srs == SrsVersion::v4_0_0 ? "4.4.7.1.5.1" : "3.14.4";
  return with_mode(journal, m, D_NVROLL_step(journal, m, clause), guarded(m, m.before.guards.standstill, clause));
}

/// The distance of packet 139, from the end of the area of packet 138.
Steps reversing_steps(const Journal& journal, const Moment& m) {
  Steps steps;
  if (const Note* note = journal.last(What::packet_accepted, m.t_ms, std::int32_t{packet::reversing_area}))
    steps.push_back(step_of(*note));
  const auto& supervision = m.after.track.reversing_supervision;
  if (const Note* note = journal.last(What::packet_accepted, m.t_ms, std::int32_t{packet::reversing_supervision})) {
    steps.push_back(step_of(*note));
    if (supervision && supervision->D_REVERSE)
      steps.back().text += fmt::format(": D_REVERSE {}", metres_words(*supervision->D_REVERSE));
  }
  if (const Note* note = journal.last(What::mode_changed, m.t_ms)) steps.push_back(step_of(*note));
  const auto left = track::reversing_left(m.after.track, kernel::here(m.after));
  steps.push_back({m.t_ms,
                   fmt::format("the train is {}beyond the distance to run in reverse",
                               left ? fmt::format("{:.2f} m ", std::abs(left->si)) : ""),
                   "3.15.4.8"});
  return steps;
}

}  // namespace

Steps movement_steps(Cause cause, const Journal& journal, const Moment& m) {
  switch (cause) {
    case Cause::roll_away:
      return roll_away_steps(journal, m);
    case Cause::reverse_movement:
      return reverse_movement_steps(journal, m);
    case Cause::standstill:
      return standstill_steps(journal, m);
    case Cause::post_trip_distance:
      return with_mode(journal, m,
                       distance_step(journal, m, "D_NVPOTRP", m.after.national_values.D_NVPOTRP, "4.4.14.1.3"),
                       {m.t_ms,
                        fmt::format("the train has moved backwards farther than D_NVPOTRP, {}",
                                    metres_words(m.after.national_values.D_NVPOTRP)),
                        "4.4.14.1.3"});
    case Cause::reversing_distance:
      return reversing_steps(journal, m);
    case Cause::movement_while_entering_train_data:
      return window_steps(journal, m, port::Window::train_data, "3.18.3.3.1");
    default:
      return window_steps(journal, m, port::Window::SR_data, "4.4.11.1.5.1");
  }
}

Steps train_data_steps(const Journal& journal, const Moment& m) {
  Steps steps;
  if (const Act* act = journal.last(Act::Kind::external_data, m.t_ms)) steps.push_back(step_of(*act));
  const bool validates = m.after.train_data_change.procedure.step == procedures::train_data_change::Step::S4;
  steps.push_back(
      {m.t_ms,
       fmt::format("in {} at {}: {}; first the train has to stop", name(m.after.mode), kmh_words(m.outputs.v),
                   validates ? "the driver has to validate them" : "the route may not suit it any more"),
       "5.17.2.2"});
  return steps;
}

Steps fault_steps(const Journal& journal, const Moment& m) {
  Steps steps;
  const Act* reported = journal.last(Act::Kind::fault, m.t_ms);
  if (m.safety_fault && reported != nullptr) steps.push_back(step_of(*reported));
  for (const Note& note : journal.notes()) {
    if (note.t_ms != m.t_ms) continue;
    if (note.event.what == What::odometry_not_sound) steps.push_back(odometry_step(m));
    if (note.event.what == What::mode_not_of_level) steps.push_back(step_of(note));
  }
  if (m.after.configuration_refused)
    steps.push_back({m.t_ms, "the configuration is out of range: train data or national values", "4.4.5.1.1"});
  return steps;
}

}  // namespace evc::explain
