#include "airgap/airgap.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "airgap/bit_by_bit_test.h"
#include "airgap/candidate.h"

namespace evc::airgap {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Generator = std::mt19937_64;

Bytes bytes_of(const std::string& hex) {
  Bytes bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(hex.substr(i, 2), nullptr, 16)));
  return bytes;
}
Bytes bytes_of(std::span<const std::uint8_t> span) { return {span.begin(), span.end()}; }
Format format_of(const nlohmann::json& vector) { return vector.at("format") == 1023 ? Format::long_ : Format::short_; }

Bytes random_user(Generator& random, Format format) {
  Bytes user(bytes_for(user_bits(format)));
  for (auto& byte : user) byte = static_cast<std::uint8_t>(random());
  user.back() &= static_cast<std::uint8_t>(0xFFu << (8 * user.size() - user_bits(format)));
  return user;
}

/// A stream of single bits, and what the receivers take.
struct Stream {
  std::vector<int> bits;
  void add(const Coded& coded, std::size_t from, std::size_t count, bool inverted = false) {
    for (std::size_t i = 0; i < count; ++i)
      bits.push_back((bit(coded.bytes, (from + i) % coded_bits(coded.format)) != inverted) ? 1 : 0);
  }
  void add_equal(int value, std::size_t count) { bits.insert(bits.end(), count, value); }
  void add_noise(Generator& random, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) bits.push_back(static_cast<int>(random() >> 63));
  }
  Bytes bytes() const {
    Bytes out(bytes_for(bits.size()));
    for (std::size_t i = 0; i < bits.size(); ++i)
      if (bits[i] != 0) out[i / 8] |= static_cast<std::uint8_t>(0x80u >> i % 8);
    return out;
  }
  Outcome<Received> receive(std::size_t from = 0) const { return airgap::receive(bytes(), bits.size(), from); }
};

void expect_equal(const Outcome<Received>& fast, const bit_by_bit::Read& slow) {
  ASSERT_EQ(fast.fault, slow.fault);
  if (!fast) return;
  EXPECT_EQ(bytes_of(fast->user_bytes()), bit_by_bit::to_bytes(slow.user));
  EXPECT_EQ(fast->inverted, slow.inverted);
  EXPECT_EQ(fast->rotation, slow.rotation);
  EXPECT_EQ(fast->start, slow.start);
  EXPECT_EQ(fast->end, slow.end);
}

TEST(Words, EqualTheReferenceTable) {
  ASSERT_EQ(bit_by_bit::word_table().size(), words.size());
  for (std::size_t i = 0; i < words.size(); ++i) EXPECT_EQ(words[i], bit_by_bit::word_table()[i]) << i;
  for (std::size_t w = 0; w < 2048; ++w) EXPECT_EQ(block_of[w], bit_by_bit::word_index()[w]) << w;
}

TEST(Codes, PolynomialsEqualTheReference) {
  const auto equals = [](Residue a, const std::vector<std::size_t>& exponents) {
    Residue sum;
    for (const std::size_t e : exponents) sum = sum ^ polynomial(static_cast<int>(e));
    return sum == a;
  };
  EXPECT_TRUE(equals(LongCode::f, bit_by_bit::code(Format::long_).f));
  EXPECT_TRUE(equals(LongCode::g, bit_by_bit::code(Format::long_).g));
  EXPECT_TRUE(equals(ShortCode::f, bit_by_bit::code(Format::short_).f));
  EXPECT_TRUE(equals(ShortCode::g, bit_by_bit::code(Format::short_).g));
}

