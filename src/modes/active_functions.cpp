#include "modes/active_functions.h"

namespace evc::modes {
namespace {

struct FunctionInMode {
  Function function{};
  Mode mode{};
};

/// The marks of 4.5.2 of 4.0.0 that 3.x has not.
constexpr auto srs_4_5_2_changes_v400 = std::to_array<FunctionInMode>({
    {Function::report_standstill, Mode::SB},
    {Function::report_integrity_confirmed, Mode::UN},
    {Function::report_integrity_confirmed, Mode::SN},
    {Function::report_integrity_lost, Mode::UN},
    {Function::report_integrity_lost, Mode::SN},
    {Function::report_rbc_border, Mode::SL},
    {Function::report_rbc_border, Mode::NL},
    {Function::report_level_border_rear, Mode::SL},
    {Function::report_level_change_trackside, Mode::SL},
    {Function::report_rbc_requested, Mode::SL},
    {Function::report_every_bg, Mode::SB},
    {Function::report_every_bg, Mode::SL},
});

bool added_in_4_0_0(Function function, Mode mode) {
  for (const FunctionInMode& added : srs_4_5_2_changes_v400)
    if (added.function == function && added.mode == mode) return true;
  return false;
}

}  // namespace

Activity activity(Function function, Mode mode, SrsVersion srs) {
  if (srs == SrsVersion::v3_4_0) {
    if (function == Function::text_messages && mode == Mode::NL) return Activity::active;
    if (function == Function::advance_route_display) return mode == Mode::FS ? Activity::optional : Activity::inactive;
    if (function == Function::report_data_consistency_error) return Activity::inactive;
  }
  if (srs == SrsVersion::v4_0_0 && added_in_4_0_0(function, mode)) return Activity::active;
  return srs_4_5_2[static_cast<std::size_t>(function)].modes[static_cast<std::size_t>(mode)];
}

}  // namespace evc::modes
