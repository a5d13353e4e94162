#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "port/inputs.h"
#include "port/outputs.h"
#include "terms/mode.h"
#include "terms/row.h"

// What must hold in every cycle of a unit, said by its inputs and outputs and by what trackside sent. Nothing of the
// kernel is used. The trains of these worlds have an odometer without error.
namespace evc::exploration {

/// A rule, and what it is of.
enum class Rule : std::uint8_t {
  area_ahead,            ///< 3.12.4.7: the begin of an area whose mode was not entered in it is the EOA at the latest
  stop_location,         ///< 3.10.2.2: no authority beyond the place of an accepted emergency stop
  stop_pending,          ///< 3.10.2.4: no authority is accepted before the stop is revoked
  stop_trips,            ///< 3.10.2.3: an unconditional emergency stop trips at once
  authority_of_mode,     ///< 4.4: FS, LS, OS and AD have an authority, other modes than SM have none
  growth,                ///< 3.8: an authority becomes longer by another one only
  passed_end,            ///< 3.13.10.2: no train goes on beyond its authority
  standing_at_end,       ///< 3.13.9: at the EOA the permitted speed is 0, or the release speed
  order_of_limits,       ///< 3.13.9: permitted speed, warning, SBI, EBI in this order
  too_fast,              ///< 3.13.10: above the EBI limit the emergency brake, above the SBI limit a brake
  ceiling,               ///< 3.11.7: no mode permits more than its speed
  runs_unbraked,         ///< 3.14.2 to 3.14.4: roll away, reverse movement, standstill
  trip_reason,           ///< 4.4.13.1.3: in TR and PT, and the same until TR is left
  brake_for_a_reason,    ///< 3.14.1: a brake is commanded for a cause, and for a cause a brake
  asked_in_mode,         ///< 4.6.3, 5: an acknowledgement is asked where it can lead to something
  asked_until_answered,  ///< 5: standing, with nothing new from outside, a request stays
  silent_without_radio,  ///< 3.5: without a session nothing is sent
  count
};
inline constexpr auto kRuleRows = std::to_array<terms::Row<Rule>>({
    {Rule::area_ahead, "area ahead"},
    {Rule::stop_location, "stop location"},
    {Rule::stop_pending, "stop pending"},
    {Rule::stop_trips, "stop trips"},
    {Rule::authority_of_mode, "authority of the mode"},
    {Rule::growth, "growth"},
    {Rule::passed_end, "passed end"},
    {Rule::standing_at_end, "standing at the end"},
    {Rule::order_of_limits, "order of limits"},
    {Rule::too_fast, "too fast"},
    {Rule::ceiling, "ceiling"},
    {Rule::runs_unbraked, "runs unbraked"},
    {Rule::trip_reason, "trip reason"},
    {Rule::brake_for_a_reason, "brake for a reason"},
    {Rule::asked_in_mode, "asked in the mode"},
    {Rule::asked_until_answered, "asked until answered"},
    {Rule::silent_without_radio, "silent without radio"},
});
static_assert(terms::in_order(kRuleRows) && kRuleRows.size() == terms::index(Rule::count));
constexpr const char* name(Rule rule) { return kRuleRows[terms::index(rule)].name; }

/// What a group or message has beside its packets: places as the counter of the front end there (Outputs::EOA).
struct Told {
  std::optional<Mode> area;           ///< the mode of the area of its mode profile
  OdometerPlace begin;                ///< of that area
  std::optional<OdometerPlace> stop;  ///< of a conditional emergency stop
};

/// What is known of a unit between two cycles.
struct Known {
  std::optional<Told> telling;  ///< while a group is passed or a message is answered
  Mode mode = Mode::NP;
  Level level = Level::L0;
  // The authority that was accepted last.
  std::optional<Mode> area;  ///< the mode of its area, until the train was in the area and in its mode
  OdometerPlace begin;
  std::optional<OdometerPlace> EOA;
  // Emergency stops that are not revoked; `stop`: the nearest place of one.
  std::vector<std::int32_t> stops;
  std::optional<OdometerPlace> stop;
  bool backward = false;  ///< the train runs
  Distance free_run;      ///< forbidden movement since standstill without a brake
  Distance longest_run;   ///< of a cycle meanwhile
  std::optional<StatusText> trip_reason;
  Set<Ack> requests;
  std::uint32_t signals = 0;  ///< of driver and train
  int quiet = 0;              ///< cycles in which nothing came from outside and the train stood
};

/// How often each rule was applied.
using Applied = std::array<std::uint64_t, static_cast<std::size_t>(Rule::count)>;

/// One cycle of a unit. Returns the faults, without numbers: a rule's name, the mode, and what is wrong.
std::vector<std::string> look(Known& known, const port::Inputs& in, const port::Outputs& now, Applied& applied);

}  // namespace evc::exploration
