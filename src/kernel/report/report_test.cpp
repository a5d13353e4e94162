#include "kernel/report/report.h"

#include <gtest/gtest.h>

#include <memory>

#include "base/test_units.h"
#include "kernel/report/radio.h"

// The outputs of a cycle from what the stages found (4.7, 3.13.10).
namespace evc::kernel {
namespace {

using evc::test::at;
using evc::test::kmh;

class Report : public ::testing::Test {
 protected:
  Report() {
    state.mode = Mode::FS;
    state.previous_mode = Mode::FS;
    state.level.level = Level::L2;
    state.data.level_status = DataStatus::valid;
    in.train.desk_open = true;
    in.train.powered = true;
  }
  const Outputs& report_now() {
    out = {};
    radio::Outbox outbox;
    kernel::report(state, in, received, decided, supervised, outbox, Log{out.events}, out);
    return out;
  }
  bool shows(Symbol symbol) {
    for (const Symbol s : report_now().symbols)
      if (s == symbol) return true;
    return false;
  }
  sdm::Result& limits() {
    if (!supervised.limits) supervised.limits.emplace();
    return *supervised.limits;
  }

  std::unique_ptr<State> memory = std::make_unique<State>();
  State& state = *memory;
  Inputs in;
  Received received;
  Decided decided;
  Supervised supervised;
  std::unique_ptr<Outputs> outputs = std::make_unique<Outputs>();
  Outputs& out = *outputs;
};

TEST_F(Report, HasTheLimitsOfSupervision) {  // 3.13.10
  sdm::Result& r = limits();
  r.monitoring = Monitoring::TSM;
  r.status = Status::Overspeed;
  r.V_P = kmh(81.0);
  r.V_W = kmh(82.0);
  r.V_SBI = kmh(83.0);
  r.V_EBI = kmh(84.0);
  r.V_MRSP = kmh(85.0);
  r.V_target = kmh(31.0);
  r.d_target = Distance{400.0};
  r.V_release = kmh(20.0);
  r.V_I = kmh(79.0);
  r.TTI = Duration{7.0};
  r.MRDT_changed = true;
  r.first_indication = Distance{55.0};
  supervised.LSSMA = kmh(45.0);
  state.position.now.V_est = kmh(82.5);
  const Outputs& o = report_now();
  EXPECT_EQ(o.monitoring, Monitoring::TSM);
  EXPECT_EQ(o.status, Status::Overspeed);
  EXPECT_EQ(o.V_P, kmh(81.0));
  EXPECT_EQ(o.V_W, kmh(82.0));
  EXPECT_EQ(o.V_SBI, kmh(83.0));
  EXPECT_EQ(o.V_EBI, kmh(84.0));
  EXPECT_EQ(o.V_MRSP, kmh(85.0));
  EXPECT_EQ(o.V_target, kmh(31.0));
  EXPECT_EQ(o.d_target, Distance{400.0});
  EXPECT_EQ(o.V_release, kmh(20.0));
  EXPECT_EQ(o.V_I, kmh(79.0));
  EXPECT_EQ(o.TTI, Duration{7.0});
  EXPECT_EQ(o.LSSMA, kmh(45.0));
  EXPECT_TRUE(o.MRDT_changed);
  EXPECT_EQ(o.d_indication, Distance{55.0});
  EXPECT_TRUE(o.memo_status.has_value());
}

TEST_F(Report, HasNoLimitsWhereSpeedIsNotSupervised) {  // 4.5.2
  const Outputs& o = report_now();
  EXPECT_EQ(o.monitoring, Monitoring::none);
  EXPECT_EQ(o.V_P, std::nullopt);
  EXPECT_EQ(o.memo_status, std::nullopt);
}

TEST_F(Report, HasTheStateOfTheUnit) {  // 4.7.2
  state.now = {12.5};
  state.level.level = Level::NTC;
  state.level.nid_ntc = 9;
  state.position.now.V_est = {3.0};
  position::Reference lrbg;
  lrbg.id = {5, 77};
  ASSERT_TRUE(state.position.references.push_back(lrbg));
  decided.here.est_front = at(1000.0);
  decided.here.min_safe_front = at(990.0);
  decided.here.max_safe_front = at(1010.0);
  state.basis.authority.EOA = at(3000.0);
  state.basis.authority.SvL = at(3050.0);
  const Outputs& o = report_now();
  EXPECT_EQ(o.now, Duration{12.5});
  EXPECT_EQ(o.mode, Mode::FS);
  EXPECT_EQ(o.level, Level::NTC);
  EXPECT_EQ(o.nid_ntc, 9);
  EXPECT_EQ(o.v, Speed{3.0});
  EXPECT_EQ(o.lrbg, (NidLrbg{5, 77}));
  EXPECT_EQ(o.est_front.from_origin, Distance{1000.0});
  EXPECT_EQ(o.min_safe_front.from_origin, Distance{990.0});
  EXPECT_EQ(o.max_safe_front.from_origin, Distance{1010.0});
  ASSERT_TRUE(o.EOA && o.SvL);
  EXPECT_EQ(o.EOA->from_origin, Distance{3000.0});
  EXPECT_EQ(o.SvL->from_origin, Distance{3050.0});
  EXPECT_TRUE(o.level_valid);
}

TEST_F(Report, HasTheLimitOfAuthorityAsItsEnd) {  // 3.8.4.3
  EXPECT_EQ(report_now().EOA, std::nullopt);
  EXPECT_EQ(report_now().SvL, std::nullopt);
  state.basis.authority.LOA = at(2500.0);
  ASSERT_TRUE(report_now().EOA.has_value());
  EXPECT_EQ(out.EOA->from_origin, Distance{2500.0});
}

TEST_F(Report, ShowsTheSymbolsOfWhatHolds) {  // 4.7.2, 015560
  const auto only_when = [&](Symbol symbol, auto&& set) {
    EXPECT_FALSE(shows(symbol));
    set();
    EXPECT_TRUE(shows(symbol));
  };
  EXPECT_TRUE(shows(Symbol::LE04));
  only_when(Symbol::ST01, [&] { decided.asked.add(brakes::Cause::T_NVCONTACT); });
  only_when(Symbol::ST02, [&] { state.slippery_rail = true; });
  only_when(Symbol::ST06, [&] { decided.reversing_possible = true; });
  only_when(Symbol::ST03, [&] { state.radio.supervising.session.indication = RadioIndication::up; });
  only_when(Symbol::ST04, [&] { state.radio.supervising.session.indication = RadioIndication::failed; });
  state.mode = Mode::SR;
  only_when(Symbol::MO03, [&] { state.override_.active = true; });
  only_when(Symbol::DR02, [&] { state.track_ahead_free.asking = true; });
}

TEST_F(Report, ShowsThatTheAntennaAlarmIsInhibited) {  // 5.22.4.1 of 4.0.0
  const auto shows_inhibition = [&](Mode mode, SrsVersion srs) {
    state.mode = mode;
    state.srs = srs;
    return report_now().shown.has(DriverOutput::bmm_inhibition);
  };
  EXPECT_FALSE(shows_inhibition(Mode::SR, SrsVersion::v4_0_0));
  state.antenna_alarm.inhibited.emplace();
  for (const Mode mode : {Mode::SB, Mode::SH, Mode::SR}) {
    EXPECT_TRUE(shows_inhibition(mode, SrsVersion::v4_0_0));
    EXPECT_FALSE(shows_inhibition(mode, SrsVersion::v3_6_0));
  }
  EXPECT_FALSE(shows_inhibition(Mode::FS, SrsVersion::v4_0_0));
}

TEST_F(Report, ShowsSlipperyRailOfTheTrackside) {  // 3.13.5.3
  state.train.L_TRAIN = {200.0};
  ASSERT_TRUE(state.track.adhesion.push_back({at(1000.0), at(1100.0), true}));
  decided.here.est_front = at(999.0);
  EXPECT_FALSE(shows(Symbol::ST02));
  decided.here.est_front = at(1290.0);
  EXPECT_TRUE(shows(Symbol::ST02));
  decided.here.est_front = at(1310.0);
  EXPECT_FALSE(shows(Symbol::ST02));
}

TEST_F(Report, ShowsAnUnprotectedCrossingUntilItIsPassed) {  // 5.16
  track::LevelCrossing lx;
  lx.unprotected = true;
  lx.from = at(1000.0);
  lx.to = at(1010.0);
  ASSERT_TRUE(state.track.lx.push_back(lx));
  decided.here.min_safe_front = at(900.0);
  EXPECT_FALSE(shows(Symbol::LX01)) << "the driver was not informed (5.16.1.4)";
  state.track.lx[0].informed = true;
  decided.here.est_front = at(1100.0);
  decided.here.min_safe_front = at(1009.5);
  EXPECT_TRUE(shows(Symbol::LX01));
  decided.here.min_safe_front = at(1010.5);
  EXPECT_FALSE(shows(Symbol::LX01));
}

TEST_F(Report, CommandsTheBrakesOfTheMode) {  // 4.4
  EXPECT_FALSE(report_now().eb);
  for (const Mode mode : {Mode::TR, Mode::NP, Mode::SF}) {
    state.brakes = {};
    state.mode = mode;
    EXPECT_TRUE(report_now().eb);
    EXPECT_EQ(out.brake_reasons.has(Cause::trip), mode == Mode::TR);
    EXPECT_EQ(out.brake_reasons.has(Cause::no_power_or_failure), mode != Mode::TR);
  }
  state.brakes = {};
  state.mode = Mode::FS;
  received.safety_fault = true;
  EXPECT_TRUE(report_now().eb);
  state.mode = Mode::IS;
  EXPECT_FALSE(report_now().eb) << "isolated from the brakes (4.4.3)";
}

TEST_F(Report, CommandsTheBrakesOfAllStages) {  // 3.14.1
  for (brakes::CauseSet* asked : {&received.asked, &decided.asked, &supervised.asked}) {
    state.brakes = {};
    asked->add(brakes::Cause::overspeed_emergency);
    EXPECT_TRUE(report_now().eb);
    *asked = {};
  }
}

TEST_F(Report, CommandsTheBrakesOfTheNationalSystem) {  // SUBSET-035 5.3.1.1
  for (std::size_t i = 0; i < kModes; ++i) {
    state.brakes = {};
    state.mode = state.previous_mode = static_cast<Mode>(i);
    in.national_system.emergency_brake = true;
    const brakes::CauseSet causes = report_now().brake_reasons;
    EXPECT_EQ(causes.has(brakes::Cause::national_system_emergency), state.mode == Mode::SN) << i;
  }
}

TEST_F(Report, CommandsTheBrakesThatAreFitted) {  // 3.13.2.2.8, 3.14.1.2
  const auto commanded = [&](bool service_brake, bool traction_cut_off) {
    state.brakes = {};
    state.train.service_brake_interface = service_brake;
    state.train.traction_cut_off_interface = traction_cut_off;
    received.asked.add(brakes::Cause::T_NVCONTACT);
    supervised.asked.add(brakes::Cause::overspeed_traction);
    return report_now();
  };
  const Outputs fitted = commanded(true, true);
  EXPECT_TRUE(fitted.sb);
  EXPECT_TRUE(fitted.tco);
  EXPECT_FALSE(fitted.eb);
  EXPECT_TRUE(commanded(false, true).eb) << "in place of the service brake (3.14.1.2)";
  EXPECT_FALSE(commanded(true, false).tco);
}

TEST_F(Report, HasTheStatusOfATripInTripModeOnly) {  // 3.13.10
  limits();
  EXPECT_EQ(report_now().memo_status, MemoStatus::Null);
  state.mode = Mode::TR;
  EXPECT_EQ(report_now().memo_status, MemoStatus::Trip);
}

TEST_F(Report, ShowsWhatTheDriverHasToAcknowledge) {  // 4.7.2, 015560
  EXPECT_FALSE(shows(Symbol::MO08));
  decided.effects.requests.add(Ack::OS);
  EXPECT_TRUE(shows(Symbol::MO08));
}

TEST_F(Report, ShowsTrackConditionsInTheModesOf_4_7_2) {
  using enum ConditionPhase;
  const auto tell = [&](TrackConditionKind kind, ConditionPhase phase) {
    ASSERT_TRUE(state.track.conditions.push_back({at(1000.0), at(1100.0), kind, {phase, 0, {}}}));
  };
  tell(TrackConditionKind::sound_horn, active);
  tell(TrackConditionKind::switch_off_eddy_current_service_brake, announced);
  tell(TrackConditionKind::switch_off_eddy_current_emergency_brake, announced);
  tell(TrackConditionKind::air_tightness, over);
  tell(TrackConditionKind::powerless_main_switch_off, ahead);
  state.track.traction = track::TractionChange{at(1200.0), 1, 7, {active, 0, {}}};
  EXPECT_TRUE(report_now().track_conditions.empty()) << "the watch says that there is nothing";
  state.track.watch.shown = true;
  report_now();
  ASSERT_EQ(out.track_conditions.size(), 4u);
  EXPECT_EQ(out.track_conditions[0].symbol, Symbol::TC35);
  EXPECT_EQ(out.track_conditions[0].kind, TrackConditionKind::sound_horn);
  EXPECT_EQ(out.track_conditions[0].phase, active);
  EXPECT_EQ(out.track_conditions[0].from.from_origin, Distance{1000.0});
  EXPECT_EQ(out.track_conditions[0].to.from_origin, Distance{1100.0});
  EXPECT_EQ(out.track_conditions[3].symbol, Symbol::TC25);
  EXPECT_EQ(out.track_conditions[3].kind, std::nullopt);
  EXPECT_TRUE(out.sound_horn);
  int eddy_current = 0;
  for (const Symbol s : out.symbols) eddy_current += s == Symbol::TC16 ? 1 : 0;
  EXPECT_EQ(eddy_current, 1) << "one symbol for both inhibitions";
  for (const Mode mode : {Mode::NL, Mode::TR, Mode::PT}) {
    state.mode = mode;
    EXPECT_FALSE(shows(Symbol::TC35));
    EXPECT_TRUE(shows(Symbol::TC25));
    EXPECT_FALSE(out.sound_horn);
  }
  state.mode = Mode::SR;
  EXPECT_FALSE(shows(Symbol::TC25));
  EXPECT_TRUE(out.ordered_areas.empty());
  state.mode = Mode::FS;
  in.train.desk_open = false;
  EXPECT_TRUE(report_now().track_conditions.empty());
}

TEST_F(Report, OrdersTheTrainWithTheDistancesOf_5_20) {
  using enum ConditionPhase;
  state.track.watch.shown = true;
  const track::Progress announced_{announced, 0, {}}, active_{active, 0, {}};
  using Kind = TrackConditionKind;
  ASSERT_TRUE(state.track.conditions.push_back({at(1000.0), at(1100.0), Kind::powerless_lower_pantograph, announced_}));
  ASSERT_TRUE(state.track.conditions.push_back({at(1000.0), at(1100.0), Kind::air_tightness, announced_}));
  ASSERT_TRUE(state.track.conditions.push_back({at(1000.0), at(1100.0), Kind::radio_hole, active_}));
  ASSERT_TRUE(state.track.platforms.push_back({at(1000.0), at(1100.0), 3, 2, announced_}));
  state.track.traction = track::TractionChange{at(1000.0), 1, 7, announced_};
  state.track.current = track::CurrentChange{at(1000.0), 600, announced_};
  track::Here& here = decided.here;
  here.min_safe_front = at(900.0);
  here.max_safe_front = at(950.0);
  here.min_safe_rear = at(700.0);
  report_now();
  ASSERT_EQ(out.ordered_areas.size(), 2u);
  EXPECT_EQ(out.ordered_areas[0].to_start, Distance{50.0});
  EXPECT_EQ(out.ordered_areas[0].to_end, Distance{200.0}) << "powerless: the min safe front end (5.20.2.3)";
  EXPECT_EQ(out.ordered_areas[1].to_start, Distance{50.0});
  EXPECT_EQ(out.ordered_areas[1].to_end, Distance{400.0}) << "air tightness: the min safe rear end (5.20.4.3)";
  ASSERT_EQ(out.ordered_platforms.size(), 1u);
  EXPECT_EQ(out.ordered_platforms[0].to_start, Distance{50.0});
  EXPECT_EQ(out.ordered_platforms[0].to_end, Distance{200.0});
  EXPECT_EQ(out.ordered_platforms[0].M_PLATFORM, 3);
  EXPECT_EQ(out.ordered_platforms[0].Q_PLATFORM, 2);
  ASSERT_TRUE(out.ordered_traction && out.ordered_current);
  EXPECT_EQ(out.ordered_traction->to_start, Distance{50.0});
  EXPECT_EQ(out.ordered_traction->M_VOLTAGE, 1);
  EXPECT_EQ(out.ordered_traction->NID_CTRACTION, 7);
  EXPECT_EQ(out.ordered_current->amperes, 600);
  here.max_safe_front = at(1050.0);
  report_now();
  EXPECT_EQ(out.ordered_areas[0].to_start, Distance{-50.0}) << "until the rear end has passed (5.20.2.4)";
  EXPECT_EQ(out.ordered_areas[1].to_start, std::nullopt) << "until the front end has passed (5.20.4.4)";
  EXPECT_EQ(out.ordered_traction->to_start, Distance{-50.0});
  here.min_safe_rear = at(1000.0);
  report_now();
  EXPECT_EQ(out.ordered_areas[0].to_start, std::nullopt);
  EXPECT_EQ(out.ordered_platforms[0].to_start, std::nullopt);
  state.track.conditions[0].progress.rear_left = Duration{1.0};
  state.track.traction->progress.rear_left = Duration{1.0};
  report_now();
  ASSERT_EQ(out.ordered_areas.size(), 1u) << "the rear end has left the powerless section (5.20.2.5)";
  EXPECT_FALSE(out.ordered_traction.has_value());
  EXPECT_FALSE(out.remote_shunting);
  state.mode = Mode::SH;
  EXPECT_TRUE(report_now().remote_shunting);
  EXPECT_FALSE(out.engine_orientation.has_value());
  state.mode = Mode::SM;
  EXPECT_EQ(report_now().engine_orientation, EngineOrientation::same) << "4.4.21.1.13";
  state.manoeuvre.opposite = true;
  EXPECT_EQ(report_now().engine_orientation, EngineOrientation::opposite);
}

TEST_F(Report, OrdersTheTrainOnlyWhatIsAnnouncedAndNotOver) {  // 5.20
  using Kind = TrackConditionKind;
  state.track.watch.shown = true;
  track::Here& here = decided.here;
  here.min_safe_front = here.max_safe_front = at(950.0);
  here.min_safe_rear = at(700.0);
  const auto orders = [&](ConditionPhase phase) {
    const track::Progress p{phase, 0, {}};
    state.track.conditions.clear();
    for (const Kind kind : {Kind::powerless_main_switch_off, Kind::sound_horn, Kind::non_stopping_area,
                            Kind::tunnel_stopping_area, Kind::radio_hole})
      EXPECT_TRUE(state.track.conditions.push_back({at(1000.0), at(1100.0), kind, p}));
    state.track.platforms.clear();
    EXPECT_TRUE(state.track.platforms.push_back({at(1000.0), at(1100.0), 3, 2, p}));
    state.track.traction = track::TractionChange{at(1000.0), 1, 7, p};
    state.track.current = track::CurrentChange{at(1000.0), 600, p};
    report_now();
    const bool any = !out.ordered_areas.empty();
    EXPECT_EQ(!out.ordered_platforms.empty(), any);
    EXPECT_EQ(out.ordered_traction.has_value(), any);
    EXPECT_EQ(out.ordered_current.has_value(), any);
    return any;
  };
  using enum ConditionPhase;
  EXPECT_FALSE(orders(ahead));
  EXPECT_FALSE(orders(over));
  for (const ConditionPhase phase : {announced, active, ending}) EXPECT_TRUE(orders(phase));
  ASSERT_EQ(out.ordered_areas.size(), 1u) << "horn, stopping areas and the radio hole concern the unit itself";
  EXPECT_EQ(out.ordered_areas[0].kind, Kind::powerless_main_switch_off);
  EXPECT_EQ(out.ordered_areas[0].to_end, Distance{150.0}) << "the min safe front end (5.20.3.3)";
  EXPECT_EQ(out.ordered_current->to_start, Distance{50.0});
  here.max_safe_front = at(1000.0);
  state.track.conditions[0].kind = Kind::switch_off_magnetic_shoe_brake;
  report_now();
  EXPECT_EQ(out.ordered_areas[0].to_start, std::nullopt) << "the front end is there (5.20.5.4)";
  state.track.watch.shown = false;
  EXPECT_TRUE(report_now().ordered_areas.empty());
}

TEST_F(Report, RemembersWhatTheDriverMayAnswer) {  // 4.7.2
  decided.effects.requests.add(Ack::OS);
  decided.effects.entries.add(Entry::train_data);
  decided.effects.offers.add(Offer::start);
  report_now();
  EXPECT_TRUE(out.requests.has(Ack::OS));
  EXPECT_TRUE(out.entries.has(Entry::train_data));
  EXPECT_TRUE(out.start_offered);
  EXPECT_TRUE(state.requested.has(Ack::OS));
  EXPECT_TRUE(state.entries.has(Entry::train_data));
  EXPECT_TRUE(state.offers.has(Offer::start));
  decided.effects = {};
  report_now();
  EXPECT_FALSE(out.start_offered);
  EXPECT_FALSE(state.requested.has(Ack::OS));
  EXPECT_FALSE(state.entries.has(Entry::train_data));
  EXPECT_FALSE(state.offers.has(Offer::start));
}

}  // namespace
}  // namespace evc::kernel