TEST(Codes, ResidueEqualsLongDivision) {
  Generator random(36);
  for (int round = 0; round < 50; ++round) {
    Bits<1023> bits;
    for (std::size_t i = 0; i < 1023; ++i) bits.put(i, 1, random() >> 63);
    bit_by_bit::Bits slow(1023);
    for (std::size_t i = 0; i < 1023; ++i) slow[i] = bits[i] ? 1 : 0;
    const auto& code = bit_by_bit::code(Format::long_);
    const Residue v = Arithmetic<LongCode>::of(bits);
    const auto r = bit_by_bit::remainder(slow, bit_by_bit::times(code.f, code.g));
    for (std::size_t i = 0; i < 85; ++i) ASSERT_EQ(v.has(i), r[i] != 0);
    const Residue w = Arithmetic<LongCode>::modulo_g(v);
    const auto s = bit_by_bit::remainder(slow, code.g);
    for (std::size_t i = 0; i < 75; ++i) ASSERT_EQ(w.has(i), s[i] != 0);
    ASSERT_EQ(w.high >> 11, 0u);
  }
}

TEST(Vectors, EncodeGivesTheFirstTelegram) {
  const auto reference = bit_by_bit::reference("eurobalise_vectors.json");
  ASSERT_EQ(reference.at("vectors").size(), 12u);
  for (const auto& vector : reference.at("vectors")) {
    SCOPED_TRACE(vector.at("name").get<std::string>());
    const auto coded = encode(bytes_of(vector.at("user_hex").get<std::string>()), format_of(vector));
    ASSERT_TRUE(coded);
    EXPECT_EQ(coded->shaping.sb, vector.at("sb"));
    EXPECT_EQ(coded->shaping.esb, vector.at("esb"));
    EXPECT_EQ(bytes_of(coded->bits()), bytes_of(vector.at("telegram_hex").get<std::string>()));
  }
}

TEST(Vectors, DecodeGivesTheUserBits) {
  const auto reference = bit_by_bit::reference("eurobalise_vectors.json");
  ASSERT_EQ(reference.at("vectors").size(), 12u);
  for (const auto& vector : reference.at("vectors")) {
    SCOPED_TRACE(vector.at("name").get<std::string>());
    const Bytes coded = bytes_of(vector.at("telegram_hex").get<std::string>());
    const auto found = read(coded, format_of(vector));
    ASSERT_TRUE(found);
    EXPECT_EQ(bytes_of(found->user_bytes()), bytes_of(vector.at("user_hex").get<std::string>()));
    EXPECT_EQ(found->shaping.sb, vector.at("sb"));
    EXPECT_EQ(found->shaping.esb, vector.at("esb"));
    EXPECT_FALSE(found->inverted);
    EXPECT_EQ(found->rotation, 0);
    EXPECT_EQ(examine(coded, format_of(vector)), Fault::none);
  }
}

TEST(Vectors, WhatMustBeRejectedIsForTheStatedTest) {
  const std::map<std::string, Fault> tests = {
      {"alphabet", Fault::alphabet}, {"off-synch", Fault::off_synch}, {"aperiodicity", Fault::aperiodicity}};
  const auto reference = bit_by_bit::reference("eurobalise_vectors.json");
  ASSERT_EQ(reference.at("must_be_rejected_by_encoder").size(), 5u);
  for (const auto& vector : reference.at("must_be_rejected_by_encoder")) {
    const Bytes coded = bytes_of(vector.at("telegram_hex").get<std::string>());
    ASSERT_EQ(vector.at("fails").size(), 1u);
    const Fault stated = tests.at(vector.at("fails")[0].get<std::string>());
    EXPECT_EQ(examine(coded, format_of(vector)), stated);
    // The reference names the first test that fails; the two of the alphabet break off-synch parsing as well. The
    // encoder never sends it.
    const auto& code = bit_by_bit::code(format_of(vector));
    const auto bits = bit_by_bit::from_bytes(coded, code.n);
    const auto failing = bit_by_bit::failing_tests(bits, code);
    ASSERT_FALSE(failing.empty());
    EXPECT_EQ(failing.front(), stated);
    EXPECT_EQ(failing.size(), stated == Fault::alphabet ? 2u : 1u);
    const Shaping pair{static_cast<std::uint16_t>(bit_by_bit::number(bits, 95, 12)),
                       static_cast<std::uint16_t>(bit_by_bit::number(bits, 85, 10))};
    const auto next = encode(bytes_of(vector.at("user_hex").get<std::string>()), format_of(vector), pair);
    ASSERT_TRUE(next);
    EXPECT_FALSE(next->shaping == pair);
  }
}

