#pragma once
// What an instrumented source is built with (tools/mutation/schema.py): every
// place that a mutant changes asks here whether that mutant is the chosen one.
// The environment variable EVC_MUTANT gives its number; 0 or none: no mutant;
// -1: none, but it is noted where a mutant would have made a difference.
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <type_traits>
#include <utility>
#include <vector>

namespace evc_mutant {

inline const int chosen = std::getenv("EVC_MUTANT") != nullptr ? std::atoi(std::getenv("EVC_MUTANT")) : 0;

unsigned char* notes();
inline unsigned char* const seen = chosen < 0 ? notes() : nullptr;
[[gnu::cold, gnu::noinline]] inline void note(int id) { seen[id] = 1; }

/// Where it cannot be said what else the mutant would change: being asked is
/// the difference.
[[gnu::always_inline]] inline bool on(int id) {
  if (__builtin_expect(chosen < 0, 0)) note(id);
  return __builtin_expect(chosen == id, 0);
}

/// With and without the mutant; noted where their bits differ.
template <class T>
[[gnu::cold, gnu::noinline]] void note_difference(int id, const T& unchanged, const T& changed) {
  if constexpr (std::is_trivially_copyable_v<T>)
    if (std::memcmp(&unchanged, &changed, sizeof(T)) == 0) return;
  note(id);
}

/// Not constexpr on purpose: what the compiler computes itself would never meet
/// the mutant.
template <class T>
[[gnu::always_inline]] inline T pick(int id, T unchanged, T changed) {
  return on(id) ? changed : unchanged;
}

/// A row of text, and the same with one word changed. It is read before the
/// first test begins, so that it is noted for every test.
struct Text {
  int id;
  const char* text;
};
inline const char* text(const char* unchanged, std::initializer_list<Text> others) {
  for (const Text& other : others)
    if (on(other.id)) return other.text;
  return unchanged;
}

// `a + b` is written `a + Plus<7>{} + b`: both signs bind like the one they
// replace, and types stay what they are. Where the changed operator does not
// exist, or gives another type, the compiler says so.
#define EVC_MUTANT_BINARY(Name, op, changed)                                                             \
  template <int kId>                                                                                     \
  struct Name {};                                                                                        \
  template <int kId, class A>                                                                            \
  struct Name##Left {                                                                                    \
    A&& a;                                                                                               \
  };                                                                                                     \
  template <int kId, class A>                                                                            \
  [[gnu::always_inline]] inline Name##Left<kId, A> operator op(A&& a, Name<kId>) {                       \
    return {std::forward<A>(a)};                                                                         \
  }                                                                                                      \
  template <int kId, class A, class B>                                                                   \
  [[gnu::always_inline]] inline auto operator op(Name##Left<kId, A> left, B&& b)                         \
      ->decltype(std::forward<A>(left.a) op std::forward<B>(b)) {                                        \
    if constexpr (std::is_integral_v<std::remove_cvref_t<B>>) {                                          \
      if (on(kId)) return std::forward<A>(left.a) changed std::forward<B>(b);                            \
    } else {                                                                                             \
      using Value = std::remove_cvref_t<decltype(std::forward<A>(left.a) op std::forward<B>(b))>;        \
      if (__builtin_expect(chosen < 0, 0)) note_difference<Value>(kId, left.a op b, left.a changed b);   \
      if (__builtin_expect(chosen == kId, 0)) return std::forward<A>(left.a) changed std::forward<B>(b); \
    }                                                                                                    \
    return std::forward<A>(left.a) op std::forward<B>(b);                                                \
  }

EVC_MUTANT_BINARY(Plus, +, -)
EVC_MUTANT_BINARY(Minus, -, +)
EVC_MUTANT_BINARY(Times, *, /)
EVC_MUTANT_BINARY(Over, /, *)
EVC_MUTANT_BINARY(Less, <, <=)
EVC_MUTANT_BINARY(LessEqual, <=, <)
EVC_MUTANT_BINARY(Greater, >, >=)
EVC_MUTANT_BINARY(GreaterEqual, >=, >)
EVC_MUTANT_BINARY(Equal, ==, !=)
EVC_MUTANT_BINARY(NotEqual, !=, ==)

// `a += b` is written `a += PlusAssign<7>{} += b`, which reads from the right.
#define EVC_MUTANT_ASSIGNMENT(Name, op, changed)                                    \
  template <int kId>                                                                \
  struct Name {};                                                                   \
  template <int kId, class B>                                                       \
  struct Name##Right {                                                              \
    B&& b;                                                                          \
  };                                                                                \
  template <int kId, class B>                                                       \
  [[gnu::always_inline]] inline Name##Right<kId, B> operator op(Name<kId>, B&& b) { \
    return {std::forward<B>(b)};                                                    \
  }                                                                                 \
  template <int kId, class A, class B>                                              \
  [[gnu::always_inline]] inline A& operator op(A& a, Name##Right<kId, B> right) {   \
    if (on(kId))                                                                    \
      a changed std::forward<B>(right.b);                                           \
    else                                                                            \
      a op std::forward<B>(right.b);                                                \
    return a;                                                                       \
  }

EVC_MUTANT_ASSIGNMENT(PlusAssign, +=, -=)
EVC_MUTANT_ASSIGNMENT(MinusAssign, -=, +=)

/// std::min and std::max, each the other where chosen.
template <bool kMin>
struct Extreme {
  int id;
  template <class T>
  const T& operator()(const T& a, const T& b) const {
    if (__builtin_expect(chosen < 0, 0) && (a < b || b < a)) note(id);
    const bool min = kMin != (chosen == id);
    return min ? (b < a ? b : a) : (a < b ? b : a);
  }
  template <class T>
  T operator()(std::initializer_list<T> all) const {
    const bool min = kMin != on(id);
    T best = *all.begin();
    for (const T& x : all)
      if (min ? x < best : best < x) best = x;
    return best;
  }
};
using Min = Extreme<true>;
using Max = Extreme<false>;

/// A constexpr array whose rows can be left out.
template <class T>
struct Row {
  int id;
  T row;
};
template <class T>
class Table {
 public:
  Table(std::initializer_list<Row<T>> all) {
    for (const Row<T>& r : all)
      if (r.id < 0 || !on(r.id)) rows_.push_back(r.row);
  }
  const T* begin() const { return rows_.data(); }
  const T* end() const { return rows_.data() + rows_.size(); }
  const T* data() const { return rows_.data(); }
  std::size_t size() const { return rows_.size(); }
  const T& operator[](std::size_t i) const { return rows_[i]; }

 private:
  std::vector<T> rows_;
};

}  // namespace evc_mutant

// Nothing is a constant any more. What an assertion would say of a mutant is
// seen when it is built alone.
#define static_assert(...) static_assert(true)
