#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "openevc/terms/srs_clauses.h"

namespace evc {

static_assert(
    [] {
      for (std::size_t i = 1; i < kSrsClauses.size(); ++i)
        if (kSrsClauses[i - 1] >= kSrsClauses[i]) return false;
      return kSrsClauses.size() < 0xFFFF;
    }(),
    "the register is sorted and names each paragraph once");

/// Neither defined nor constexpr: the compiler names it in its error where a literal is not a clause of the register.
void clause_does_not_stand_in_the_register();

/// A paragraph of SUBSET-026 that an event, a refusal or a table row refers to: "3.8.6", a bullet of it "5.8.4.1 a", or
/// an exception of a table "4.8.3 [4]". Made from a literal at compile time, "3.8.6"_srs; a paragraph that is not in
/// the register does not compile. Stored as a number: the kernel holds no text (texts/texts.h prints it).
class Clause {
 public:
  /// None.
  constexpr Clause() = default;

  /// The clause with the name `text`; for use at compile time only: at run time it does not link.
  static constexpr Clause of(std::string_view text) {
    Clause c;
    if (c.find(text)) return c;
    // Not find(): with -fsanitize=undefined g++ 12 cannot evaluate it on a template argument.
    std::size_t space = 0;
    while (space < text.size() && text[space] != ' ') ++space;
    if (space == text.size() || !c.find(text.substr(0, space)) || !c.take_part(text.substr(space + 1)))
      clause_does_not_stand_in_the_register();
    return c;
  }

  /// The n-th numbered exception of the table, 1 to 99: "4.8.3" with 4 is "4.8.3 [4]". 0: the clause itself.
  constexpr Clause exception(std::size_t n) const {
    Clause c = *this;
    c.part_ = n == 0 ? std::uint8_t{0} : static_cast<std::uint8_t>(kExceptions + n);
    return c;
  }

  constexpr explicit operator bool() const { return paragraph_ != 0; }
  /// Index of its paragraph in the register. Not valid for no clause.
  constexpr std::size_t place_in_register() const { return paragraph_ - std::size_t{1}; }
  /// 'a' to 'z', 0 without one.
  constexpr char bullet() const { return part_ >= 1 && part_ <= 26 ? static_cast<char>('a' + part_ - 1) : '\0'; }
  /// Whether it is the column of infill information of the table: "4.8.4 infill".
  constexpr bool infill() const { return part_ == kInfill; }
  /// The number of the exception, 0 without one.
  constexpr unsigned exception() const { return part_ > kExceptions ? part_ - kExceptions : 0u; }

  friend constexpr bool operator==(Clause, Clause) = default;

 private:
  static constexpr std::uint8_t kInfill = 27;
  static constexpr unsigned kExceptions = 100;

  constexpr bool find(std::string_view paragraph) {
    std::size_t low = 0;
    std::size_t high = kSrsClauses.size();
    while (low < high) {
      const std::size_t middle = (low + high) / 2;
      if (kSrsClauses[middle] < paragraph)
        low = middle + 1;
      else
        high = middle;
    }
    if (low == kSrsClauses.size() || kSrsClauses[low] != paragraph) return false;
    paragraph_ = static_cast<std::uint16_t>(low + 1);
    return true;
  }
  /// "a", "[12]" or "infill".
  constexpr bool take_part(std::string_view part) {
    if (part == "infill") {
      part_ = kInfill;
      return true;
    }
    if (part.size() == 1 && part[0] >= 'a' && part[0] <= 'z') {
      part_ = static_cast<std::uint8_t>(part[0] - 'a' + 1);
      return true;
    }
    if (part.size() < 3 || part.size() > 4 || part.front() != '[' || part.back() != ']') return false;
    unsigned n = 0;
    for (const char digit : part.substr(1, part.size() - 2)) {
      if (digit < '0' || digit > '9') return false;
      n = 10 * n + static_cast<unsigned>(digit - '0');
    }
    part_ = static_cast<std::uint8_t>(kExceptions + n);
    return n != 0;
  }

  std::uint16_t paragraph_ = 0;  // 0: none, else one more than its place in the register
  std::uint8_t part_ = 0;        // 1 to 26: a bullet; 27: infill; above kExceptions: an exception
};

/// The characters of a literal as a template argument.
template <std::size_t N>
struct ClauseText {
  consteval ClauseText(const char (&literal)[N]) {
    for (std::size_t i = 0; i + 1 < N; ++i) text[i] = literal[i];
  }
  char text[N]{};
};

/// "3.8.6"_srs. A template, so that the clause is a constant wherever the literal stands: in some places clang 14 emits
/// calls of a consteval operator.
template <ClauseText T>
constexpr Clause operator""_srs() {
  constexpr Clause clause = Clause::of({T.text, sizeof(T.text) - 1});
  return clause;
}

}  // namespace evc
