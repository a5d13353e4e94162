#include "kernel/driver_inputs.h"

#include "kernel/here.h"

namespace evc::kernel {

driver::ActionContext action_context(const State& s, const Inputs& in, const track::Here& here) {
  const TrainSignals& train = in.train;
  driver::ActionContext c;
  c.srs = s.srs;
  c.mode = s.mode;
  if (valid(s.data.level_status)) c.level = s.level.level;
  c.desk_open = train.desk_open;
  c.standstill = here.standstill;
  c.driver_id_valid = valid(s.data.driver_id_status);
  c.train_data_valid = valid(s.data.train_data_status);
  c.train_running_number_valid = valid(s.data.train_running_number_status);
  c.session_open = s.radio.supervising.session.established();
  c.train_data_acknowledged = s.radio.supervising.knows_train_data();
  c.non_leading_signal = train.non_leading;
  c.passive_shunting_signal = train.passive_shunting;
  c.slow_enough_for_override = run_of(s.position.now).V <= s.national_values.V_NVALLOWOVTRP;
  c.driver_may_change_adhesion = s.national_values.Q_NVDRIVER_ADHES;
  c.driver_id_while_running = s.national_values.M_NVDERUN;
  c.network_offered = !s.network.offered.empty();
  c.track_ahead_free_asked = s.track_ahead_free.asking;
  // With the selector in position "On" only (4.4.16.1.2).
  c.automatic_driving_asked =
      s.srs == SrsVersion::v4_0_0 && in.automatic_operation.requests_AD && in.automatic_operation.active;
  c.alarm_may_be_inhibited = s.srs == SrsVersion::v4_0_0 && c.level && level_1_2_3(*c.level);
  c.alarm_inhibited = s.antenna_alarm.inhibited.has_value();
  c.offers = s.offers;
  // What start of mission asks for is offered too (S1, S2, S3, S12, S13).
  const auto asked = [&](Offer offer, Entry entry) { c.offers.add(offer, s.entries.has(entry)); };
  asked(Offer::driver_id, Entry::driver_id);
  asked(Offer::level, Entry::level);
  asked(Offer::rbc_contact, Entry::rbc_contact);
  asked(Offer::train_data, Entry::train_data);
  asked(Offer::train_running_number, Entry::train_running_number);
  c.requests = s.requested;
  return c;
}

modes::AvailableLevels available_levels(const State& state, const NationalSystem& national_system) {
  modes::AvailableLevels available;
  available.fitted = state.fitted_levels;
  available.national_systems[0] = national_system.available;
  return available;
}

}  // namespace evc::kernel
