#include <cstring>
#include <new>

#include "kernel/state.h"
#include "kernel/state_layout.h"
#include "openevc/evc.h"

namespace evc::kernel {
namespace {

/// The contents of a Unit's memory.
struct Content {
  State state;
  Derived derived;
};
static_assert(std::is_trivially_copyable_v<Content>);
static_assert(sizeof(Content) <= Unit::kBytes && sizeof(Content) + 16 * 1024 > Unit::kBytes,
              "Unit::kBytes follows the size of State and Derived");
static_assert(alignof(Content) <= Unit::kAlignment);

/// Before the State in a snapshot. A number of another byte order is another magic.
struct SnapshotHead {
  std::uint64_t magic = 0x4F50454E45564331;  // "OPENEVC1"
  std::uint32_t format = 1;                  // of this head
  std::uint32_t state_bytes = sizeof(State);
  std::uint64_t layout = EVC_STATE_LAYOUT;
  std::uint64_t checksum = 0;  // of the State's bytes
};
static_assert(sizeof(SnapshotHead) == 32 && std::is_trivially_copyable_v<SnapshotHead>);
static_assert(sizeof(State) % 8 == 0, "checksum_of reads eight bytes at a time");

/// FNV-1a, eight bytes at a time: detects damage by storage and transport, not forgery.
std::uint64_t checksum_of(std::span<const std::byte> bytes) {
  std::uint64_t sum = 0xCBF29CE484222325;
  for (std::size_t i = 0; i < bytes.size(); i += 8) {
    std::uint64_t word{};
    std::memcpy(&word, bytes.data() + i, sizeof word);
    sum = (sum ^ word) * 0x100000001B3;
  }
  return sum;
}

std::span<const std::byte> state_in(std::span<const std::byte> snapshot) {
  return snapshot.subspan(sizeof(SnapshotHead), sizeof(State));
}

}  // namespace

/// The only access to the contents of a Unit.
struct UnitAccess {
  static Content& of(Unit& unit) { return *std::launder(reinterpret_cast<Content*>(unit.memory_)); }
  static const Content& of(const Unit& unit) { return *std::launder(reinterpret_cast<const Content*>(unit.memory_)); }
};

Unit::Unit() noexcept { new (memory_) Content; }

void power_up(Unit& unit, const Config& config) noexcept {
  Content& c = UnitAccess::of(unit);
  power_up(c.state, c.derived, config);
}

bool power_up(Unit& unit, const Config& config, const Retained& retained) noexcept {
  Content& c = UnitAccess::of(unit);
  return power_up(c.state, c.derived, config, retained);
}

Retained retained(const Unit& unit) noexcept { return retained(UnitAccess::of(unit).state); }

void step(Unit& unit, const Inputs& inputs, Outputs& outputs) noexcept {
  Content& c = UnitAccess::of(unit);
  step(c.state, c.derived, inputs, outputs);
}

bool plan(const Unit& unit, Planning& planning) noexcept {
  const Content& c = UnitAccess::of(unit);
  return plan(c.state, c.derived, planning);
}

void show(const Unit& unit, const Outputs& outputs, Display& display) noexcept {
  const Content& c = UnitAccess::of(unit);
  show(c.state, c.derived, outputs, display);
}

std::size_t snapshot_size() noexcept { return sizeof(SnapshotHead) + sizeof(State); }

bool snapshot(const Unit& unit, std::span<std::byte> out) noexcept {
  if (out.size() < snapshot_size()) return false;
  const std::span<std::byte> state = out.subspan(sizeof(SnapshotHead), sizeof(State));
  std::memcpy(state.data(), &UnitAccess::of(unit).state, sizeof(State));
  SnapshotHead head;
  head.checksum = checksum_of(state);
  std::memcpy(out.data(), &head, sizeof head);
  return true;
}

SnapshotFault fault_of(std::span<const std::byte> snapshot) noexcept {
  const SnapshotHead ours;
  SnapshotHead head;
  if (snapshot.size() < sizeof head) return SnapshotFault::too_short;
  std::memcpy(&head, snapshot.data(), sizeof head);
  if (head.magic != ours.magic) return SnapshotFault::not_a_snapshot;
  if (head.format != ours.format) return SnapshotFault::other_format;
  if (head.layout != ours.layout || head.state_bytes != ours.state_bytes) return SnapshotFault::other_layout;
  if (snapshot.size() < snapshot_size()) return SnapshotFault::too_short;
  return checksum_of(state_in(snapshot)) == head.checksum ? SnapshotFault::none : SnapshotFault::damaged;
}

SnapshotFault restore(Unit& unit, std::span<const std::byte> snapshot) noexcept {
  const SnapshotFault fault = fault_of(snapshot);
  if (fault != SnapshotFault::none) return fault;
  Content& c = UnitAccess::of(unit);
  std::memcpy(&c.state, state_in(snapshot).data(), sizeof(State));
  new (&c.derived) Derived;  // built again in the next cycle; too large for the stack
  return SnapshotFault::none;
}

}  // namespace evc::kernel
