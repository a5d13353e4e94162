#include "protection/emergency_stops.h"

#include <array>

#include "track/withdraw.h"

namespace evc::protection {
namespace {

/// A stop with a known identity replaces the old one (3.10.1.3.1). There is room for all sixteen identities.
void keep(EmergencyStops& stops, const EmergencyStop& stop) {
  stops.pending.erase_if([&](const EmergencyStop& old) { return old.NID_EM == stop.NID_EM; });
  if (!stops.pending.push_back(stop)) stops.pending.back() = stop;
}

}  // namespace

bool EmergencyStops::unconditional_pending() const {
  for (const EmergencyStop& stop : pending)
    if (!stop.conditional) return true;
  return false;
}

Answer accept_conditional(EmergencyStops& stops, track::Description& d, std::uint8_t NID_EM, Place stop,
                          Place min_front_at_reception, const track::Here& here) {
  // The train has already passed the place: refused, and nothing changes (3.10.2.2).
  if (min_front_at_reception > stop) return {false, 3, "3.10.2.2"_srs};
  keep(stops, {NID_EM, true, stop});
  return {true, track::stop_at(d, stop, here), {}};
}

Answer accept_unconditional(EmergencyStops& stops, std::uint8_t NID_EM) {
  keep(stops, {NID_EM, false, {}});
  return {true, 2, {}};
}

bool revoke(EmergencyStops& stops, std::uint8_t NID_EM) {
  const std::size_t before = stops.pending.size();
  stops.pending.erase_if([&](const EmergencyStop& stop) { return stop.NID_EM == NID_EM; });
  return stops.pending.size() != before;
}

std::uint8_t Q_EMERGENCYSTOP_for_version_1(std::uint8_t Q_EMERGENCYSTOP) {
  constexpr std::array<std::uint8_t, 4> kValue{0, 0, 2, 1};
  return kValue[Q_EMERGENCYSTOP & 3u];
}

}  // namespace evc::protection
