#include "explain/brought.h"

#include <cmath>

namespace evc::explain {
namespace {

/// What hangs on an unlinked group moves with it, by the inaccuracy of a location at most.
constexpr double kMoved = 100.0;

template <class T>
bool at_one_place(const T& a, const T& b, Place of_a, Place of_b) {
  return of_a == of_b || (a.anchor != b.anchor && std::abs((of_a - of_b).si) < kMoved);
}

}  // namespace

bool alike(const track::StaticSpeedProfile::Step& a, const track::StaticSpeedProfile::Step& b) {
  return a.value == b.value && at_one_place(a, b, a.from, b.from);
}
bool alike(const track::AxleLoadRestriction& a, const track::AxleLoadRestriction& b) {
  return a.V_AXLELOAD == b.V_AXLELOAD && at_one_place(a, b, a.from, b.from);
}
bool alike(const track::TemporarySpeedRestriction& a, const track::TemporarySpeedRestriction& b) {
  return a.NID_TSR == b.NID_TSR && a.V_TSR == b.V_TSR && at_one_place(a, b, a.from, b.from);
}
bool alike(const track::PermittedBrakingDistance& a, const track::PermittedBrakingDistance& b) {
  return a.D_PBD == b.D_PBD && a.service_brake == b.service_brake && at_one_place(a, b, a.from, b.from);
}
bool alike(const track::LevelCrossing& a, const track::LevelCrossing& b) {
  return a.NID_LX == b.NID_LX && a.unprotected == b.unprotected && a.V_LX == b.V_LX &&
         at_one_place(a, b, a.from, b.from);
}
bool alike(const track::ModeArea& a, const track::ModeArea& b) {
  return a.mode == b.mode && a.V_MAMODE == b.V_MAMODE && at_one_place(a, b, a.from, b.from);
}
bool alike(const track::RouteSuitability& a, const track::RouteSuitability& b) {
  return a.kind == b.kind && a.M_LINEGAUGE == b.M_LINEGAUGE && a.M_LINEAXLELOADCAT == b.M_LINEAXLELOADCAT &&
         a.M_VOLTAGE == b.M_VOLTAGE && a.NID_CTRACTION == b.NID_CTRACTION && at_one_place(a, b, a.at, b.at);
}
bool alike(const track::AdhesionArea& a, const track::AdhesionArea& b) {
  return a.slippery == b.slippery && at_one_place(a, b, a.from, b.from);
}
bool alike(const track::TrackCondition& a, const track::TrackCondition& b) {
  return a.kind == b.kind && at_one_place(a, b, a.from, b.from);
}

}  // namespace evc::explain
