#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/diagnostic.h"

// Scenarios as text (docs/scenarios.md): the contents of a file, read and checked, ready to be run.
namespace evc::scenario {

using Json = nlohmann::json;

/// The place of a statement. `called_from` is the statement that uses its block.
struct Place {
  std::string file;
  int line = 0;
  std::string called_from;  ///< "file:line", or nothing
  std::string text() const;
};

/// A set of alternatives of one value: a number with tolerance, a word, a text; the output of a cycle is compared with
/// it.
struct Wanted {
  enum class How : std::uint8_t { equal, above, below, between, has, lacks, absent };
  How how = How::equal;
  Json value;                              ///< number, text or true/false
  double upper = 0.0;                      ///< between
  double tolerance = 0.0;                  ///< equal, for numbers
  std::optional<std::int64_t> from_group;  ///< a place counted from this group (NID_BG)
  bool from_front = false;                 ///< a place counted from the estimated front end
};

/// Who is at the other end of the radio.
struct Partner {
  std::int64_t number = 0;   ///< NID_RBC, or
  bool infill_unit = false;  ///< NID_RIU
  const char* key() const { return infill_unit ? "NID_RIU" : "NID_RBC"; }
};

/// A message or packets that the on-board sends: the given members must be equal.
struct WantedMessage {
  int NID_MESSAGE = 0;
  std::optional<Partner> to;  ///< the recipient; absent: any
  Json members;               ///< name -> code
  std::vector<Json> packets;  ///< each with NID_PACKET and the given members
};

/// One condition on a cycle.
struct Condition {
  enum class What : std::uint8_t { output, event, message, call, hang_up, brakes };
  What what = What::output;
  bool negated = false;  ///< event, message, call: none since the last `when`
  std::string key;       ///< output: its name, nested names joined with a dot
  Wanted wanted;
  std::string pattern;    ///< event: with * for any characters
  WantedMessage message;  ///< message
  Json address;           ///< call, hang_up: the given members
  bool tco = false, sb = false, eb = false;
  std::vector<std::string> reasons;  ///< brakes: causes that have to be among those reported
};

/// What is wrong with the bits of a telegram or message on their way, beyond what can be encoded.
struct Damage {
  struct Bits {
    std::size_t first = 0, last = 0;
    std::uint64_t value = 0;
  };
  std::vector<Bits> bits;
  std::int64_t bytes = 0;  ///< message: so many more at the end; below 0: fewer
};

struct Balise {
  Json telegram;  ///< in the form of `evc encode balise`
  bool missing = false;
  bool spoiled = false;  ///< detected, but not decoded
  Damage damage;
};

/// The action of a `given` or `when`.
struct Action {
  enum class What : std::uint8_t { configure, message, loop, pass, lay, drive, stop, wait, input, odometer, restart };
  What what = What::wait;
  bool same_cycle = false;      ///< message, loop, input: in the cycle of the step before
  Json json;                    ///< configure, input: members; message, loop: in the form of `evc encode`
  bool T_TRAIN = false;         ///< message: T_TRAIN is the time of sending
  double ago_s = 0.0;           ///< message: so much before the time of the unit
  Damage damage;                ///< message
  bool NID_LRBG = false;        ///< message: NID_LRBG is the one last reported by the unit
  std::optional<Partner> from;  ///< message: the sender; absent: the RBC called last
  int answers = 0;              ///< message: T_TRAIN_REF is the T_TRAIN of the last message of this number sent
  std::int64_t NID_BG = 0;      ///< pass, lay
  std::vector<Balise> balises;  ///< pass, lay: in the order of N_PIG
  bool reversed = false;        ///< pass, lay: the balise with the greatest N_PIG comes first
  double ahead_m = 1.0;         ///< pass, lay: from the antenna, or
  std::optional<std::int64_t> from_group;  ///< lay: from the first balise of this group
  std::optional<double> v_mps;             ///< drive
  double a_mps2 = 1.0;                     ///< drive, stop
  std::optional<double> for_s;             ///< drive, wait
  std::optional<double> for_m;             ///< drive
  std::optional<Condition> until;
  double within_s = 60.0;       ///< with `until`
  std::optional<double> error;  ///< odometer: half of the interval per metre
  std::optional<double> reads;  ///< odometer: metres counted per metre
};

struct Statement {
  enum class Kind : std::uint8_t { given, when, then };
  Kind kind = Kind::given;
  Place at;
  std::string text;  ///< as written
  Action action;     ///< given, when
  Condition condition;
  std::vector<std::string> clauses;  ///< then
  std::optional<double> within_s;    ///< then: from now on, at the latest
  std::optional<double> for_s;       ///< then: in every cycle from now on
  bool in_block = false;
};

/// One `covers` entry of a scenario.
struct Cover {
  std::string kind;  ///< "message", "procedure", "stored", "brake", "step"
  std::string name;
};

struct Scenario {
  Place at;
  std::string name;
  std::vector<Cover> covers;
  std::string open;  ///< the finding for which it is expected to fail; nothing: it is expected to pass
  std::string srs;   ///< the issue, whatever `config` says; nothing: that of `config`
  std::vector<Statement> statements;
};

/// A line of a file cut into words, and the blocks that files share.
struct Token {
  enum class Kind : std::uint8_t { word, text, mark };
  Kind kind = Kind::word;
  std::string text;
  int line = 0;
};
using Line = std::vector<Token>;
struct Parameter {
  std::string name;
  Line value;
};
struct Block {
  Place at;
  std::string name;
  std::vector<Parameter> parameters;
  std::vector<Line> body;
};

struct File {
  std::vector<Block> blocks;
  std::vector<Scenario> scenarios;
};

/// Reads a file. Everything in it is checked: words, names of variables, packets, outputs. `library` holds the blocks
/// of files read before.
io::Result<File> read(std::string_view text, const std::string& file, const std::vector<Block>& library = {});

}  // namespace evc::scenario
