#include "kernel/train_data.h"

#include "kernel/here.h"
#include "kernel/stored.h"
#include "track/withdraw.h"

namespace evc::kernel {
namespace {

/// 3.18.3.7 b: what RBCs sent with an authority for the level or the RBC ahead is deleted; restrictions, orders and
/// texts of the same messages stay.
void forget_buffered_authorities(State& s) {
  for (BufferedSet& set : s.buffer)
    if (set.medium == Medium::rbc) set.waiting &= ~set.of_authority;
  s.buffer.erase_if([](const BufferedSet& set) { return set.waiting == 0 && !set.message_waits; });
}

/// 3.18.3.7: the authority was received for other train data.
void forget_authority_of_old_train(State& s, const track::Here& here, Log log) {
  if (shorten(s, track::Situation::j_train_data_changed, here.max_safe_front, here))
    log.note({.what = What::track_description_shortened, .clause = "3.18.3.7"_srs});
  forget_buffered_authorities(s);
}

}  // namespace

bool acceptable(const train::TrainData& data, Log log) {
  const train::Fault fault = train::check(data);
  if (fault == train::Fault::none) return true;
  log.note({.what = What::train_data_refused, .id = static_cast<std::int32_t>(fault), .clause = train::clause(fault)});
  return false;
}

bool sends_train_data(const State& s) {
  return valid(s.data.train_data_status) && s.mode != Mode::SL && s.mode != Mode::NL;
}

bool route_matters(const train::TrainData& before, const train::TrainData& after) {
  return before.cant_deficiency_mm != after.cant_deficiency_mm || before.other_categories != after.other_categories ||
         before.axle_load != after.axle_load || before.loading_gauge != after.loading_gauge ||
         !(before.traction_systems == after.traction_systems);
}

void change_train_data(State& s, const train::TrainData& data, const track::Here& here, Log log) {
  if (here.standstill && valid(s.data.train_data_status) && route_matters(s.train, data))
    forget_authority_of_old_train(s, here, log);
  // 3.18.3.8: the track under what was joined to the rear end.
  if (valid(s.data.train_data_status) && data.L_TRAIN > s.train.L_TRAIN) {
    s.track.ssp.begin_at(here.min_safe_rear);
    s.track.gradient.begin_at(here.min_safe_rear);
  }
  s.train = data;
  s.data.train_data_status = DataStatus::valid;
  ++s.revision;
  radio::note_validated_train_data(s.radio);
  log.note({.what = What::train_data_valid, .clause = "3.18.3"_srs});
}

}  // namespace evc::kernel
