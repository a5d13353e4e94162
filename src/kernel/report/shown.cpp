#include "kernel/report/shown.h"

#include "driver/driver.h"
#include "kernel/here.h"

namespace evc::kernel {
namespace {

/// Speeds and distances (3.13.10).
void add_limits(const sdm::Result& limits, const Outputs& out, Set<DriverOutput>& given) {
  using enum DriverOutput;
  given.add(permitted_speed, out.V_P.has_value());
  given.add(sbi_speed, limits.show_SBI);
  given.add(target_speed, out.V_target.has_value());
  given.add(target_distance, out.d_target.has_value());
  given.add(release_speed, out.V_release.has_value());
  given.add(monitoring_status, out.status != Status::none);
  given.add(time_to_indication, out.TTI.has_value());
}

/// The planning area (3.15.10); the question for a free track hides it (015560 8.3).
void add_planning(const State& s, const Outputs& out, Set<DriverOutput>& given) {
  using enum DriverOutput;
  if (!out.EOA || s.track_ahead_free.asking) return;
  given.add(gradient);
  given.add(mrsp);
  given.add(eoa_loa);
  given.add(first_indication_location, out.d_indication.has_value());
}

/// The data view (3.18.6), which can be opened in each mode of the table.
void add_data(const ShownData& data, const Outputs& out, Set<DriverOutput>& given) {
  using enum DriverOutput;
  const auto known = [](DataStatus status) { return status != DataStatus::unknown; };
  given.add(DriverOutput::train_data, known(data.train_status));
  given.add(driver_id, known(data.driver_id_status));
  given.add(train_running_number, known(data.train_running_number_status));
  given.add(rbc_contact, known(data.rbc_status));
  given.add(vbc, !out.covers.empty());
  given.add(radio_network_id, data.network.has_value());
}

/// Texts of the trackside, and status texts by the rows that started them.
void add_texts(const State& s, const Outputs& out, Set<DriverOutput>& given) {
  using enum DriverOutput;
  for (const ShownText& text : out.texts) given.add(text.Q_TEXT ? fixed_text : plain_text);
  if (s.status_texts.shown.empty()) return;
  for (std::size_t i = 0; i < driver::srs_status_texts.size(); ++i)
    given.add(driver::srs_status_texts[i].output, s.status_texts.rows[i].on);
}

void add_symbols(const Outputs& out, Set<DriverOutput>& given) {
  using enum DriverOutput;
  for (const Symbol symbol : out.symbols)
    if (const auto output = driver::output_of(symbol)) given.add(*output);
  for (const ShownCondition& condition : out.track_conditions)
    given.add(condition.kind ? driver::output_of(*condition.kind) : track_cond_general);
}

}  // namespace

void show_by_mode(const State& s, bool desk_open, const Supervised& supervised, Outputs& out) {
  using enum DriverOutput;
  Set<DriverOutput> given{mode, train_speed, operated_version};
  given.add(level, out.level_valid);
  if (supervised.limits) add_limits(*supervised.limits, out, given);
  given.add(target_distance, out.rv_left.has_value());
  given.add(lssma, out.LSSMA.has_value());
  given.add(trip_reason, out.trip_reason.has_value());
  given.add(geo_position, out.geo.has_value());
  given.add(local_time, out.clock.has_value());
  add_planning(s, out, given);
  add_data(out.data, out, given);
  add_texts(s, out, given);
  add_symbols(out, given);
  given.add(DriverOutput::set_speed, s.set_speed.has_value());
  given.add(authorised_direction, s.manoeuvre.active);                                              // 4.4.21.1.9
  given.add(bmm_inhibition, s.srs == SrsVersion::v4_0_0 && s.antenna_alarm.inhibited.has_value());  // 5.22.4.1
  out.shown = driver::shown(given, s.mode, s.srs, desk_open, s.toggled_on);
  if (out.shown.has(DriverOutput::set_speed)) out.set_speed = s.set_speed;
}

}  // namespace evc::kernel
