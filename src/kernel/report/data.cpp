#include "kernel/report/data.h"

#include "kernel/clock.h"
#include "kernel/here.h"
#include "modes/active_functions.h"

namespace evc::kernel {
namespace {

/// Of the train data those that the driver or another source may change (3.18.6.1).
ShownTrainData shown(const train::TrainData& train) {
  ShownTrainData data;
  data.L_TRAIN = train.L_TRAIN;
  data.V_MAXTRAIN = train.V_MAXTRAIN;
  if (train.brake_model == train::BrakeModel::lambda) data.brake_percentage = train.brake_percentage;
  data.cant_deficiency_mm = train.cant_deficiency_mm;
  data.other_categories = train.other_categories;
  data.axle_load = train.axle_load;
  data.loading_gauge = train.loading_gauge;
  data.airtight = train.airtight;
  return data;
}

/// The speed that is supervised in SR, and what is left of the distance (4.4.11.1.3).
ShownSR shown_SR(const State& s, const track::Here& here) {
  ShownSR SR;
  SR.status = s.mode == Mode::SR ? DataStatus::valid : DataStatus::unknown;
  SR.V = s.staff_responsible.V ? *s.staff_responsible.V : s.national_values.V_NVSTFF;
  if (s.staff_responsible.end) SR.D = *s.staff_responsible.end - here.est_front;
  return SR;
}

}  // namespace

void show_clock(const State& s, Outputs& out) {
  const std::optional<std::int64_t> utc = date(s);
  if (utc && modes::active(modes::Function::date_time, s.mode)) out.clock = {*utc, s.local_time_offset_min};
}

void show_data(const State& s, const track::Here& here, Outputs& out) {
  ShownData& data = out.data;
  data.driver_id_status = s.data.driver_id_status;
  data.driver_id = s.data.driver_id;
  data.train_running_number_status = s.data.train_running_number_status;
  data.train_running_number = s.data.train_running_number;
  data.level_status = s.data.level_status;
  if (s.radio.contact) {
    data.rbc_status = s.contact_status;
    data.rbc = {s.radio.contact->NID_C, s.radio.contact->NID_RBC, s.radio.contact->NID_RADIO};
  }
  data.train_status = s.data.train_data_status;
  data.train = shown(s.train);
  data.SR = shown_SR(s, here);
  data.slippery_rail = s.slippery_rail;
  data.network = s.network.NID_MN;
  if (!data.network && !s.network.offered.empty()) data.network = s.network.offered[0];
  for (const balise::Cover& cover : s.balise.covers)
    (void)out.covers.push_back(
        {cover.NID_C, cover.NID_VBCMK, cover.until - s.now, cover.T_VBC});  // as many as are stored
}

}  // namespace evc::kernel
