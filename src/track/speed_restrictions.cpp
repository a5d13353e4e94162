#include "track/speed_restrictions.h"

namespace evc::track {

SpeedCode StaticSpeed::speed_for(const TrainCategory& train) const {
  // The basic speed comes before the cant deficiency classes; a missing class has the speed of the next lower one.
  SpeedCode base = V_STATIC;
  for (std::size_t k = 0; k <= train.NC_CDTRAIN && k < cd.size(); ++k)
    if (cd[k] != kNoSpeed) base = cd[k];
  SpeedCode lowest = kNoSpeed;
  bool replaced = false;
  for (std::size_t k = 0; k < other.size(); ++k) {
    if (other[k] == kNoSpeed || ((train.NC_TRAIN >> k) & 1u) == 0) continue;
    if (other[k] < lowest) lowest = other[k];
    replaced = replaced || ((replaces_cd >> k) & 1u) != 0 || train.NC_CDTRAIN < replaces_below;
  }
  if (!replaced && base < lowest) lowest = base;
  return lowest;
}

SpeedCode AxleLoadRestriction::speed_for(const TrainCategory& train) const {
  SpeedCode lowest = kNoSpeed;
  const std::size_t first = train.own_axle_load_only ? train.M_AXLELOADCAT : 0;
  for (std::size_t k = first; k <= train.M_AXLELOADCAT && k < V_AXLELOAD.size(); ++k)
    if (V_AXLELOAD[k] < lowest) lowest = V_AXLELOAD[k];
  return lowest;
}

void cover(TemporarySpeedRestriction& kept, const TemporarySpeedRestriction& more) {
  kept.NID_TSR = 255;
  kept.Q_FRONT = kept.Q_FRONT && more.Q_FRONT;
  if (more.V_TSR < kept.V_TSR) kept.V_TSR = more.V_TSR;
  if (more.from < kept.from) kept.from = more.from;
  if (more.to > kept.to) kept.to = more.to;
}

}  // namespace evc::track
