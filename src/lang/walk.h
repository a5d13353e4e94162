#pragma once
#include <cstdint>
#include <span>

#include "base/bit_cursor.h"
#include "lang/fault.h"
#include "lang/layouts.h"

// A walk over bits by a layout as data. It shares only the layout with the readers made from the
// structs: tests and fuzzers compare the two.
namespace evc::lang {

/// The structures that a walk is in, innermost first.
struct WalkScope {
  std::span<const Step> steps;
  const std::uint64_t* codes;  ///< of the fields read so far, by step
  const WalkScope* up;
  /// The nearest code of a variable in the structures around.
  std::uint64_t around(const char* variable) const {
    for (const WalkScope* s = up; s != nullptr; s = s->up)
      for (std::size_t i = 0; i < s->steps.size(); ++i)
        if (s->steps[i].kind == Step::Kind::field && s->steps[i].variable == variable) return s->codes[i];
    return 0;
  }
};

inline constexpr std::size_t kStepsMax = 96;

/// Reads along `steps` and calls `visitor`:
///   field(step, code, bit), begin_group(step, count, bit of the counter), begin_element(index),
///   end_element(), end_group(), rest(step, bit, bits).
/// `Read` reads a code: fast or bit by bit. Ends early when the reader becomes faulty.
template <auto Read, class Visitor>
void walk(BitReader& in, std::span<const Step> steps, Visitor& visitor, const WalkScope* up = nullptr,
          std::size_t first = 0) {
  std::uint64_t codes[kStepsMax];
  const WalkScope scope{steps, codes, up};
  for (std::size_t i = first; i < steps.size() && !in.faulty(); ++i) {
    const Step& step = steps[i];
    switch (step.kind) {
      case Step::Kind::field: {
        const std::size_t bit = in.position();
        codes[i] = (in.*Read)(step.bits, step.variable);
        if (!in.faulty()) visitor.field(step, codes[i], bit);
        break;
      }
      case Step::Kind::when:
        if (!step.test(codes[step.condition])) i += step.count;
        break;
      case Step::Kind::when_around:
        if (!step.test(scope.around(step.variable))) i += step.count;
        break;
      case Step::Kind::repeat: {
        const std::size_t bit = in.position();
        const std::uint64_t n = (in.*Read)(step.bits, step.variable);
        if (in.faulty()) break;
        visitor.begin_group(step, n, bit);
        for (std::uint64_t k = 0; k < n && !in.faulty(); ++k) {
          visitor.begin_element(k);
          walk<Read>(in, step.element(), visitor, &scope);
          visitor.end_element();
        }
        visitor.end_group();
        break;
      }
      case Step::Kind::rest:
        visitor.rest(step, in.position(), in.left());
        in.advance(in.left());
        break;
    }
  }
}
inline constexpr auto read_fast = &BitReader::read;
inline constexpr auto read_slowly = &BitReader::read_bit_by_bit;

}  // namespace evc::lang
