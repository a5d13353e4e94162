#pragma once
#include <cstdint>
#include <span>

#include "lang/schema.h"

namespace evc::lang {

/// The meaning of a number on the wire.
enum class Kind : std::uint8_t {
  acceleration,
  bcd,        ///< decimal digits, one in four bits, filled up with F
  bitset,     ///< one meaning per bit, VariableInfo::bit_meanings
  character,  ///< ISO 8859-1
  current,
  distance,     ///< VariableInfo::by_scale: counts of Q_SCALE
  enumeration,  ///< VariableInfo::codes is the whole list
  factor,
  gradient,
  identity,
  length,
  mass,
  number,
  speed,
  table,  ///< VariableInfo::numbers gives the number of each code
  time,
  version,  ///< X.Y, see system_version()
};

struct Meaning {
  std::uint64_t code;
  const char* text;
};
struct CodeNumber {
  std::uint64_t code;
  double number;
};

/// One row of SUBSET-026-7 7.5 as data. All texts are literals.
struct VariableInfo {
  const char* key;   ///< the name of its type in lang::var
  const char* name;  ///< the standard's name (without _V1)
  unsigned bits;
  bool is_signed;  ///< two's complement
  Kind kind;
  const char* unit;   ///< "" if none
  double resolution;  ///< of one count, in `unit`; 0 if there is none or `by_scale`
  bool by_scale;      ///< the resolution is 0.1 m, 1 m or 10 m by Q_SCALE
  std::uint64_t max;  ///< greatest ordinary code
  std::span<const Meaning> special;
  std::span<const Meaning> codes;
  std::span<const Meaning> bit_meanings;  ///< Meaning::code is the number of the bit, 0 the least significant
  std::span<const CodeNumber> numbers;
  std::span<const Range> spare;
  Versions versions;
  const char* about;
  const char* ref;
  const char* note;
};

/// All variables, in the order of 7.5.
std::span<const VariableInfo> variables();
/// The row of the variable with this key, or of the newest with this name; null if there is none.
const VariableInfo* find_variable(const char* key);

}  // namespace evc::lang
