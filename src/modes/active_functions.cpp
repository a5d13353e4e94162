#include "modes/active_functions.h"

namespace evc::modes {
namespace {}  // namespace

Activity activity(Function function, Mode mode, SrsVersion srs) {
  if (srs == SrsVersion::v3_4_0) {
    if (function == Function::text_messages && mode == Mode::NL) return Activity::active;
    if (function == Function::advance_route_display) return mode == Mode::FS ? Activity::optional : Activity::inactive;
    if (function == Function::report_data_consistency_error) return Activity::inactive;
  }
  return srs_4_5_2[static_cast<std::size_t>(function)].modes[static_cast<std::size_t>(mode)];
}

}  // namespace evc::modes
