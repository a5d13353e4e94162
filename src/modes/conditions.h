#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace evc::modes {

/// The conditions of SUBSET-026-4 4.6.3 by their number in the standard: bit n is condition [n].
class Conditions {
 public:
  static constexpr int kNumbers = 128;

  constexpr Conditions() = default;
  constexpr Conditions(std::initializer_list<int> numbers) {
    for (const int n : numbers) set(n);
  }
  /// `n` is 0..127; the standard uses 1..84.
  constexpr void set(int n, bool value = true) {
    const std::uint64_t bit = std::uint64_t{1} << (n % 64);
    std::uint64_t& word = words_[static_cast<std::size_t>(n) / 64];
    word = value ? (word | bit) : (word & ~bit);
  }
  constexpr bool test(int n) const { return ((words_[static_cast<std::size_t>(n) / 64] >> (n % 64)) & 1u) != 0; }
  constexpr bool any_of(const Conditions& c) const {
    return ((words_[0] & c.words_[0]) | (words_[1] & c.words_[1])) != 0;
  }
  constexpr bool none() const { return (words_[0] | words_[1]) == 0; }
  constexpr Conditions& operator|=(const Conditions& c) {
    words_[0] |= c.words_[0];
    words_[1] |= c.words_[1];
    return *this;
  }
  friend constexpr Conditions operator|(Conditions a, const Conditions& b) { return a |= b; }
  friend constexpr Conditions operator&(Conditions a, const Conditions& b) {
    a.words_[0] &= b.words_[0];
    a.words_[1] &= b.words_[1];
    return a;
  }
  friend constexpr bool operator==(const Conditions&, const Conditions&) = default;

 private:
  std::array<std::uint64_t, 2> words_{};
};

/// How long a condition stays true, which decides between two cells of equal priority (srs_4_6_2.h):
/// a state can be evaluated again in the next cycle, an event cannot, and after a level transition the unit is in a
/// level in which the old mode has no meaning.
enum class Nature : std::uint8_t { state, event, level };

/// The source of the facts of a condition. procedures/observe.h turns all 65 into bits; this names
/// the room whose values it needs.
enum class Origin : std::uint8_t {
  train_interface,    // desks, sleeping, non leading, passive shunting, power, isolation
  safety_monitor,     // the platform's own fault detection
  driver_selection,   // a request of the driver (driver/driver.h: when it is enabled)
  start_of_mission,   // procedures/start_of_mission.h
  train_trip,         // procedures/train_trip.h
  mode_profile,       // procedures/mode_profile.h: OS, LS and SH areas and their acknowledgement
  shunting,           // procedures/shunting.h
  override_,          // procedures/override.h
  level_transition,   // procedures/level_transition.h with modes/levels.h
  reversing,          // procedures/reversing.h
  staff_responsible,  // procedures/staff_responsible.h: distance and list
  authority,          // track: MA, SSP, gradient and the position of the train on them
  balise,             // balise: linking, version, trip order, stop orders
  emergency_stop,     // protection: message 16
  radio,              // radio: T_NVCONTACT
};

struct Condition {
  std::uint8_t number;
  Nature nature;
  Origin origin;
  const char* meaning;  // our words
};

