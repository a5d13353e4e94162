#include "kernel/report/radio.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "base/test_units.h"
#include "kernel/report/outgoing.h"
#include "modes/active_functions.h"
#include "radio/compose.h"
#include "radio/messages.h"
#include "track/indication.h"

// What the unit reports to the RBC, and when it asks for an authority (3.5, 3.6.5, 3.8.2).
namespace evc::kernel {
namespace {

using evc::test::at;

class RadioReport : public ::testing::Test {
 protected:
  RadioReport() { restart(Mode::FS); }
  /// A unit without memory, with a session in level 2.
  void restart(Mode mode) {
    state = State{};
    received = {};
    decided = {};
    state.mode = mode;
    state.level.level = Level::L2;
    state.radio.supervising.session.phase = radio::Phase::up;
    state.radio.supervising.session.M_VERSION = 33;
    state.now = {100.0};
  }
  /// The messages of one cycle.
  std::vector<radio::Intent> run(bool before_perturbation = false, RadioLink link = RadioLink::unchanged) {
    radio::Outbox outbox;
    out = {};
    Inputs inputs;
    inputs.radio_link = link;
    result = run_radio(state, inputs, received, decided, before_perturbation, outbox, Log{out.events});
    return {outbox.messages.begin(), outbox.messages.end()};
  }
  /// Q_MARQSTREASON of the request of this cycle, 0: none.
  std::uint8_t reasons(bool before_perturbation = false) {
    state.radio.reasons = 0;
    state.radio.requested_at.reset();
    for (const radio::Intent& m : run(before_perturbation))
      if (m.NID_MESSAGE == 132) return m.Q_MARQSTREASON;
    return 0;
  }
  bool sends(std::uint8_t NID_MESSAGE) {
    for (const radio::Intent& m : run())
      if (m.NID_MESSAGE == NID_MESSAGE) return true;
    return false;
  }
  bool happened(What what) const {
    for (const Event& e : out.events)
      if (e.what == what) return true;
    return false;
  }
  /// What `set` sets up is reported in the modes of the row of 4.5.2 and in no other one.
  template <class Set>
  void expect_in_modes(modes::Function row, Set set) {
    for (std::size_t i = 0; i < kModes; ++i) {
      const Mode mode = static_cast<Mode>(i);
      restart(mode);
      EXPECT_FALSE(sends(136)) << i;
      set();
      EXPECT_EQ(sends(136), modes::active(row, mode)) << i;
    }
  }
  /// The rear end leaves level 2 with this report, in level 1 and with a session.
  void leave_level_2() {
    state.level.level = Level::L1;
    state.reports.rear_border = at(-1000.0);
    EXPECT_TRUE(sends(136));
  }
  bool sends_after(double seconds) {
    state.now += Duration{seconds};
    return sends(136);
  }
  std::vector<std::uint8_t> composed(std::uint8_t NID_MESSAGE) {
    out.radio_out.clear();
    radio::Outbox outbox;
    outbox.send(NID_MESSAGE);
    compose_messages(state, {}, outbox, Log{out.events}, out);
    EXPECT_EQ(out.radio_out.size(), 1u);
    return {out.radio_out[0].bytes.begin(), out.radio_out[0].bytes.end()};
  }
  std::vector<std::uint8_t> expected(std::uint8_t NID_MESSAGE, const radio::PositionReport& position,
                                     const radio::TrainDataReport& train) const {
    radio::Intent intent;
    intent.NID_MESSAGE = NID_MESSAGE;
    std::vector<std::uint8_t> bytes(192);
    bytes.resize(radio::compose(intent, position, train, {}, 33, bytes));
    return bytes;
  }

