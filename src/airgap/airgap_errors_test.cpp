#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <random>
#include <vector>

#include "airgap/airgap.h"

// Effect of bit errors: a telegram with errors may be rejected, or received later, but its user bits are never wrong.
// By default a sample of the errors is tried; with OPENEVC_CAMPAIGN set, all of them (figures: docs/airgap.md).
namespace evc::airgap {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Generator = std::mt19937_64;

bool whole_campaign() { return std::getenv("OPENEVC_CAMPAIGN") != nullptr; }
void flip(Bytes& bytes, std::size_t i) { bytes[i / 8] ^= static_cast<std::uint8_t>(0x80u >> i % 8); }

/// A coded telegram of random user bits, and streams of it.
struct Sample {
  Format format;
  Coded coded;
  std::array<std::uint8_t, 104> user{};
  std::size_t n, least;

  Sample(Generator& random, Format f) : format(f), n(coded_bits(f)), least(n + (f == Format::long_ ? 77 : 121)) {
    for (std::size_t i = 0; i < user_bits(f); ++i)
      if (random() >> 63 != 0) user[i / 8] |= static_cast<std::uint8_t>(0x80u >> i % 8);
    coded = encode(user, f).value;
  }
  Bytes stream(std::size_t shift, std::size_t count) const {
    Bytes bytes(bytes_for(count));
    for (std::size_t i = 0; i < count; ++i)
      if (bit(coded.bytes, (i + shift) % n)) flip(bytes, i);
    return bytes;
  }
};

struct Tally {
  std::uint64_t tried = 0, accepted_right = 0, accepted_wrong = 0;
  void count(const Outcome<Received>& received, const Sample& sample) {
    ++tried;
    if (!received) return;
    const bool right = received->format == sample.format && received->user == sample.user;
    ++(right ? accepted_right : accepted_wrong);
  }
  void report(const char* what, Format format) const {
    std::cout << "  " << (format == Format::long_ ? "long " : "short") << "  " << what << ": " << tried << " tried, "
              << accepted_right << " accepted with the right user bits, " << accepted_wrong << " with wrong ones\n";
  }
};

class Errors : public testing::TestWithParam<Format> {
 protected:
  Generator random{36};
  Tally tally;
};
INSTANTIATE_TEST_SUITE_P(Formats, Errors, testing::Values(Format::long_, Format::short_),
                         [](const auto& instance) { return instance.param == Format::long_ ? "long_" : "short_"; });

TEST_P(Errors, EverySingleBitOfThePeriod) {
  for (int round = 0; round < 20; ++round) {
    const Sample sample(random, GetParam());
    Bytes period = sample.stream(random() % sample.n, sample.n);
    for (std::size_t i = 0; i < sample.n; ++i) {
      flip(period, i);
      tally.count(read(period, sample.format), sample);
      flip(period, i);
    }
  }
  tally.report("one bit of the period", GetParam());
  EXPECT_EQ(tally.accepted_right, 0u);
  EXPECT_EQ(tally.accepted_wrong, 0u);
}

TEST_P(Errors, EveryTwoBitsOfThePeriod) {
  const Sample sample(random, GetParam());
  Bytes period = sample.stream(random() % sample.n, sample.n);
  for (std::size_t i = 0; i < sample.n; ++i) {
    flip(period, i);
    for (std::size_t k = i + 1; k < sample.n; ++k) {
      flip(period, k);
      tally.count(read(period, sample.format), sample);
      flip(period, k);
    }
    flip(period, i);
  }
  tally.report("two bits of the period", GetParam());
  EXPECT_EQ(tally.tried, sample.n * (sample.n - 1) / 2);
  EXPECT_EQ(tally.accepted_right, 0u);
  EXPECT_EQ(tally.accepted_wrong, 0u);
}

TEST_P(Errors, EverySingleBitOfTheWindow) {
  for (int round = 0; round < 5; ++round) {
    const Sample sample(random, GetParam());
    Bytes window = sample.stream(random() % sample.n, sample.least);
    for (std::size_t i = 0; i < sample.least; ++i) {
      flip(window, i);
      tally.count(receive(window, sample.least), sample);
      flip(window, i);
    }
  }
  tally.report("one bit of the n + r received", GetParam());
  EXPECT_EQ(tally.accepted_right, 0u);
  EXPECT_EQ(tally.accepted_wrong, 0u);
}

TEST_P(Errors, EveryTwoBitsOfTheWindow) {
  const Sample sample(random, GetParam());
  Bytes window = sample.stream(random() % sample.n, sample.least);
  const std::size_t step = whole_campaign() ? 1 : 23;
  for (std::size_t i = 0; i < sample.least; ++i) {
    flip(window, i);
    // Every distance between the two bits occurs for some i even when only a sample is tried.
    for (std::size_t k = i + 1 + (step == 1 ? 0 : random() % step); k < sample.least; k += step) {
      flip(window, k);
      tally.count(receive(window, sample.least), sample);
      flip(window, k);
    }
    flip(window, i);
  }
  tally.report("two bits of the n + r received", GetParam());
  EXPECT_EQ(tally.accepted_right, 0u);
  EXPECT_EQ(tally.accepted_wrong, 0u);
}

/// A burst: `length` bits, the first and the last wrong, those between at random.
void add_burst(Generator& random, Bytes& bytes, std::size_t at, std::size_t length, std::size_t round_trip) {
  const std::uint64_t inner = random();
  for (std::size_t i = 0; i < length; ++i)
    if (i == 0 || i + 1 == length || (inner >> i & 1) != 0) flip(bytes, (at + i) % round_trip);
}

TEST_P(Errors, BurstsUpTo32BitsInThePeriod) {
  const std::uint64_t count = whole_campaign() ? 5'000'000 : 50'000;
  while (tally.tried < count) {
    const Sample sample(random, GetParam());
    const Bytes clean = sample.stream(random() % sample.n, sample.n);
    for (int i = 0; i < 5000 && tally.tried < count; ++i) {
      Bytes period = clean;
      add_burst(random, period, random() % sample.n, 1 + random() % 32, sample.n);
      tally.count(read(period, sample.format), sample);
    }
  }
  tally.report("bursts of 1 to 32 bits in the period", GetParam());
  EXPECT_EQ(tally.accepted_right, 0u);
  EXPECT_EQ(tally.accepted_wrong, 0u);
}

TEST_P(Errors, BurstsUpTo32BitsInAStream) {
  // Three periods with a burst: the parts beside it may be received, and are then right.
  const std::uint64_t count = whole_campaign() ? 5'000'000 : 10'000;
  while (tally.tried < count) {
    const Sample sample(random, GetParam());
    const std::size_t bits = 3 * sample.n;
    const Bytes clean = sample.stream(random() % sample.n, bits);
    for (int i = 0; i < 5000 && tally.tried < count; ++i) {
      Bytes stream = clean;
      const std::size_t length = 1 + random() % 32;
      add_burst(random, stream, random() % (bits - length), length, bits);
      tally.count(receive(stream, bits), sample);
    }
  }
  tally.report("bursts of 1 to 32 bits in three periods", GetParam());
  EXPECT_GT(tally.accepted_right, 0u);
  EXPECT_EQ(tally.accepted_wrong, 0u);
}

TEST_P(Errors, SlippedBitsInTheWindow) {
  // Annex A1.3: up to three bits lost or inserted in n + r are always detected.
  const std::uint64_t count = whole_campaign() ? 1'000'000 : 5'000;
  while (tally.tried < count) {
    const Sample sample(random, GetParam());
    for (int i = 0; i < 1000 && tally.tried < count; ++i) {
      std::vector<bool> bits;
      const std::size_t shift = random() % sample.n;
      for (std::size_t k = 0; k < sample.least + 3; ++k)
        bits.push_back(bit(sample.coded.bytes, (shift + k) % sample.n));
      const std::size_t slips = 1 + random() % 3;
      for (std::size_t k = 0; k < slips; ++k) {
        const auto at = bits.begin() + static_cast<std::ptrdiff_t>(random() % sample.least);
        if (random() % 2 != 0)
          bits.erase(at);
        else
          bits.insert(at, random() % 2 != 0);
      }
      Bytes window(bytes_for(sample.least));
      for (std::size_t k = 0; k < sample.least; ++k)
        if (bits[k]) flip(window, k);
      tally.count(receive(window, sample.least), sample);
    }
  }
  tally.report("1 to 3 bits lost or inserted in n + r", GetParam());
  EXPECT_EQ(tally.accepted_wrong, 0u);
}

}  // namespace
}  // namespace evc::airgap
