#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "capi/codes.h"
#include "capi/guard.h"
#include "io/input_stream.h"
#include "io/json.h"
#include "io/output_lines.h"
#include "openevc/evc.h"

using evc::capi::kNone;
using evc::capi::Why;
namespace kernel = evc::kernel;

/// The unit and memory for the data its port refers to, without pointers: it may be moved as bytes.
struct openevc_unit {
  static constexpr std::uint64_t kTag = 0x6F6576635F756E69;  // "oevc_uni"
  std::uint64_t tag = 0;
  kernel::Unit unit;
  kernel::Outputs outputs;
};
static_assert(std::is_trivially_copyable_v<openevc_unit>);
static_assert(alignof(openevc_unit) <= evc::capi::kAlignment);

static_assert(decltype(kernel::Outputs::sessions)::capacity() == OPENEVC_SESSIONS &&
              decltype(kernel::Outputs::symbols)::capacity() == OPENEVC_SYMBOLS &&
              decltype(kernel::Outputs::texts)::capacity() == OPENEVC_TEXTS &&
              decltype(kernel::Outputs::radio_out)::capacity() == OPENEVC_RADIO_OUT &&
              decltype(kernel::Outputs::events)::capacity() == OPENEVC_EVENTS &&
              decltype(kernel::OutgoingMessage::bytes)::capacity() == sizeof openevc_radio_out{}.bytes);

