#include "capi/inputs.h"

#include <cmath>
#include <cstring>

#include "capi/codes.h"
#include "io/json.h"
#include "io/train_file.h"
#include "lang/schema.h"

namespace evc::capi {
namespace {

/// Inputs of a program with an older header are shorter: members it does not have keep their
/// defaults.
bool take_struct(openevc_inputs& ours, const openevc_inputs* theirs) {
  openevc_inputs_init(&ours, sizeof ours);
  if (theirs == nullptr || theirs->size < sizeof theirs->size) return false;
  std::memcpy(&ours, theirs, theirs->size < sizeof ours ? theirs->size : sizeof ours);
  return true;
}

/// A block of docs/train.md, not checked.
openevc_result read_train_data(std::optional<train::TrainData>& data, const char* text, std::size_t length,
                               const char* name, Why why) {
  const auto train = io::guarded([&] {
    const io::Json document = io::parse_json({text, length}, name);
    return io::read_entered_train(io::JsonPlace(document, name));
  });
  if (!train) return why.because(OPENEVC_REFUSED, train.error().text());
  data = train->data;
  return OPENEVC_OK;
}

ConsistEnd of(const openevc_consist_end& end) { return {{end.nominal}, {end.min}, {end.max}}; }

/// False: not all of them are given, or not as they have to be.
bool take_consist(std::optional<ConsistLength>& to, const openevc_inputs& in) {
  const auto absent = [](const openevc_consist_end& end) {
    return std::isnan(end.nominal) && std::isnan(end.min) && std::isnan(end.max);
  };
  to.reset();
  if (absent(in.consist_front) && absent(in.consist_rear)) return true;
  to = ConsistLength{of(in.consist_front), of(in.consist_rear)};
  return is_possible(to->front) && is_possible(to->rear);
}

const char* take_signals(kernel::TrainSignals& s, const openevc_inputs& in) {
  s.powered = in.powered != 0;
  s.isolated = in.isolated != 0;
  s.desk_open = in.desk_open != 0;
  if (in.cab > 1) return "inputs.cab: not 0 or 1";
  s.cab = in.cab == 0 ? kernel::Cab::A : kernel::Cab::B;
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
  s.radio_registered = in.radio_registered != 0;
  if (in.integrity < OPENEVC_INTEGRITY_UNKNOWN || in.integrity > OPENEVC_INTEGRITY_LOST)
    return "inputs.integrity: not an openevc_integrity";
  s.integrity = static_cast<TrainIntegrity>(in.integrity);
  if (!std::isnan(in.length_confirmed)) s.length_confirmed = {in.length_confirmed};
  if (!take_consist(s.consist, in)) return "inputs.consist: not six numbers 0 <= min <= nominal <= max <= 4095";
  return nullptr;
}

// The following return what is wrong; null where everything is as it has to be.
static_assert(OPENEVC_RECEIVED == 64, "in the texts below");

std::optional<kernel::RbcIdentity> of(const openevc_rbc& rbc) {
  if (rbc.given == 0) return std::nullopt;
  kernel::RbcIdentity identity;
  identity.NID_C = rbc.NID_C;
  identity.NID_RBC = rbc.NID_RBC;
  return identity;
}

const char* take_telegrams(Cycle& cycle, const openevc_inputs& in) {
  if (in.telegrams_count > 0 && in.telegrams == nullptr) return "inputs.telegrams: null";
  if (in.telegrams_count > cycle.telegrams.capacity()) return "inputs.telegrams: more than 64";
  for (std::size_t i = 0; i < in.telegrams_count; ++i) {
    const openevc_telegram& from = in.telegrams[i];
    if (from.bytes == nullptr && from.bits != 0) return "inputs.telegrams: without bytes";
    kernel::BaliseTelegram& telegram = *cycle.telegrams.grow();
    telegram = {};
    telegram.bytes = {from.bytes, (std::size_t{from.bits} + 7) / 8};
    telegram.bits = from.bits;
    telegram.at = {{from.at}};
    if (in.telegrams_passed != nullptr && !std::isnan(in.telegrams_passed[i]))
      telegram.passed = Duration{in.telegrams_passed[i]};
  }
  cycle.inputs.balise_telegrams = {cycle.telegrams.begin(), cycle.telegrams.size()};
  return nullptr;
}

const char* take_loops(Cycle& cycle, const openevc_inputs& in) {
  if (in.loops_count > 0 && in.loops == nullptr) return "inputs.loops: null";
  if (in.loops_count > cycle.loops.capacity()) return "inputs.loops: more than 64";
  for (std::size_t i = 0; i < in.loops_count; ++i) {
    if (in.loops[i].bytes == nullptr) return "inputs.loops: without bytes";
    *cycle.loops.grow() = {.bytes = {in.loops[i].bytes, in.loops[i].size}};
  }
  cycle.inputs.loop_messages = {cycle.loops.begin(), cycle.loops.size()};
  return nullptr;
}

const char* take_radio(Cycle& cycle, const openevc_inputs& in) {
  if (in.radio_count > 0 && in.radio == nullptr) return "inputs.radio: null";
  if (in.radio_count > cycle.radio.capacity()) return "inputs.radio: more than 64";
  for (std::size_t i = 0; i < in.radio_count; ++i) {
    if (in.radio[i].bytes == nullptr) return "inputs.radio: without bytes";
    kernel::RadioMessage& message = *cycle.radio.grow();
    message = {};
    message.bytes = {in.radio[i].bytes, in.radio[i].size};
    if (in.radio_from != nullptr) message.from = of(in.radio_from[i]);
    message.infill_unit = in.radio_from != nullptr && in.radio_from[i].infill_unit == 1;
  }
  cycle.inputs.radio_messages = {cycle.radio.begin(), cycle.radio.size()};
  if (in.link < OPENEVC_LINK_UNCHANGED || in.link > OPENEVC_LINK_REFUSED) return "inputs.link: not an openevc_link";
  cycle.inputs.radio_link = static_cast<RadioLink>(in.link);
  cycle.inputs.radio_link_with = of(in.link_with);
  cycle.inputs.radio_link_of_infill_unit = in.link_with.infill_unit == 1;
  return nullptr;
}

bool entered(const openevc_inputs& in, openevc_entry entry) { return ((in.entered >> entry) & 1u) != 0; }

DriverId driver_id_of(const openevc_inputs& in) {
  DriverId id;
  std::memcpy(id.characters.data(), in.driver_id_text, DriverId::kMost);
  if (id.characters[0] != '\0') return id;
  std::size_t size = 0;
  for (int shift = 28; shift >= 0; shift -= 4)
    if (const std::uint32_t digit = (in.driver_id >> shift) & 15u; digit < 10)
      id.characters[size++] = static_cast<char>('0' + digit);
  return id;
}

const char* take_driver(kernel::DriverActions& driver, const openevc_inputs& in) {
  driver.selected = in.selected;
  driver.acknowledged = in.acknowledged;
  if (in.acknowledged_text > kernel::kLastStatusId) return "inputs.acknowledged_text: no such id";
  driver.acknowledged_text = in.acknowledged_text;
  if (entered(in, OPENEVC_ENTRY_DRIVER_ID)) driver.driver_id = driver_id_of(in);
  if (entered(in, OPENEVC_ENTRY_TRAIN_RUNNING_NUMBER)) driver.train_running_number = in.train_running_number;
  if (entered(in, OPENEVC_ENTRY_LEVEL)) {
    if (in.level < OPENEVC_L0 || in.level > OPENEVC_L3) return "inputs.level: not an openevc_level";
    if (in.NID_NTC > 255) return "inputs.NID_NTC: above 255";
    driver.level = static_cast<Level>(in.level);
    driver.nid_ntc = static_cast<std::uint8_t>(in.NID_NTC);
  }
  if (entered(in, OPENEVC_ENTRY_RBC_CONTACT)) {
    if (in.NID_C > 1023) return "inputs.NID_C: above 1023";
    if (in.NID_RBC > 16383) return "inputs.NID_RBC: above 16383";
    if (lang::is_in(lang::decimal_digits, in.NID_RADIO)) return "inputs.NID_RADIO: a digit from A to E (7.5.1.95)";
    kernel::DriverActions::RbcContact& contact = driver.rbc_contact.emplace();
    contact.NID_C = in.NID_C;
    contact.NID_RBC = in.NID_RBC;
    contact.NID_RADIO = in.NID_RADIO;
  }
  if (entered(in, OPENEVC_ENTRY_VBC)) {
    if (in.VBC_NID_C > 1023) return "inputs.VBC_NID_C: above 1023";
    if (in.VBC_NID_VBCMK > 63) return "inputs.VBC_NID_VBCMK: above 63";
    kernel::DriverActions::Cover& cover = driver.cover.emplace();
    cover.NID_C = in.VBC_NID_C;
    cover.NID_VBCMK = in.VBC_NID_VBCMK;
    cover.T_VBC = in.VBC_T_VBC;
  }
  if (entered(in, OPENEVC_ENTRY_NETWORK)) {
    if (in.network > 0xFFFFFF) return "inputs.network: above 24 bits";
    driver.network = in.network;
  }
  if (entered(in, OPENEVC_ENTRY_LANGUAGE)) driver.language = Language{{in.language[0], in.language[1]}};
  if (entered(in, OPENEVC_ENTRY_SET_SPEED)) driver.set_speed = Speed{in.set_speed};
  if (entered(in, OPENEVC_ENTRY_SR_SPEED)) driver.V_sr = Speed{in.V_sr};
  if (entered(in, OPENEVC_ENTRY_SR_DISTANCE)) driver.D_sr = Distance{in.D_sr};
  if (entered(in, OPENEVC_ENTRY_TRAIN_DATA) && in.train_data == nullptr) return "inputs.train_data: null";
  return nullptr;
}

/// The texts: the only part that needs the heap.
openevc_result take_train_data(Cycle& cycle, const openevc_inputs& in, Why why) {
  if (entered(in, OPENEVC_ENTRY_TRAIN_DATA)) {
    const openevc_result read =
        read_train_data(cycle.train, in.train_data, in.train_data_length, "inputs.train_data", why);
    if (read != OPENEVC_OK) return read;
    cycle.inputs.driver.train_data = &*cycle.train;
  }
  if (in.external_train_data != nullptr) {
    const openevc_result read = read_train_data(cycle.external_train, in.external_train_data,
                                                in.external_train_data_length, "inputs.external_train_data", why);
    if (read != OPENEVC_OK) return read;
    kernel::ExternalTrainData& external = cycle.inputs.external_train_data;
    external.data = &*cycle.external_train;
    external.driver_validates = in.external_data_trusted == 0;
  }
  return OPENEVC_OK;
}

const char* take_states(kernel::Inputs& to, const openevc_inputs& in) {
  to.now = {in.now};
  to.odometry.nominal = {{in.nominal}};
  to.odometry.min = {{in.min}};
  to.odometry.max = {{in.max}};
  to.odometry.V_est = {in.V_est};
  to.odometry.V_min = {in.V_min};
  to.odometry.V_max = {in.V_max};
  to.odometry.A_est = {in.A_est};
  if (!std::isnan(in.measured)) to.odometry.measured = Duration{in.measured};
  to.windows = Set<kernel::Window>::of_bits(in.open_windows);
  to.national_system.available = in.national_systems;
  to.national_system.trip_active = in.national_trip != 0;
  to.national_system.service_brake = in.national_service_brake != 0;
  to.national_system.emergency_brake = in.national_emergency_brake != 0;
  to.automatic_operation.requests_AD = in.ato_requests_AD != 0;
  to.automatic_operation.active = in.ato_active != 0;
  to.safety_fault = in.safety_fault != 0;
  if (in.moved < OPENEVC_MOVEMENT_UNKNOWN || in.moved > OPENEVC_MOVED) return "inputs.moved: not an openevc_movement";
  if (in.utc_given != 0) to.utc = in.utc;
  if (in.moved != OPENEVC_MOVEMENT_UNKNOWN) to.moved = in.moved == OPENEVC_MOVED;
  return nullptr;
}

}  // namespace

openevc_result take_inputs(Cycle& cycle, const openevc_inputs* inputs, Why why) {
  openevc_inputs in;
  if (!take_struct(in, inputs)) return why.because(OPENEVC_BAD_ARGUMENT, "inputs: null, or its size is not set");
  for (const char* wrong :
       {take_telegrams(cycle, in), take_loops(cycle, in), take_radio(cycle, in), take_signals(cycle.inputs.train, in),
        take_driver(cycle.inputs.driver, in), take_states(cycle.inputs, in)})
    if (wrong != nullptr) return why.because(OPENEVC_BAD_ARGUMENT, wrong);
  return take_train_data(cycle, in, why);
}

}  // namespace evc::capi
