#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <vector>

#include "capi/capi_test.h"
#include "openevc/openevc.h"

// The heap of this program, and so of the library: it fails when a test wants it to.
namespace {
bool heap_is_full = false;
std::size_t allocated = 0;

void* allocate(std::size_t size) {
  if (!heap_is_full) {
    ++allocated;
    if (void* const memory = std::malloc(size == 0 ? 1 : size)) return memory;
  }
  throw std::bad_alloc();
}

/// While it lives, nothing is allocated.
class FullHeap {
 public:
  FullHeap() { heap_is_full = true; }
  FullHeap(const FullHeap&) = delete;
  FullHeap& operator=(const FullHeap&) = delete;
  ~FullHeap() { heap_is_full = false; }
};
}  // namespace

void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace {

using evc::capi::CUnit;
using evc::capi::Memory;

class CHeap : public CUnit {
 protected:
  CHeap() : snapshot_before(openevc_snapshot_size()), snapshot_after(openevc_snapshot_size()) {}
  /// A step without heap: it gives outputs, or the unit and the outputs stay as they were.
  openevc_result step_without_heap(const openevc_inputs& in) {
    EXPECT_EQ(openevc_snapshot(unit, snapshot_before.data(), snapshot_before.size()), OPENEVC_OK);
    std::memset(out.get(), 0x5A, sizeof *out);
    out->size = sizeof *out;
    const auto untouched = std::make_unique<openevc_outputs>(*out);
    openevc_result result = OPENEVC_DEFECT;
    {
      const FullHeap full;
      result = step(in);
    }
    EXPECT_EQ(openevc_snapshot(unit, snapshot_after.data(), snapshot_after.size()), OPENEVC_OK);
    if (result == OPENEVC_OK) {
      EXPECT_EQ(out->now, in.now);
    } else {
      EXPECT_TRUE(snapshot_before == snapshot_after) << "the unit has stepped, and its outputs are lost";
      EXPECT_EQ(std::memcmp(untouched.get(), out.get(), sizeof *out), 0);
    }
    return result;
  }
  std::vector<unsigned char> snapshot_before, snapshot_after;
};

TEST_F(CHeap, TheLibraryUsesThisOne) {
  const std::size_t before = allocated;
  ASSERT_EQ(power_up("{}"), OPENEVC_OK);
  EXPECT_GT(allocated, before);
  const FullHeap full;
  EXPECT_EQ(power_up("{}"), OPENEVC_NO_MEMORY);
}

/// Start of mission, a group and messages: only the cycle with train data needs the heap, and it may be repeated.
TEST_F(CHeap, AStepNeedsNone) {
  std::uint8_t bytes[104] = {};
  const openevc_telegram telegram{bytes, 830, 0, 0.0};
  const openevc_message message{bytes, 20};
  for (int n = 0; n < 90; ++n) {
    openevc_inputs in = at(n);
    if (n == 70) {
      in.telegrams = &telegram;
      in.loops = in.radio = &message;
      in.telegrams_count = in.loops_count = in.radio_count = 1;
    }
    if (n == 80) {
      in.external_train_data = kTrain;
      in.external_train_data_length = std::strlen(kTrain);
    }
    const openevc_result result = step_without_heap(in);
    EXPECT_EQ(result, n == 40 || n == 80 ? OPENEVC_NO_MEMORY : OPENEVC_OK) << n << ": " << why;
    if (result != OPENEVC_OK) {
      ASSERT_EQ(step(in), OPENEVC_OK) << n << ": " << why;
    }
    if (n == 0) {
      EXPECT_TRUE(has_event("mode NP->SB [4]"));
    }
    if (n == 70) {
      EXPECT_GT(out->events_count, 0u);
    }
  }
  EXPECT_EQ(out->mode, OPENEVC_UN);
}

/// A brake command reaches the train: standstill supervision in SB (3.14.4).
TEST_F(CHeap, ABrakeCommandIsNotLost) {
  run(0, 3);
  std::uint8_t bytes[104] = {};
  const openevc_telegram telegram{bytes, 830, 0, 0.0};
  bool braked = false;
  for (int n = 3; n < 40; ++n) {
    openevc_inputs in = at(n);
    in.entered = in.selected = in.acknowledged = 0;
    in.nominal = in.min = in.max = 0.2 * (n - 2);
    in.V_est = in.V_min = in.V_max = 2.0;
    in.telegrams = &telegram;  // which gives an event
    in.telegrams_count = 1;
    EXPECT_EQ(step_without_heap(in), OPENEVC_OK) << n << ": " << why;
    braked = braked || out->sb == 1 || out->eb == 1;
  }
  EXPECT_TRUE(braked);
}

}  // namespace
