// The language: cost of a telegram, and of a packet 5 with 17 links.
#include <benchmark/benchmark.h>

#include <array>

#include "io/telegram_json.h"
#include "telegram_work.h"

namespace {

using namespace evc;
using namespace evc::lang;

void telegram(benchmark::State& state) {
  const bench::BusyTelegram t;
  bench::Decoded decoded;
  for (auto _ : state) {
    if (!bench::read(t, decoded)) state.SkipWithError("not sound");
    benchmark::DoNotOptimize(decoded);
  }
  state.counters["bits"] = static_cast<double>(t.used);
}
BENCHMARK(telegram);

void packet_5_with_17_links(benchmark::State& state) {
  std::array<std::uint8_t, 200> bytes{};
  BitWriter out(bytes);
  encode(out, bench::linking(17));
  PacketView view;
  view.NID_PACKET = 5;
  view.L_PACKET = static_cast<std::uint16_t>(out.position());
  view.sv = {2, 1};
  view.bytes = out.bytes();
  Packet5 p;
  for (auto _ : state) {
    decode(view, p);
    benchmark::DoNotOptimize(p);
  }
}
BENCHMARK(packet_5_with_17_links);

void telegram_to_json(benchmark::State& state) {
  const bench::BusyTelegram t;
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