  std::unique_ptr<State> memory = std::make_unique<State>();
  State& state = *memory;
  Received received;
  Decided decided;
  RadioResult result;
  std::unique_ptr<Outputs> outputs = std::make_unique<Outputs>();
  Outputs& out = *outputs;
};

TEST_F(RadioReport, HasTheTrainData) {  // 7.4.3.5, 7.5.1
  train::TrainData& t = state.train;
  t.L_TRAIN = {307.2};
  t.V_MAXTRAIN = {142.0 / 3.6};
  t.cant_deficiency_mm = 150;
  t.other_categories = train::kFreightP | train::kPassenger;
  t.axle_load = train::AxleLoad::C4;
  t.loading_gauge = train::LoadingGauge::GB;
  t.airtight = true;
  ASSERT_TRUE(t.traction_systems.push_back({300, 1}));
  ASSERT_TRUE(t.traction_systems.push_back({0, 0}));
  radio::PositionReport p;
  p.mode = Mode::FS;
  p.M_LEVEL = 3;  // level 2
  radio::TrainDataReport r;
  r.NC_CDTRAIN = 3;
  r.NC_TRAIN = 5;
  r.L_TRAIN = 308;    // not too small
  r.V_MAXTRAIN = 29;  // 145 km/h
  r.M_LOADINGGAUGE = 3;
  r.M_AXLELOADCAT = 6;
  r.M_AIRTIGHT = 1;
  ASSERT_TRUE(r.tractions.push_back({1, 300}));
  ASSERT_TRUE(r.tractions.push_back({0, 0}));
  EXPECT_EQ(composed(129), expected(129, p, r));
  t.L_TRAIN = {307.0};
  t.V_MAXTRAIN = {145.0 / 3.6};
  t.airtight = false;
  state.data.train_running_number = 0x4711;
  state.data.train_running_number_status = DataStatus::invalid;
  r.L_TRAIN = 307;
  r.M_AIRTIGHT = 0;
  EXPECT_EQ(composed(129), expected(129, p, r));
}

TEST_F(RadioReport, HasThePosition) {  // 7.4.3.1
  state.mode = Mode::SN;
  state.level.level = Level::NTC;
  state.level.nid_ntc = 22;
  position::Odometry& now = state.position.now;
  now.counter = {{{1000.0}}, {{990.0}}, {{1015.0}}};
  now.V_est = now.V_min = now.V_max = {12.0};
  position::Reference lrbg;
  lrbg.id = {5, 77};
  lrbg.counter = {{{800.0}}, {{800.0}}, {{800.0}}};
  lrbg.place = at(795.0);
  lrbg.Q_LOCACC = {4.0};
  lrbg.orientation = Direction::nominal;
  state.position.status = DataStatus::valid;
  ASSERT_TRUE(state.position.references.push_back(lrbg));
  const position::Report from = position::report(state.position, {});
  // The values differ from each other and from the defaults, so that none can take another's place.
  ASSERT_NE(from.D_LRBG, 32767);
  ASSERT_NE(from.L_DOUBTOVER, from.L_DOUBTUNDER);
  ASSERT_NE(from.V_TRAIN, 0);
  radio::PositionReport p;
  p.Q_SCALE = from.Q_SCALE;
  p.NID_LRBG = (5u << 14) | 77u;
  p.D_LRBG = from.D_LRBG;
  p.Q_DIRLRBG = from.Q_DIRLRBG;
  p.Q_DLRBG = from.Q_DLRBG;
  p.L_DOUBTOVER = from.L_DOUBTOVER;
  p.L_DOUBTUNDER = from.L_DOUBTUNDER;
  p.Q_LENGTH = from.Q_LENGTH;
  p.V_TRAIN = from.V_TRAIN;
  p.Q_DIRTRAIN = from.Q_DIRTRAIN;
  p.mode = Mode::SN;
  p.M_LEVEL = 1;
  p.NID_NTC = 22;
  EXPECT_EQ(composed(136), expected(136, p, {}));
  EXPECT_TRUE(state.position.references[0].reported);
}

TEST_F(RadioReport, HasTheLengthOfATrainThatIsComplete) {  // 3.6.5.2.4, 7.5.1.58, 7.5.1.106
  ASSERT_TRUE(state.position.references.push_back({}));
  state.position.status = DataStatus::valid;
  for (const auto integrity : {position::Integrity::none, position::Integrity::by_device}) {
    state.integrity.integrity = integrity;
    state.integrity.min_safe_rear = position::front(state.position).est - Distance{250.0};
    const position::Report from = position::report(state.position, state.integrity);
    radio::PositionReport p;
    p.Q_SCALE = from.Q_SCALE;
    p.NID_LRBG = from.NID_LRBG;
    p.NID_PRVLRBG = from.NID_PRVLRBG;
    p.D_LRBG = from.D_LRBG;
    p.Q_DIRLRBG = from.Q_DIRLRBG;
    p.Q_DLRBG = from.Q_DLRBG;
    p.L_DOUBTOVER = from.L_DOUBTOVER;
    p.L_DOUBTUNDER = from.L_DOUBTUNDER;
    p.Q_DIRTRAIN = from.Q_DIRTRAIN;
    p.mode = Mode::FS;
    p.M_LEVEL = M_LEVEL(Level::L2);
    if (integrity == position::Integrity::by_device) {
      p.Q_LENGTH = 1;
      p.L_TRAININT = 250;
    }
    EXPECT_EQ(composed(136), expected(136, p, {}));
  }
}

TEST_F(RadioReport, ReportsSessionsAndErrorsInTheirModes) {  // 3.6.5.1.4 l, m, 4.5.2
  expect_in_modes(modes::Function::report_session_established, [&] { state.radio.supervising.established_now = true; });
  expect_in_modes(modes::Function::report_data_consistency_error,
                  [&] { ASSERT_TRUE(state.radio.errors.push_back(ErrorReport::linked_message)); });
}

TEST_F(RadioReport, HasTheErrorInItsModesOnly) {  // 3.16.4, 4.5.2
  for (const Mode mode : {Mode::FS, Mode::SL, Mode::SH}) {
    restart(mode);
    state.radio.supervising.established_now = true;
    ASSERT_TRUE(state.radio.errors.push_back(ErrorReport::linked_message));
    for (const radio::Intent& m : run())
      EXPECT_EQ(m.M_ERROR.has_value(), m.NID_MESSAGE == 136 && mode != Mode::SH) << static_cast<int>(mode);
    EXPECT_EQ(state.radio.errors.empty(), mode != Mode::SH);
  }
}

TEST_F(RadioReport, ReportsTheIntegrityInItsModes) {  // 3.6.5.1.4 c, d, 3.6.5.2, 4.5.2
  const auto can_confirm = [&] {
    state.data.train_data_status = DataStatus::valid;
    state.radio.supervising.train_data_acknowledged = true;
    state.position.status = DataStatus::valid;
    EXPECT_TRUE(state.position.references.push_back({}));
  };
  expect_in_modes(modes::Function::report_integrity_lost, [&] {
    can_confirm();
    received.integrity = TrainIntegrity::lost;
  });
  expect_in_modes(modes::Function::report_integrity_confirmed, [&] {
    can_confirm();
    received.selected.add(Select::integrity_confirmed);
  });
  restart(Mode::FS);
  can_confirm();
  state.train.L_TRAIN = {321.0};
  received.integrity = TrainIntegrity::confirmed;
  (void)run();
  EXPECT_EQ(state.integrity.L_TRAIN, Distance{321.0});
  restart(Mode::FS);
  can_confirm();
  received.integrity = TrainIntegrity::confirmed;
  state.train_data_change.pending.emplace();
  (void)run();
  EXPECT_EQ(state.integrity.integrity, position::Integrity::none) << "another length waits for the driver";
}

TEST_F(RadioReport, WithoutPowerNoConditionOfTheContactHolds) {  // 4.4.4, 4.6.3 [41]
  restart(Mode::NP);
  state.contact_trip = true;
  (void)run();
  EXPECT_FALSE(state.contact_trip);
}

TEST_F(RadioReport, ANewSessionEndsWhatIsKnownOfTheIntegrity) {  // 3.6.5.2.6
  for (const bool established : {false, true}) {
    restart(Mode::FS);
    state.data.train_data_status = DataStatus::valid;
    state.radio.supervising.train_data_acknowledged = true;
    state.integrity.integrity = position::Integrity::lost;
    received.integrity = TrainIntegrity::lost;
    state.radio.supervising.established_now = established;
    const auto before = state.integrity;
    state.integrity.integrity = position::Integrity::by_driver;
    state.integrity.L_TRAIN = state.train.L_TRAIN;
    (void)run();
    EXPECT_EQ(state.integrity.integrity, established ? position::Integrity::lost : position::Integrity::by_driver);
    state.integrity = before;
  }
}

TEST_F(RadioReport, NotesOnlyAPositionThatWasSent) {  // 3.6.2.2.2 c
  ASSERT_TRUE(state.position.references.push_back({}));
  state.position.status = DataStatus::valid;
  composed(146);
  EXPECT_FALSE(state.position.references[0].reported);
  composed(136);
  EXPECT_TRUE(state.position.references[0].reported);
}

TEST_F(RadioReport, AsksForAnAuthorityForEachReason) {  // 3.8.2.3, 7.5.1.118.3
  EXPECT_EQ(reasons(), 0);
  decided.start_selected = true;
  EXPECT_EQ(reasons(), radio::kStartSelected);
  decided.start_selected = false;
  received.NID_LTRBG = 0x4001;
  EXPECT_EQ(reasons(), radio::kTrackAheadFree);
  received.NID_LTRBG.reset();
  state.track_description_deleted = true;
  EXPECT_EQ(reasons(), radio::kTrackDescriptionDeleted);
  state.mode = Mode::SH;
  EXPECT_EQ(reasons(), 0) << "not in SH (4.5.2)";
  state.mode = Mode::FS;
  state.level.level = Level::L1;
  EXPECT_EQ(reasons(), 0) << "not in level 1 (3.8.2.7)";
}

TEST_F(RadioReport, AsksForAnAuthorityBeforeThePerturbationOnlyWithT_MAR) {  // 3.8.2.3 b
  EXPECT_EQ(reasons(true), 0) << "no parameters";
  state.radio.ma_request.emplace();
  EXPECT_EQ(reasons(true), 0) << "T_MAR is infinite";
  state.radio.ma_request->T_MAR = Duration{20.0};
  EXPECT_EQ(reasons(true), radio::kBeforePerturbation);
  EXPECT_EQ(reasons(false), 0);
  state.level.level = Level::L1;
  EXPECT_EQ(reasons(true), 0);
}

TEST_F(RadioReport, AsksForAnAuthorityBeforeATimerEnds) {  // 3.8.2.3 c
  track::MovementAuthority ma;
  track::Section section{at(0.0), at(3000.0)};
  section.timed = true;
  section.timer = {Duration{50.0}, Duration{80.0}, true};  // until 130 s
  section.stop = at(3000.0);
  ASSERT_TRUE(ma.sections.push_back(section));
  state.track.ma = ma;
  state.radio.ma_request.emplace();
  EXPECT_EQ(reasons(), 0) << "T_TIMEOUTRQST is infinite";
  state.radio.ma_request->T_TIMEOUTRQST = Duration{29.0};
  EXPECT_EQ(reasons(), 0);
  state.radio.ma_request->T_TIMEOUTRQST = Duration{30.0};
  EXPECT_EQ(reasons(), radio::kBeforeTimeout);
}

TEST_F(RadioReport, SendsWhatTheProceduresRequire) {  // chapter 5
  using procedures::Send;
  const std::pair<Send, int> wishes[] = {{Send::shunting_request, 130}, {Send::end_of_mission, 150}};
  for (const auto& [wish, number] : wishes) {
    decided.effects.send = {};
    EXPECT_FALSE(sends(static_cast<std::uint8_t>(number)));
    decided.effects.send.add(wish);
    EXPECT_TRUE(sends(static_cast<std::uint8_t>(number)));
  }
  decided.effects.send = {};
  EXPECT_FALSE(sends(149));
  decided.track_ahead_free_granted = true;
  EXPECT_TRUE(sends(149));
  EXPECT_FALSE(sends(158));
  state.radio.supervising.session.rbc = {1, 2, 0};
  ASSERT_TRUE(decided.texts_to_report.push_back({7, 1, 3}));
  EXPECT_FALSE(sends(158)) << "another RBC is named (3.12.3.5.2)";
  ASSERT_TRUE(decided.texts_to_report.push_back({7, 1, 2}));
  EXPECT_TRUE(sends(158));
}

TEST_F(RadioReport, ReportsTheModeInEveryLevel) {  // 3.6.5.1.4 b
  decided.mode_changed = true;
  EXPECT_TRUE(sends(136));
  state.level.level = Level::L1;
  EXPECT_TRUE(sends(136));
  decided.mode_changed = false;
  EXPECT_FALSE(sends(136));
  state.level.level = Level::L2;
  EXPECT_FALSE(sends(136));
}

TEST_F(RadioReport, ReportsANewLevel) {  // 3.6.5.1.4 g
  EXPECT_FALSE(sends(136));
  received.level_switched_to = Level::L2;
  EXPECT_TRUE(sends(136));
  received.level_changed_by_driver = true;
  EXPECT_TRUE(sends(136));
}

TEST_F(RadioReport, ReportsAnError) {  // 3.6.5.1.4 l, 3.16.4
  EXPECT_FALSE(sends(136));
  ASSERT_TRUE(state.radio.errors.push_back(ErrorReport::linked_message));
  EXPECT_TRUE(sends(136));
}

using modes::Function;

TEST_F(RadioReport, ReportsEachEventInItsModes) {  // 3.6.5.1.4, 4.5.2
  expect_in_modes(Function::report_mode_change, [&] { decided.mode_changed = true; });
  for (const bool by_driver : {false, true})
    expect_in_modes(by_driver ? Function::report_level_change_driver : Function::report_level_change_trackside, [&] {
      received.level_changed_by_driver = by_driver;
      received.level_switched_to = Level::L2;
    });
}

TEST_F(RadioReport, ReportsByParametersInTheirModes) {  // 3.6.5.1.4, 4.5.2
  expect_in_modes(Function::report_rbc_requested, [&] {
    position::ReportParameters now;
    now.M_LOC = 0;
    position::set_parameters(state.reports, state.position, now);
  });
}

TEST_F(RadioReport, ReportsStandstillInItsModes) {  // 3.6.5.1.4 a, 4.5.2
  expect_in_modes(Function::report_standstill, [&] {
    position::update(state.position, {}, {90.0});
    position::update(state.position, {}, {99.0});
    ASSERT_TRUE(position::at_standstill(state.position));
  });
}

TEST_F(RadioReport, ReportsTheLevelBorderInItsModes) {  // 3.6.5.1.4 f, 4.5.2
  expect_in_modes(Function::report_level_border_rear, [&] { state.reports.rear_border = at(-1000.0); });
}

TEST_F(RadioReport, RepeatsTheReportOfTheBorderAndEndsTheSession) {  // 3.5.5.1 e, 5.10.3.3.5
  leave_level_2();
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(sends_after(14.9));
    EXPECT_TRUE(sends_after(0.1)) << i;
  }
  EXPECT_TRUE(state.radio.supervising.session.established());
  EXPECT_FALSE(sends_after(15.0));
  EXPECT_FALSE(state.radio.supervising.session.established());
}

TEST_F(RadioReport, RepeatsNoReportWithoutABorder) {  // 3.5.5.1 e
  state.level.level = Level::L1;
  for (int i = 0; i < 5; ++i) EXPECT_FALSE(sends_after(15.0));
  EXPECT_TRUE(state.radio.supervising.session.established());
}

TEST_F(RadioReport, RepeatsTheReportOfTheBorderUntilTheRBCAnswers) {  // 3.5.5.1 e
  leave_level_2();
  received.termination_ordered = true;
  EXPECT_FALSE(sends_after(1.0));
  received.termination_ordered = false;
  EXPECT_FALSE(sends_after(15.0));
}

TEST_F(RadioReport, RepeatsNoReportOfABorderInLevel2) {  // 5.10.3.3.5
  leave_level_2();
  state.level.level = Level::L2;
  EXPECT_FALSE(sends_after(15.0));
}

TEST_F(RadioReport, RepeatsNoReportWithoutASession) {  // 3.5.5.1 e
  leave_level_2();
  const radio::Session session = state.radio.supervising.session;
  state.radio.supervising.session = {};
  EXPECT_FALSE(sends_after(1.0));
  state.radio.supervising.session = session;
  EXPECT_FALSE(sends_after(15.0));
}

TEST_F(RadioReport, SendsTrainDataOfTheEngineThatLeads) {  // 3.18.3.4, 4.4.6, 4.4.15
  for (std::size_t i = 0; i < kModes; ++i) {
    restart(static_cast<Mode>(i));
    decided.effects.send.add(procedures::Send::train_data);
    EXPECT_FALSE(sends(129)) << i;
    state.data.train_data_status = DataStatus::valid;
    const bool leads = state.mode != Mode::NP && state.mode != Mode::SL && state.mode != Mode::NL;
    EXPECT_EQ(sends(129), leads) << i;
  }
}

TEST_F(RadioReport, SupervisesTheContactInItsModesAndLevels) {  // 3.16.3.4.1, 4.5.2
  const auto trips_in = [&](Mode mode, Level level) {
    restart(mode);
    state.level.level = level;
    state.national_values.T_NVCONTACT = Duration{10.0};
    state.national_values.M_NVCONTACT = Reaction::trip;
    state.radio.contact_reference = Duration{80.0};
    state.radio.was_level_2_or_3 = true;
    run();
    return state.contact_trip;
  };
  for (std::size_t i = 0; i < kModes; ++i) {
    const Mode mode = static_cast<Mode>(i);
    EXPECT_EQ(trips_in(mode, Level::L2), modes::active(Function::safe_radio_supervision, mode)) << i;
    EXPECT_FALSE(trips_in(mode, Level::L1)) << i;
  }
}

TEST_F(RadioReport, LogsTheLossOfTheSession) {  // 3.5.4
  ASSERT_NE(state.buffer.grow(), nullptr);
  state.buffer[0].medium = Medium::rbc;
  run(false, RadioLink::lost);
  EXPECT_FALSE(happened(What::session_lost)) << "the connection may come back";
  state.now += Duration{301.0};
  run();
  EXPECT_TRUE(happened(What::session_lost));
  EXPECT_TRUE(state.buffer.empty()) << "what waited came from this session (4.8.5.4 c)";
}

TEST_F(RadioReport, HasTheTrainRunningNumberWhereItIsValid) {  // 7.4.3.4
  const auto message = [&](DataStatus status, std::uint32_t number) {
    state.data.train_running_number = number;
    state.data.train_running_number_status = status;
    radio::Intent intent;
    intent.NID_MESSAGE = 136;
    intent.running_number = true;
    radio::Outbox outbox;
    outbox.send(intent);
    out = {};
    compose_messages(state, {}, outbox, Log{out.events}, out);
    return std::vector<std::uint8_t>(out.radio_out[0].bytes.begin(), out.radio_out[0].bytes.end());
  };
  EXPECT_NE(message(DataStatus::valid, 0x4711), message(DataStatus::valid, 0x4712));
  EXPECT_EQ(message(DataStatus::invalid, 0x4711), message(DataStatus::invalid, 0x4712));
}

TEST_F(RadioReport, LogsMessagesThatCouldNotBeSent) {
  radio::Outbox outbox;
  outbox.send(136);
  compose_messages(state, {}, outbox, Log{out.events}, out);
  EXPECT_FALSE(happened(What::message_not_sent));
  outbox.lost = true;
  compose_messages(state, {}, outbox, Log{out.events}, out);
  EXPECT_TRUE(happened(What::message_not_sent));
}

TEST_F(RadioReport, SendsNoMessageThatTheVersionDoesNotHave) {  // 6.6.3.4
  radio::Outbox outbox;
  outbox.send(0);
  compose_messages(state, {}, outbox, Log{out.events}, out);
  EXPECT_TRUE(out.radio_out.empty());
}

TEST_F(RadioReport, ShortensWhatIsStoredWhenTheContactIsLost) {  // 3.16.3.4.5, A.3.4 i
  state.national_values.T_NVCONTACT = Duration{10.0};
  state.national_values.M_NVCONTACT = Reaction::service_brake;
  state.radio.contact_reference = Duration{89.0};
  state.radio.was_level_2_or_3 = true;
  run();
  EXPECT_FALSE(result.asked.empty());
  EXPECT_FALSE(state.contact_trip);
  decided.here.standstill = true;
  ASSERT_TRUE(state.track.ssp.append(at(0.0), {.V_STATIC = 20}));
  run();
  EXPECT_TRUE(happened(What::track_description_shortened));
  state.radio.contact_lost = false;
  state.national_values.M_NVCONTACT = Reaction::trip;
  run();
  EXPECT_TRUE(state.contact_trip);
}

TEST_F(RadioReport, SupervisesTheContactOutsideARadioHole) {  // 3.16.3.4.1, 3.12.1.3
  state.national_values.T_NVCONTACT = Duration{10.0};
  state.national_values.M_NVCONTACT = Reaction::trip;
  state.radio.was_level_2_or_3 = true;
  const auto trips_at = [&](TrackConditionKind kind, double est_front, double max_safe_front) {
    state.track.conditions.clear();
    EXPECT_TRUE(state.track.conditions.push_back({at(1000.0), at(2000.0), kind}));
    decided.here.est_front = at(est_front);
    decided.here.max_safe_front = at(max_safe_front);
    decided.here.hole_front = decided.here.max_safe_front;
    decided.here.hole_rear = decided.here.est_front;
    track::advance_conditions(state.track, decided.here, {});
    state.radio.contact_lost = false;
    state.radio.was_in_hole = false;
    state.radio.contact_reference = Duration{80.0};
    run();
    return state.contact_trip;
  };
  using Kind = TrackConditionKind;
  EXPECT_TRUE(trips_at(Kind::radio_hole, 990.0, 999.0));
  EXPECT_FALSE(trips_at(Kind::radio_hole, 990.0, 1000.0));
  EXPECT_FALSE(trips_at(Kind::radio_hole, 1500.0, 1510.0));
  EXPECT_FALSE(trips_at(Kind::radio_hole, 1999.0, 2009.0));
  EXPECT_TRUE(trips_at(Kind::radio_hole, 2001.0, 2011.0));
  EXPECT_TRUE(trips_at(Kind::air_tightness, 1500.0, 1510.0));
}

}  // namespace
}  // namespace evc::kernel
