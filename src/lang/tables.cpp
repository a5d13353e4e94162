#include "lang/fault.h"
#include "lang/message_table.h"
#include "lang/variable_table.h"

namespace evc::lang {
namespace {

bool equal(const char* a, const char* b) {
  for (; *a != '\0' && *a == *b; ++a, ++b) {
  }
  return *a == *b;
}

}  // namespace

const VariableInfo* find_variable(const char* key) {
  for (const VariableInfo& v : variables())
    if (equal(v.key, key)) return &v;
  for (const VariableInfo& v : variables())
    if (equal(v.name, key)) return &v;
  return nullptr;
}

const MessageRules* find_message_rules(Direction direction, std::uint8_t NID_MESSAGE, SystemVersion sv) {
  const Versions version = known_version(sv);
  for (const MessageRules& m : message_rules())
    if (m.direction == direction && m.NID_MESSAGE == NID_MESSAGE &&
        ((m.versions & version) != 0 || (version == 0 && m.version_invariant)))
      return &m;
  return nullptr;
}

const char* text_of(Fault fault) {
  switch (fault) {
    case Fault::none:
      return "no fault";
    case Fault::truncated:
      return "ends inside a variable";
    case Fault::spare_value:
      return "spare value";
    case Fault::length_mismatch:
      return "L_PACKET is not the length of the content";
    case Fault::length_too_small:
      return "L_PACKET less than the packet's header";
    case Fault::length_beyond_end:
      return "L_PACKET reaches beyond the end";
    case Fault::no_end_packet:
      return "no packet 255";
    case Fault::too_many_packets:
      return "more packets than can be held";
    case Fault::duplicate_packet:
      return "packet occurs twice for one direction";
    case Fault::wrong_medium:
      return "packet not allowed on this medium";
    case Fault::wrong_direction:
      return "transmission in the other direction";
    case Fault::wrong_place:
      return "packet must come first";
    case Fault::missing_packet:
      return "mandatory packet missing";
    case Fault::unexpected_packet:
      return "packet not allowed in this message";
    case Fault::unknown_message:
      return "unknown message";
    case Fault::message_length_mismatch:
      return "L_MESSAGE is not the length of the message";
    case Fault::unknown_version:
      return "unknown system version";
    case Fault::not_applicable:
      return "to be ignored by a unit of this version";
    case Fault::not_a_packet_of_this_kind:
      return "another packet";
  }
  return "";
}

}  // namespace evc::lang
