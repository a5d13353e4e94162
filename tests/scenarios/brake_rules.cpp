#include "brake_rules.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "base/test_paths.h"
#include "terms/requests.h"

namespace evc::brake_rules {
namespace {

/// A train that is slower stands (the standard gives no figure), after a second at the latest.
constexpr double kSlow = 0.05;
constexpr Duration kSurely{1.0};
/// A.3.1: for how long an alarm of the balise antenna is ignored in levels 0 and NTC, and how near to it the unit may
/// see either.
constexpr Distance kIgnored{300.0}, kUnclear{1.0};

std::optional<bool> stands(const Cycle& c) {
  if (c.between_moving_and_standing()) return {};
  return c.standing > Duration{};
}
Condition acknowledged(Ack ack) {
  return [ack](const Cycle& c) { return std::optional(c.in.driver.has(ack)); };
}
/// The limits are those of the movement that is permitted; another direction has its own protections (3.14.2, 3.14.3).
std::optional<bool> speed_permitted(const Cycle& c) {
  const bool backwards = (c.in.odometry.V_est.si < 0.0) != (c.in.train.cab == port::Cab::B);
  if (backwards && c.now.mode != Mode::RV) return true;
  const double V = std::abs(c.in.odometry.V_est.si);
  if (!c.now.V_P || V <= c.now.V_P->si || (c.now.V_release && V <= c.now.V_release->si)) return true;
  if (c.shown_speed_held) return {};  // that in force may be higher
  return false;
}
std::optional<bool> message_of_RBC(const Cycle& c) {
  return std::any_of(c.in.radio_messages.begin(), c.in.radio_messages.end(),
                     [](const port::RadioMessage& m) { return !m.infill_unit; });
}
std::optional<bool> power_and_no_failure(const Cycle& c) {
  return c.now.mode != Mode::NP && c.now.mode != Mode::SF && !c.in.safety_fault;
}
/// 5.22.4.2 of 4.0.0, seen by the possibility to revoke it; while an acknowledgement is asked for the menus are closed.
std::optional<bool> alarm_inhibited(const Cycle& c) {
  if (!c.now.requests.empty()) return {};
  return c.now.enabled.has(DriverInput::bmm_revoke);
}
/// 3.15.7.2: from where the alarm began, in whatever level that was.
std::optional<bool> alarm_is_short(const Cycle& c) {
  if (level_1_2_3(c.now.level)) return false;
  if (!c.run_with_alarm) return true;
  if (*c.run_with_alarm > kIgnored - kUnclear && *c.run_with_alarm < kIgnored + kUnclear) return {};
  return *c.run_with_alarm <= kIgnored;
}
/// 3.15.7.4 of 4.0.0.
std::optional<bool> ignored_in_SB(const Cycle& c) {
  return c.srs == SrsVersion::v4_0_0 && c.now.mode == Mode::SB && level_1_2_3(c.now.level);
}
std::optional<bool> distance_extended(const Cycle& c) { return !c.now.rv_left || *c.now.rv_left > Distance{}; }

Condition condition_of(const std::string& name, const std::string& brake) {
  static const std::map<std::string, Condition> all{
      {"standstill", stands},
      {"speed permitted", speed_permitted},
      {"no target speed monitoring", [](const Cycle& c) { return std::optional(c.now.monitoring != Monitoring::TSM); }},
      {"release speed monitoring", [](const Cycle& c) { return std::optional(c.now.monitoring == Monitoring::RSM); }},
      {"level left", [](const Cycle& c) { return std::optional(c.now.level != c.level_before); }},
      {"release at speed", [](const Cycle& c) { return std::optional(!c.emergency_until_standstill); }},
      {"message from the RBC", message_of_RBC},
      {"no power or failure over", power_and_no_failure},
      {"distance extended", distance_extended},
      {"alarm over", [](const Cycle& c) { return std::optional(!c.in.train.antenna_alarm); }},
      {"alarm inhibited", alarm_inhibited},
      {"less than 300 m in level 0 or NTC", alarm_is_short},
      {"SB in level 1 or 2 of 4.0.0", ignored_in_SB},
      {"not ordered SB", [](const Cycle& c) { return std::optional(!c.in.national_system.service_brake); }},
      {"not ordered EB", [](const Cycle& c) { return std::optional(!c.in.national_system.emergency_brake); }},
  };
  const std::size_t last = name.rfind(' ');
  if (name.substr(last + 1) == "acknowledged")
    for (const auto& row : kAckRows)
      if (name.substr(0, last) == row.name) return acknowledged(row.value);
  const auto found = all.find(name == "not ordered" ? name + " " + brake : name);
  if (found == all.end()) throw std::runtime_error("tests/reference/brake_causes.json: no condition " + name);
  return found->second;
}

Mode mode_of_name(const std::string& abbreviation) {
  for (std::size_t m = 0; m < kModes; ++m)
    if (abbreviation == name(static_cast<Mode>(m))) return static_cast<Mode>(m);
  throw std::runtime_error("tests/reference/brake_causes.json: no mode " + abbreviation);
}

Marks read_marks(const nlohmann::json& columns, const std::string& text) {
  Marks marks{};
  std::istringstream cells(text);
  for (const std::string column : columns) cells >> marks[terms::index(mode_of_name(column))];
  return marks;
}

std::vector<Rule> read_rules() {
  std::ifstream in(evc::test::source_folder() + "/tests/reference/brake_causes.json");
  const auto file = nlohmann::json::parse(in);
  std::vector<Rule> all;
  for (const auto& cause : file["causes"]) {
    Rule rule;
    rule.id = cause["id"];
    rule.brake = cause["brake"];
    rule.clause = cause["clause"];
    rule.clause_4_0_0 = cause.value("clause_4_0_0", "");
    if (cause.value("on_entry_in_level", "") == "0") rule.of_level = Level::L0;
    for (const auto& conditions : cause["release"]) {
      Way& way = rule.ways.emplace_back();
      for (const std::string name : conditions) way.push_back({name, condition_of(name, rule.brake)});
    }
    rule.marks = read_marks(file["_meta"]["columns"], cause.value("on_entry", ""));
    if (cause.contains("on_entry_4_0_0"))
      rule.marks_4_0_0 = read_marks(file["_meta"]["columns"], cause["on_entry_4_0_0"].get<std::string>());
    if (cause.contains("grey_revoked")) {
      rule.grey_revoked.emplace();
      for (const std::string mode : cause["grey_revoked"]) rule.grey_revoked->add(mode_of_name(mode));
    }
    all.push_back(std::move(rule));
  }
  return all;
}

/// The orientation of the train changed.
bool train_turned(const port::Outputs& now) {
  return std::any_of(now.events.begin(), now.events.end(),
                     [](const port::Event& e) { return e.what == What::train_turned; });
}

/// The faults and what is seen of one cycle.
class Look {
 public:
  Look(const Memory& before, const Cycle& cycle, Seen* seen, const std::string& place)
      : before_(before), cycle_(cycle), seen_(seen), place_(place) {}

