#include "position/parts.h"
#include "position/position.h"

// The position over the time without power (4.10, 4.11).
namespace evc::position {

std::optional<Kept> kept(const State& state, Distance L_engine) {
  if (state.references.empty() || state.status == DataStatus::unknown) return std::nullopt;
  State of_cab_A = state;
  if (state.sense < 0) change_cab(of_cab_A, L_engine);
  const PlaceInterval at = front(of_cab_A);
  Kept out;
  out.lrbg = of_cab_A.references.back();
  out.ahead = at.est - out.lrbg.place;
  // Not less by rounding than what the interval begins with.
  const auto at_least = [&](Distance d) { return d > out.lrbg.Q_LOCACC ? d : out.lrbg.Q_LOCACC; };
  out.doubts = {at_least(at.est - at.min), at_least(at.max - at.est)};
  return out;
}

void restore(State& state, const Kept& position) {
  Reference lrbg = position.lrbg;
  lrbg.place = Place{};
  // The increments of the counters since the group was passed, which give the same interval again.
  const Distance least = position.ahead - (position.doubts.over - lrbg.Q_LOCACC);
  const Distance most = position.ahead + (position.doubts.under - lrbg.Q_LOCACC);
  lrbg.counter = {OdometerPlace{-position.ahead}, OdometerPlace{-least}, OdometerPlace{-most}};
  lrbg.reported = false;
  state.references.clear();
  (void)state.references.push_back(lrbg);
  state.offset = position.ahead;
  state.status = DataStatus::invalid;
}

void count_from(State& state, const OdometerReading& first) {
  if (state.references.empty()) return;
  for (Reference& reference : state.references) {
    OdometerReading& counter = reference.counter;
    counter.nominal = first.nominal + (counter.nominal - OdometerPlace{});
    counter.min = first.min + (counter.min - OdometerPlace{});
    counter.max = first.max + (counter.max - OdometerPlace{});
  }
  state.offset -= state.sense * (first.nominal - OdometerPlace{});
}

}  // namespace evc::position