namespace {

bool usable(const openevc_unit* unit) {
  return unit != nullptr && evc::capi::aligned(unit) && unit->tag == openevc_unit::kTag;
}
constexpr const char* kTrainData = "inputs.train_data";
constexpr const char* kExternalTrainData = "inputs.external_train_data";
constexpr const char* kNoUnit = "unit: null or not powered up";

/// Inputs of a program with an older header are shorter: members it does not have keep their
/// defaults.
bool take_inputs(openevc_inputs& ours, const openevc_inputs* theirs) {
  openevc_inputs_init(&ours, sizeof ours);
  if (theirs == nullptr || theirs->size < sizeof theirs->size) return false;
  std::memcpy(&ours, theirs, theirs->size < sizeof ours ? theirs->size : sizeof ours);
  return true;
}

/// The spans of one cycle.
struct Received {
  std::vector<kernel::BaliseTelegram> telegrams;
  std::vector<kernel::LoopMessage> loops;
  std::vector<kernel::RadioMessage> radio;
  std::optional<evc::io::Train> train, external_train;
};

/// A block of docs/train.md, not checked.
evc::io::Result<evc::io::Train> read_train_data(const char* text, std::size_t length, const char* name) {
  return evc::io::guarded([&] {
    const evc::io::Json document = evc::io::parse_json({text, length}, name);
    return evc::io::read_entered_train(evc::io::JsonPlace(document, name));
  });
}

const char* take_signals(kernel::TrainSignals& s, const openevc_inputs& in) {
  s.powered = in.powered != 0;
  s.isolated = in.isolated != 0;
  s.desk_open = in.desk_open != 0;
  s.sleeping = in.sleeping != 0;
  s.non_leading = in.non_leading != 0;
  s.passive_shunting = in.passive_shunting != 0;
  if (in.direction < -1 || in.direction > 1) return "inputs.direction: not -1, 0 or 1";
  s.direction_controller = in.direction < 0   ? kernel::DirectionController::backward
                           : in.direction > 0 ? kernel::DirectionController::forward
                                              : kernel::DirectionController::neutral;
  if (!std::isnan(in.brake_pressure_kpa)) s.brake_pressure_kpa = in.brake_pressure_kpa;
  s.service_brake_feedback = in.service_brake_feedback != 0;
  s.regenerative_brake_active = in.regenerative_brake_active != 0;
  s.eddy_current_brake_active = in.eddy_current_brake_active != 0;
  s.magnetic_shoe_brake_active = in.magnetic_shoe_brake_active != 0;
  s.ep_brake_active = in.ep_brake_active != 0;
  s.additional_brake_active = in.additional_brake_active != 0;
  s.antenna_alarm = in.antenna_alarm != 0;
  if (in.integrity < OPENEVC_INTEGRITY_UNKNOWN || in.integrity > OPENEVC_INTEGRITY_LOST)
    return "inputs.integrity: not an openevc_integrity";
  s.integrity = static_cast<evc::TrainIntegrity>(in.integrity);
  if (!std::isnan(in.length_confirmed)) s.length_confirmed = {in.length_confirmed};
  return nullptr;
}

/// Null where everything is as it has to be.
const char* take_received(kernel::Inputs& out, Received& received, const openevc_inputs& in) {
  if ((in.telegrams_count > 0 && in.telegrams == nullptr) || (in.loops_count > 0 && in.loops == nullptr) ||
      (in.radio_count > 0 && in.radio == nullptr))
    return "inputs.telegrams, loops or radio: null";
  for (std::size_t i = 0; i < in.telegrams_count; ++i) {
    const openevc_telegram& t = in.telegrams[i];
    if (t.bytes == nullptr || t.bits == 0) return "inputs.telegrams: without bits";
    received.telegrams.push_back({{t.bytes, (std::size_t{t.bits} + 7) / 8}, t.bits, {{t.at}}});
  }
  for (std::size_t i = 0; i < in.loops_count; ++i) {
    if (in.loops[i].bytes == nullptr) return "inputs.loops: without bytes";
    received.loops.push_back({{in.loops[i].bytes, in.loops[i].size}});
  }
  for (std::size_t i = 0; i < in.radio_count; ++i) {
    if (in.radio[i].bytes == nullptr) return "inputs.radio: without bytes";
    received.radio.push_back({{in.radio[i].bytes, in.radio[i].size}});
  }
  if (in.link < OPENEVC_LINK_UNCHANGED || in.link > OPENEVC_LINK_REFUSED) return "inputs.link: not an openevc_link";
  out.radio_link = static_cast<evc::RadioLink>(in.link);
  out.balise_telegrams = received.telegrams;
  out.loop_messages = received.loops;
  out.radio_messages = received.radio;
  return nullptr;
}

bool entered(const openevc_inputs& in, openevc_entry entry) { return ((in.entered >> entry) & 1u) != 0; }

/// Null where everything is as it has to be; a train that cannot be read is rejected with the
/// reason in `why`.
const char* take_driver(kernel::DriverActions& driver, const openevc_inputs& in) {
  driver.selected = in.selected;
  driver.acknowledged = in.acknowledged;
  if (entered(in, OPENEVC_ENTRY_DRIVER_ID)) driver.driver_id = in.driver_id;
  if (entered(in, OPENEVC_ENTRY_TRAIN_RUNNING_NUMBER)) driver.train_running_number = in.train_running_number;
  if (entered(in, OPENEVC_ENTRY_LEVEL)) {
    if (in.level < OPENEVC_L0 || in.level > OPENEVC_L3) return "inputs.level: not an openevc_level";
    if (in.NID_NTC > 255) return "inputs.NID_NTC: above 255";
    driver.level = static_cast<evc::Level>(in.level);
    driver.nid_ntc = static_cast<std::uint8_t>(in.NID_NTC);
  }
  if (entered(in, OPENEVC_ENTRY_RBC_CONTACT)) driver.rbc_contact = {in.NID_C, in.NID_RBC, in.NID_RADIO};
  if (entered(in, OPENEVC_ENTRY_SR_SPEED)) driver.V_sr = evc::Speed{in.V_sr};
  if (entered(in, OPENEVC_ENTRY_SR_DISTANCE)) driver.D_sr = evc::Distance{in.D_sr};
  if (entered(in, OPENEVC_ENTRY_TRAIN_DATA) && in.train_data == nullptr) return "inputs.train_data: null";
  return nullptr;
}

double of(const std::optional<evc::Speed>& v) { return v ? v->si : kNone; }
double of(const std::optional<evc::Distance>& d) { return d ? d->si : kNone; }
double of(const std::optional<evc::OdometerPlace>& p) { return p ? p->from_origin.si : kNone; }

openevc_address of(const std::optional<kernel::RbcAddress>& address) {
  openevc_address a{};
  if (!address) return a;
  a.given = 1;
  a.NID_C = address->NID_C;
  a.NID_RBC = address->NID_RBC;
  a.NID_RADIO = address->NID_RADIO;
  return a;
}

template <std::size_t N>
void put(char (&to)[N], std::string_view text) {
  const std::size_t n = text.size() < N - 1 ? text.size() : N - 1;
  std::memcpy(to, text.data(), n);
  to[n] = '\0';
}

void give_lists(openevc_outputs& to, const kernel::Outputs& o) {
  for (const evc::Symbol symbol : o.symbols) put(to.symbols[to.symbols_count++], evc::name(symbol));
  for (const kernel::ShownText& text : o.texts) {
    openevc_text& t = to.texts[to.texts_count++];
    t.id = text.id;
    t.Q_TEXT = text.Q_TEXT ? *text.Q_TEXT : -1;
    t.length = text.length;
    std::memcpy(t.characters, text.characters.data(), text.length);
  }
  for (const kernel::OutgoingMessage& message : o.radio_out) {
    openevc_radio_out& m = to.radio_out[to.radio_out_count++];
    m.size = static_cast<std::uint32_t>(message.bytes.size());
    std::memcpy(m.bytes, message.bytes.begin(), message.bytes.size());
  }
  std::string line;
  for (const kernel::Event& event : o.events) {
    line.clear();
    evc::io::append_event(line, event);
    put(to.events[to.events_count++].text, line);
  }
}

/// For a member of 32 bits.
template <class E>
std::uint32_t bits_32(evc::Set<E> set) {
  static_assert(static_cast<unsigned>(E::count) <= 32);
  return static_cast<std::uint32_t>(set.bits());
}

/// What the driver is shown beside symbols and texts.
void give_second_edition(openevc_outputs& to, const kernel::Outputs& o) {
  to.V_I = of(o.V_I);
  to.TTI = o.TTI ? o.TTI->si : kNone;
  to.LSSMA = of(o.LSSMA);
  to.d_indication = of(o.d_indication);
  to.geo = of(o.geo);
  to.rv_left = of(o.rv_left);
  to.MRDT_changed = o.MRDT_changed;
  to.level_valid = o.level_valid;
  static_assert(evc::kLevels <= 8);
  to.levels_allowed = static_cast<std::uint8_t>(o.levels_allowed.bits());
  to.memo_status = o.memo_status ? static_cast<std::int32_t>(*o.memo_status) : -1;
  to.trip_reason = o.trip_reason ? static_cast<std::int32_t>(*o.trip_reason) : -1;
  for (const kernel::ShownStatus& shown : o.status_texts) to.status_texts |= std::uint64_t{1} << int(shown.text);
  to.enabled = o.enabled.bits();
  for (const kernel::RbcSession& session : o.sessions)
    to.sessions[to.sessions_count++] = {session.NID_C, session.NID_RBC, static_cast<std::int32_t>(session.phase)};
}

void give_outputs(openevc_outputs& to, const kernel::Outputs& o) {
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
  to.connect = of(o.radio_connect);
  to.disconnect = of(o.radio_disconnect);
  give_lists(to, o);
  give_second_edition(to, o);
}

}  // namespace