// clang-format off
/// 4.6.3 of SRS 3.3.0 to 3.6.0: the 65 conditions in use. Not in use there: 9, 11, 24, 33, 48, 53
/// (empty rows), 55, 57, 64 (no such rows). "Reported" means in this cycle.
inline constexpr auto srs_4_6_3 = [] {
  using enum Nature;
  using enum Origin;
  return std::to_array<Condition>({
    { 1, state, train_interface,   "the isolation device is operated"},
    { 2, state, train_interface,   "a desk is open"},
    { 3, state, train_interface,   "standstill and no sleeping signal"},
    { 4, state, train_interface,   "the unit is supplied"},
    { 5, event, driver_selection,  "standstill, level 0, NTC or 1, driver selects shunting"},
    { 6, event, shunting,          "standstill, level 2 or 3, the RBC grants the shunting asked for"},
    { 7, event, train_trip,        "standstill, not level 0 or NTC, driver acknowledges the trip"},
    { 8, event, start_of_mission,  "staff responsible is proposed and the driver acknowledges it"},
    {10, state, authority,         "train data valid; MA, SSP and gradient stored; no mode profile in force"},
    {12, state, authority,         "level 1, min safe antenna beyond the EOA or LOA"},
    {13, state, safety_monitor,    "a fault that affects safety"},
    {14, state, train_interface,   "standstill, sleeping signal, every desk closed"},
    {15, event, mode_profile,      "on sight is requested and the driver acknowledges it"},
    {16, state, authority,         "level 2 or 3, min safe front end beyond the EOA or LOA"},
    {17, event, balise,            "the linking reaction is trip"},
    {18, event, balise,            "a balise group orders a trip and override is off"},
    {19, event, driver_selection,  "standstill, driver leaves shunting"},
    {20, event, emergency_stop,    "an unconditional emergency stop is accepted"},
    {21, level, level_transition,  "the level becomes 0"},
    {22, state, shunting,          "a desk is open and shunting has to stop at its opening"},
    {23, state, shunting,          "a desk is open and shunting may go on at its opening"},
    {25, level, level_transition,  "the level becomes 1, 2 or 3; MA, SSP and gradient stored; no mode profile in force"},
    {26, state, shunting,          "every desk closed, shunting goes on, passive shunting signal"},
    {27, state, shunting,          "every desk closed and shunting does not go on"},
    {28, state, train_interface,   "every desk closed"},
    {29, state, train_interface,   "the unit is not supplied"},
    {30, state, shunting,          "every desk closed and no passive shunting signal"},
    {31, state, authority,         "level 2 or 3; MA, SSP and gradient stored; no mode profile in force"},
    {32, state, authority,         "level 1; MA, SSP and gradient stored; no mode profile in force; the MA is no trip order"},
    {34, level, level_transition,  "the level becomes 1, 2 or 3 with the max safe front end in an on sight area"},
    {35, event, shunting,          "driver selects shunting while a national trip goes on"},
    {36, event, staff_responsible, "a balise group that is not in the SR list, override off"},
    {37, event, override_,         "driver selects override at no more than V_NVALLOWOVTRP"},
    {38, level, level_transition,  "the level becomes 0, 1, 2 or 3 while a national trip goes on"},
    {39, level, level_transition,  "the level becomes 1, 2 or 3 and no MA is accepted"},
    {40, state, mode_profile,      "the max safe front end is in an on sight area"},
    {41, state, radio,             "T_NVCONTACT has passed and its reaction is trip"},
    {42, state, staff_responsible, "the estimated front end is beyond the SR distance, override off"},
    {43, event, override_,         "min safe antenna passes the former EOA, override off"},
    {44, level, level_transition,  "override on and the level becomes 1"},
    {45, level, level_transition,  "override on, no unconditional emergency stop, and the level becomes 2 or 3"},
    {46, event, driver_selection,  "standstill, non leading signal, driver selects non leading"},
    {47, state, train_interface,   "standstill and no non leading signal"},
    {49, event, shunting,          "a balise group says stop if in shunting, override off"},
    {50, event, mode_profile,      "shunting is requested and the driver acknowledges it"},
    {51, state, mode_profile,      "the max safe front end is at or beyond the entry of a shunting area"},
    {52, event, shunting,          "a balise group that is not in the SH list, override off"},
    {54, event, staff_responsible, "a balise group says stop if in SR, is in no SR list, override off"},
    {56, level, level_transition,  "the level becomes NTC"},
    {58, event, start_of_mission,  "level NTC, national system is requested and the driver acknowledges it"},
    {59, event, reversing,         "standstill and the driver acknowledges reversing"},
    {60, event, start_of_mission,  "unfitted is requested and the driver acknowledges it"},
    {61, level, level_transition,  "the level becomes 1, 2 or 3 with the max safe front end at or beyond the entry of a shunting area"},
    {62, event, train_trip,        "standstill, level 0, train data valid, driver acknowledges the trip"},
    {63, event, train_trip,        "standstill, level NTC, train data valid, driver acknowledges the trip"},
    {65, event, balise,            "level 1, 2 or 3 and a telegram of a system version X that is too high"},
    {66, event, balise,            "a linked balise group is passed in the unexpected direction"},
    {67, level, level_transition,  "the level becomes 1, a balise group orders a trip and override is off"},
    {68, event, train_trip,        "standstill, level 0 or NTC, no valid train data, driver acknowledges the trip"},
    {69, state, authority,         "the estimated front end is in rear of the stored SSP or gradient"},
    {70, event, mode_profile,      "limited supervision is requested and the driver acknowledges it"},
    {71, level, level_transition,  "the level becomes 1, 2 or 3 with the max safe front end in a limited supervision area"},
    {72, state, mode_profile,      "the max safe front end is in a limited supervision area"},
    {73, state, mode_profile,      "as [40] and the estimated front end is not where limited supervision may be acknowledged"},
    {74, state, mode_profile,      "as [72] and the estimated front end is not where on sight may be acknowledged"},
  });
}();
// clang-format on

static_assert(srs_4_6_3.size() == 65);
static_assert(
    [] {
      for (std::size_t i = 1; i < srs_4_6_3.size(); ++i)
        if (srs_4_6_3[i - 1].number >= srs_4_6_3[i].number) return false;
      return true;
    }(),
    "the conditions are in the order of the standard");

/// All conditions of one nature.
constexpr Conditions conditions_of(Nature nature) {
  Conditions c;
  for (const Condition& row : srs_4_6_3)
    if (row.nature == nature) c.set(row.number);
  return c;
}

/// A short description of condition [n]; null when 3.x has no such condition.
constexpr const char* meaning(int n) {
  for (const Condition& row : srs_4_6_3)
    if (row.number == n) return row.meaning;
  return nullptr;
}

}  // namespace evc::modes
