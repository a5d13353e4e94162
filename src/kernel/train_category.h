#pragma once
#include "radio/radio.h"
#include "track/conditions.h"
#include "track/speed_restrictions.h"
#include "train/train_data.h"

namespace evc::kernel {

/// The train as the choice of speeds and the validated train data need it (3.18.3.2, 7.5.1.82).
track::TrainCategory category_of(const train::TrainData& train);
/// The train as route suitability needs it (3.12.2).
track::TrainInterfaces interfaces_of(const train::TrainData& train);
/// What the routes of an RBC depend on (4.8.3 [3] of 4.0.0).
radio::RouteData route_data(const train::TrainData& train);

}  // namespace evc::kernel
