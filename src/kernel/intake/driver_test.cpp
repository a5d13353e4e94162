#include "kernel/intake/driver.h"

#include <gtest/gtest.h>

#include "base/test_units.h"
#include "kernel/intake/levels.h"
#include "kernel/intake/test_message.h"

// What the driver enters and selects, where it is enabled and where it is not (4.7, 5.4).
namespace evc::kernel {
namespace {

using test::at;

using evc::test::kmh;

/// At standstill in SB, with an open desk and all data entered, in a step that offers all entries (5.4.3.2 S20).
class Driver : public test::OneMessage {
 protected:
  Driver() {
    state.mode = Mode::SB;
    state.level.level = Level::L1;
    state.data.level_status = state.data.driver_id_status = state.data.train_data_status =
        state.data.train_running_number_status = DataStatus::valid;
    received.here.standstill = true;
    state.radio.supervising.session.phase = radio::Phase::up;
    for (const Offer offer : {Offer::train_data, Offer::start, Offer::driver_id, Offer::train_running_number,
                              Offer::level, Offer::rbc_contact, Offer::non_leading})
      state.offers.add(offer);
  }
  void act() {
    out = {};
    const track::Here here = received.here;
    received = {};
    received.here = here;
    receive_driver(reception);
  }
  void disable() { in.train.desk_open = false; }
};

TEST_F(Driver, EntersItsIdentity) {  // 5.4.4
  in.driver.driver_id = DriverId("4711");
  state.data.driver_id_status = DataStatus::invalid;
  disable();
  act();
  EXPECT_TRUE(state.data.driver_id.view().empty());
  EXPECT_EQ(state.data.driver_id_status, DataStatus::invalid);
  EXPECT_FALSE(received.entered.has(Entered::driver_id));
  EXPECT_TRUE(happened(What::entry_not_enabled));
  in.train.desk_open = true;
  act();
  EXPECT_EQ(state.data.driver_id.view(), "4711");
  EXPECT_EQ(state.data.driver_id_status, DataStatus::valid);
  EXPECT_TRUE(received.entered.has(Entered::driver_id));
  EXPECT_FALSE(happened(What::entry_not_enabled));
}

TEST_F(Driver, EntersTheTrainRunningNumber) {  // 5.4.4
  in.driver.train_running_number = 0x99;
  state.data.train_running_number_status = DataStatus::unknown;
  disable();
  act();
  EXPECT_EQ(state.data.train_running_number_status, DataStatus::unknown);
  EXPECT_FALSE(received.entered.has(Entered::train_running_number));
  in.train.desk_open = true;
  act();
  EXPECT_EQ(state.data.train_running_number, 0x99u);
  EXPECT_EQ(state.data.train_running_number_status, DataStatus::valid);
  EXPECT_TRUE(received.entered.has(Entered::train_running_number));
}

TEST_F(Driver, EntersOnlyWhatStartOfMissionAsksForOrOffers) {  // 5.4.3.2, 5.4.5.3
  in.train.desk_open = true;
  state.offers = {};
  state.entries = {};
  in.driver.driver_id = DriverId("4711");
  in.driver.train_running_number = 0x99;
  act();
  EXPECT_TRUE(received.entered.empty());
  state.entries.add(Entry::driver_id);  // S1
  act();
  EXPECT_EQ(received.entered, Set<Entered>{Entered::driver_id});
  state.entries = {Entry::train_running_number};  // S13
  act();
  EXPECT_EQ(received.entered, Set<Entered>{Entered::train_running_number});
  // With the driver's identity the level, where it is asked for behind it (D2).
  state.entries = {Entry::driver_id};
  in.driver.level = Level::L1;
  state.data.level_status = DataStatus::invalid;
  act();
  EXPECT_TRUE(driver_level(reception).has_value());
  state.data.level_status = DataStatus::valid;
  state.position.status = DataStatus::valid;
  act();
  EXPECT_FALSE(driver_level(reception).has_value());
}

TEST_F(Driver, EntersTheContactWithItsLevel) {  // 3.18.4.3.2
  in.train.desk_open = true;
  in.driver.rbc_contact = DriverActions::RbcContact{5, 77, 0x1234};
  in.driver.level = Level::L1;
  act();
  EXPECT_FALSE(state.radio.contact.has_value());
  in.driver.level = Level::L3;
  act();
  EXPECT_TRUE(state.radio.contact.has_value());
}

TEST_F(Driver, RevalidatesTheLastRBC) {  // 5.4.4
  in.train.desk_open = true;
  state.level.level = Level::L2;
  in.driver.selected = 1u << static_cast<unsigned>(Select::last_rbc);
  act();
  EXPECT_FALSE(received.entered.has(Entered::rbc_contact)) << "none is stored";
  EXPECT_EQ(state.contact_status, DataStatus::unknown);
  state.radio.contact = radio::Rbc{5, 77, 0x1234};
  state.contact_status = DataStatus::invalid;
  act();
  EXPECT_TRUE(received.entered.has(Entered::rbc_contact));
  EXPECT_EQ(state.contact_status, DataStatus::valid);
}

TEST_F(Driver, EntersTheContactOfTheRBC) {  // 5.4.4
  in.driver.rbc_contact = DriverActions::RbcContact{5, 77, 0x1234};
  disable();
  act();
  EXPECT_FALSE(state.radio.contact.has_value());
  EXPECT_FALSE(received.entered.has(Entered::rbc_contact));
  EXPECT_EQ(state.contact_status, DataStatus::unknown);
  in.train.desk_open = true;
  act();
  EXPECT_FALSE(state.radio.contact.has_value()) << "level 0 (3.18.4.3.2)";
  state.level.level = Level::L2;
  act();
  EXPECT_EQ(state.contact_status, DataStatus::valid);
  ASSERT_TRUE(state.radio.contact.has_value());
  EXPECT_EQ(state.radio.contact->NID_C, 5);
  EXPECT_EQ(state.radio.contact->NID_RBC, 77);
  EXPECT_EQ(state.radio.contact->NID_RADIO, 0x1234u);
  EXPECT_TRUE(received.entered.has(Entered::rbc_contact));
}

TEST_F(Driver, EntersTrainData) {  // 3.18.3
  train::TrainData data = state.train;
  data.L_TRAIN = {123.0};
  in.driver.train_data = &data;
  state.data.train_data_status = DataStatus::unknown;
  const std::uint32_t revision = state.revision;
  disable();
  act();
  EXPECT_NE(state.train.L_TRAIN, Distance{123.0});
  EXPECT_EQ(state.data.train_data_status, DataStatus::unknown);
  in.train.desk_open = true;
  act();
  EXPECT_EQ(state.train, data);
  EXPECT_EQ(state.data.train_data_status, DataStatus::valid);
  EXPECT_NE(state.revision, revision);
  EXPECT_TRUE(state.radio.supervising.train_data_pending);
  EXPECT_TRUE(received.entered.has(Entered::train_data));
  EXPECT_TRUE(happened(What::train_data_valid));
}

TEST_F(Driver, EntersNoTrainDataOutOfRange) {  // 3.18.3.2.3
  train::TrainData data = state.train;
  data.brake_percentage = 10.0;
  in.driver.train_data = &data;
  state.data.train_data_status = DataStatus::unknown;
  act();
  EXPECT_EQ(state.data.train_data_status, DataStatus::unknown);
  EXPECT_FALSE(state.radio.supervising.train_data_pending);
  EXPECT_FALSE(received.entered.has(Entered::train_data));
  EXPECT_TRUE(happened(What::train_data_refused));
}

TEST_F(Driver, AcknowledgesTrainDataThatAreStored) {  // 5.4.4, S12
  in.driver.acknowledged = 1u << static_cast<unsigned>(Ack::train_data);
  state.data.train_data_status = DataStatus::unknown;
  act();
  EXPECT_EQ(state.data.train_data_status, DataStatus::unknown);
  EXPECT_FALSE(received.entered.has(Entered::train_data));
  state.data.train_data_status = DataStatus::invalid;
  disable();
  act();
  EXPECT_EQ(state.data.train_data_status, DataStatus::invalid);
  in.train.desk_open = true;
  act();
  EXPECT_EQ(state.data.train_data_status, DataStatus::valid);
  EXPECT_TRUE(state.radio.supervising.train_data_pending);
  EXPECT_TRUE(received.entered.has(Entered::train_data));
}

TEST_F(Driver, LosesTheAuthorityOfAnotherTrain) {  // 3.18.3.7
  track::MovementAuthority ma;
  ASSERT_TRUE(ma.sections.push_back({at(0.0), at(3000.0)}));
  train::TrainData data = state.train;
  in.driver.train_data = &data;
  const auto loses = [&](DataStatus before) {
    state.track.ma = ma;
    state.buffer.clear();
    EXPECT_NE(state.buffer.grow(), nullptr);
    state.train.axle_load = data.axle_load == train::AxleLoad::A ? train::AxleLoad::D4 : train::AxleLoad::A;
    state.data.train_data_status = before;
    act();
    EXPECT_EQ(state.buffer.empty(), happened(What::track_description_shortened));
    return happened(What::track_description_shortened);
  };
  EXPECT_TRUE(loses(DataStatus::valid));
  EXPECT_FALSE(loses(DataStatus::unknown)) << "there was no other train";
}

TEST_F(Driver, SelectsTheAdhesion) {  // 3.18.4.6
  state.national_values.Q_NVDRIVER_ADHES = true;
  std::uint32_t revision = state.revision;
  const auto select = [&](Select what) {
    in.driver.selected = 1u << static_cast<unsigned>(what);
    act();
    return state.revision != std::exchange(revision, state.revision);
  };
  EXPECT_FALSE(select(Select::adhesion_normal)) << "it was normal";
  EXPECT_TRUE(select(Select::slippery_rail));
  EXPECT_TRUE(state.slippery_rail);
  EXPECT_FALSE(select(Select::slippery_rail)) << "it was slippery";
  EXPECT_TRUE(select(Select::adhesion_normal));
  EXPECT_FALSE(state.slippery_rail);
  state.national_values.Q_NVDRIVER_ADHES = false;
  EXPECT_FALSE(select(Select::slippery_rail));
  EXPECT_FALSE(state.slippery_rail);
  EXPECT_TRUE(happened(What::selection_not_enabled));
}

TEST_F(Driver, EachSelectionIsIgnoredWhereItIsNotEnabled) {  // 4.7.2
  for (const Select what :
       {Select::start, Select::override_, Select::shunting, Select::exit_shunting, Select::non_leading,
        Select::maintain_shunting, Select::slippery_rail, Select::adhesion_normal, Select::track_ahead_free}) {
    in.driver.selected = 1u << static_cast<unsigned>(what);
    disable();
    state.mode = Mode::NP;
    act();
    EXPECT_FALSE(received.selected.has(what)) << static_cast<int>(what);
    EXPECT_TRUE(happened(What::selection_not_enabled));
  }
}

TEST_F(Driver, EachSelectionHasAnInputOfItsOwn) {  // 4.7.2
  const auto enabled_in = [&](Select what) {
    in.driver.selected = 1u << static_cast<unsigned>(what);
    act();
    EXPECT_NE(received.selected.has(what), happened(What::selection_not_enabled));
    return received.selected.has(what);
  };
  state.mode = Mode::SH;
  in.train.passive_shunting = true;
  EXPECT_TRUE(enabled_in(Select::exit_shunting));
  EXPECT_TRUE(enabled_in(Select::maintain_shunting));
  EXPECT_FALSE(enabled_in(Select::shunting));
  EXPECT_FALSE(enabled_in(Select::start));
  in.train.passive_shunting = false;
  EXPECT_FALSE(enabled_in(Select::maintain_shunting));
  state.mode = Mode::SB;
  EXPECT_TRUE(enabled_in(Select::start));
  EXPECT_FALSE(enabled_in(Select::exit_shunting));
  EXPECT_FALSE(enabled_in(Select::non_leading));
  in.train.non_leading = true;
  EXPECT_TRUE(enabled_in(Select::non_leading));
  EXPECT_FALSE(enabled_in(Select::track_ahead_free));
  state.track_ahead_free.asking = true;
  EXPECT_TRUE(enabled_in(Select::track_ahead_free));
}

TEST_F(Driver, EntersSpeedAndDistanceOnlyInSR) {  // 4.4.11.1.5
  state.mode = Mode::SR;
  const auto entered = [&](std::optional<double> V_kmh, std::optional<double> D) {
    state.staff_responsible = {};
    in.driver.V_sr = V_kmh ? std::optional(kmh(*V_kmh)) : std::nullopt;
    in.driver.D_sr = D ? std::optional(Distance{*D}) : std::nullopt;
    act();
    return state.staff_responsible.V.has_value() || state.staff_responsible.end.has_value();
  };
  EXPECT_FALSE(entered({}, {}));
  EXPECT_TRUE(entered(30.0, {}));
  EXPECT_EQ(state.staff_responsible.V, kmh(30.0));
  EXPECT_EQ(state.staff_responsible.end, std::nullopt);
  const std::uint32_t revision = state.revision;
  EXPECT_TRUE(entered({}, 200.0));
  EXPECT_EQ(state.staff_responsible.V, std::nullopt);
  EXPECT_EQ(state.staff_responsible.end, at(1200.0));
  EXPECT_NE(state.revision, revision);
  EXPECT_TRUE(entered(600.0, 100000.0));
  EXPECT_TRUE(entered(0.0, 0.0));
  EXPECT_FALSE(entered(601.0, 200.0));
  EXPECT_TRUE(happened(What::SR_data_out_of_range));
  EXPECT_FALSE(entered(30.0, 100000.1));
  EXPECT_FALSE(entered(-1.0, 200.0));
  EXPECT_FALSE(entered(30.0, -1.0));
  state.mode = Mode::FS;
  EXPECT_FALSE(entered(30.0, 200.0));
  EXPECT_TRUE(happened(What::entry_not_enabled));
}

TEST_F(Driver, IsBrakedWhenMovingWhileEnteringSRData) {  // 4.4.11.1.5
  using brakes::Cause;
  const auto braked = [&](Mode mode, bool standstill) {
    state.mode = mode;
    received.here.standstill = standstill;
    in.driver.V_sr = kmh(30.0);
    act();
    return received.asked.has(Cause::movement_while_entering_SR_data);
  };
  EXPECT_TRUE(braked(Mode::SR, false));
  EXPECT_FALSE(braked(Mode::SR, true));
  EXPECT_FALSE(braked(Mode::FS, false));
}

TEST_F(Driver, SelectsALevelThatMayBeSelected) {  // 5.10.1.7, 5.10.2.8
  EXPECT_EQ(driver_level(reception), std::nullopt);
  in.driver.level = Level::L2;
  const auto level = driver_level(reception);
  ASSERT_TRUE(level.has_value());
  EXPECT_EQ(level->level, Level::L2);
  EXPECT_TRUE(received.entered.has(Entered::level));
  received.entered = {};
  modes::LevelTable table;
  modes::OrderedLevel only;
  only.level = Level::L1;
  ASSERT_TRUE(table.push_back(only));
  state.level_table = table;
  EXPECT_EQ(driver_level(reception), std::nullopt) << "not in the table of the trackside";
  EXPECT_FALSE(received.entered.has(Entered::level));
  EXPECT_TRUE(happened(What::entry_not_enabled));
  state.level_table.reset();
  disable();
  EXPECT_EQ(driver_level(reception), std::nullopt);
}

TEST_F(Driver, ChangesTheLevelAtOnce) {  // 5.10.1.7, 4.8.5.4
  state.srs = SrsVersion::v4_0_0;
  modes::PendingTransition& pending = state.level_transition.pending.emplace();
  pending.to.level = Level::L3;
  pending.border = at(5000.0);
  state.data.level_status = DataStatus::invalid;
  ASSERT_NE(state.buffer.grow(), nullptr);
  state.level.level = Level::L2;
  state.reports.rear_border = at(500.0);
  in.driver.level = Level::L1;
  run_level_transition(reception);
  EXPECT_EQ(state.level.level, Level::L1);
  EXPECT_TRUE(received.level_changed_by_driver);
  EXPECT_EQ(state.data.level_status, DataStatus::valid);
  EXPECT_TRUE(state.buffer.empty());
  EXPECT_EQ(state.reports.rear_border, std::nullopt) << "there is no border to pass";
}

TEST_F(Driver, ConfirmsTheLevelThatIs) {  // 5.4.4, S2
  state.data.level_status = DataStatus::invalid;
  in.driver.level = Level::L1;
  run_level_transition(reception);
  EXPECT_EQ(received.level_switched_to, std::nullopt);
  EXPECT_EQ(state.data.level_status, DataStatus::valid);
}

TEST_F(Driver, SelectsANationalSystemByItsNumber) {  // 5.10.1.7
  in.driver.level = Level::NTC;
  in.driver.nid_ntc = 9;
  in.national_system.available = std::uint64_t{1} << 9;
  const auto level = driver_level(reception);
  ASSERT_TRUE(level.has_value());
  EXPECT_EQ(level->nid_ntc, 9);
  in.driver.level = Level::L1;
  ASSERT_TRUE(driver_level(reception).has_value());
  EXPECT_EQ(driver_level(reception)->nid_ntc, 0);
}

TEST_F(Driver, TheLogNamesWhatWasNotEnabled) {  // 4.7.2
  disable();
  state.mode = Mode::NP;
  const train::TrainData data = state.train;
  const auto named = [&](auto&& enter) {
    in.driver = {};
    enter(in.driver);
    act();
    (void)driver_level(reception);
    EXPECT_EQ(out.events.size(), 1u);
    return out.events.empty() ? -1 : out.events[0].id;
  };
  EXPECT_EQ(named([&](DriverActions& d) { d.driver_id = DriverId("1"); }), static_cast<int>(Entered::driver_id));
  EXPECT_EQ(named([&](DriverActions& d) { d.train_running_number = 1; }),
            static_cast<int>(Entered::train_running_number));
  EXPECT_EQ(named([&](DriverActions& d) { d.train_data = &data; }), static_cast<int>(Entered::train_data));
  state.data.train_data_status = DataStatus::invalid;
  EXPECT_EQ(named([&](DriverActions& d) { d.acknowledged = 1u << static_cast<unsigned>(Ack::train_data); }),
            static_cast<int>(Entered::train_data));
  EXPECT_EQ(named([&](DriverActions& d) {
              d.rbc_contact = DriverActions::RbcContact{1, 1, 1};
            }),
            static_cast<int>(Entered::rbc_contact));
  EXPECT_EQ(named([&](DriverActions& d) { d.level = Level::L1; }), static_cast<int>(Entered::level));
  EXPECT_EQ(named([&](DriverActions& d) { d.V_sr = kmh(30.0); }), static_cast<int>(Entered::SR_speed_distance));
}

// --- Train data from another source than the driver

TEST_F(Driver, DataOfAnotherSourceAreValidatedWhereItIsAskedFor) {  // 5.17.2.2 D0
  train::TrainData good = state.train, bad = state.train;
  good.L_TRAIN = {321.0};
  bad.L_TRAIN = {-1.0};
  in.train.powered = true;
  const auto validates = [&](const train::TrainData& data, bool asked, bool pending, bool before) {
    state.train_data_change = {};
    if (pending) state.train_data_change.pending = state.train;
    state.train_data_change.driver_validates = before;
    in.external_train_data = {&data, asked};
    out = {};
    receive_external_train_data(reception);
    EXPECT_EQ(state.train_data_change.pending, data);
    EXPECT_TRUE(happened(What::train_data_changed_by_source));
    return state.train_data_change.driver_validates;
  };
  EXPECT_FALSE(validates(good, false, false, false));
  EXPECT_TRUE(validates(good, true, false, false));
  EXPECT_TRUE(validates(bad, false, false, false)) << "the driver has to enter other data";
  EXPECT_TRUE(validates(bad, true, false, false));
  EXPECT_TRUE(validates(good, false, true, true)) << "he has not done it yet";
  EXPECT_FALSE(validates(good, false, true, false));
  EXPECT_FALSE(validates(good, false, false, true)) << "that change is over";
}

TEST_F(Driver, DataOfAnotherSourceAreNewerThanAnEntry) {  // 5.17.2.2
  using Step = procedures::train_data_change::Step;
  train::TrainData other = state.train;
  other.L_TRAIN = {321.0};
  in.train.powered = true;
  in.external_train_data = {&other, false};
  for (const Entered entered : {Entered::train_data, Entered::rbc_contact}) {
    state.train_data_change.procedure.step = Step::S6;
    received.entered = {};
    received.entered.add(entered);
    receive_external_train_data(reception);
    EXPECT_EQ(state.train_data_change.procedure.step, entered == Entered::train_data ? Step::S0 : Step::S6);
  }
}

}  // namespace
}  // namespace evc::kernel
