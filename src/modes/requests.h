#pragma once
#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace evc::modes {

/// A set of enumerators (at most 64; bits() and of_bits() are those of the first 32).
template <class E>
class Set {
 public:
  constexpr Set() = default;
  constexpr Set(std::initializer_list<E> elements) {
    for (const E e : elements) add(e);
  }
  constexpr static Set of_bits(std::uint32_t bits) {
    Set s;
    s.bits_ = bits & ((std::uint64_t{1} << static_cast<unsigned>(E::count)) - 1u);
    return s;
  }
  constexpr void add(E e) { bits_ |= std::uint64_t{1} << static_cast<unsigned>(e); }
  constexpr void add(E e, bool when) {
    if (when) add(e);
  }
  constexpr void remove(E e) { bits_ &= ~(std::uint64_t{1} << static_cast<unsigned>(e)); }
  constexpr bool has(E e) const { return ((bits_ >> static_cast<unsigned>(e)) & 1u) != 0; }
  constexpr bool empty() const { return bits_ == 0; }
  constexpr std::uint32_t bits() const { return static_cast<std::uint32_t>(bits_); }
  constexpr Set& operator|=(Set b) {
    bits_ |= b.bits_;
    return *this;
  }
  friend constexpr bool operator==(Set, Set) = default;

 private:
  std::uint64_t bits_ = 0;
};

/// What the driver can be asked to acknowledge; the numbers are those of the driver interface.
enum class Ack : std::uint8_t { OS, LS, SH, SR, UN, SN, RV, trip, level, text, brake, train_data, count };

/// Data that the driver is asked to enter or to revalidate.
enum class Entry : std::uint8_t { driver_id, level, rbc_contact, train_data, train_running_number, count };

/// What the procedure lets the driver choose now (beside the conditions of the mode, driver/actions.h).
enum class Offer : std::uint8_t {
  start,
  shunting,
  non_leading,
  train_data,
  override_,
  driver_id,
  train_running_number,
  level,
  count
};

/// What the driver is told; the texts are those of the DMI (driver/texts.h).
enum class Inform : std::uint8_t {
  network_registration_failed,
  session_failed,
  train_rejected,
  SH_refused,
  SH_request_failed,
  count
};

}  // namespace evc::modes
