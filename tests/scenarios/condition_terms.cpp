#include "condition_terms.h"

#include <algorithm>
#include <initializer_list>
#include <optional>

namespace evc::scenario {
namespace {

using procedures::Facts;

/// A fact of the unit, as the text says; `wanted` false: the text denies it.
Term fact(const char* text, bool Facts::*member, bool wanted = true) {
  return {text, [=](const Moment& m) { return m.facts.*member == wanted; }};
}
Term signal(const char* text, bool port::TrainSignals::*member, bool wanted = true) {
  return {text, [=](const Moment& m) { return m.in.train.*member == wanted; }};
}
Term selects(const char* text, port::Select what) {
  return {text, [=](const Moment& m) { return m.in.driver.has(what); }, what};
}
Term requested(Ack what) {
  return {std::string(kAckRows[terms::index(what)].name) + " is requested",
          [=](const Moment& m) { return m.facts.requested.has(what); }};
}
Term acknowledges(Ack what) {
  return {std::string("driver acknowledges ") + kAckRows[terms::index(what)].name,
          [=](const Moment& m) { return m.in.driver.has(what); },
          {},
          what};
}
Term in_level(const char* text, std::initializer_list<Level> levels) {
  const std::vector<Level> all = levels;
  return {text, [=](const Moment& m) { return std::find(all.begin(), all.end(), m.facts.level) != all.end(); }};
}
Term switched(const char* text, std::initializer_list<Level> levels) {
  const std::vector<Level> all = levels;
  return {text, [=](const Moment& m) {
            return m.facts.level_switched_to &&
                   std::find(all.begin(), all.end(), *m.facts.level_switched_to) != all.end();
          }};
}

/// "SH authorised" with the time stamp of the last request (8.7.11: T_TRAIN_REF begins at bit 75).
bool is_grant(const port::RadioMessage& message, std::optional<std::uint32_t> asked) {
  constexpr std::size_t kFirst = 75;
  if (message.bytes.size() * 8 < kFirst + 32 || message.bytes[0] != 28) return false;
  std::uint32_t T_TRAIN_REF = 0;
  for (std::size_t bit = kFirst; bit < kFirst + 32; ++bit)
    T_TRAIN_REF = (T_TRAIN_REF << 1) | ((message.bytes[bit / 8] >> (7 - bit % 8)) & 1u);
  return T_TRAIN_REF == asked;
}
bool is_granted(const Moment& m) {
  if (m.facts.SH_granted) return true;
  const auto& all = m.in.radio_messages;
  return m.SH_was_asked_for && std::any_of(all.begin(), all.end(), [&](const port::RadioMessage& message) {
           return is_grant(message, m.state.radio.shunting_request_stamp);
         });
}

/// One telegram is enough (4.6.3 [65]); M_VERSION follows the bit Q_UPDOWN, its X is the first three bits (7.5.1.79).
/// In levels 0 and NTC the unit does not look for it; elsewhere it says whether the telegram counts (3.15.9).
bool is_version_too_high(const Moment& m) {
  if (m.facts.telegram_version_too_high || level_1_2_3(m.facts.level)) return m.facts.telegram_version_too_high;
  const auto& all = m.in.balise_telegrams;
  return std::any_of(all.begin(), all.end(), [&](const port::BaliseTelegram& telegram) {
    return telegram.bits > 8 && ((telegram.bytes[0] & 0x7Fu) >> 4) > kernel::highest_X(m.state.srs);
  });
}

/// [10], [31], [32]; in the area of an acknowledgement given ahead of a mode area the mode stays (5.9.3.4, 5.19.3.4).
bool mode_profile_asks(const Facts& f) {
  return f.profile_in_force || (f.mode_is_OS && f.front_in_OS_ack_area) || (f.mode_is_LS && f.front_in_LS_ack_area);
}

std::vector<ConditionRow> rows() {
  using enum Level;
  using F = Facts;
  using S = port::TrainSignals;
  using port::Select;

  const Term standstill = fact("standstill", &F::standstill);
  const Term desk_open = fact("a desk is open", &F::desk_open);
  const Term desks_closed = fact("every desk closed", &F::desk_open, false);
  const Term sleeping = signal("sleeping signal", &S::sleeping);
  const Term no_override = fact("override is not active", &F::override_active, false);
  const Term override_active = fact("override is active", &F::override_active);
  const Term train_data = fact("train data valid", &F::train_data_valid);
  const Term no_train_data = fact("train data not valid", &F::train_data_valid, false);
  const Term described = fact("MA, SSP and gradient stored", &F::ma_ssp_gradient_stored);
  const Term trip_order = fact("trip order of a balise group", &F::trip_order);
  const Term national_trip = {"national trip", [](const Moment& m) { return m.in.national_system.trip_active; }};
  const Term no_profile = {"no mode profile in force", [](const Moment& m) { return !mode_profile_asks(m.facts); }};
  const Term no_profile_here = {"no mode profile in force",
                                [](const Moment& m) { return !m.facts.profile_in_force && !m.facts.SM_authorised; }};
  const Term selects_SH = selects("driver selects shunting", Select::shunting);
  const Term granted = {"the RBC grants the shunting asked for", is_granted, {}, {}, 28};
  const Term slow = {"at most V_NVALLOWOVTRP",
                     [](const Moment& m) { return m.in.odometry.V_est <= m.state.national_values.V_NVALLOWOVTRP; }};
  const Term no_contact = {"T_NVCONTACT passed", [](const Moment& m) {
                             return m.facts.T_NVCONTACT_trip || m.state.brakes.active.has(brakes::Cause::T_NVCONTACT);
                           }};
  const Term contact_trip = {"M_NVCONTACT is trip",
                             [](const Moment& m) { return m.state.national_values.M_NVCONTACT == Reaction::trip; }};
  const Term no_MA = {"no MA accepted", [](const Moment& m) { return !m.facts.ma_ssp_gradient_stored; }};
  const Term in_OS = fact("front end in an on sight area", &F::profile_demands_OS);
  const Term in_LS = fact("front end in a limited supervision area", &F::profile_demands_LS);
  const Term in_SH = fact("front end at or beyond the entry of a shunting area", &F::profile_demands_SH);
  const Term no_OS_ack = fact("front end not where on sight may be acknowledged", &F::front_in_OS_ack_area, false);
  const Term no_LS_ack =
      fact("front end not where limited supervision may be acknowledged", &F::front_in_LS_ack_area, false);
  const Term to_0 = switched("level switched to 0", {L0});
  const Term to_1 = switched("level switched to 1", {L1});
  const Term to_NTC = {"level switched to NTC", [](const Moment& m) {
                         return m.facts.level_switched_to == NTC && !m.facts.level_order_changed_national_system_only;
                       }};
  const Term to_2_3 = switched("level switched to 2 or 3", {L2, L3});
  const Term to_1_2_3 = switched("level switched to 1, 2 or 3", {L1, L2, L3});
  const Term to_0_1_2_3 = switched("level switched to 0, 1, 2 or 3", {L0, L1, L2, L3});
  const Term to_0_NTC = switched("level switched to 0 or NTC", {L0, NTC});
  const Term in_2_3 = in_level("level 2 or 3", {L2, L3});
  const Term in_1_2_3 = in_level("level 1, 2 or 3", {L1, L2, L3});
  const Term in_0_NTC = in_level("level 0 or NTC", {L0, NTC});
  const bool y = true, n = false;

  // `number, in 3.x, in 4.0.0, terms`. 4.0.0 has no level 3.
  // clang-format off
  return {
    { 1, y, y, {{"isolated", [](const Moment& m) { return m.in.train.isolated || m.in.driver.has(Select::isolate); }}}},
    { 2, y, y, {desk_open}},
    { 3, y, y, {signal("no sleeping signal", &S::sleeping, false), standstill}},
    { 4, y, y, {signal("powered", &S::powered)}},
    { 5, y, y, {standstill, in_level("level 0, NTC or 1", {L0, NTC, L1}), selects_SH}},
    { 6, y, y, {standstill, in_2_3, granted}},
    { 7, y, y, {requested(Ack::trip), acknowledges(Ack::trip), standstill, in_1_2_3}},
    { 8, y, y, {requested(Ack::SR), acknowledges(Ack::SR)}},
    { 9, n, y, {described, fact("the approach of an unprotected level crossing begins to be shown", &F::level_crossing_approach_shown)}},
    {10, y, y, {train_data, described, no_profile}},
    {11, n, y, {in_level("level 2", {L2}), fact("release speed monitoring, and a linked group at or beyond the EOA is read", &F::group_at_eoa_in_RSM)}},
    {12, y, y, {fact("min safe antenna beyond the EOA or LOA", &F::min_safe_antenna_beyond_eoa), in_level("level 1", {L1})}},
    {13, y, y, {fact("a fault that affects safety", &F::safety_fault)}},
    {14, y, y, {sleeping, standstill, desks_closed}},
    {15, y, y, {requested(Ack::OS), acknowledges(Ack::OS)}},
    {16, y, y, {fact("min safe front end beyond the EOA or LOA", &F::min_safe_front_beyond_eoa), in_2_3}},
    {17, y, y, {fact("the linking reaction is trip", &F::linking_reaction_trip)}},
    {18, y, y, {trip_order, no_override}},
    {19, y, y, {selects("driver leaves shunting", Select::exit_shunting), standstill}},
    {20, y, y, {fact("an unconditional emergency stop is accepted", &F::ues_accepted)}},
    {21, y, y, {to_0}},
    {22, y, y, {desk_open, fact("stop shunting at desk opening stored", &F::stop_shunting_stored)}},
    {23, y, y, {desk_open, fact("no stop shunting at desk opening stored", &F::stop_shunting_stored, false)}},
    {24, n, y, {described, fact("service or emergency brake commanded", &F::brake_commanded)}},
    {25, y, y, {to_1_2_3, described, no_profile}},
    {26, y, y, {desks_closed, fact("shunting is to be continued", &F::continue_shunting), signal("passive shunting signal", &S::passive_shunting)}},
    {27, y, y, {desks_closed, fact("shunting is not to be continued", &F::continue_shunting, false)}},
    {28, y, y, {desks_closed}},
    {29, y, y, {signal("not powered", &S::powered, false)}},
    {30, y, y, {desks_closed, signal("no passive shunting signal", &S::passive_shunting, false)}},
    {31, y, y, {described, no_profile, in_2_3}},
    {32, y, y, {described, no_profile, in_level("level 1", {L1}), fact("the MA is no trip order", &F::ma_with_trip_order, false)}},
    {33, n, y, {described, {"automatic driving is not asked for", [](const Moment& m) { return !m.in.automatic_operation.requests_AD; }}}},
    {34, y, y, {in_OS, to_1_2_3}},
    {35, y, y, {selects_SH, national_trip}},
    {36, y, y, {fact("a group that is not in the SR list", &F::group_passed_not_in_SR_list), no_override}},
    {37, y, y, {selects("driver selects override", Select::override_), slow}},
    {38, y, y, {to_0_1_2_3, national_trip}},
    {39, y, y, {to_1_2_3, no_MA}},
    {40, y, y, {in_OS}},
    {41, y, y, {no_contact, contact_trip}},
    {42, y, y, {fact("front end beyond the SR distance", &F::SR_distance_passed), no_override}},
    {43, y, y, {fact("min safe antenna passes the former EOA", &F::former_eoa_passed), no_override}},
    {44, y, y, {override_active, to_1}},
    {45, y, y, {override_active, fact("no unconditional emergency stop", &F::ues_received, false), to_2_3}},
    {46, y, y, {selects("driver selects non leading", Select::non_leading), standstill, signal("non leading signal", &S::non_leading)}},
    {47, y, y, {signal("no non leading signal", &S::non_leading, false), standstill}},
    {48, n, y, {described, fact("SSP or gradient not known for the whole train", &F::described_for_whole_train, false)}},
    {49, y, y, {fact("stop if in shunting", &F::stop_if_in_SH), no_override}},
    {50, y, y, {requested(Ack::SH), acknowledges(Ack::SH)}},
    {51, y, y, {in_SH}},
    {52, y, y, {fact("a group that is not in the SH list", &F::group_passed_not_in_SH_list), no_override}},
    {53, n, y, {described, {"driver disengages, or the selector is in stand-by", [](const Moment& m) { return m.in.driver.has(Select::ato_disengage) || !m.in.automatic_operation.active; }, Select::ato_disengage}}},
    {54, y, y, {fact("stop if in SR", &F::stop_if_in_SR), fact("no list, or not in it", &F::group_passed_in_SR_list, false), no_override}},
    {56, y, y, {to_NTC}},
    {58, y, y, {in_level("level NTC", {NTC}), requested(Ack::SN), acknowledges(Ack::SN)}},
    {59, y, y, {standstill, requested(Ack::RV), acknowledges(Ack::RV)}},
    {60, y, y, {requested(Ack::UN), acknowledges(Ack::UN)}},
    {61, y, y, {in_SH, to_1_2_3}},
    {62, y, y, {requested(Ack::trip), acknowledges(Ack::trip), standstill, in_level("level 0", {L0}), train_data}},
    {63, y, y, {requested(Ack::trip), acknowledges(Ack::trip), standstill, in_level("level NTC", {NTC}), train_data}},
    {65, y, y, {{"a telegram of a version X that is too high", is_version_too_high}, in_1_2_3}},
    {66, y, y, {fact("a linked group in the unexpected direction", &F::linked_group_wrong_direction)}},
    {67, y, y, {to_1, trip_order, no_override}},
    {68, y, y, {requested(Ack::trip), acknowledges(Ack::trip), standstill, in_0_NTC, no_train_data}},
    {69, y, y, {fact("front end in rear of the stored SSP or gradient", &F::front_in_rear_of_track_description)}},
    {70, y, y, {requested(Ack::LS), acknowledges(Ack::LS)}},
    {71, y, y, {in_LS, to_1_2_3}},
    {72, y, y, {in_LS}},
    {73, y, y, {in_OS, no_LS_ack}},
    {74, y, y, {in_LS, no_OS_ack}},
    {75, n, y, {no_OS_ack, no_profile_here}},
    {76, n, y, {no_LS_ack, no_profile_here}},
    {77, n, y, {to_0, train_data}},
    {78, n, y, {to_0_NTC, no_train_data}},
    {79, n, y, {switched("level switched to NTC", {NTC}), train_data}},
    {80, n, y, {{"automatic driving is asked for", [](const Moment& m) { return m.in.automatic_operation.requests_AD; }},
                fact("SSP and gradient known for the whole train", &F::described_for_whole_train),
                fact("no brake commanded", &F::brake_commanded, false), selects("driver engages", Select::ato_engage)}},
    {81, n, y, {fact("the RBC authorises the supervised manoeuvre asked for", &F::SM_authorised)}},
    {82, n, y, {selects("driver leaves supervised manoeuvre", Select::exit_sm), standstill}},
    {83, n, y, {train_data, fact("safe consist length in front becomes other than zero", &F::consist_in_front)}},
    {84, n, y, {fact("error of the odometer beyond the threshold", &F::odometer_beyond_threshold)}},
  };
  // clang-format on
}

}  // namespace

const std::vector<ConditionRow>& condition_rows() {
  static const std::vector<ConditionRow> all = rows();
  return all;
}

const ConditionRow* condition_row(int number, SrsVersion srs) {
  for (const ConditionRow& row : condition_rows())
    if (row.number == number && row.is_of(srs)) return &row;
  return nullptr;
}

}  // namespace evc::scenario
