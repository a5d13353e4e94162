#include "track/areas.h"
#include "track/withdraw.h"

namespace evc::track {
namespace {

/// A row of 4.10.1.3 that is stored in the track description, and how it is reset to its initial state.
struct Row {
  evc::Stored what;
  void (*forget)(Description& d);
};

bool is_horn_or_stopping(const TrackCondition& c) { return horn_or_stopping(c.kind); }

// clang-format off
constexpr auto kRows = std::to_array<Row>({
    {evc::Stored::movement_authority,         [](Description& d) { d.ma.reset(); }},
    {evc::Stored::gradient,                   [](Description& d) { d.gradient.steps.clear(); }},
    {evc::Stored::ssp,                        [](Description& d) { d.ssp.steps.clear(); }},
    {evc::Stored::stop_sh_on_desk_opening,    [](Description& d) { d.stop_shunting_on_desk_opening = false; }},
    {evc::Stored::sh_bg_list,                 [](Description& d) { d.sh_list.reset(); }},
    {evc::Stored::sr_bg_list_speed_distance,  [](Description& d) { d.sr_list.reset(); }},
    {evc::Stored::tsr,                        [](Description& d) { d.tsr.clear(); }},
    {evc::Stored::inhibit_revocable_tsr,      [](Description& d) { d.revocable_tsr_inhibited = false; }},
    {evc::Stored::default_gradient_tsr,       [](Description& d) { d.default_gradient.reset(); }},
    {evc::Stored::signalling_speed,           [](Description& d) { d.signalling.clear(); }},
    {evc::Stored::route_suitability,          [](Description& d) { d.suitability.clear(); }},
    {evc::Stored::adhesion_trackside,         [](Description& d) { d.adhesion.clear(); }},
    {evc::Stored::plain_text,                 [](Description& d) { d.texts.erase_if([](const Text& t) { return !t.Q_TEXT; }); }},
    {evc::Stored::fixed_text,                 [](Description& d) { d.texts.erase_if([](const Text& t) { return t.Q_TEXT.has_value(); }); }},
    {evc::Stored::geo_position,               [](Description& d) { d.geo.clear(); }},
    {evc::Stored::mode_profile,               [](Description& d) { d.mode_profile.clear(); }},
    {evc::Stored::rbc_transition_order,       [](Description& d) { d.rbc_transition.reset(); }},
    {evc::Stored::radio_infill_area,          [](Description& d) { d.radio_infill.reset(); }},
    {evc::Stored::track_conditions_general,   [](Description& d) {
       d.conditions.erase_if([](const TrackCondition& c) { return !is_horn_or_stopping(c); });
       d.traction.reset();
       d.current.reset();
     }},
    {evc::Stored::track_conditions_horn_stopping, [](Description& d) { d.conditions.erase_if(is_horn_or_stopping); }},
    {evc::Stored::reversing_area,             [](Description& d) { d.reversing_area.reset(); d.reversing_reference.reset(); }},
    {evc::Stored::reversing_supervision,      [](Description& d) { d.reversing_supervision.reset(); }},
    {evc::Stored::level_crossing,             [](Description& d) { d.lx.clear(); }},
    {evc::Stored::generic_ls_marker,          [](Description& d) { d.generic_ls_marker = false; }},
});
// clang-format on

}  // namespace

bool forget(Description& d, evc::Stored stored) {
  bool kept_here = false;
  d.watch.changed = true;
  for (const Row& row : kRows) {
    if (row.what != stored) continue;
    row.forget(d);
    kept_here = true;
  }
  each_list([&](const auto& list) {
    if (list.row != stored) return;
    (d.*list.kept).clear();
    kept_here = true;
  });
  if (kept_here) ++d.revision;
  return kept_here;
}

}  // namespace evc::track
