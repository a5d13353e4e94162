#include "kernel/train_category.h"

namespace evc::kernel {
namespace {

/// NC_CDTRAIN (7.5.1.82.1): the cant deficiencies in mm by code.
constexpr std::array<std::uint16_t, 11> kCantDeficiency{80, 100, 130, 150, 165, 180, 210, 225, 245, 275, 300};

}  // namespace

track::TrainCategory category_of(const train::TrainData& train) {
  track::TrainCategory c;
  for (std::size_t i = 0; i < kCantDeficiency.size(); ++i)
    if (kCantDeficiency[i] <= train.cant_deficiency_mm) c.NC_CDTRAIN = static_cast<std::uint8_t>(i);
  c.NC_TRAIN = train.other_categories;
  c.M_AXLELOADCAT = static_cast<std::uint8_t>(train.axle_load);
  return c;
}

track::TrainInterfaces interfaces_of(const train::TrainData& train) {
  track::TrainInterfaces i;
  i.M_LOADINGGAUGE = static_cast<std::uint8_t>(train.loading_gauge);
  i.M_AXLELOADCAT = static_cast<std::uint8_t>(train.axle_load);
  for (const train::TractionSystem& t : train.traction_systems)
    (void)i.tractions.push_back({t.M_VOLTAGE, t.NID_CTRACTION});  // both hold eight
  return i;
}

radio::RouteData route_data(const train::TrainData& train) {
  const track::TrainCategory category = category_of(train);
  radio::RouteData r;
  r.NC_CDTRAIN = category.NC_CDTRAIN;
  r.NC_TRAIN = category.NC_TRAIN;
  r.M_AXLELOADCAT = category.M_AXLELOADCAT;
  r.M_LOADINGGAUGE = static_cast<std::uint8_t>(train.loading_gauge);
  for (const train::TractionSystem& t : train.traction_systems)
    (void)r.tractions.push_back({t.M_VOLTAGE, t.NID_CTRACTION});  // both hold eight
  return r;
}

}  // namespace evc::kernel
