#include "airgap/airgap.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "airgap/bit_by_bit_test.h"
#include "airgap/candidate.h"
#include "airgap/samples_test.h"

namespace evc::airgap {
namespace {

using namespace samples;

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
    // The reference names the first test that fails; the two alphabet faults break off-synch parsing as well. The
    // encoder never sends such a telegram.
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
  // Every pair before the chosen one fails in the bit-by-bit implementation too.
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
  // Candidates of all kinds: unchanged, with bits changed, and with the check bits computed again.
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

/// Any valid words in the right parsing, as polynomial and bit by bit.
template <std::size_t N>
Bits<N> random_words(Generator& random) {
  Bits<N> bits;
  for (std::size_t p = 0; p < N; p += kWordBits) bits.put(p, kWordBits, words[random() % 1024]);
  return bits;
}
template <std::size_t N>
bool fails(const Bits<N>& bits, Format format, Fault test) {
  bit_by_bit::Bits slow(N);
  for (std::size_t i = 0; i < N; ++i) slow[i] = bits[i] ? 1 : 0;
  const auto failing = bit_by_bit::failing_tests(slow, bit_by_bit::code(format));
  return std::find(failing.begin(), failing.end(), test) != failing.end();
}

TEST(Examine, OffSynchParsingAgreesWithTheBitByBitOne) {
  Generator random(11);
  int passed = 0, failed = 0;
  for (int round = 0; round < 500; ++round) {
    const auto long_words = random_words<1023>(random);
    const auto short_words = random_words<341>(random);
    const bool long_passes = passes_off_synch<LongCode>(word_places(long_words));
    const bool short_passes = passes_off_synch<ShortCode>(word_places(short_words));
    ASSERT_EQ(long_passes, !fails(long_words, Format::long_, Fault::off_synch));
    ASSERT_EQ(short_passes, !fails(short_words, Format::short_, Fault::off_synch));
    passed += int{long_passes} + int{short_passes};
    failed += int{!long_passes} + int{!short_passes};
  }
  EXPECT_GT(passed, 50);
  EXPECT_GT(failed, 50);
}

TEST(Examine, AperiodicityAgreesWithTheBitByBitOne) {
  Generator random(341);
  int passed = 0, failed = 0;
  for (int round = 0; round < 400; ++round) {
    // Two words are repeated a third of the telegram later, one to three bits shifted or not, some bits changed.
    auto bits = random_words<1023>(random);
    const std::size_t p = 11 * (random() % 93), shift = 338 + random() % 7;
    std::set<std::size_t> changed;
    const std::size_t changes = random() % 5;
    while (changed.size() < changes) changed.insert(random() % 22);
    for (std::size_t i = 0; i < 22; ++i) {
      const std::size_t to = (p + 1023 - shift + i) % 1023;
      const bool value = bits[(p + i) % 1023] != (changed.count(i) != 0);
      if (bits[to] != value) bits.w[to / 64] ^= std::uint64_t{1} << to % 64;
    }
    const bool passes = passes_aperiodicity(bits);
    ASSERT_EQ(passes, !fails(bits, Format::long_, Fault::aperiodicity));
    EXPECT_TRUE(!passes || changes >= (shift == 341 ? 3u : 2u));
    ++(passes ? passed : failed);
  }
  EXPECT_GT(passed, 50);
  EXPECT_GT(failed, 50);
}

}  // namespace
}  // namespace evc::airgap
