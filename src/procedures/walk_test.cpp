#include <gtest/gtest.h>

#include <array>
#include <cstdint>

#include "modes/mode_properties.h"
#include "modes/next_mode.h"
#include "procedures/level_transition.h"
#include "procedures/observe.h"

// A random walk through modes and levels: after any events of a cycle, the unit is never in a mode that the level does
// not have.
namespace evc::procedures {
namespace {

struct Dice {
  std::uint64_t state;
  std::uint64_t roll(std::uint64_t sides) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (state >> 33) % sides;
  }
  bool one_in(std::uint64_t n) { return roll(n) == 0; }
};

bool has_authority(Level level) { return level != Level::L0 && level != Level::NTC; }

/// Facts that can be true together: an MA and its profile are used in levels 1, 2 and 3 only; SR is proposed there
/// only, UN in level 0, SN in level NTC (5.4); override cannot be selected in SB outside level 2 and 3 (5.8.2.1).
Facts anything(Dice& dice, Mode mode, Level level) {
  Facts f;
  f.isolated = dice.one_in(400);
  f.powered = mode == Mode::NP ? dice.one_in(2) : !dice.one_in(100);
  f.desk_open = !dice.one_in(10);
  f.standstill = dice.one_in(2);
  f.sleeping = dice.one_in(5);
  f.non_leading = dice.one_in(4);
  f.passive_shunting = dice.one_in(3);
  f.safety_fault = dice.one_in(200);
  f.selects_SH = dice.one_in(10);
  f.selects_exit_SH = dice.one_in(5);
  f.selects_NL = dice.one_in(10);
  f.train_data_valid = dice.one_in(2);
  f.ma_ssp_gradient_stored = has_authority(level) && dice.one_in(2);
  f.ma_accepted = f.ma_ssp_gradient_stored || dice.one_in(2);
  f.ma_with_trip_order = dice.one_in(10);
  const bool profile = has_authority(level) && f.ma_ssp_gradient_stored;
  f.profile_demands_OS = profile && dice.one_in(4);
  f.profile_demands_LS = profile && dice.one_in(4);
  f.profile_demands_SH = profile && dice.one_in(8);
  f.profile_in_force = f.profile_demands_OS || f.profile_demands_LS || f.profile_demands_SH;
  f.front_in_OS_ack_area = profile && dice.one_in(4);
  f.front_in_LS_ack_area = profile && dice.one_in(4);
  f.mode_is_OS = mode == Mode::OS;
  f.mode_is_LS = mode == Mode::LS;
  f.min_safe_antenna_beyond_eoa = dice.one_in(30);
  f.min_safe_front_beyond_eoa = dice.one_in(30);
  f.linking_reaction_trip = dice.one_in(50);
  f.trip_order = dice.one_in(30);
  f.stop_if_in_SR = dice.one_in(30);
  f.stop_if_in_SH = dice.one_in(30);
  f.ues_accepted = has_authority(level) && dice.one_in(40);
  f.override_active = dice.one_in(4);
  f.continue_shunting = dice.one_in(2);
  f.stop_shunting_stored = dice.one_in(2);
  f.national_trip = mode == Mode::SN && dice.one_in(10);
  f.SH_granted = dice.one_in(10);
  const bool level_2_3 = level == Level::L2 || level == Level::L3;
  f.selects_override = dice.one_in(15) && (mode != Mode::SB || level_2_3);
  f.acknowledged = Set<Ack>::of_bits(static_cast<std::uint32_t>(dice.roll(1u << 12)));
  f.requested.add(Ack::trip, mode == Mode::TR);
  f.requested.add(Ack::SR, has_authority(level) && dice.one_in(3));
  f.requested.add(Ack::UN, level == Level::L0 && dice.one_in(2));
  f.requested.add(Ack::SN, level == Level::NTC && dice.one_in(2));
  f.requested.add(Ack::OS, profile && dice.one_in(3));
  f.requested.add(Ack::LS, profile && dice.one_in(3));
  f.requested.add(Ack::SH, profile && dice.one_in(3));
  f.requested.add(Ack::RV, profile && dice.one_in(20));
  f.brake_commanded = dice.one_in(20);
  f.AD_requested = !dice.one_in(10);
  f.described_for_whole_train = !dice.one_in(10);
  f.selects_ATO_engage = dice.one_in(3);
  f.ATO_disengaged = dice.one_in(20);
  f.SM_authorised = level == Level::L2 && dice.one_in(10);  // 4.8.3
  f.selects_exit_SM = dice.one_in(5);
  f.consist_in_front = dice.one_in(30);
  f.odometer_beyond_threshold = dice.one_in(400);
  return f;
}

/// SF and IS are final, and in NP nothing is received.
bool receives_orders(Mode mode) { return mode != Mode::SF && mode != Mode::IS && mode != Mode::NP; }

/// Level transitions as trackside orders them: at once, or announced for a place ahead.
class LevelOrders {
 public:
  LevelOrders(SrsVersion srs, std::uint64_t levels) : levels_(levels) {
    in_.available.national_systems[0] = ~std::uint64_t{0};
    in_.srs = srs;
  }
  /// The level after one cycle.
  Level cycle(Dice& dice, Mode mode, Level level) {
    if (!receives_orders(mode)) return level;
    in_.now += Duration{0.1};
    in_.mode = mode;
    in_.current = {level, 0, {}};
    in_.est_front = in_.max_safe_front = in_.est_front + Distance{10.0};
    level_transition::JudgedOrder judged;
    in_.order = nullptr;
    if (dice.one_in(8)) {
      judged.order.kind = dice.one_in(2) ? modes::OrderKind::announcement : modes::OrderKind::immediate;
      judged.order.border = in_.est_front + Distance{static_cast<double>(dice.roll(100))};
      EXPECT_TRUE(judged.order.table.push_back({static_cast<Level>(dice.roll(levels_)), 0, {}}));
      judged.decision = modes::judge(judged.order.kind, judged.order.table, in_.current, mode, in_.available);
      in_.order = &judged;
    }
    const auto result = level_transition::step(state_, in_);
    return result.switch_to ? result.switch_to->level : level;
  }
  /// 4.10: an announced transition is deleted in some modes.
  void entered(Mode from, Mode to) { level_transition::on_mode_change(state_, from, to, in_.srs); }

