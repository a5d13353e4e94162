#pragma once
#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "openevc/openevc.h"

// A host of the C interface, for tests.
namespace evc::capi {

/// Memory of a host, followed by a fence that must not be written to.
class Memory {
 public:
  explicit Memory(std::size_t size) : size_(size), bytes_(size + 2 * openevc_alignment(), 0xA5) {
    const auto address = reinterpret_cast<std::uintptr_t>(bytes_.data());
    at_ = bytes_.data() + (openevc_alignment() - address % openevc_alignment()) % openevc_alignment();
  }
  void* at() { return at_; }
  std::size_t size() const { return size_; }
  bool fence_stands() const {
    for (const unsigned char* p = at_ + size_; p < bytes_.data() + bytes_.size(); ++p)
      if (*p != 0xA5) return false;
    return true;
  }

 private:
  std::size_t size_;
  std::vector<unsigned char> bytes_;
  unsigned char* at_;
};

/// A unit in a host's memory, through start of mission in level 0.
class CUnit : public testing::Test {
 protected:
  CUnit() : memory(openevc_unit_size()), out(std::make_unique<openevc_outputs>()) {
    out->size = sizeof *out;
    EXPECT_EQ(power_up(nullptr), OPENEVC_OK) << why;
  }
  openevc_result power_up(const char* configuration) {
    return openevc_power_up(memory.at(), memory.size(), configuration, configuration ? std::strlen(configuration) : 0,
                            &unit, why, sizeof why);
  }
  static openevc_inputs at(int n) {
    openevc_inputs in;
    EXPECT_EQ(openevc_inputs_init(&in, sizeof in), OPENEVC_OK);
    in.now = 0.1 * n;
    in.desk_open = n > 0;
    if (n == 10) {
      in.entered = 1u << OPENEVC_ENTRY_DRIVER_ID;
      in.driver_id = 0x1234;
    }
    if (n == 20) {
      in.entered = 1u << OPENEVC_ENTRY_LEVEL;
      in.level = OPENEVC_L0;
    }
    if (n == 30) in.selected = 1u << OPENEVC_TRAIN_DATA;
    if (n == 40) {
      in.entered = 1u << OPENEVC_ENTRY_TRAIN_DATA;
      in.train_data = kTrain;
      in.train_data_length = std::strlen(kTrain);
    }
    if (n == 50) {
      in.entered = 1u << OPENEVC_ENTRY_TRAIN_RUNNING_NUMBER;
      in.train_running_number = 0x4711;
    }
    if (n == 60) in.selected = 1u << OPENEVC_START;
    if (n > 60) in.acknowledged = 1u << OPENEVC_ACK_UN;
    return in;
  }
  openevc_result step(const openevc_inputs& in) { return openevc_step(unit, &in, out.get(), why, sizeof why); }
  void run(int from, int to) {
    for (int n = from; n < to; ++n) ASSERT_EQ(step(at(n)), OPENEVC_OK) << n << ": " << why;
  }
  bool has_event(const char* text) const {
    for (std::uint32_t i = 0; i < out->events_count; ++i)
      if (std::strcmp(out->events[i].text, text) == 0) return true;
    return false;
  }
  static constexpr const char* kTrain = R"({"schema":"etcs-train/1","length_m":300})";
  Memory memory;
  std::unique_ptr<openevc_outputs> out;
  openevc_unit* unit = nullptr;
  char why[256] = "";
};

}  // namespace evc::capi
