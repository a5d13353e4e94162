// Each rule of rules.h returns the fault that it is there for, and only that one.
#include "rules.h"

#include <gtest/gtest.h>

#include <functional>

namespace evc::exploration {
namespace {

/// A unit in FS in the middle of its authority, at 10 m/s.
struct Unit {
  Known known;
  port::Inputs in;
  port::Outputs out;
  Applied applied{};

  Unit() {
    in.odometry.V_est = out.v = Speed{10.0};
    in.train.desk_open = true;
    out.mode = Mode::FS;
    out.EOA = OdometerPlace{{1000.0}};
    out.est_front = at(500.0);
    out.min_safe_front = at(490.0);
    out.max_safe_front = at(510.0);
    out.V_P = Speed{20.0};
    out.V_W = Speed{21.0};
    out.V_SBI = Speed{21.5};
    out.V_EBI = Speed{22.0};
    out.V_MRSP = Speed{25.0};
  }
  static OdometerPlace at(double metres) { return {{metres}}; }
  void happens(What what, std::int32_t id = port::Event::kNone) {
    ASSERT_TRUE(out.events.push_back({.what = what, .id = id}));
  }
  std::vector<std::string> cycle() {
    std::vector<std::string> faults = look(known, in, out, applied);
    out.events.clear();
    return faults;
  }
  void runs(const std::function<void(Unit&)>& change) {
    change(*this);
    EXPECT_EQ(cycle(), std::vector<std::string>{});
  }
  void fails(Rule rule, const std::function<void(Unit&)>& change) {
    change(*this);
    const std::vector<std::string> faults = cycle();
    ASSERT_EQ(faults.size(), 1u) << name(rule);
    EXPECT_EQ(faults[0].rfind(std::string(name(rule)) + ": ", 0), 0u) << faults[0];
  }
  /// At standstill in a mode without an authority.
  void stands_in(Mode mode) {
    out.mode = mode;
    out.EOA = {};
    out.V_P = out.V_W = out.V_SBI = out.V_EBI = out.V_MRSP = {};
    in.odometry.V_est = out.v = Speed{};
    cycle();
  }
};
const auto kAsBefore = [](Unit&) {};

TEST(Rules, AnAreaAheadEndsTheAuthorityUntilItIsEntered) {
  const auto told = [](Unit& u) {
    u.known.telling = Told{Mode::OS, Unit::at(700.0), {}};
    u.happens(What::authority_accepted);
    u.out.EOA = Unit::at(700.0);
  };
  Unit u;
  u.runs(told);
  u.fails(Rule::area_ahead, [](Unit& v) {
    v.happens(What::authority_accepted);  // as it were
    v.out.EOA = Unit::at(1000.0);
  });
  Unit acknowledged;  // and left again without the area
  acknowledged.runs(told);
  acknowledged.runs([](Unit& v) {
    v.out.mode = Mode::OS;
    v.out.V_P = Speed{8.0};
    v.known.telling.reset();
    v.out.EOA = Unit::at(1000.0);
  });
  acknowledged.fails(Rule::area_ahead, [](Unit& v) { v.out.mode = Mode::FS; });
  Unit entered;  // A.3.5.1
  entered.runs(told);
  entered.runs([](Unit& v) {
    v.out.mode = Mode::OS;
    v.out.V_P = Speed{8.0};
    v.out.EOA = Unit::at(1000.0);
    v.out.max_safe_front = Unit::at(701.0);
  });
  entered.runs([](Unit& v) {
    v.out.mode = Mode::FS;
    v.out.max_safe_front = Unit::at(699.0);
  });
}

TEST(Rules, AnEmergencyStopCountsUntilItIsRevoked) {
  const auto stop = [](Unit& u) {
    u.known.telling = Told{{}, {}, Unit::at(800.0)};
    u.happens(What::emergency_stop_accepted, 3);
    u.out.EOA = Unit::at(800.0);
  };
  Unit u;
  u.runs(stop);
  u.fails(Rule::stop_pending, [](Unit& v) { v.happens(What::authority_accepted); });
  Unit beyond;
  beyond.fails(Rule::stop_location, [&](Unit& v) {
    stop(v);
    v.out.EOA = Unit::at(900.0);
  });
  Unit revoked;
  revoked.runs(stop);
  revoked.runs([](Unit& v) {
    v.happens(What::emergency_stop_revoked, 3);
    v.happens(What::authority_accepted);
    v.out.EOA = Unit::at(900.0);
  });
  Unit left;  // 4.8.3 [5]
  left.out.level = Level::L2;
  left.runs(stop);
  left.runs([](Unit& v) {
    v.out.level = Level::L1;
    v.happens(What::authority_accepted);
    v.out.EOA = Unit::at(900.0);
  });
  left.runs(kAsBefore);
  Unit unconditional;
  unconditional.fails(Rule::stop_trips, [](Unit& v) { v.happens(What::emergency_stop_unconditional, 3); });
}

TEST(Rules, TheAuthorityOfAMode) {
  Unit none;
  none.fails(Rule::authority_of_mode, [](Unit& u) { u.out.EOA = {}; });
  Unit some;
  some.fails(Rule::authority_of_mode, [](Unit& u) { u.out.mode = Mode::UN; });
  Unit grown;
  grown.runs(kAsBefore);
  grown.fails(Rule::growth, [](Unit& u) { u.out.EOA = Unit::at(1010.0); });
  grown.runs([](Unit& u) {
    u.out.EOA = Unit::at(2000.0);
    u.happens(What::authority_accepted);
  });
}

TEST(Rules, TheEndOfTheAuthority) {
  Unit u;
  u.fails(Rule::passed_end, [](Unit& v) {
    v.out.est_front = v.out.min_safe_front = v.out.max_safe_front = Unit::at(1030.0);
    v.out.V_P = Speed{};
  });
  u.runs([](Unit& v) { (void)v.out.symbols.push_back(Symbol::MO03); });
  Unit at_end;
  at_end.fails(Rule::standing_at_end, [](Unit& v) { v.out.est_front = Unit::at(1002.0); });
  at_end.runs([](Unit& v) { v.out.V_release = v.out.V_P; });
}

TEST(Rules, Limits) {
  Unit order;
  order.fails(Rule::order_of_limits, [](Unit& u) { u.out.V_SBI = Speed{22.1}; });
  Unit MRSP;
  MRSP.fails(Rule::order_of_limits, [](Unit& u) { u.out.V_MRSP = Speed{19.0}; });
  Unit SBI;
  SBI.fails(Rule::too_fast, [](Unit& u) { u.out.v = Speed{21.6}; });
  Unit EBI;
  EBI.fails(Rule::too_fast, [](Unit& u) {
    u.out.v = Speed{22.6};
    u.out.sb = true;
    u.out.brake_reasons.add(Cause::overspeed_service);
  });
  Unit OS;
  OS.fails(Rule::ceiling, [](Unit& u) { u.out.mode = Mode::OS; });
}

TEST(Rules, ForbiddenMovement) {
  Unit u;
  u.runs([](Unit& v) { v.in.odometry.V_est = Speed{-1.0}; });
  std::vector<std::string> faults;
  for (int i = 0; i < 30 && faults.empty(); ++i) faults = u.cycle();
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].rfind("runs unbraked: FS", 0), 0u);
  u.runs([](Unit& v) {
    v.out.eb = true;
    v.out.brake_reasons.add(Cause::roll_away);
  });
  // In SB from one place: 1.5 m forward, 3 m backward, and on.
  Unit SB;
  SB.stands_in(Mode::SB);
  SB.runs([](Unit& v) { v.in.odometry.V_est = Speed{1.0}; });
  for (int i = 0; i < 14; ++i) SB.runs(kAsBefore);
  SB.runs([](Unit& v) { v.in.odometry.V_est = Speed{-1.0}; });
  for (int i = 0; i < 29; ++i) SB.runs(kAsBefore);
  faults.clear();
  for (int i = 0; i < 20 && faults.empty(); ++i) faults = SB.cycle();
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].rfind("runs unbraked: SB", 0), 0u);
}

