#include <cstring>
#include <optional>

#include "capi/codes.h"
#include "capi/guard.h"
#include "capi/outputs.h"
#include "openevc/terms/button.h"
#include "openevc/terms/picture.h"

// The record of the display (ERA_ERTMS_015560) as a struct of C.
namespace evc::capi {
namespace {

// There is room for all that the kernel gives.
static_assert(kRoom<decltype(kernel::Display::conditions)> == OPENEVC_DISPLAYED_CONDITIONS);
static_assert(kRoom<decltype(kernel::Display::orders)> == OPENEVC_PLANNED_ORDERS);
static_assert(kRoom<decltype(kernel::Display::texts)> == OPENEVC_DISPLAYED_TEXTS);
static_assert(kRoom<decltype(kernel::Display::acks)> == OPENEVC_ASKED);
static_assert(kRoom<decltype(port::DisplayedData::ntcs)> == OPENEVC_NATIONAL_SYSTEMS);
static_assert(kRoom<decltype(port::DisplayedData::networks)> == OPENEVC_NETWORKS);
static_assert(kRoom<decltype(port::DisplayedData::covers)> == OPENEVC_COVERS);
static_assert(sizeof openevc_displayed_text{}.characters > sizeof port::DisplayedText{}.characters);
static_assert(terms::index(Button::count) <= 64 && terms::index(DriverInput::count) <= 64);

template <class Q>
double value_of(const std::optional<Q>& quantity) {
  return quantity ? quantity->si : kNone;
}
template <class T>
std::int32_t number_of(const std::optional<T>& value) {
  return value ? static_cast<std::int32_t>(*value) : -1;
}
void put_symbol(char (&to)[8], Picture picture) { std::strncpy(to, name(picture), sizeof to - 1); }

void give_speeds(openevc_display& to, const kernel::Display& d) {
  to.V = d.v.si;
  to.V_P = value_of(d.V_P);
  to.V_SBI = value_of(d.V_SBI);
  to.V_target = value_of(d.V_target);
  to.V_release = value_of(d.V_release);
  to.d_target = value_of(d.d_target);
  to.TTI = value_of(d.TTI);
  to.LSSMA = value_of(d.LSSMA);
  to.set_speed = value_of(d.set_speed);
  to.T_dispTTI = d.config.T_dispTTI.si;
  to.dial = static_cast<std::int32_t>(d.config.dial);
  to.monitoring = static_cast<std::int32_t>(d.monitoring);
  to.status = static_cast<std::int32_t>(d.status);
  to.target_information = d.target_information;
  to.MRDT = d.MRDT;
}

void give_symbols(openevc_display& to, const kernel::Display& d) {
  to.slippery_rail = d.slippery_rail;
  to.override_active = d.override_active;
  to.reversing_permitted = d.reversing_permitted;
  to.bmm_inhibited = d.bmm_inhibited;
  to.track_ahead_free = d.track_ahead_free;
  to.brake = d.brake;
  to.brake_for_missing_ack = d.brake_for_missing_ack;
  if (d.sm) to.SM_direction = *d.sm == port::SmDirection::forward ? 1 : -1;
  to.ato_on = d.ato.on;
  to.announced = d.announced_level.has_value();
  if (d.announced_level) {
    to.announced_level = static_cast<std::int32_t>(d.announced_level->level);
    to.announced_NID_NTC = d.announced_level->nid_ntc;
  }
  to.radio = static_cast<std::int32_t>(d.radio);
  to.tunnel = d.tunnel.has_value();
  to.tunnel_inside = d.tunnel && d.tunnel->inside;
  to.tunnel_distance = d.tunnel ? d.tunnel->distance.si : kNone;
  to.geo = value_of(d.geo);
  for (const port::DisplayedCondition& condition : d.conditions) {
    openevc_displayed_condition& c = to.conditions[to.conditions_count++];
    put_symbol(c.symbol, condition.picture);
    c.phase = static_cast<std::int32_t>(condition.phase);
    c.id = condition.id;
  }
  for (const port::PlannedOrder& order : d.orders) {
    openevc_planned_order& o = to.orders[to.orders_count++];
    put_symbol(o.symbol, order.picture);
    o.at = order.at.si;
  }
  to.indication_marker = value_of(d.indication_marker);
  to.indication_target = value_of(d.indication_target);
}

void give_text(openevc_displayed_text& to, const port::DisplayedText& text) {
  to.id = text.id;
  to.kind = static_cast<std::uint8_t>(text.kind);
  to.important = text.important;
  to.acknowledge = text.acknowledge;
  to.Q_TEXT = text.Q_TEXT;
  to.NID_NTC = text.nid_ntc;
  to.length = text.length;
  to.status = text.kind == port::TextKind::status ? static_cast<std::int32_t>(text.status) : -1;
  to.minute_of_day = number_of(text.minute_of_day);
  to.since = text.since.si;
  std::memcpy(to.characters, text.characters.data(), text.characters.size());
}

void give_driver(openevc_display& to, const kernel::Display& d) {
  for (const port::DisplayedText& text : d.texts) give_text(to.texts[to.texts_count++], text);
  for (const port::AskedAck& asked : d.acks) {
    openevc_asked& a = to.asked[to.asked_count++];
    a.what = static_cast<std::int32_t>(asked.what);
    a.id = asked.id;
    a.since = asked.since.si;
  }
  to.buttons = d.buttons.bits();
  to.enabled = d.enabled.bits();
  to.step = number_of(d.step);
  to.start_of_mission = d.start_of_mission;
  to.waiting = static_cast<std::int32_t>(d.waiting);
  to.asks_brake_percentage = d.config.asks_brake_percentage;
}

void give_displayed_data(openevc_display& to, const port::DisplayedData& data) {
  give_stored(to.data, data.stored);
  for (const kernel::ShownCover& cover : data.covers) give_cover(to.data, cover);
  std::memcpy(to.driver_id_text, data.stored.driver_id.characters.data(), DriverId::kMost);
  to.network = number_of(data.stored.network);
  to.levels = data.levels;
  to.M_VERSION = data.M_VERSION;
  to.radio_registered = data.gsmr_registered;
  for (const std::uint8_t nid_ntc : data.ntcs) to.national_systems[to.national_systems_count++] = nid_ntc;
  for (const std::uint32_t NID_MN : data.networks) to.networks[to.networks_count++] = NID_MN;
  to.D_sr_most = value_of(data.D_sr_most);
}

}  // namespace

void give_display(openevc_display& to, const kernel::Display& d) noexcept {
  to = {};
  to.mode = static_cast<std::int32_t>(d.mode);
  to.level = static_cast<std::int32_t>(d.level);
  to.level_valid = d.level_valid;
  to.NID_NTC = d.nid_ntc;
  to.standstill = d.standstill;
  to.now = d.now.si;
  to.second_of_day = number_of(d.second_of_day);
  std::memcpy(to.language, d.language.letters.data(), d.language.letters.size());
  give_speeds(to, d);
  give_symbols(to, d);
  give_driver(to, d);
  give_displayed_data(to, d.data);
  give_planning(to.planning, &d.planning);
}

}  // namespace evc::capi
