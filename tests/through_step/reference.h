#pragma once
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

// The language by the reference data of tests/reference alone: what is written and read here does not use the tables of
// the program.
namespace evc::through_step {

using Json = nlohmann::json;

/// tests/reference/NAME.json.
const Json& reference(const std::string& name);
/// The row of a variable of variables.json.
const Json& variable(const std::string& key);
std::uint64_t all_ones(unsigned bits);
bool is_spare(const Json& variable, std::uint64_t code);
/// Every code with a meaning of its own: the ends of the range, special values, lists, each bit of a set.
std::vector<std::uint64_t> codes_of(const Json& variable);
/// Both ends of each range of spare codes, and a digit A where only decimal digits have a meaning.
std::vector<std::uint64_t> spare_codes_of(const Json& variable);

/// Bits, the most significant first (7.3.2.10).
class BitList {
 public:
  void put(std::uint64_t code, unsigned bits);
  void replace(std::size_t at, std::uint64_t code, unsigned bits);
  std::size_t size() const { return bits_.size(); }
  std::vector<std::uint8_t> bytes() const;

 private:
  std::vector<bool> bits_;
};

/// Codes by the path of the field: "V_STATIC", in a repeated group "sections/D_STATIC".
using Codes = std::map<std::string, std::uint64_t>;

/// A field of a packet or message: its path, its variable, and the codes of other fields under which it is present.
struct Field {
  std::string path, variable;
  Codes needs;
  bool counter = false;  ///< of a repeated group
};
std::vector<Field> fields_of(const Json& elements);

/// The packet or message of that number in a system version "X.Y"; null if there is none.
const Json* find_packet(const std::string& direction, unsigned NID_PACKET, const std::string& sv);
const Json* find_message(const std::string& direction, unsigned NID_MESSAGE, const std::string& sv);

/// A code that is valid where nothing is said.
std::uint64_t usual(const std::string& variable, const std::string& name);

/// The code of a distance in metres.
std::uint64_t in_scale(std::uint64_t metres, std::uint64_t Q_SCALE);

/// Writes a packet with its L_PACKET, plus `wrong_length`.
void put_packet(BitList& to, const Json& packet, const Codes& codes, int wrong_length = 0);
/// Writes a message with its L_MESSAGE and padding; `packets` are written behind its fields.
BitList message_bits(const Json& message, const Codes& codes, const BitList& packets);
void append(BitList& to, const BitList& what);

/// The codes of a message of the on-board with its packets; fails the test where a bit is left over.
struct Decoded {
  Codes codes;
  std::vector<std::pair<unsigned, Codes>> packets;
  bool complete = false;
  const Codes* packet(unsigned NID_PACKET) const;
};
Decoded decode_to_track(const std::vector<std::uint8_t>& bytes, const std::string& sv);

}  // namespace evc::through_step
