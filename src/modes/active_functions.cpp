#include "modes/active_functions.h"

namespace evc::modes {
namespace {

/// Position reports that 4.5.2 of 4.0.0 has and 3.x has not.
bool reported_in_4_0_0(Function function, Mode mode) {
  switch (function) {
    case Function::report_standstill:
      return mode == Mode::SB;
    case Function::report_integrity_confirmed:
    case Function::report_integrity_lost:
      return mode == Mode::UN || mode == Mode::SN;
    case Function::report_rbc_border:
      return mode == Mode::SL || mode == Mode::NL;
    case Function::report_level_border_rear:
    case Function::report_level_change_trackside:
    case Function::report_rbc_requested:
      return mode == Mode::SL;
    case Function::report_every_bg:
      return mode == Mode::SB || mode == Mode::SL;
    default:
      return false;
  }
}

}  // namespace

Activity activity(Function function, Mode mode, SrsVersion srs) {
  if (srs == SrsVersion::v3_4_0) {
    if (function == Function::text_messages && mode == Mode::NL) return Activity::active;
    if (function == Function::advance_route_display) return mode == Mode::FS ? Activity::optional : Activity::inactive;
    if (function == Function::report_data_consistency_error) return Activity::inactive;
  }
  if (srs == SrsVersion::v4_0_0 && reported_in_4_0_0(function, mode)) return Activity::active;
  return srs_4_5_2[static_cast<std::size_t>(function)].modes[static_cast<std::size_t>(mode)];
}

}  // namespace evc::modes