TEST(Encode, FindsEveryUsablePair) {
  const Bytes ones =
      bytes_of(bit_by_bit::reference("eurobalise_vectors.json").at("vectors")[0].at("user_hex").get<std::string>());
  std::size_t pairs = 0;
  for (Shaping from;; ++pairs) {
    const auto coded = encode(ones, Format::long_, from);
    if (!coded) {
      EXPECT_EQ(coded.fault, Fault::no_candidate);
      break;
    }
    from = coded->shaping;
    from.esb = static_cast<std::uint16_t>(from.esb + 1);  // 1024: the next sb
  }
  EXPECT_EQ(pairs, bit_by_bit::reference("eurobalise_vectors.json").at("count_check").at("valid_sb_esb_pairs"));
}

TEST(Encode, RefusesTooFewBytes) {
  EXPECT_EQ(encode(Bytes(103), Format::long_).fault, Fault::size);
  EXPECT_EQ(encode(Bytes(26), Format::short_).fault, Fault::size);
}

TEST(Encode, AgreesWithTheBitByBitOne) {
  Generator random(4320);
  for (const Format format : {Format::long_, Format::short_})
    for (int round = 0; round < 10; ++round) {
      const Bytes user = random_user(random, format);
      const Shaping from{static_cast<std::uint16_t>(random() % 4000), static_cast<std::uint16_t>(random() % 1024)};
      const auto coded = encode(user, format, from);
      ASSERT_TRUE(coded);
      const auto& code = bit_by_bit::code(format);
      const auto slow =
          bit_by_bit::telegram(bit_by_bit::from_bytes(user, code.m), code, coded->shaping.sb, coded->shaping.esb);
      EXPECT_EQ(bytes_of(coded->bits()), bit_by_bit::to_bytes(slow));
      EXPECT_TRUE(bit_by_bit::failing_tests(slow, code).empty());
    }
}

TEST(Encode, PassesOverNoUsablePair) {
  // Every pair before the one that was chosen fails in the bit-by-bit implementation too.
  Generator random(4325);
  const Bytes user = random_user(random, Format::short_);
  const Shaping from{16, 0};
  const auto coded = encode(user, Format::short_, from);
  ASSERT_TRUE(coded);
  const auto& code = bit_by_bit::code(Format::short_);
  const auto user_bits = bit_by_bit::from_bytes(user, code.m);
  const int last = coded->shaping.sb * 1024 + coded->shaping.esb;
  for (int pair = std::max(16 * 1024, last - 3000); pair < last; ++pair) {
    const auto candidate = bit_by_bit::telegram(user_bits, code, pair / 1024, pair % 1024);
    ASSERT_FALSE(bit_by_bit::failing_tests(candidate, code).empty()) << pair;
  }
}

TEST(Examine, EachTestAgreesWithTheBitByBitOne) {
  // Candidates of all kinds: as they come, with bits changed and check bits put right again.
  Generator random(4321);
  std::map<Fault, int> seen;
  for (const Format format : {Format::long_, Format::short_}) {
    const auto& code = bit_by_bit::code(format);
    for (int round = 0; round < 300; ++round) {
      const Bytes user = random_user(random, format);
      const int sb = round % 3 == 0 ? static_cast<int>(random() % 4096) : -1;
      const auto coded = encode(user, format, {static_cast<std::uint16_t>(16 + random() % 3000), 0});
      ASSERT_TRUE(coded);
      auto bits = bit_by_bit::telegram(bit_by_bit::from_bytes(user, code.m), code, sb >= 0 ? sb : coded->shaping.sb,
                                       sb >= 0 ? static_cast<int>(random() % 1024) : coded->shaping.esb);
      if (round % 5 == 1) bits[random() % code.n] ^= 1;
      const auto failing = bit_by_bit::failing_tests(bits, code);
      const Fault first = failing.empty() ? Fault::none : failing.front();
      EXPECT_EQ(examine(bit_by_bit::to_bytes(bits), format), first);
      ++seen[first];
    }
  }
  for (const Fault fault : {Fault::none, Fault::parity, Fault::alphabet}) EXPECT_GT(seen[fault], 10) << name(fault);
  EXPECT_EQ(examine(Bytes(127), Format::long_), Fault::size);
}

