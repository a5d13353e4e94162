#include "display_facts.h"

#include <algorithm>

#include "driver/driver.h"
#include "kernel/here.h"
#include "kernel/manoeuvre.h"
#include "kernel/report/handover.h"
#include "kernel/state.h"
#include "kernel/train_category.h"
#include "track/services.h"

namespace evc::scenario {
namespace {

using enum DriverOutput;

/// Speeds and distances that are supervised (3.13.10); in the store: the authority and what describes its track.
void add_supervision(const kernel::State& s, const kernel::Outputs& o, Set<DriverOutput>& held) {
  held.add(permitted_speed, o.V_P.has_value());
  held.add(sbi_speed, o.V_SBI.has_value() && o.status >= Status::Overspeed);
  held.add(target_speed, o.V_target.has_value());
  held.add(target_distance, o.d_target.has_value() || o.rv_left.has_value());
  held.add(release_speed, o.V_release.has_value());
  held.add(monitoring_status, o.status != Status::none);
  held.add(time_to_indication, o.TTI.has_value());
  held.add(first_indication_location, o.d_indication.has_value());
  for (const DriverOutput planned : {gradient, mrsp, eoa_loa}) held.add(planned, s.track.ma.has_value());
  held.add(lssma, o.LSSMA.has_value());
  held.add(authorised_direction, s.manoeuvre.active);
}

void add_data(const kernel::State& s, const kernel::Outputs& o, Set<DriverOutput>& held) {
  const auto known = [](DataStatus status) { return status != DataStatus::unknown; };
  held.add(DriverOutput::level, kernel::valid(s.data.level_status));
  held.add(train_data, known(s.data.train_data_status));
  held.add(driver_id, known(s.data.driver_id_status));
  held.add(train_running_number, known(s.data.train_running_number_status));
  held.add(rbc_contact, s.radio.contact && known(s.contact_status));
  held.add(vbc, !s.balise.covers.empty());
  held.add(radio_network_id, o.data.network.has_value());
  held.add(DriverOutput::set_speed, s.set_speed.has_value());
  held.add(local_time, s.clock.has_value());
}

/// What trackside gave.
void add_track(const kernel::State& s, const track::Here& here, Set<DriverOutput>& held) {
  for (const track::Text& text : s.track.texts)
    if (text.state == track::Text::State::shown) held.add(text.Q_TEXT ? fixed_text : plain_text);
  for (const track::TrackCondition& c : s.track.conditions)
    if (driver::symbol(c.kind, c.progress.phase, s.by_train)) held.add(driver::output_of(c.kind));
  if (const auto& t = s.track.traction)
    held.add(track_cond_general, driver::symbol_of_traction(t->M_VOLTAGE, t->progress.phase, s.by_train).has_value());
  const auto& area = s.track.reversing_area;
  held.add(reversing_allowed, area && s.track.reversing_supervision && here.standstill &&
                                  here.est_front >= area->from && here.est_front <= area->to);
  held.add(geo_position, track::geographical_position(s.track, here).has_value());
  held.add(lx_not_protected, std::any_of(s.track.lx.begin(), s.track.lx.end(), [&](const track::LevelCrossing& lx) {
             return lx.informed && here.min_safe_front < lx.to;
           }));
  held.add(level_announcement, s.level_transition.pending && !s.level_transition.pending->to.same_level(s.level));
  held.add(taf_request, s.track_ahead_free.asking);
  held.add(DriverOutput::slippery_rail,
           s.slippery_rail || track::slippery(s.track, here.est_front, kernel::supervised_train(s).L_TRAIN));
}

/// Whether the reason of a status text holds that lasts as long as it (015560 15).
bool reason_holds(const kernel::State& s, const kernel::Outputs& o, const track::Here& here,
                  const driver::StatusRow& row) {
  if (!row.brakes.empty()) return !(o.brake_reasons & row.brakes).empty();
  if (row.unsuitable) return track::unsuitability(s.track, kernel::interfaces_of(s.train)).has(*row.unsuitable);
  if (row.entering) return s.track.ma.has_value() && !track::described_under_train(s.track, here);
  if (row.inform == Inform::odometer_impaired) return s.odometer_accuracy.impaired;
  if (row.inform == Inform::national_system_not_available)
    return s.level.level == Level::NTC &&
           (s.level.nid_ntc > 63 || ((s.displayed.national_systems >> s.level.nid_ntc) & 1u) == 0);
  return false;
}

}  // namespace

Set<DriverOutput> held(const kernel::State& s, const kernel::Outputs& o) {
  const track::Here here = kernel::here(s);
  Set<DriverOutput> held{DriverOutput::mode, train_speed, operated_version};
  add_supervision(s, o, held);
  add_data(s, o, held);
  add_track(s, here, held);
  held.add(DriverOutput::trip_reason, s.status_texts.trip_reason.has_value());
  held.add(brake_indication, o.sb || o.eb);
  held.add(override_status, s.override_.active);
  held.add(bmm_inhibition, s.antenna_alarm.inhibited.has_value());
  held.add(radio_link_status, kernel::indicated_session(s).indication != RadioIndication::none);
  for (std::size_t i = 0; i < driver::srs_status_texts.size(); ++i) {
    const driver::StatusRow& row = driver::srs_status_texts[i];
    held.add(row.output, s.status_texts.rows[i].on || reason_holds(s, o, here, row));
  }
  return held;
}

}  // namespace evc::scenario
