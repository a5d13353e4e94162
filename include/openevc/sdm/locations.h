#pragma once
#include <optional>

#include "openevc/sdm/inputs.h"
#include "openevc/sdm/limits.h"
#include "openevc/sdm/supervision.h"

// Locations and speeds that other functions need from speed and distance monitoring.
namespace evc::sdm {

/// Where the supervision of an unprotected level crossing changes from its start as EOA and SvL to the LX speed, when
/// no stop is required (3.13.9.3.5.11-12, 5.16.2-3). `passed`: the front end that decides has passed this place, and
/// the LX speed is in the MRSP.
struct LxSubstitution {
  Place d_P{};
  bool from_SBD = false;  // decided by SBI1: against the estimated front end
  bool passed = false;
  Limits EBD{}, SBD{};
};
/// `LX_start`: the temporary EOA and SvL. Curves are traced in `scratch`, which is not `derived`, and not valid
/// afterwards.
LxSubstitution lx_substitution(const Inputs& in, const Derived& derived, Place LX_start, Speed V_LX,
                               const Motion& motion, Derived& scratch);

/// Virtual limits of a stop with the full service brake at `foot`: the SBI of a non stopping area (5.18.4.2), and the
/// Permitted speed, without guidance, of a tunnel stopping area (5.18.8.3). Against the front ends that those clauses
/// name. `V`: the estimated speed. The curve is traced in `scratch`, which is not `derived`, and not valid afterwards.
struct ServiceBrakeStop {
  Place d_SBI{}, d_P{};
};
ServiceBrakeStop service_brake_stop(const Inputs& in, const Derived& derived, Place foot, Speed V, Derived& scratch);

/// Speed restriction of a permitted braking distance (3.11.11): rounded down to 5 km/h; 0 where no
/// speed fulfils the condition. `permitted`: the distance; `grad`: the gradient received with it. Curves are traced in
/// `scratch`, which is not valid afterwards.
Speed permitted_braking_distance_speed(const Inputs& in, Distance permitted, double grad, bool emergency_brake,
                                       Derived& scratch);

}  // namespace evc::sdm
