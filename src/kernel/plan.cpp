#include "driver/driver.h"
#include "kernel/basis.h"
#include "kernel/curves.h"
#include "kernel/evc.h"
#include "kernel/here.h"
#include "modes/active_functions.h"
#include "sdm/supervision.h"
#include "track/indication.h"

// The advance display of route related information (3.15.10).
namespace evc::kernel {
namespace {

constexpr Distance at_least_0(Distance d) { return d > Distance{} ? d : Distance{}; }

/// The display up to a place: the end of the authority, or the first speed of zero in rear of it (3.15.10.4).
class Planner {
 public:
  Planner(const State& state, const Derived& derived, Planning& out)
      : s_(state), d_(derived), out_(out), here_(here(state)), end_(*state.basis.authority.EOA_or_LOA()) {}

  void plan() {
    plan_speeds();
    add_sources();
    plan_gradients();
    plan_conditions();
    const track::Authority& a = s_.basis.authority;
    if (end_ < *a.EOA_or_LOA()) return;
    // An EOA is supervised with the estimated front end, an LOA with the max safe one.
    if (!a.ends_with_LOA()) {
      out_.EOA = at_least_0(end_ - here_.est_front);
      return;
    }
    out_.LOA = at_least_0(end_ - here_.max_safe_front);
    out_.V_LOA = a.V_LOA;
  }

 private:
  /// Where the front end will be, between its min and its max safe place.
  struct Front {
    Place min_safe, max_safe;
  };

  /// The speed in force there: the lowest between both (3.13.7.2). A lower speed is in force from the max safe front
  /// end on, a higher one from the min safe front end on. False where the display ends: at a speed of zero.
  bool add_speed(Distance at, const Front& front) {
    const Speed V = sdm::V_MRSP(d_.in_force.inputs.mrsp, front.min_safe, front.max_safe);
    if (!out_.speeds.empty() && out_.speeds.back().V == V) return true;
    // As many as the MRSP has steps.
    (void)out_.speeds.push_back({at, V, {}});
    (void)fronts_.push_back(front);
    if (V > Speed{}) return true;
    if (front.max_safe < end_) end_ = front.max_safe;
    return false;
  }

  /// To each speed the restrictions that have it.
  void add_sources() {
    track::Mrsp alone;
    for (std::size_t i = 0; i < terms::index(MrspSource::count); ++i) {
      const auto source = static_cast<MrspSource>(i);
      mrsp_of(source, alone, s_, d_.in_force, s_.basis);
      for (std::size_t n = 0; n < fronts_.size(); ++n) {
        PlannedSpeed& speed = out_.speeds[n];
        speed.sources.add(source, sdm::V_MRSP(alone, fronts_[n].min_safe, fronts_[n].max_safe) == speed.V);
      }
    }
  }

  void plan_speeds() {
    const auto& steps = d_.in_force.inputs.mrsp.steps;
    if (!add_speed({}, {here_.min_safe_front, here_.max_safe_front})) return;
    // Both kinds of change are in the order of their places: the nearer one is next.
    std::size_t lower = 1, higher = 1;
    for (;;) {
      while (lower < steps.size() && steps[lower].value > steps[lower - 1].value) ++lower;
      while (higher < steps.size() && steps[higher].value < steps[higher - 1].value) ++higher;
      const bool more_lower = lower < steps.size() && steps[lower].from < end_;
      const bool more_higher = higher < steps.size() && steps[higher].from < end_;
      if (!more_lower && !more_higher) return;
      const Distance to_lower = more_lower ? steps[lower].from - here_.max_safe_front : Distance{};
      const Distance to_higher = more_higher ? steps[higher].from - here_.min_safe_front : Distance{};
      const bool is_lower = more_lower && (!more_higher || to_lower <= to_higher);
      const Distance at = is_lower ? to_lower : to_higher;
      const Front front = is_lower ? Front{here_.min_safe_front + at, steps[lower].from}
                                   : Front{steps[higher].from, here_.max_safe_front + at};
      ++(is_lower ? lower : higher);
      if (at > Distance{} && !add_speed(at, front)) return;
    }
  }

  void plan_gradients() {
    const auto& steps = s_.track.gradient.steps;
    for (std::size_t i = 0; i < steps.size() && steps[i].from < end_; ++i) {
      const Place from = steps[i].from < here_.est_front ? here_.est_front : steps[i].from;
      const Place to = i + 1 < steps.size() && steps[i + 1].from < end_ ? steps[i + 1].from : end_;
      if (!steps[i].value.known() || !(from < to)) continue;
      // As many as are stored.
      (void)out_.gradients.push_back({from - here_.est_front, to - here_.est_front, steps[i].value.permille});
    }
  }

  /// `planned`: all but the symbol and the distance, which is that from `by` to `at`.
  void add_condition(const std::optional<Symbol>& symbol, PlannedCondition planned, Place at, Place by) {
    if (!symbol || !(by < at) || !(at < end_)) return;
    planned.symbol = *symbol;
    planned.at = at - by;
    std::size_t i = out_.conditions.size();
    while (i > 0 && planned.at < out_.conditions[i - 1].at) --i;
    (void)out_.conditions.insert(i, planned);  // two of each that is stored
  }

  void plan_conditions() {
    for (const track::TrackCondition& c : s_.track.conditions) {
      if (!driver::allowed(driver::output_of(c.kind), s_.mode, s_.srs)) continue;
      for (const bool end : {false, true})
        add_condition(driver::planning_symbol(c.kind, end, s_.by_train),
                      {.kind = c.kind, .end = end, .phase = c.progress.phase}, end ? c.to : c.from,
                      end ? track::passes_end(c.kind, here_) : track::passes_start(c.kind, here_));
    }
    if (const auto& traction = s_.track.traction)
      add_condition(driver::planning_symbol_of_traction(traction->M_VOLTAGE, s_.by_train),
                    {.phase = traction->progress.phase}, traction->at, here_.max_safe_front);
  }

  const State& s_;
  const Derived& d_;
  Planning& out_;
  track::Here here_;
  Place end_;
  InplaceVector<Front, decltype(Planning::speeds)::capacity()> fronts_;  // of the speeds
};

}  // namespace

bool plan(const State& s, const Derived& d, Planning& out) noexcept {
  out.speeds.clear();
  out.gradients.clear();
  out.conditions.clear();
  out.EOA = out.LOA = std::nullopt;
  out.V_LOA = {};
  const bool shown =
      modes::activity(modes::Function::advance_route_display, s.mode, s.srs) != modes::Activity::inactive;
  // In the modes that show it speed is supervised: the curves are those of the last step.
  if (!shown || !s.basis.authority.EOA_or_LOA() || d.built == 0 || d.built != s.basis.number) return false;
  Planner(s, d, out).plan();
  return true;
}

}  // namespace evc::kernel
