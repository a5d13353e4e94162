#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <new>
#include <string_view>
#include <type_traits>

#include "openevc/openevc.h"

// The boundary of the C interface: arguments are checked, and no exception leaves it.
namespace evc::capi {

inline constexpr std::size_t kAlignment = 64;

/// The buffer for the reason of a failure.
struct Why {
  char* text;
  std::size_t size;

  /// `to` may be null: nobody wants to know.
  Why(char* to, std::size_t room) noexcept : text(to), size(room) {}
  openevc_result because(openevc_result result, std::string_view reason) const noexcept {
    if (text != nullptr && size > 0) {
      const std::size_t n = reason.size() < size - 1 ? reason.size() : size - 1;
      std::memcpy(text, reason.data(), n);
      text[n] = '\0';
    }
    return result;
  }
};

/// Runs the body; an exception becomes a result. Only texts need the heap.
template <class Body>
openevc_result guarded(Why why, Body&& body) noexcept {
  try {
    return body();
  } catch (const std::bad_alloc&) {
    return why.because(OPENEVC_NO_MEMORY, "no memory");
  } catch (...) {
    return why.because(OPENEVC_DEFECT, "a defect of the library");
  }
}

inline bool aligned(const void* memory) { return reinterpret_cast<std::uintptr_t>(memory) % kAlignment == 0; }

/// Why memory cannot hold an object of `size` bytes; null when it can.
inline const char* refuse_memory(const void* memory, std::size_t memory_size, std::size_t size) {
  if (memory == nullptr) return "memory: null";
  if (!aligned(memory)) return "memory: not aligned to openevc_alignment()";
  if (memory_size < size) return "memory: smaller than the object's size";
  return nullptr;
}

/// The library's struct, from the caller's, which may be shorter (of an older header) or longer: members that the
/// caller's does not have are zero. False: its size is not set.
template <class Struct>
bool take(Struct& ours, const Struct* theirs) {
  static_assert(std::is_trivially_copyable_v<Struct>);
  ours = {};
  if (theirs == nullptr || theirs->size < sizeof theirs->size) return false;
  std::memcpy(&ours, theirs, theirs->size < sizeof ours ? theirs->size : sizeof ours);
  return true;
}
/// The opposite: nothing beyond the caller's size is written, and that size is kept.
template <class Struct>
bool give(Struct* theirs, const Struct& ours) {
  if (theirs == nullptr || theirs->size < sizeof theirs->size) return false;
  const std::uint32_t size = theirs->size;
  std::memcpy(theirs, &ours, size < sizeof ours ? size : sizeof ours);
  theirs->size = size;
  return true;
}

/// Writes a text to the caller's buffer, with a zero at its end; its length is returned even if it does not fit.
inline openevc_result give_text(std::string_view text, char* out, std::size_t size, std::size_t* length,
                                Why why) noexcept {
  if (length != nullptr) *length = text.size();
  if (out == nullptr || size < text.size() + 1) return why.because(OPENEVC_TOO_SMALL, "the buffer is too small");
  std::memcpy(out, text.data(), text.size());
  out[text.size()] = '\0';
  return OPENEVC_OK;
}

inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

}  // namespace evc::capi
