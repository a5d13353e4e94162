#pragma once
#include <gtest/gtest.h>

#include <array>

#include "lang/encode.h"
#include "track/from_packets.h"
#include "track/testing.h"

// Packets written with the encoder of `lang`, for tests.
namespace evc::track::testing {

/// A packet written with the encoder of `lang` and read as in a telegram of version 2.1.
struct Written {
  std::array<std::uint8_t, 2048> bytes{};
  lang::PacketView view;
  template <class P>
  explicit Written(const P& packet, lang::SystemVersion sv = {2, 1}) {
    BitWriter out(bytes);
    lang::encode(out, packet);
    EXPECT_FALSE(out.faulty());
    view.NID_PACKET = P::info.NID_PACKET;
    view.Q_DIR = packet.Q_DIR.raw;
    view.L_PACKET = static_cast<std::uint16_t>(out.position());
    view.sv = sv;
    view.bytes = bytes;
  }
};
inline Reference reference(double place = 1000.0) {
  Reference r;
  r.place = at(place);
  r.orientation = Direction::nominal;
  r.group = {426, 7};
  r.medium = Medium::rbc;
  r.now = Duration{100};
  return r;
}
template <class P>
Contents contents_of(P packet, lang::SystemVersion sv = {2, 1}) {
  Contents c;
  c.time = Duration{90};
  packet.Q_DIR.raw = 1;
  const Written written(packet, sv);
  EXPECT_EQ(add(c, written.view, reference()), Added::added);
  return c;
}
template <class P>
P packet_in_metres() {
  P p;
  p.Q_SCALE.raw = 1;
  return p;
}

}  // namespace evc::track::testing
