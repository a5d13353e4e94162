#include "airgap/airgap.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "airgap/bit_by_bit_test.h"
#include "airgap/samples_test.h"

namespace evc::airgap {
namespace {

using namespace samples;

void expect_equal(const Outcome<Received>& fast, const bit_by_bit::Read& slow) {
  ASSERT_EQ(fast.fault, slow.fault);
  if (!fast) return;
  EXPECT_EQ(bytes_of(fast->user_bytes()), bit_by_bit::to_bytes(slow.user));
  EXPECT_EQ(fast->inverted, slow.inverted);
  EXPECT_EQ(fast->rotation, slow.rotation);
  EXPECT_EQ(fast->start, slow.start);
  EXPECT_EQ(fast->end, slow.end);
}

TEST(Receive, AnyRotationInvertedOrNot) {
  Generator random(4341);
  for (const Format format : {Format::long_, Format::short_}) {
    const std::size_t n = coded_bits(format), least = n + (format == Format::long_ ? 77 : 121);
    const Bytes user = random_user(random, format);
    const auto coded = encode(user, format);
    ASSERT_TRUE(coded);
    for (std::size_t shift = 0; shift < n; ++shift)
      for (const bool inverted : {false, true}) {
        Stream stream;
        stream.add(*coded, shift, least, inverted);
        const auto received = stream.receive();
        ASSERT_TRUE(received) << name(received.fault);
        EXPECT_EQ(bytes_of(received->user_bytes()), user);
        EXPECT_EQ(received->shaping, coded->shaping);
        EXPECT_EQ(received->inverted, inverted);
        EXPECT_EQ(received->rotation, shift);
        EXPECT_EQ(received->start, 0u);
        EXPECT_EQ(received->end, least);
        Bytes period = stream.bytes();
        const auto one = read(period, format);
        ASSERT_TRUE(one);
        EXPECT_EQ(one->user, received->user);
        EXPECT_EQ(one->rotation, shift);
      }
  }
}

TEST(Receive, EncodedRandomUserBitsComeBack) {
  Generator random(4342);
  for (int round = 0; round < 300; ++round) {
    const Format format = round % 2 == 0 ? Format::long_ : Format::short_;
    const Bytes user = random_user(random, format);
    const auto coded = encode(user, format);
    ASSERT_TRUE(coded);
    Stream stream;
    const std::size_t noise = random() % 300, shift = random() % coded_bits(format);
    const bool inverted = random() % 2 != 0;
    stream.add_noise(random, noise);
    stream.add(*coded, shift, 1100, inverted);
    stream.add_noise(random, random() % 300);
    const auto received = stream.receive();
    ASSERT_TRUE(received) << name(received.fault);
    EXPECT_EQ(bytes_of(received->user_bytes()), user);
    EXPECT_EQ(received->inverted, inverted);
    // A noise bit that happens to continue the telegram backwards moves the start forward.
    EXPECT_LE(received->start, noise);
    EXPECT_EQ((received->rotation + noise - received->start) % coded_bits(format), shift);
  }
}

TEST(Receive, NotOneBitLessThanTheStandardAsks) {
  Generator random(4343);
  for (const Format format : {Format::long_, Format::short_}) {
    const auto coded = encode(random_user(random, format), format);
    const std::size_t least = coded_bits(format) + (format == Format::long_ ? 77 : 121);
    Stream stream;
    stream.add(*coded, 5, least - 1);
    EXPECT_FALSE(stream.receive());
    stream.add(*coded, 5 + least - 1, 1);
    EXPECT_TRUE(stream.receive());
    stream.bits.back() ^= 1;
    EXPECT_EQ(stream.receive().fault, Fault::repetition);
  }
  EXPECT_EQ(receive({}, 0).fault, Fault::too_few_bits);
  EXPECT_EQ(receive(Bytes(58), 461).fault, Fault::too_few_bits);
  EXPECT_EQ(receive(Bytes(58), 465).fault, Fault::size);
  EXPECT_EQ(receive(Bytes(200), 1600, 1601).fault, Fault::too_few_bits);
  EXPECT_EQ(read(Bytes(127), Format::long_).fault, Fault::size);
  EXPECT_EQ(read(Bytes(42), Format::short_).fault, Fault::size);
}

TEST(Receive, AfterSevenThousandFiveHundredBitsTwoWholePeriods) {
  Generator random(7500);
  for (const Format format : {Format::long_, Format::short_}) {
    const std::size_t n = coded_bits(format), r = format == Format::long_ ? 77 : 121;
    const auto coded = encode(random_user(random, format), format);
    for (const std::size_t noise : {std::size_t{7500}, std::size_t{7501}}) {
      Stream stream;
      stream.add_noise(random, noise - 1);
      stream.add_equal(bit(coded->bytes, n - 1) ? 0 : 1, 1);  // differs from the telegram's next bit
      stream.add(*coded, 0, n + r);
      EXPECT_EQ(static_cast<bool>(stream.receive()), noise == 7500);
      stream.add(*coded, r, n - r);
      const auto received = stream.receive();
      ASSERT_TRUE(received);
      EXPECT_EQ(received->start, noise);
      EXPECT_EQ(received->end, noise + n + (noise == 7500 ? r : n));
    }
  }
}

TEST(Receive, AShortTelegramInALongWindowIsShort) {
  Generator random(341);
  const Bytes user = random_user(random, Format::short_);
  const auto coded = encode(user, Format::short_);
  Stream stream;
  stream.add(*coded, 100, 5 * 341);
  const auto received = stream.receive();
  ASSERT_TRUE(received);
  EXPECT_EQ(received->format, Format::short_);
  EXPECT_EQ(bytes_of(received->user_bytes()), user);
  // Three periods pass the long parity, but synchronise nowhere.
  EXPECT_EQ(read(stream.bytes(), Format::long_).fault, Fault::synchronisation);
}

TEST(Receive, TwoTelegramsInARowWithTheGapOfASwitch) {
  Generator random(437);
  for (int round = 0; round < 40; ++round) {
    const Format first_format = round % 2 == 0 ? Format::long_ : Format::short_;
    const Format second_format = round % 4 < 2 ? Format::long_ : Format::short_;
    const Bytes first_user = random_user(random, first_format), second_user = random_user(random, second_format);
    const auto first = encode(first_user, first_format), second = encode(second_user, second_format);
    Stream stream;
    stream.add(*first, random() % coded_bits(first_format), 1100 + random() % 1000, round % 3 == 0);
    const std::size_t old_end = stream.bits.size();
    stream.add_equal(round % 8 < 4 ? 0 : 1, 75 + random() % 54);  // 4.3.3
    stream.add(*second, random() % coded_bits(second_format), 1100 + random() % 1000);
    const auto one = stream.receive();
    ASSERT_TRUE(one);
    EXPECT_EQ(bytes_of(one->user_bytes()), first_user);
    // Continue the search: only these two are found, the old one first.
    bool old_one = true;
    std::size_t from = one->end, found = 0;
    for (auto next = stream.receive(from); next; next = stream.receive(from = next->end), ++found) {
      const Bytes user = bytes_of(next->user_bytes());
      EXPECT_TRUE(user == second_user || (old_one && user == first_user));
      if (user == second_user) old_one = false;
      EXPECT_TRUE(!old_one || next->end <= old_end + 10);
    }
    EXPECT_GE(found, 1u);
    EXPECT_FALSE(old_one);
  }
}

TEST(Receive, BitsOfALaterFormatEndTheSearch) {
  for (const Format format : {Format::long_, Format::short_}) {
    const auto& code = bit_by_bit::code(format);
    // A telegram with b108 = 1 or b107 = 0, otherwise correct: its first word of control bits must be valid.
    int tried = 0;
    for (const int control : {0, 2, 3}) {
      bool found = false;
      for (int sb = 16; sb < 4096 && !found; ++sb)
        for (int esb = 0; esb < 64 && !found; ++esb) {
          auto bits = bit_by_bit::telegram(bit_by_bit::Bits(code.m), code, sb, esb);
          bit_by_bit::set_number(bits, 107, 3, control);
          if (!bit_by_bit::valid_word(bits, 110)) break;
          if (!bit_by_bit::valid_word(bits, 99)) continue;
          for (std::size_t i = 0; i < 85; ++i) bits[i] = 0;
          const auto check = bit_by_bit::remainder(bits, bit_by_bit::times(code.f, code.g));
          for (std::size_t i = 0; i < 85; ++i) bits[i] = check[i];
          for (const std::size_t e : code.g) bits[e] ^= 1;
          bool valid = true;
          for (std::size_t i = 11; i <= 110; i += 11) valid &= bit_by_bit::valid_word(bits, i);
          if (!valid) continue;
          found = true;
          for (const int inversion : {0, 1}) {
            auto sent = bits;
            for (int& x : sent) x ^= inversion;
            const Bytes period = bit_by_bit::to_bytes(sent);
            EXPECT_EQ(read(period, format).fault, Fault::unknown_format);
            Stream stream;
            for (std::size_t i = 0; i < 3000; ++i) stream.bits.push_back(sent[code.n - 1 - (i + 17) % code.n]);
            const auto received = stream.receive();
            EXPECT_EQ(received.fault, Fault::unknown_format);
            EXPECT_EQ(received->format, format);
            expect_equal(received, bit_by_bit::search(stream.bits, code));
          }
        }
      tried += found ? 1 : 0;
    }
    EXPECT_GE(tried, 2);
  }
}

TEST(Receive, AgreesWithTheBitByBitOne) {
  Generator random(4344);
  std::map<Fault, int> seen;
  for (int round = 0; round < 60; ++round) {
    const Format format = round % 2 == 0 ? Format::long_ : Format::short_;
    const auto& code = bit_by_bit::code(format);
    // Some telegrams break the alphabet, some have no extra bits, all are inside noise, some with a wrong bit.
    Coded coded = encode(random_user(random, format), format).value;
    if (round % 3 == 1) {
      const auto any = bit_by_bit::to_bytes(bit_by_bit::telegram(
          bit_by_bit::from_bytes(random_user(random, format), code.m), code, static_cast<int>(random() % 4096), 3));
      std::copy(any.begin(), any.end(), coded.bytes.begin());
    }
    Stream stream;
    stream.add_noise(random, random() % 40);
    stream.add(coded, random() % code.n, code.n + random() % (2 * code.r), random() % 2 != 0);
    if (round % 4 == 3) stream.bits[random() % stream.bits.size()] ^= 1;
    stream.add_noise(random, random() % 100);
    const auto slow = bit_by_bit::search(stream.bits, code);
    const auto fast = stream.receive();
    ++seen[slow.fault];
    // The receiver of the other format passes more tests only if this one passes none.
    if (slow.fault >= Fault::repetition || slow.fault == Fault::none) expect_equal(fast, slow);
    EXPECT_EQ(static_cast<bool>(fast), slow.fault == Fault::none);
  }
  for (const Fault fault : {Fault::none, Fault::parity, Fault::repetition, Fault::alphabet})
    EXPECT_GT(seen[fault], 2) << name(fault);
}

TEST(Receive, PureNoiseIsNothing) {
  Generator random(0);
  for (int round = 0; round < 20; ++round) {
    Stream stream;
    stream.add_noise(random, 20000);
    EXPECT_FALSE(stream.receive());
  }
  Stream silence;
  silence.add_equal(0, 5000);
  EXPECT_FALSE(silence.receive());
  Stream ones;
  ones.add_equal(1, 5000);
  EXPECT_FALSE(ones.receive());
}

TEST(Faults, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (int i = 0; i <= static_cast<int>(Fault::no_candidate); ++i) names.insert(name(static_cast<Fault>(i)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(Fault::no_candidate) + 1);
}

}  // namespace
}  // namespace evc::airgap
