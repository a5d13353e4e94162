#include "position/odometer_accuracy.h"

namespace evc::position {
namespace {

constexpr Distance kInterval{100.0};
constexpr Distance kTotal{5000.0};
constexpr Distance kImpairmentThreshold{250.0};
constexpr Distance kSafetyThreshold{1500.0};
/// Accuracy of distances measured on-board (SUBSET-041 5.3.1.1).
constexpr Distance accuracy_over(Distance travelled) { return Distance{5.0 + 0.05 * travelled.si}; }

bool any_above(const OdometerAccuracy::Errors& errors, Distance limit) {
  return errors.under > limit || errors.over > limit;
}

/// 3.6.8.6: impaired until the total distance was travelled with less than the accuracy that is required.
void recover(OdometerAccuracy& a) {
  a.recovering.under += a.open.under;
  a.recovering.over += a.open.over;
  a.recovered += a.travelled;
  if (any_above(a.recovering, accuracy_over(a.recovered))) {
    a.recovering = {};
    a.recovered = {};
  }
  a.impaired = a.recovered < kTotal;
}

Distance amount(Distance d) { return d < Distance{} ? Distance{} - d : d; }
Distance not_negative(Distance d) { return d < Distance{} ? Distance{} : d; }

void check(OdometerAccuracy& a) {
  OdometerAccuracy::Errors sum;
  for (const OdometerAccuracy::Errors& interval : a.intervals) {
    sum.under += interval.under;
    sum.over += interval.over;
  }
  if (a.impaired) recover(a);
  if (any_above(sum, kImpairmentThreshold)) {
    a.impaired = true;
    a.recovering = {};
    a.recovered = {};
  }
  a.beyond_safety_threshold = any_above(sum, kSafetyThreshold);
}

}  // namespace

void accumulate(OdometerAccuracy& a, const Counters& now) {
  const Counters before = a.last;
  a.last = now;
  if (!a.begun) {
    a.begun = true;
    return;
  }
  const Distance moved = now.nominal - before.nominal;
  const Distance above = not_negative((now.max - before.max) - moved);
  const Distance below = not_negative(moved - (now.min - before.min));
  const bool forward = !(moved < Distance{});
  a.open.under += forward ? above : below;
  a.open.over += forward ? below : above;
  a.travelled += amount(moved);
  if (a.travelled < kInterval) return;
  a.intervals[a.next] = a.open;
  a.next = static_cast<std::uint8_t>((a.next + 1u) % OdometerAccuracy::kIntervals);
  check(a);
  a.open = {};
  a.travelled = {};
}

}  // namespace evc::position
