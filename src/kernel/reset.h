#pragma once
#include <cstddef>

#include "base/inplace_vector.h"

// Outputs are reset before they are filled.
namespace evc::kernel {

template <class T>
void reset_field(T& field) {
  field = T{};
}
/// Elements are not read before they are written: they need not be cleared.
template <class T, std::size_t N>
void reset_field(InplaceVector<T, N>& list) {
  list.clear();
}
template <class... Fields>
void reset_all(Fields&... fields) {
  (reset_field(fields), ...);
}

}  // namespace evc::kernel