  std::vector<std::string> all() {
    const Set<Cause> now = cycle_.now.brake_reasons;
    const bool changed = before_.mode != cycle_.now.mode;
    for (std::size_t i = 0; i < rules().size(); ++i) {
      const Cause cause = static_cast<Cause>(i);
      rule_ = &rules()[i];
      if (now.has(cause) && !changed) note("in " + std::string(name(cycle_.now.mode)));
      if (!before_.commanded.has(cause)) {
        entering.add(cause, changed && now.has(cause) && !rule_->grey_revoked);
        continue;
      }
      // A command that ends when another mode is entered at once is ended by that entry.
      const bool late = before_.entering.has(cause) && !(changed && !now.has(cause));
      entered_ = late ? before_.mode : cycle_.now.mode;
      from_ = late ? before_.from : before_.mode;
      level_ = late ? before_.level : cycle_.now.level;
      turned_ = late ? before_.turned : train_turned(cycle_.now);
      if (changed && !late && now.has(cause) && !rule_->grey_revoked)
        entering.add(cause);  // what asks for it sees the mode in the next cycle
      else if (changed || late)
        now.has(cause) ? kept() : revoked();
      else
        now.has(cause) ? held() : released("");
    }
    one_acknowledgement();
    return std::move(faults_);
  }
  Set<Cause> entering;  ///< to be judged in the next cycle

