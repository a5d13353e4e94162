#include "position/integrity.h"

namespace evc::position {
namespace {

/// The range of L_TRAININT, 32767 m, less half a step of D_LRBG, from which it counts (7.5.1.57).
constexpr Distance kLongestReported{32762.0};

/// 3.6.5.2.4: without a valid position against an LRBG, or without a length, nothing can be confirmed.
bool can_confirm(const State& state, const IntegrityFacts& facts) {
  const bool by_train_data = facts.train_data_valid && facts.length_acknowledged && !facts.validated_since;
  const bool by_consist =
      !facts.train_data_valid && facts.consist_known && !facts.consist_changed && facts.consist_acknowledged;
  return (by_train_data || by_consist) && !facts.turned && state.status == DataStatus::valid && lrbg(state) != nullptr;
}

void confirm(IntegrityStatus& status, Integrity by, const State& state, const IntegrityFacts& facts) {
  status = {by, rear(state, facts.L_TRAIN).min, facts.L_TRAIN};
}

/// A source that gives a longer train confirms another one (condition 3).
bool knows_this_train(const IntegrityFacts& facts) {
  return !facts.device_length || *facts.device_length <= facts.L_TRAIN;
}

bool confirmed_by_device(const State& state, const IntegrityFacts& facts) {  // 3
  return facts.device == TrainIntegrity::confirmed && knows_this_train(facts) && can_confirm(state, facts) &&
         motion(state) != Motion::backward;
}

/// Condition 4, the end of condition 1.
bool loss_counts(const IntegrityFacts& facts) {
  return facts.train_data_valid || facts.consist_known || facts.consist_captured;
}

/// Conditions 7, 8, 9, 10 of Table 2c. It has them for a confirmation by an external source, as that of the driver is
/// reported at once; while the connection is lost the train can run back meanwhile, or get longer.
bool outdated(const IntegrityStatus& status, const State& state, const IntegrityFacts& facts) {
  const bool length =
      facts.train_data_valid ? facts.length_acknowledged : facts.consist_known && !facts.consist_changed;
  return !length || facts.turned || facts.L_TRAIN != status.L_TRAIN || motion(state) == Motion::backward ||
         front(state).est - status.min_safe_rear > kLongestReported;
}

}  // namespace

IntegrityEvents supervise(IntegrityStatus& status, const State& state, const IntegrityFacts& facts) {
  if (facts.session_established) status = {};
  const Integrity before = status.integrity;
  const bool by_driver = facts.driver_confirms && can_confirm(state, facts);  // 2
  const bool by_device = confirmed_by_device(state, facts);
  const bool lost = facts.device == TrainIntegrity::lost && loss_counts(facts);  // 4
  switch (before) {
    case Integrity::none:
      if (by_driver)
        confirm(status, Integrity::by_driver, state, facts);
      else if (lost)
        status.integrity = Integrity::lost;
      else if (by_device)
        confirm(status, Integrity::by_device, state, facts);
      break;
    case Integrity::by_driver:  // until it is reported: at once, or when the connection is back
      if (by_driver)
        confirm(status, Integrity::by_driver, state, facts);
      else if (outdated(status, state, facts))
        status = {};
      break;
    case Integrity::by_device:
      if (lost)
        status.integrity = Integrity::lost;
      else if (by_driver)
        confirm(status, Integrity::by_driver, state, facts);
      else if (by_device)
        confirm(status, Integrity::by_device, state, facts);
      else if (outdated(status, state, facts))
        status = {};
      break;
    case Integrity::lost:
      if (by_driver)
        confirm(status, Integrity::by_driver, state, facts);
      else if (by_device)
        confirm(status, Integrity::by_device, state, facts);
      else if (!loss_counts(facts) || facts.device == TrainIntegrity::unknown)  // 1, 6
        status = {};
      break;
  }
  IntegrityEvents events;
  events.confirmed_by_driver = by_driver && status.integrity == Integrity::by_driver;
  events.lost = status.integrity == Integrity::lost && before != Integrity::lost;
  return events;
}

void note_reported(IntegrityStatus& status) {
  if (status.integrity == Integrity::by_driver || status.integrity == Integrity::by_device) status = {};
}

}  // namespace evc::position
