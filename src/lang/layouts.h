#pragma once
#include <cstdint>
#include <span>

#include "lang/schema.h"

// The layouts of all packets and messages as data, derived from `layout_of<>`: for views, pages and
// tests, which read bits by them without the structs.
namespace evc::lang {

/// One step of a layout, in the order of chapter 7. A structure is a list of steps; a condition covers
/// the `count` steps after it, a repetition refers to the list of its element.
struct Step {
  enum class Kind : std::uint8_t { field, when, when_around, repeat, rest };
  Kind kind = Kind::field;
  std::uint8_t bits = 0;       ///< field: width; repeat: width of the counter
  std::uint8_t condition = 0;  ///< when: the step of this list whose code is tested
  std::uint8_t count = 0;      ///< when, when_around: number of the following steps that depend on it
  std::uint16_t capacity = 0;  ///< repeat: maximum number of elements
  Test test{};                 ///< when, when_around
  const char* name = "";       ///< member name; repeat: name of the group
  const char* variable =
      "";                    ///< field: its type in lang::var; when_around: the one tested; repeat: that of the counter
  const char* counter = "";  ///< repeat: name of the counter
  bool (*is_spare)(std::uint64_t) = nullptr;  ///< field with spare codes
  const Step* body = nullptr;                 ///< repeat: the element
  std::uint8_t body_size = 0;
  constexpr std::span<const Step> element() const { return {body, body_size}; }
};

struct PacketLayout {
  const PacketInfo* info;
  const char* type;             ///< name of the struct
  bool has_length;              ///< false: no Q_DIR and no L_PACKET (packets 0 to the train, 255)
  bool has_direction;           ///< Q_DIR comes first in `steps` and, on the wire, before L_PACKET
  std::span<const Step> steps;  ///< without NID_PACKET and L_PACKET
};
struct MessageLayout {
  const MessageInfo* info;
  const char* type;
  std::span<const Step> steps;  ///< from after L_MESSAGE up to the packets
};

/// Track to train first, in the order of their numbers, the newest layout of a packet first.
std::span<const PacketLayout> packet_layouts();
std::span<const MessageLayout> message_layouts();
/// Null: none in this version (one bit of Versions).
const PacketLayout* find_packet_layout(Direction direction, Versions version, std::uint8_t nid);
/// With an unknown X in `sv` the newest form is returned.
const MessageLayout* find_message_layout(Direction direction, SystemVersion sv, std::uint8_t nid);

}  // namespace evc::lang
