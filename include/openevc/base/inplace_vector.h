#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "openevc/base/require.h"

namespace evc {

/// A sequence with a compile-time capacity and no heap. Elements are trivially copyable, so the
/// kernel's state can be snapshotted, hashed and compared as bytes.
template <class T, std::size_t Capacity>
class InplaceVector {
  static_assert(std::is_trivially_copyable_v<T>);
  static_assert(Capacity > 0 && Capacity < 65536);

 public:
  using value_type = T;
  static constexpr std::size_t capacity() { return Capacity; }
  constexpr std::size_t size() const { return size_; }
  constexpr bool empty() const { return size_ == 0; }
  constexpr bool full() const { return size_ == Capacity; }

  /// False when full: the caller does what the standard requires then; nothing is dropped silently.
  [[nodiscard]] constexpr bool push_back(const T& value) {
    if (size_ == Capacity) return false;
    items_[size_++] = value;
    return true;
  }
  /// Appends an element with unspecified content, to be filled in by the caller. Null when full.
  [[nodiscard]] constexpr T* grow() {
    if (size_ == Capacity) return nullptr;
    return &items_[size_++];
  }
  /// Inserts before index `i` (`i` <= size()). False when full.
  [[nodiscard]] constexpr bool insert(std::size_t i, const T& value) {
    EVC_REQUIRE(i <= size_);
    if (size_ == Capacity) return false;
    for (std::size_t k = size_; k > i; --k) items_[k] = items_[k - 1];
    items_[i] = value;
    ++size_;
    return true;
  }
  /// Removes the elements of [first, last).
  constexpr void erase(std::size_t first, std::size_t last) {
    EVC_REQUIRE(first <= last && last <= size_);
    for (std::size_t k = last; k < size_; ++k) items_[first + k - last] = items_[k];
    size_ = static_cast<std::uint16_t>(size_ - (last - first));
  }
  constexpr void erase(std::size_t i) { erase(i, i + 1); }
  /// Removes every element for which `gone` returns true; the others keep their order.
  template <class Predicate>
  constexpr void erase_if(Predicate gone) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < size_; ++k)
      if (!gone(items_[k])) items_[kept++] = items_[k];
    size_ = static_cast<std::uint16_t>(kept);
  }
  constexpr void pop_back() {
    EVC_REQUIRE(size_ > 0);
    --size_;
  }
  constexpr void clear() { size_ = 0; }

  constexpr T& operator[](std::size_t i) {
    EVC_REQUIRE(i < size_);
    return items_[i];
  }
  constexpr const T& operator[](std::size_t i) const {
    EVC_REQUIRE(i < size_);
    return items_[i];
  }
  constexpr T& front() { return (*this)[0]; }
  constexpr const T& front() const { return (*this)[0]; }
  constexpr T& back() { return (*this)[size_ - 1u]; }
  constexpr const T& back() const { return (*this)[size_ - 1u]; }
  constexpr T* begin() { return items_.data(); }
  constexpr T* end() { return items_.data() + size_; }
  constexpr const T* begin() const { return items_.data(); }
  constexpr const T* end() const { return items_.data() + size_; }

  friend constexpr bool operator==(const InplaceVector& a, const InplaceVector& b) {
    if (a.size_ != b.size_) return false;
    for (std::size_t i = 0; i < a.size_; ++i)
      if (!(a.items_[i] == b.items_[i])) return false;
    return true;
  }

 private:
  std::array<T, Capacity> items_{};
  std::uint16_t size_ = 0;
};

}  // namespace evc
