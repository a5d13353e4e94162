#include "kernel/intake/groups.h"

#include <gtest/gtest.h>

#include <deque>
#include <vector>

#include "kernel/intake/test_message.h"
#include "lang/packets/packet_12.h"
#include "lang/packets/packet_3.h"
#include "lang/packets/packet_66.h"

// What reading a balise group does to the unit, beside what its packets say (3.4, 3.6.1, 3.16.2).
namespace evc::kernel {
namespace {

using test::at;

constexpr Mode kOnTheTrack[] = {Mode::SB, Mode::SH, Mode::PS, Mode::FS, Mode::LS, Mode::SR, Mode::OS,
                                Mode::SL, Mode::NL, Mode::UN, Mode::TR, Mode::PT, Mode::SN, Mode::RV};

class Groups : public test::OneMessage {
 protected:
  Groups() {
    restart(Mode::FS, Level::L2);
    runs(900.0, 1000.0);
  }
  /// A unit without memory, after a movement from one counter to another.
  void restart(Mode mode, Level level = Level::L1) {
    state = State{};
    state.mode = mode;
    state.level.level = level;
    state.train.L_antenna_front = {0.0};
    received = Received{};
  }
  void runs(double from, double to) {
    state.position = {};
    moves_to(from);
    moves_to(to);
  }
  void moves_to(double counter) {
    position::Odometry o;
    o.counter = {{{counter}}, {{counter}}, {{counter}}};
    position::update(state.position, o, state.now);
  }
  static lang::TelegramHeader balise(std::uint16_t NID_BG, std::uint8_t N_PIG = 0, std::uint8_t N_TOTAL = 0,
                                     std::uint8_t Q_LINK = 1) {
    lang::TelegramHeader h;
    h.N_PIG.raw = N_PIG;
    h.N_TOTAL.raw = N_TOTAL;
    h.NID_C.raw = 1;
    h.NID_BG.raw = NID_BG;
    h.Q_LINK.raw = Q_LINK;
    return h;
  }
  /// A balise that is read in the next cycle, where the counter is `counter`.
  template <class... P>
  void lies(double counter, const lang::TelegramHeader& header, const P&... contents) {
    lies_with(counter, header, [&](BitWriter& writer) { (lang::encode(writer, contents), ...); });
  }
  template <class Write>
  void lies_with(double counter, const lang::TelegramHeader& header, Write write) {
    std::array<std::uint8_t, 104>& bytes = memory_of_telegrams.emplace_back();
    BitWriter writer(bytes);
    lang::begin_telegram(writer, header);
    write(writer);
    lang::end_telegram(writer, 830);
    ASSERT_FALSE(writer.faulty());
    telegrams.push_back({bytes, 830, {{counter}}});
  }
  void cycle() {
    out = {};
    in.balise_telegrams = telegrams;
    receive_balises(reception);
    telegrams.clear();
    in.balise_telegrams = {};
  }
  int times(What what) const {
    int n = 0;
    for (const Event& e : out.events) n += e.what == what ? 1 : 0;
    return n;
  }
  /// A group of which one balise is not read.
  void pass_incomplete(std::uint8_t Q_LINK = 0) {
    lies(1000.0, balise(200, 0, 1, Q_LINK));
    cycle();
    moves_to(1020.0);
    cycle();
  }
  void announce(std::uint16_t NID_BG, double place, Reaction reaction = Reaction::service_brake) {
    balise::Link link;
    link.id = {1, NID_BG};
    link.place = at(place);
    link.Q_LOCACC = {5.0};
    link.reaction = reaction;
    link.crossing = Direction::nominal;
    link.gives_orientation = true;
    ASSERT_TRUE(state.balise.linking.links.push_back(link));
    state.balise.linking.used_until = at(place + 100.0);
  }
  static lang::Packet3 values(std::uint8_t Q_DIR) {
    lang::Packet3 p;
    p.Q_DIR.raw = Q_DIR;
    return p;
  }

