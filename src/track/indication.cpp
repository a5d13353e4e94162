#include "track/indication.h"

#include <array>

namespace evc::track {
namespace {

/// The time for the driver or the train to act (5.18.2.2.1 and others leave it to the unit).
constexpr Duration kToAct{15.0};
/// The driver's reaction time before sounding the horn (A.3.1).
constexpr Duration kToSoundHorn{4.0};
/// An indication that what was asked for may be undone stays for this time after the rear end has left (A.3.1).
constexpr Duration kShownAfterwards{5.0};
/// The highest speed of the language (7.5.1.173): no point C is farther in rear of point D.
constexpr Speed kFastest{600.0 / 3.6};
constexpr Place kNowhere{{1e12}};

/// The end of the train with which a point is compared.
enum class End : std::uint8_t { max_safe_front, est_front, min_safe_front, min_safe_rear, hole_front, hole_rear };

Place place_of(End end, const Here& here) {
  switch (end) {
    case End::max_safe_front:
      return here.max_safe_front;
    case End::est_front:
      return here.est_front;
    case End::min_safe_front:
      return here.min_safe_front;
    case End::hole_front:
      return here.hole_front;
    case End::hole_rear:
      return here.hole_rear;
    case End::min_safe_rear:
      break;
  }
  return here.min_safe_rear;
}

/// A procedure of 5.18: point C lies in rear of point D by the way of `lead` at the current speed.
struct Course {
  TrackConditionKind kind{};
  Duration lead{};
  ConditionPhase from_C{};  ///< an announcement up to D, or already the indication itself
  End at_C_and_D{};
  End at_E{};
  ConditionPhase from_E{};  ///< nothing, or what is shown until the rear end has left
};

// clang-format off
constexpr auto srs_5_18 = [] {
  using enum TrackConditionKind;
  using enum ConditionPhase;
  using enum End;
  return std::to_array<Course>({
    {sound_horn,                              kToSoundHorn, active,    est_front,      est_front,      over},    // 5.18.9
    {powerless_lower_pantograph,              kToAct,       announced, max_safe_front, min_safe_front, ending},  // 5.18.2
    {radio_hole,                              {},           active,    hole_front,     hole_rear,      over},    // 5.18.5
    {air_tightness,                           kToAct,       announced, max_safe_front, min_safe_rear,  ending},  // 5.18.6
    {switch_off_regenerative_brake,           kToAct,       announced, max_safe_front, min_safe_rear,  over},    // 5.18.7
    {switch_off_eddy_current_service_brake,   kToAct,       announced, max_safe_front, min_safe_rear,  over},
    {switch_off_magnetic_shoe_brake,          kToAct,       announced, max_safe_front, min_safe_rear,  over},
    {powerless_main_switch_off,               kToAct,       announced, max_safe_front, min_safe_front, ending},  // 5.18.3
    {switch_off_eddy_current_emergency_brake, kToAct,       announced, max_safe_front, min_safe_rear,  over},
  });
}();
// clang-format on

static_assert(
    [] {
      using enum TrackConditionKind;
      for (const auto& row : kTrackConditionRows) {
        // Both stopping areas are shown by 5.18.4 and 5.18.8 as long as the unit stores them.
        const bool none = row.value == non_stopping_area || row.value == tunnel_stopping_area;
        int courses = 0;
        for (const Course& course : srs_5_18) courses += course.kind == row.value;
        if (courses != (none ? 0 : 1)) return false;
      }
      return true;
    }(),
    "every kind of track condition that comes and goes has one course");

/// 5.20.6 to 5.20.8 and 5.18.10: a place or platform, output to the train until its rear end has passed.
constexpr Course kPlatform{
    {}, kToAct, ConditionPhase::announced, End::max_safe_front, End::min_safe_rear, ConditionPhase::over};
constexpr Course kTraction{
    {}, kToAct, ConditionPhase::announced, End::max_safe_front, End::max_safe_front, ConditionPhase::active};

const Course* course_of(TrackConditionKind kind) {
  for (const Course& course : srs_5_18)
    if (course.kind == kind) return &course;
  return nullptr;
}

class Runner {
 public:
  Runner(ConditionWatch& watch, const Here& here, Speed V) : watch_(watch), here_(here), V_(V) {}

  void run(Progress& p, const Course& course, Place D, Place E) {
    using enum ConditionPhase;
    // What the whole train has left was never seen by it: it is not shown.
    if (p.phase <= announced && here_.min_safe_rear > E) p.phase = over;
    const Place front = place_of(course.at_C_and_D, here_);
    if (p.phase == ahead && front >= D - V_ * course.lead) p.phase = course.from_C;
    if (p.phase == announced && front >= D) p.phase = active;
    if (p.phase == active && place_of(course.at_E, here_) >= E) p.phase = course.from_E;
    if (!p.rear_left && p.phase != ahead && p.phase != over && here_.min_safe_rear >= E) p.rear_left = here_.now;
    const bool afterwards = p.rear_left && here_.now - *p.rear_left < kShownAfterwards;
    if (p.phase == course.from_E && p.rear_left && !afterwards) p.phase = over;
    if (p.phase == ahead)
      quiet_until(watch_, D - kFastest * course.lead);
    else
      watch_.shown = watch_.shown || p.phase != over;
  }

 private:
  ConditionWatch& watch_;
  const Here& here_;
  Speed V_;
};

}  // namespace

Place passes_start(TrackConditionKind kind, const Here& here) {
  const Course* course = course_of(kind);
  // A non stopping area by the braking curve of the max safe front end (5.18.4.2).
  return place_of(course != nullptr ? course->at_C_and_D : End::max_safe_front, here);
}

Place passes_end(TrackConditionKind kind, const Here& here) {
  const Course* course = course_of(kind);
  return place_of(course != nullptr ? course->at_E : End::min_safe_rear, here);
}

Duration lead_of(TrackConditionKind kind) {
  const Course* course = course_of(kind);
  return course != nullptr ? course->lead : Duration{};
}

Duration lead_of_traction() { return kTraction.lead; }

void advance_conditions(Description& d, const Here& here, Speed V) {
  d.watch = {.changed = false, .shown = false, .stopping = false, .quiet_to = kNowhere};
  Runner runner(d.watch, here, V);
  for (TrackCondition& c : d.conditions) {
    if (const Course* course = course_of(c.kind))
      runner.run(c.progress, *course, c.from, c.to);
    else
      d.watch.stopping = true;
  }
  for (Platform& p : d.platforms) runner.run(p.progress, kPlatform, p.from, p.to);
  if (d.traction) runner.run(d.traction->progress, kTraction, d.traction->at, d.traction->at);
  if (d.current) runner.run(d.current->progress, kPlatform, d.current->at, d.current->at);
}

bool in_radio_hole(const Description& d) {
  if (!d.watch.shown) return false;
  for (const TrackCondition& c : d.conditions)
    if (c.kind == TrackConditionKind::radio_hole && c.progress.phase == ConditionPhase::active) return true;
  return false;
}

}  // namespace evc::track
