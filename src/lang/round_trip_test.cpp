// Random packets of every layout: the reader and writer made from the structs, compared with a walk over the layout as
// data that reads bit by bit. OPENEVC_CASES sets how many per layout.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "lang/decode.h"
#include "lang/encode.h"
#include "lang/layouts.h"
#include "lang/messages.h"
#include "lang/packets.h"
#include "lang/walk.h"

namespace evc::lang {
namespace {

using Random = std::mt19937_64;

/// Writes random codes by a layout, without spare ones.
struct RandomWriter {
  Random& random;
  BitWriter& out;
  std::size_t most_bits;

  std::uint64_t code(const Step& step) {
    for (;;) {
      // Often a limit of the range, where special values are.
      const std::uint64_t any = random();
      std::uint64_t code = any & all_ones(step.bits);
      if (any >> 60 == 0) code = all_ones(step.bits) - (any & 3u & all_ones(step.bits));
      if (any >> 60 == 1) code = any & 3u & all_ones(step.bits);
      if (step.is_spare == nullptr || !step.is_spare(code)) return code;
      if (std::string(step.variable).starts_with("NID_") && step.bits >= 24) return all_ones(step.bits) / 15 * 7;
    }
  }
  void write(std::span<const Step> steps, const WalkScope* up, std::size_t first) {
    std::array<std::uint64_t, kStepsMax> codes{};
    const WalkScope scope{steps, codes.data(), up};
    for (std::size_t i = first; i < steps.size(); ++i) {
      const Step& step = steps[i];
      switch (step.kind) {
        case Step::Kind::field:
          codes[i] = code(step);
          out.write(codes[i], step.bits);
          break;
        case Step::Kind::when:
          if (!step.test(codes[step.condition])) i += step.count;
          break;
        case Step::Kind::when_around:
          if (!step.test(scope.around(step.variable))) i += step.count;
          break;
        case Step::Kind::repeat: {
          std::uint64_t n = random() % (step.capacity + 1u);
          if (random() % 2 == 0) n %= 3;
          if (out.position() > most_bits) n = 0;
          out.write(n, step.bits);
          for (std::uint64_t k = 0; k < n; ++k) write(step.element(), &scope, 0);
          break;
        }
        case Step::Kind::rest:
          for (std::uint64_t n = random() % 100; n > 0; --n) out.write(random() & 1u, 1);
          break;
      }
    }
  }
};

/// The values of a walk as a list.
struct Record {
  std::vector<std::pair<std::string, std::uint64_t>> seen;
  void field(const Step& step, std::uint64_t code, std::size_t bit) {
    seen.emplace_back(step.name, code);
    seen.emplace_back("at", bit);
  }
  void begin_group(const Step& step, std::uint64_t n, std::size_t) { seen.emplace_back(step.counter, n); }
  void begin_element(std::uint64_t k) { seen.emplace_back("{", k); }
  void end_element() { seen.emplace_back("}", 0); }
  void end_group() { seen.emplace_back("]", 0); }
  void rest(const Step& step, std::size_t bit, std::size_t bits) { seen.emplace_back(step.name, bit * 10000 + bits); }
};

int cases() {
  const char* n = std::getenv("OPENEVC_CASES");
  return n != nullptr ? std::atoi(n) : 1000;
}

const PacketLayout& layout_named(const std::string& type) {
  for (const PacketLayout& l : packet_layouts())
    if (type == l.type) return l;
  std::abort();
}

SystemVersion newest(Versions versions) {
  return (versions & v3_0) != 0   ? SystemVersion{3, 0}
         : (versions & v2_3) != 0 ? SystemVersion{2, 3}
         : (versions & v2_2) != 0 ? SystemVersion{2, 2}
         : (versions & v2_1) != 0 ? SystemVersion{2, 1}
         : (versions & v2_0) != 0 ? SystemVersion{2, 0}
         : (versions & v1_1) != 0 ? SystemVersion{1, 1}
                                  : SystemVersion{1, 0};
}

template <class P>
void round_trip(const char* type) {
  SCOPED_TRACE(type);
  const PacketLayout& layout = layout_named(type);
  Random random(P::info.NID_PACKET * 7u + static_cast<unsigned>(P::info.direction));
  // A Packet3 has over two thousand bits: the size is chosen so that L_PACKET can hold it.
  for (int n = cases(); n > 0 && !testing::Test::HasFailure(); --n) {
    std::array<std::uint8_t, 1400> bytes{};
    BitWriter out(bytes);
    const auto offset = static_cast<unsigned>(random() % 8);
    if (offset > 0) out.write(random() & all_ones(offset), offset);
    out.write(P::info.NID_PACKET, 8);
    if (layout.has_direction) out.write(random() % 3, 2);
    const std::size_t length_at = out.position();
    if (layout.has_length) out.write(0, 13);
    RandomWriter{random, out, 5000}.write(layout.steps, nullptr, layout.has_direction ? 1 : 0);
    ASSERT_FALSE(out.faulty());
    const std::size_t bits = out.position() - offset;
    if (bits > 8191) continue;
    if (layout.has_length) out.patch(length_at, bits, 13);

    PacketView view;
    view.NID_PACKET = P::info.NID_PACKET;
    view.L_PACKET = static_cast<std::uint16_t>(bits);
    view.sv = newest(P::info.versions);
    view.direction = P::info.direction;
    view.bytes = out.bytes();
    view.bit = offset;
    P packet;
    const FaultAt at = decode_at(view, packet);
    ASSERT_FALSE(at) << text_of(at.fault) << " bit " << at.bit << " " << (at.variable != nullptr ? at.variable : "");
    std::array<std::uint8_t, 1400> again{};
    BitWriter writer(again);
    encode(writer, packet);
    ASSERT_FALSE(writer.faulty());
    ASSERT_EQ(writer.position(), bits);
    BitReader first(out.bytes(), offset + bits, offset);
    BitReader second(again, bits);
    while (first.left() > 0) {
      const auto width = static_cast<unsigned>(std::min<std::size_t>(first.left(), 64));
      ASSERT_EQ(first.read_bit_by_bit(width), second.read_bit_by_bit(width));
    }
    // Both walks give the same values.
    const std::size_t header = layout.has_direction ? 23 : layout.has_length ? 21 : 8;
    BitReader fast(out.bytes(), offset + bits, offset + header);
    BitReader slow(out.bytes(), offset + bits, offset + header);
    Record a, b;
    walk<read_fast>(fast, layout.steps, a, nullptr, layout.has_direction ? 1 : 0);
    walk<read_slowly>(slow, layout.steps, b, nullptr, layout.has_direction ? 1 : 0);
    ASSERT_EQ(a.seen, b.seen);
    ASSERT_FALSE(fast.faulty());
    ASSERT_EQ(fast.position(), offset + bits);
    // One bit less: the content no longer fits into L_PACKET, or L_PACKET into the bytes.
    if (layout.has_length && bits > header) {
      bool has_rest = false;
      for (const Step& s : layout.steps) has_rest = has_rest || s.kind == Step::Kind::rest;
      --view.L_PACKET;
      if (!has_rest) {
        ASSERT_EQ(decode(view, packet), Fault::length_mismatch);
      }
    }
  }
}

#define EVC_TEST(P) \
  TEST(RoundTrip, P) { round_trip<lang::P>(#P); }
EVC_PACKETS_TO_TRAIN(EVC_TEST)
EVC_PACKETS_TO_TRACK(EVC_TEST)
#undef EVC_TEST

template <class M>
void message_round_trip(const char* type) {
  SCOPED_TRACE(type);
  const MessageLayout* layout = nullptr;
  for (const MessageLayout& l : message_layouts())
    if (std::string(l.type) == type) layout = &l;
  ASSERT_NE(layout, nullptr);
  Random random(M::info.NID_MESSAGE);
  for (int n = cases(); n > 0 && !testing::Test::HasFailure(); --n) {
    std::array<std::uint8_t, 64> bytes{};
    BitWriter out(bytes);
    out.write(M::info.NID_MESSAGE, 8);
    out.write(0, 10);
    RandomWriter{random, out, 500}.write(layout->steps, nullptr, 0);
    end_message(out);
    ASSERT_FALSE(out.faulty());
    M message;
    if constexpr (M::info.direction == Direction::to_train) {
      MessageToTrainView view;
      view.NID_MESSAGE = M::info.NID_MESSAGE;
      view.sv = newest(M::info.versions);
      view.bytes = out.bytes();
      ASSERT_EQ(decode(view, message), Fault::none);
    } else {
      MessageToTrackView view;
      view.NID_MESSAGE = M::info.NID_MESSAGE;
      view.sv = newest(M::info.versions);
      view.bytes = out.bytes();
      ASSERT_EQ(decode(view, message), Fault::none);
    }
    std::array<std::uint8_t, 64> again{};
    BitWriter writer(again);
    begin_message(writer, message);
    end_message(writer);
    ASSERT_EQ(bytes, again);
  }
}
#define EVC_TEST(M) \
  TEST(RoundTrip, M) { message_round_trip<lang::M>(#M); }
EVC_MESSAGES_TO_TRAIN(EVC_TEST)
EVC_MESSAGES_TO_TRACK(EVC_TEST)
#undef EVC_TEST

}  // namespace
}  // namespace evc::lang
