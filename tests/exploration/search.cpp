#include "search.h"

#include <algorithm>
#include <cstdio>
#include <deque>
#include <queue>
#include <set>
#include <stdexcept>
#include <tuple>

#include "io/output_lines.h"

namespace evc::exploration {
namespace {

/// What distinguishes two states: all that the driver, the train and the RBC can see but places, speeds and times.
using View = std::vector<std::uint64_t>;

/// No consist known, one behind the engine, one in front of it too.
std::uint64_t consist_of(const port::TrainSignals& t) {
  if (!t.consist) return 0;
  return t.consist->front.max > Distance{} ? 2 : 1;
}

View view_of(const World& w) {
  const port::Outputs& o = w.out;
  const port::TrainSignals& t = w.in.levels.train;
  const double V = w.in.levels.odometry.V_est.si;
  View v{static_cast<std::uint64_t>(o.mode),
         static_cast<std::uint64_t>(o.level),
         static_cast<std::uint64_t>(o.monitoring),
         o.brake_reasons.bits(),
         o.requests.bits(),
         o.entries.bits(),
         o.enabled.bits(),
         o.levels_allowed.bits(),
         o.dialogue ? static_cast<std::uint64_t>(o.dialogue->step) + 1 : 0,
         o.trip_reason ? static_cast<std::uint64_t>(*o.trip_reason) + 1 : 0,
         static_cast<std::uint64_t>(o.data.driver_id_status) * 243 +
             static_cast<std::uint64_t>(o.data.train_running_number_status) * 81 +
             static_cast<std::uint64_t>(o.data.level_status) * 27 + static_cast<std::uint64_t>(o.data.rbc_status) * 9 +
             static_cast<std::uint64_t>(o.data.train_status) * 3 + static_cast<std::uint64_t>(o.data.SR.status)};
  std::uint64_t flags = 0;
  for (const bool b : {o.tco, o.sb, o.eb, o.start_offered, o.lrbg.has_value(), o.EOA.has_value(), o.rv_left.has_value(),
                       o.level_valid, t.powered, t.isolated, t.desk_open, t.sleeping, t.non_leading, t.passive_shunting,
                       t.antenna_alarm, V > 0.0, V < 0.0, w.calling, w.in.levels.national_system.available != 0})
    flags = flags << 1 | (b ? 1u : 0u);
  v.push_back(flags);
  v.push_back(static_cast<std::uint64_t>(t.direction_controller));
  // What the rules keep from trackside: an area that was not entered, and a stop that is not revoked.
  v.push_back(w.known.area ? static_cast<std::uint64_t>(*w.known.area) + 1 : 0);
  v.push_back(w.known.stops.size());
  v.push_back(consist_of(t));
  for (const Symbol s : o.symbols) v.push_back(static_cast<std::uint64_t>(s));
  for (const auto& s : o.sessions)
    v.push_back(static_cast<std::uint64_t>(s.phase) * 8 + static_cast<std::uint64_t>(s.role));
  return v;
}

/// States of one class are alike for the driver; the search takes them in turn.
using Class = std::tuple<Mode, Level, std::uint64_t, std::uint64_t>;
Class class_of(const World& w) {
  const port::TrainSignals& t = w.in.levels.train;
  std::uint64_t signals = static_cast<std::uint64_t>(t.direction_controller) * 3 + consist_of(t);
  const bool reversing = std::find(w.out.symbols.begin(), w.out.symbols.end(), Symbol::ST06) != w.out.symbols.end();
  for (const bool b : {t.desk_open, t.sleeping, t.non_leading, t.passive_shunting, reversing, w.out.EOA.has_value()})
    signals = signals << 1 | (b ? 1u : 0u);
  return {w.out.mode, w.out.level, w.out.dialogue ? static_cast<std::uint64_t>(w.out.dialogue->step) + 1 : 0, signals};
}

struct Node {
  std::unique_ptr<World> world;  // until it is expanded
  std::size_t parent = 0, action = 0;
  int depth = 0;
};

class Search {
 public:
  Search(SrsVersion srs, Bounds bounds) : bounds_(bounds), actions_(actions(srs)), watch_(srs), runner_(srs, watch_) {}

