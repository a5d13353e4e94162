#include "openevc/evc.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

namespace evc::kernel {
namespace {

using Bytes = std::vector<std::byte>;

/// The outputs that distinguish two units.
struct Seen {
  int mode = 0, level = 0;
  double est_front = 0.0, max_safe_front = 0.0;
  bool sb = false, eb = false;
  std::size_t events = 0, symbols = 0, radio = 0;
  friend bool operator==(const Seen&, const Seen&) = default;
};

/// A unit whose driver opens the desk, enters data and starts in level 0; then the train runs.
class Drive {
 public:
  Drive() : unit(std::make_unique<Unit>()), out_(std::make_unique<Outputs>()) { power_up(*unit, Config{}); }

  Seen cycle(int n) {
    Inputs in;
    in.now = {0.1 * n};
    const double v = n < 50 ? 0.0 : std::min(10.0, 0.1 * (n - 50));
    const double x = n < 50 ? 0.0 : 0.005 * (n - 50) * (n - 50);
    in.odometry = {{{x}}, {{x * 0.99}}, {{x * 1.01}}, {v}, {v * 0.99}, {v * 1.01}, {v > 0.0 ? 1.0 : 0.0}};
    in.train.desk_open = n >= 2;
    if (n == 5) in.driver.driver_id = DriverId("12345678");
    if (n == 10) in.driver.level = static_cast<decltype(in.driver.level)::value_type>(0);
    if (n == 15) in.driver.train_running_number = 0x00004711;
    if (n == 20) in.driver.selected = 1u << static_cast<unsigned>(Select::train_data);
    if (n == 25) in.driver.train_data = &train_;
    if (n == 30) in.driver.selected = 1u << static_cast<unsigned>(Select::start);
    if (n > 30) in.driver.acknowledged = ~0u;
    step(*unit, in, *out_);
    const Outputs& o = *out_;
    return {static_cast<int>(o.mode),
            static_cast<int>(o.level),
            o.est_front.from_origin.si,
            o.max_safe_front.from_origin.si,
            o.sb,
            o.eb,
            o.events.size(),
            o.symbols.size(),
            o.radio_out.size()};
  }
  std::vector<Seen> cycles(int from, int to) {
    std::vector<Seen> seen;
    for (int n = from; n < to; ++n) seen.push_back(cycle(n));
    return seen;
  }

  std::unique_ptr<Unit> unit;

