#pragma once
#include <cstdint>
#include <initializer_list>

namespace evc {

/// A set of enumerators, at most 64: bit n is that of the enumerator n.
template <class E>
class Set {
 public:
  constexpr Set() = default;
  constexpr Set(std::initializer_list<E> elements) {
    for (const E e : elements) add(e);
  }
  /// Bits that are of no enumerator are left out.
  constexpr static Set of_bits(std::uint64_t bits) {
    constexpr auto kCount = static_cast<unsigned>(E::count);
    static_assert(kCount >= 1 && kCount <= 64);
    Set s;
    s.bits_ = bits & (~std::uint64_t{0} >> (64u - kCount));
    return s;
  }
  constexpr void add(E e) { bits_ |= std::uint64_t{1} << static_cast<unsigned>(e); }
  constexpr void add(E e, bool when) {
    if (when) add(e);
  }
  constexpr void remove(E e) { bits_ &= ~(std::uint64_t{1} << static_cast<unsigned>(e)); }
  constexpr void remove(Set b) { bits_ &= ~b.bits_; }
  constexpr bool has(E e) const { return ((bits_ >> static_cast<unsigned>(e)) & 1u) != 0; }
  constexpr bool empty() const { return bits_ == 0; }
  constexpr std::uint64_t bits() const { return bits_; }
  constexpr Set& operator|=(Set b) {
    bits_ |= b.bits_;
    return *this;
  }
  constexpr Set& operator&=(Set b) {
    bits_ &= b.bits_;
    return *this;
  }
  /// Those in both.
  friend constexpr Set operator&(Set a, Set b) { return a &= b; }
  friend constexpr bool operator==(Set, Set) = default;

 private:
  std::uint64_t bits_ = 0;
};

}  // namespace evc
