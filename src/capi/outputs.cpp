#include "capi/outputs.h"

#include <cstring>
#include <optional>
#include <string_view>

#include "capi/codes.h"
#include "capi/guard.h"
#include "texts/texts.h"

namespace evc::capi {
namespace {

// There is room for all that the kernel gives.
static_assert(kRoom<decltype(kernel::Outputs::symbols)> == OPENEVC_SYMBOLS);
static_assert(kRoom<decltype(kernel::Outputs::texts)> == OPENEVC_TEXTS);
static_assert(kRoom<decltype(kernel::Outputs::radio_out)> == OPENEVC_RADIO_OUT);
static_assert(kRoom<decltype(kernel::OutgoingMessage::bytes)> == sizeof openevc_radio_out{}.bytes);
static_assert(kRoom<decltype(kernel::Outputs::events)> == OPENEVC_EVENTS);
static_assert(kRoom<decltype(kernel::Outputs::sessions)> == OPENEVC_SESSIONS);
static_assert(kRoom<decltype(kernel::Outputs::infill_sessions)> == OPENEVC_SESSIONS);
static_assert(kRoom<decltype(kernel::Outputs::status_texts)> == OPENEVC_STATUS_TEXTS);
static_assert(kRoom<decltype(kernel::Outputs::track_conditions)> == OPENEVC_CONDITIONS);
static_assert(kRoom<decltype(kernel::Outputs::ordered_areas)> == OPENEVC_AREAS);
static_assert(kRoom<decltype(kernel::Outputs::ordered_platforms)> == OPENEVC_PLATFORMS);
static_assert(kRoom<decltype(kernel::Outputs::forwarded)> == OPENEVC_FORWARDED);
static_assert(kRoom<decltype(kernel::ForwardedData::bytes)> == sizeof openevc_forwarded{}.bytes);
static_assert(kRoom<decltype(kernel::Outputs::covers)> == OPENEVC_COVERS);
static_assert(kRoom<decltype(kernel::Planning::speeds)> == OPENEVC_PLANNED_SPEEDS);
static_assert(kRoom<decltype(kernel::Planning::gradients)> == OPENEVC_PLANNED_GRADIENTS);
static_assert(kRoom<decltype(kernel::Planning::conditions)> == OPENEVC_PLANNED_CONDITIONS);
static_assert(sizeof openevc_text{}.characters == sizeof kernel::ShownText{}.characters);
static_assert(sizeof openevc_event{}.text > texts::ShortText::kMost);
static_assert(terms::index(StatusText::count) <= 64 && kLevels <= 8, "they are bits of a member");

double of(const std::optional<Speed>& v) { return v ? v->si : kNone; }
double of(const std::optional<Distance>& d) { return d ? d->si : kNone; }
double of(const std::optional<OdometerPlace>& p) { return p ? p->from_origin.si : kNone; }

openevc_address of(const std::optional<kernel::RbcAddress>& address) {
  openevc_address a{};
  if (!address) return a;
  a.given = 1;
  a.NID_C = address->NID_C;
  a.NID_RBC = address->NID_RBC;
  a.NID_RADIO = address->NID_RADIO;
  a.infill_unit = address->infill_unit;
  return a;
}

openevc_session of(const kernel::RbcSession& session) {
  openevc_session its{};
  its.NID_C = session.NID_C;
  its.NID_RBC = session.NID_RBC;
  its.phase = static_cast<std::int32_t>(session.phase);
  return its;
}

template <std::size_t N>
void put(char (&to)[N], std::string_view text) {
  const std::size_t n = text.size() < N - 1 ? text.size() : N - 1;
  std::memcpy(to, text.data(), n);
  to[n] = '\0';
}

void give_texts(openevc_outputs& to, const kernel::Outputs& o) {
  for (const kernel::ShownText& text : o.texts) {
    openevc_text_shown& shown = to.texts_shown[to.texts_count];
    shown.since = text.since.si;
    shown.important = text.important;
    shown.acknowledge = text.acknowledge;
    openevc_text& t = to.texts[to.texts_count++];
    t.id = text.id;
    t.Q_TEXT = text.Q_TEXT ? *text.Q_TEXT : -1;
    t.length = text.length;
    std::memcpy(t.characters, text.characters.data(), text.length);
  }
  for (const kernel::ShownStatus& status : o.status_texts) {
    to.status_texts |= std::uint64_t{1} << terms::index(status.text);
    openevc_status_shown& shown = to.statuses[to.statuses_count++];
    shown.text = static_cast<std::int32_t>(status.text);
    shown.acknowledge = asks_acknowledgement(status.text);
    shown.since = status.since.si;
  }
}

void give_radio(openevc_outputs& to, const kernel::Outputs& o) {
  to.connect = of(o.radio_connect);
  to.disconnect = of(o.radio_disconnect);
  for (const kernel::OutgoingMessage& message : o.radio_out) {
    if (message.to) {
      openevc_rbc& rbc = to.radio_out_to[to.radio_out_count];
      rbc.given = 1;
      rbc.NID_C = message.to->NID_C;
      rbc.NID_RBC = message.to->NID_RBC;
      rbc.infill_unit = message.infill_unit;
    }
    openevc_radio_out& m = to.radio_out[to.radio_out_count++];
    m.size = static_cast<std::uint32_t>(message.bytes.size());
    std::memcpy(m.bytes, message.bytes.begin(), message.bytes.size());
  }
  for (const kernel::RbcSession& session : o.sessions) {
    to.sessions_role[to.sessions_count] = static_cast<std::int32_t>(session.role);
    to.sessions[to.sessions_count++] = of(session);
  }
  for (const kernel::RbcSession& session : o.infill_sessions)
    to.infill_sessions[to.infill_sessions_count++] = of(session);
}

/// Track conditions for the driver (5.18) and orders for the train (5.20).
void give_conditions(openevc_outputs& to, const kernel::Outputs& o) {
  for (const kernel::ShownCondition& condition : o.track_conditions) {
    openevc_condition& c = to.conditions[to.conditions_count++];
    put(c.symbol, name(condition.symbol));
    c.kind = condition.kind ? static_cast<std::int32_t>(*condition.kind) : -1;
    c.phase = static_cast<std::int32_t>(condition.phase);
    c.from = condition.from.from_origin.si;
    c.to = condition.to.from_origin.si;
  }
  for (const kernel::OrderedArea& area : o.ordered_areas) {
    openevc_area& a = to.areas[to.areas_count++];
    a.kind = static_cast<std::int32_t>(area.kind);
    a.to_start = of(area.to_start);
    a.to_end = area.to_end.si;
  }
  for (const kernel::OrderedPlatform& platform : o.ordered_platforms) {
    openevc_platform& p = to.platforms[to.platforms_count++];
    p.to_start = of(platform.to_start);
    p.to_end = platform.to_end.si;
    p.M_PLATFORM = platform.M_PLATFORM;
    p.Q_PLATFORM = platform.Q_PLATFORM;
  }
  if (o.ordered_traction) {
    to.traction.given = 1;
    to.traction.M_VOLTAGE = o.ordered_traction->M_VOLTAGE;
    to.traction.NID_CTRACTION = o.ordered_traction->NID_CTRACTION;
    to.traction.to_start = o.ordered_traction->to_start.si;
  }
  if (o.ordered_current) {
    to.current.given = 1;
    to.current.amperes = o.ordered_current->amperes ? *o.ordered_current->amperes : -1;
    to.current.to_start = o.ordered_current->to_start.si;
  }
  to.sound_horn = o.sound_horn;
  to.remote_shunting = o.remote_shunting;
  if (o.engine_orientation) to.engine_orientation = *o.engine_orientation == EngineOrientation::same ? 1 : -1;
}

/// For a member of 32 bits.
template <class E>
std::uint32_t bits_32(Set<E> set) {
  static_assert(static_cast<unsigned>(E::count) <= 32);
  return static_cast<std::uint32_t>(set.bits());
}

std::uint8_t code_of(DataStatus status) { return static_cast<std::uint8_t>(status); }

void give_train(openevc_data& to, const kernel::ShownTrainData& train) {
  to.L_TRAIN = train.L_TRAIN.si;
  to.V_MAXTRAIN = train.V_MAXTRAIN.si;
  to.brake_percentage = train.brake_percentage.value_or(kNone);
  to.cant_deficiency_mm = train.cant_deficiency_mm;
  to.other_categories = train.other_categories;
  to.M_AXLELOADCAT = static_cast<std::uint8_t>(train.axle_load);
  to.M_LOADINGGAUGE = static_cast<std::uint8_t>(train.loading_gauge);
  to.airtight = train.airtight;
}

/// As BCD, filled up with F; all F for an ID that is no number of 8 digits.
std::uint32_t digits_of(const DriverId& id) {
  std::uint32_t packed = 0xFFFFFFFF;
  if (id.view().size() > 8) return packed;
  for (std::size_t i = 0; i < id.view().size(); ++i) {
    const char c = id.characters[i];
    if (c < '0' || c > '9') return 0xFFFFFFFF;
    const unsigned shift = 28u - 4u * static_cast<unsigned>(i);
    packed = (packed & ~(15u << shift)) | (static_cast<std::uint32_t>(c - '0') << shift);
  }
  return packed;
}

/// Stored data (3.18.6).
void give_data(openevc_data& to, const kernel::Outputs& o) {
  give_stored(to, o.data);
  for (const kernel::ShownCover& cover : o.covers) give_cover(to, cover);
}

void give_forwarded(openevc_outputs& to, const kernel::Outputs& o) {
  for (const kernel::ForwardedData& data : o.forwarded) {
    openevc_forwarded& f = to.forwarded[to.forwarded_count++];
    f.NID_XUSER = data.NID_XUSER;
    f.NID_NTC = data.NID_NTC ? std::int16_t{*data.NID_NTC} : std::int16_t{-1};
    f.bits = data.bits;
    f.size = static_cast<std::uint16_t>(data.bytes.size());
    std::memcpy(f.bytes, data.bytes.begin(), data.bytes.size());
  }
}

/// Single values that came later.
void give_second_edition(openevc_outputs& to, const kernel::Outputs& o) {
  to.V_I = of(o.V_I);
  to.TTI = o.TTI ? o.TTI->si : kNone;
  to.LSSMA = of(o.LSSMA);
  to.d_indication = of(o.d_indication);
  to.geo = of(o.geo);
  to.rv_left = of(o.rv_left);
  to.M_VERSION = o.M_VERSION;
  to.radio_register = o.radio_register ? static_cast<std::int32_t>(*o.radio_register) : -1;
  to.MRDT_changed = o.MRDT_changed;
  to.level_valid = o.level_valid;
  to.levels_allowed = static_cast<std::uint8_t>(o.levels_allowed.bits());
  to.memo_status = o.memo_status ? static_cast<std::int32_t>(*o.memo_status) : -1;
  to.trip_reason = o.trip_reason ? static_cast<std::int32_t>(*o.trip_reason) : -1;
  to.enabled = o.enabled.bits();
  to.dialogue = o.dialogue ? static_cast<std::int32_t>(o.dialogue->step) : -1;
  const bool acknowledges = o.dialogue && o.dialogue->acknowledges;
  to.shown = o.shown.bits();
  std::memcpy(to.language, o.language.letters.data(), o.language.letters.size());
  std::memcpy(to.driver_id_text, o.data.driver_id.characters.data(), DriverId::kMost);
  to.national_system = o.national_system ? std::int32_t{*o.national_system} : -1;
  to.network = o.data.network ? static_cast<std::int32_t>(*o.data.network) : -1;
  to.set_speed = of(o.set_speed);
  to.dialogue_acknowledge = acknowledges ? static_cast<std::int32_t>(*o.dialogue->acknowledges) : -1;
}

}  // namespace

void give_stored(openevc_data& to, const kernel::ShownData& data) noexcept {
  to.driver_id_status = code_of(data.driver_id_status);
  to.driver_id = digits_of(data.driver_id);
  to.train_running_number_status = code_of(data.train_running_number_status);
  to.train_running_number = data.train_running_number;
  to.level_status = code_of(data.level_status);
  to.rbc_status = code_of(data.rbc_status);
  to.rbc = of(data.rbc_status == DataStatus::unknown ? std::nullopt : std::optional(data.rbc));
  to.train_status = code_of(data.train_status);
  give_train(to, data.train);
  to.SR_status = code_of(data.SR.status);
  to.V_sr = data.SR.V.si;
  to.D_sr = of(data.SR.D);
  to.slippery_rail = data.slippery_rail;
}

void give_cover(openevc_data& to, const kernel::ShownCover& cover) noexcept {
  openevc_cover& c = to.covers[to.covers_count++];
  c.NID_C = cover.NID_C;
  c.NID_VBCMK = cover.NID_VBCMK;
  c.T_VBC = cover.T_VBC;
  c.left = cover.left.si;
}

void give_outputs(openevc_outputs& to, const kernel::Outputs& o) noexcept {
  to = {};
  to.mode = static_cast<std::int32_t>(o.mode);
  to.level = static_cast<std::int32_t>(o.level);
  to.NID_NTC = o.nid_ntc;
  to.LRBG_NID_C = o.lrbg ? o.lrbg->NID_C : -1;
  to.LRBG_NID_BG = o.lrbg ? o.lrbg->NID_BG : -1;
  to.monitoring = static_cast<std::int32_t>(o.monitoring);
  to.status = static_cast<std::int32_t>(o.status);
  to.now = o.now.si;
  to.est_front = o.est_front.from_origin.si;
  to.min_safe_front = o.min_safe_front.from_origin.si;
  to.max_safe_front = o.max_safe_front.from_origin.si;
  to.V_est = o.v.si;
  to.V_P = of(o.V_P);
  to.V_W = of(o.V_W);
  to.V_SBI = of(o.V_SBI);
  to.V_EBI = of(o.V_EBI);
  to.V_MRSP = of(o.V_MRSP);
  to.V_target = of(o.V_target);
  to.V_release = of(o.V_release);
  to.d_target = of(o.d_target);
  to.EOA = of(o.EOA);
  to.SvL = of(o.SvL);
  to.tco = o.tco;
  to.sb = o.sb;
  to.eb = o.eb;
  to.start_offered = o.start_offered;
  to.requests = bits_32(o.requests);
  to.entries = bits_32(o.entries);
  to.brake_causes = o.brake_reasons.bits();
  for (const Symbol symbol : o.symbols) put(to.symbols[to.symbols_count++], name(symbol));
  for (const kernel::Event& event : o.events) put(to.events[to.events_count++].text, texts::line_of(event).view());
  give_second_edition(to, o);
  give_texts(to, o);
  give_radio(to, o);
  give_conditions(to, o);
  give_data(to.data, o);
  give_forwarded(to, o);
  to.utc_given = o.clock ? 1 : 0;
  to.utc = o.clock ? o.clock->utc : 0;
  to.local_offset_min = o.clock ? o.clock->local_offset_min : 0;
}

void give_planning(openevc_planning& to, const kernel::Planning* planning) noexcept {
  to = {};
  to.EOA = to.LOA = to.V_LOA = kNone;
  if (planning == nullptr) return;
  const kernel::Planning& p = *planning;
  to.given = 1;
  to.EOA = of(p.EOA);
  to.LOA = of(p.LOA);
  if (p.LOA) to.V_LOA = p.V_LOA.si;
  for (const kernel::PlannedSpeed& speed : p.speeds) {
    openevc_planned_speed& s = to.speeds[to.speeds_count++];
    s.at = speed.at.si;
    s.V = speed.V.si;
    s.sources = bits_32(speed.sources);
  }
  for (const kernel::PlannedGradient& gradient : p.gradients) {
    openevc_planned_gradient& g = to.gradients[to.gradients_count++];
    g.from = gradient.from.si;
    g.to = gradient.to.si;
    g.permille = gradient.permille;
  }
  for (const kernel::PlannedCondition& condition : p.conditions) {
    openevc_planned_condition& c = to.conditions[to.conditions_count++];
    put(c.symbol, name(condition.symbol));
    c.kind = condition.kind ? static_cast<std::int32_t>(*condition.kind) : -1;
    c.at = condition.at.si;
  }
}

}  // namespace evc::capi