  Found run() {
    add(runner_.power_up(), 0, 0, 0);
    for (std::size_t next = 0; next < nodes_.size() && nodes_[next].depth < bounds_.depth; ++next) expand(next);
    while (found_.expanded < bounds_.states) {
      const std::size_t next = least_seen();
      if (next == nodes_.size()) break;
      expand(next);
    }
    found_.states = nodes_.size();
    found_.cells = watch_.cells;
    found_.cycles = watch_.cycles;
    found_.modes = watch_.modes();
    found_.applied = watch_.applied;
    return std::move(found_);
  }

 private:
  void add(std::unique_ptr<World> world, std::size_t parent, std::size_t action, int depth) {
    if (!seen_.insert(view_of(*world)).second) return;
    waiting_[class_of(*world)].push_back(nodes_.size());
    nodes_.push_back({std::move(world), parent, action, depth});
    found_.depth = std::max(found_.depth, depth);
  }

  /// The first state of the class that was expanded least, in the mode that was, of several the class that was found
  /// first; nodes_.size() if none is left.
  std::size_t least_seen() {
    auto best = waiting_.end();
    std::tuple<std::size_t, std::size_t, std::size_t> least;
    for (auto c = waiting_.begin(); c != waiting_.end(); ++c) {
      while (!c->second.empty() && !nodes_[c->second.front()].world) c->second.pop_front();
      if (c->second.empty()) continue;
      const std::tuple now{times_of_mode_[std::get<Mode>(c->first)], times_[c->first], c->second.front()};
      if (best != waiting_.end() && least <= now) continue;
      best = c;
      least = now;
    }
    return best == waiting_.end() ? nodes_.size() : best->second.front();
  }

  void expand(std::size_t n) {
    const std::unique_ptr<World> world = std::move(nodes_[n].world);
    ++times_[class_of(*world)];
    ++times_of_mode_[world->out.mode];
    ++found_.expanded;
    for (std::size_t a = 0; a < actions_.size(); ++a) {
      auto after = std::make_unique<World>(*world);
      runner_.go_on_with(*after);
      actions_[a].act(runner_);
      ++found_.inputs;
      note(n, actions_[a].name);
      add(std::move(after), n, a, nodes_[n].depth + 1);
    }
    // Out of IS no input leads (4.6.2).
    if (world->out.mode == Mode::IS || world->in.levels.train.isolated) return;
    World after = *world;
    runner_.go_on_with(after);
    ++found_.ways_on;
    if (!goes_on(runner_)) watch_.faults.push_back(std::string("no way on; ends in ") + name(after.out.mode));
    note(n, "(goes on)");
  }

  void note(std::size_t n, const std::string& last) {
    for (const std::string& fault : watch_.faults) {
      if (!noted_.insert(fault).second) continue;
      std::string way = last;
      for (std::size_t at = n; at != 0; at = nodes_[at].parent) way = actions_[nodes_[at].action].name + "; " + way;
      found_.faults.push_back(fault + ": " + way);
    }
    watch_.faults.clear();
  }

  Bounds bounds_;
  const std::vector<Action>& actions_;
  Watch watch_;
  Runner runner_;
  Found found_;
  std::vector<Node> nodes_;
  std::set<View> seen_;
  std::set<std::string> noted_;  ///< faults: each once
  std::map<Class, std::deque<std::size_t>> waiting_;
  std::map<Class, std::size_t> times_;
  std::map<Mode, std::size_t> times_of_mode_;
};

}  // namespace

void print_way(SrsVersion srs, const std::string& way) {
  Watch watch(srs);
  Runner runner(srs, watch);
  const auto world = runner.power_up();
  runner.prints_events = true;
  const auto print = [&](const std::string& what) {
    std::string line;
    io::append_output(line, world->in.t_ms, world->out, nullptr);
    std::printf("%s\n  %s\n", what.c_str(), line.c_str());
    for (const std::string& fault : watch.faults) std::printf("  %s\n", fault.c_str());
    watch.faults.clear();
  };
  for (std::size_t from = 0; from < way.size();) {
    const std::size_t to = std::min(way.find("; ", from), way.size());
    const std::string name = way.substr(from, to - from);
    from = to + 2;
    if (name == "(goes on)") {
      print(goes_on(runner) ? "goes on" : "does not go on");
      continue;
    }
    const std::vector<Action>& all = actions(srs);
    const auto a = std::find_if(all.begin(), all.end(), [&](const Action& x) { return x.name == name; });
    if (a == all.end()) throw std::runtime_error("no action " + name);
    a->act(runner);
    print(name);
  }
}

Found search(SrsVersion srs, Bounds bounds) { return Search(srs, bounds).run(); }

}  // namespace evc::exploration