 private:
  level_transition::State state_;
  level_transition::Inputs in_;
  std::uint64_t levels_;
};

void walk(SrsVersion srs, std::size_t modes) {
  const std::uint64_t levels = srs == SrsVersion::v4_0_0 ? kLevels - 1 : kLevels;  // 4.0.0 has no level 3
  Dice dice{20240517};
  std::array<std::uint64_t, kModes> visits{};
  std::uint64_t changes_in_PT_or_RV = 0;
  for (int journey = 0; journey < 2000; ++journey) {
    Mode mode = Mode::NP;
    Level level = static_cast<Level>(dice.roll(levels));
    LevelOrders orders(srs, levels);
    for (int cycle = 0; cycle < 200; ++cycle) {
      const Level before = level;
      level = orders.cycle(dice, mode, level);
      if ((mode == Mode::PT || mode == Mode::RV) && level != before) ++changes_in_PT_or_RV;
      Facts f = anything(dice, mode, level);
      f.level = level;
      if (level != before) f.level_switched_to = level;
      const auto went = modes::next_mode(mode, observe(f, srs), srs);
      if (went.has_value()) {
        orders.entered(mode, went->to);
        mode = went->to;
      }
      ++visits[static_cast<std::size_t>(mode)];
      ASSERT_TRUE(modes::possible_in(mode, level))
          << name(mode) << " in level " << name(level) << " by [" << (went ? went->number : 0) << "]";
    }
  }
  EXPECT_GT(changes_in_PT_or_RV, 0u);  // among levels 1 to 3
  for (std::size_t m = 0; m < modes; ++m) EXPECT_GT(visits[m], 0u) << name(static_cast<Mode>(m));
}

TEST(Walk, The_mode_is_always_one_of_the_level) { walk(SrsVersion::v3_6_0, kModesOf3); }
TEST(Walk, The_mode_is_always_one_of_the_level_in_4_0_0) { walk(SrsVersion::v4_0_0, kModes); }

}  // namespace
}  // namespace evc::procedures
