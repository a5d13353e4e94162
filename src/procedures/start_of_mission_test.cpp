#include "procedures/start_of_mission.h"

#include <gtest/gtest.h>

namespace evc::procedures::start_of_mission {
namespace {

/// A driver at a desk; every call is one cycle.
struct Cab {
  State state;
  Inputs in;
  Effects last;
  Cab() { in.desk_open = true; }
  Effects& cycle() {
    last = step(state, in);
    in.enters_level = in.enters_rbc_contact = in.enters_train_data = in.selects_start = false;
    in.position_confirmed = in.train_accepted = in.train_rejected = in.SR_authorised = false;
    return last;
  }
  void give_driver_id() {
    in.driver_id = DataStatus::valid;
    cycle();
  }
  void enter_level(Level level) {
    in.level = level;
    in.enters_level = true;
    in.level_status = DataStatus::valid;
    cycle();
  }
  void enter_train_data() {
    in.train_data = DataStatus::valid;
    in.enters_train_data = true;
    cycle();
  }
  void give_running_number() {
    in.train_running_number = DataStatus::valid;
    cycle();
  }
  void start() {
    in.selects_start = true;
    cycle();
  }
  /// S10 in level 2 with an open session and an unknown position.
  void to_S10_in_level_2() {
    cycle();
    give_driver_id();
    in.mobile_terminal_registered = true;
    enter_level(Level::L2);
    EXPECT_EQ(state.step, Step::S3);
    EXPECT_TRUE(last.entries.has(Entry::rbc_contact));
    in.enters_rbc_contact = true;
    EXPECT_TRUE(cycle().send.has(Send::open_session));
    EXPECT_EQ(state.step, Step::D31);
    in.session = Session::establishing;
    cycle();
    EXPECT_EQ(state.step, Step::D31);
    in.session = Session::open;
    EXPECT_TRUE(cycle().send.has(Send::start_of_mission_report));
    EXPECT_EQ(state.step, Step::D33);
    in.train_accepted = true;
    EXPECT_TRUE(cycle().status.has(Status::position_unknown));
    EXPECT_EQ(state.step, Step::S10);
  }
  void to_S20_in_level_2() {
    to_S10_in_level_2();
    in.train_running_number = DataStatus::valid;
    enter_train_data();
    EXPECT_EQ(state.step, Step::S11);
    EXPECT_TRUE(last.send.has(Send::train_data));
    cycle();
    EXPECT_EQ(state.step, Step::S11);
    EXPECT_FALSE(last.send.has(Send::train_data));
    in.train_data_acknowledged = true;
    cycle();
    EXPECT_EQ(state.step, Step::S20);
  }
};

void start_in(Level level, Ack ack) {
  Cab cab;
  EXPECT_TRUE(cab.cycle().entries.has(Entry::driver_id));
  EXPECT_EQ(cab.state.step, Step::S1);
  cab.give_driver_id();
  EXPECT_EQ(cab.state.step, Step::S2);
  EXPECT_TRUE(cab.last.entries.has(Entry::level));
  cab.enter_level(level);
  EXPECT_TRUE(cab.last.status.has(Status::level_valid));
  EXPECT_EQ(cab.state.step, Step::S10);
  EXPECT_TRUE(cab.last.entries.has(Entry::train_data));
  EXPECT_TRUE(cab.last.offers.has(Offer::shunting));
  EXPECT_FALSE(cab.last.offers.has(Offer::start));
  cab.enter_train_data();
  EXPECT_EQ(cab.state.step, Step::S13);
  EXPECT_TRUE(cab.last.entries.has(Entry::train_running_number));
  cab.give_running_number();
  EXPECT_EQ(cab.state.step, Step::S20);
  EXPECT_TRUE(cab.last.offers.has(Offer::start));
  EXPECT_TRUE(cab.last.requests.empty());
  cab.start();
  EXPECT_EQ(cab.last.requests, Set<Ack>{ack});
  cab.cycle();
  EXPECT_EQ(cab.last.requests, Set<Ack>{ack});
  cab.in.position = DataStatus::invalid;
  cab.in.mode = Mode::SN;
  EXPECT_TRUE(cab.cycle().status.has(Status::position_unknown));
  EXPECT_EQ(cab.state.step, Step::S0);
  EXPECT_TRUE(cab.cycle().status.empty());
}

TEST(StartOfMission, Level_0) { start_in(Level::L0, Ack::UN); }
TEST(StartOfMission, Level_NTC) { start_in(Level::NTC, Ack::SN); }
TEST(StartOfMission, Level_1) { start_in(Level::L1, Ack::SR); }

TEST(StartOfMission, All_entries_in_one_cycle) {
  Cab cab;
  cab.in.driver_id = cab.in.train_data = cab.in.train_running_number = cab.in.level_status = DataStatus::valid;
  cab.in.level = Level::NTC;
  cab.in.enters_level = cab.in.enters_train_data = true;
  cab.cycle();
  EXPECT_EQ(cab.state.step, Step::S20);
  cab.start();
  EXPECT_EQ(cab.state.step, Step::S22);
}

TEST(StartOfMission, Level_2_with_SR) {
  Cab cab;
  cab.to_S20_in_level_2();
  cab.start();
  EXPECT_EQ(cab.state.step, Step::S21);
  cab.in.SR_authorised = true;
  EXPECT_TRUE(cab.cycle().requests.has(Ack::SR));
}

TEST(StartOfMission, Level_2_with_a_mode_profile) {
  for (const auto& [mode, ack] : {std::pair{Mode::OS, Ack::OS}, {Mode::LS, Ack::LS}, {Mode::SH, Ack::SH}}) {
    Cab cab;
    cab.to_S20_in_level_2();
    cab.start();
    cab.in.profile_at_front = mode;
    EXPECT_EQ(cab.cycle().requests, Set<Ack>{ack});
    EXPECT_EQ(cab.state.step, Step::S25);
    cab.cycle();
    cab.in.session = Session::none;
    cab.cycle();
    EXPECT_EQ(cab.state.step, Step::S10);
  }
}

TEST(StartOfMission, Another_level_takes_the_acknowledgement_of_a_mode_profile_back) {
  Cab cab;
  cab.to_S20_in_level_2();
  cab.start();
  cab.in.profile_at_front = Mode::OS;
  cab.cycle();
  cab.in.level = Level::L0;
  EXPECT_TRUE(cab.cycle().requests.empty());
  EXPECT_EQ(cab.state.step, Step::S20);
}

TEST(StartOfMission, The_RBC_answers_the_position) {
  Cab cab;
  cab.cycle();
  cab.in.mobile_terminal_registered = true;
  cab.in.position = DataStatus::invalid;
  cab.give_driver_id();
  EXPECT_TRUE(cab.last.status.has(Status::rbc_contact_invalid));
  cab.enter_level(Level::L2);
  cab.in.enters_rbc_contact = true;
  cab.cycle();
  cab.in.session = Session::open;
  cab.cycle();
  const Cab waiting = cab;
  cab.in.position_confirmed = true;
  EXPECT_TRUE(cab.cycle().status.has(Status::position_valid));
  EXPECT_EQ(cab.state.step, Step::S10);
  cab = waiting;
  cab.in.train_rejected = true;
  cab.cycle();
  EXPECT_TRUE(cab.last.send.has(Send::terminate_session));
  EXPECT_FALSE(cab.last.inform.has(Inform::train_rejected)) << "A40: once the session is terminated";
  cab.in.session = Session::terminating;
  EXPECT_TRUE(cab.cycle().inform.empty());
  EXPECT_EQ(cab.state.step, Step::A40);
  cab.in.session = Session::none;
  cab.cycle();
  EXPECT_TRUE(cab.last.inform.has(Inform::train_rejected));
  EXPECT_EQ(cab.state.step, Step::S10);
  cab = waiting;
  cab.cycle();
  EXPECT_EQ(cab.state.step, Step::D33);
  cab.in.session = Session::none;
  cab.cycle();
  EXPECT_EQ(cab.state.step, Step::S10);
}

TEST(StartOfMission, A_valid_position_and_level_go_straight_to_the_RBC) {
  Cab cab;
  cab.in.position = cab.in.level_status = DataStatus::valid;
  cab.in.level = Level::L2;
  cab.in.mobile_terminal_registered = true;
  cab.cycle();
  cab.give_driver_id();
  EXPECT_EQ(cab.state.step, Step::D31);
  cab.in.session = Session::open;
  cab.cycle();
  EXPECT_TRUE(cab.last.send.has(Send::start_of_mission_report));
  EXPECT_EQ(cab.state.step, Step::S10);
  // The same in level 1 needs no RBC.
  Cab one;
  one.in.position = one.in.level_status = DataStatus::valid;
  one.in.level = Level::L1;
  one.cycle();
  one.give_driver_id();
  EXPECT_EQ(one.state.step, Step::S10);
}

TEST(StartOfMission, Without_a_network_or_a_session) {
  Cab cab;
  cab.cycle();
  cab.give_driver_id();
  cab.enter_level(Level::L2);
  EXPECT_TRUE(cab.last.inform.has(Inform::network_registration_failed));
  EXPECT_EQ(cab.state.step, Step::S10);
  // Start without a session leads to SR also in level 2 (5.4.5.3 h).
  cab.in.train_running_number = DataStatus::valid;
  cab.enter_train_data();
  EXPECT_EQ(cab.state.step, Step::S10);
  EXPECT_TRUE(cab.last.offers.has(Offer::start));
  cab.start();
  EXPECT_EQ(cab.last.requests, Set<Ack>{Ack::SR});
  cab.cycle();
  EXPECT_EQ(cab.state.step, Step::S24);

  Cab known;
  known.in.position = known.in.level_status = DataStatus::valid;
  known.in.level = Level::L2;
  known.cycle();
  known.give_driver_id();
  EXPECT_TRUE(known.last.inform.has(Inform::network_registration_failed));

  Cab failed;
  failed.cycle();
  failed.give_driver_id();
  failed.in.mobile_terminal_registered = true;
  failed.enter_level(Level::L3);
  failed.in.enters_rbc_contact = true;
  failed.cycle();
  EXPECT_TRUE(failed.cycle().inform.empty());
  EXPECT_EQ(failed.state.step, Step::S10);
}

TEST(StartOfMission, A_session_lost_leads_back) {
  for (const Step lost : {Step::S11, Step::S20, Step::S21, Step::S24}) {
    Cab cab;
    cab.to_S10_in_level_2();
    cab.in.train_running_number = DataStatus::valid;
    cab.enter_train_data();
    if (lost != Step::S11) {
      cab.in.train_data_acknowledged = true;
      cab.cycle();
    }
    if (lost == Step::S21 || lost == Step::S24) cab.start();
    if (lost == Step::S24) {
      cab.in.SR_authorised = true;
      cab.cycle();
    }
    ASSERT_EQ(cab.state.step, lost);
    cab.in.session = Session::none;
    cab.cycle();
    EXPECT_EQ(cab.state.step, Step::S10) << static_cast<int>(lost);
  }
}

TEST(StartOfMission, Level_entered_again) {
  Cab cab;
  cab.to_S20_in_level_2();
  cab.enter_level(Level::L1);
  EXPECT_EQ(cab.state.step, Step::S10);
  EXPECT_TRUE(cab.last.status.has(Status::rbc_contact_invalid));
  cab.start();
  EXPECT_EQ(cab.state.step, Step::S24);
  // A level change during the request for acknowledgement withdraws the request.
  cab.in.level = Level::NTC;
  cab.cycle();
  EXPECT_EQ(cab.state.step, Step::S20);
  cab.start();
  EXPECT_EQ(cab.state.step, Step::S22);
  cab.in.level = Level::L0;
  cab.cycle();
  EXPECT_EQ(cab.state.step, Step::S20);
  cab.start();
  EXPECT_EQ(cab.state.step, Step::S23);
  cab.in.level = Level::L1;
  cab.cycle();
  EXPECT_EQ(cab.state.step, Step::S20);
}

/// 5.4.5.3 j: radio data that are entered again at S10 and S20 lead to S3, and so to the call; in levels without an RBC
/// they lead nowhere.
TEST(StartOfMission, Radio_data_entered_again) {
  for (const bool short_number : {false, true}) {
    Cab cab;
    cab.to_S20_in_level_2();
    cab.in.enters_rbc_contact = !short_number;
    cab.in.selects_short_number = short_number;
    EXPECT_TRUE(cab.cycle().send.has(Send::open_session));
    EXPECT_EQ(cab.state.step, Step::D31);
    cab.in.selects_short_number = false;
    cab.in.session = Session::establishing;
    cab.cycle();
    EXPECT_EQ(cab.state.step, Step::D31);
    cab.in.session = Session::none;  // failed: at S10 the same again
    cab.cycle();
    EXPECT_EQ(cab.state.step, Step::S10);
    cab.in.enters_rbc_contact = true;
    EXPECT_TRUE(cab.cycle().send.has(Send::open_session));
    EXPECT_EQ(cab.state.step, Step::D31);
  }
  Cab unregistered;
  unregistered.to_S20_in_level_2();
  unregistered.in.mobile_terminal_registered = false;
  unregistered.in.enters_rbc_contact = true;
  EXPECT_TRUE(unregistered.cycle().inform.has(Inform::network_registration_failed));
  EXPECT_FALSE(unregistered.last.send.has(Send::open_session));
  EXPECT_EQ(unregistered.state.step, Step::S10);
  Cab level_1;
  level_1.to_S20_in_level_2();
  level_1.enter_level(Level::L1);
  level_1.in.enters_rbc_contact = true;
  EXPECT_FALSE(level_1.cycle().send.has(Send::open_session));
  EXPECT_EQ(level_1.state.step, Step::S10);
}

TEST(StartOfMission, Train_data_that_have_to_be_revalidated) {
  Cab cab;
  cab.cycle();
  cab.give_driver_id();
  cab.enter_level(Level::L1);
  cab.in.entry_of_train_data_open = true;  // selected, not yet valid
  EXPECT_TRUE(cab.cycle().entries.has(Entry::train_data));
  EXPECT_EQ(cab.state.step, Step::S12);
  cab.cycle();
  EXPECT_EQ(cab.state.step, Step::S12);
}

TEST(StartOfMission, Waits_for_an_old_session_and_ends_with_the_desk) {
  Cab cab;
  cab.in.session = Session::open;
  cab.cycle();
  EXPECT_EQ(cab.state.step, Step::S0);
  cab.in.session = Session::none;
  cab.cycle();
  EXPECT_EQ(cab.state.step, Step::S1);
  cab.in.desk_open = false;
  cab.cycle();
  EXPECT_EQ(cab.state.step, Step::S0);
  EXPECT_TRUE(cab.last.entries.empty());
}

}  // namespace
}  // namespace evc::procedures::start_of_mission
