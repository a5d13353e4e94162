#pragma once
#include <optional>
#include <string>
#include <vector>

#include "explain/journal.h"
#include "explain/why.h"

// Where facts, restrictions and the authority came from.
namespace evc::explain {

/// A step of an explanation: at a time, with its clause.
struct Step {
  std::optional<std::int64_t> t_ms;
  std::string text;
  std::string clause;  ///< "3.8.4"; nothing: none
};
using Steps = std::vector<Step>;

/// The step of an event: its words, its source, its clause.
Step step_of(const Note& note);
/// Nothing for null.
std::optional<Step> step_of_last(const Note* note);
Step step_of(const Act& act);

/// The national values in force: since when, and what gave them. `values`: those that matter here, "D_NVROLL 2.0 m".
Step national_values_step(const Journal& journal, std::int64_t t_ms, const std::string& values, const char* clause);

/// The last change of level, and the order that it executed; nothing: none.
std::optional<Step> level_step(const Journal& journal, std::int64_t t_ms);

/// From what a fact of the moment came; nothing where only the position or the time made it so.
std::optional<Step> origin_of(const Literal& literal, const Journal& journal, std::int64_t t_ms);

/// "EOA at 600.0 m, SvL at 700.0 m, release speed 30 km/h"; nothing without an authority.
std::string end_words(const track::Authority& authority, const position::State& position);

/// The authority in force: from what it came, what changed it since, and where it ends.
Steps authority_steps(const Journal& journal, const Moment& moment);

/// A part of the MRSP.
struct Restriction {
  MrspSource source{};
  Speed V;
  std::string text;          ///< "TSR 4 of 60 km/h from 500.0 m to 900.0 m"
  std::optional<Step> from;  ///< what brought it
};
Step step_of(const Restriction& restriction);
/// "3.11.5": the clause of the restriction.
const char* clause_of(MrspSource source);
/// Those that limit the speed to `V` between two places.
std::vector<Restriction> restrictions(const Journal& journal, const Moment& moment, Place from, Place to, Speed V);

/// What gave the SR distance last: the RBC, a loop, the driver; without these it is the national value.
Step SR_distance_step(const Journal& journal, const Moment& moment);

/// The target of a moment as words: "EOA at 3039.3 m".
std::string target_words(const Moment& moment, const sdm::TargetId& target);
/// The same with its distance, from the front end that counts for it (3.13.9.3): "EOA at 3039.3 m, 900.0 m ahead; SvL
/// at 3139.3 m, 988.0 m ahead of the max safe front end".
std::string target_distance_words(const Moment& moment, const sdm::TargetId& target);
/// What brought it.
Steps target_steps(const Journal& journal, const Moment& moment, const sdm::TargetId& target);

}  // namespace evc::explain
