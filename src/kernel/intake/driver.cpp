#include "kernel/intake/driver.h"

#include "driver/driver.h"
#include "kernel/driver_inputs.h"
#include "kernel/here.h"
#include "kernel/intake/entry_checks.h"
#include "kernel/stored.h"
#include "kernel/train_data.h"

namespace evc::kernel {
namespace {

/// About a selection, entry or acknowledgement of the driver.
template <class Act>
Event event_of(What what, Act act, Clause clause) {
  return {.what = what, .id = static_cast<std::int32_t>(act), .clause = clause};
}

/// The level that is entered in this cycle.
modes::OrderedLevel entered_level(const Reception& r) {
  modes::OrderedLevel level;
  level.level = *r.in.driver.level;
  if (level.level == Level::NTC) level.nid_ntc = r.in.driver.nid_ntc;
  return level;
}

/// 5.10.1.7
bool may_select(const Reception& r, const modes::OrderedLevel& level) {
  const State& s = r.state;
  const modes::LevelTable* table = s.level_table ? &*s.level_table : nullptr;
  return modes::driver_may_select(level, table, available_levels(s, r.in.national_system));
}

/// 5.4.3.2 D2: start of mission asks for the level.
bool asks_for_level(const State& s) { return !valid(s.position.status) || !valid(s.data.level_status); }

/// Whether the driver may do it now; an action that is not enabled has no effect and is logged.
bool may(Reception& r, driver::Input input, const Event& otherwise) {
  driver::ActionContext context = action_context(r.state, r.in, r.out.here);
  // With the driver's identity the level that is asked for behind it (5.4.3.2 D2), and with the level the contact for
  // it (3.18.4.3.2).
  context.offers.add(Offer::level, r.out.entered.has(Entered::driver_id) && asks_for_level(r.state));
  if (input == driver::Input::rbc_contact && r.in.driver.level && may_select(r, entered_level(r)) &&
      driver::enabled(context).has(driver::Input::level)) {
    context.level = r.in.driver.level;
    context.offers.add(Offer::rbc_contact);
  }
  if (driver::enabled(context).has(input)) return true;
  r.log.note(otherwise);
  return false;
}

/// The enabled selections; the others are ignored.
Set<Select> enabled_selections(Reception& r) {
  struct Row {
    Select select;
    driver::Input input;
  };
  constexpr std::array<Row, 22> rows{{
      {Select::start, driver::Input::start},
      {Select::override_, driver::Input::override_},
      {Select::shunting, driver::Input::shunting},
      {Select::exit_shunting, driver::Input::exit_shunting},
      {Select::non_leading, driver::Input::non_leading},
      {Select::maintain_shunting, driver::Input::continue_shunting},
      {Select::slippery_rail, driver::Input::adhesion},
      {Select::adhesion_normal, driver::Input::adhesion},
      {Select::track_ahead_free, driver::Input::track_ahead_free},
      {Select::integrity_confirmed, driver::Input::integrity_confirmation},
      {Select::last_rbc, driver::Input::rbc_contact},
      {Select::short_number, driver::Input::rbc_contact},
      {Select::radio_network, driver::Input::radio_network_id},
      {Select::vbc_set, driver::Input::vbc},
      {Select::vbc_remove, driver::Input::vbc},
      {Select::ato_engage, driver::Input::ato_engage},
      {Select::ato_disengage, driver::Input::ato_disengage},
      {Select::sm, driver::Input::sm},
      {Select::continue_sm, driver::Input::sm},
      {Select::exit_sm, driver::Input::exit_sm},
      {Select::bmm_inhibit, driver::Input::bmm_inhibit},
      {Select::bmm_revoke, driver::Input::bmm_revoke},
  }};
  Set<Select> selected = Set<Select>::of_bits(r.in.driver.selected);
  for (const Row& row : rows)
    if (selected.has(row.select) && !may(r, row.input, event_of(What::selection_not_enabled, row.select, "4.7.2"_srs)))
      selected.remove(row.select);
  if (selected.has(Select::toggle) && !(r.in.train.desk_open && driver::can_be_toggled(r.state.mode))) {
    r.log.note(event_of(What::selection_not_enabled, Select::toggle, "4.7.2"_srs));
    selected.remove(Select::toggle);
  }
  return selected;
}

/// Those that were asked for when the driver gave them, none with a closed desk (4.4.7.1.4, 4.4.13.1.6). Train data are
/// an entry, which is judged as one.
Set<Ack> acknowledgements(Reception& r) {
  Set<Ack> given = Set<Ack>::of_bits(r.in.driver.acknowledged);
  const bool train_data = given.has(Ack::train_data) && r.in.train.desk_open;
  given.remove(Ack::train_data);
  for (std::size_t n = 0; n < terms::index(Ack::count); ++n) {
    const auto ack = static_cast<Ack>(n);
    if (!given.has(ack) || (r.in.train.desk_open && r.state.requested.has(ack))) continue;
    r.log.note(event_of(What::acknowledgement_not_enabled, ack, "4.7.2"_srs));
    given.remove(ack);
  }
  given.add(Ack::train_data, train_data);
  return given;
}

/// Whether the data were accepted.
bool enter_train_data(Reception& r, const train::TrainData& data, bool typed) {
  if (!acceptable(data, r.log)) return false;
  // Values of another source are validated as they are (5.17.2.2 S6).
  const std::optional<train::TrainData>& changed = r.state.train_data_change.pending;
  const train::TrainData& before = changed ? *changed : r.state.train;
  const train::Fault fault = typed ? off_resolution(data, before) : train::Fault::none;
  if (fault != train::Fault::none) {
    r.log.note(event_of(What::train_data_refused, fault, "A.3.11"_srs));
    return false;
  }
  change_train_data(r.state, data, r.out.here, r.log);
  return true;
}

/// Train data entered, or those stored or changed by another source (5.17.2.2 S6) revalidated.
void receive_train_data(Reception& r) {
  const State& s = r.state;
  const DriverActions& driver = r.in.driver;
  const bool revalidated = driver.has(Ack::train_data) && s.data.train_data_status != DataStatus::unknown;
  if ((driver.train_data == nullptr && !revalidated) || !may_enter(r, driver::Input::train_data, Entered::train_data))
    return;
  const train::TrainData& data = driver.train_data != nullptr  ? *driver.train_data
                                 : s.train_data_change.pending ? *s.train_data_change.pending
                                                               : s.train;
  r.out.entered.add(Entered::train_data, enter_train_data(r, data, driver.train_data != nullptr));
}

/// 3.18.3.3.1, 4.4.11.1.5.1: movement while the driver enters, changes or revalidates data. An entry that arrives
/// counts as one whose window is open.
void watch_entries(Reception& r) {
  if (r.out.here.standstill) return;
  const State& s = r.state;
  const DriverActions& driver = r.in.driver;
  const bool train_data = r.in.windows.has(Window::train_data) || driver.train_data != nullptr ||
                          driver.has(Ack::train_data) ||
                          s.train_data_change.procedure.step == procedures::train_data_change::Step::S6;
  const bool SR_data = r.in.windows.has(Window::SR_data) || driver.V_sr || driver.D_sr;
  // After the start of mission: in SB any movement brakes (4.4.7.1.5).
  r.out.asked.add(brakes::Cause::movement_while_entering_train_data,
                  train_data && s.mode != Mode::SB && driver::allowed(driver::Input::train_data, s.mode, s.srs));
  r.out.asked.add(brakes::Cause::movement_while_entering_SR_data,
                  SR_data && driver::allowed(driver::Input::sr_speed_distance, s.mode, s.srs));
}

/// Entry of SR speed and distance (4.4.11.1.5): only in SR, the distance from the front end at the entry.
void enter_SR_data(Reception& r) {
  State& s = r.state;
  if (!r.in.driver.V_sr && !r.in.driver.D_sr) return;
  if (!may_enter(r, driver::Input::sr_speed_distance, Entered::SR_speed_distance)) return;
  if (!is_SR_entry(r.in.driver.V_sr, r.in.driver.D_sr))
    return r.log.note({.what = What::SR_data_out_of_range, .clause = "A.3.11"_srs});
  if (r.in.driver.V_sr) s.staff_responsible.V = r.in.driver.V_sr;
  if (r.in.driver.D_sr) set_SR_distance(s, r.out.here, r.in.driver.D_sr);
  ++s.revision;
}

/// 5.4.3.2 S3, 3.18.4.3.2: the contact is entered, or the stored one is used.
void choose_contact(Reception& r) {
  State& s = r.state;
  const auto& entered = r.in.driver.rbc_contact;
  const bool last = r.out.selected.has(Select::last_rbc);
  if (last && !s.radio.contact && !entered)
    return r.log.note(event_of(What::selection_not_enabled, Select::last_rbc, "3.18.4.3.1"_srs));
  if (entered && !is_rbc(*entered))
    return r.log.note(event_of(What::entry_out_of_range, Entered::rbc_contact, "3.18.4.3.5"_srs));
  if (entered && may_enter(r, driver::Input::rbc_contact, Entered::rbc_contact))
    s.radio.contact = radio::Rbc{entered->NID_C, entered->NID_RBC, entered->NID_RADIO};
  else if (!last)
    return;
  s.contact_status = DataStatus::valid;
  r.out.entered.add(Entered::rbc_contact);
}

/// 3.18.4.3.6: one of the networks that are offered. With another network the RBC of the contact may not be reached
/// (5.4.3.2 S3: deleted; 3.18.4.3.6.3 of 4.0.0: invalid).
void enter_network(Reception& r) {
  State& s = r.state;
  const auto& entered = r.in.driver.network;
  if (!entered || !may_enter(r, driver::Input::radio_network_id, Entered::network)) return;
  bool offered = false;
  for (const std::uint32_t NID_MN : s.network.offered) offered = offered || NID_MN == *entered;
  if (!offered) return r.log.note(event_of(What::entry_not_enabled, Entered::network, "3.18.4.3.6"_srs));
  r.out.entered.add(Entered::network);
  if (s.network.NID_MN == *entered) return;
  s.network.NID_MN = *entered;
  s.network.changed = true;
  s.network.by_driver = true;
  if (s.srs == SrsVersion::v4_0_0) return invalidate(s.contact_status);
  s.radio.contact.reset();
  s.contact_status = DataStatus::unknown;
}

/// 3.15.9.2, 3.15.9.5 c: the driver sets a virtual balise cover or removes one.
void enter_cover(Reception& r) {
  State& s = r.state;
  if (r.out.selected.has(Select::vbc_set) || !r.in.train.desk_open) s.removes_cover = false;
  if (r.out.selected.has(Select::vbc_remove)) s.removes_cover = true;
  const auto& cover = r.in.driver.cover;
  if (!cover || !may_enter(r, driver::Input::vbc, Entered::cover)) return;
  const bool removes = s.removes_cover;
  s.removes_cover = false;
  if (removes) {
    balise::remove_cover(s.balise, cover->NID_VBCMK, cover->NID_C);
    return r.log.note({.what = What::cover_removed, .id = cover->NID_VBCMK, .clause = "3.15.9.5"_srs});
  }
  // From now on (3.15.9.6), in days (7.5.1.155.1).
  const Duration until = s.now + Duration{86400.0 * cover->T_VBC};
  if (!balise::set_cover(s.balise, {cover->NID_VBCMK, cover->NID_C, until, cover->T_VBC}))
    return r.log.note({.what = What::cover_capacity});
  r.log.note({.what = What::cover_set, .id = cover->NID_VBCMK, .clause = "3.15.9.2"_srs});
}

/// 3.18.4.1, A.3.11
void enter_driver_id(Reception& r) {
  State& s = r.state;
  const auto& entered = r.in.driver.driver_id;
  if (!entered || !may_enter(r, driver::Input::driver_id, Entered::driver_id)) return;
  if (!entered->valid()) return r.log.note(event_of(What::entry_not_enabled, Entered::driver_id, "A.3.11"_srs));
  s.data.driver_id = *entered;
  s.data.driver_id_status = DataStatus::valid;
  r.out.entered.add(Entered::driver_id);
}

}  // namespace

bool may_enter(Reception& r, driver::Input input, Entered entered) {
  return may(r, input, event_of(What::entry_not_enabled, entered, "4.7.2"_srs));
}

std::optional<modes::OrderedLevel> driver_level(Reception& r) {
  if (!r.in.driver.level || !may_enter(r, driver::Input::level, Entered::level)) return {};
  const modes::OrderedLevel level = entered_level(r);
  if (!may_select(r, level)) {
    r.log.note(event_of(What::entry_not_enabled, Entered::level, "5.10.1.7"_srs));
    return {};
  }
  r.out.entered.add(Entered::level);
  return level;
}

void receive_driver(Reception& r) {
  State& s = r.state;
  const DriverActions& driver = r.in.driver;
  if (driver.selected != 0) r.out.selected = enabled_selections(r);
  r.out.acknowledged = acknowledgements(r);
  enter_driver_id(r);
  if (driver.train_running_number && may_enter(r, driver::Input::train_running_number, Entered::train_running_number)) {
    s.data.train_running_number = *driver.train_running_number;
    s.data.train_running_number_status = DataStatus::valid;
    s.data.train_running_number_from.reset();
    r.out.entered.add(Entered::train_running_number);
  }
  r.out.entry_of_train_data_open = r.in.windows.has(Window::train_data);
  receive_train_data(r);
  enter_network(r);
  choose_contact(r);
  enter_cover(r);
  set_display(r);
  if (r.out.selected.has(Select::slippery_rail) && !s.slippery_rail) {
    s.slippery_rail = true;
    ++s.revision;
  }
  if (r.out.selected.has(Select::adhesion_normal) && s.slippery_rail) {
    s.slippery_rail = false;
    ++s.revision;
  }
  watch_entries(r);
  enter_SR_data(r);
}

void receive_external_train_data(Reception& r) {
  const ExternalTrainData& received = r.in.external_train_data;
  TrainDataChange& change = r.state.train_data_change;
  if (received.data == nullptr || !r.in.train.powered || (!change.pending && *received.data == r.state.train)) return;
  // A train that cannot be supervised: the driver has to enter other data.
  const bool supervisable = acceptable(*received.data, r.log);
  // What the driver entered in this cycle is older: the procedure begins anew.
  if (r.out.entered.has(Entered::train_data)) change.procedure = {};
  change.driver_validates = received.driver_validates || !supervisable || (change.pending && change.driver_validates);
  change.pending = *received.data;
  r.log.note({.what = What::train_data_changed_by_source, .clause = "5.17.2.2"_srs});
}

}  // namespace evc::kernel
