#pragma once
#include "curves/explain_page.h"
#include "curves/result.h"

// The sections of `--explain` on values from train and national values: decelerations and build-up times.
namespace evc::curves {

/// A_brake_emergency, A_brake_safe and (with an SBD) A_brake_service at the speed and the places of `e`.
void explain_brakes(ExplainPage& page, const Approached& approached, const sdm::Explanation& e);
/// T_brake_emergency and T_brake_service with T_be and T_bs.
void explain_build_up_times(ExplainPage& page, const Approached& approached, const sdm::Explanation& e);
/// Gradient under the train, A_gradient, A_safe and A_expected at the places where the curves have
/// the speed.
void explain_decelerations(ExplainPage& page, const Approached& approached, const sdm::Explanation& e);

/// The arcs of a curve from its foot upstream to the one that has the speed `V`, each with its components.
void explain_arcs(ExplainPage& page, const Approached& approached, sdm::CurveKind kind, sdm::CurveView curve, Speed V);

}  // namespace evc::curves