TEST(Examine, ControlBitsOfALaterFormat) {
  for (const Format format : {Format::long_, Format::short_}) {
    const auto& code = bit_by_bit::code(format);
    for (int control = 0; control < 8; ++control) {
      auto bits = bit_by_bit::telegram(bit_by_bit::Bits(code.m), code, 100, 100);
      bit_by_bit::set_number(bits, 107, 3, control);
      for (std::size_t i = 0; i < 85; ++i) bits[i] = 0;
      const auto check = bit_by_bit::remainder(bits, bit_by_bit::times(code.f, code.g));
      for (std::size_t i = 0; i < 85; ++i) bits[i] = check[i];
      for (const std::size_t e : code.g) bits[e] ^= 1;
      const Fault fault = examine(bit_by_bit::to_bytes(bits), format);
      EXPECT_EQ(fault == Fault::control_bits, control != 1);
      EXPECT_NE(fault, Fault::parity);
    }
  }
}

/// `run` valid words in a row in a telegram that is read at every 2^k-th bit, noise elsewhere.
template <std::size_t N>
Bits<N> under_sampled_run(Generator& random, std::size_t run, int k, std::size_t at) {
  Bits<N> v;
  for (std::size_t i = 0; i < N; ++i) v.put(i, 1, random() >> 63);
  Bits<N> out;
  for (std::size_t w = 0; w < N / kWordBits; ++w)
    for (std::size_t i = 0; i < kWordBits; ++i) {
      const std::size_t j = kWordBits * w + i;
      const std::uint64_t value = w < run                              ? words[(w * 37 + 5) % 1024] >> i & 1
                                  : w == run || w + 1 == N / kWordBits ? 0
                                                                       : v[j];
      out.put((((at + j) % N) << k) % N, 1, value);
    }
  return out;
}

TEST(Examine, UnderSamplingAllowsThirtyWordsAndNoMore) {
  Generator random(30);
  for (int k = 1; k <= 4; ++k)
    for (const std::size_t at : {std::size_t{0}, std::size_t{7}, std::size_t{1000}}) {
      const auto thirty = under_sampled_run<1023>(random, 30, k, at);
      const auto more = under_sampled_run<1023>(random, 31, k, at);
      const auto& code = bit_by_bit::code(Format::long_);
      for (const auto& [bits, passes] : {std::pair{thirty, true}, std::pair{more, false}}) {
        EXPECT_EQ(passes_under_sampling<LongCode>(bits), passes) << k << " " << at;
        bit_by_bit::Bits slow(1023);
        for (std::size_t i = 0; i < 1023; ++i) slow[i] = bits[i] ? 1 : 0;
        const auto failing = bit_by_bit::failing_tests(slow, code);
        EXPECT_EQ(std::find(failing.begin(), failing.end(), Fault::under_sampling) == failing.end(), passes);
      }
    }
  // In the short format 31 words are the whole telegram.
  EXPECT_FALSE(passes_under_sampling<ShortCode>(under_sampled_run<341>(random, 31, 1, 3)));
  EXPECT_TRUE(passes_under_sampling<ShortCode>(under_sampled_run<341>(random, 30, 1, 3)));
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
      stream.add_equal(bit(coded->bytes, n - 1) ? 0 : 1, 1);  // surely not the telegram's
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
    // Search on: only these two are ever found, the old one first.
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
    // A telegram whose b108 is 1 or whose b107 is 0, otherwise sound: its first word of control bits must be valid.
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
    // The other format's receiver is never the one that got further, unless this one got nowhere.
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

TEST(SelfTest, Passes) { EXPECT_TRUE(self_test()); }

TEST(Faults, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (int i = 0; i <= static_cast<int>(Fault::no_candidate); ++i) names.insert(name(static_cast<Fault>(i)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(Fault::no_candidate) + 1);
}

}  // namespace
}  // namespace evc::airgap
