#pragma once
#include <gtest/gtest.h>

#include <vector>

#include "radio/radio.h"

namespace evc::radio::testing {

inline constexpr Rbc kRbc{426, 1, 0x0031840880150FFF};
inline constexpr Rbc kOther{426, 2, 0x0031840880151FFF};

/// A unit and what it sends, cycle by cycle of 100 ms.
struct Unit {
  State s;
  Inputs in;
  Outbox out;
  double now = 0;
  std::uint32_t stamp = 1000;

  Unit() {
    in.level_2_or_3 = true;
    in.train_data_valid = true;
  }
  Result cycle(RadioLink link = RadioLink::unchanged) {
    in.now = Duration{now};
    in.link = link;
    Inputs given = in;
    // As the kernel asks in modes that report both events (3.6.5.1.4 h, l).
    given.report_due = in.report_due || s.supervising.established_now || !s.errors.empty();
    const Result r = supervise(s, given, out);
    if (out.connect) note_called(s, *out.connect);
    now += 0.1;
    return r;
  }
  /// Runs for a time without inputs; returns the messages sent meanwhile.
  std::vector<int> run(double seconds) {
    std::vector<int> sent;
    for (const double end = now + seconds; now < end;) {
      fresh();
      cycle();
      for (const int m : messages()) sent.push_back(m);
    }
    fresh();
    return sent;
  }
  void fresh() { out = Outbox{}; }
  std::vector<int> messages() const {
    std::vector<int> ids;
    for (const Intent& i : out.messages) ids.push_back(i.NID_MESSAGE);
    return ids;
  }
  Rejected message(std::uint8_t NID_MESSAGE, bool M_ACK = false) {
    return receive(s, {NID_MESSAGE, T_TRAIN_of(Duration{now}), M_ACK}, Duration{now}, out);
  }
  void order_session(const Rbc& rbc = kRbc, bool establish = true) {
    ASSERT_TRUE(order(s, {establish, rbc, false, Cause::trackside_order}, false, false, Duration{now}, out));
  }
  void version(std::uint8_t M_VERSION = 0x10) {
    ASSERT_EQ(message(32), Rejected::no);
    receive_version(s, M_VERSION, Duration{now}, out);
  }
  /// Establishes a session and sends the messages due at its start.
  void up(std::uint8_t M_VERSION = 0x10) {
    order_session();
    cycle();
    cycle(RadioLink::connected);
    fresh();
    version(M_VERSION);
    cycle();
    fresh();
    if (s.supervising.train_data_stamp) receive_train_data_ack(s.supervising, *s.supervising.train_data_stamp);
  }
};
using Ids = std::vector<int>;

}  // namespace evc::radio::testing
