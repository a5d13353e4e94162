#include "sim/driver.h"

#include <algorithm>
#include <cmath>

namespace evc::sim {
namespace {

using port::Outputs;
using port::Select;

constexpr double kWithoutSpeed = 40.0 / kKmh;  // if neither on-board nor line gives a speed
constexpr double kBeforeLevel2 = 60.0 / kKmh;
constexpr double kComfortable = 0.45;   // m/s2, braking ahead
constexpr double kMargin = 3.0 / kKmh;  // below the permitted speed
constexpr double kMarginLate = 0.5 / kKmh;
constexpr double kStopShort = 12.0;             // metres before the end of authority
constexpr std::int64_t kEntry_ms = 1000;        // time between two entries
constexpr std::uint32_t kDigits = 0x4711FFFFu;  // train running number 4711, packed

constexpr std::uint32_t bit(Select s) { return 1u << static_cast<unsigned>(s); }

/// The deceleration with which the driver brakes for a place: comfortable, and well within the capacity of the brakes.
double comfortable(const Motion& motion) { return std::min(kComfortable, 0.6 * motion.full_service_brake()); }
/// How much earlier the driver begins because the brakes of a long train build up slowly: seconds and metres.
double slowness_s(const Motion& motion) {
  return std::max(0.0, motion.brake_build_up_s() - Dynamics{}.build_up_s) / 2.0;
}
double anticipation(const Motion& motion) { return motion.speed() * slowness_s(motion); }

/// The speed from which `a` reaches `v` within `d` metres.
double braking_from(double v, double a, double d) { return std::sqrt(v * v + 2.0 * a * std::max(0.0, d)); }

}  // namespace

Seen::Seen(const Outputs& o)
    : mode(o.mode),
      level(o.level),
      monitoring(o.monitoring),
      V_P(o.V_P),
      V_target(o.V_target),
      V_release(o.V_release),
      d_target(o.d_target),
      tco(o.tco),
      sb(o.sb),
      eb(o.eb),
      requests(o.requests),
      entries(o.entries),
      start_offered(o.start_offered) {}

Driver::Driver(DriverKind kind, const Line& line, const train::TrainData& train)
    : kind_(kind), line_(line), train_(train) {}

void Driver::act(const Seen& seen, std::int64_t t_ms, CycleInputs& inputs) {
  if (seen.level == Level::L2 || seen.level == Level::L3) level_2_entered_ = true;
  inputs.levels.train.desk_open = true;
  inputs.levels.train.direction_controller = port::DirectionController::forward;
  start_mission(seen, t_ms, inputs);
  acknowledge(seen, t_ms, inputs);
}

/// Start of mission (5.4.3): the data asked for are entered, then Start is selected.
void Driver::start_mission(const Seen& seen, std::int64_t t_ms, CycleInputs& inputs) {
  if (seen.mode != Mode::SB || t_ms < next_entry_ms_) return;
  auto& driver = inputs.levels.driver;
  next_entry_ms_ = t_ms + (kind_ == DriverKind::late ? 2 * kEntry_ms : kEntry_ms);
  if (seen.entries.has(Entry::driver_id)) {
    driver.driver_id = DriverId("4711");
  } else if (seen.entries.has(Entry::level)) {
    driver.level = line_.start_level;
    driver.nid_ntc = line_.start_nid_ntc;
  } else if (seen.entries.has(Entry::rbc_contact)) {
    driver.rbc_contact = line_.rbc.contact;
  } else if (seen.entries.has(Entry::train_data)) {
    inputs.train_data = train_;
    data_entered_ = true;
  } else if (seen.entries.has(Entry::train_running_number)) {
    driver.train_running_number = kDigits;
  } else if (seen.start_offered && data_entered_) {
    driver.selected |= bit(Select::start);
  } else if (!data_entered_) {
    driver.selected |= bit(Select::train_data);
  }
}

void Driver::acknowledge(const Seen& seen, std::int64_t t_ms, CycleInputs& inputs) {
  // The limit is 5 s (T_ACK, A.3.1).
  const std::int64_t delay = kind_ == DriverKind::late ? 3500 : 1000;
  for (std::size_t n = 0; n < asked_since_.size(); ++n) {
    if (!seen.requests.has(static_cast<Ack>(n))) {
      asked_since_[n].reset();
      continue;
    }
    if (!asked_since_[n]) asked_since_[n] = t_ms;
    if (t_ms - *asked_since_[n] < delay) continue;
    inputs.levels.driver.acknowledged |= 1u << n;
    asked_since_[n] = t_ms;
  }
}

double Driver::margin() const { return kind_ == DriverKind::late ? kMarginLate : kMargin; }

bool Driver::must_stand(const Seen& seen) const {
  switch (seen.mode) {
    case Mode::NP:
    case Mode::SB:
    case Mode::TR:
    case Mode::PT:
    case Mode::SF:
    case Mode::IS:
      return true;
    default:
      return false;
  }
}

/// The speed of the line at the train, with comfortable braking for lower ones ahead.
double Driver::speed_of_line(const Motion& motion) const {
  const double rear = motion.front() - train_.L_TRAIN.si;
  const double cap = level_2_entered_ ? 1000.0 : kBeforeLevel2;
  double allowed = cap;
  double covered_to = rear;  // without a segment at the front end there is no speed
  for (const SpeedSegment& s : line_.ssp) {
    const double v = s.kmh / kKmh;
    if (s.end_m <= rear) continue;
    if (s.start_m <= motion.front()) {
      allowed = std::min(allowed, v);
      if (s.end_m > motion.front()) covered_to = s.end_m;
    } else {
      allowed =
          std::min(allowed, braking_from(v, comfortable(motion), s.start_m - motion.front() - anticipation(motion)));
    }
  }
  if (covered_to <= motion.front()) allowed = std::min(allowed, kWithoutSpeed);
  return std::max(0.0, allowed - std::min(margin(), 0.1 * allowed));
}

/// The speed at which no limit is ever exceeded.
double Driver::permitted(const Seen& seen, const Motion& motion) const {
  if (!seen.V_P) return speed_of_line(motion);
  double limit = seen.V_P->si;
  const bool to_stop = seen.V_target && seen.V_target->si == 0.0;
  if (to_stop && seen.V_release) limit = std::max(limit, seen.V_release->si);
  double wanted = limit - std::min(margin(), 0.12 * limit);
  // From the Indication limit on the Permitted speed falls.
  if (seen.monitoring == Monitoring::TSM && seen.V_target && motion.speed() > seen.V_target->si)
    wanted -= comfortable(motion) * slowness_s(motion);
  if (seen.V_target && seen.d_target) {
    // For a stop the driver aims short of the place, and runs the last metres slowly.
    const double target = to_stop ? 0.0 : seen.V_target->si - std::min(margin(), 0.12 * seen.V_target->si);
    const double d = seen.d_target->si - (to_stop ? kStopShort : 0.0) - anticipation(motion);
    wanted = std::min(wanted, to_stop && d <= 0.0 ? 0.0 : braking_from(target, comfortable(motion), d));
  }
  return std::max(0.0, wanted);
}

/// As fast as the train can run; after an intervention before a stop it continues below the release speed.
double Driver::reckless_speed(const Seen& seen, const Motion& motion) {
  if (!seen.V_P) {
    creeping_ = false;
    return speed_of_line(motion);
  }
  const bool before_stop = seen.V_release && seen.V_target && seen.V_target->si == 0.0;
  // Braked to the release speed by the on-board, or at standstill.
  if (before_stop && (seen.eb || seen.sb || seen.tco) && motion.speed() <= seen.V_release->si) creeping_ = true;
  if (!before_stop) creeping_ = false;
  if (creeping_) return std::max(0.5, seen.V_release->si - 1.0 / kKmh);
  return 100.0;
}

Handle Driver::handle(const Seen& seen, const Motion& motion, double step_s) {
  Handle handle;
  if (must_stand(seen)) {
    last_wanted_.reset();
    wanted_.clear();
    handle.brake = 1.0;
    return handle;
  }
  const bool reckless = kind_ == DriverKind::reckless;
  const double wanted = reckless ? reckless_speed(seen, motion) : permitted(seen, motion);
  // A falling Permitted speed is followed with its own deceleration; a step is corrected.
  double following = 0.0;
  if (last_wanted_ && std::abs(wanted - *last_wanted_) < 1.5 * step_s)
    following = std::clamp((wanted - *last_wanted_) / step_s, -1.2, 0.0);
  last_wanted_ = wanted;
  const double gap = wanted - motion.speed();
  double a = std::clamp(0.5 * gap + (gap < 1.0 ? following : 0.0), -1.3, 0.7);
  if (reckless && !creeping_ && gap > 10.0) a = 10.0;
  if (wanted == 0.0 && motion.speed() < 1.0) a = std::min(a, -0.4);
  // No traction when approaching a target with a lower speed.
  const bool approaching = seen.monitoring == Monitoring::TSM && seen.V_target;
  if (!reckless && approaching && motion.speed() > seen.V_target->si && motion.speed() > std::max(8.0, 0.8 * wanted))
    a = std::min(a, 0.0);
  if (kind_ == DriverKind::late) {
    wanted_.push_back(a);
    const auto cycles = static_cast<std::size_t>(1.2 / step_s);
    if (wanted_.size() <= cycles) return handle;
    a = wanted_.front();
    wanted_.pop_front();
  }
  const double push = a - motion.coasting();
  if (push > 0.0)
    handle.traction = motion.full_traction() > 0.0 ? std::min(1.0, push / motion.full_traction()) : 0.0;
  else
    handle.brake = std::min(1.0, -push / motion.full_service_brake());
  return handle;
}

}  // namespace evc::sim
