#pragma once
#include <string>
#include <vector>

#include "script.h"

// Words of a scenario and their conversion to codes of the ETCS language.
namespace evc::scenario {

/// Thrown inside the reader, which turns it into a Result.
struct ReadError {
  int line;
  std::string found, expected;
};

/// A value as written: a number with its unit, a word, a text, an object `{ NAME VALUE ... }` or a list `[ ... ]`.
struct Value {
  enum class Kind : std::uint8_t { number, word, text, object, list };
  Kind kind = Kind::word;
  int line = 0;
  double number = 0.0;
  std::string text;  ///< the word or text; for a number, as written
  std::string unit;
  std::string name;  ///< for a member of an object
  std::vector<Value> members;
  std::vector<Value> items;
};

/// Cuts a text into lines of words; text after `#` is a comment. A line continues while a brace or bracket is open.
std::vector<Line> cut(std::string_view text);

/// The words of one statement, taken from left to right.
class Words {
 public:
  explicit Words(const Line& line) : line_(line) {}
  bool end() const { return at_ == line_.size(); }
  int place() const;
  /// The next word, "" at the end; `ahead` words further on.
  const std::string& peek(std::size_t ahead = 0) const;
  bool next_is_text() const { return at_ < line_.size() && line_[at_].kind == Token::Kind::text; }
  /// Consumes the next word if it is this one.
  bool take(std::string_view word);
  void require(std::string_view word);
  std::string word(const char* expected);
  std::string text(const char* expected);
  /// One of these words, with its index.
  std::size_t one_of(std::initializer_list<const char*> words);
  double number(const char* expected);
  std::int64_t integer(std::int64_t least, std::int64_t most, const char* expected);
  /// A number with a unit of this kind, in SI units.
  double metres();
  double seconds();
  double speed();
  Value value();
  Value object();
  [[noreturn]] void fail(const std::string& expected) const;

 private:
  const Line& line_;
  std::size_t at_ = 0;
};

/// The number of a word; nothing if it is not a number.
std::optional<double> number_of(const std::string& word);
/// Of a unit: its value in SI units, and its quantity ('m', 's', 'v', 'g' gradient in per mille, 'a'); 0: no unit.
double unit_factor(const std::string& unit, char& kind);

/// As JSON of the files and streams: words are texts, numbers without their unit, `true`, `false`, `null`.
Json plain_json(const Value& value);

/// A packet to the train with defaults for all variables not given (docs/scenarios.md).
Json packet_json(std::uint8_t NID_PACKET, const Value* members, int line, int X, int Y);
/// The variables of a message to the train, without its packets.
Json message_json(std::uint8_t NID_MESSAGE, const Value* members, int line, int X, int Y);
/// The given members of a message of the on-board, as codes. `Q_SCALE` applies to distances.
Json sent_members(const Value& members);

}  // namespace evc::scenario