size_t openevc_unit_size(void) noexcept { return sizeof(openevc_unit); }

openevc_result openevc_power_up(void* memory, size_t memory_size, const char* configuration, size_t length,
                                openevc_unit** unit, char* why_text, size_t why_size) noexcept {
  const Why why{why_text, why_size};
  if (unit == nullptr) return why.because(OPENEVC_BAD_ARGUMENT, "unit: null");
  *unit = nullptr;
  if (const char* refused = evc::capi::refuse_memory(memory, memory_size, sizeof(openevc_unit)))
    return why.because(OPENEVC_BAD_ARGUMENT, refused);
  return evc::capi::guarded(why, [&] {
    const bool given = configuration != nullptr && length > 0;
    const auto read =
        evc::io::read_configuration(given ? std::string_view(configuration, length) : "{}", "configuration");
    if (!read) return why.because(OPENEVC_REFUSED, read.error().text());
    auto& u = *new (memory) openevc_unit;
    kernel::Config config = read->for_kernel();
    config.terminals = 1;  // its messages do not name their RBC
    kernel::power_up(u.unit, config);
    u.tag = openevc_unit::kTag;
    *unit = &u;
    return OPENEVC_OK;
  });
}

openevc_result openevc_inputs_init(openevc_inputs* inputs, uint32_t size) noexcept {
  if (inputs == nullptr || size < sizeof inputs->size) return OPENEVC_BAD_ARGUMENT;
  const kernel::TrainSignals signals;
  openevc_inputs in{};
  in.powered = signals.powered;
  in.direction = 1;
  in.regenerative_brake_active = in.eddy_current_brake_active = in.magnetic_shoe_brake_active = in.ep_brake_active = 1;
  in.brake_pressure_kpa = in.length_confirmed = kNone;
  in.size = size;
  std::memcpy(inputs, &in, size < sizeof in ? size : sizeof in);
  return OPENEVC_OK;
}

