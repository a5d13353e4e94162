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

struct Condition {
  std::uint8_t number;
  Nature nature;
  const char* meaning;  // our words
};

// clang-format off
/// 4.6.3 of SRS 3.3.0 to 3.6.0: the 65 conditions in use. Not in use there: 9, 11, 24, 33, 48, 53
/// (empty rows), 55, 57, 64 (no such rows). "Reported" means in this cycle.
inline constexpr auto srs_4_6_3 = [] {
  using enum Nature;
  return std::to_array<Condition>({
    { 1, state, "the isolation device is operated"},
    { 2, state, "a desk is open"},
    { 3, state, "standstill and no sleeping signal"},
    { 4, state, "the unit is supplied"},
    { 5, event, "standstill, level 0, NTC or 1, driver selects shunting"},
    { 6, event, "standstill, level 2 or 3, the RBC grants the shunting asked for"},
    { 7, event, "standstill, not level 0 or NTC, driver acknowledges the trip"},
    { 8, event, "staff responsible is proposed and the driver acknowledges it"},
    {10, state, "train data valid; MA, SSP and gradient stored; no mode profile in force"},
    {12, state, "level 1, min safe antenna beyond the EOA or LOA"},
    {13, state, "a fault that affects safety"},
    {14, state, "standstill, sleeping signal, every desk closed"},
    {15, event, "on sight is requested and the driver acknowledges it"},
    {16, state, "level 2 or 3, min safe front end beyond the EOA or LOA"},
    {17, event, "the linking reaction is trip"},
    {18, event, "a balise group orders a trip and override is off"},
    {19, event, "standstill, driver leaves shunting"},
    {20, event, "an unconditional emergency stop is accepted"},
    {21, level, "the level becomes 0"},
    {22, state, "a desk is open and shunting has to stop at its opening"},
    {23, state, "a desk is open and shunting may go on at its opening"},
    {25, level, "the level becomes 1, 2 or 3; MA, SSP and gradient stored; no mode profile in force"},
    {26, state, "every desk closed, shunting goes on, passive shunting signal"},
    {27, state, "every desk closed and shunting does not go on"},
    {28, state, "every desk closed"},
    {29, state, "the unit is not supplied"},
    {30, state, "every desk closed and no passive shunting signal"},
    {31, state, "level 2 or 3; MA, SSP and gradient stored; no mode profile in force"},
    {32, state, "level 1; MA, SSP and gradient stored; no mode profile in force; the MA is no trip order"},
    {34, level, "the level becomes 1, 2 or 3 with the max safe front end in an on sight area"},
    {35, event, "driver selects shunting while a national trip goes on"},
    {36, event, "a balise group that is not in the SR list, override off"},
    {37, event, "driver selects override at no more than V_NVALLOWOVTRP"},
    {38, level, "the level becomes 0, 1, 2 or 3 while a national trip goes on"},
    {39, level, "the level becomes 1, 2 or 3 and no MA is accepted"},
    {40, state, "the max safe front end is in an on sight area"},
    {41, state, "T_NVCONTACT has passed and its reaction is trip"},
    {42, state, "the estimated front end is beyond the SR distance, override off"},
    {43, event, "min safe antenna passes the former EOA, override off"},
    {44, level, "override on and the level becomes 1"},
    {45, level, "override on, no unconditional emergency stop, and the level becomes 2 or 3"},
    {46, event, "standstill, non leading signal, driver selects non leading"},
    {47, state, "standstill and no non leading signal"},
    {49, event, "a balise group says stop if in shunting, override off"},
    {50, event, "shunting is requested and the driver acknowledges it"},
    {51, state, "the max safe front end is at or beyond the entry of a shunting area"},
    {52, event, "a balise group that is not in the SH list, override off"},
    {54, event, "a balise group says stop if in SR, is in no SR list, override off"},
    {56, level, "the level becomes NTC"},
    {58, event, "level NTC, national system is requested and the driver acknowledges it"},
    {59, event, "standstill and the driver acknowledges reversing"},
    {60, event, "unfitted is requested and the driver acknowledges it"},
    {61, level, "the level becomes 1, 2 or 3 with the max safe front end at or beyond the entry of a shunting area"},
    {62, event, "standstill, level 0, train data valid, driver acknowledges the trip"},
    {63, event, "standstill, level NTC, train data valid, driver acknowledges the trip"},
    {65, event, "level 1, 2 or 3 and a telegram of a system version X that is too high"},
    {66, event, "a linked balise group is passed in the unexpected direction"},
    {67, level, "the level becomes 1, a balise group orders a trip and override is off"},
    {68, event, "standstill, level 0 or NTC, no valid train data, driver acknowledges the trip"},
    {69, state, "the estimated front end is in rear of the stored SSP or gradient"},
    {70, event, "limited supervision is requested and the driver acknowledges it"},
    {71, level, "the level becomes 1, 2 or 3 with the max safe front end in a limited supervision area"},
    {72, state, "the max safe front end is in a limited supervision area"},
    {73, state, "as [40] and the estimated front end is not where limited supervision may be acknowledged"},
    {74, state, "as [72] and the estimated front end is not where on sight may be acknowledged"},
  });
}();

