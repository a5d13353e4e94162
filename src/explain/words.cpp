#include "explain/words.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "lang/message_table.h"
#include "position/position.h"

namespace evc::explain {
namespace {

struct FactWords {
  Fact fact;
  const char* yes;
  const char* no;
};
// clang-format off
constexpr auto kFacts = std::to_array<FactWords>({
    {Fact::isolated, "isolation device operated", "isolation device not operated"},
    {Fact::powered, "the unit is supplied", "the unit is not supplied"},
    {Fact::desk_open, "a desk is open", "every desk is closed"},
    {Fact::standstill, "standstill", "not at standstill"},
    {Fact::sleeping, "sleeping signal", "no sleeping signal"},
    {Fact::non_leading, "non leading signal", "no non leading signal"},
    {Fact::passive_shunting, "passive shunting signal", "no passive shunting signal"},
    {Fact::safety_fault, "a fault that affects safety", "no fault"},
    {Fact::level_0, "level 0", "not level 0"},
    {Fact::level_NTC, "level NTC", "not level NTC"},
    {Fact::level_1, "level 1", "not level 1"},
    {Fact::level_2_or_3, "level 2 or 3", "not level 2 or 3"},
    {Fact::level_1_2_3, "level 1, 2 or 3", "level 0 or NTC"},
    {Fact::level_becomes_0, "the level becomes 0", "no change to level 0"},
    {Fact::level_becomes_NTC, "the level becomes NTC", "no change to level NTC"},
    {Fact::level_becomes_1, "the level becomes 1", "no change to level 1"},
    {Fact::level_becomes_2_or_3, "the level becomes 2 or 3", "no change to level 2 or 3"},
    {Fact::national_system_only, "only the national system changes", "another level was left"},
    {Fact::requested, "", ""},
    {Fact::acknowledged, "", ""},
    {Fact::selects_SH, "shunting selected", "shunting not selected"},
    {Fact::selects_exit_SH, "exit of shunting selected", "exit of shunting not selected"},
    {Fact::selects_NL, "non leading selected", "non leading not selected"},
    {Fact::selects_override, "override selected", "override not selected"},
    {Fact::train_data_valid, "train data valid", "train data not valid"},
    {Fact::ma_ssp_gradient_stored, "MA, SSP and gradient stored", "MA, SSP and gradient not all stored"},
    {Fact::ma_accepted, "an MA is stored", "no MA stored"},
    {Fact::ma_with_trip_order, "the MA is a trip order", "the MA is no trip order"},
    {Fact::profile_demands_OS, "in an OS area", "not in an OS area"},
    {Fact::profile_demands_LS, "in an LS area", "not in an LS area"},
    {Fact::profile_demands_SH, "at an SH area", "not at an SH area"},
    {Fact::profile_in_force, "a mode profile is in force", "no mode profile in force"},
    {Fact::front_in_OS_ack_area, "on sight may be acknowledged here", "on sight may not be acknowledged here"},
    {Fact::front_in_LS_ack_area, "limited supervision may be acknowledged here", "limited supervision may not be acknowledged here"},
    {Fact::mode_is_OS, "the mode is OS", "the mode is not OS"},
    {Fact::mode_is_LS, "the mode is LS", "the mode is not LS"},
    {Fact::min_safe_antenna_beyond_eoa, "min safe antenna beyond the EOA", "min safe antenna not beyond the EOA"},
    {Fact::min_safe_front_beyond_eoa, "min safe front end beyond the EOA", "min safe front end not beyond the EOA"},
    {Fact::group_at_eoa_in_RSM, "the group at the EOA was read", "no group read at the EOA"},
    {Fact::front_in_rear_of_track_description, "front end in rear of the stored SSP or gradient", "SSP and gradient stored at the front end"},
    {Fact::linking_reaction_trip, "linking reaction: trip", "no linking reaction"},
    {Fact::linked_group_wrong_direction, "a linked group was passed in the wrong direction", "no group in the wrong direction"},
    {Fact::telegram_version_too_high, "a telegram has too high a version X", "no version X too high"},
    {Fact::trip_order, "a balise group orders a trip", "no trip order"},
    {Fact::stop_if_in_SH, "stop if in shunting", "no stop if in shunting"},
    {Fact::stop_if_in_SR, "stop if in SR", "no stop if in SR"},
    {Fact::group_passed_not_in_SH_list, "a group that is not in the SH list", "no group outside of an SH list"},
    {Fact::group_passed_not_in_SR_list, "a group that is not in the SR list", "no group outside of an SR list"},
    {Fact::group_passed_in_SR_list, "the group is in the SR list", "no group of an SR list"},
    {Fact::ues_accepted, "unconditional emergency stop accepted", "no unconditional emergency stop"},
    {Fact::ues_received, "unconditional emergency stop received", "no unconditional emergency stop"},
    {Fact::T_NVCONTACT_trip, "T_NVCONTACT has passed, its reaction is trip", "no trip by T_NVCONTACT"},
    {Fact::SH_granted, "shunting granted by the RBC", "shunting not granted by the RBC"},
    {Fact::override_active, "override is on", "override is off"},
    {Fact::former_eoa_passed, "min safe antenna passes the former EOA", "no former EOA is passed"},
    {Fact::SR_distance_passed, "front end beyond the SR distance", "front end not beyond an SR distance"},
    {Fact::continue_shunting, "shunting goes on", "shunting does not go on"},
    {Fact::stop_shunting_stored, "shunting has to stop at the opening of a desk", "no order to stop shunting"},
    {Fact::national_trip, "national trip", "no national trip"},
    {Fact::level_crossing_approach_shown, "the approach of a level crossing begins to be shown", "no approach of a level crossing begins to be shown"},
    {Fact::brake_commanded, "a brake is commanded", "no brake is commanded"},
    {Fact::AD_requested, "automatic driving asked for", "automatic driving not asked for"},
    {Fact::described_for_whole_train, "SSP and gradient known for the whole train", "SSP or gradient not known for the whole train"},
    {Fact::selects_ATO_engage, "automatic operation engaged", "automatic operation not engaged"},
    {Fact::ATO_disengaged, "automatic operation disengaged or in stand-by", "automatic operation neither disengaged nor in stand-by"},
    {Fact::SM_authorised, "supervised manoeuvre authorised", "supervised manoeuvre not authorised"},
    {Fact::selects_exit_SM, "exit of supervised manoeuvre selected", "exit of supervised manoeuvre not selected"},
    {Fact::consist_in_front, "a consist in front of the engine", "no change of the consist in front of the engine"},
    {Fact::odometer_beyond_threshold, "odometer error beyond the safety threshold", "odometer error within the safety threshold"},
});
// clang-format on
static_assert(
    [] {
      for (std::size_t i = 0; i < kFacts.size(); ++i)
        if (static_cast<std::size_t>(kFacts[i].fact) != i) return false;
      return kFacts.size() == static_cast<std::size_t>(Fact::count);
    }(),
    "one row for each, in order");

/// A tenth, without "-0".
double tenth(double value) { return std::nearbyint(value * 10.0) / 10.0 + 0.0; }

}  // namespace

std::string time_words(std::int64_t t_ms) { return fmt::format("{:.1f} s", static_cast<double>(t_ms) / 1000.0); }

std::string message_words(std::uint8_t NID_MESSAGE) {
  const lang::MessageRules* rules = lang::find_message_rules(lang::Direction::to_train, NID_MESSAGE, {2, 1});
  if (rules == nullptr) rules = lang::find_message_rules(lang::Direction::to_train, NID_MESSAGE, lang::kNewest);
  return rules == nullptr ? fmt::format("message {}", NID_MESSAGE)
                          : fmt::format("message {} ({})", NID_MESSAGE, rules->name);
}

std::string kmh_words(Speed v) { return fmt::format("{:g} km/h", tenth(v.si * 3.6)); }
std::string metres_words(Distance d) { return fmt::format("{:.1f} m", tenth(d.si)); }
std::string place_words(const position::State& position, Place place) {
  return metres_words(position::counter_of(position, place).from_origin);
}
std::string place_words(const kernel::State& state, Place place) { return place_words(state.position, place); }

std::array<std::string, 2> different_kmh_words(Speed a, Speed b) {
  std::array<std::string, 2> text;
  for (int digits = 2; digits <= 6; ++digits) {
    text = {fmt::format("{:.{}f} km/h", a.si * 3.6, digits), fmt::format("{:.{}f} km/h", b.si * 3.6, digits)};
    if (text[0] != text[1]) break;
  }
  return text;
}

std::string words(const Literal& l) {
  const char* ack = terms::kNames<kAckRows>[terms::index(l.ack)];
  if (l.fact == Fact::requested) return fmt::format("{} {} for", ack, l.holds ? "asked" : "not asked");
  if (l.fact == Fact::acknowledged) return fmt::format("{} {}", ack, l.holds ? "acknowledged" : "not acknowledged");
  const FactWords& row = kFacts[static_cast<std::size_t>(l.fact)];
  return l.holds ? row.yes : row.no;
}

std::string words(const Reason& reason) {
  const Literals& literals = reason.because;
  std::string text;
  for (std::size_t i = 0; i < literals.size(); ++i) {
    const bool one_choice = i > 0 && literals[i].choice == literals[i - 1].choice;
    if (i > 0) text += reason.holds ? (one_choice ? " and " : "; also ") : (one_choice ? " / " : "; ");
    text += words(literals[i]);
  }
  return text;
}

const char* words(brakes::Kind kind) {
  switch (kind) {
    case brakes::Kind::traction_cut_off:
      return "traction cut-off";
    case brakes::Kind::service_brake:
      return "service brake";
    default:
      return "emergency brake";
  }
}

}  // namespace evc::explain
