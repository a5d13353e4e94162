#include "run/course.h"

#include <algorithm>

namespace evc::run {

void Course::record(const kernel::Outputs& o) {
  if (o.tco && !tco_) ++interventions_.tco;
  if (o.sb && !sb_) ++interventions_.sb;
  if (o.eb && !eb_) ++interventions_.eb;
  tco_ = o.tco;
  sb_ = o.sb;
  eb_ = o.eb;
  // Before start of mission the level is that of the last mission: the first level entered is the first that counts.
  if (mode_ != o.mode) {
    if (o.mode == Mode::TR) ++interventions_.trip;
    if (o.mode != Mode::NP) modes_.emplace_back(name(o.mode));
    mode_ = o.mode;
  }
  if (level_ != o.level && o.mode != Mode::NP && o.mode != Mode::SB) {
    levels_.emplace_back(name(o.level));
    level_ = o.level;
  }
  if (!o.V_EBI) return;
  const double margin = (o.V_EBI->si - o.v.si) * 3.6;
  min_margin_ = min_margin_ ? std::min(*min_margin_, margin) : margin;
}

}  // namespace evc::run
