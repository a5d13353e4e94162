#include <cstring>

#include "capi/guard.h"
#include "capi/inputs.h"
#include "capi/outputs.h"
#include "io/input_stream.h"
#include "openevc/evc.h"
#include "openevc/terms/button.h"

using evc::capi::Why;
namespace kernel = evc::kernel;

/// The unit and its outputs, without pointers: it may be moved as bytes.
struct openevc_unit {
  static constexpr std::uint64_t kTag = 0x6F6576635F756E69;  // "oevc_uni"
  std::uint64_t tag = 0;
  kernel::Unit unit;
  kernel::Outputs outputs;
  openevc_outputs given{};
  kernel::Planning planning;
  openevc_planning planned{};
  kernel::Display display;
  openevc_display displayed{};
};
static_assert(std::is_trivially_copyable_v<openevc_unit>);
static_assert(alignof(openevc_unit) <= evc::capi::kAlignment);

namespace {

bool usable(const openevc_unit* unit) {
  return unit != nullptr && evc::capi::aligned(unit) && unit->tag == openevc_unit::kTag;
}
constexpr const char* kNoUnit = "unit: null or not powered up";

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
    config.terminals = read->terminals.value_or(1);
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
  in.radio_registered = signals.radio_registered;
  in.direction = 1;
  in.regenerative_brake_active = in.eddy_current_brake_active = in.magnetic_shoe_brake_active = in.ep_brake_active = 1;
  in.brake_pressure_kpa = in.length_confirmed = in.measured = evc::capi::kNone;
  in.consist_front = in.consist_rear = {evc::capi::kNone, evc::capi::kNone, evc::capi::kNone};
  in.size = size;
  std::memcpy(inputs, &in, size < sizeof in ? size : sizeof in);
  return OPENEVC_OK;
}

openevc_result openevc_step(openevc_unit* unit, const openevc_inputs* inputs, openevc_outputs* outputs, char* why_text,
                            size_t why_size) noexcept {
  const Why why{why_text, why_size};
  if (!usable(unit)) return why.because(OPENEVC_BAD_ARGUMENT, kNoUnit);
  if (outputs == nullptr || outputs->size < sizeof outputs->size)
    return why.because(OPENEVC_BAD_ARGUMENT, "outputs: null, or its size is not set");
  evc::capi::Cycle cycle;
  const openevc_result taken = evc::capi::guarded(why, [&] { return evc::capi::take_inputs(cycle, inputs, why); });
  if (taken != OPENEVC_OK) return taken;
  // From here on nothing can fail and nothing is allocated: what the unit has decided reaches the caller.
  kernel::step(unit->unit, cycle.inputs, unit->outputs);
  evc::capi::give_outputs(unit->given, unit->outputs);
  evc::capi::give(outputs, unit->given);
  return OPENEVC_OK;
}

openevc_result openevc_plan(openevc_unit* unit, openevc_planning* planning) noexcept {
  if (!usable(unit) || planning == nullptr || planning->size < sizeof planning->size) return OPENEVC_BAD_ARGUMENT;
  const bool given = kernel::plan(unit->unit, unit->planning);
  evc::capi::give_planning(unit->planned, given ? &unit->planning : nullptr);
  evc::capi::give(planning, unit->planned);
  return OPENEVC_OK;
}

openevc_result openevc_show(openevc_unit* unit, openevc_display* display) noexcept {
  if (!usable(unit) || display == nullptr || display->size < sizeof display->size) return OPENEVC_BAD_ARGUMENT;
  kernel::show(unit->unit, unit->outputs, unit->display);
  evc::capi::give_display(unit->displayed, unit->display);
  evc::capi::give(display, unit->displayed);
  return OPENEVC_OK;
}

const char* openevc_button_name(int32_t button) noexcept {
  if (button < 0 || button >= int(evc::Button::count)) return nullptr;
  return evc::name(static_cast<evc::Button>(button));
}

const char* openevc_cause_name(int32_t cause) noexcept {
  if (cause < 0 || cause >= int(evc::Cause::count)) return nullptr;
  return evc::name(static_cast<evc::Cause>(cause));
}

const char* openevc_status_text_name(int32_t text) noexcept {
  if (text < 0 || text >= int(evc::StatusText::count)) return nullptr;
  return evc::name(static_cast<evc::StatusText>(text));
}

const char* openevc_output_name(int32_t output) noexcept {
  if (output < 0 || output >= int(evc::DriverOutput::count)) return nullptr;
  return evc::name(static_cast<evc::DriverOutput>(output));
}
const char* openevc_input_name(int32_t input) noexcept {
  if (input < 0 || input >= int(evc::DriverInput::count)) return nullptr;
  return evc::name(static_cast<evc::DriverInput>(input));
}

openevc_dialogue_words openevc_dialogue(int32_t dialogue) noexcept {
  if (dialogue < 0 || dialogue >= int(evc::Dialogue::count)) return {};
  const evc::DialogueRow& row = evc::kDialogueRows[static_cast<std::size_t>(dialogue)];
  return {row.procedure, row.step, row.waits_for};
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