 private:
  void note(const std::string& what) {
    if (seen_ != nullptr) seen_->try_emplace(rule_->id + " " + what, place_);
  }
  void note_entry(const std::string& what) {
    if (seen_ != nullptr) seen_->try_emplace(rule_->entries_in(before_.srs) + " " + what + " " + entry(), place_);
  }
  void fault(const std::string& what) { faults_.push_back("brake " + rule_->id + " " + what); }
  std::string entry() const { return std::string(name(entered_)) + (from_ == Mode::PT ? " from PT" : ""); }
  bool revokes() const {
    const char mark = rule_->marks_in(before_.srs)[terms::index(entered_)];
    if (mark == '-' && rule_->grey_revoked) return rule_->grey_revoked->has(entered_);
    if (mark == 'O') return turned_;
    if (mark == 'L') return level_1_2_3(level_);
    return mark == 'R' || (mark == 'P' && from_ == Mode::PT);
  }

  /// 3.14.1: a command lasts as long as a condition of each way is missing.
  void held() {
    for (const Way& way : rule_->ways) {
      const NamedCondition* missing = nullptr;
      std::size_t fulfilled = 0;
      for (const NamedCondition& c : way) {
        const std::optional<bool> holds = c.holds(cycle_);
        if (holds && !*holds) missing = &c;
        if (holds && *holds) ++fulfilled;
      }
      if (missing != nullptr && fulfilled + 1 == way.size())
        note("without " + missing->name + " (" + name_of(way) + ")");
      if (fulfilled == way.size() && ends_at_once(way)) fault("is still commanded: " + name_of(way));
    }
  }
  /// Whether nothing but this way decides. One acknowledgement is for the causes of one clause (3.14.1.10); the limits
  /// have a hysteresis, and one of several texts may have been acknowledged.
  bool ends_at_once(const Way& way) const {
    if (way.back().name == "brake acknowledged") {
      for (std::size_t i = 0; i < rules().size(); ++i)
        if (before_.commanded.has(static_cast<Cause>(i)) && rules()[i].acknowledged_at_standstill() &&
            rules()[i].clause_in(before_.srs) != rule_->clause_in(before_.srs))
          return false;
      return cycle_.in.train.desk_open;
    }
    if (rule_->id == "balise_antenna") return true;  // it lasts as long as the alarm that is not ignored
    return way.front().name == "standstill" && way.size() == 1 && rule_->id != "overspeed_emergency";
  }

  void released(const std::string& where) {
    for (const Way& way : rule_->ways) {
      const bool fulfilled = std::all_of(way.begin(), way.end(), [&](const NamedCondition& c) {
        const std::optional<bool> holds = c.holds(cycle_);
        return !holds || *holds;
      });
      if (fulfilled) return note("by " + name_of(way));
    }
    fault("ended without its release conditions" + where + " in " + name(cycle_.now.mode));
  }

  /// 3.14.1.10: not of two clauses at once.
  void one_acknowledgement() {
    const Rule* first = nullptr;
    if (before_.mode != cycle_.now.mode) return;
    for (std::size_t i = 0; i < rules().size(); ++i) {
      const Rule& rule = rules()[i];
      const Cause cause = static_cast<Cause>(i);
      if (!rule.acknowledged_at_standstill() || !before_.commanded.has(cause) || cycle_.now.brake_reasons.has(cause))
        continue;
      if (first != nullptr && first->clause_in(before_.srs) != rule.clause_in(before_.srs))
        faults_.push_back("brake " + rule.id + " ended with " + first->id + ", which is of another clause");
      first = &rule;
    }
  }
  void kept() {
    if (rule_->of_level && before_.level != *rule_->of_level) return;
    note_entry("kept");
    if (revokes()) fault("is not revoked by the entry of " + entry());
  }
  void revoked() {
    const char mark = rule_->marks_in(before_.srs)[terms::index(entered_)];
    const bool outside = entered_ == Mode::IS || entered_ == Mode::SF || entered_ == Mode::SL || entered_ == Mode::PS;
    const bool undefined = entered_ == Mode::IS || (outside && mark == '-' && !rule_->grey_revoked);
    if (revokes() || mark == 'T' || undefined)
      note_entry("revoked");
    else
      released(" on the entry of " + entry() + " from " + name(from_));
  }