TEST(Rules, TripAndBrakes) {
  Unit u;
  u.stands_in(Mode::TR);
  u.out.eb = true;
  u.out.brake_reasons.add(Cause::trip);
  u.fails(Rule::trip_reason, kAsBefore);
  u.out.trip_reason = StatusText{};
  (void)u.cycle();
  u.fails(Rule::trip_reason, [](Unit& v) { v.out.trip_reason = static_cast<StatusText>(1); });
  Unit FS;
  FS.fails(Rule::trip_reason, [](Unit& v) { v.out.trip_reason = StatusText{}; });
  Unit braked;
  braked.fails(Rule::brake_for_a_reason, [](Unit& v) { v.out.sb = true; });
  Unit reason;
  reason.fails(Rule::brake_for_a_reason, [](Unit& v) { v.out.brake_reasons.add(Cause::linking); });
}

TEST(Rules, Requests) {
  Unit u;
  u.fails(Rule::asked_in_mode, [](Unit& v) { v.out.requests.add(Ack::trip); });
  Unit standing;
  standing.stands_in(Mode::SB);
  standing.out.requests.add(Ack::SR);
  for (int i = 0; i < 40; ++i) EXPECT_TRUE(standing.cycle().empty());
  standing.fails(Rule::asked_until_answered, [](Unit& v) { v.out.requests = {}; });
  standing.out.requests.add(Ack::SR);
  (void)standing.cycle();
  standing.runs([](Unit& v) {
    v.in.driver.acknowledged = 1u << static_cast<unsigned>(Ack::SR);
    v.out.requests = {};
  });
}

TEST(Rules, NothingIsSentWithoutASession) {
  Unit u;
  u.fails(Rule::silent_without_radio, [](Unit& v) { (void)v.out.radio_out.push_back({}); });
}

}  // namespace
}  // namespace evc::exploration
