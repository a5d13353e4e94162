// The language: what the on-board pays for a telegram, and for a packet 5 with 17 links.
#include <benchmark/benchmark.h>

#include <array>

#include "io/telegram_json.h"
#include "lang/decode.h"
#include "lang/encode.h"
#include "lang/packets.h"
#include "lang/telegram.h"

namespace {

using namespace evc;
using namespace evc::lang;

Packet5 linking(int links) {
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
struct Telegram {
  std::array<std::uint8_t, 104> bytes{};
  std::size_t used = 0;
  Telegram() {
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

template <class P>
void take(const PacketView& view, P& packet) {
  decode(view, packet);
  benchmark::DoNotOptimize(packet);
}

void telegram(benchmark::State& state) {
  const Telegram t;
  Packet5 p5;
  Packet12 p12;
  Packet21 p21;
  Packet27 p27;
  Packet41 p41;
  for (auto _ : state) {
    const TelegramView view = scan_telegram(t.bytes, 830);
    if (view.fault != Fault::none) state.SkipWithError("not sound");
    for (const PacketView& p : view.packets) {
      switch (p.NID_PACKET) {
        case 5:
          take(p, p5);
          break;
        case 12:
          take(p, p12);
          break;
        case 21:
          take(p, p21);
          break;
        case 27:
          take(p, p27);
          break;
        case 41:
          take(p, p41);
          break;
        default:
          break;
      }
    }
  }
  state.counters["bits"] = static_cast<double>(t.used);
}
BENCHMARK(telegram);

void packet_5_with_17_links(benchmark::State& state) {
  std::array<std::uint8_t, 200> bytes{};
  BitWriter out(bytes);
  encode(out, linking(17));
  PacketView view;
  view.NID_PACKET = 5;
  view.L_PACKET = static_cast<std::uint16_t>(out.position());
  view.sv = {2, 1};
  view.bytes = out.bytes();
  Packet5 p;
  for (auto _ : state) take(view, p);
}
BENCHMARK(packet_5_with_17_links);

void telegram_to_json(benchmark::State& state) {
  const Telegram t;
  std::string text;
  for (auto _ : state) {
    text.clear();
    benchmark::DoNotOptimize(io::append_balise_json(text, t.bytes, 830));
  }
  state.counters["telegrams/s"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(telegram_to_json);

}  // namespace