  const Memory& before_;
  const Cycle& cycle_;
  Seen* seen_;
  const std::string& place_;
  const Rule* rule_ = nullptr;  // looked at, and the mode entry that is judged
  Mode entered_ = Mode::NP, from_ = Mode::NP;
  Level level_ = Level::L0;  // in which it was entered
  bool turned_ = false;
  std::vector<std::string> faults_;
};

}  // namespace

bool Cycle::between_moving_and_standing() const { return standing > Duration{} && standing < kSurely; }

bool Rule::acknowledged_at_standstill() const {
  return std::any_of(ways.begin(), ways.end(), [](const Way& way) { return way.back().name == "brake acknowledged"; });
}

const std::string& Rule::clause_in(SrsVersion srs) const {
  return srs == SrsVersion::v4_0_0 && !clause_4_0_0.empty() ? clause_4_0_0 : clause;
}

const Marks& Rule::marks_in(SrsVersion srs) const {
  return srs == SrsVersion::v4_0_0 && marks_4_0_0 ? *marks_4_0_0 : marks;
}

std::string Rule::entries_in(SrsVersion srs) const {
  return srs == SrsVersion::v4_0_0 && marks_4_0_0 ? id + " of 4.0.0" : id;
}

const std::vector<Rule>& rules() {
  static const std::vector<Rule> all = read_rules();
  return all;
}

std::string name_of(const Way& way) {
  std::string text;
  for (const NamedCondition& c : way) text += (text.empty() ? "" : " + ") + c.name;
  return text;
}

std::vector<std::string> look(Memory& memory, const port::Inputs& in, const port::Outputs& now,
                              bool emergency_until_standstill, Seen* seen, const std::string& place) {
  const bool slow = std::abs(in.odometry.V_est.si) < kSlow;
  if (!slow) memory.standing_since.reset();
  if (slow && !memory.standing_since) memory.standing_since = in.now;
  const OdometerReading here{in.odometry.nominal, in.odometry.min, in.odometry.max};
  if (!in.train.antenna_alarm) memory.alarm_since.reset();
  if (in.train.antenna_alarm && !memory.alarm_since) memory.alarm_since = here;
  std::vector<std::string> faults;
  Set<Cause> entering;
  if (!memory.commanded.empty() || !now.brake_reasons.empty()) {
    Cycle cycle{in, now, memory.level, {}, emergency_until_standstill && now.mode != Mode::RV};
    cycle.shown_speed_held =
        memory.srs == SrsVersion::v4_0_0 && now.monitoring == Monitoring::TSM && now.V_P && memory.V_P == now.V_P;
    cycle.srs = memory.srs;
    if (const auto& then = memory.alarm_since)
      cycle.run_with_alarm = std::max(here.max - then->max, then->min - here.min);
    if (slow) cycle.standing = in.now - *memory.standing_since + Duration{0.001};
    Look one(memory, cycle, seen, place);
    faults = one.all();
    entering = one.entering;
  }
  if (now.requests.has(Ack::brake) && !slow) faults.push_back("the release of a brake is asked of a moving train");
  memory.commanded = now.brake_reasons;
  memory.entering = entering;
  memory.from = memory.mode;
  memory.turned = train_turned(now);
  memory.mode = now.mode;
  memory.level = now.level;
  memory.V_P = now.V_P;
  return faults;
}

}  // namespace evc::brake_rules
