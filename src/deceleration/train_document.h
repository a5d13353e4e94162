#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "deceleration/bands.h"
#include "deceleration/spec.h"

namespace evc::deceleration {

/// Whether a train file can be made of the `train` of a spec: its keys are those of `etcs-train/1`, without those that
/// are computed. False without a `train`; an error with its place in the spec where it cannot be.
io::Result<bool> check_train(const Spec& spec);

/// The steps for a train file: at most 7, with those of `Kwet_rst` (3.13.2.2.9.2) where the spec has a `train`.
std::vector<Step> train_steps(const Spec& spec, std::span<const Step> steps);

/// The train file: `train` of the spec, with A_brake_emergency and Kdry_rst in these `train_steps`, and
/// T_brake_emergency_s where response times are given. An error where the computed values are not those of a train,
/// such as a build-up time beyond 120 s.
io::Result<std::string> train_document(const Spec& spec, std::span<const Step> steps, std::optional<double> build_up_s);

}  // namespace evc::deceleration
