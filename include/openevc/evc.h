#pragma once
/// The on-board unit: one deterministic function of a state and the inputs of a cycle. Link openevc::kernel.
///
///     auto unit = std::make_unique<evc::kernel::Unit>();   // or anywhere else: it is plain memory
///     evc::kernel::power_up(*unit, config);
///     for (;;) {                                            // every config.cycle
///       evc::kernel::step(*unit, inputs, outputs);
///     }
///
/// Nothing goes in or out but Config, Inputs and Outputs: no clock, no file, no thread, no random number, no heap, no
/// exception, no state outside the Unit. Units may be used from any threads at the same time, each by one at a time.
/// Quantities are SI and carry their dimension (openevc/base/units.h); enumerations have the standard's names and
/// codes.
#include <cstddef>
#include <cstdint>
#include <span>

#include "openevc/kernel/port.h"

namespace evc::kernel {

/// All of one on-board unit, as plain memory: it may lie anywhere, be copied as bytes, and needs no end. A copy is a
/// unit that goes on from the same moment. Large: not for a small stack.
class Unit {
 public:
  static constexpr std::size_t kBytes = 336 * 1024;
  static constexpr std::size_t kAlignment = 16;

  /// Not powered up: power_up comes before the first step.
  Unit() noexcept;

 private:
  friend struct UnitAccess;
  alignas(kAlignment) std::byte memory_[kBytes];
};

/// Puts the unit into its state after power-up: mode SB is entered from NP in the first cycle (4.6.3 [4]). With train
/// data or national values that `train::check` refuses it goes to SF then ([13]).
void power_up(Unit& unit, const Config& config) noexcept;

/// One cycle. Total, deterministic, allocation-free; equal (unit, inputs) give equal results. Times, places and speeds
/// that are not numbers, out of all range (10^9 s or m, 1000 m/s), not between their bounds or before the last cycle's
/// lead to SF (4.4.5).
void step(Unit& unit, const Inputs& inputs, Outputs& outputs) noexcept;

/// A snapshot is all that the unit remembers, behind a head that says what made it; bytes of this machine, for storing
/// and for another process.
std::size_t snapshot_size() noexcept;
/// False, and nothing written, where `out` has less than snapshot_size().
[[nodiscard]] bool snapshot(const Unit& unit, std::span<std::byte> out) noexcept;

/// Why a snapshot is refused.
enum class SnapshotFault : std::uint8_t {
  none,
  too_short,       ///< fewer bytes than its head says, or than a head has
  not_a_snapshot,  ///< other bytes, or a machine with another byte order
  other_format,    ///< made by a version of openevc with another head
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
/// The unit goes on from the moment of the snapshot; with any fault it is as it was. Finds what storage and transport
/// damage, not what somebody forges.
[[nodiscard]] SnapshotFault restore(Unit& unit, std::span<const std::byte> snapshot) noexcept;

}  // namespace evc::kernel