  std::deque<std::array<std::uint8_t, 104>> memory_of_telegrams;
  std::vector<BaliseTelegram> telegrams;
};

TEST_F(Groups, InSleepingAndShuntingTheDirectionOfPassageCounts) {  // 3.6.3.1.3
  // Backward over a group that the cab faces in its nominal direction.
  const auto evaluated = [&](Mode mode, std::uint8_t Q_DIR) {
    restart(mode);
    runs(1100.0, 995.0);
    lies(1003.0, balise(200, 1, 1));
    lies(1000.0, balise(200, 0, 1), values(Q_DIR));
    cycle();
    EXPECT_EQ(times(What::group_accepted), 1);
    return told(3).times == 1;
  };
  for (const Mode mode : {Mode::SB, Mode::NL, Mode::UN, Mode::TR, Mode::SN, Mode::SL, Mode::PS, Mode::SH}) {
    const bool crossing = mode == Mode::SL || mode == Mode::PS || mode == Mode::SH;
    EXPECT_EQ(evaluated(mode, 0), crossing) << static_cast<int>(mode);
    EXPECT_EQ(evaluated(mode, 1), !crossing) << static_cast<int>(mode);
  }
}

TEST_F(Groups, DuringAForbiddenMovementAreIgnored) {  // 3.14.3.6, 4.5.2
  const auto accepted = [&](Mode mode, double from) {
    restart(mode);
    runs(from, 1000.0);
    lies(1000.0, balise(200));
    cycle();
    return received.new_lrbg;
  };
  for (const Mode mode : kOnTheTrack) {
    const bool backward_only = mode == Mode::PT || mode == Mode::RV;
    const bool forward_only = mode == Mode::FS || mode == Mode::LS || mode == Mode::SR || mode == Mode::OS;
    EXPECT_EQ(accepted(mode, 900.0), !backward_only) << static_cast<int>(mode);
    EXPECT_EQ(accepted(mode, 1100.0), !forward_only) << static_cast<int>(mode);
  }
}

// 3.16.2.5.1; 4.4.6.1.12, 4.4.14.1.9, 4.4.15.1.10, 4.4.18.1.10, 4.4.20.1.15
TEST_F(Groups, AnInconsistentOneBrakesNotInEveryMode) {
  for (const Mode mode : kOnTheTrack) {
    restart(mode);
    mode == Mode::PT || mode == Mode::RV ? runs(1100.0, 1000.0) : runs(900.0, 1000.0);
    pass_incomplete();
    const bool exempt =
        mode == Mode::SL || mode == Mode::PT || mode == Mode::NL || mode == Mode::RV || mode == Mode::PS;
    EXPECT_TRUE(happened(What::group_inconsistent)) << static_cast<int>(mode);
    EXPECT_EQ(received.asked.has(brakes::Cause::balise_group_consistency), !exempt) << static_cast<int>(mode);
  }
}

TEST_F(Groups, ErrorsAreReportedToAnRBCOnly) {  // 3.16.4.1
  pass_incomplete();
  ASSERT_EQ(state.radio.errors.size(), 1u);
  EXPECT_EQ(state.radio.errors[0], ErrorReport::unlinked_message);
  restart(Mode::FS, Level::L1);
  runs(900.0, 1000.0);
  pass_incomplete();
  EXPECT_TRUE(happened(What::group_inconsistent));
  EXPECT_TRUE(state.radio.errors.empty());
  restart(Mode::FS, Level::L2);
  runs(900.0, 1000.0);
  announce(200, 1000.0);
  lies(1000.0, balise(200));
  cycle();
  EXPECT_TRUE(happened(What::linking_ok));
  EXPECT_TRUE(state.radio.errors.empty());
}

TEST_F(Groups, OutsideItsWindowBrakesBecauseOfLinking) {  // 3.16.2.3.1
  const auto linking_brake_after = [&](double place, double run_to) {
    restart(Mode::FS);
    runs(900.0, 1000.0);
    announce(200, place);
    if (place > 1000.0) lies(1000.0, balise(200));
    cycle();
    moves_to(run_to);
    cycle();
    return received.asked.has(brakes::Cause::linking);
  };
  EXPECT_TRUE(linking_brake_after(1100.0, 1000.0)) << "found too early";
  EXPECT_TRUE(linking_brake_after(1000.0, 1030.0)) << "not found";
  EXPECT_FALSE(linking_brake_after(1000.0, 1000.0));
}

TEST_F(Groups, InTheUnexpectedDirectionTrips) {  // 3.16.2.3.2, condition [66]
  state.mode = Mode::FS;
  announce(200, 1000.0, Reaction::none);
  lies(997.0, balise(200, 1, 1));
  lies(1000.0, balise(200, 0, 1));
  cycle();
  EXPECT_TRUE(received.linked_group_wrong_direction);
}

TEST_F(Groups, TheAccuracyOfANewLRBGChangesTheReleaseSpeedCalculatedOnBoard) {  // 3.13.9.4.8.2
  const auto changes = [&](ReleaseSpeedChoice kind) {
    restart(Mode::FS);
    runs(900.0, 1000.0);
    state.basis.authority.release.kind = kind;
    lies(1000.0, balise(200));
    cycle();
    return state.revision != 0;
  };
  EXPECT_TRUE(changes(ReleaseSpeedChoice::on_board));
  EXPECT_FALSE(changes(ReleaseSpeedChoice{}));
}

TEST_F(Groups, DataOfAnUnlinkedOneMoveWithTheNextLRBG) {  // 3.6.4.2.5, 3.6.4.3
  const auto moves_inexactly = [&](double x) {
    position::Odometry o;
    o.counter = {{{x}}, {{0.98 * x}}, {{1.03 * x}}};
    position::update(state.position, o, state.now);
  };
  const auto store = [&](Anchor anchor) {
    state.anchors = {};
    state.anchors.add(anchor, anchor != Anchor::lrbg);
    state.level_transition.pending = modes::PendingTransition{{Level::L2, 0}, at(1500.0), anchor};
    state.pending_national_values = {at(1600.0), anchor, {}};
    state.buffer.clear();
    for (const Anchor of : {anchor, Anchor::lrbg}) {
      BufferedSet& set = *state.buffer.grow();
      set = {};
      set.reference = at(1700.0);
      set.anchor = of;
      set.widening = {{}, {1.0}, {2.0}};
    }
  };
  for (const Anchor anchor : {Anchor::unlinked, Anchor::travelled, Anchor::lrbg}) {
    restart(Mode::FS, Level::L1);
    state.position = {};
    moves_inexactly(500.0);
    moves_inexactly(600.0);
    lies(600.0, balise(100));
    cycle();
    moves_inexactly(800.0);
    lies(800.0, balise(150, 0, 0, 0));
    cycle();
    ASSERT_TRUE(state.position.unlinked.has_value());
    moves_inexactly(1000.0);
    store(anchor);
    announce(200, position::front(state.position).est.from_origin.si + 3.0);
    const auto copy = std::make_unique<position::State>(state.position);
    position::Passage passage;
    passage.id = {1, 200};
    passage.counter = {{{1000.0}}, {{980.0}}, {{1030.0}}};
    passage.Q_LOCACC = {5.0};
    passage.link_place = state.balise.linking.links[0].place;
    passage.single = true;
    const position::Relocated all = position::relocate(*copy, passage);
    ASSERT_TRUE(all.unlinked.nearer.si > 0.0 && all.unlinked.farther.si > 0.0 && all.unlinked.shift.si != 0.0);
    ASSERT_TRUE(all.travelled.nearer.si > 0.0);
    const Relocation by = anchor == Anchor::unlinked    ? all.unlinked
                          : anchor == Anchor::travelled ? all.travelled
                                                        : Relocation{};
    const Anchor then = anchor == Anchor::unlinked ? Anchor::travelled : Anchor::lrbg;
    received.new_lrbg = false;
    lies(1000.0, balise(200));
    cycle();
    ASSERT_TRUE(received.new_lrbg);
    EXPECT_FALSE(happened(What::odometer_out_of_tolerance));
    EXPECT_EQ(state.level_transition.pending->border, at(1500.0) + by.shift);
    EXPECT_EQ(state.pending_national_values->from, at(1600.0) + by.shift);
    EXPECT_EQ(state.buffer[0].reference, at(1700.0) + by.shift);
    EXPECT_EQ(state.buffer[0].widening.nearer, Distance{1.0} + by.nearer);
    EXPECT_EQ(state.buffer[0].widening.farther, Distance{2.0} + by.farther);
    EXPECT_EQ(state.level_transition.pending->anchor, then);
    EXPECT_EQ(state.pending_national_values->anchor, then);
    EXPECT_EQ(state.buffer[0].anchor, then);
    EXPECT_EQ(state.buffer[1].reference, at(1700.0));
    EXPECT_EQ(state.buffer[1].anchor, Anchor::lrbg);
    EXPECT_FALSE(state.anchors.has(Anchor::unlinked));
    EXPECT_EQ(state.anchors.has(Anchor::travelled), anchor == Anchor::unlinked);
    EXPECT_FALSE(state.anchors.has(Anchor::lrbg)) << "they do not count";
  }
}

TEST_F(Groups, DataOfAnUnlinkedOneMoveWithTheNextWithoutAnLRBG) {  // 3.6.4.7
  const auto moves_inexactly = [&](double x) {
    position::Odometry o;
    o.counter = {{{x}}, {{0.98 * x}}, {{1.03 * x}}};
    position::update(state.position, o, state.now);
  };
  restart(Mode::FS, Level::L1);
  state.position = {};
  moves_inexactly(700.0);
  moves_inexactly(800.0);
  lies(800.0, balise(150, 0, 0, 0));
  cycle();
  ASSERT_TRUE(state.anchors.has(Anchor::unlinked));
  moves_inexactly(1000.0);
  BufferedSet& set = *state.buffer.grow();
  set.reference = at(1700.0);
  set.anchor = Anchor::unlinked;
  const auto copy = std::make_unique<position::State>(state.position);
  position::Passage passage;
  passage.id = {1, 160};
  passage.counter = {{{1000.0}}, {{980.0}}, {{1030.0}}};
  passage.Q_LOCACC = state.national_values.Q_NVLOCACC;
  passage.single = true;
  const Relocation by = position::refer_to_unlinked(*copy, passage).unlinked;
  ASSERT_TRUE(by.any());
  lies(1000.0, balise(160, 0, 0, 0));
  cycle();
  EXPECT_EQ(state.buffer[0].widening.nearer, by.nearer);
  EXPECT_EQ(state.buffer[0].widening.farther, by.farther);
  EXPECT_EQ(state.buffer[0].anchor, Anchor::unlinked);
}

TEST_F(Groups, DataOfAFormerLRBGMoveUntilLinkingLeadsToAnother) {  // 3.6.4.2.5 b, 3.6.4.3
  for (const bool linked : {true, false}) {
    restart(Mode::FS, Level::L1);
    runs(500.0, 600.0);
    lies(600.0, balise(100));
    cycle();
    moves_to(1000.0);
    state.anchors.add(Anchor::travelled);
    state.buffer.grow()->anchor = Anchor::travelled;
    if (linked) announce(200, position::front(state.position).est.from_origin.si);
    lies(1000.0, balise(200));
    cycle();
    EXPECT_EQ(state.buffer[0].anchor, linked ? Anchor::lrbg : Anchor::travelled);
    EXPECT_EQ(state.anchors.has(Anchor::travelled), !linked);
  }
}

TEST_F(Groups, OfAListAreNamed) {  // 4.4.8.1.1 c, 4.4.11.1.3 d
  const auto pass = [&](Mode mode, std::uint16_t NID_BG) {
    restart(mode);
    runs(900.0, 1000.0);
    state.track.sr_list.emplace();
    state.track.sh_list.emplace();
    EXPECT_TRUE(state.track.sr_list->push_back({1, 200}));
    EXPECT_TRUE(state.track.sh_list->push_back({1, 200}));
    lies(1000.0, balise(NID_BG));
    cycle();
  };
  pass(Mode::SR, 200);
  EXPECT_TRUE(received.group_passed_in_SR_list);
  EXPECT_FALSE(received.group_passed_not_in_SR_list);
  pass(Mode::SR, 201);
  EXPECT_FALSE(received.group_passed_in_SR_list);
  EXPECT_TRUE(received.group_passed_not_in_SR_list);
  pass(Mode::SH, 200);
  EXPECT_FALSE(received.group_passed_not_in_SH_list);
  pass(Mode::SH, 201);
  EXPECT_TRUE(received.group_passed_not_in_SH_list);
  EXPECT_FALSE(received.group_passed_not_in_SR_list);
}

TEST_F(Groups, WithMorePacketsThanTheUnitHoldsAreInconsistent) {  // 3.16.2.4.4
  static_assert(lang::kPacketsMax == 48);
  const auto pass = [&](Mode mode, int packets_of_a_balise) {
    restart(mode);
    runs(900.0, 1010.0);
    lang::Packet66 revocation;
    revocation.Q_DIR.raw = 2;
    for (std::uint8_t i = 0; i < 3; ++i)
      lies_with(1000.0 + 3.0 * i, balise(200, i, 2), [&](BitWriter& writer) {
        for (int n = 0; n < packets_of_a_balise; ++n) {
          ++revocation.NID_TSR.raw;
          lang::encode(writer, revocation);
        }
      });
    cycle();
    return happened(What::group_too_many_packets);
  };
  EXPECT_FALSE(pass(Mode::SR, 16));
  EXPECT_EQ(told(66).times, 48);
  EXPECT_TRUE(received.asked.empty());
  EXPECT_TRUE(pass(Mode::SR, 17));
  EXPECT_EQ(told(66).times, 0);
  EXPECT_TRUE(received.asked.has(brakes::Cause::balise_group_consistency));
  EXPECT_TRUE(state.shorten_at_standstill);
  EXPECT_TRUE(pass(Mode::SL, 17));
  EXPECT_TRUE(received.asked.empty());
  EXPECT_FALSE(state.shorten_at_standstill);
}

TEST_F(Groups, AtTheEndOfAuthorityTripInReleaseSpeedMonitoring) {  // 3.13.10.2.6 b of 4.0.0
  struct Case {
    double EOA = 1000.0;
    Level level = Level::L2;
    SrsVersion srs = SrsVersion::v4_0_0;
    bool active = true;
    Monitoring monitoring = Monitoring::RSM;
    bool announced = true;
  };
  const auto trips = [&](const Case& c) {
    restart(Mode::FS, c.level);
    runs(900.0, 1000.0);
    state.srs = c.srs;
    state.supervision.active = c.active;
    state.supervision.monitoring = c.monitoring;
    state.basis.authority.EOA = at(c.EOA);
    state.train.L_antenna_front = {2.0};
    moves_to(1002.0);
    if (c.announced) announce(200, 1000.0);  // with an accuracy of 5 m
    lies(1002.0, balise(200));
    cycle();
    return received.group_at_EOA_in_RSM;
  };
  EXPECT_TRUE(trips({.EOA = 995.0}));
  EXPECT_TRUE(trips({.EOA = 996.9})) << "the front end may be beyond the EOA when the group is read";
  EXPECT_FALSE(trips({.EOA = 997.0})) << "the group may lie farther in rear of the EOA";
  EXPECT_FALSE(trips({.EOA = 995.0, .level = Level::L1}));
  EXPECT_FALSE(trips({.EOA = 995.0, .srs = SrsVersion::v3_6_0}));
  EXPECT_FALSE(trips({.EOA = 995.0, .active = false}));
  EXPECT_FALSE(trips({.EOA = 995.0, .monitoring = Monitoring::TSM}));
  EXPECT_FALSE(trips({.EOA = 995.0, .announced = false}));
}

TEST_F(Groups, MoveTheTrainToThePlaceByLinking) {  // 3.6.4.3
  announce(200, 1003.0);
  lies(1000.0, balise(200));
  cycle();
  EXPECT_EQ(received.here.est_front, at(1003.0));
  EXPECT_EQ(received.here.min_safe_front, at(998.0));
}

TEST_F(Groups, ASingleOneHasTheDirectionByLinkingWhereTheCounterFalls) {  // 3.4.2.3.2.3
  state.position = {};
  state.position.sense = -1.0;
  moves_to(-900.0);
  moves_to(-1000.0);
  announce(200, 1000.0);
  lies(-1000.0, balise(200));
  cycle();
  ASSERT_TRUE(happened(What::linking_ok));
  EXPECT_EQ(position::orientation(state.position), Direction::nominal);
}

TEST_F(Groups, EndTheCoversOfAnotherCountry) {  // 3.15.9.5 d
  for (const std::uint16_t NID_C : {std::uint16_t{1}, std::uint16_t{2}})
    ASSERT_TRUE(balise::set_cover(state.balise, {7, NID_C, {1e6}}));
  lies(1000.0, balise(200));
  cycle();
  ASSERT_EQ(state.balise.covers.size(), 1u);
  EXPECT_EQ(state.balise.covers[0].NID_C, 1);
}

TEST_F(Groups, WaitForALevelAsTheyWereRead) {  // 4.8.5.1, 4.8.5.7, 3.8.4.2.1 b
  state.level_transition.pending.emplace().to.level = Level::L1;
  state.now = {50.0};
  runs(900.0, 1000.0);
  state.position.references.clear();
  announce(200, 1000.0);
  lang::Packet12 p;
  p.Q_DIR.raw = 2;
  lies(1000.0, balise(200), p);
  cycle();
  ASSERT_EQ(state.buffer.size(), 1u);
  const BufferedSet& set = state.buffer[0];
  EXPECT_EQ(set.medium, Medium::balise);
  EXPECT_EQ(set.min_safe_front, at(995.0));
  EXPECT_EQ(set.received, Duration{50.0});
  EXPECT_EQ(set.telegram_bits.size(), 1u);
}

TEST_F(Groups, WithoutWaitingInformationAreNotBuffered) {  // 4.8.5.1
  lies(1000.0, balise(200), values(2));
  cycle();
  EXPECT_TRUE(state.buffer.empty());
}

TEST_F(Groups, ADuplicatedTelegramIsUsedOnce) {  // 3.16.2.4.8
  lang::TelegramHeader first = balise(200, 0, 1), second = balise(200, 1, 1);
  first.M_DUP.raw = 1;   // its duplicate is the next
  second.M_DUP.raw = 2;  // its duplicate is the one before
  lies(1000.0, first, values(2));
  lies(1003.0, second, values(2));
  moves_to(1010.0);
  cycle();
  EXPECT_EQ(told(3).times, 1);
}

}  // namespace
}  // namespace evc::kernel