/// 4.6.3 of SRS 4.0.0: the conditions that 3.x does not have. It has those of 3.x too, without level 3.
inline constexpr auto srs_4_6_3_v400 = [] {
  using enum Nature;
  return std::to_array<Condition>({
    { 9, event, "MA, SSP and gradient stored; the approach of an unprotected level crossing begins to be shown"},
    {11, event, "level 2, release speed monitoring, and a linked group at or beyond the EOA is read"},
    {24, state, "MA, SSP and gradient stored; the service or emergency brake is commanded"},
    {33, state, "MA, SSP and gradient stored; automatic operation does not ask for automatic driving"},
    {48, state, "MA, SSP and gradient stored; SSP or gradient is not known for the whole train"},
    {53, event, "MA, SSP and gradient stored; driver disengages automatic operation, or its selector is in stand-by"},
    {75, state, "no mode profile in force and the estimated front end is not where on sight may be acknowledged"},
    {76, state, "no mode profile in force and the estimated front end is not where limited supervision may be acknowledged"},
    {77, level, "the level becomes 0 and train data are valid"},
    {78, level, "the level becomes 0 or NTC and train data are not valid"},
    {79, level, "the level becomes NTC and train data are valid"},
    {80, event, "automatic driving is asked for, SSP and gradient known for the whole train, no brake commanded, driver engages it"},
    {81, event, "the RBC authorises the supervised manoeuvre asked for"},
    {82, event, "standstill, driver leaves supervised manoeuvre"},
    {83, event, "train data valid and the safe consist length in front of the engine becomes other than zero"},
    {84, state, "the accumulated error of the odometer is beyond the safety threshold"},
  });
}();
// clang-format on

static_assert(srs_4_6_3.size() == 65);
template <std::size_t N>
constexpr bool in_the_order_of_the_standard(const std::array<Condition, N>& rows) {
  for (std::size_t i = 1; i < rows.size(); ++i)
    if (rows[i - 1].number >= rows[i].number) return false;
  return true;
}
static_assert(in_the_order_of_the_standard(srs_4_6_3) && in_the_order_of_the_standard(srs_4_6_3_v400));

/// All conditions of one nature.
constexpr Conditions conditions_of(Nature nature) {
  Conditions c;
  for (const Condition& row : srs_4_6_3)
    if (row.nature == nature) c.set(row.number);
  for (const Condition& row : srs_4_6_3_v400)
    if (row.nature == nature) c.set(row.number);
  return c;
}

/// A short description of condition [n]; null when no edition has such a condition.
constexpr const char* meaning(int n) {
  for (const Condition& row : srs_4_6_3)
    if (row.number == n) return row.meaning;
  for (const Condition& row : srs_4_6_3_v400)
    if (row.number == n) return row.meaning;
  return nullptr;
}

}  // namespace evc::modes
