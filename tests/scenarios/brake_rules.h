#pragma once
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/location.h"
#include "port/inputs.h"
#include "port/outputs.h"
#include "terms/cause.h"
#include "terms/level.h"
#include "terms/mode.h"
#include "terms/srs_version.h"

// What the standard says of each brake command (tests/reference/brake_causes.json), and whether the inputs and outputs
// of a unit keep to it, cycle by cycle. Nothing of src/brakes is used.
namespace evc::brake_rules {

/// One cycle from outside.
struct Cycle {
  const port::Inputs& in;
  const port::Outputs& now;
  Level level_before = Level::L0;
  Duration standing{};                     ///< since the train stands; none: it moves
  bool emergency_until_standstill = true;  ///< Q_NVEMRRLS 0, and the service brake has not been replaced (3.13.10)
  bool shown_speed_held = false;           ///< the permitted speed that is displayed may not rise (3.13.10.4.8.1)
  SrsVersion srs = SrsVersion::v3_6_0;
  /// The longest way that the train can have run since the alarm of the balise antenna began; absent: there is none.
  std::optional<Distance> run_with_alarm = {};
  bool between_moving_and_standing() const;  ///< the unit may see it as either
};

/// Whether a condition of a release rule is fulfilled; absent: the unit may see it either way.
using Condition = std::function<std::optional<bool>(const Cycle&)>;
struct NamedCondition {
  std::string name;
  Condition holds;
};
/// All conditions of a way are needed; each way is enough.
using Way = std::vector<NamedCondition>;

/// 4.12: R revoked, M maintained, P maintained unless from PT, O as M unless the train is turned, T evaluated again, L
/// revoked in levels 1 to 3 and maintained in the others, - grey; empty: no row.
using Marks = std::array<char, kModes>;
struct Rule {
  std::string id, brake, clause;
  std::string clause_4_0_0;  ///< empty: the same paragraph as in 3.x
  std::vector<Way> ways;
  Marks marks{};
  std::optional<Marks> marks_4_0_0;       ///< absent: the same as in 3.x
  std::optional<Level> of_level;          ///< in which 4.12 has the row
  std::optional<Set<Mode>> grey_revoked;  ///< chosen; absent: the command lasts as long as it is asked for
  bool acknowledged_at_standstill() const;
  const std::string& clause_in(SrsVersion srs) const;
  const Marks& marks_in(SrsVersion srs) const;
  /// What mode entries are named with in `Seen`: the id, with the issue where its marks are of one.
  std::string entries_in(SrsVersion srs) const;
};
/// In the order of `Cause`.
const std::vector<Rule>& rules();
std::string name_of(const Way& way);

/// What is known of a unit between two cycles.
struct Memory {
  SrsVersion srs = SrsVersion::v3_6_0;
  Set<Cause> commanded;
  Mode mode = Mode::NP;
  Level level = Level::L0;
  Set<Cause> entering;  ///< commanded when `mode` was entered from mode `from`, and not judged yet
  Mode from = Mode::NP;
  bool turned = false;  ///< the train, in the cycle in which `mode` was entered
  std::optional<Duration> standing_since;
  std::optional<OdometerReading> alarm_since;  ///< when the alarm of the balise antenna began
  std::optional<Speed> V_P;                    ///< displayed
};

/// What has been seen, each with the first place: "ID in MODE", "ID without CONDITION", "ID by WAY", "ENTRIES kept
/// MODE", "ENTRIES revoked MODE"; "from PT" behind the last two if so. ENTRIES: Rule::entries_in.
using Seen = std::map<std::string, std::string>;

/// One cycle of a unit. Returns the faults: commands that ended too early or too late, or that a mode entry should have
/// revoked or maintained.
std::vector<std::string> look(Memory& memory, const port::Inputs& in, const port::Outputs& now,
                              bool emergency_until_standstill, Seen* seen = nullptr, const std::string& place = {});

}  // namespace evc::brake_rules
