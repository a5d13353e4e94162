#include <fmt/format.h>

#include <algorithm>

#include "check/journey.h"
#include "kernel/intake/routes.h"
#include "terms/packet_numbers.h"

namespace evc::check {
namespace {

using enum Severity;

template <class Fresh, class Stored>
bool covered(const Stored& stored, const std::optional<Fresh>& fresh, Place from, Place to) {
  return fresh ? track::covers_together(stored, *fresh, from, to) : stored.covers(from, to);
}

}  // namespace

/// Last: SSP and gradient have to cover it (4.8.3 [4]).
void Journey::take_authority(Source& source, const Part& part) {
  for (const lang::PacketView* view : part.packets) {
    if (kernel::route_of(*view).turn != kernel::Turn::authority || !passes(source, *view)) continue;
    track::AuthorityContents offered;
    if (track::add(offered, {}, *view, part.reference) != track::Added::added) continue;
    const track::MovementAuthority& ma = *offered.ma;
    check_timers(source, ma);
    if (ma.end() <= source.front) {
      out_.add(error, source.where, "3.8.1.1 a"_srs,
               fmt::format("the authority ends at {:.1f} m, not ahead of the train at {:.1f} m", metres(ma.end()),
                           metres(source.front)));
      continue;
    }
    check_cover(source, ma);
    contents_->ma = offered.ma;
  }
}

/// 3.7.2.3: by the rule of the unit (track::complete), here for each profile, to name it.
void Journey::check_cover(const Source& source, const track::MovementAuthority& ma) const {
  const Place from = contents_->infill.value_or(source.front), to = ma.far_end();
  const auto look = [&](bool covers, const char* what) {
    if (!covers)
      out_.add(error, source.where, "3.7.2.3"_srs,
               fmt::format("the {} does not cover the authority from {:.1f} to {:.1f} m: a train refuses it", what,
                           metres(from), metres(to)));
  };
  look(covered(stored_->gradient, contents_->gradient, from, to), "gradient profile");
  look(covered(stored_->ssp, contents_->ssp, from, to), "static speed profile");
}

/// The highest speed of any train in the static speed profile.
double Journey::highest_speed() const {
  track::SpeedCode highest = 0;
  const auto look = [&](const auto& profile) {
    for (const auto& step : profile.steps) {
      if (step.value.known()) highest = std::max(highest, step.value.V_STATIC);
      for (const track::SpeedCode v : step.value.cd)
        if (v != track::kNoSpeed) highest = std::max(highest, v);
      for (const track::SpeedCode v : step.value.other)
        if (v != track::kNoSpeed) highest = std::max(highest, v);
    }
  };
  look(stored_->ssp);
  if (contents_->ssp) look(*contents_->ssp);
  return track::speed_of(highest).si;
}

void Journey::check_timers(const Source& source, const track::MovementAuthority& ma) const {
  const double v = highest_speed();
  for (const track::Section& section : ma.sections) {
    if (!section.timed) continue;
    if (section.stop > section.end)
      out_.add(error, source.where, "3.8.3.4"_srs,
               fmt::format("the stop place of a section timer, {:.1f} m, is beyond its section, which ends at {:.1f} m",
                           metres(section.stop), metres(section.end)));
    const double way = (section.stop - source.front).si;
    if (section.timer.limit && way > v * section.timer.limit->si)
      out_.add(warning, source.where, "3.8.4.2.2"_srs,
               fmt::format("a section timer of {:.0f} s always ends: {:.1f} m to its stop place, at most {:.0f} km/h",
                           section.timer.limit->si, way, v * 3.6));
  }
  const Place last = ma.sections.back().begin;
  if (ma.end_section && ma.end_section->start < last)
    out_.add(error, source.where, "3.8.4.1.1"_srs,
             fmt::format("the end section timer starts at {:.1f} m, before the end section, which begins at {:.1f} m",
                         metres(ma.end_section->start), metres(last)));
  if (ma.overlap && ma.overlap->start < last)
    out_.add(error, source.where, "3.8.4.4.1"_srs,
             fmt::format("the overlap timer starts at {:.1f} m, before the end section, which begins at {:.1f} m",
                         metres(ma.overlap->start), metres(last)));
}

}  // namespace evc::check
