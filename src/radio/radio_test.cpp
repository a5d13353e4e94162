#include "radio/radio.h"

#include <algorithm>
#include <array>

#include "radio/testing.h"

namespace evc::radio {
namespace {

using namespace testing;

TEST(Messages, OrderOfTimeStamps) {  // 3.16.3.3
  Unit u;
  u.up();
  const auto stamped = [&](std::uint32_t T_TRAIN) {
    return receive(u.s, {24, T_TRAIN, false}, Duration{u.now}, u.out);
  };
  const std::uint32_t base = *u.s.supervising.session.last_T_TRAIN;
  EXPECT_EQ(stamped(base), Rejected::time_stamp) << "equal";
  EXPECT_EQ(stamped(base - 1), Rejected::time_stamp);
  EXPECT_EQ(stamped(kUnknownTime), Rejected::time_stamp);
  EXPECT_EQ(u.s.errors.size(), 1u) << "reported once";
  EXPECT_EQ(u.s.errors[0], ErrorReport::radio_sequence);
  EXPECT_EQ(stamped(base + 1), Rejected::no);
  EXPECT_EQ(*u.s.supervising.session.last_T_TRAIN, base + 1);
  EXPECT_TRUE(later(5, 0xFFFFFFF0u)) << "the counter runs over";
  EXPECT_FALSE(later(0xFFFFFFF0u, 5));
}

TEST(Messages, AcknowledgementWhenAsked) {  // 3.16.3.5
  Unit u;
  u.up();
  EXPECT_EQ(u.message(24, false), Rejected::no);
  EXPECT_TRUE(u.out.messages.empty());
  u.now += 0.1;
  EXPECT_EQ(u.message(3, true), Rejected::no);
  ASSERT_EQ(u.messages(), Ids{146});
  EXPECT_EQ(u.out.messages[0].T_TRAIN_REF, T_TRAIN_of(Duration{u.now}));
  u.fresh();
  EXPECT_EQ(u.message(3, true), Rejected::time_stamp);
  EXPECT_TRUE(u.out.messages.empty()) << "a rejected message is not acknowledged";
  State idle;
  EXPECT_EQ(receive(idle, {24, 5, true}, Duration{0}, u.out), Rejected::no_session);
  for (const Rejected r : {Rejected::no_session, Rejected::terminating, Rejected::time_stamp})
    EXPECT_TRUE(static_cast<bool>(clause(r)));
  EXPECT_FALSE(static_cast<bool>(clause(Rejected::no)));
}

TEST(Messages, EveryOneHasItsOwnStamp) {  // 3.16.3.3.2
  Unit u;
  u.up();
  for (std::uint8_t i = 0; i < 5; ++i) answer_emergency_stop(i, 3, u.out);
  answer_shortening(true, 77, u.out);
  report_text_acknowledged(4, u.out);
  u.cycle();
  ASSERT_EQ(u.messages(), (Ids{147, 147, 147, 147, 147, 137, 158}));
  for (std::size_t i = 1; i < u.out.messages.size(); ++i)
    EXPECT_TRUE(later(u.out.messages[i].T_TRAIN, u.out.messages[i - 1].T_TRAIN));
  EXPECT_EQ(u.out.messages[5].T_TRAIN_REF, 77u);
  u.fresh();
  answer_shortening(false, 78, u.out);
  EXPECT_EQ(u.out.messages[0].NID_MESSAGE, 138);
  State s;
  s.supervising.session.phase = Phase::up;
  s.last_sent = 0xFFFFFFFEu;
  Outbox out;
  out.send(136);
  Inputs in;
  in.now = Duration{0};
  supervise(s, in, out);
  EXPECT_EQ(out.messages[0].T_TRAIN, 0u) << "never the code for unknown";
  EXPECT_EQ(T_TRAIN_of(Duration{12.34}), 1234u);
}

TEST(Messages, AFullOutboxSaysSo) {
  Outbox out;
  for (std::size_t i = 0; i < out.messages.capacity(); ++i) out.send(136);
  EXPECT_FALSE(out.lost);
  out.send(136);
  EXPECT_TRUE(out.lost);
}

TEST(Messages, AnAnswerToAnEmergencyStopFindsRoom) {
  Outbox out;
  out.send(147);
  for (std::size_t i = 1; i < out.messages.capacity(); ++i) out.send(146);
  const auto answers = [&] {
    return std::count_if(out.messages.begin(), out.messages.end(),
                         [](const Intent& i) { return i.NID_MESSAGE == 147; });
  };
  out.send(147);
  out.send(147);
  EXPECT_EQ(answers(), 3);
  for (std::size_t i = 0; i < out.messages.capacity(); ++i) out.send(147);
  EXPECT_EQ(static_cast<std::size_t>(answers()), out.messages.capacity());
}

TEST(Messages, AStampBecomesATime) {
  EXPECT_EQ(time_of(1000, Duration{20.0}), Duration{10.0});
  EXPECT_EQ(time_of(2001, Duration{20.0}), Duration{20.0}) << "never later than now";
  const Duration late{42949672.95 + 5.0};  // the counter has overflowed
  EXPECT_NEAR(time_of(0xFFFF'FFF0u, late).si, late.si - 5.15, 0.011);
}

TEST(Messages, WithoutASessionNoErrorIsReported) {  // 3.16.4.1
  Unit u;
  receive_inconsistent(u.s);
  EXPECT_TRUE(u.s.errors.empty());
  u.up();
  receive_inconsistent(u.s, Peer::other);
  EXPECT_TRUE(u.s.errors.empty());
}

TEST(Messages, ErrorsAreReportedOneByOne) {  // 3.16.4
  Unit u;
  u.up();
  receive_inconsistent(u.s);
  using enum ErrorReport;
  for (const ErrorReport e : {linking, linked_message, unlinked_message, radio_sequence, linking}) report_error(u.s, e);
  EXPECT_EQ(u.s.errors.size(), 4u) << "the oldest made room";
  u.cycle();
  ASSERT_EQ(u.messages(), Ids{136});
  EXPECT_EQ(u.out.messages[0].M_ERROR, linking);
  EXPECT_EQ(u.run(1).size(), 3u);
}

TEST(Contact, Reactions) {  // 3.16.3.4
  for (const Reaction reaction : {Reaction::trip, Reaction::service_brake, Reaction::none}) {
    Unit u;
    u.up();
    u.in.contact = {Duration{35}, reaction};
    u.in.contact_supervised = true;
    u.message(24);
    u.run(34.8);
    EXPECT_FALSE(u.s.contact_lost);
    u.run(0.4);
    Result r = u.cycle();
    EXPECT_TRUE(u.s.contact_lost);
    EXPECT_EQ(r.trip, reaction == Reaction::trip);
    EXPECT_EQ(r.service_brake, reaction == Reaction::service_brake);
    u.message(24);
    r = u.cycle();
    EXPECT_FALSE(r.trip || r.service_brake || u.s.contact_lost);
  }
}

TEST(Contact, AReactionThatIsOverDoesNotCountForTheNextSupervision) {  // 3.16.3.4.1.1, 3.16.3.4.1.3
  for (const bool hole : {false, true}) {
    Unit u;
    u.up();
    u.in.contact = {Duration{35}, Reaction::service_brake};
    u.in.contact_supervised = true;
    u.message(24);
    u.run(35.2);
    ASSERT_TRUE(u.cycle().service_brake);
    u.in.standstill = true;
    u.run(1.0);
    u.in.standstill = false;
    EXPECT_FALSE(u.cycle().service_brake) << "it ended at standstill";
    (hole ? u.in.in_radio_hole : u.in.contact_supervised) = hole;
    u.run(1.0);
    u.in.in_radio_hole = false;
    u.in.contact_supervised = true;
    u.run(35.2);
    EXPECT_TRUE(u.cycle().service_brake) << hole;
  }
}

TEST(Contact, TheStampCountsNotTheArrival) {
  Unit u;
  u.up();
  u.in.contact = {Duration{35}, Reaction::trip};
  u.in.contact_supervised = true;
  u.run(30);
  ASSERT_EQ(receive(u.s, {24, T_TRAIN_of(Duration{u.now - 20}), false}, Duration{u.now}, u.out), Rejected::no);
  u.run(15.2);
  EXPECT_TRUE(u.cycle().trip);
  ASSERT_EQ(receive(u.s, {24, T_TRAIN_of(Duration{u.now + 50}), false}, Duration{u.now}, u.out), Rejected::no);
  u.run(35.2);
  EXPECT_TRUE(u.cycle().trip) << "a stamp from the future does not prolong";
}

TEST(Contact, NotSupervisedElsewhereOrWithoutALimit) {
  Unit u;
  u.up();
  u.in.contact = {Duration{35}, Reaction::trip};
  u.run(100);
  EXPECT_FALSE(u.cycle().trip);
  u.in.contact_supervised = true;
  EXPECT_TRUE(u.cycle().trip) << "the old stamp counts on return";
  u.in.contact.T_NVCONTACT.reset();
  EXPECT_FALSE(u.cycle().trip);
}

TEST(Contact, TheBrakeIsReleasedAtStandstill) {
  Unit u;
  u.up();
  u.in.contact = {Duration{35}, Reaction::service_brake};
  u.in.contact_supervised = true;
  u.run(36);
  EXPECT_TRUE(u.cycle().service_brake);
  u.in.standstill = true;
  Result r = u.cycle();
  EXPECT_TRUE(r.shorten);
  EXPECT_FALSE(r.service_brake);
  u.in.standstill = false;
  r = u.cycle();
  EXPECT_FALSE(r.shorten || r.service_brake) << "not again without a new message";
}

TEST(Contact, SixtySecondsLaterTheConnectionIsSetUpAgain) {  // 3.16.3.4.3
  Unit u;
  u.up();
  u.in.contact = {Duration{35}, Reaction::none};
  u.in.contact_supervised = true;
  u.run(94);
  EXPECT_EQ(u.s.supervising.session.phase, Phase::up);
  u.run(2);
  EXPECT_EQ(u.s.supervising.session.phase, Phase::lost);
  u.cycle(RadioLink::connected);
  EXPECT_EQ(u.s.supervising.session.phase, Phase::up);
  u.run(70);
  EXPECT_EQ(u.s.supervising.session.phase, Phase::up) << "once";
}

TEST(Contact, RadioHoleAndLevelSwitchStartItAnew) {
  Unit u;
  u.up();
  u.in.contact = {Duration{35}, Reaction::trip};
  u.in.contact_supervised = true;
  u.in.in_radio_hole = true;
  u.run(100);
  EXPECT_FALSE(u.cycle().trip);
  u.in.in_radio_hole = false;
  u.run(34);
  EXPECT_FALSE(u.cycle().trip);
  u.run(2);
  EXPECT_TRUE(u.cycle().trip);
  Unit v;
  v.in.contact = u.in.contact;
  v.in.contact_supervised = true;
  v.run(36);
  EXPECT_TRUE(v.cycle().trip) << "from the switch to level 2 on, without a session";
}

TEST(TrainData, SentAcknowledgedAndSentAgain) {  // 3.18.3.4
  Unit u;
  u.up();
  EXPECT_FALSE(u.s.supervising.train_data_stamp.has_value());
  EXPECT_TRUE(u.s.supervising.train_data_acknowledged);
  send_train_data(u.s);
  u.cycle();
  ASSERT_EQ(u.messages(), Ids{129});
  EXPECT_TRUE(u.s.supervising.train_data_stamp.has_value());
  receive_train_data_ack(u.s.supervising, u.out.messages[0].T_TRAIN + 1);
  EXPECT_TRUE(u.s.supervising.train_data_stamp.has_value()) << "of another sending";
  u.fresh();
  u.cycle(RadioLink::lost);
  u.fresh();
  u.cycle(RadioLink::connected);
  EXPECT_EQ(u.messages(), Ids{129}) << "in the kept session";
  receive_train_data_ack(u.s.supervising, *u.s.supervising.train_data_stamp);
  EXPECT_FALSE(u.s.supervising.train_data_stamp.has_value());
}

/// 4.8.3 [3] of 4.0.0.
class AwaitedTrainData : public ::testing::Test {
 protected:
  void SetUp() override {
    unit_.in.route_data = kOfNow;
    begin_session();
  }
  void begin_session() {
    unit_.order_session();
    unit_.cycle();
    unit_.cycle(RadioLink::connected);
    unit_.fresh();
    unit_.version();
  }
  void end_session() {
    unit_.order_session(kRbc, false);
    unit_.cycle();
    ASSERT_EQ(unit_.message(39), Rejected::no);
    unit_.cycle(RadioLink::lost);
    unit_.fresh();
  }
  bool waits() const { return awaits_train_data_acknowledgement(unit_.s.supervising); }
  /// Sends train data; their stamp.
  std::uint32_t send(const RouteData& data) {
    unit_.in.route_data = data;
    send_train_data(unit_.s);
    unit_.fresh();
    unit_.cycle();
    return unit_.out.messages.back().T_TRAIN;
  }
  void acknowledge(std::uint32_t T_TRAIN) { receive_train_data_ack(unit_.s.supervising, T_TRAIN); }

  static constexpr RouteData kOfNow{3, 0, 1, 2, {}};
  static constexpr RouteData kHeavier{3, 0, 4, 2, {}};
  Unit unit_;
};

TEST_F(AwaitedTrainData, UntilAnyAreAcknowledgedInTheSession) {
  EXPECT_FALSE(waits()) << "none were sent yet";
  const std::uint32_t first = send(kOfNow);
  EXPECT_TRUE(waits());
  acknowledge(first + 1);
  EXPECT_TRUE(waits()) << "of nothing that was sent";
  const std::uint32_t second = send(kOfNow);
  acknowledge(first);
  EXPECT_FALSE(waits()) << "the first ones are any, and the second do not differ";
  acknowledge(second);
  end_session();
  begin_session();
  EXPECT_FALSE(waits()) << "none were sent in the new session";
  send(kOfNow);
  EXPECT_TRUE(waits());
}

TEST_F(AwaitedTrainData, ThenThoseThatDifferFromTheLastAcknowledged) {
  acknowledge(send(kOfNow));
  const std::uint32_t same = send(kOfNow);
  EXPECT_FALSE(waits());
  const std::uint32_t heavier = send(kHeavier);
  EXPECT_TRUE(waits());
  acknowledge(same);
  EXPECT_TRUE(waits());
  const std::uint32_t back = send(kOfNow);
  EXPECT_TRUE(waits()) << "the heavier ones still have no acknowledgement";
  acknowledge(heavier);
  EXPECT_TRUE(waits()) << "now the lighter ones differ";
  acknowledge(back);
  EXPECT_FALSE(waits());
}

TEST_F(AwaitedTrainData, AnAcknowledgementAnswersWhatWasSentBefore) {
  acknowledge(send(kOfNow));
  send(kHeavier);
  acknowledge(send(kOfNow));
  EXPECT_FALSE(waits());
}

TEST_F(AwaitedTrainData, EachValueCounts) {
  acknowledge(send(kOfNow));
  const auto waits_with = [this](auto change) {
    RouteData other = kOfNow;
    change(other);
    const std::uint32_t stamp = send(other);
    const bool differs = waits();
    acknowledge(stamp);
    acknowledge(send(kOfNow));
    return differs && !waits();
  };
  EXPECT_TRUE(waits_with([](RouteData& d) { d.NC_CDTRAIN = 4; }));
  EXPECT_TRUE(waits_with([](RouteData& d) { d.NC_TRAIN = 1; }));
  EXPECT_TRUE(waits_with([](RouteData& d) { d.M_AXLELOADCAT = 2; }));
  EXPECT_TRUE(waits_with([](RouteData& d) { d.M_LOADINGGAUGE = 3; }));
  EXPECT_TRUE(waits_with([](RouteData& d) { EXPECT_TRUE(d.tractions.push_back({1, 0})); }));
}

TEST_F(AwaitedTrainData, EachTractionSystemCounts) {
  const auto with = [](std::uint8_t M_VOLTAGE, std::uint16_t NID_CTRACTION) {
    RouteData d = kOfNow;
    EXPECT_TRUE(d.tractions.push_back({M_VOLTAGE, NID_CTRACTION}));
    return d;
  };
  acknowledge(send(with(1, 5)));
  acknowledge(send(with(1, 5)));
  EXPECT_FALSE(waits());
  send(with(2, 5));
  EXPECT_TRUE(waits()) << "another voltage";
  acknowledge(send(with(1, 5)));
  send(with(1, 6));
  EXPECT_TRUE(waits()) << "another system of that voltage";
}

/// However many are sent without an acknowledgement, that of the latest ends the waiting.
TEST_F(AwaitedTrainData, MoreThanAreRemembered) {
  acknowledge(send(kOfNow));
  for (int i = 0; i < 6; ++i) send(kHeavier);
  EXPECT_TRUE(waits());
  acknowledge(send(kHeavier));
  EXPECT_FALSE(waits());
}

TEST(MaRequest, RepeatedEvery60SecondsWithoutParameters) {  // 3.8.2, A.3.1
  Unit u;
  u.up();
  u.in.reasons = kStartSelected;
  u.cycle();
  ASSERT_EQ(u.messages(), Ids{132});
  EXPECT_EQ(u.out.messages[0].Q_MARQSTREASON, 1);
  u.fresh();
  EXPECT_TRUE(u.run(59).empty());
  EXPECT_EQ(u.run(2), Ids{132});
  u.in.reasons = 0;
  EXPECT_TRUE(u.run(130).empty());
}

TEST(MaRequest, ParametersAndNewReasons) {
  Unit u;
  u.up();
  u.s.ma_request = MaRequestParameters{Duration{5}, std::nullopt, std::nullopt};
  u.in.reasons = kBeforePerturbation | kBeforeTimeout;
  u.cycle();
  ASSERT_EQ(u.messages(), Ids{132});
  EXPECT_EQ(u.out.messages[0].Q_MARQSTREASON, kBeforePerturbation) << "T_TIMEOUTRQST is off";
  u.fresh();
  EXPECT_TRUE(u.run(300).empty()) << "T_CYCRQST 255: once only";
  u.in.reasons = kBeforePerturbation | kTrackDescriptionDeleted;
  u.cycle();
  EXPECT_EQ(u.messages(), Ids{132});
  EXPECT_EQ(u.out.messages[0].Q_MARQSTREASON, kBeforePerturbation | kTrackDescriptionDeleted);
  u.s.ma_request->T_CYCRQST = Duration{10};
  u.fresh();
  EXPECT_EQ(u.run(20.5).size(), 2u);
  u.s.ma_request.reset();
  u.in.reasons = kBeforePerturbation;
  EXPECT_TRUE(u.run(70).empty()) << "without parameters the criterion does not exist";
}

TEST(MaRequest, WaitsForTheSessionAndTrackAheadFreeGoesOnce) {
  Unit u;
  u.in.reasons = kStartSelected;
  u.cycle();
  EXPECT_TRUE(u.out.messages.empty());
  u.order_session();
  u.cycle(RadioLink::connected);
  u.fresh();
  u.version();
  u.cycle();
  EXPECT_EQ(u.messages(), (Ids{159, 136, 129, 132}));
  u.in.reasons = kTrackAheadFree;
  u.in.NID_LTRBG = 12345;
  u.fresh();
  u.cycle();
  ASSERT_EQ(u.messages(), Ids{132});
  EXPECT_EQ(u.out.messages[0].NID_LTRBG, 12345u);
  u.fresh();
  EXPECT_TRUE(u.run(130).empty());
}

TEST(Reports, WhenDue) {
  Unit u;
  u.up();
  u.in.report_due = true;
  u.cycle();
  EXPECT_EQ(u.messages(), Ids{136});
  EXPECT_FALSE(u.out.messages[0].M_ERROR || u.out.messages[0].running_number);
}

}  // namespace
}  // namespace evc::radio