 private:
  std::unique_ptr<Outputs> out_;
  train::TrainData train_;
};

Bytes snapshot_of(const Unit& unit) {
  Bytes bytes(snapshot_size());
  EXPECT_TRUE(snapshot(unit, bytes));
  return bytes;
}

TEST(UnitInMemory, GoesThroughStartOfMission) {
  Drive drive;
  const std::vector<Seen> seen = drive.cycles(0, 120);
  EXPECT_GT(seen.back().est_front, 20.0);
  const auto modes = [&] {
    std::vector<int> all;
    for (const Seen& s : seen)
      if (all.empty() || all.back() != s.mode) all.push_back(s.mode);
    return all;
  }();
  EXPECT_GE(modes.size(), 2u) << "the unit leaves SB";
}

TEST(UnitInMemory, BeginsAnewWithItsConfiguration) {
  Drive drive;
  drive.cycles(0, 120);
  Config config;
  config.levels[static_cast<std::size_t>(Level::L0)] = false;
  power_up(*drive.unit, config);
  Drive fresh;
  EXPECT_EQ(drive.cycle(0), fresh.cycle(0)) << "nothing of the run is left";
  const auto state = [](const Config& of) {
    const auto unit = std::make_unique<Unit>();
    power_up(*unit, of);
    return snapshot_of(*unit);
  };
  EXPECT_NE(state(config), state(Config{}));
}

/// At every moment of the start and of the run a restored unit continues like the original.
TEST(UnitSnapshot, GoesOnFromAnyMoment) {
  Drive whole;
  const std::vector<Seen> expected = whole.cycles(0, 150);
  Drive first;
  for (int at = 0; at < 150; at += 7) {
    const Bytes bytes = snapshot_of(*first.unit);
    Drive other;
    other.cycles(0, 60);  // any cycles before
    ASSERT_EQ(restore(*other.unit, bytes), SnapshotFault::none);
    const int to = std::min(150, at + 30);
    const std::vector<Seen> seen = other.cycles(at, to);
    EXPECT_TRUE(std::equal(seen.begin(), seen.end(), expected.begin() + at)) << at;
    first.cycles(at, std::min(150, at + 7));
  }
}

TEST(UnitSnapshot, CopyIsAUnitOfItsOwn) {
  Drive a;
  a.cycles(0, 80);
  const Unit copy = *a.unit;
  const std::vector<Seen> seen = a.cycles(80, 120);
  *a.unit = copy;
  EXPECT_EQ(a.cycles(80, 120), seen);
}

class Refused : public testing::Test {
 protected:
  Refused() {
    drive.cycles(0, 80);
    good = snapshot_of(*drive.unit);
    other.cycles(0, 40);
    before = snapshot_of(*other.unit);
  }
  /// Rejected with this fault, and the unit is unchanged.
  void expect(const Bytes& bytes, SnapshotFault fault) {
    EXPECT_EQ(restore(*other.unit, bytes), fault);
    EXPECT_EQ(snapshot_of(*other.unit), before);
  }
  Bytes with(std::size_t at, unsigned char flipped) const {
    Bytes bytes = good;
    bytes[at] ^= std::byte{flipped};
    return bytes;
  }
  Drive drive, other;
  Bytes good, before;
};

TEST_F(Refused, TooShort) {
  for (const std::size_t size : {std::size_t{0}, std::size_t{7}, std::size_t{31}, std::size_t{32}, good.size() - 1})
    expect(Bytes(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size)), SnapshotFault::too_short);
}

TEST_F(Refused, AHeadAloneShowsWhetherItIsOne) { expect(Bytes(32), SnapshotFault::not_a_snapshot); }

/// A program that moves snapshots can check them: FNV-1a of 64 bits over the words of the content, docs/embedding.md.
TEST_F(Refused, TheChecksumIsFNV1a) {
  std::uint64_t sum = 14695981039346656037u, there = 0;
  for (std::size_t at = 32; at < good.size(); at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, &good[at], 8);
    sum = (sum ^ word) * 1099511628211u;
  }
  std::memcpy(&there, &good[24], 8);
  EXPECT_EQ(there, sum);
}

/// The header: magic, format, size of the State, layout, checksum. Every bit counts.
TEST_F(Refused, EveryBitOfTheHead) {
  for (std::size_t at = 0; at < 32; ++at)
    for (unsigned bit = 0; bit < 8; ++bit)
      expect(with(at, static_cast<unsigned char>(1u << bit)), at < 8    ? SnapshotFault::not_a_snapshot
                                                              : at < 12 ? SnapshotFault::other_format
                                                              : at < 24 ? SnapshotFault::other_layout
                                                                        : SnapshotFault::damaged);
}

/// Snapshots of the first format stay readable as such: docs/embedding.md.
TEST_F(Refused, TheHeadIsThatOfTheFirstFormat) {
  std::uint32_t format = 0, state_bytes = 0;
  std::memcpy(&format, good.data() + 8, sizeof format);
  std::memcpy(&state_bytes, good.data() + 12, sizeof state_bytes);
  EXPECT_EQ(format, 1u);
  EXPECT_EQ(state_bytes, good.size() - 32);
}

TEST_F(Refused, AnyByteOfTheContent) {
  for (std::size_t at = 32; at < good.size(); at += 131) expect(with(at, 0x10), SnapshotFault::damaged);
  expect(with(good.size() - 1, 0x01), SnapshotFault::damaged);
}

TEST_F(Refused, MoreBytesThanNeededAreLeft) {
  Bytes longer = good;
  longer.resize(good.size() + 100, std::byte{0xFF});
  EXPECT_EQ(restore(*other.unit, longer), SnapshotFault::none);
}

TEST_F(Refused, BufferForASnapshotTooSmall) {
  Bytes small(snapshot_size() - 1, std::byte{0x55});
  EXPECT_FALSE(snapshot(*drive.unit, small));
  EXPECT_TRUE(std::all_of(small.begin(), small.end(), [](std::byte b) { return b == std::byte{0x55}; }));
}

TEST_F(Refused, EachFaultHasAName) {
  for (int f = 1; f <= static_cast<int>(SnapshotFault::damaged); ++f)
    EXPECT_GT(std::strlen(name(static_cast<SnapshotFault>(f))), 5u);
}

}  // namespace
}  // namespace evc::kernel
