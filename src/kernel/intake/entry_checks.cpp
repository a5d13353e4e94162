#include "kernel/intake/entry_checks.h"

#include <cstdint>

namespace evc::kernel {
namespace {

/// Whether `steps`, a value over its resolution, is a whole number from 0 to `most`. The value is a decimal number that
/// was converted to SI: it is one to 1e-6.
bool is_whole(double steps, double most) {
  if (!(steps > -1e-6 && steps < most + 1e-6)) return false;  // false for NaN
  const double off = steps - static_cast<double>(static_cast<std::int64_t>(steps + 0.5));
  return off < 1e-6 && off > -1e-6;
}

constexpr double kLeastSpeed = 5.0 / 3.6;         ///< 5 km/h
constexpr double kSpeeds = 120.0;                 ///< 600 km/h in steps of 5 km/h
constexpr double kLongestSRDistance = 100'000.0;  ///< m
constexpr double kLongestTrain = 4095.0;          ///< m
constexpr double kHighestPercentage = 250.0;

}  // namespace

bool is_SR_entry(const std::optional<Speed>& V, const std::optional<Distance>& D) {
  return (!V || is_whole(V->si / kLeastSpeed, kSpeeds)) && (!D || is_whole(D->si, kLongestSRDistance));
}

bool is_rbc(const DriverActions::RbcContact& contact) {
  constexpr std::uint32_t kLast = 16777214, kCountries = 1024, kRbcs = 16384;
  if (contact.NID_C >= kCountries || contact.NID_RBC >= kRbcs) return false;
  return contact.NID_C * kRbcs + contact.NID_RBC <= kLast;
}

train::Fault off_resolution(const train::TrainData& entered, const train::TrainData& before) {
  if (entered.L_TRAIN != before.L_TRAIN && !is_whole(entered.L_TRAIN.si, kLongestTrain))
    return train::Fault::train_length;
  if (entered.V_MAXTRAIN != before.V_MAXTRAIN && !is_whole(entered.V_MAXTRAIN.si / kLeastSpeed, kSpeeds))
    return train::Fault::maximum_speed;
  if (entered.brake_model == train::BrakeModel::lambda && entered.brake_percentage != before.brake_percentage &&
      !is_whole(entered.brake_percentage, kHighestPercentage))
    return train::Fault::brake_percentage;
  return train::Fault::none;
}

}  // namespace evc::kernel
