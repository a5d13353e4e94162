#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/location.h"
#include "terms/clause.h"

namespace evc::check {

/// An error stops or trips a train, or loses information; a warning may; a note is for the reader only.
enum class Severity : std::uint8_t { note, warning, error };
const char* name(Severity severity);

/// The place that a finding is about.
struct Where {
  double at_m = 0.0;             ///< metres along the run
  std::optional<GroupId> group;  ///< the group, or that of the balise
  std::optional<int> message;    ///< `seq` of a radio message
  friend bool operator==(const Where&, const Where&) = default;
};

struct Finding {
  Severity severity = Severity::note;
  Where where;
  std::string clause;  ///< of SUBSET-026; or another document by name: "SUBSET-040 4.1.1.2", "docs/line.md"
  std::string text;
};

/// The findings of a review, in the order of their places when it is complete.
class Findings {
 public:
  void add(Severity severity, const Where& where, Clause clause, std::string text);
  void add(Severity severity, const Where& where, const char* document, std::string text);
  /// By place; at one place as they were found.
  void sort();
  std::size_t count(Severity severity) const;
  const std::vector<Finding>& all() const { return findings_; }

 private:
  std::vector<Finding> findings_;
};

/// A group as it is written in findings: NID_C/NID_BG.
std::string group_text(GroupId id);

}  // namespace evc::check
