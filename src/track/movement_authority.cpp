#include "track/movement_authority.h"

namespace evc::track {

Place MovementAuthority::SvL_without_LOA() const {
  if (fixed_SvL) return *fixed_SvL;
  if (overlap) return overlap->end;
  if (danger_point) return danger_point->at;
  return end();
}

std::optional<Place> MovementAuthority::SvL() const {
  if (limited() && !fixed_SvL) return std::nullopt;
  return SvL_without_LOA();
}

Place MovementAuthority::far_end() const {
  const std::optional<Place> supervised = SvL();
  return supervised ? *supervised : end();
}

Release MovementAuthority::release() const {
  if (fixed_release) return *fixed_release;
  if (limited()) return {};
  if (overlap) return overlap->release;
  if (danger_point) return danger_point->release;
  return {};
}

}  // namespace evc::track
