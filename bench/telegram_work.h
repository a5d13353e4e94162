#pragma once
#include <array>

#include "lang/decode.h"
#include "lang/encode.h"
#include "lang/packets/packet_12.h"
#include "lang/packets/packet_21.h"
#include "lang/packets/packet_27.h"
#include "lang/packets/packet_41.h"
#include "lang/packets/packet_5.h"
#include "lang/telegram.h"

// The data of the benchmarks of the language.
namespace evc::bench {

using namespace evc::lang;

inline Packet5 linking(int links) {
  Packet5 p;
  p.Q_DIR.raw = 1;
  p.Q_SCALE.raw = 1;
  for (int i = 1; i < links; ++i) {
    Packet5_links link;
    link.D_LINK.raw = static_cast<std::uint16_t>(100 + i);
    link.NID_BG.raw = static_cast<std::uint16_t>(i);
    link.Q_NEWCOUNTRY.raw = i % 4 == 0;
    (void)p.links.push_back(link);
  }
  return p;
}

/// 764 bits with packets 5, 12, 21, 27 and 41.
struct BusyTelegram {
  std::array<std::uint8_t, 104> bytes{};
  std::size_t used = 0;
  BusyTelegram() {
    BitWriter out(bytes);
    TelegramHeader header;
    header.NID_BG.raw = 7;
    begin_telegram(out, header);
    encode(out, linking(4));
    Packet12 ma;
    ma.Q_DIR.raw = 1;
    ma.V_MAIN.raw = 20;
    ma.T_EMA.raw = 1023;
    ma.L_ENDSECTION.raw = 1000;
    encode(out, ma);
    Packet21 gradient;
    gradient.Q_DIR.raw = 1;
    for (std::uint8_t i = 0; i < 6; ++i) (void)gradient.steps.push_back({{100}, {1}, {i}});
    encode(out, gradient);
    Packet27 speed;
    speed.Q_DIR.raw = 1;
    speed.V_STATIC.raw = 20;
    for (int i = 0; i < 3; ++i) {
      Packet27_steps step;
      step.D_STATIC.raw = 200;
      step.V_STATIC.raw = 10;
      if (i < 2) (void)step.diffs.push_back({{0}, {3}, {0}, {30}});
      (void)speed.steps.push_back(step);
    }
    encode(out, speed);
    Packet41 level;
    level.Q_DIR.raw = 1;
    level.M_LEVELTR.raw = 2;
    (void)level.levels.push_back({{3}, {0}, {0}});
    encode(out, level);
    used = out.position() + 8;
    end_telegram(out, 830);
  }
};

/// Memory for each packet of that telegram.
struct Decoded {
  Packet5 p5;
  Packet12 p12;
  Packet21 p21;
  Packet27 p27;
  Packet41 p41;
};
/// From bits to structs. False if the telegram is not consistent.
inline bool read(const BusyTelegram& t, Decoded& out) {
  const TelegramView view = scan_telegram(t.bytes, 830);
  for (const PacketView& p : view.packets) {
    switch (p.NID_PACKET) {
      case 5:
        decode(p, out.p5);
        break;
      case 12:
        decode(p, out.p12);
        break;
      case 21:
        decode(p, out.p21);
        break;
      case 27:
        decode(p, out.p27);
        break;
      case 41:
        decode(p, out.p41);
        break;
      default:
        break;
    }
  }
  return view.fault == Fault::none;
}

}  // namespace evc::bench