openevc_result openevc_step(openevc_unit* unit, const openevc_inputs* inputs, openevc_outputs* outputs, char* why_text,
                            size_t why_size) noexcept {
  const Why why{why_text, why_size};
  if (!usable(unit)) return why.because(OPENEVC_BAD_ARGUMENT, kNoUnit);
  openevc_inputs in;
  if (!take_inputs(in, inputs)) return why.because(OPENEVC_BAD_ARGUMENT, "inputs: null, or its size is not set");
  if (outputs == nullptr || outputs->size < sizeof outputs->size)
    return why.because(OPENEVC_BAD_ARGUMENT, "outputs: null, or its size is not set");
  return evc::capi::guarded(why, [&] {
    kernel::Inputs cycle;
    Received received;
    for (const char* refused :
         {take_received(cycle, received, in), take_signals(cycle.train, in), take_driver(cycle.driver, in)})
      if (refused != nullptr) return why.because(OPENEVC_BAD_ARGUMENT, refused);
    if (entered(in, OPENEVC_ENTRY_TRAIN_DATA)) {
      auto train = read_train_data(in.train_data, in.train_data_length, kTrainData);
      if (!train) return why.because(OPENEVC_REFUSED, train.error().text());
      received.train = std::move(*train);
      cycle.driver.train_data = &received.train->data;
    }
    if (in.external_train_data != nullptr) {
      auto train = read_train_data(in.external_train_data, in.external_train_data_length, kExternalTrainData);
      if (!train) return why.because(OPENEVC_REFUSED, train.error().text());
      received.external_train = std::move(*train);
      cycle.external_train_data = {&received.external_train->data, in.external_data_trusted == 0};
    }
    cycle.windows = evc::Set<kernel::Window>::of_bits(in.open_windows);
    cycle.now = {in.now};
    cycle.odometry = {{{in.nominal}}, {{in.min}}, {{in.max}}, {in.V_est}, {in.V_min}, {in.V_max}, {in.A_est}};
    cycle.national_system = {in.national_systems, in.national_trip != 0, in.national_service_brake != 0,
                             in.national_emergency_brake != 0};
    cycle.safety_fault = in.safety_fault != 0;
    kernel::step(unit->unit, cycle, unit->outputs);
    openevc_outputs out{};
    give_outputs(out, unit->outputs);
    evc::capi::give(outputs, out);
    return OPENEVC_OK;
  });
}

const char* openevc_cause_name(int32_t cause) noexcept {
  if (cause < 0 || cause >= int(evc::Cause::count)) return nullptr;
  return evc::name(static_cast<evc::Cause>(cause));
}

const char* openevc_status_text_name(int32_t text) noexcept {
  if (text < 0 || text >= int(evc::StatusText::count)) return nullptr;
  return evc::name(static_cast<evc::StatusText>(text));
}

const char* openevc_input_name(int32_t input) noexcept {
  if (input < 0 || input >= int(evc::DriverInput::count)) return nullptr;
  return evc::name(static_cast<evc::DriverInput>(input));
}

size_t openevc_snapshot_size(void) noexcept { return kernel::snapshot_size(); }

openevc_result openevc_snapshot(const openevc_unit* unit, void* snapshot, size_t size) noexcept {
  if (!usable(unit) || snapshot == nullptr) return OPENEVC_BAD_ARGUMENT;
  return kernel::snapshot(unit->unit, {static_cast<std::byte*>(snapshot), size}) ? OPENEVC_OK : OPENEVC_TOO_SMALL;
}

openevc_result openevc_restore(void* memory, size_t memory_size, const void* snapshot, size_t size, openevc_unit** unit,
                               char* why_text, size_t why_size) noexcept {
  const Why why{why_text, why_size};
  if (unit == nullptr) return why.because(OPENEVC_BAD_ARGUMENT, "unit: null");
  if (const char* refused = evc::capi::refuse_memory(memory, memory_size, sizeof(openevc_unit)))
    return why.because(OPENEVC_BAD_ARGUMENT, refused);
  if (snapshot == nullptr) return why.because(OPENEVC_BAD_ARGUMENT, "snapshot: null");
  const std::span bytes(static_cast<const std::byte*>(snapshot), size);
  const kernel::SnapshotFault fault = kernel::fault_of(bytes);
  if (fault != kernel::SnapshotFault::none) return why.because(OPENEVC_REFUSED, kernel::name(fault));
  // Nothing is read in memory that may never have held a unit.
  auto* const u = new (memory) openevc_unit;
  static_cast<void>(kernel::restore(u->unit, bytes));  // without a fault, as asked above
  u->tag = openevc_unit::kTag;
  *unit = u;
  return OPENEVC_OK;
}
