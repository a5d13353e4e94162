#pragma once
#include <gtest/gtest.h>

#include <array>
#include <memory>

#include "base/test_units.h"
#include "kernel/intake/filter.h"
#include "kernel/intake/reception.h"
#include "lang/encode.h"
#include "lang/messages.h"
#include "lang/packets/packet_41.h"

// For tests: one message, made of packets, evaluated by a unit in any state.
namespace evc::kernel::test {

using evc::test::at;

/// A unit at 1000 m that receives messages of group 100, which lies at 950 m.
class OneMessage : public ::testing::Test {
 protected:
  OneMessage() {
    state.mode = Mode::FS;
    state.level.level = Level::L2;
    received.here.est_front = received.here.min_safe_front = received.here.max_safe_front = at(1000.0);
    in.train.desk_open = true;
    information.medium = Medium::rbc;
    information.group = {1, 100};
    information.reference = at(950.0);
    information.orientation = Direction::nominal;
  }
  template <class P>
  void add(P packet) {
    packet.Q_DIR.raw = 1;
    lang::PacketView view;
    view.bit = static_cast<std::uint32_t>(packets.position());
    lang::encode(packets, packet);
    view.NID_PACKET = P::info.NID_PACKET;
    view.L_PACKET = static_cast<std::uint16_t>(packets.position() - view.bit);
    view.Q_DIR = 1;
    view.sv = {2, 1};
    view.known = true;
    view.bytes = packet_bytes;
    ASSERT_TRUE(information.packets.push_back(view));
  }
  /// Packet 41; `D_LEVELTR` in metres, 32767: at once.
  static lang::Packet41 order_to(std::uint8_t M_LEVELTR, std::uint16_t D_LEVELTR) {
    lang::Packet41 p;
    p.Q_SCALE.raw = 1;
    p.D_LEVELTR.raw = D_LEVELTR;
    p.M_LEVELTR.raw = M_LEVELTR;
    return p;
  }
  Waiting evaluate_now() {
    out = {};
    return evaluate(reception, information);
  }
  /// What the log says of a packet, and how often.
  struct Told {
    int times = 0;
    What what{};
    Clause clause;
  };
  Told told(int NID_PACKET) const {
    Told found;
    for (const Event& e : out.events)
      if (e.id == NID_PACKET &&
          (e.what == What::packet_accepted || e.what == What::packet_refused || e.what == What::packet_buffered ||
           e.what == What::packet_kept || e.what == What::packet_contact_stored || e.what == What::packet_not_used)) {
        ++found.times;
        found.what = e.what;
        found.clause = e.clause;
      }
    return found;
  }
  void expect(int NID_PACKET, What what, Clause clause = {}) const {
    const Told t = told(NID_PACKET);
    EXPECT_EQ(t.times, 1) << NID_PACKET;
    EXPECT_EQ(t.what, what) << NID_PACKET;
    if (clause) {
      EXPECT_EQ(t.clause, clause) << NID_PACKET;
    }
  }
  bool happened(What what) const {
    for (const Event& e : out.events)
      if (e.what == what) return true;
    return false;
  }
  /// The message becomes a radio message.
  template <class M>
  void set_message(M m, lang::SystemVersion sv = {2, 1}) {
    m.NID_LRBG.raw = (1u << 14) | 100u;
    BitWriter writer(message_bytes);
    lang::encode_message(writer, m);
    message =
        lang::scan_message_to_train({message_bytes.data(), writer.position() / 8}, {2, 1}, lang::Check::structure);
    message.sv = sv;
    ASSERT_EQ(message.fault, lang::Fault::none);
    information.message = &message;
  }

  std::unique_ptr<State> memory = std::make_unique<State>();
  State& state = *memory;
  std::unique_ptr<Derived::Scratch> scratch = std::make_unique<Derived::Scratch>();
  Inputs in;
  radio::Outbox outbox;
  std::unique_ptr<Outputs> outputs = std::make_unique<Outputs>();
  Outputs& out = *outputs;
  Received received;
  Reception reception{state, *scratch, in, outbox, Log{out.events}, received, {}};
  Information information;
  std::array<std::uint8_t, 2048> packet_bytes{};
  BitWriter packets{packet_bytes};  // as if all were of one telegram
  std::array<std::uint8_t, 64> message_bytes{};
  lang::MessageToTrainView message;
};

}  // namespace evc::kernel::test
