#include "track/services.h"

#include "base/units.h"

namespace evc::track {
namespace {

void nearest(std::optional<Place>& best, Place at) {
  if (!best || at < *best) best = at;
}

/// The nearest temporary EOA and SvL: areas of a mode profile, unsuitable route, level crossings (3.12).
struct Temporary {
  std::optional<Place> EOA, SvL;
  void stop_at(Place at) {
    nearest(EOA, at);
    nearest(SvL, at);
  }
};

/// Those of the areas that are not entered yet.
Temporary temporary_of(const MovementAuthority& ma, std::span<const ModeArea> profile, Mode mode,
                       const std::optional<Place>& est_front, SrsVersion srs) {
  Temporary t;
  for (const ModeArea& area : profile) {
    if (area.accepted || area.mode == mode || (est_front && area.from <= *est_front)) continue;
    nearest(t.EOA, area.from);
    const bool beyond_LOA = srs == SrsVersion::v4_0_0 && ma.limited() && ma.end() < area.from;  // 3.12.4.7 c
    if (area.also_SvL || beyond_LOA) {
      nearest(t.SvL, area.from);
    } else if (ma.limited()) {
      // With a stop at an area's start there is no LOA: the overlap or danger point counts, else the end.
      nearest(t.SvL, ma.SvL_without_LOA());
    }
  }
  return t;
}

/// The authority of `ma` with what replaces its own end. A temporary EOA up to an LOA replaces it; one beyond does not
/// count. In 4.0.0 both count: a temporary EOA stands for an EOA only (3.13.1.5).
Authority with(const Temporary& t, const MovementAuthority& ma, SrsVersion srs) {
  Authority a;
  if (ma.limited()) {
    if (srs == SrsVersion::v4_0_0) {
      a.EOA = t.EOA;
      a.SvL = t.SvL;
      a.LOA = ma.end();
      a.V_LOA = ma.V_LOA;
      return a;
    }
    if (t.EOA && *t.EOA <= ma.end()) {
      a.EOA = t.EOA;
      a.SvL = t.SvL;
    } else {
      a.LOA = ma.end();
      a.V_LOA = ma.V_LOA;
    }
    return a;
  }
  a.EOA = ma.end();
  a.SvL = ma.SvL();
  a.release = ma.release();
  if (t.EOA && *t.EOA <= *a.EOA) {
    a.EOA = t.EOA;
    a.release = {};
  }
  if (t.SvL && a.SvL && *t.SvL <= *a.SvL) {
    a.SvL = t.SvL;
    a.release = {};
  }
  return a;
}

}  // namespace

bool unsuitable(const RouteSuitability& item, const TrainInterfaces& train) {
  switch (item.kind) {
    case Suitability::gauge:
      // A train without an interoperable profile fits none of those listed.
      return train.M_LOADINGGAUGE == 0 || ((item.M_LINEGAUGE >> (train.M_LOADINGGAUGE - 1)) & 1u) == 0;
    case Suitability::axle_load:
      return ((item.M_LINEAXLELOADCAT >> train.M_AXLELOADCAT) & 1u) == 0;
    case Suitability::traction:
      for (const TrainInterfaces::Traction& t : train.tractions) {
        // 3.12.2.3.1: an engine that runs where there is no traction system needs none.
        if (t.M_VOLTAGE == 0) return false;
        if (t.M_VOLTAGE == item.M_VOLTAGE && t.NID_CTRACTION == item.NID_CTRACTION) return false;
      }
      return true;
  }
  return true;
}

std::optional<Place> unsuitable_from(const Description& d, const TrainInterfaces& train) {
  std::optional<Place> first;
  for (const RouteSuitability& item : d.suitability)
    if (unsuitable(item, train)) nearest(first, item.at);
  return first;
}

Authority authority(const MovementAuthority& ma, std::span<const ModeArea> profile, Mode mode, SrsVersion srs) {
  return with(temporary_of(ma, profile, mode, std::nullopt, srs), ma, srs);
}

Authority authority(const Description& d, const TrainInterfaces& train, Mode mode, Place est_front, SrsVersion srs) {
  if (!d.ma || !supervises_authority(mode)) return {};
  Temporary temporary = temporary_of(*d.ma, {d.mode_profile.begin(), d.mode_profile.size()}, mode, est_front, srs);
  if (const std::optional<Place> closed = unsuitable_from(d, train)) temporary.stop_at(*closed);
  for (const LevelCrossing& lx : d.lx)
    if (lx.unprotected && !lx.substituted) temporary.stop_at(lx.from);
  return with(temporary, *d.ma, srs);
}

void accept_area(Description& d, Mode mode, const Here& here) {
  for (ModeArea& area : d.mode_profile)
    if (area.mode == mode && (here.est_front >= area.ack_from || here.max_safe_front >= area.from) && !area.accepted) {
      area.accepted = true;
      ++d.revision;
    }
}

bool slippery(const Description& d, Place at, Distance train_length) {
  for (const AdhesionArea& area : d.adhesion)
    if (area.slippery && at >= area.from && at <= area.to + train_length) return true;
  return false;
}

bool before_track_description(const Description& d, const Here& here) {
  return d.ssp.empty() || d.gradient.empty() || here.est_front < d.ssp.steps.front().from ||
         here.est_front < d.gradient.steps.front().from;
}

void substitute_level_crossing(Description& d, std::uint8_t NID_LX, Place from) {
  for (LevelCrossing& lx : d.lx)
    if (lx.NID_LX == NID_LX && lx.unprotected && !lx.substituted) {
      lx.substituted = true;
      lx.V_LX_from = from;
      ++d.revision;
    }
}

std::optional<Duration> time_to_timeout(const Description& d, Duration now) {
  std::optional<Duration> shortest;
  if (!d.ma) return shortest;
  const auto consider = [&](const Timer& timer) {
    if (!timer.running || !timer.limit) return;
    const Duration left = *timer.limit - (now - timer.started);
    if (!shortest || left < *shortest) shortest = left;
  };
  for (const Section& section : d.ma->sections) consider(section.timer);
  if (d.ma->limited()) consider(d.ma->loa_timer);
  return shortest;
}

Set<Suitability> unsuitability(const Description& d, const TrainInterfaces& train) {
  Set<Suitability> kinds;
  for (const RouteSuitability& item : d.suitability) kinds.add(item.kind, unsuitable(item, train));
  return kinds;
}

bool described_under_train(const Description& d, const Here& here) {
  return d.ssp.covers(here.min_safe_rear, here.est_front) && d.gradient.covers(here.min_safe_rear, here.est_front);
}

std::optional<Distance> reversing_left(const Description& d, const Here& here) {
  if (!d.reversing_reference || !d.reversing_supervision || !d.reversing_supervision->D_REVERSE) return std::nullopt;
  return here.est_front - (*d.reversing_reference - *d.reversing_supervision->D_REVERSE);
}

namespace {

/// The value at the estimated front end; below 0 there is none (3.6.6.9 c).
double position_from(const GeoReference& reference, const Here& here) {
  const double run = (here.est_front - *reference.applies_from).si;
  const double origin = static_cast<double>(*reference.M_POSITION);
  return reference.counts_up_ahead ? origin + run : origin - run;
}

/// The one that became applicable last.
const GeoReference* applicable(const Description& d) {
  const GeoReference* last = nullptr;
  for (const GeoReference& reference : d.geo)
    if (reference.applicable && (last == nullptr || *reference.applies_from >= *last->applies_from)) last = &reference;
  return last;
}

}  // namespace

std::optional<std::uint32_t> geographical_position(const Description& d, const Here& here) {
  const GeoReference* reference = applicable(d);
  if (reference == nullptr || !reference->M_POSITION) return std::nullopt;
  const double value = position_from(*reference, here);
  if (value < 0.0 || value > 9'999'999.0) return std::nullopt;
  return static_cast<std::uint32_t>(value + 0.5);  // NOLINT(bugprone-incorrect-roundings): the kernel has no libm
}

void place(GeoReference& reference, Place at, Direction orientation, Anchor anchor) {
  if (orientation == Direction::unknown) return;
  reference.applies_from = at + reference.D_POSOFF;
  reference.counts_up_ahead = reference.counts_up == (orientation == Direction::nominal);
  reference.anchor = anchor;
}

void note_group(Description& d, GroupId group, Place at, Direction orientation, Anchor anchor) {
  for (GeoReference& reference : d.geo)
    if (reference.group == group && !reference.applicable) place(reference, at, orientation, anchor);
}

void advance_geographical_position(Description& d, const Here& here) {
  for (GeoReference& reference : d.geo)
    if (reference.applies_from && *reference.applies_from <= here.est_front) reference.applicable = true;
  const GeoReference* last = applicable(d);
  if (last == nullptr) return;
  const bool over = !last->M_POSITION || position_from(*last, here) < 0.0;
  const Place from = *last->applies_from;
  d.geo.erase_if([&](const GeoReference& r) { return r.applicable && (over || *r.applies_from < from); });
}

}  // namespace evc::track
