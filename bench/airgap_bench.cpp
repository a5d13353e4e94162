#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <random>
#include <vector>

#include "airgap/airgap.h"

namespace {

using namespace evc::airgap;

std::vector<std::uint8_t> random_user(std::mt19937_64& random, Format format) {
  std::vector<std::uint8_t> user(bytes_for(user_bits(format)));
  for (auto& byte : user) byte = static_cast<std::uint8_t>(random());
  return user;
}

/// Streams of one telegram each, at random rotations.
std::vector<std::vector<std::uint8_t>> streams(Format format, std::size_t bits) {
  std::mt19937_64 random(36);
  std::vector<std::vector<std::uint8_t>> all;
  for (int k = 0; k < 64; ++k) {
    const Outcome<Coded> coded = encode(random_user(random, format), format);
    const std::size_t shift = random() % coded_bits(format);
    std::vector<std::uint8_t> stream(bytes_for(bits));
    for (std::size_t i = 0; i < bits; ++i)
      if (bit(coded->bytes, (i + shift) % coded_bits(format)))
        stream[i / 8] |= static_cast<std::uint8_t>(0x80u >> i % 8);
    all.push_back(stream);
  }
  return all;
}

/// One period at an unknown rotation: parity, synchronisation, words, descrambling.
void airgap_read(benchmark::State& state) {
  const Format format = state.range(0) == 1023 ? Format::long_ : Format::short_;
  const auto periods = streams(format, coded_bits(format));
  std::size_t next = 0;
  for (auto _ : state) benchmark::DoNotOptimize(read(periods[next++ % periods.size()], format));
}
BENCHMARK(airgap_read)->Arg(1023)->Arg(341);

/// The on-board receiver, both formats at once, the minimum number of bits (n + r).
void airgap_receive(benchmark::State& state) {
  const Format format = state.range(0) == 1023 ? Format::long_ : Format::short_;
  const std::size_t bits = format == Format::long_ ? 1100 : 462;
  const auto all = streams(format, bits);
  std::size_t next = 0;
  for (auto _ : state) benchmark::DoNotOptimize(receive(all[next++ % all.size()], bits));
}
BENCHMARK(airgap_receive)->Arg(1023)->Arg(341);

/// The receiver on noise: its longest time, per 10 000 bits.
void airgap_receive_noise(benchmark::State& state) {
  std::mt19937_64 random(36);
  std::vector<std::uint8_t> noise(1250);
  for (auto& byte : noise) byte = static_cast<std::uint8_t>(random());
  for (auto _ : state) benchmark::DoNotOptimize(receive(noise, 10000));
}
BENCHMARK(airgap_receive_noise);

/// Coding random user bits to the first telegram that passes all tests; the reported time is the mean, `median` and
/// `worst` are those of 2 000 telegrams.
void airgap_encode(benchmark::State& state) {
  const Format format = state.range(0) == 1023 ? Format::long_ : Format::short_;
  std::mt19937_64 random(36);
  std::vector<std::vector<std::uint8_t>> users;
  for (int k = 0; k < 2000; ++k) users.push_back(random_user(random, format));
  std::vector<double> took;
  for (const auto& user : users) {
    const auto begin = std::chrono::steady_clock::now();
    benchmark::DoNotOptimize(encode(user, format));
    took.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  std::sort(took.begin(), took.end());
  std::size_t next = 0;
  for (auto _ : state) benchmark::DoNotOptimize(encode(users[next++ % users.size()], format));
  state.counters["median"] = took[took.size() / 2];
  state.counters["worst"] = took.back();
}
BENCHMARK(airgap_encode)->Arg(1023)->Arg(341)->Unit(benchmark::kMicrosecond);

}  // namespace
