#pragma once
/// The on-board unit: one deterministic function of a state and the inputs of a cycle. Link openevc::kernel.
///
///     auto unit = std::make_unique<evc::kernel::Unit>();   // or anywhere else: it is plain memory
///     evc::kernel::power_up(*unit, config);
///     for (;;) {                                            // every cycle, of 100 ms for instance
///       evc::kernel::step(*unit, inputs, outputs);
///     }
///
/// The only inputs and outputs are Config, Inputs and Outputs: no clock, no file, no thread, no random number, no heap,
/// no exception, no state outside the Unit. Different threads may use different units at the same time; one unit is
/// used by one thread at a time. Quantities are SI and carry their dimension (openevc/base/units.h); enumerations have
/// the standard's names and codes.
#include <cstddef>
#include <cstdint>
#include <span>

#include "openevc/kernel/port.h"

namespace evc::kernel {

/// A whole on-board unit as plain memory: it may be stored anywhere, be copied as bytes, and needs no destruction. A
/// copy is a unit that continues from the same moment. Too large for a small stack.
class Unit {
 public:
  static constexpr std::size_t kBytes = 352 * 1024;
  static constexpr std::size_t kAlignment = 16;

  /// Not powered up: call power_up before the first step.
  Unit() noexcept;

 private:
  friend struct UnitAccess;
  alignas(kAlignment) std::byte memory_[kBytes];
};

/// Puts the unit into its state after power-up: mode SB is entered from NP in the first cycle (4.6.3 [4]). If
/// `train::check` rejects the train data or national values, it enters SF instead ([13]).
void power_up(Unit& unit, const Config& config) noexcept;

/// The same with what the unit kept without power: it replaces the national values of the configuration, and `moved` of
/// the inputs decides on position, level and RBC contact (4.11). False: no unit gives such data; they are not used, as
/// after their loss (3.18.2.5).
[[nodiscard]] bool power_up(Unit& unit, const Config& config, const Retained& retained) noexcept;
/// What is kept when the power goes off now, or went off before: to be stored until the next power-up.
Retained retained(const Unit& unit) noexcept;

/// One cycle. Total, deterministic, allocation-free; equal (unit, inputs) give equal results. Times, places and speeds
/// that are not numbers, beyond 10^9 s, 10^9 m or 1000 m/s, outside their bounds, or earlier than in the last cycle
/// lead to SF (4.4.5).
void step(Unit& unit, const Inputs& inputs, Outputs& outputs) noexcept;

/// The advance display (3.15.10) after the last step, computed now. False where there is none: in another mode than FS
/// and OS, without an authority, and between `restore` and the next step.
[[nodiscard]] bool plan(const Unit& unit, Planning& planning) noexcept;

/// The record of the display (015560) after the last step, whose outputs are `outputs`: what the mode shows (4.7.2),
/// whether the driver has toggled it on or not. With a closed desk nothing is shown but the system failure and the
/// isolation: the record then is of mode NP. Of `display.config` the edition, the dial, the names of national systems,
/// the radio systems and T_dispTTI are written; the rest is the host's.
void show(const Unit& unit, const Outputs& outputs, Display& display) noexcept;

/// A snapshot is the whole state of the unit, preceded by a header that identifies the format and the build; in the
/// byte order of this machine, to be stored or passed to another process.
std::size_t snapshot_size() noexcept;
/// False, with nothing written, if `out` has fewer than snapshot_size() bytes.
[[nodiscard]] bool snapshot(const Unit& unit, std::span<std::byte> out) noexcept;

/// Why a snapshot is refused.
enum class SnapshotFault : std::uint8_t {
  none,
  too_short,       ///< fewer bytes than its header says, or than a header has
  not_a_snapshot,  ///< other data, or a machine with another byte order
  other_format,    ///< made by a version of openevc with another header
  other_layout,    ///< made by a build whose unit is laid out differently
  damaged          ///< the checksum is not that of the content
};
/// "damaged".
constexpr const char* name(SnapshotFault fault) {
  constexpr const char* kNames[] = {
      "",       "too short", "not a snapshot of a unit", "of another format", "of a unit that is laid out differently",
      "damaged"};
  return kNames[static_cast<std::size_t>(fault)];
}
/// Whether a unit of this build can be restored from it. Detects damage by storage and transport, not forgery.
[[nodiscard]] SnapshotFault fault_of(std::span<const std::byte> snapshot) noexcept;
/// The unit continues from the moment of the snapshot; with any fault it stays unchanged.
[[nodiscard]] SnapshotFault restore(Unit& unit, std::span<const std::byte> snapshot) noexcept;

}  // namespace evc::kernel
