#pragma once
#include "openevc/base/units.h"

namespace evc {

/// The distance from the front end of the engine, on the side of the active cab, to one end of the shunting consist:
/// min <= nominal <= max.
struct ConsistEnd {
  Distance nominal{}, min{}, max{};
  friend constexpr bool operator==(const ConsistEnd&, const ConsistEnd&) = default;
};

/// Whether a source that works gives such lengths: in order, and with room for them in packet 10 (12 bits, m). No
/// number is none of them.
constexpr bool is_possible(const ConsistEnd& end) {
  constexpr Distance kGreatest{4095.0};
  return end.min >= Distance{} && end.min <= end.nominal && end.nominal <= end.max && end.max <= kGreatest;
}

/// Safe consist length of 4.0.0 (3.18.3.2 b): what is in front of the engine, and what is in rear of its front end, the
/// engine included.
struct ConsistLength {
  ConsistEnd front, rear;
  friend constexpr bool operator==(const ConsistLength&, const ConsistLength&) = default;
};

}  // namespace evc
